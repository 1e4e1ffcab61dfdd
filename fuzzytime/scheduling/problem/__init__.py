"""What is solved: jobs with costs and windows, on a grid where that is wanted, posed from a task."""
