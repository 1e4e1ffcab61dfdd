"""Times and clauses that "or" joins to others of one thing: "at nine, or at ten if the baby is asleep"."""

from collections.abc import Collection
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.instruction import Remark, RemarkKind, Span
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.sentence.clauses.conditions import IF
from fuzzytime.language.sentence.sketches.alternatives import not_used
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import Constraint


def first_offered(sketch: Sketch, text: str) -> tuple[Sketch, list[Remark]]:
    """Leave out clauses, and times behind one, that "or" joins to what is said before, and say so.

    "For ten minutes or until tender" says both: it is about as long as that. Of two times of which one has a
    condition, either may be taken: "on Saturday or, if it rains, on Sunday".
    """
    lasting = {p.span for p in sketch.phrases if p.said.constraint is Constraint.FOR}
    clauses = {clause.span for clause in sketch.clauses}
    moments = {p.span for p in sketch.phrases if p.said.constraint in {None, Constraint.AT}}
    left = [
        second
        for first, second in pairwise(sorted(sketch.heard))
        if _is_or(sketch, first, second, text)
        and ((first in lasting and second in moments) or _is_other(first, second, lasting, clauses))
    ]
    chosen = _with_condition(sketch, left, text)
    phrases = [place for place, phrase in enumerate(sketch.phrases) if phrase.span not in left]
    kept = replace(
        sketch,
        phrases=tuple(_offered(sketch.phrases[place], chosen) for place in phrases),
        references=tuple(sketch.references[place] for place in phrases),
        clauses=tuple(c for c in sketch.clauses if c.span not in left and c.span not in chosen),
    )
    return kept, [
        *(not_used(text, span) for span in left if span not in chosen),
        *(_either(text, span) for span in chosen),
    ]


def _with_condition(sketch: Sketch, left: Collection[Span], text: str) -> dict[Span, Span]:
    """Give the conditions of the second of two times, with that time."""
    conditions = {clause.span for clause in sketch.clauses if clause.kind == IF}
    times = {phrase.span for phrase in sketch.phrases}
    heard = sorted(sketch.heard)
    found: dict[Span, Span] = {}
    for place, (first, second) in enumerate(pairwise(heard)):
        if text[first[1] : second[0]].strip(" ,"):
            continue
        if first in conditions and first in left and second in times:
            found[first] = second
        elif (
            second in conditions
            and first in times
            and place
            and _is_or(sketch, heard[place - 1], first, text)
        ):
            found[second] = first
    return found


def _is_or(sketch: Sketch, first: Span, second: Span, text: str) -> bool:
    """Whether "or" alone stands between two times."""
    between = text[first[1] : second[0]].strip(" ,").lower()
    return between in sketch.part.tree.lexicon.closed.alternatives


def _offered(phrase: Phrase, chosen: dict[Span, Span]) -> Phrase:
    """Give a time that may be taken instead of the one before it as such."""
    if phrase.span not in chosen.values():
        return phrase
    return replace(phrase, said=replace(phrase.said, alternative=True))


def _either(text: str, span: Span) -> Remark:
    """Say that the condition of the second of two times is left out."""
    message = f"{text[slice(*span)]!r} is not used: either of the times joined by 'or' is taken"
    return Remark(RemarkKind.POLICY, span, message)


def _is_other(first: Span, second: Span, lasting: Collection[Span], clauses: Collection[Span]) -> bool:
    """Whether a time or a clause stands for another: no length does that a clause ends."""
    return first not in lasting and (first in clauses or second in clauses)
