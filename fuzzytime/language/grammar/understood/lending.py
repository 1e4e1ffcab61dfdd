"""What the times of a text lend each other: a unit to a number, a half of the day to a clock time."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.english import is_participle
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.surroundings.compared import NEAR
from fuzzytime.language.grammar.understood.lent import is_heated, is_left_for, lasts_minutes
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.days.relations import Relative, days_away
from fuzzytime.language.meaning.expressions import Duration, Offset, Phrase, Range, Repeat, Said, Wall
from fuzzytime.language.meaning.joined.beside import lasts_then
from fuzzytime.language.meaning.times_of_day import DAY_HOURS, Clock, Half
from fuzzytime.requirement import Constraint, Unit

LENT = frozenset({Constraint.AFTER, Constraint.FOR})
"""How numbers bind that are no hours, and take a unit said before."""

STOPS = frozenset({".", ";", "!", "?"})
"""Marks behind which a number counts minutes again."""

FROM_NOW = frozenset({"in", "after"})
"""The prepositions of a length that begins now."""

NOON = 12 * 3600


def in_unit(phrase: Phrase, before: Phrase, words: Sequence[Word], lexicon: Lexicon) -> Phrase:
    """Lend a number the unit of the length of time before it: "for two minutes, … and for one".

    Behind "after" a number is an hour, unless it is said what goes on meanwhile: "rotating it after 20".
    """
    said, length = phrase.said, before.said
    again = length.time.every if isinstance(length.time, Repeat) else None
    if again is not None and isinstance(said.time, Repeat) and said.time.every and said.time.every.bare_end:
        # "Every two hours, then every four"
        counted = _counted(said.time.every, again.terms[-1][1])
        return phrase.at(replace(said.time, every=counted))
    if not isinstance(length.time, Duration):
        return phrase
    unit = length.time.terms[-1][1]
    if {said.preposition, length.preposition} <= FROM_NOW and isinstance(said.time, Duration):
        # "Feed the cat in an hour and the dog in two", "flip it after a minute, then after another two"
        near = not _ends_between(before, phrase, words)
        alone = said.time.bare_end and said.time.until is None and len(said.time.terms) == 1
        hours = near and alone and said.time.terms[0][0] <= DAY_HOURS
        return phrase.at(_counted(said.time, unit) if hours else said.time)
    if said.preposition == length.preposition == "after" and isinstance(said.time, Wall) and said.time.bare:
        return _further_after(phrase, length.time, unit, near=not _ends_between(before, phrase, words))
    if length.constraint is not Constraint.FOR:
        return phrase
    if isinstance(said.time, Duration) and said.time.bare_end and said.constraint in LENT:
        many = said.constraint is Constraint.FOR and said.time.terms[0][0] > DAY_HOURS
        # "Cool it for an hour and chill it for 40" minutes
        unit = Unit.MINUTE if many and unit is Unit.HOUR else unit
        return phrase.at(replace(_counted(said.time, unit), unsaid=length.time.unsaid))
    if isinstance(said.time, Repeat) and said.time.every is not None and said.time.every.bare_end:
        return phrase.at(Repeat(_counted(said.time.every, unit)))
    number = said.wall.bare and said.preposition in {"for", "after"}
    return _hour_in_unit(phrase, words[before.end : phrase.first], unit, lexicon) if number else phrase


def _hour_in_unit(phrase: Phrase, between: Sequence[Word], unit: Unit, lexicon: Lexicon) -> Phrase:
    """Lend a number that would be an hour the unit of the length before it, where it is so long."""
    said, clock = phrase.said, phrase.said.wall.clock
    meanwhile = any(is_participle(word.text) for word in between)
    if clock is None or clock.grain is not Unit.HOUR or (said.preposition == "after" and not meanwhile):
        return phrase
    if between and between[-1].text in lexicon.events:
        # "Set a timer for ten minutes and an alarm for seven"
        return phrase
    duration = Duration(((clock.hour, unit),))
    constraint = Constraint.FOR if said.preposition == "for" else said.constraint
    return replace(phrase, said=replace(said, time=duration, constraint=constraint))


def _further_after(phrase: Phrase, length: Duration, unit: Unit, *, near: bool) -> Phrase:
    """Lend a number behind "after" the unit of a smaller one: "after 3 minutes this, after 5 that"."""
    clock = phrase.said.wall.clock
    hour = clock is not None and clock.grain is Unit.HOUR and clock.half is None
    if clock is None or not hour or not near or len(length.terms) > 1 or clock.hour <= length.terms[0][0]:
        return phrase
    return phrase.at(Duration(((clock.hour, unit),)))


def _ends_between(before: Phrase, phrase: Phrase, words: Sequence[Word]) -> bool:
    """Whether a sentence ends between two times."""
    return bool(STOPS & {word.text for word in words[before.end : phrase.first]})


def in_minutes(phrase: Phrase, words: Sequence[Word], lexicon: Lexicon) -> Phrase:
    """Read a number alone as minutes where only a length of time can be meant: "simmer for ten"."""
    said = phrase.said
    clock = said.wall.clock
    hour = clock is not None and clock.grain is Unit.HOUR and clock.half is None
    inside = words[phrase.first : phrase.end]
    number = any(word.is_digits or word.text in lexicon.numbers for word in inside)
    number = number and lexicon.beside.of_clocks.isdisjoint(word.text for word in inside)
    # "Simmer for 20 or so", but "simmer for noon or so"
    hedged = hour and bool(said.hedges) and number
    bare = said.preposition == "for" and isinstance(said.time, Wall) and (said.time.bare or hedged)
    texts = [word.text for word in words[: phrase.first]]
    before, alone = set(texts), lasts_minutes(texts, lexicon) or is_heated(texts, said.time)
    left = is_left_for([word.text for word in words], phrase.first, phrase.end, lexicon)
    if left and said.preposition is None and clock is not None:
        return replace(phrase, said=Said(_in_minutes(clock), Constraint.FOR))
    measured = before & lexicon.timing and not before & lexicon.appointing
    if not bare or clock is None or not (alone or measured):
        return phrase
    return replace(phrase, said=replace(said, time=_in_minutes(clock), constraint=Constraint.FOR))


def _in_minutes(number: Clock) -> Duration:
    """Give so many minutes as a number alone seems an hour."""
    return Duration(((number.hour, Unit.MINUTE),), unsaid=True)


ARROWS = frozenset({">", "→", "⇒"})
"""Marks between an old time and a new one: "move mtg 2 > 3pm"."""


def is_moved(words: Sequence[Word], start: int, end: int, lexicon: Lexicon) -> bool:
    """Whether an arrow stands between the old and the new hour of what is moved: "move mtg 2 > 3"."""
    arrow = any(word.text in ARROWS for word in words[start:end])
    named = start > 1 and words[start - 1].is_letters and not words[start - 1].text.endswith("s")
    return arrow and named and words[start - 2].text in lexicon.moving


def moved_to(phrase: Phrase, words: Sequence[Word], lexicon: Lexicon) -> Phrase:
    """Read the second of two times as that of what is given another: "move the meeting from two to three"."""
    said, before = phrase.said, [word.text for word in words[max(0, phrase.first - NEAR) : phrase.first]]
    if _is_length_changed(before, lexicon) and isinstance(said.time, Offset):
        return replace(phrase, said=_lengthened(said, said.time))
    arrow = any(word.text in ARROWS for word in words[phrase.first : phrase.end])
    led = words[phrase.first].text == "from" or arrow
    time = _first_and_last(said.time) if isinstance(said.time, Repeat) else said.time
    if not isinstance(time, Range) or not led or not before:
        return phrase
    event = before[-1] in lexicon.events | lexicon.taken
    named = event or (len(before) > 1 and before[-2] in lexicon.closed.possessives)
    # "Move bingo from two to three": what has no article is done, and is no thing.
    named = named or (len(before) > 1 and before[-2] in lexicon.moving and not before[-1].endswith("s"))
    # "Switch my alarm from six to seven", but "switch my lights from six to seven"
    verbs = lexicon.moving | lexicon.switching if event else lexicon.moving
    # "I have the late shift from two to ten": what has the time is no order
    if not named or not verbs & set(before[:-1]):
        return phrase
    first, last = time.first, time.last
    if isinstance(first, Wall) and isinstance(last, Wall) and last.days is None and first.clock is not None:
        # "From nine to ten on friday": the day is said of both
        last = replace(last, days=first.days)
    return replace(phrase, said=Said(last, None, "to"))


def _first_and_last(repeat: Repeat) -> Range | None:
    """Give days in a row at some hour as from one to another: "move the vet from friday to monday at ten"."""
    several = repeat.every is None and repeat.starting is None and len(repeat.walls) > 1
    return Range(repeat.walls[0], repeat.walls[-1]) if several else None


def _is_length_changed(before: Sequence[str], lexicon: Lexicon) -> bool:
    """Whether what goes on for some time is given another: "change the timer from ten minutes to fifteen"."""
    gives = not lexicon.rescheduling.isdisjoint(before)
    return gives and before[-1] in lexicon.lasting


def _lengthened(said: Said, time: Offset) -> Said:
    """Read so long before a number as two lengths, of which the second is meant."""
    clock = time.anchor.clock if isinstance(time.anchor, Wall) else None
    if clock is None or clock.grain is not Unit.HOUR or time.direction > 0 or said.preposition != "from":
        return said
    return lasts_then(_counted(Duration(((clock.hour, Unit.HOUR),)), time.duration.unit))


def appointed(phrase: Phrase, words: Sequence[Word], lexicon: Lexicon) -> Phrase:
    """Read "for two months from today" as that day, behind what is made for a time: "a checkup for …"."""
    said, wall = phrase.said, phrase.said.time
    if said.lasting is None or words[phrase.first].text != "for" or not isinstance(wall, Wall):
        return phrase
    day = isinstance(wall.days, Relative) and wall.clock is None and wall.part is None
    if not day or not lexicon.appointing & {word.text for word in words[: phrase.first]}:
        return phrase
    days = None if said.lasting.hedges or wall.days is None else days_away(said.lasting, wall.days, 1)
    return phrase if days is None else replace(phrase, said=Said(Wall(days), None, "for"))


def one_by_one(phrase: Phrase, words: Sequence[Word], lexicon: Lexicon) -> list[Phrase]:
    """Give each time of a list as a phrase of its own: "in 10, 20 and 30 minutes"."""
    times = (replace(phrase.said, listed=()), *phrase.said.listed)
    joints = lexicon.closed.coordinators | {"/"}
    found = []
    first = phrase.first
    for place, said in enumerate(times):
        while words[first].text in joints:
            first += 1
        rest = range(first, phrase.end)
        last = place == len(times) - 1
        end = phrase.end if last else next(at for at in rest if words[at].text in joints)
        found.append(
            replace(phrase, said=said, first=first, end=end, span=(words[first].start, words[end - 1].end))
        )
        first = end
    return found


def _counted(number: Duration, unit: Unit) -> Duration:
    """Give as many of a unit."""
    return Duration(((number.terms[0][0], unit),))


def in_half(phrase: Phrase, following: Phrase, words: Sequence[Word], lexicon: Lexicon) -> Phrase:
    """Lend a clock time the half of the day of the next in a list: "at 6, 6:10 and 6:20 am".

    Of the same number twice, the first is in the other half: "at 7 and again at 7 pm".
    """
    joints = {word.text for word in words[phrase.end : following.first]} - lexicon.beside.again
    first, second = phrase.said.time, following.said.time
    if (
        not joints
        or joints - lexicon.closed.coordinators
        or not isinstance(first, Wall)
        or not isinstance(second, Wall)
    ):
        return phrase
    if first.clock is None or second.clock is None or first.days is not None or first.part is not None:
        return phrase
    half = second.clock.half
    open_half = first.clock.is_open and first.clock.half is None and half in {Half.AM, Half.PM}
    if half is None or not open_half or first.clock.seconds % NOON > second.clock.seconds % NOON:
        return phrase
    if first.clock.seconds % NOON == second.clock.seconds % NOON:
        half = Half.PM if half is Half.AM else Half.AM
    clock = replace(first.clock, half=half, bare=False)
    return phrase.at(replace(first, clock=clock))
