"""Which occurrences of a repetition are planned: those within the horizon, or as far as one looks ahead."""

from fuzzytime.interpreter.request import MAX_HORIZON, WITHOUT_END, Request, Wish
from fuzzytime.interpreter.turns.waking_hours import far_ahead, on_their_days, within_hours
from fuzzytime.language import Policy
from fuzzytime.requirement import Recurrence, Window
from fuzzytime.times import seconds_between


def planned_until(request: Request, wish: Wish, recurrence: Recurrence) -> float:
    """Give up to when a repetition is planned, in seconds from when the wish was said."""
    ahead = WITHOUT_END if recurrence.endless else MAX_HORIZON
    return (request.horizon or ahead) - seconds_between(request.now, wish.given)


def planned_windows(
    request: Request, wish: Wish, recurrence: Recurrence, policy: Policy
) -> tuple[Window, ...]:
    """Give when the occurrences of a repetition are that are planned, in seconds from when it was said."""
    until = planned_until(request, wish, recurrence)
    coming = recurrence.windows(until)
    if request.horizon is not None:
        # What may be done at any time of a day has none of it left where the day begins at the end.
        coming = tuple(window for window in coming if window[0] < until or window[0] == window[1])
    windows = on_their_days(coming, wish.given)
    if request.horizon is None:
        passed = seconds_between(request.now, wish.given)
        windows = windows if len(windows) > 1 else far_ahead(recurrence, MAX_HORIZON - passed)
        windows = within_hours(windows, recurrence, wish.given, -passed, policy)
    return windows
