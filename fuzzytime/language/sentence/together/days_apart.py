"""Days said apart from their clock times: "tomorrow open the blinds at seven".

A day in front of an order holds for all that is joined to it; a day with a clock time for the clock times
behind it; any other for the times of its own instruction.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from fuzzytime.language.grammar.lexicon import Entry, Lexicon
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.expressions import (
    Duration,
    Offset,
    Phrase,
    Range,
    Repeat,
    Said,
    TimeWord,
    Wall,
)
from fuzzytime.language.meaning.intervals_on_days import on_days
from fuzzytime.language.meaning.repeats_beside import names_day_of, without_clocks
from fuzzytime.language.meaning.throughout import each_day, is_clock_time, is_rest_of_days
from fuzzytime.language.meaning.times_of_day import Half, Part
from fuzzytime.language.meaning.told_apart import told_apart
from fuzzytime.language.sentence.references.phrase_anchors import ORDERING
from fuzzytime.language.sentence.segments.drafts import Heading
from fuzzytime.language.sentence.segments.segment import ENDS, JOINED
from fuzzytime.language.sentence.sketches.sketch import Sketch, text_between
from fuzzytime.language.sentence.together.listed_days import listed_below_day
from fuzzytime.language.sentence.together.mornings import is_morning_after, part_before
from fuzzytime.requirement import Constraint, Unit


@dataclass(frozen=True, slots=True)
class _Day:
    """A day that holds for instructions behind; ``phrase`` where it holds for those without a time too.

    ``part`` is what was said of that day with it.
    """

    said: Said
    phrase: Phrase | None = None
    part: Part | None = None

    @property
    def days(self) -> tuple[Said, ...]:
        """As said, and without the part of the day in it: "tomorrow morning and evening"."""
        said = self.said.sure
        time = said.time
        parted = isinstance(time, Wall) and time.days is not None and time.part is not None
        return (said, Said(Wall(time.days))) if parted and isinstance(time, Wall) else (said,)


def on_their_days(sketches: Sequence[Sketch], text: str, heading: Heading | None = None) -> list[Sketch]:
    """Put each time of some instructions on the day that was said for it elsewhere.

    That is in the same sentence, or on a line above, as a heading; what has no time has that of its heading.
    """
    placed: list[Sketch] = []
    day = None if heading is None else heading.day
    above = None if day is None else _Day(day.said)
    held = above
    for sketch in map(_on_each_day, sketches):
        between = text_between(placed[-1], sketch, text) if placed else ""
        if ENDS & set(between) and not listed_below_day(placed[0], sketch, between, text):
            held = above
        offered = _offered(sketch)
        days = [(p, phrase.said) for p, phrase in enumerate(sketch.phrases) if phrase.said.is_day]
        days = [(place, said) for place, said in days if place not in offered]
        named = [place for place, _ in sorted(days, key=lambda day: _narrowness(day[1]))]
        named += [place for place, phrase in enumerate(sketch.phrases) if _is_first_day(phrase.said)]
        told = sketch
        if held is not None and (not named or _is_part(sketch.phrases[named[0]].said)):
            # "Sunday:", then "assemble the bed in the morning"
            told = _on_day(sketch, held)
        if named:
            told = _on_own_day(told, named[0], text)
        # What stands before a colon holds for all behind it, as in "school trip on the 12th: …".
        heads = text[sketch.part.segment.span[1] :].lstrip().startswith(":")
        held = _day_of(sketch, heads=heads) or held
        placed.append(told)
    return placed if heading is None else [_under(sketch, heading) for sketch in placed]


def _offered(sketch: Sketch) -> set[int]:
    """Give the places of times one of which is kept: the day of one is none of another's."""
    alternatives = {place for place, phrase in enumerate(sketch.phrases) if phrase.said.alternative}
    return alternatives | {place - 1 for place in alternatives}


def _on_each_day(sketch: Sketch) -> Sketch:
    """Let a clock time be on each day of what is left: "for the rest of the week feed it at six"."""
    said = [phrase.said for phrase in sketch.phrases]
    clocks, rests = [one for one in said if is_clock_time(one)], [one for one in said if is_rest_of_days(one)]
    daily = each_day(clocks[0], rests[0]) if len(clocks) == len(rests) == 1 else None
    if daily is None:
        return sketch
    told = Said(daily, Constraint.EVERY, clocks[0].preposition)
    apart = (*clocks, *rests)
    return replace(
        sketch,
        phrases=tuple(
            replace(p, said=p.said.borrowing(told)) if p.said in apart else p for p in sketch.phrases
        ),
    )


def on_owned_day(sketch: Sketch, lexicon: Lexicon) -> Sketch:
    """Put what happens on the day that it is named by: "friday's meeting is at ten"."""
    operation = sketch.operation
    named = (operation.object or "").lower().replace("’", "'") if operation and operation.stated else ""
    owner, mark, _ = named.removeprefix("the ").partition("'s ")
    entries = lexicon.entries.get(owner, ()) if mark else ()
    days = [Fields(weekday=e.value) if e.category == "weekday" else e.value for e in entries if _is_day(e)]
    if not days or any(phrase.said.is_day for phrase in sketch.phrases):
        return sketch
    return _on_day(sketch, _Day(Said(Wall(days[0]))))


def _is_day(entry: Entry) -> bool:
    return entry.category in {"weekday", "day"} and len(entry.words) == 1


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


def _with_days(sketch: Sketch, days: list[Phrase]) -> Sketch:
    """Give a sketch on some days, unless it has one of its own."""
    if any(phrase.said.is_day for phrase in sketch.phrases):
        return sketch
    return sketch.under(days)


def _under(sketch: Sketch, heading: Heading) -> Sketch:
    """Give an instruction the times of a line above, where its own do not say when something is done."""
    operation = sketch.operation
    if operation is not None and operation.addressee is None and not operation.stated:
        operation = replace(operation, addressee=heading.addressee)
        sketch = replace(sketch, operation=operation)
    if operation is None or any(_tells_when(phrase) for phrase in sketch.phrases):
        return sketch
    if operation.stated and all(phrase.said.constraint is Constraint.FOR for phrase in sketch.phrases):
        # "It takes an hour"
        return sketch
    if sketch.part.segment.connective not in JOINED and not sketch.phrases:
        # What comes "then" comes on the day of what it follows.
        return sketch
    due = _due_on_day(sketch, heading)
    return replace(due or sketch.under(heading.phrases), headed=heading.clauses)


def _due_on_day(sketch: Sketch, heading: Heading) -> Sketch | None:
    """Give what is due by an hour of the day of a line above: "Thursday:", then "bins out before seven"."""
    walls = [phrase.said.time for phrase in heading.phrases]
    day = walls[0] if len(walls) == 1 else None
    if not isinstance(day, Wall) or day.days is None or day.clock is not None or day.part is not None:
        return None
    due = [phrase for phrase in sketch.phrases if phrase.said.constraint is Constraint.BEFORE]
    if len(due) != 1 or not isinstance(due[0].said.time, Wall) or due[0].said.time.clock is None:
        return None
    (bound,) = due
    kept = replace(bound, said=replace(bound.said, within=Wall(day.days)))
    return replace(sketch, phrases=tuple(kept if one is bound else one for one in sketch.phrases))


def _tells_when(phrase: Phrase) -> bool:
    """Whether a time is more than a bound, a length, or a place in an order."""
    said = phrase.said
    if isinstance(said.time, (Duration, TimeWord)):
        return isinstance(said.time, TimeWord) and said.time.word not in ORDERING
    return said.constraint not in {Constraint.BEFORE, Constraint.AFTER, Constraint.FOR}


def _is_part(said: Said) -> bool:
    """Whether it is a part of a day that is not said."""
    return isinstance(said.time, Wall) and said.time.days is None


def _narrowness(said: Said) -> int:
    """Give how deep a time lies in others of one thing: "at dawn … every other day" is dawn of those days."""
    if isinstance(said.time, Repeat):
        return 0
    return 2 if _is_part(said) else 1


def _ends_night(said: Said, day: Said) -> bool:
    """Whether it is a deadline of what goes on at night: "charge it overnight so it's ready by six"."""
    night = isinstance(day.time, Wall) and day.time.part is not None and day.time.part.half is Half.NIGHT
    return night and said.constraint is Constraint.BEFORE


def _is_at_most(said: Said) -> bool:
    """Whether it is a length of time that something takes no longer than."""
    return isinstance(said.time, Duration) and said.preposition == "within"


def _is_first_day(said: Said) -> bool:
    """Whether it is a day from which on something holds: "from monday on sign in by ten to nine"."""
    time = said.time
    days = time.days if isinstance(time, Wall) and time.clock is None and time.part is None else None
    return said.constraint is Constraint.AFTER and days is not None and days.grain is Unit.DAY


def _is_open(said: Said, day: Said) -> bool:
    """Whether it is a time of day, or a weekday in the week that is said; not a second day."""
    time = said.time
    if isinstance(time, Offset):
        return isinstance(time.anchor, Wall) and time.anchor.clock is not None and time.anchor.days is None
    if isinstance(time, Range):
        ends = [end for end in (time.first, time.last) if isinstance(end, Wall)]
        clocks = all(end.clock is not None and end.days is None for end in ends)
        return len(ends) > 1 and (clocks or all(_is_in_week(end, day) for end in ends))
    if not isinstance(time, Wall):
        return False
    if time.days is None or (isinstance(day.time, Repeat) and names_day_of(day.time, time)):
        return True
    return _is_in_week(time, day)


def _is_in_week(wall: Wall, day: Said) -> bool:
    """Whether it is a weekday in the week, or month, that is said."""
    coarse = isinstance(day.time, Wall) and day.time.days is not None and day.time.days.grain is not Unit.DAY
    return coarse and isinstance(wall.days, Fields) and wall.days.weekly


def _every_so_often(phrase: Phrase, day: Phrase, text: str) -> Said | None:
    """Give what is done every so often, on the days that are said apart from that."""
    first, second = sorted((phrase, day), key=lambda one: one.span)
    said, joint = phrase.said, text[first.span[1] : second.span[0]].strip(" ,").lower()
    if not isinstance(said.time, Repeat) or not isinstance(day.said.time, Repeat) or joint in {"and", "or"}:
        return None
    found = on_days(said.time, day.said.time)
    return None if found is None else replace(said, time=found, constraint=Constraint.EVERY)


def _on_own_day(sketch: Sketch, place: int, text: str) -> Sketch:
    """Put the other times of an instruction on its day; those of a repetition are all of it."""
    day, phrases = sketch.phrases[place].said, list(sketch.phrases)
    repeated = [place]
    for other, phrase in enumerate(sketch.phrases):
        if other != place and _is_at_most(phrase.said):
            # "Run it in under 25 minutes on saturday"
            hedges = ("at most", *phrase.said.hedges)
            told_length = replace(phrase.said, constraint=Constraint.FOR, preposition="for", hedges=hedges)
            phrases[other] = replace(phrase, said=told_length)
            continue
        if isinstance(phrase.said.time, Repeat) and other != place:
            often = _every_so_often(phrase, replace(sketch.phrases[place], said=day), text)
            if often is not None:
                phrases[other], day = replace(phrase, said=often), often
                repeated.append(other)
            continue
        apart = other == place or not _is_open(phrase.said, day)
        told = (
            None
            if apart or (other > place and _ends_night(phrase.said, day))
            else told_apart(phrase.said, day)
        )
        if told is None:
            continue
        phrases[other] = replace(phrase, said=told)
        if isinstance(told.time, Repeat):
            day = told
            repeated.append(other)
    if len(repeated) > 1:
        for other in repeated:
            whole = replace(phrases[other].said, time=day.time)
            said = sketch.phrases[other].said
            phrases[other] = replace(phrases[other], said=said.borrowing(whole))
    return replace(sketch, phrases=tuple(phrases))


def _on_day(sketch: Sketch, held: _Day) -> Sketch:
    """Put the times of an instruction on a day that was said before it; without a time, it has that day."""
    if held.phrase is not None and not sketch.phrases and not sketch.clauses:
        alone = sketch.part.segment.connective in JOINED and sketch.operation is not None
        return replace(sketch, phrases=(held.phrase,), references=(None,)) if alone else sketch
    phrases = []
    for phrase in sketch.phrases:
        told = None
        # "Soak the beans tonight, cook them in the morning"
        later = held.part is not None and is_morning_after(phrase.said, held.part)
        for day in held.days if _is_open(phrase.said, held.said) and not later else ():
            told = told or told_apart(phrase.said, day)
        phrases.append(phrase if told is None else replace(phrase, said=told))
    return replace(sketch, phrases=tuple(phrases))


def _day_of(sketch: Sketch, *, heads: bool) -> _Day | None:
    """Give the day that an instruction hands on to those joined to it, or to all where it ``heads`` them."""
    start = sketch.operation.span[0] if sketch.operation is not None else 0
    for phrase in sketch.phrases:
        said = phrase.said
        if said.is_day and (heads or phrase.span[1] <= start):
            return _Day(said, phrase, part_before(sketch, said))
        time = said.time
        if isinstance(time, Wall) and time.days is not None and (time.clock or time.part) is not None:
            return _Day(Said(Wall(time.days)), part=part_before(sketch, said))
        daily = without_clocks(time) if isinstance(time, Repeat) and phrase.span[1] <= start else None
        if daily is not None:
            # "Every evening at six feed the hens, and at seven shut the coop"
            return _Day(Said(daily, Constraint.EVERY))
    return None
