"""Days said apart from their clock times: "tomorrow open the blinds at seven".

A day in front of an order holds for all that is joined to it; a day with a clock time for the clock times
behind it; any other for the times of its own instruction.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from fuzzytime.language.grammar.lexicon import Entry, Lexicon
from fuzzytime.language.meaning.calendar import Fields, is_weekday
from fuzzytime.language.meaning.expressions import Duration, Ending, Offset, Phrase, Range, Repeat, Said, Wall
from fuzzytime.language.meaning.joined.bounded_repeats import is_of_day
from fuzzytime.language.meaning.joined.intervals_on_days import is_interval, on_days
from fuzzytime.language.meaning.joined.repeats_beside import names_day_of, without_clocks
from fuzzytime.language.meaning.joined.throughout import each_day, is_clock_time, is_rest_of_days
from fuzzytime.language.meaning.joined.told_apart import ending_on, told_apart
from fuzzytime.language.meaning.times_of_day import Half, Part
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.segment import ENDS, JOINED
from fuzzytime.language.sentence.sketches.sketch import Sketch, text_between
from fuzzytime.language.sentence.together.days.below_headings import headings_of, under_heading
from fuzzytime.language.sentence.together.days.listed_days import listed_below_day
from fuzzytime.language.sentence.together.days.mornings_after import is_morning_after, part_before
from fuzzytime.requirement import BOUNDS, Constraint, Unit

WHY = frozenset({",", "-", "–", ":"})
"""Marks behind which is told what an order is for."""


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
        parted = said.wall.days is not None and said.wall.part is not None
        return (said, Said(Wall(said.wall.days))) if parted else (said,)


def on_their_days(sketches: Sequence[Sketch], draft: Draft) -> list[Sketch]:
    """Put each time of some instructions on the day that was said for it elsewhere.

    That is in the same sentence, or a heading: in front of the line, or on one above. What has no time has
    that of its heading.
    """
    text, placed = draft.text, list[Sketch]()
    headings = headings_of(sketches, draft)
    held = None
    for sketch, heading in zip(map(_on_each_day, sketches), headings, strict=True):
        day = None if heading is None else heading.day
        above = None if day is None else _Day(day.said)
        held = held if placed else above
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
        elif not named and placed:
            beside = _day_beside(placed[-1], sketch, between)
            told = sketch if beside is None else _on_day(sketch, beside)
        if named:
            told = _on_own_day(told, named[0], text)
        # What stands before a colon holds for all behind it, as in "school trip on the 12th: …".
        heads = text[sketch.part.segment.span[1] :].lstrip().startswith(":")
        if held is not None and held.part is not None and _is_over(sketch, held.part):
            # "Pack tonight, leave at five am and be there by half six"
            held = above
        held = _day_of(sketch, heads=heads) or held
        placed.append(told)
    return [under_heading(sketch, heading) for sketch, heading in zip(placed, headings, strict=True)]


def _is_over(sketch: Sketch, part: Part) -> bool:
    """Whether an instruction is in the morning behind a part of the day, and so are those behind it."""
    return any(is_morning_after(phrase.said, part) for phrase in sketch.phrases)


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
    return sketch.telling([phrase for phrase in sketch.phrases if phrase.said in (*clocks, *rests)], told)


def on_owned_day(sketch: Sketch) -> Sketch:
    """Put what happens on the day that it is named by: "friday's meeting is at ten"."""
    operation = sketch.operation
    named = (operation.object or "").lower().replace("’", "'") if operation and operation.stated else ""
    owner, mark, _ = named.removeprefix("the ").partition("'s ")
    entries = sketch.lexicon.entries.get(owner, ()) if mark else ()
    days = [Fields(weekday=e.value) if e.category == "weekday" else e.value for e in entries if _is_day(e)]
    if not days or any(phrase.said.is_day for phrase in sketch.phrases):
        return sketch
    return _on_day(sketch, _Day(Said(Wall(days[0]))))


def _is_day(entry: Entry) -> bool:
    return entry.category in {"weekday", "day"} and len(entry.words) == 1


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
    part = day.wall.part
    return part is not None and part.half is Half.NIGHT and said.constraint is Constraint.BEFORE


def _is_at_most(said: Said) -> bool:
    """Whether it is a length of time that something takes no longer than."""
    return isinstance(said.time, Duration) and said.preposition == "within"


def _is_first_day(said: Said) -> bool:
    """Whether it is a day from which on something holds: "from monday on sign in by ten to nine"."""
    days = None if said.wall.is_timed else said.wall.days
    return said.constraint is Constraint.AFTER and days is not None and days.grain is Unit.DAY


def _is_open(said: Said, day: Said) -> bool:
    """Whether it is a time of day, or a weekday in the week that is said; not a second day."""
    time = said.time
    if isinstance(time, Repeat):
        return is_interval(time) and isinstance(day.time, Wall)
    if isinstance(time, Offset):
        return is_of_day(time.anchor)
    if isinstance(time, Range):
        ends = [end for end in (time.first, time.last) if isinstance(end, Wall)]
        clocks = all(end.clock is not None and end.days is None for end in ends)
        return len(ends) > 1 and (clocks or all(_is_in_week(end, day) for end in ends))
    if isinstance(time, Ending):
        return isinstance(day.time, Wall) and ending_on(time, day.time.days) is not None
    if not isinstance(time, Wall):
        return False
    if time.days is None or (isinstance(day.time, Repeat) and names_day_of(day.time, time)):
        return True
    return _is_in_week(time, day)


def _is_in_week(wall: Wall, day: Said) -> bool:
    """Whether it is a weekday in the week, or month, that is said."""
    coarse = day.wall.days is not None and day.wall.days.grain is not Unit.DAY
    return coarse and is_weekday(wall.days)


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
        if isinstance(phrase.said.time, Repeat) and isinstance(day.time, Repeat) and other != place:
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
    placed = replace(sketch, phrases=tuple(phrases))
    # "On friday the painters are here all day" is on that day, and not for 24 hours.
    return (
        placed.keeping(lambda phrase: not _is_all_day(phrase, text, sketch.lexicon)) if day.is_day else placed
    )


def _is_all_day(phrase: Phrase, text: str, lexicon: Lexicon) -> bool:
    """Whether it is the length of a day that is said as all of it: "all day"."""
    said = {*text[slice(*phrase.span)].lower().split()}
    whole = not said.isdisjoint(lexicon.beside.all_of_a_day)
    return whole and phrase.said.time == Duration(((1, Unit.DAY),))


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
        if said.wall.days is not None and said.wall.is_timed:
            return _Day(Said(Wall(said.wall.days)), part=part_before(sketch, said))
        daily = without_clocks(time) if isinstance(time, Repeat) and phrase.span[1] <= start else None
        if daily is not None:
            # "Every evening at six feed the hens, and at seven shut the coop"
            return _Day(Said(daily, Constraint.EVERY))
    return None


def _day_beside(before: Sketch, sketch: Sketch, between: str) -> _Day | None:
    """Give the day of what an event is told beside: "buy the cake on friday, guests come at four"."""
    told = [one.operation is not None and one.operation.stated for one in (before, sketch)]
    if not told[1] or ENDS & {*between} or (between.strip() not in WHY and not told[0]):
        return None
    days = [said for said in (one.said for one in before.phrases) if said.is_day]
    days = [said for said in days if (on := said.wall.days) is not None and on.grain is Unit.DAY]
    days = [said for said in days if said.constraint not in BOUNDS]
    return _Day(days[0]) if len(days) == 1 else None
