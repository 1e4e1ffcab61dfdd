"""What time words mean: expressions that know no language, and how they become instants and requirements.

Rules of a grammar build expressions; once it is known when they were said, the policy decides what they
leave open.

Values
    What was said: ``expressions``, ``calendar``, ``times_of_day``, ``nested``, ``relations``,
    ``feasts`` (days from ``calendars``), ``workdays``, ``spared_days``, ``recurrence``,
    ``closing_recurrence``, ``delayed_recurrence``, ``recurrence_by_months``, ``recurrence_on_days``.
    What names no time: ``ungrounded``.
    What is reckoned with: ``instants``, ``moment``, ``standpoint``.

From values to requirements
    Grounding: ``grounding``, ``chosen_clocks``, ``dated_weekdays``, ``part_instants``,
    ``range_instants``; repetitions: ``series``, ``hours_of_turns``.
    One of several times: ``offered_days``.
    When something is not to be done: ``denied_times``.
    Two times as one: ``beside``, ``told_apart``, ``repeats_beside``, ``bounded_repeats``, ``first_times``,
    ``distances``, ``intervals_on_days``, ``throughout``, ``offered``, ``range_ends``, ``weekdays_left_out``.
    What is asked of ``phrases``.
    What is handed on: ``requirements``, ``grains``, ``decisions``.
"""
