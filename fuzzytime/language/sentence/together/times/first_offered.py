"""Times and clauses that "or" joins to others of one thing: "at nine, or at ten if the baby is asleep"."""

from collections.abc import Collection, Sequence
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.instruction import Remark, Span
from fuzzytime.language.meaning.expressions import Duration, Phrase, Wall
from fuzzytime.language.sentence.sketches.meaning.alternatives import not_used
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import MOMENTS, Constraint

STATES = frozenset({"when", "if"})
"""Kinds of clauses that say what must be so when something begins."""


def first_offered(sketch: Sketch, text: str) -> tuple[Sketch, list[Remark]]:
    """Leave out clauses, and times behind one, that "or" joins to what is said before, and say so.

    "For ten minutes or until tender", or the other way round, says both: it is about as long as that. Of
    two times of which one has a condition, either may be taken: "on Saturday or, if it rains, on Sunday".
    """
    sketch = _elapsed_or_so(sketch, text)
    lasting = {p.span for p in sketch.phrases if p.said.constraint is Constraint.FOR}
    clauses = {clause.span for clause in sketch.clauses}
    moments = {p.span for p in sketch.phrases if p.said.constraint in MOMENTS | {Constraint.AFTER}}
    ends = {clause.span for clause in sketch.clauses if clause.kind == "until"}
    left = [
        second
        for first, second in pairwise(sorted(sketch.heard))
        if _is_or(sketch, first, second, text)
        and not (first in ends and second in lasting)
        and ((first in lasting and second in moments) or _is_other(first, second, lasting, clauses))
    ]
    sketch, left, latest = _until_the_latest(sketch, left, text)
    chosen = _with_condition(sketch, left, text)
    left = [span for span in left if span not in _latest_of_states(sketch, left)]
    either = _times_or_states(sketch, [span for span in left if span not in chosen], moments)
    left = [span for span in left if span not in either]
    whole = sketch.keeping(lambda phrase: phrase.span not in left)
    kept = replace(
        whole,
        phrases=tuple(_offered(phrase, {*chosen.values(), *either}) for phrase in whole.phrases),
        clauses=tuple(
            replace(clause, alternative=clause.span in either)
            for clause in sketch.clauses
            if clause.span not in left and clause.span not in chosen
        ),
    )
    return kept, [
        *(not_used(text, span) for span in left if span not in chosen),
        *(_either(text, span) for span in chosen),
        *latest,
    ]


def _with_condition(sketch: Sketch, left: Collection[Span], text: str) -> dict[Span, Span]:
    """Give the conditions of the second of two times, with that time."""
    conditions = {clause.span for clause in sketch.clauses if clause.kind == "if"}
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
    return between in sketch.lexicon.closed.alternatives


def _until_the_latest(
    sketch: Sketch, left: Sequence[Span], text: str
) -> tuple[Sketch, list[Span], list[Remark]]:
    """Let the clock time bound what goes on until it or an event: "until the bell or three o'clock".

    Whichever is first ends it, and when the event is may not be known.
    """
    events = {clause.span for clause in sketch.clauses if clause.is_event and clause.kind == "until"}
    phrases = {phrase.span: phrase for phrase in sketch.phrases}
    heard = pairwise(sorted(sketch.heard))
    found = {b: a for a, b in heard if a in events and b in left and isinstance(phrases[b].said.time, Wall)}
    bounded = {span: _until(phrases[span]) for span in found}
    remarks = [
        Remark.noted(text, event, f"is not used: it is over by {text[slice(*span)]!r}, if not before")
        for span, event in found.items()
    ]
    told = replace(
        sketch,
        phrases=tuple(bounded.get(phrase.span, phrase) for phrase in sketch.phrases),
        clauses=tuple(clause for clause in sketch.clauses if clause.span not in found.values()),
    )
    return told, [span for span in left if span not in found], remarks


def _until(phrase: Phrase) -> Phrase:
    """Give a time as what something goes on until."""
    return replace(phrase, said=replace(phrase.said, constraint=Constraint.BEFORE, preposition="until"))


def _states(sketch: Sketch) -> set[Span]:
    """Give the clauses that say what must be so."""
    return {
        clause.span for clause in sketch.clauses if clause.condition is not None and clause.kind in STATES
    }


def _elapsed_or_so(sketch: Sketch, text: str) -> Sketch:
    """Let a time that may be taken for a state, or a state for it, be when it has passed.

    "Stop it when it is full or after an hour" is in an hour, and not whenever later.
    """
    states, heard = _states(sketch), list(pairwise(sorted(sketch.heard)))
    if not states:
        return sketch
    beside = {pair for pair in heard if states & {*pair} and _is_or(sketch, *pair, text)}
    spans = {span for pair in beside for span in pair}
    over = {
        phrase.span
        for phrase in sketch.phrases
        if phrase.span in spans
        and phrase.said.constraint is Constraint.AFTER
        and isinstance(phrase.said.time, Duration)
    }
    return replace(sketch, phrases=tuple(_passed(p) if p.span in over else p for p in sketch.phrases))


def _passed(phrase: Phrase) -> Phrase:
    return replace(phrase, said=replace(phrase.said, constraint=Constraint.AT, preposition="in"))


def _latest_of_states(sketch: Sketch, left: Collection[Span]) -> set[Span]:
    """Give deadlines behind what must be so, which hold beside it: "when it is golden or by noon"."""
    due = {phrase.span for phrase in sketch.phrases if phrase.said.constraint is Constraint.BEFORE}
    states, pairs = _states(sketch), pairwise(sorted(sketch.heard))
    return {second for first, second in pairs if second in left and first in states and second in due}


def _times_or_states(sketch: Sketch, left: Collection[Span], moments: set[Span]) -> set[Span]:
    """Give times, and what must be so, that may be taken one for the other: "at six or when it is full"."""
    states = _states(sketch)
    pairs = ((first, second) for first, second in pairwise(sorted(sketch.heard)) if second in left)
    return {second for first, second in pairs if {first, second} & moments and {first, second} & states}


def _offered(phrase: Phrase, chosen: Collection[Span]) -> Phrase:
    """Give a time that may be taken instead of the one before it as such."""
    if phrase.span not in chosen:
        return phrase
    return replace(phrase, said=replace(phrase.said, alternative=True))


def _either(text: str, span: Span) -> Remark:
    """Say that the condition of the second of two times is left out."""
    return Remark.noted(text, span, "is not used: either of the times joined by 'or' is taken")


def _is_other(first: Span, second: Span, lasting: Collection[Span], clauses: Collection[Span]) -> bool:
    """Whether a time or a clause stands for another: no length does that a clause ends."""
    return first not in lasting and (first in clauses or second in clauses)
