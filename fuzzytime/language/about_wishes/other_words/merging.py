"""A new time with what it leaves of the old one: "tomorrow at six", and then "no, at seven"."""

import re
from datetime import datetime, timedelta
from itertools import product

from fuzzytime.language.about_wishes.said import CLOCKED
from fuzzytime.language.finding import find_times, one_time
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS
from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime.times import instant_after, seconds_between

DAY_OR_LONGER = DAY_SECONDS - 3600 - 1
"""Seconds that a day has at least, where clocks change."""

HALVES = ("am", "pm")
"""The halves of the day, as they are said behind an hour."""


def merged_time(old: str, said: datetime, new: str, now: datetime, lexicon: Lexicon) -> str:
    """Give a new time with the day, the hour or the repetition of an old one that it leaves open.

    Parameters
    ----------
    old, said
        The words of the time, and when they were said.
    new, now
        Those in their place, and when they are said.

    >>> from fuzzytime.language.finding import shipped_lexicon
    >>> wednesday = datetime(2026, 3, 4, 9)
    >>> merged_time("tomorrow at six", wednesday, "at seven", wednesday, shipped_lexicon())
    'tomorrow at seven pm'
    """
    # "Tomorrow, same time"
    same = "|".join(lexicon.beside.same_time)
    new = re.sub(rf",?\s+(?:at )?(?:the )?(?:{same})$", "", new, flags=re.IGNORECASE)
    new = _past_hour_said(new, old, said, now, lexicon)
    other = one_time(new, now, lexicon)
    before = one_time(old, said, lexicon)
    counted = before is not None and before.unit is not None and before.preposition is not None
    if other is None or counted:
        # What was to be in ten minutes, or ten minutes after that, and is tomorrow, leaves no hour open.
        return new
    pieces = ((piece, one_time(piece, said, lexicon)) for piece in _pieces(old))
    # "Before that" says no day and no hour, nor does its "before".
    times = {piece: time for piece, time in pieces if time is not None and not _is_open(time)}
    days = [piece for piece, time in times.items() if is_of_days(time)]
    dated = not is_of_days(other) and (
        # "Tonight", "this evening"
        lexicon.means(new.split()[0].lower(), "day_part", "deictic")
        or any(is_of_days(part) for part in _times_in(new, now, lexicon))
    )
    for piece, told in times.items():
        if dated and is_of_days(told):
            # "At eleven on friday" leaves no day open.
            continue
        if is_of_days(other) and any(day.split()[-1] in piece.split() for day in days):
            continue
        words = _as_said_now(piece, told, said, now, lexicon)
        kept = one_time(words, now, lexicon) or told
        texts = [f"{words} {new}", f"{new} {words}"]
        # Days stand in front: "saturday at six".
        for text in reversed(texts) if is_of_days(other) else texts:
            both = one_time(text, now, lexicon)
            if both is not None and any(fits(both, other, kept) for fits in (_lies_in, _goes_on, _in_part)):
                clock = words if is_of_days(other) else new
                return _at_that_hour(text, clock, old, said, now, lexicon)
    return _at_that_hour(new, new, old, said, now, lexicon)


def _at_that_hour(text: str, clock: str, old: str, said: datetime, now: datetime, lexicon: Lexicon) -> str:
    """Give a new time with the half of the day said that lies next to the old time, where none is.

    What was at six in the evening, and is moved to friday, is so in the evening.
    """
    before, anew = one_time(old, said, lexicon), one_time(text, now, lexicon)
    if before is None or anew is None or _begin_of(before) is None or _begin_of(anew) is None:
        return text
    if anew.recurrence is None and not find_times(text, now, lexicon).questions:
        # "06:00" is in the morning.
        return text
    halves = [text.replace(clock, f"{clock} {half}", 1) for half in HALVES]
    read = [(words, time) for words in halves if (time := one_time(words, now, lexicon)) is not None]
    if len({_hour_of(time, now) for _, time in read if _begin_of(time) is not None}) < len(HALVES):
        return text
    hour, then = _hour_of(before, said), instant_after(said, _begin_of(before) or 0.0)
    of_day = before.recurrence is not None or anew.recurrence is not None
    of_day = of_day or any(is_of_days(part) for part in _times_in(text, now, lexicon))

    def unlikely(time: TimeRequirement) -> tuple[bool, float]:
        anew, at = _hour_of(time, now), instant_after(now, _begin_of(time) or 0.0)
        # "At ten" tonight, and then "at five", is seven hours later, and "on friday at five" another day.
        return lexicon.policy.far_from(anew, hour if of_day else anew - seconds_between(then, at) / 3600.0)

    words, time = min(read, key=lambda pair: unlikely(pair[1]))
    return words if _hour_of(time, now) != _hour_of(anew, now) else text


def _past_hour_said(new: str, old: str, said: datetime, now: datetime, lexicon: Lexicon) -> str:
    """Give minutes past or to no hour with the one that makes them the nearest to the old time.

    Of two as near that is the hour of the old one: what was at seven, and then is at half past, is so
    half an hour later.
    """
    before, anew = _clock_in(old, said, lexicon), one_time(new, now, lexicon)
    if before is None or anew is None or not _names_clock(anew):
        return new
    begin = before.replace(minute=0, second=0, microsecond=0)
    minute = instant_after(now, anew.t_spec or 0.0).minute
    found: list[tuple[float, bool, str]] = []
    # "Ten to 12 pm" is before midnight, and "ten past 12 am" behind it.
    for hours, half in product((0, 1, -1, 2), HALVES):
        hour = begin + timedelta(hours=hours)
        text = f"{new} {hour.hour % 12 or 12} {half}"
        whole = one_time(text, now, lexicon)
        if whole is None or not _names_clock(whole):
            continue
        then = instant_after(now, whole.t_spec or 0.0)
        if then.minute == minute:
            away = abs(_second_of(then) - _second_of(before))
            found.append((min(away, DAY_SECONDS - away), then.hour != begin.hour, text))
    return min(found)[2] if found else new


def _clock_in(text: str, said: datetime, lexicon: Lexicon) -> datetime | None:
    """Give the clock time that a time is at, or bounded by first; None where it names none."""
    if not any(_is_clock(word, said, lexicon) for word in text.split()):
        # "Tomorrow morning" begins at an hour that nobody said.
        return None
    for piece in _pieces(text):
        time = one_time(piece, said, lexicon)
        bounds = () if time is None else (*_turns(time), time.t_spec, time.earliest, time.latest)
        first = next((bound for bound in bounds if bound is not None), None)
        clocked = time is not None and (time.grain in CLOCKED or bool(_turns(time)))
        if clocked and first is not None:
            return instant_after(said, first)
    return None


def _is_open(time: TimeRequirement) -> bool:
    """Whether a time only counts from another: "beforehand", "after the call"."""
    return time.anchor is not None or time.constraint is Constraint.VAGUE


def _turns(time: TimeRequirement) -> tuple[float, ...]:
    """Give when something repeated is first done: what is "every day at seven" is so in the morning."""
    return () if time.recurrence is None else time.recurrence.occurrences(2 * DAY_SECONDS)[:1]


def _is_clock(word: str, said: datetime, lexicon: Lexicon) -> bool:
    time = one_time(f"at {word}", said, lexicon)
    return time is not None and _is_at_clock(time)


def _second_of(instant: datetime) -> float:
    """Give the second of the day."""
    return instant.hour * 3600.0 + instant.minute * 60.0 + instant.second


def _names_clock(time: TimeRequirement) -> bool:
    return time.t_spec is not None and time.grain in CLOCKED


def _is_at_clock(time: TimeRequirement) -> bool:
    return time.constraint is Constraint.AT and _names_clock(time)


def _begin_of(time: TimeRequirement) -> float | None:
    """Give when a clock time is, or when something repeated is first done; None for what is neither."""
    return time.t_spec if _is_at_clock(time) else next(iter(_turns(time)), None)


def _hour_of(time: TimeRequirement, now: datetime) -> float:
    """Give the hour of a clock time, with its fraction."""
    instant = instant_after(now, _begin_of(time) or 0.0)
    return instant.hour + instant.minute / 60.0


def _pieces(text: str) -> list[str]:
    """Give a text, and what it begins and ends with, the longest first."""
    words = text.split()
    cuts = range(1, len(words))
    parts = [part for cut in cuts for part in (words[cut:], words[:cut])]
    return sorted((" ".join(part).rstrip(",") for part in (words, *parts)), key=len, reverse=True)


def _times_in(text: str, now: datetime, lexicon: Lexicon) -> list[TimeRequirement]:
    """Give the times that a text is, begins with, or ends with."""
    return [time for piece in _pieces(text) if (time := one_time(piece, now, lexicon)) is not None]


def _as_said_now(piece: str, kept: TimeRequirement, said: datetime, now: datetime, lexicon: Lexicon) -> str:
    """Give the words for a day as they are now: "tomorrow", said yesterday, is a date."""
    anew = one_time(piece, now, lexicon)
    if kept.earliest is None or anew is None or anew.earliest is None or not is_of_days(kept):
        return piece
    day = instant_after(said, kept.earliest)
    return piece if day.date() == instant_after(now, anew.earliest).date() else f"on {day:%Y-%m-%d}"


def is_of_days(time: TimeRequirement) -> bool:
    """Whether a time is a day, or several."""
    if time.constraint is not Constraint.BETWEEN or time.earliest is None or time.latest is None:
        return False
    return time.latest - time.earliest >= DAY_OR_LONGER


def _lies_in(both: TimeRequirement, one: TimeRequirement, other: TimeRequirement) -> bool:
    """Whether two times together are the one that names no day, on the days of the other."""
    days = [time for time in (one, other) if is_of_days(time)]
    bounds = [bound for bound in (both.earliest, both.latest) if bound is not None]
    if len(days) != 1 or not bounds or is_of_days(both):
        return False
    first, last = days[0].earliest, days[0].latest
    if last is not None and both.earliest is not None and both.earliest >= last:
        # "After tomorrow" begins when that is over.
        return False
    return first is not None and last is not None and all(first <= bound <= last for bound in bounds)


def _goes_on(both: TimeRequirement, other: TimeRequirement, kept: TimeRequirement) -> bool:
    """Whether what is repeated is so at another time: "every day at six", and then "at seven"."""
    repeated = both.constraint is Constraint.EVERY and kept.constraint is Constraint.EVERY
    return repeated and other.constraint is not Constraint.EVERY


def _in_part(both: TimeRequirement, one: TimeRequirement, other: TimeRequirement) -> bool:
    """Whether two times together are the clock time of the one, in the part of the day of the other."""
    times = [time for time in (one, other) if time.constraint is Constraint.AT]
    parts = [time for time in (one, other) if time.constraint is Constraint.BETWEEN and not is_of_days(time)]
    if not (times and parts) or both.constraint is not Constraint.AT or both.t_spec is None:
        return False
    first, last = parts[0].earliest, parts[0].latest
    # "At six", taken as 18:00, and then "no, in the evening" is another time in the evening.
    anew = parts[0] is not one or both.t_spec != times[0].t_spec
    return anew and first is not None and last is not None and first <= both.t_spec <= last
