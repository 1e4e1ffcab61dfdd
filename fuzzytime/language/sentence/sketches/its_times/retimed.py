"""Times bound anew by what is done: "be there by seven tomorrow" is on that day."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation
from fuzzytime.language.meaning.expressions import Edge, Phrase, Wall
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.clauses.times_of_events import AHEAD
from fuzzytime.requirement import MOMENTS, Constraint


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
