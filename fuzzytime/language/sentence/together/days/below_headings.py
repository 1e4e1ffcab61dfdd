"""Instructions below a line that says when: "Saturday:", "school trip on the 12th:"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.meaning.expressions import (
    Duration,
    Ending,
    Phrase,
    Range,
    Repeat,
    Time,
    TimeWord,
    Wall,
)
from fuzzytime.language.meaning.joined.intervals_on_days import is_interval
from fuzzytime.language.meaning.joined.told_apart import ending_on
from fuzzytime.language.meaning.phrases import is_window
from fuzzytime.language.sentence.references.phrase_anchors import ORDERING
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.heading import Heading
from fuzzytime.language.sentence.segments.segment import JOINED
from fuzzytime.language.sentence.sketches.sketch import Sketch, text_between
from fuzzytime.language.sentence.together.days.listed_days import heads_list
from fuzzytime.requirement import Constraint


def under_first_line(sketches: list[Sketch], text: str) -> list[Sketch]:
    """Let a day on the first line hold for all lines below it: "Saturday:", "school trip on the 12th:"."""
    first, mark, rest = text.partition(":")
    if not mark or not sketches or not rest.lstrip(" \t\r").startswith("\n"):
        return sketches
    days = [phrase for phrase in sketches[0].phrases if phrase.span[1] <= len(first) and phrase.said.is_day]
    if not days or first[days[-1].span[1] :].strip():
        return sketches
    days = [replace(day, said=day.said.sure) for day in days]
    return [sketches[0], *(_with_days(sketch, days) for sketch in sketches[1:])]


def _with_days(sketch: Sketch, days: Sequence[Phrase]) -> Sketch:
    """Give a sketch on some days, unless it has one of its own."""
    if any(phrase.said.is_day for phrase in sketch.phrases):
        return sketch
    return sketch.under(days)


def headings_of(sketches: Sequence[Sketch], draft: Draft) -> list[Heading | None]:
    """Give for each of some sketches the time that heads it: that in front of its line, or on one above.

    "Monday: change the sheets. Water the ferns."
    """
    found: list[Heading | None] = []
    heading = draft.heading
    for place, sketch in enumerate(sketches):
        between = text_between(sketches[place - 1], sketch, draft.text) if place else ""
        heading = draft.heading if "\n" in between else heading
        if heads_list(sketch, draft.text):
            day = sketch.phrases[0]
            name = draft.text[slice(*day.span)]
            heading = Heading(name, draft.text, draft.scanned, (day.at(day.said.sure.time),))
            found.append(draft.heading)
        else:
            found.append(heading)
    return found


def under_heading(sketch: Sketch, heading: Heading | None) -> Sketch:
    """Give an instruction the times of a line above, where its own do not say when something is done."""
    if heading is None:
        return sketch
    sketch = _during_hours(sketch, heading)
    operation = sketch.operation
    if operation is not None and operation.addressee is None and not operation.stated:
        operation = replace(operation, addressee=heading.addressee)
        sketch = replace(sketch, operation=operation)
    if operation is None or any(
        _tells_when(phrase) or _is_on_another_day(phrase, heading) for phrase in sketch.phrases
    ):
        return sketch
    if operation.stated and sketch.phrases and not sketch.times:
        # "It takes an hour"
        return sketch
    if sketch.part.segment.connective not in JOINED and not sketch.phrases:
        # What comes "then" comes on the day of what it follows.
        return sketch
    wholes = (_is_whole_day(phrase) or is_window(phrase) for phrase in heading.phrases)
    if _counts_from_another(sketch) and all(wholes):
        # "An hour before the meeting" is on the meeting's day, and counts from nothing above.
        conditions = (clause for clause in heading.clauses if clause.distance is None)
        return replace(sketch, headed=tuple(conditions))
    due = _due_on_day(sketch, heading)
    return replace(due or sketch.under(heading.phrases), headed=heading.clauses)


def _during_hours(sketch: Sketch, heading: Heading) -> Sketch:
    """Give what is done every so often the hours of a line above for its bounds, where it names none.

    What is due by the end of the day is due by that of theirs.
    """
    hours = next((phrase.said.time for phrase in heading.phrases if is_window(phrase)), None)
    if not isinstance(hours, Range):
        return sketch
    phrases = [phrase.at(_bounded(phrase.said.time, hours)) for phrase in sketch.phrases]
    return replace(sketch, phrases=tuple(phrases))


def _bounded(time: Time | Duration | Repeat, hours: Range) -> Time | Duration | Repeat:
    """Give a repetition by an interval with those bounds that it names itself, and else with some hours."""
    if isinstance(time, Ending) and isinstance(hours.first, Wall):
        return ending_on(time, hours.first.days) or time
    if not isinstance(time, Repeat) or not is_interval(time):
        return time
    return replace(time, starting=time.starting or hours.first, until=time.until or hours.last)


def _counts_from_another(sketch: Sketch) -> bool:
    """Whether it is so long before or after something else, and nothing else is said of when."""
    measured = any(clause.distance is not None and not clause.excepted for clause in sketch.clauses)
    return measured and not sketch.times


def _is_whole_day(phrase: Phrase) -> bool:
    day = phrase.said.time
    return isinstance(day, Wall) and day.days is not None and day.clock is None and day.part is None


def _due_on_day(sketch: Sketch, heading: Heading) -> Sketch | None:
    """Give what is due by an hour of the day of a line above: "Thursday:", then "bins out before seven"."""
    walls = [phrase.said.time for phrase in heading.phrases]
    day = walls[0] if len(walls) == 1 else None
    if not isinstance(day, Wall) or not _is_whole_day(heading.phrases[0]):
        return None
    due = [phrase for phrase in sketch.phrases if phrase.said.constraint is Constraint.BEFORE]
    if len(due) != 1 or not isinstance(due[0].said.time, Wall) or due[0].said.time.clock is None:
        return None
    (bound,) = due
    kept = replace(bound, said=replace(bound.said, within=Wall(day.days)))
    return replace(sketch, phrases=tuple(kept if one is bound else one for one in sketch.phrases))


def _is_on_another_day(phrase: Phrase, heading: Heading) -> bool:
    """Whether a time has a day of its own: "Saturday:", then "print them by noon on friday"."""
    above = None if heading.day is None else heading.day.said.wall.days
    return above is not None and phrase.said.wall.days not in {None, above}


def _tells_when(phrase: Phrase) -> bool:
    """Whether a time is more than a bound, a length, or a place in an order."""
    said = phrase.said
    if isinstance(said.time, (Duration, TimeWord)):
        return isinstance(said.time, TimeWord) and said.time.word not in ORDERING
    return said.constraint not in {Constraint.BEFORE, Constraint.AFTER, Constraint.FOR}
