"""What is repeated from a time on that stands elsewhere: "from six, set three alarms ten minutes apart"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Offset, Phrase, Repeat
from fuzzytime.language.meaning.joined.first_times import (
    at_the_beginning,
    beginning,
    closing_of,
    first_time,
    in_the_end,
    is_release,
    opening_of,
)
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import MOMENTS, Constraint


def from_first_time(sketch: Sketch, words: Sequence[Word]) -> Sketch:
    """Begin a repetition by an interval at the time that is said for its first.

    Of what is counted that is any time: "two tablets at eight, six hours apart". What is only done every so
    often begins where a time says from when on, or at a clock time: "at ten for a minute every two hours".
    """
    phrases = list(sketch.phrases)
    repeated = [place for place, phrase in enumerate(phrases) if isinstance(phrase.said.time, Repeat)]
    if len(repeated) != 1:
        return sketch
    repeat = phrases[repeated[0]].said.time
    if not isinstance(repeat, Repeat) or repeat.walls or repeat.every is None:
        return sketch
    if repeat.starting not in {None, Offset(repeat.every, 1)}:
        return sketch
    every, within = phrases[repeated[0]], _in_part(sketch, repeat, repeated[0])
    if within is not None:
        return within
    counted, closed = repeat.times is not None, sketch.lexicon.closed
    clocks = [p for p in phrases if p.said.constraint in MOMENTS and p.said.wall.clock is not None]
    said = [
        place
        for place, phrase in enumerate(phrases)
        if first_time(phrase.said) is not None
        and (counted or is_release(phrase.said) or phrase in clocks)
        # "At ten and every two hours"; but "every two hours and at ten"
        and not _between(phrase, every, words)
        & (closed.alternatives if counted or phrase.first < every.first else closed.coordinators)
    ]
    moments = [place for place in said if not phrases[place].said.is_day] or said
    first = first_time(phrases[moments[0]].said) if len(moments) == 1 else None
    if first is None:
        return sketch
    again = beginning(repeat, first)
    places = (*repeated, *moments)
    hedges = tuple(dict.fromkeys(hedge for place in places for hedge in phrases[place].said.hedges))
    for place in (*repeated, *said):
        phrase = phrases[place]
        told = replace(phrase.said, time=again, constraint=Constraint.EVERY, hedges=hedges, beside=False)
        phrases[place] = replace(phrase, said=told)
    return replace(sketch, phrases=tuple(phrases))


def _in_part(sketch: Sketch, repeat: Repeat, place: int) -> Sketch | None:
    """Let a repetition be in the beginning or the end of what goes on: "in the last hour, baste it …"."""
    for part_of, within in ((closing_of, in_the_end), (opening_of, at_the_beginning)):
        parts = [(other, length) for other, p in enumerate(sketch.phrases) if (length := part_of(p.said))]
        part = within(repeat, parts[0][1]) if len(parts) == 1 else None
        if part is not None:
            return _repeated(sketch, part, (place, parts[0][0]))
    return None


def _repeated(sketch: Sketch, repeat: Repeat, places: Sequence[int]) -> Sketch:
    """Give a sketch with a repetition for its times at some places, which say it together."""
    phrases = list(sketch.phrases)
    for place in places:
        told = replace(phrases[place].said, time=repeat, constraint=Constraint.EVERY, lasting=None)
        phrases[place] = replace(phrases[place], said=told)
    return replace(sketch, phrases=tuple(phrases))


def _between(one: Phrase, other: Phrase, words: Sequence[Word]) -> set[str]:
    """Give the words between two times, which stand in any order."""
    first, second = sorted((one, other), key=lambda phrase: phrase.first)
    return {word.text for word in words[first.end : second.first]}
