"""What is repeated from a time on that stands elsewhere: "from six, set three alarms ten minutes apart"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Phrase, Repeat
from fuzzytime.language.meaning.first_times import beginning, closing_of, first_time, in_the_end, is_release
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import Constraint


def from_first_time(sketch: Sketch, words: Sequence[Word]) -> Sketch:
    """Begin a repetition by an interval at the time that is said for its first.

    Of what is counted that is any time: "two tablets at eight, six hours apart". What is only done every so
    often begins where a time says from when on.
    """
    phrases = list(sketch.phrases)
    repeated = [place for place, phrase in enumerate(phrases) if isinstance(phrase.said.time, Repeat)]
    if len(repeated) != 1:
        return sketch
    repeat = phrases[repeated[0]].said.time
    if not isinstance(repeat, Repeat) or repeat.walls or repeat.every is None or repeat.starting is not None:
        return sketch
    every = phrases[repeated[0]]
    in_its_end = _in_the_end(phrases, repeated[0], repeat)
    if in_its_end is not None:
        return replace(sketch, phrases=tuple(in_its_end))
    counted = repeat.times is not None
    lexicon = sketch.part.tree.lexicon
    said = [
        place
        for place, phrase in enumerate(phrases)
        if first_time(phrase.said) is not None
        and (counted or is_release(phrase.said))
        and not _between(phrase, every, words) & lexicon.closed.alternatives
    ]
    moments = [place for place in said if not phrases[place].said.is_day] or said
    first = first_time(phrases[moments[0]].said) if len(moments) == 1 else None
    if first is None:
        return sketch
    again = beginning(repeat, first)
    hedges = tuple(
        dict.fromkeys(hedge for place in (*repeated, *moments) for hedge in phrases[place].said.hedges)
    )
    for place in (*repeated, *said):
        told = replace(
            phrases[place].said, time=again, constraint=Constraint.EVERY, hedges=hedges, beside=False
        )
        phrases[place] = replace(phrases[place], said=told)
    return replace(sketch, phrases=tuple(phrases))


def _in_the_end(phrases: Sequence[Phrase], place: int, repeat: Repeat) -> list[Phrase] | None:
    """Put a repetition in the end of something: "in the last hour, baste it every 20 minutes"."""
    closings = [(other, length) for other, p in enumerate(phrases) if (length := closing_of(p.said))]
    again = in_the_end(repeat, closings[0][1]) if len(closings) == 1 else None
    if again is None:
        return None
    found = list(phrases)
    for other in (place, closings[0][0]):
        told = replace(found[other].said, time=again, constraint=Constraint.EVERY, lasting=None)
        found[other] = replace(found[other], said=told)
    return found


def _between(one: Phrase, other: Phrase, words: Sequence[Word]) -> set[str]:
    """Give the words between two times, which stand in any order."""
    first, second = sorted((one, other), key=lambda phrase: phrase.first)
    return {word.text for word in words[first.end : second.first]}
