"""A new time with what it leaves of the old one: "tomorrow at six", and then "no, at seven"."""

from datetime import datetime

from fuzzytime.language.finding import find_times
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS
from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime.times import instant_after

DAY_OR_LONGER = DAY_SECONDS - 3600 - 1
"""Seconds that a day has at least, where clocks change."""


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
    'tomorrow at seven'
    """
    other = _one_time(new, now, lexicon)
    if other is None:
        return new
    times = {piece: time for piece in _pieces(old) if (time := _one_time(piece, said, lexicon)) is not None}
    days = [piece for piece, time in times.items() if _is_of_days(time)]
    for piece, told in times.items():
        if _is_of_days(other) and any(day in piece for day in days):
            continue
        words = _as_said_now(piece, told, said, now, lexicon)
        kept = _one_time(words, now, lexicon) or told
        texts = [f"{words} {new}", f"{new} {words}"]
        # Days stand in front: "saturday at six".
        for text in reversed(texts) if _is_of_days(other) else texts:
            both = _one_time(text, now, lexicon)
            if both is not None and (_lies_in(both, other, kept) or _goes_on(both, kept, other)):
                return text
    return new


def _pieces(text: str) -> list[str]:
    """Give a text, and what it begins and ends with, the longest first."""
    words = text.split()
    cuts = range(1, len(words))
    parts = [part for cut in cuts for part in (words[cut:], words[:cut])]
    return sorted((" ".join(part).rstrip(",") for part in (words, *parts)), key=len, reverse=True)


def _one_time(text: str, now: datetime, lexicon: Lexicon) -> TimeRequirement | None:
    """Give the time that a text is, whole."""
    found = find_times(text, now, lexicon).requirements
    return found[0] if len(found) == 1 and found[0].span == (0, len(text)) else None


def _as_said_now(piece: str, kept: TimeRequirement, said: datetime, now: datetime, lexicon: Lexicon) -> str:
    """Give the words for a day as they are now: "tomorrow", said yesterday, is a date."""
    anew = _one_time(piece, now, lexicon)
    if kept.earliest is None or anew is None or anew.earliest is None or not _is_of_days(kept):
        return piece
    day = instant_after(said, kept.earliest)
    return piece if day.date() == instant_after(now, anew.earliest).date() else f"on {day:%Y-%m-%d}"


def _is_of_days(time: TimeRequirement) -> bool:
    """Whether a time is a day, or several."""
    if time.constraint is not Constraint.BETWEEN or time.earliest is None or time.latest is None:
        return False
    return time.latest - time.earliest >= DAY_OR_LONGER


def _lies_in(both: TimeRequirement, one: TimeRequirement, other: TimeRequirement) -> bool:
    """Whether two times together are the one that names no day, on the days of the other."""
    days = [time for time in (one, other) if _is_of_days(time)]
    bounds = [bound for bound in (both.earliest, both.latest) if bound is not None]
    if len(days) != 1 or not bounds or _is_of_days(both):
        return False
    first, last = days[0].earliest, days[0].latest
    return first is not None and last is not None and all(first <= bound <= last for bound in bounds)


def _goes_on(both: TimeRequirement, kept: TimeRequirement, other: TimeRequirement) -> bool:
    """Whether what is repeated is so at another time: "every day at six", and then "at seven"."""
    repeated = both.constraint is Constraint.EVERY and kept.constraint is Constraint.EVERY
    return repeated and other.constraint is not Constraint.EVERY
