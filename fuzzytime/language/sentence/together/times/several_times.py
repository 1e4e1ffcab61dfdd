"""Several times of one thing: all are meant ("at seven and at eight"), or one ("at seven or at eight")."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.understood.filled import filled
from fuzzytime.language.grammar.understood.lists import lists_of
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Offset, Phrase, Said
from fuzzytime.language.meaning.joined.distances import EARLIER, INTO, LATER
from fuzzytime.language.sentence.sketches.around_events.at_events import events_in
from fuzzytime.language.sentence.sketches.sketch import Sketch

COUNTED = {EARLIER: "before", LATER: "after", INTO: "after"}
"""The prepositions of distances that stand alone, and the clauses that they may be part of."""


def of_several_times(sketch: Sketch, words: Sequence[Word]) -> list[Sketch]:
    """Give one sketch for each time that is meant, or one of which each time is an alternative.

    "At seven and at six" asks for two, "at seven or at eight" for one; "tomorrow, by noon" is one time.
    """
    times = next(lists_of(sketch.phrases, words, sketch.lexicon), None)
    if times is None:
        return [sketch]
    rest = [phrase for phrase in sketch.phrases if phrase not in times.members]
    members = filled(times, words)
    listed = times.members[0].span[0], times.members[-1].span[1]
    sketch = replace(sketch, joints=(*sketch.joints, listed))
    groups = [members] if times.either else [[one] for one in members]
    return [_with(sketch, [*rest, *group]) for group in groups]


def _with(sketch: Sketch, phrases: Sequence[Phrase]) -> Sketch:
    """Give a sketch with some of its times, which may have got a day or a clock time, in their order."""
    references = {
        phrase.span: reference for phrase, reference in zip(sketch.phrases, sketch.references, strict=True)
    }
    times = tuple(sorted(phrases, key=lambda phrase: phrase.span))
    return replace(sketch, phrases=times, references=tuple(references[time.span] for time in times))


def of_one_event(sketches: Sequence[Sketch]) -> list[Sketch]:
    """Let the distances of a list count from what is named behind its last.

    "Remind me a week before, a day before and an hour before the exam".
    """
    found: list[Sketch] = []
    apart = [one for sketch in sketches for one in _distance_by_distance(sketch)]
    for one in reversed(apart):
        found.append(_counted_alike(one, found[-1]) if found else one)
    return found[::-1]


def _distance_by_distance(sketch: Sketch) -> list[Sketch]:
    """Give one sketch for each distance that stands alone, and the last for that which names the event."""
    last = next((clause.span for clause in sketch.clauses if clause.distance is not None), None)
    alone = [one for one in sketch.phrases if one.said.preposition in COUNTED and last and one.span < last]
    joints = (*sketch.joints, *((one.span[1], last[0]) for one in alone if last))
    sketch = replace(sketch, joints=joints)
    others = [one for one in sketch.phrases if one not in alone]
    firsts = [replace(_with(sketch, [*others, one]), clauses=()) for one in alone]
    return [*firsts, _with(sketch, others)]


def _counted_alike(sketch: Sketch, later: Sketch) -> Sketch:
    """Give the distance of a sketch what one behind it of the same to be done counts from."""
    apart = [one for one in sketch.phrases if one.said.preposition in COUNTED]
    (phrase,) = apart if len(apart) == 1 else (None,)
    time, kind = (None, "") if phrase is None else (phrase.said.time, COUNTED[phrase.said.preposition or ""])
    same = sketch.operation is not None and sketch.operation == later.operation and not sketch.clauses
    if phrase is None or not isinstance(time, Offset) or time.anchor is not None or not same:
        return sketch
    for clause in later.clauses:
        if clause.distance is not None and clause.kind == kind:
            told = replace(clause, span=phrase.span, distance=time.duration)
            return replace(sketch.keeping(lambda one: one is not phrase), clauses=(told,))
    for other in (one.said.time for one in later.phrases):
        if isinstance(other, Offset) and other.anchor is not None and other.direction == time.direction:
            return sketch.telling([phrase], Said(replace(other, duration=time.duration), None))
    return sketch


def also_at_events(sketch: Sketch, words: Sequence[Word]) -> list[Sketch]:
    """Give one sketch for the time, and one for what hardly is a place and is joined to that by "and"."""
    if not sketch.asks or not sketch.phrases:
        return [sketch]
    ends = {phrase.end for phrase in sketch.phrases}
    for span, is_moment in events_in(sketch, words):
        at = next(place for place, word in enumerate(words) if word.start == span[0])
        joint = at - 1
        if is_moment and joint in ends and words[joint].text in sketch.lexicon.closed.additions:
            heard = (*sketch.joints, (words[joint].start, span[1]))
            return [replace(sketch, joints=heard), replace(sketch, phrases=(), references=(), joints=heard)]
    return [sketch]
