"""How far what is repeated without an end is planned: as long as people are up, or for the night.

"Check the wires every half hour" ends with the day that it begins on, unless words, or a horizon, say more.
"""

from collections.abc import Iterator, Sequence
from datetime import datetime, timedelta

from fuzzytime.language import Policy
from fuzzytime.requirement import Recurrence, Window
from fuzzytime.times import DAY, HOUR, hours_of_its_day, instant_after, seconds_between


def within_hours(
    windows: Sequence[Window], recurrence: Recurrence, given: datetime, passed: float, policy: Policy
) -> tuple[Window, ...]:
    """Give the occurrences of a repetition that one goes on with.

    Those of which no end is said are in waking hours where the first one is, else at night; and they end
    with these hours, those of them that are not over. What comes at long intervals goes on round the clock;
    what is done so often a day is done in waking hours, as far as its share of the day has any.

    Parameters
    ----------
    windows
        When each begins and is over, in seconds from when it was given.
    passed
        Seconds from then until now.
    """
    interval = recurrence.interval
    open_end = recurrence.endless or recurrence.all_day
    if not open_end or interval is None or not windows:
        return tuple(windows)
    if interval >= policy.round_the_clock_hours * HOUR:
        shared = interval < DAY and all(end - start >= interval for start, end in windows)
        return tuple(_awake_part(window, given, policy) if shared else window for window in windows)
    awake = recurrence.all_day or _is_awake(windows[0][0], given, policy)
    alike = [window for window in windows if _is_awake(window[0], given, policy) is awake]
    return tuple(_until_a_break(alike, passed, interval))


def on_their_days(windows: Sequence[Window], given: datetime) -> tuple[Window, ...]:
    """Give the days of what is done once a day, or every so many: "water the herbs every two days".

    Said at noon, the next time is any time of the day after tomorrow, and not up to the noon behind it.
    """
    if not windows or max(end - start for start, end in windows) != DAY:
        return tuple(windows)
    return tuple(_day_of(window, given) for window in windows)


def _day_of(window: Window, given: datetime) -> Window:
    start, end = window
    opens, closes = hours_of_its_day(given, start, 0.0, DAY)
    return max(0.0, opens), min(end, closes)


def far_ahead(recurrence: Recurrence, until: float) -> tuple[Window, ...]:
    """Give the first occurrence, however far away: "every monday"; and a day of what comes more often."""
    ahead = DAY
    while not (coming := recurrence.windows(min(ahead, until))) and ahead < until:
        ahead *= 2
    if coming and recurrence.interval is not None and recurrence.interval < DAY:
        return tuple(recurrence.windows(min(coming[0][0] + DAY, until)))
    return tuple(coming[:1])


def _awake_part(window: Window, given: datetime, policy: Policy) -> Window:
    """Give the waking hours of an occurrence, as of "twice a day"; all of it where it has none of them."""
    start, end = window
    begin = instant_after(given, start)
    day = begin.replace(hour=0, minute=0, second=0, microsecond=0)
    for later in (0, 1):
        opens, closes = (
            seconds_between(given, datetime.combine(day + timedelta(days=later), hour, day.tzinfo))
            for hour in (policy.plausible_from, policy.plausible_to)
        )
        if max(start, opens) < min(end, closes):
            return max(start, opens), min(end, closes)
    return window


def _is_awake(moment: float, given: datetime, policy: Policy) -> bool:
    return policy.plausible_from <= instant_after(given, moment).time() <= policy.plausible_to


def _until_a_break(windows: Sequence[Window], passed: float, interval: float) -> Iterator[Window]:
    """Give windows up to the first break between two of which the earlier one is not over."""
    before: float | None = None
    for start, end in windows:
        if before is not None and before >= passed and start - before > interval + 1.0:
            return
        yield start, end
        before = start
