"""What is denied on both sides is between them: "don't ring before eight or after ten"."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Edge, Phrase, Range, Wall, wall_of
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import BOUNDS, Constraint

BOTH_SIDES = "both_sides"
"""The rule of a stretch outside which a verb is denied."""

FROM = "not before"
"""The preposition of a time whose other side is denied."""


def between_sides(sketch: Sketch, words: Sequence[Word]) -> Sketch:
    """Give a sketch whose two bounds are one stretch, where what lies outside is denied.

    "Don't ring before eight or after ten", "ring on friday, not before nine or after noon". What is never to
    be stays denied, and so does what nobody asks for.
    """
    operation, lexicon = sketch.operation, sketch.lexicon
    denied = operation is not None and operation.negated
    unwanted = denied and operation is not None and operation.lemma in lexicon.doing.unwanted
    for place, (first, second) in enumerate(pairwise(sketch.phrases)):
        between = {word.text for word in words[first.end : second.first]}
        if not between or between - lexicon.closed.denied_alternatives - lexicon.closed.additions:
            continue
        stretch = _of_verb(first, second) if denied else _of_bounds(first, second, between, lexicon)
        if stretch is None or unwanted or (denied and _is_for_good(sketch, words)):
            continue
        said = replace(
            first.said, time=stretch, constraint=Constraint.BETWEEN, preposition="between", edge=Edge.START
        )
        rule = BOTH_SIDES if denied else first.rule
        whole = replace(first, said=said, end=second.end, span=(first.span[0], second.span[1]), rule=rule)
        phrases = (*sketch.phrases[:place], whole, *sketch.phrases[place + 2 :])
        references = (*sketch.references[: place + 1], *sketch.references[place + 2 :])
        asked = replace(operation, negated=False) if operation is not None else None
        return replace(sketch, phrases=phrases, references=references, operation=asked)
    return sketch


def _is_for_good(sketch: Sketch, words: Sequence[Word]) -> bool:
    """Whether it is never to be."""
    first, end = sketch.part.segment.span
    return any(word.text == "never" for word in words if first <= word.start < end)


def _of_verb(first: Phrase, second: Phrase) -> Range | None:
    """Give what lies between the bounds of what is not to be done: "don't … before eight or after ten"."""
    by_side = {one.said.constraint: one.said for one in (first, second)}
    if by_side.keys() != BOUNDS or any(one.denied for one in by_side.values()):
        return None
    begin, end = by_side[Constraint.BEFORE].time, by_side[Constraint.AFTER].time
    return _stretch(wall_of(begin), wall_of(end))


def _of_bounds(first: Phrase, second: Phrase, between: set[str], lexicon: Lexicon) -> Range | None:
    """Give what lies between a time that is denied before it, and one behind: "… nor after noon"."""
    either = not between.isdisjoint(lexicon.closed.denied_alternatives)
    one, other = first.said, second.said
    if not either or other.constraint is not Constraint.AFTER or other.preposition == FROM:
        return None
    if one.constraint is Constraint.AFTER and one.preposition == FROM:
        return _stretch(wall_of(one.time), wall_of(other.time))
    if not isinstance(one.time, Range) or isinstance(one.time.last, Wall) or one.preposition != FROM:
        return None
    # "On saturday but not before seven | or after eleven"
    return _stretch(wall_of(one.time.first), wall_of(other.time))


def _stretch(begin: Wall, end: Wall) -> Range | None:
    """Give what lies between two times of day; the day of the end is that of both."""
    if not begin.is_timed or not end.is_timed:
        return None
    # "Before ten or after six" is not ten to six.
    clock = begin.clock and replace(begin.clock, hours=False)
    return Range(replace(begin, clock=clock, days=begin.days or end.days), end, widest=True)
