"""What negations ask for: "don't open it before six" is not before six, "don't … until" when it is so."""

from collections.abc import Iterable
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Operation
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import BOUNDS, Anchor, Constraint, Edge, TimeRequirement

TURNED = {
    Constraint.BEFORE: Constraint.AFTER,
    Constraint.AFTER: Constraint.BEFORE,
    Constraint.FOR: Constraint.AFTER,
}
"""What "don't … before", "don't … after" and "don't … for" ask for."""


LONGER = "more than"
"""The hedge of a length of time that is not to be exceeded."""


def awaiting(sketch: Sketch) -> Sketch:
    """Read "don't serve it until the guests arrive" as: serve it, when they do."""
    operation = sketch.operation
    if operation is None or not operation.negated or all(c.kind != "until" for c in sketch.clauses):
        return sketch
    clauses = tuple(
        clause
        if clause.kind != "until"
        else replace(clause, kind="when", marker="when")
        if clause.distance is None
        else replace(clause, kind="after", marker="after")
        for clause in sketch.clauses
    )
    return replace(sketch, operation=replace(operation, negated=False), clauses=clauses)


def without_denial(
    operation: Operation | None,
    requirements: list[TimeRequirement],
    duration: float | None,
    connected: TimeRequirement | None,
    said: str,
    lexicon: Lexicon,
    begun: Anchor | None,
) -> tuple[Operation | None, list[TimeRequirement], float | None]:
    """Read what is not to be done at some time as what is to be done at another: "don't open it before six".

    Parameters
    ----------
    operation, requirements, duration
        What is asked for, when, and how long it goes on, in seconds; given back as they are to be read.
    connected
        What the word requires that joins it to what was said before.
    said
        The words of the instruction, and of one before it that is denied with it.
    lexicon
        What nobody asks for at any time is not turned: "don't disturb dad before ten".
    begun
        What is asked for right before it: from there counts how long something is not to be done: "put the
        pie in at six and don't open the door for half an hour".
    """
    denied = _denied_times(requirements, connected, said)
    if operation is None or not operation.negated or not denied or operation.lemma in lexicon.doing.unwanted:
        return operation, requirements, duration
    later = all(r.constraint is Constraint.AFTER for r in requirements if r.span in denied)
    if later and (_is_of_anyone(operation, lexicon) or _forbids(said, lexicon)):
        return operation, requirements, duration
    lasting = any(r.constraint is Constraint.FOR and LONGER in r.fuzziness for r in requirements)
    if duration is not None and not lasting:
        requirements = _beside_times(requirements, duration)
    turned = [_turned(r, duration, begun) if r.span in denied else r for r in requirements]
    return replace(operation, negated=False), turned, duration if lasting else None


def _is_of_anyone(operation: Operation, lexicon: Lexicon) -> bool:
    """Whether nobody asks for it before: "don't let anyone in after ten", "don't eat anything after ten"."""
    named = (operation.object or "").lower()
    return named in lexicon.closed.indefinite_pronouns or named.partition(" ")[0] in {"any", "anything"}


def _forbids(said: str, lexicon: Lexicon) -> bool:
    """Whether somebody is told what they may not do: "he mustn't drive after ten"."""
    return any(word.text in lexicon.closed.forbidding for word in words_of(said))


def _beside_times(requirements: Iterable[TimeRequirement], length: float) -> list[TimeRequirement]:
    """Read "not for two hours after lunch" as later than that, and "before lunch" as earlier than that."""
    found: list[TimeRequirement] = []
    for requirement in requirements:
        last = found[-1] if found else requirement
        joined = last.constraint is Constraint.FOR and requirement.span[0] <= last.span[1] + 1
        if not joined or requirement.constraint not in BOUNDS:
            found.append(requirement)
            continue
        by = length if requirement.constraint is Constraint.AFTER else -length
        anchor = requirement.anchor
        found[-1] = replace(
            requirement.shifted(by),
            text=f"{last.text} {requirement.text}",
            span=(last.span[0], requirement.span[1]),
            anchor=None if anchor is None else replace(anchor, lag=anchor.lag + by),
            denied=True,
        )
    return found


def _denied_times(
    requirements: Iterable[TimeRequirement], connected: TimeRequirement | None, said: str
) -> set[tuple[int, int]]:
    """Give the spans of the times at which something is not to be done, as it is to be done at others.

    "Never leave it open for more than a minute" asks for nothing, nor does "never open it before noon", which
    holds each day; but "never water it before sunday" does. "Then don't serve it" asks for nothing, either:
    the word that connects it only goes on telling.
    """
    joining = None if connected is None else connected.span
    denied = (one for one in requirements if one.span != joining and _is_turned(one))
    for_good = "never" in said.lower().split()
    return {one.span for one in denied if not for_good or _is_before_day(one)}


def _is_turned(requirement: TimeRequirement) -> bool:
    """Whether what is not to be done then is to be done at another time: "not for the first ten minutes"."""
    anchor = requirement.anchor
    opening = requirement.earliest == 0.0 or (anchor is not None and anchor.edge is Edge.START)
    return requirement.constraint in TURNED or (_is_stretch(requirement) and opening)


def _is_before_day(requirement: TimeRequirement) -> bool:
    """Whether something is due before a day, or a longer period: "before sunday"."""
    unanchored = requirement.constraint is Constraint.BEFORE and requirement.anchor is None
    return unanchored and requirement.grain is not None and requirement.grain not in SUB_DAY


def _is_stretch(requirement: TimeRequirement) -> bool:
    """Whether a requirement is how long something goes on, from some moment: "for the first ten minutes"."""
    return requirement.constraint is Constraint.BETWEEN and requirement.preposition == "for"


def _turned(requirement: TimeRequirement, duration: float | None, begun: Anchor | None) -> TimeRequirement:
    """Read "don't open it before six" as: open it, not before six."""
    if requirement.constraint is Constraint.FOR and LONGER in requirement.fuzziness:
        # "Don't boil it for more than a minute": for a minute at most.
        return replace(requirement, fuzziness=("at most",))
    constraint = TURNED.get(requirement.constraint, Constraint.AFTER)
    time = duration if requirement.constraint is Constraint.FOR else requirement.t_spec
    if requirement.constraint is Constraint.BETWEEN:
        # "Don't stir it for the first ten minutes": after them.
        time = requirement.latest
    after = constraint is Constraint.AFTER
    turned = replace(
        requirement,
        denied=True,
        constraint=constraint,
        preposition="not before" if after else "no later than",
        t_spec=time,
        earliest=time if after else None,
        latest=None if after else time,
    )
    lasting = requirement.constraint is Constraint.FOR or _is_stretch(requirement)
    if begun is None or requirement.anchor is not None or time is None or not lasting:
        return turned
    counted = replace(begun, text=requirement.text, lag=time)
    return replace(turned, anchor=counted, t_spec=None, earliest=None, latest=None, grain=None)
