"""Times said once for several instructions: "by five, wash the car and mow the lawn", "…, both by five".

What stands in front of an order holds for what is joined to it and has no time of its own: bounds, windows,
repetitions and conditions as they are; of a moment, what follows is not before it, as the first is begun
then. A deadline behind the last holds for all that is joined to it without a time, and so does any time that
says so: "both by five", "each at noon". Days have rules of their own (``days_apart``).
"""

import re
from collections.abc import Collection, Sequence
from dataclasses import replace

from fuzzytime.language.instruction import Remark, Span
from fuzzytime.language.meaning.expressions import (
    Duration,
    Offset,
    Phrase,
    Range,
    Repeat,
    Said,
    TimeWord,
    Wall,
)
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.segments.other_cases import CONDITIONS, OTHER_CASE
from fuzzytime.language.sentence.segments.segment import ENDS, JOINED
from fuzzytime.language.sentence.sketches.around_events.clause_requirements import LASTING
from fuzzytime.language.sentence.sketches.sketch import Sketch, text_between
from fuzzytime.language.sentence.together.told.reasons_told import leads_to_consequence
from fuzzytime.language.sentence.trees.named import names_person
from fuzzytime.requirement import MOMENTS, STRETCHES, Condition, Constraint

HELD = frozenset({"when", "if", "after", "before"})
"""Kinds of clauses that hold for all that is joined."""

STEPS = JOINED | {"first", "then"}
"""Connectives of steps, which a deadline may be for."""

FOR_ALL = re.compile(r",\s*(\w+)(?: of (?:them|these|those))?\s*$")
"""The word before a time for all: ", both at noon", ", all of them by five"."""


def said_for_all(sketches: Sequence[Sketch], text: str) -> list[Sketch]:
    """Give each instruction what is said once for several; what asks for nothing has no operation by now."""
    return _held_behind(_held_in_front(sketches, text), text)


def _held_in_front(sketches: Sequence[Sketch], text: str) -> list[Sketch]:
    """Give the times and clauses in front of an order to what the same sentence joins to it."""
    found: list[Sketch] = []
    phrases: tuple[Phrase, ...] = ()
    clauses: tuple[Clause, ...] = ()
    inserted = False
    for sketch in sketches:
        if not found or _is_ended(found[-1], sketch, text):
            phrases, clauses = (), ()
        segment = sketch.part.segment
        if segment.connective == OTHER_CASE and sketch.operation is not None:
            # "If it rains stay in, otherwise wash the car and mow the lawn"
            phrases, clauses = (), _denied(found, segment.connective_span)
            found.append(sketch.under((), clauses) if clauses else _unbound(sketch, text))
            continue
        if (phrases or clauses) and _is_bare(sketch, JOINED):
            found.append(sketch.under(phrases, clauses))
            continue
        if phrases and _is_bare(sketch, STEPS):
            # "By five, wash the car, then mow the lawn"
            due = tuple(phrase for phrase in phrases if phrase.said.constraint is Constraint.BEFORE)
            found.append(sketch.under(due))
            continue
        # "Buy milk, and if they have eggs buy six, and be back by noon": that is of its own order alone.
        inserted = inserted and "," in (text_between(found[-1], sketch, text) if found else "")
        conditions = () if inserted else tuple(clause for clause in clauses if clause.kind == "if")
        if conditions and sketch.asks and sketch.part.segment.connective in JOINED and _ends_only(sketch):
            # "If it rains, bring in the chairs and call mum at six"
            found.append(sketch.under((), conditions))
            continue
        found.append(sketch)
        if sketch.operation is not None and sketch.asks:
            begin = sketch.operation.span[0]
            phrases = tuple(h for p in sketch.phrases if p.span[1] <= begin for h in _handed_on(p))
            clauses = tuple(c for c in sketch.clauses if c.span[1] <= begin and c.kind in HELD)
            inserted = len(found) > 1 and not _is_ended(found[-2], sketch, text)
    return found


def _ends_only(sketch: Sketch) -> bool:
    """Whether clauses of an order say no more than when it is over: "sit with her until she's asleep"."""
    return all(clause.kind == "until" for clause in sketch.clauses)


def _denied(before: Sequence[Sketch], said: Span) -> tuple[Clause, ...]:
    """Give the last conditions before "otherwise" as those of what is done where they are not so."""
    conditions = ([c for c in sketch.clauses if c.kind in CONDITIONS] for sketch in reversed(before))
    return tuple(
        replace(clause, span=said, condition=_contrary(clause.condition))
        for clause in next((found for found in conditions if found), [])
        if clause.condition is not None
    )


def _unbound(sketch: Sketch, text: str) -> Sketch:
    """Say that no other case is known: "if it's after nine, call Ann, otherwise walk the dog"."""
    told = "is not used: whether that is so is a matter of the calendar"
    return replace(
        sketch, remarks=(*sketch.remarks, Remark.noted(text, sketch.part.segment.connective_span, told))
    )


def _contrary(condition: Condition) -> Condition:
    """Give the condition that another is not so; what is left out "unless it rains" waits for the rain."""
    return replace(condition, negated=not condition.negated, contrary=not condition.contrary, excepted=False)


def _held_behind(sketches: Sequence[Sketch], text: str) -> list[Sketch]:
    """Give orders what is said behind the last of them: a deadline, or a time that is said to be for all."""
    found = list(sketches)
    for place, sketch in enumerate(sketches):
        shared = [p for p in sketch.phrases if _is_shared(p, sketch, text)]
        last = place + 1 == len(sketches) or _is_ended(sketch, sketches[place + 1], text)
        away = [clause for clause in sketch.clauses if _is_while_others(clause, sketch)]
        joined = place and sketch.part.segment.connective in JOINED and _is_open_in_front(found[place - 1])
        if away and last and joined and not _is_ended(found[place - 1], sketch, text):
            found[place - 1] = _beside_others(found[place - 1], away)
        for other in range(place - 1, -1, -1):
            if not shared or not last or _is_ended(found[other], found[other + 1], text):
                break
            if leads_to_consequence(found[other], found[other + 1], text):
                # "Chill it for four hours, so make it before lunch": the one is why, not what is due.
                break
            if not _is_bare(found[other], STEPS) or _is_other_need(found[other], sketch):
                break
            found[other] = found[other].under(shared)
        if last and place and _is_verb_alone(found[place - 1], text) and _is_bare(found[place - 1], STEPS):
            # "Level and float when the pour is finished", "stretch and fold every half hour"
            phrases = [phrase for phrase in sketch.phrases if isinstance(phrase.said.time, Repeat)]
            clauses = [
                clause for clause in sketch.clauses if clause.kind in HELD and _follows(clause, sketch)
            ]
            joint = text_between(found[place - 1], sketch, text).strip().lower()
            if (
                joint in sketch.lexicon.closed.additions
                or sketch.part.segment.connective in sketch.lexicon.closed.additions
            ):
                found[place - 1] = found[place - 1].under(phrases, clauses)
    return found


def _is_other_need(before: Sketch, sketch: Sketch) -> bool:
    """Whether it is told what must be done, behind an order: "buy milk, bins need emptying by six"."""
    told, ordered = sketch.operation, before.operation
    return told is not None and told.due is not None and ordered is not None and ordered.due is None


def _is_open_in_front(sketch: Sketch) -> bool:
    """Whether it asks for something, begins its sentence or goes on in it, and says at most how long."""
    return sketch.is_open and sketch.part.segment.connective in {None, *JOINED}


def _is_while_others(clause: Clause, sketch: Sketch) -> bool:
    """Whether a clause behind an order says where others are meanwhile: "… while she's out"."""
    subject = None if clause.condition is None else clause.condition.subject
    there = clause.where is not None and subject not in {None, *sketch.lexicon.closed.singular_anaphors}
    return clause.kind == "while" and there and _follows(clause, sketch)


def _beside_others(sketch: Sketch, clauses: Sequence[Clause]) -> Sketch:
    """Give an order what is said behind the next: "clean the bath and do the beds while she's out".

    Who is called in it may be meant by that: "wake Ben and cook while he is in the bath".
    """
    thing = "" if sketch.operation is None else sketch.operation.object or ""
    return sketch if names_person(thing, sketch.lexicon) else sketch.under((), tuple(clauses))


def _is_verb_alone(sketch: Sketch, text: str) -> bool:
    """Whether nothing is said of an order but its verb."""
    first, end = sketch.part.segment.span
    return text[first:end].strip(" ,").isalpha()


def _follows(clause: Clause, sketch: Sketch) -> bool:
    """Whether a clause stands behind what is to be done."""
    return sketch.operation is not None and clause.span[0] > sketch.operation.span[0]


def _is_shared(phrase: Phrase, sketch: Sketch, text: str) -> bool:
    """Whether a time behind an order is a deadline, or led by a word for all: ", both at noon"."""
    operation = sketch.operation
    if operation is None or not sketch.asks or phrase.span[0] < operation.span[1]:
        return False
    led = FOR_ALL.search(text[: phrase.span[0]])
    if led is not None and led[1].lower() in sketch.lexicon.closed.universal_pronouns:
        return True
    said = phrase.said
    # "Clear the table and load the dishwasher after dinner"; but "pack and leave after four"
    meal = isinstance(said.time, Wall) and said.time.clock is None
    bound = said.constraint is Constraint.BEFORE or (said.constraint is Constraint.AFTER and meal)
    due = bound and said.preposition not in LASTING
    lengths = all(time is phrase for time in sketch.times)
    # "Wash the car and, after lunch, mow the lawn by five": that is said of the lawn alone.
    alone = lengths and not sketch.clauses and sketch.part.segment.connective in JOINED
    return due and alone and isinstance(said.time, (Wall, Duration))


def _is_ended(before: Sketch, sketch: Sketch, text: str) -> bool:
    """Whether a sentence ends between two."""
    return not ENDS.isdisjoint(text_between(before, sketch, text))


def _is_bare(sketch: Sketch, joints: Collection[str]) -> bool:
    """Whether it asks for something, joined so, and says at most how long."""
    return sketch.is_open and sketch.part.segment.connective in joints


def _handed_on(phrase: Phrase) -> list[Phrase]:
    """Give what a time in front of the first order says of the others, if anything."""
    said, time = phrase.said, phrase.said.time
    if (
        said.preposition in LASTING
        or isinstance(time, TimeWord)
        or (isinstance(time, Offset) and time.anchor is None)
    ):
        return []
    if said.constraint in STRETCHES or isinstance(time, (Range, Repeat)):
        return [phrase]
    later = _not_before(said)
    return [] if later is None else [replace(phrase, said=later)]


def _not_before(said: Said) -> Said | None:
    """Read a moment as one that what is done next does not come before."""
    time = said.time
    if said.constraint not in MOMENTS or said.is_day:
        return None
    if isinstance(time, Duration):
        counted = said.preposition == "in"
        return replace(said, constraint=Constraint.AFTER, preposition="after") if counted else None
    return replace(said, constraint=Constraint.AFTER, preposition="from")
