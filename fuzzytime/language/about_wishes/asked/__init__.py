"""Questions ``about_the_plan``, ``about_room``, and ``about_the_day``: when one is free, what was done."""
