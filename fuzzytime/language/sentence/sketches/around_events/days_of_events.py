"""Times of day on a day that is counted from an event: "by noon the day before the wedding".

Where something told says when the event is, they are on that day; where nothing does, they are on none, and
least of all on today.
"""

from dataclasses import replace
from datetime import timedelta

from fuzzytime.language.instruction import Remark, RemarkKind
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.expressions import Phrase, Said, Wall
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.meaning.joined.beside import joined
from fuzzytime.language.meaning.joined.bounded_repeats import is_of_day
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.clauses.clause_sides import FIRST
from fuzzytime.language.sentence.references.anchors import Anchors
from fuzzytime.language.sentence.sketches.sketch import Sketch

ON_THE_DAY = "on the day of"
"""The marker of what is on the day of an event."""

COUNTED = frozenset({"before", "after"})
"""Clauses from whose event days are counted."""

ALL_DAY = "all day"
"""The rule of such a day where no time of day is said."""

DAY = timedelta(days=1)


def on_days_of_events(sketch: Sketch, anchors: Anchors, text: str) -> tuple[Sketch, int | None, list[Remark]]:
    """Put the times of day of an instruction on the day that its clause counts from an event.

    Gives the position of the event, too, if there is
    one, and what is pointed at.
    """
    remarks: list[Remark] = []
    event: int | None = None
    for clause in sketch.clauses:
        away = _days_away(clause)
        timed = clause.day_part is not None or any(map(_is_of_day, sketch.phrases))
        if away is None or not (timed or _is_any_time(clause)):
            continue
        target = anchors.target_of(clause)
        day = None if target is None else anchors.told.start(target)
        if day is None and not timed:
            continue
        if day is None:
            unused = [phrase for phrase in sketch.phrases if _is_of_day(phrase)]
            if clause.day_part is not None and target is not None:
                unused.append(clause.day_part)
            remarks += (_unknown(text, phrase, clause) for phrase in unused)
            sketch = sketch.keeping(lambda phrase: not _is_of_day(phrase))
            continue
        event, there = target, day.date() + away * DAY
        wall = Wall(Fields(there.year, there.month, there.day))
        if clause.day_part is not None:
            sketch, wall = _in_part(sketch, replace(clause.day_part, span=clause.span), wall)
        elif not timed:
            on_day = Phrase(Said(wall, None, "on"), 0, 0, clause.span, ALL_DAY)
            sketch = sketch.also(on_day, about=sketch.reference)
        phrases = tuple(_on_day(phrase, wall) if _is_of_day(phrase) else phrase for phrase in sketch.phrases)
        kept = tuple(other for other in sketch.clauses if other is not clause)
        sketch = replace(sketch, phrases=phrases, clauses=kept)
    return sketch, event, remarks


def _days_away(clause: Clause) -> int | None:
    """Give how many whole days a clause is from its event; None where it counts none."""
    distance = clause.distance
    if clause.marker == ON_THE_DAY or (clause.day_part is not None and distance is None):
        # "On the day of the party", "on the morning of the party"
        return 0
    if distance is None or any(unit in SUB_DAY for _, unit in distance.terms) or distance.until is not None:
        return None
    return round(distance.seconds / DAY.total_seconds()) * (-1 if clause.kind in FIRST else 1)


def _is_any_time(clause: Clause) -> bool:
    """Whether a clause counts days, and leaves open when on the day: "five days before the wedding"."""
    exact = clause.distance is not None and not clause.distance.hedges and clause.side is None
    return exact and clause.kind in COUNTED and clause.beside is None


def _is_of_day(phrase: Phrase) -> bool:
    return is_of_day(phrase.said.time)


def _on_day(phrase: Phrase, day: Wall) -> Phrase:
    """Give a time on a day, where they go together."""
    time = phrase.said.time
    both = joined(day, time) if isinstance(time, Wall) else None
    return phrase if both is None else phrase.at(both)


def _in_part(sketch: Sketch, part: Phrase, day: Wall) -> tuple[Sketch, Wall]:
    """Put a part of the day among the times, or, where there is a time of that day, into the day."""
    if any(map(_is_of_day, sketch.phrases)):
        both = joined(day, part.said.time) if isinstance(part.said.time, Wall) else None
        return sketch, both or day
    return sketch.also(part, about=sketch.reference), day


def _unknown(text: str, phrase: Phrase, clause: Clause) -> Remark:
    said, what = text[slice(*phrase.span)], text[slice(*clause.span)]
    message = f"{said!r} is not used: on which day it is, {what!r}, is not known"
    return Remark(RemarkKind.UNRESOLVED, phrase.span, message)
