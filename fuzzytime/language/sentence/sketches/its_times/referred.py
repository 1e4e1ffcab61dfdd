"""Which moment of what is done its times and clauses are about: its start, its end, all of it."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation, Span
from fuzzytime.language.meaning.expressions import Edge, Phrase, Range, Wall
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.clauses.clause_sides import AHEAD, BEHIND
from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.sketches.its_clauses.deadlines import DEADLINE
from fuzzytime.language.sentence.sketches.its_times.elsewhere import is_of_subject
from fuzzytime.language.sentence.sketches.its_times.own_times import OwnTimes
from fuzzytime.language.sentence.sketches.its_times.said_of_time import DATED
from fuzzytime.language.sentence.verbs.meant.actions import Action
from fuzzytime.language.sentence.verbs.meant.small_clauses import reference_of
from fuzzytime.requirement import MOMENTS, Constraint, Reference

PUT = "put"
OFF = frozenset({"off", "back"})
"""Particles of "put it off until thursday", which gives it another time; but "put it on until noon"."""


def referred(
    part: Part, times: OwnTimes, action: Action, operation: Operation
) -> tuple[tuple[Phrase, ...], tuple[Clause, ...], tuple[Reference | None, ...]]:
    """Give an operation's times as its verb means them, its clauses, and what each of the times is about."""
    clauses = tuple(
        replace(clause, reference=_reference_at(part, clause.span, action)) for clause in times.clauses
    )
    phrases = times.phrases
    if not operation.negated:
        phrases = tuple(by_that_day(phrase, clauses) for phrase in phrases)
    references = tuple(_reference(part, phrase, action, clauses) for phrase in phrases)
    if is_there(operation, part.lexicon):
        phrases = tuple(on_that_day(phrase) for phrase in phrases)
    moved = operation.lemma in part.lexicon.moving and (operation.lemma != PUT or operation.particle in OFF)
    if moved and not operation.negated:
        phrases = tuple(put_off(phrase) for phrase in phrases)
    elif not operation.negated:
        references = _until_from_then(phrases, references)
    if _is_gone(operation, part.lexicon):
        references = tuple(None if one is Reference.THROUGHOUT else one for one in references)
    if operation.stated:
        # "The shop is closed between ten and eleven" is so all that time.
        references = tuple(
            None if isinstance(phrase.said.time, Range) else one
            for phrase, one in zip(phrases, references, strict=True)
        )
    return phrases, clauses, references


def _until_from_then(
    phrases: Sequence[Phrase], references: tuple[Reference | None, ...]
) -> tuple[Reference | None, ...]:
    """Let what begins at a time go on all the while until another: "at six lock the hens in until eight"."""
    clocks = [one.said for one in phrases if one.said.wall.clock is not None]
    begun = any(one.constraint in MOMENTS or one.preposition == "from" for one in clocks)
    ends = [begun and one.said.preposition == "until" for one in phrases]
    return tuple(Reference.THROUGHOUT if end else one for one, end in zip(references, ends, strict=True))


def _is_gone(operation: Operation, lexicon: Lexicon) -> bool:
    """Whether "leave" is to go: "leave the house between seven and eight" is no "leave the lamp on"."""
    if operation.phrase != "leave" or operation.complement is not None:
        return False
    if operation.object is None:
        return operation.place is not None and operation.place.lower().startswith(("for ", "to "))
    return operation.place is None and operation.object.lower().split()[-1] in lexicon.beside.sites


def _reference(part: Part, phrase: Phrase, action: Action, clauses: Sequence[Clause]) -> Reference | None:
    """Give which moment a time is about, by the verb nearest above it: "so that it finishes by noon"."""
    if phrase.rule in {DATED, DEADLINE}:
        # What its clause is about starts or ends then, not what is to be done.
        return action.reference
    if any(clause.kind in BEHIND | AHEAD and clause.span[1] + 1 == phrase.span[0] for clause in clauses):
        # "Lock up when everyone has left on friday"
        return action.reference
    if action.reference is Reference.FINISH and is_of_subject(part, phrase, action):
        # "Staff meeting at 3.30, should be done by half four"
        return None
    return _reference_at(part, phrase.span, action)


def _reference_at(part: Part, span: Span, action: Action) -> Reference | None:
    """Give which moment words in a stretch are about, by the verb nearest above them."""
    first, end = part.local(span)
    for place in part.tree.at(first, end):
        for above in part.tree.above(place):
            if above == action.place:
                return action.reference
            inside = first <= part.tree.nodes[above].start < end
            if part.tree.nodes[above].is_verb and not inside:
                return reference_of(part.tree, above) or action.reference
    return action.reference


def by_that_day(phrase: Phrase, clauses: Sequence[Clause]) -> Phrase:
    """Bind what is to be done before an event by the end of its day: "before the show on Saturday"."""
    said = phrase.said
    ahead = (c for c in clauses if c.kind in AHEAD and c.distance is None and c.span[1] + 1 == phrase.span[0])
    day = isinstance(said.time, Wall) and not said.wall.is_timed and said.constraint in MOMENTS
    if not day or next(ahead, None) is None:
        return phrase
    return replace(phrase, said=replace(said, constraint=Constraint.BEFORE, edge=Edge.LAST))


def is_there(operation: Operation, lexicon: Lexicon) -> bool:
    """Whether somebody is somewhere then, or no longer: what nobody does a day ahead."""
    alone = operation.complement is None and (operation.object is None or operation.place is None)
    if operation.phrase in lexicon.doing.being_there:
        # "Leave the keys at reception" is done at any time until then.
        return alone
    return (
        operation.phrase in lexicon.doing.getting_there
        and operation.object is None
        and operation.place is not None
    )


def put_off(phrase: Phrase) -> Phrase:
    """Take until when something is put off as when it is: "postpone the demo until thursday"."""
    said = phrase.said
    if said.preposition != "until" or said.constraint is not Constraint.BEFORE:
        return phrase
    return replace(phrase, said=replace(said, constraint=None, edge=Edge.START))


def on_that_day(phrase: Phrase) -> Phrase:
    """Bind a deadline of some day by that day: "be at the station by seven tomorrow"."""
    said, wall = phrase.said, phrase.said.wall
    if wall.days is None or wall.clock is None or said.constraint is not Constraint.BEFORE:
        return phrase
    return replace(phrase, said=replace(said, within=replace(wall, clock=None, weak=False)))
