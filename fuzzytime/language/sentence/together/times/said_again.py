"""What is done at several times: "before lunch and again at two", "one at six, the other at ten"."""

from collections.abc import Container, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.grammar.understood.lists import lists_of
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Span
from fuzzytime.language.sentence.segments.events.instances import Instances
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import Constraint

SEVERAL = 2
ONE_OF = "one of the "
"""What is said of one of several: "one of the alarms"."""


def done_again(sketch: Sketch, words: Sequence[Word]) -> list[Sketch]:
    """Give one sketch for each time that "and again" joins to those before it.

    Times that go on for a while are of all of them; what else is said belongs to the time that it stands by.
    """
    cuts = list(_cuts(sketch, words))
    if not cuts or sketch.operation is None:
        return [sketch]
    lasting = {phrase.span[0] for phrase in sketch.phrases if phrase.said.constraint is Constraint.FOR}
    ends = pairwise([0, *(cut[1] for cut in cuts), len(words) and words[-1].end])
    return [replace(_of_stretch(sketch, range(*stretch), lasting), joints=tuple(cuts)) for stretch in ends]


def each_of(sketch: Sketch, instances: Instances) -> list[Sketch]:
    """Give one sketch for each of several of one kind; what is said before the first holds for all."""
    first, end = sketch.part.segment.span
    starts = [start for start in instances.starts if first <= start < end]
    operation = sketch.operation
    if len(starts) < SEVERAL or operation is None:
        return [sketch]
    if instances.counted and operation.object is not None:
        # "Give him two pills" has who gets them in front.
        before, counted, behind = (
            operation.object.removesuffix(" and").rstrip(" ,").partition(instances.counted)
        )
        operation = replace(operation, object=f"{before}{ONE_OF}{counted}{behind}" if counted else before)
    leading = (span[0] for span in sketch.heard if span[0] < starts[0] < span[1])
    starts[0] = next(leading, starts[0])
    named = replace(sketch, operation=operation)
    return [_of_stretch(named, range(*stretch), range(starts[0])) for stretch in pairwise([*starts, end])]


def _of_stretch(sketch: Sketch, stretch: range, shared: Container[int]) -> Sketch:
    """Give a sketch with its times and clauses in a stretch, and those that begin at shared places."""

    def is_its(span: Span) -> bool:
        return span[0] in stretch or span[0] in shared

    clauses = tuple(clause for clause in sketch.clauses if is_its(clause.span))
    return replace(sketch.keeping(lambda phrase: is_its(phrase.span)), clauses=clauses)


def _cuts(sketch: Sketch, words: Sequence[Word]) -> Iterator[Span]:
    """Give the stretches between two times that say that something is done again, but for those of lists.

    What stands beside the times of a list is of all of them, a clause behind the last of that one alone.
    """
    beside = sketch.lexicon.beside
    lists = () if sketch.clauses else lists_of(sketch.phrases, words, sketch.lexicon)
    listed = {member.span[0] for times in lists for member in times.members[1:]}
    for (_, end), (start, _) in pairwise(sorted(sketch.heard)):
        between = {word.text for word in words if end <= word.start < start and start not in listed}
        again = between & beside.twice and between <= beside.beside_twice
        if again and between & sketch.lexicon.closed.joints_of_steps:
            yield end, start
