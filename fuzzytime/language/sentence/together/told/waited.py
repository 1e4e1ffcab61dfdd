"""A length in front of what is to be done "then" is what is waited: "give it a week, then call them"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.instruction import Operation
from fuzzytime.language.meaning.expressions import Duration
from fuzzytime.language.meaning.joined.distances import later_by
from fuzzytime.language.sentence.segments.told.asides import Aside
from fuzzytime.language.sentence.sketches.sketch import Sketch

THEN = "then"


def waited(
    sketches: list[Sketch], asides: Sequence[Aside], given: Sequence[Operation | None]
) -> list[Sketch]:
    """Let the first instruction come as long after the last one ``given`` as its aside in front says.

    Where that one is done for so many minutes ("bake the bread"), the length may be its own: it is left.
    """
    if not sketches or not asides:
        return sketches
    (aside, *_), first = asides, sketches[0]
    segment, length = first.part.segment, aside.length.said.time
    leads = aside.span[1] <= segment.span[0] and segment.connective == THEN and not aside.way
    before = given[-1] if given else None
    cooked = before is not None and before.lemma in first.lexicon.timing | first.lexicon.timing_alone
    if not leads or cooked or not isinstance(length, Duration):
        return sketches
    waits = replace(aside.length, said=later_by(length), span=aside.span)
    segment = replace(segment, span=(aside.span[0], segment.span[1]), connective="")
    return [replace(first.under([waits]), part=replace(first.part, segment=segment)), *sketches[1:]]
