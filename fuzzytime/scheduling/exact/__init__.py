"""Schedules proved best: by sets of jobs, by labels, by shares of the work, by mixed-integer programs."""
