"""Hours, and minutes, typed as "8h", "1h30", or "1:30 h": how long something takes, or a clock time."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Duration, Phrase, Said, Wall
from fuzzytime.language.meaning.joined.distances import INTO
from fuzzytime.language.meaning.times_of_day import DAY_HOURS, Clock
from fuzzytime.requirement import Constraint, Unit

NOUN = 3
"""Words behind a preposition among which its noun is."""

HALF_DAY = 12
"""Hours that something goes on for at most, where they may be of a clock: "8h"."""

FEW_HOURS = 8
"""Hours below which they are how long, where a day or what goes on stands beside; others are of a clock."""


def lasting_on_day(phrase: Phrase, words: Sequence[Word], lexicon: Lexicon) -> Phrase:
    """Read "1h30" behind "for" as how long, beside a day: "for 1h30 tomorrow".

    But "an alarm for 7h30 tomorrow" is at half past seven, as nothing is when people sleep.
    """
    said, wall = phrase.said, phrase.said.time
    clock = wall.clock if isinstance(wall, Wall) and wall.days is not None else None
    if not isinstance(wall, Wall) or clock is None or clock.half is not None or said.lasting is not None:
        return phrase
    few = lexicon.policy.ahead_from.hour if _is_appointed(phrase, words, lexicon) else FEW_HOURS
    if not _is_typed_length(phrase, words, lexicon) or clock.hour >= few:
        return phrase
    length = Duration(((clock.hour, Unit.HOUR), (clock.minute, Unit.MINUTE)))
    return replace(
        phrase, said=replace(said, time=replace(wall, clock=None), preposition=None, lasting=length)
    )


def going_on(phrase: Phrase, words: Sequence[Word], lexicon: Lexicon) -> Phrase:
    """Read hours with an h as how long something goes on: "soak the beans 12h"; but "dentist 9h".

    With minutes they are so beside a thing at an hour at which nobody is up, as in "bread 2h15".
    """
    said, wall = phrase.said, phrase.said.time
    clock = wall.clock if isinstance(wall, Wall) and said.preposition is None else None
    typed = "h" in {word.text for word in words[phrase.first : phrase.end]}
    if not isinstance(wall, Wall) or clock is None or not typed or clock.hour > HALF_DAY:
        return phrase
    goes_on = lexicon.lasting - lexicon.doing.errands
    goes_on |= lexicon.timing | lexicon.timing_alone | lexicon.doing.resting
    happens = lexicon.happening | lexicon.taken | lexicon.addressing
    lasts = not (goes_on - happens).isdisjoint(word.text for word in words[: phrase.first])
    beside = phrase.end - phrase.first < len(words) and not _is_appointed(phrase, words, lexicon)
    asleep = beside and clock.hour < lexicon.policy.ahead_from.hour
    # "It takes about 7h30"
    takes = phrase.first > 0 and words[phrase.first - 1].text in lexicon.told["taking"]
    if not (asleep or takes or (lasts and clock.hour < FEW_HOURS) if clock.minute else lasts):
        return phrase
    length = Duration(((clock.hour, Unit.HOUR), (clock.minute, Unit.MINUTE)))
    if wall.days is None and wall.part is None:
        return replace(phrase, said=replace(said, time=length, constraint=Constraint.FOR))
    return replace(phrase, said=replace(said, time=replace(wall, clock=None), lasting=length))


def clock_of_alarm(phrase: Phrase, words: Sequence[Word], lexicon: Lexicon) -> Phrase:
    """Read "for 7h30" as a clock time behind what is made for one: "an alarm for 7h30"."""
    said, length = phrase.said, phrase.said.time
    typed = isinstance(length, Duration) and said.preposition == "for" and not said.hedges
    if not typed or not isinstance(length, Duration) or not _is_typed_length(phrase, words, lexicon):
        return phrase
    hours, minutes = divmod(int(length.seconds) // 60, 60)
    awake = lexicon.policy.ahead_from.hour <= hours < DAY_HOURS
    timed = {word.text for word in words[: phrase.first]} & (lexicon.timing | lexicon.timing_alone)
    if not awake or timed or not _is_appointed(phrase, words, lexicon):
        return phrase
    clock = Clock(hours, minutes, 0, Unit.MINUTE, full_day=True)
    return replace(phrase, said=Said(Wall(clock=clock), None, "for"))


def gone_by(phrase: Phrase, words: Sequence[Word], lexicon: Lexicon) -> Phrase:
    """Read "0:30" before "into" as hours and minutes that have gone by: "at 0:30 into the run"."""
    said, behind = phrase.said, words[phrase.end : phrase.end + 1]
    clock = said.time.clock if isinstance(said.time, Wall) and said.time.days is None else None
    if clock is None or clock.half is not None or clock.shift or not behind or behind[0].text != INTO:
        return phrase
    goes_on = lexicon.lasting | lexicon.happening | lexicon.taken | lexicon.frames
    inside = {word.text for word in words[phrase.end + 1 : phrase.end + 1 + NOUN]}
    if ":" not in {word.text for word in words[phrase.first : phrase.end]} or goes_on.isdisjoint(inside):
        # As in "put it at 6:30 into the oven".
        return phrase
    length = Duration(((clock.hour, Unit.HOUR), (clock.minute, Unit.MINUTE), (clock.second, Unit.SECOND)))
    return replace(phrase, said=Said(length, Constraint.FOR))


def _is_appointed(phrase: Phrase, words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether what is made for a time stands before one."""
    return not lexicon.appointing.isdisjoint({word.text for word in words[: phrase.first]})


def _is_typed_length(phrase: Phrase, words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether "for" stands in a time before hours and minutes typed as lengths are: "1h30", "1:30 h"."""
    texts = [word.text for word in words[: phrase.end]]
    for at in range(phrase.first, phrase.end - 2):
        if texts[at] != "for" or not words[at + 1].is_digits:
            continue
        unit = at + (4 if texts[at + 2] == ":" else 2)
        if unit < phrase.end and lexicon.means(texts[unit], "unit"):
            return texts[at + 2] in {":", "h"}
    return False
