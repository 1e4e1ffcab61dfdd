"""What is done on both sides of something: "flush the line before and after each infusion"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Span
from fuzzytime.language.meaning.expressions import Edge, Phrase
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import Constraint


def on_both_sides(sketch: Sketch, words: Sequence[Word]) -> list[Sketch]:
    """Give one sketch for either side of what an instruction is to be done before and after."""
    span = _both(sketch, words)
    if span is None or sketch.operation is None:
        return [sketch]
    joint, behind = span
    phrases = tuple(_before(p, joint) if p.span[0] == behind else p for p in sketch.phrases)
    clauses = tuple(_clause_before(c, joint) if c.span[0] == behind else c for c in sketch.clauses)
    first = replace(sketch, phrases=phrases, clauses=clauses, joints=(*sketch.joints, joint))
    return [first, replace(sketch, joints=(*sketch.joints, joint))]


def _both(sketch: Sketch, words: Sequence[Word]) -> tuple[Span, int] | None:
    """Give the stretch of "before and", and where the time or clause behind begins; None for none."""
    starts = {span[0] for span in sketch.heard}
    for one, other, third in zip(words, words[1:], words[2:], strict=False):
        if [one.text, other.text, third.text] == ["before", "and", "after"] and third.start in starts:
            return (one.start, other.end), third.start
    return None


def _before(phrase: Phrase, joint: Span) -> Phrase:
    said = replace(phrase.said, constraint=Constraint.BEFORE, preposition="before", edge=Edge.START)
    return replace(phrase, said=said, span=(joint[0], phrase.span[1]))


def _clause_before(clause: Clause, joint: Span) -> Clause:
    return replace(clause, kind="before", marker="before", span=(joint[0], clause.span[1]))
