"""The hours at which people do what is asked for: dinner is in the evening, who wakes does in the morning."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from datetime import time

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word, words_of
from fuzzytime.language.instruction import Operation
from fuzzytime.language.meaning.expressions import Offset, Range, Wall
from fuzzytime.language.meaning.grounded.moment import Moment
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS, Clock
from fuzzytime.language.sentence.segments.told.asides_of_hours import HOURS
from fuzzytime.language.sentence.sketches.its_times.said_of_time import DATED
from fuzzytime.language.sentence.sketches.sketch import Sketch

BEFORE_NAMES = frozenset({";", "it"})
"""What stands in front of a name among the words that tell the hours."""

CLAUSE = re.compile("[,;:.(–]|-(?= )")
"""What ends before a clause that says when somewhere opens."""


def at_usual_hours(moment: Moment, sketch: Sketch, text: str) -> Moment:
    """Give the moment for one instruction, with the policy of the hours that its words are usual at."""
    named = [sketch.operation.name] if sketch.operation is not None else []
    # "Let me sleep until ten", "don't sleep past nine"
    leading = [text[slice(*phrase.span)].partition(" ")[0] for phrase in sketch.phrases]
    leading += [phrase.said.preposition or "" for phrase in sketch.phrases]
    denied = [f"{name} not" for name in _denied(sketch, text)]
    named = [*(f"{name} {word}" for name in (*named, *denied) for word in dict.fromkeys(leading)), *named]
    dated = [text[slice(*phrase.span)] for phrase in sketch.phrases if phrase.rule == DATED]
    hours = [phrase for phrase in sketch.phrases if phrase.rule == HOURS]
    # "(Opens at eight)" does not say what does, nor does "they open at eight".
    dated += [f"it {CLAUSE.split(text[: phrase.span[1]])[-1]}" for phrase in hours]
    named += [f"it {name}" for name in named if sketch.operation and sketch.operation.stated]
    if hours and len(hours) == len(sketch.phrases):
        # They were said of something else, which tells which half of the day is meant.
        moment = replace(moment, since=None)
    words = words_of(" ; ".join((*dated, *named)))
    things = [place for place in range(len(words)) if _is_thing(words, place, sketch.lexicon)]
    if sketch.operation is not None and _is_only_named(sketch.operation):
        # "Evening feed at six", "night bus at eleven"; but "buy night cream"
        parts, front = sketch.lexicon.beside.ending_names, [";", *(word.text for word in words)]
        things = [p for p in things if words[p].text not in parts or front[p] not in BEFORE_NAMES]
    places = (place for place in range(len(words)) if place not in things)
    found = (longest_match(words, place, sketch.lexicon.usual_hours) for place in places)
    usual = sketch.lexicon.usual_hours
    # "Sleep until" says more than "sleep", and in "crew breakfast" the meal does.
    said = [(len(form), usual[form][1] is not None, usual[form]) for form in found if form is not None]
    if not said:
        return moment
    *_, (first, last) = max(said, key=lambda one: one[:2])
    if last is not None and not all(_is_in(clock, first, last) for clock in _clocks_of(sketch)):
        # "Wake grandma from her nap at three": not at its usual hours.
        return moment
    policy = replace(moment.policy, ahead_from=first)
    if last is not None:
        policy = replace(policy, plausible_from=first, plausible_to=last, workday_from=first)
    return replace(moment, policy=policy, usual=last is not None, early=last is None)


def _denied(sketch: Sketch, text: str) -> list[str]:
    """Give what is not to be then: "no music after ten", "don't play music after ten"."""
    if sketch.operation is not None:
        return [sketch.operation.name] if sketch.operation.negated else []
    start = min((phrase.span[0] for phrase in sketch.phrases), default=0)
    before = text[sketch.part.segment.span[0] : start].lower()
    return [before] if before.split()[:1] == ["no"] else []


def _is_only_named(operation: Operation) -> bool:
    """Whether words name what is then, or happens, and no verb says what is done with a thing."""
    return operation.stated or operation.verb == operation.name


def _clocks_of(sketch: Sketch) -> Iterator[Clock]:
    """Give the clock times of an instruction, also those that others are counted from."""
    for phrase in sketch.phrases:
        said = phrase.said.time
        ends = (said.first, said.last) if isinstance(said, Range) else (said,)
        walls = (end.anchor if isinstance(end, Offset) else end for end in ends)
        yield from (wall.clock for wall in walls if isinstance(wall, Wall) and wall.clock is not None)


def _is_in(clock: Clock, first: time, last: time) -> bool:
    """Whether a clock time may be in some hours, or where they are over."""
    begins = first.hour * 3600 + first.minute * 60
    length = (last.hour * 3600 + last.minute * 60 - begins) % DAY_SECONDS
    return any((seconds - begins) % DAY_SECONDS <= length for seconds in clock.candidates())


def _is_thing(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a word names a thing, and nothing of the day: "bed 5", "make the bed"."""
    behind = words[place + 1 : place + 2]
    named = words[place].text in lexicon.beside.ending_names
    if named and behind and behind[0].is_letters and behind[0].text not in lexicon.function_words:
        # "Buy night cream", but "add a movie night"
        return True
    if behind and (behind[0].is_digits or behind[0].text in lexicon.numbers):
        return True
    led = place > 0 and words[place - 1].text in lexicon.closed.noun_openers
    return led and any(p.category == "meal" and p.value.place for p in lexicon.pieces(words, place))
