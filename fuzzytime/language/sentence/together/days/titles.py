"""The first of some lines, where it says on which day, or in which hours, the lines below it are."""

from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.meaning.calendar import Calendar
from fuzzytime.language.meaning.days.relations import Relative
from fuzzytime.language.meaning.expressions import Phrase, Range, Repeat, Said, Wall, wall_of
from fuzzytime.language.meaning.phrases import is_window
from fuzzytime.language.meaning.times_of_day import Clock, Half
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.heading import HEADED, Heading
from fuzzytime.language.sentence.segments.lists.things_needed import is_marked
from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.sketches.sketch import sketch_of
from fuzzytime.language.sentence.together.days.windows import clocks_in, is_within
from fuzzytime.language.sentence.verbs.without_verbs.named_deeds import names_deed

FEWEST = 3
"""Lines below a title, at least."""

ENOUGH = 5
"""Lines with hours below a title that make it one, whatever it names: "Concert Saturday", "Sunday plot"."""

FEWEST_NAMING = 2
"""Words of a title without a time, at least: "Dentist" may be an entry."""

FEW_DATED = 4
"""Of so many lines below a title, one may have a day of its own, or be outside of its hours."""

LONGEST = 6
"""Words of a title, at most."""

SEVERAL = "parts"
"""What a part of the day means, and several of it."""

FROM_TO = 2
"""Clock times of a stretch."""

SHIFT = (Clock(19, full_day=True), Clock(9, full_day=True))
"""From when to when those are at work who work at night, at most; estimated."""

APART = ",:-–—("
"""What may stand between the name of a title and its day: "Brew day, Saturday"."""


def title_of(drafts: Sequence[Draft]) -> Heading | None:
    """Give the day, or the hours, that the first of some lines names with what they are about.

    So does "Early shift Thursday", or "Night shift Friday 21:00-07:00". The lines below have clock times,
    and no days of their own; what somebody attends is no title. What only names what they are about has no
    time: "Tech rehearsal".
    """
    first, below = drafts[0], [draft for draft in drafts[1:] if draft.now == drafts[0].now]
    clocks = [found for draft in below if (found := clocks_in(draft))]
    night = _night_of(first) if len(clocks) >= FEWEST else None
    if night is not None:
        return Heading(name_of(first), first.text, first.scanned, held(first, [night]))
    if len(below) < FEWEST or len(first.phrases) > 1:
        return None
    alone = len(clocks) >= FEWEST and (_only_names(first) or _is_numbered(first))
    if not first.phrases:
        alone = alone or (len(below) > FEWEST and _heads_steps(first, below))
        return Heading(name_of(first), first.text, first.scanned) if alone else None
    (time,) = first.phrases
    if is_window(time):
        within = sum(is_within(found, time, first, first.lexicon.policy) for found in clocks)
        most = 2 * within >= len(below) and FEW_DATED * (len(clocks) - within) <= len(clocks)
        named = most and _is_named(first, time)
    else:
        time = _whole_day(time)
        named = time.said.is_day and is_of_calendar(time) and _names_day_of(first, time, below)
    said = [word.text for word in first.scanned.words[time.first : time.end]]
    if not first.lexicon.beside.before_or_after.isdisjoint(said) or first.scanned.words[-1].text == ".":
        # "Shower, pack the night before."
        return None
    led = {None, "between", *(() if begins_order(first) else ("for", "on"))}
    if not named or time.said.preposition not in led:
        return None
    return _heading(first, time)


def _heads_steps(first: Draft, below: Sequence[Draft]) -> bool:
    """Whether a line only names what is made, or done, by the orders, or of the things, below it.

    The only line without a mark does, whatever it may ask for ("Release 2.4"), and so does what stands in
    front of what is needed for it: "Mushroom risotto for 4".
    """
    if is_marked(first.text) or first.step is not None or first.needed:
        return False
    numbered = all(draft.step is not None for draft in below)
    if begins_order(first):
        # "Changing the filter"
        return numbered
    marked = sum(is_marked(draft.text) or draft.step is not None for draft in below)
    things = [draft.needed for draft in below]
    return marked == len(below) or any(things[:2]) or _only_names(first)


def _night_of(first: Draft) -> Phrase | None:
    """Give the hours of the night of which a title names the shift: "Night shift Saturday", "Nights".

    Without a day it is tonight; its hours may be said, too: "on 10pm off 6am".
    """
    words, times = first.scanned.words, [phrase.said.time for phrase in first.phrases]
    worked = {one.text for one, behind in pairwise(words) if behind.text in first.lexicon.beside.shifts}
    named = [
        entry.value
        for word in words
        for entry in first.lexicon.entries.get(word.text, ())
        if entry.category == SEVERAL or (entry.category == "part" and word.text in worked)
    ]
    night = any(part.half is Half.NIGHT and part.start for part in named)
    if not night or begins_order(first):
        return None
    clocked = [time for time in times if isinstance(time, Wall) and time.clock is not None]
    if len(clocked) == len(times) == FROM_TO:
        return replace(first.phrases[0], said=Said(Range(*clocked)))
    day = next(iter(times), Wall(Relative(0)))
    day = (day.starting or Wall(Relative(0))) if isinstance(day, Repeat) else day
    if len(times) > 1 or not isinstance(day, Wall) or day.days is None or day.clock is not None:
        return None
    return Phrase(Said(shift_of(day.days)), 0, 0, (0, len(first.text)), HEADED)


def shift_of(day: Calendar) -> Range:
    """Give the hours of a shift at night, from the evening of a day on."""
    return Range(Wall(day, clock=SHIFT[0]), Wall(clock=SHIFT[1]))


def _names_day_of(first: Draft, time: Phrase, below: Sequence[Draft]) -> bool:
    """Whether lines below have hours, few of them have days, and the first is nothing to do on its day."""
    hours = sum(bool(clocks_in(draft)) for draft in below)
    dated = sum(any(map(names_day, draft.phrases)) for draft in below)
    if FEW_DATED * dated > len(below):
        return False
    most, alone = 2 * hours >= len(below), hours >= FEWEST and _only_names(first)
    if hours >= ENOUGH and 3 * hours >= len(below) and not begins_order(first):
        return True
    apart = first.text[: time.span[0]].rstrip()[-1:]
    enough = most or (hours >= FEWEST and apart != "" and apart in APART)
    numbered = hours >= FEWEST and _numbers_day(first, time)
    return numbered or ((enough or alone) and _is_named(first, time))


def begins_order(draft: Draft) -> bool:
    """Whether a part of a line begins with what is done to something: "clean:", "fix the fence:"."""
    lexicon = draft.lexicon
    asked = lexicon.alone | lexicon.chores | lexicon.addressing | lexicon.ordering
    return any(_begins_with(part, asked) for part in draft.parts)


def _begins_with(part: Part, asked: AbstractSet[str]) -> bool:
    tree = part.tree
    first = next((place for place, node in enumerate(tree.nodes) if node.text[0].isalpha()), None)
    if first is None:
        return False
    owned = any(tree.children(thing, "det", "poss") for thing in tree.children(first, "dobj"))
    root = tree.nodes[tree.root]
    named = tree.nodes[first].relation == "compound"
    return (tree.nodes[first].lower in asked and not named) or root.lower in asked or owned


def _whole_day(time: Phrase) -> Phrase:
    """Give a day without the meal that a title names on it: "Sat 7 March lunch + dinner"."""
    wall = time.said.time
    if not isinstance(wall, Wall) or wall.days is None or wall.part is None or not wall.part.meal:
        return time
    return time.at(replace(wall, part=None))


def hours_of(draft: Draft) -> Heading | None:
    """Give the hours that a line with a colon names behind what goes on then: "Market 9-16:"."""
    (time, *others) = draft.phrases or (None,)
    if time is None or others or not is_window(time) or not _is_named(draft, time):
        return None
    return _heading(draft, time)


def _heading(draft: Draft, time: Phrase) -> Heading:
    """Give a heading with a time; what goes on in those hours, as a shift does, is told by its line too."""
    named = [word.text for word in draft.scanned.words[: time.first] if word.is_letters]
    happens = is_window(time) and not draft.lexicon.frames.isdisjoint(named[-1:])
    name = draft.text[slice(*time.span)]
    return Heading(name, draft.text, draft.scanned, held(draft, (time,)), happens=happens)


def _is_named(first: Draft, time: Phrase) -> bool:
    """Whether a time stands behind the name of what goes on then, which asks for nothing.

    How many there are may follow: "Wedding, Saturday 120 guests".
    """
    words = first.scanned.words
    named = [word.text for word in words[: time.first] if word.is_letters]
    behind = words[time.end :]
    counted = words[time.first - 1].text in APART and bool(behind) and behind[0].is_digits
    if not named or (any(word.is_letters for word in behind) and not counted):
        return False
    return counted or _is_name(named, first.lexicon)


def _is_name(named: Sequence[str], lexicon: Lexicon) -> bool:
    """Whether words are neither something that one attends, or does with somebody, nor an order."""
    events = lexicon.taken | lexicon.happening | lexicon.function_words
    done = lexicon.alone | lexicon.chores | lexicon.addressing | lexicon.ordering
    if not lexicon.no_times.together.isdisjoint(named):
        # "Dinner with Ann on friday"
        return False
    return named[-1] not in events - lexicon.frames and named[0] not in done


def _only_names(first: Draft) -> bool:
    """Whether a line names something, and no verb is understood but in a name: "School run", "Sports day"."""
    said = [word.text for word in first.scanned.words if word.is_letters]
    if not FEWEST_NAMING <= len(said) <= LONGEST or not first.lexicon.function_words.isdisjoint(said):
        return False
    if len(first.parts) != 1 or not first.parts[0].tree.nodes:
        return False
    (part,) = first.parts
    sketch, tree = sketch_of(first, part), part.tree
    deed = tree.root == len(tree.nodes) - 1 and names_deed(tree, 0, tree.root)
    named = sketch.operation is None or not tree.nodes[tree.root].may_act
    return named or deed or _is_unit(said[-1], first.lexicon)


def _is_numbered(first: Draft) -> bool:
    """Whether it begins with the number of a day, or week, of something: "Day 4 - harbour", "Day 9 of 22"."""
    unit, number, behind = ([word.text for word in first.scanned.words] + [""] * 3)[:3]
    return _is_unit(unit, first.lexicon) and number.isdecimal() and behind in {*APART, "of", ""}


def _numbers_day(first: Draft, time: Phrase) -> bool:
    """Whether it numbers the days, or weeks, of something: "Tomorrow: shoot day 4"."""
    words = first.scanned.words
    beside = [word for place, word in enumerate(words) if not time.first <= place < time.end]
    return any(second.is_digits and _is_unit(one.text, first.lexicon) for one, second in pairwise(beside))


def _is_unit(word: str, lexicon: Lexicon) -> bool:
    return any(entry.category == "unit" for entry in lexicon.entries.get(word, ()))


def name_of(draft: Draft) -> str:
    """Give the words of a heading, without its marks."""
    return draft.text.strip(" :.-*#_")


def held(draft: Draft, phrases: Sequence[Phrase]) -> tuple[Phrase, ...]:
    """Give times as they hold for other lines, in which they have no place."""
    return tuple(
        replace(phrase, first=0, end=0, span=(0, 0), rule=HEADED, above=draft.text[slice(*phrase.span)])
        for phrase in phrases
    )


def names_day(phrase: Phrase) -> bool:
    """Whether it says on which day."""
    time = phrase.said.time
    return wall_of(time.first if isinstance(time, Range) else time).days is not None


def is_of_calendar(phrase: Phrase) -> bool:
    """Whether a time alone is a day or a part of one."""
    time = phrase.said.time
    if not isinstance(time, Wall) or time.clock is not None or phrase.said.constraint is not None:
        return False
    if time.days is not None:
        return not time.weak
    return time.part is not None
