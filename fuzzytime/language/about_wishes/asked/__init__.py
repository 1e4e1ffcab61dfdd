"""Questions ``about_the_plan``, and ``about_the_day``: when one is free, what was done, and what there is."""
