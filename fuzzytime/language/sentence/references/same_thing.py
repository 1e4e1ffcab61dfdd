"""Times that count from what was asked for of the same thing before: "take it out after forty minutes"."""

from dataclasses import replace

from fuzzytime.language.instruction import Operation
from fuzzytime.language.meaning.expressions import Duration, Offset, Said
from fuzzytime.language.sentence.references.anchors import Anchors, only_counted
from fuzzytime.language.sentence.references.mentions import shares_thing, undoes
from fuzzytime.requirement import Anchor, Constraint, Edge, TimeRequirement
from fuzzytime.times import seconds_between


def since_the_same(anchors: Anchors, said: Said, requirement: TimeRequirement) -> TimeRequirement | None:
    """Count so long "after" from what was asked for of the same thing before; None where it counts from now.

    "In an hour" counts from now, and so does what names its thing anew, unless it undoes what was done ("take
    the pie out after an hour"), or would be before the same thing's own time: "put the lasagne in at six and
    take it out in forty minutes".
    """
    own, distance = anchors.operation_at(anchors.position), requirement.t_spec
    if own is not None and distance is not None and said.preposition in {"in", "within"}:
        found = _behind_last(anchors, own, said, requirement)
        if found is not None:
            return found
    bare = isinstance(said.time, Duration) or (isinstance(said.time, Offset) and said.time.anchor is None)
    if own is None or not own.is_asked or distance is None or not bare:
        return None
    if _counts_on(anchors, own, said, requirement):
        anchor = Anchor(
            text=requirement.text, target=anchors.position - 1, edge=Edge.FREE, lag=distance, exact=True
        )
        return only_counted(requirement, anchor, Constraint.AFTER)
    lent = said.preposition == "after" and _is_lent(requirement, anchors)
    if lent and anchors.position - 1 in anchors.told.since:
        # "After 3 minutes the beans, after 5 the corn, after 8 turn it off": all since the same
        told = anchors.told.since[anchors.position - 1]
        return (
            None if told is None else only_counted(requirement, replace(told, lag=distance), Constraint.AFTER)
        )
    return _since_asked_before(anchors, own, said, requirement, distance)


def _since_asked_before(
    anchors: Anchors, own: Operation, said: Said, requirement: TimeRequirement, distance: float
) -> TimeRequirement | None:
    """Count from what was asked for of the same thing, from its begin where that lasts longer."""
    target = _asked_before(anchors) if said.preposition in {"after", "in"} else None
    if target is None or _is_said_before(anchors, target, requirement):
        return None
    start = anchors.told.start(target)
    begun = None if start is None or anchors.now is None else seconds_between(anchors.now, start)
    too_early = begun is not None and distance < begun
    other = anchors.operation_at(target)
    undone = other is not None and undoes(own, other, anchors.lexicon)
    after = said.preposition == "after" and (own.again or undone or too_early)
    if not after and not (own.again and too_early):
        return None
    edge = Edge.FREE if tells_length_of(anchors, target) else Edge.END
    if distance < (anchors.told.length(target) or 0.0):
        # "Roast it for an hour. Turn it after ten minutes"
        edge = Edge.START
    anchor = Anchor(text=requirement.text, target=target, edge=edge, lag=distance, exact=True)
    return only_counted(requirement, anchor, Constraint.AFTER)


def _behind_last(
    anchors: Anchors, own: Operation, said: Said, requirement: TimeRequirement
) -> TimeRequirement | None:
    """Count what would be before the instruction right before it from that: "at 14:00, … within 30 minutes".

    It is about the same thing, or tells who speaks of it; so is "in" where that is tried again.
    """
    last, distance = anchors.position - 1, requirement.t_spec or 0.0
    before = anchors.operation_at(last) if last >= anchors.first else None
    start = anchors.told.start(last)
    if before is None or not before.is_asked or not own.is_asked or start is None or anchors.now is None:
        return None
    doing = anchors.lexicon.doing
    again = own.object is None and own.lemma in doing.repeating | doing.trying
    # "Leave the house at ten and call me within the hour"
    reports = (
        own.lemma in anchors.lexicon.addressing and own.object in anchors.lexicon.closed.first_person_objects
    )
    within = said.preposition == "within"
    counted = (reports or is_about_the_same(anchors, last)) if within else again
    if (
        not counted
        or distance > seconds_between(anchors.now, start)
        or _is_said_before(anchors, last, requirement)
    ):
        return None
    anchor = Anchor(text=requirement.text, target=last, edge=Edge.END, lag=distance, exact=not within)
    return only_counted(requirement, anchor, Constraint.BETWEEN if within else Constraint.AFTER)


def _counts_on(anchors: Anchors, own: Operation, said: Said, requirement: TimeRequirement) -> bool:
    """Whether it counts from what is to be done before it: "fry it at ten, and after five minutes add salt".

    So it does where it would be before that, and in other words always: "…, and in another five minutes".
    """
    last = anchors.position - 1
    before = anchors.operation_at(last) if last >= anchors.first else None
    if before is None or not before.is_asked or said.preposition not in {"after", "in"}:
        return False
    if _is_said_before(anchors, last, requirement):
        return False
    more = anchors.lexicon.conversation["more"]
    if any((word,) in more for word in requirement.text.lower().split()):
        return True
    start, distance = anchors.told.start(last), requirement.t_spec or 0.0
    begun = None if start is None or anchors.now is None else seconds_between(anchors.now, start)
    # "Boil it at six and call mum after ten minutes" is not sure to.
    in_front = requirement.span[0] < own.span[0]
    return said.preposition == "after" and in_front and begun is not None and distance < begun


def _is_said_before(anchors: Anchors, target: int, requirement: TimeRequirement) -> bool:
    """Whether a time in front of another instruction is of both: "in an hour, check and baste it"."""
    other = anchors.operation_at(target)
    return target >= anchors.first and other is not None and requirement.span[0] < other.span[0]


def _is_lent(requirement: TimeRequirement, anchors: Anchors) -> bool:
    """Whether a number has the unit of one before it: "after 5"."""
    last = requirement.text.lower().split()[-1]
    return last.isdecimal() or last in anchors.lexicon.numbers


def tells_length_of(anchors: Anchors, target: int) -> bool:
    """Whether a distance from another instruction is how long that goes on.

    So it is where both ask for something of the same thing, and nothing else tells how long: "bake it at
    six, take it out after an hour". "Another tablet two hours later" tells no length.
    """
    own, other = anchors.operation_at(anchors.position), anchors.operation_at(target)
    if own is None or other is None or own.stated or other.stated or own.lemma == other.lemma:
        return False
    return _is_of_the_same(anchors, target) and anchors.told.length(target) is None


def is_about_the_same(anchors: Anchors, target: int) -> bool:
    """Whether an instruction is about what another is about, or names nothing else."""
    own, other = anchors.operation_at(anchors.position), anchors.operation_at(target)
    if own is None or other is None:
        return False
    return own.object is None or own.object == other.object or shares_thing(other, own)


def _asked_before(anchors: Anchors) -> int | None:
    """Give the latest instruction, not long ago, that asks once for something of the same thing.

    Who asks for the very same anew, by its name, means another time of it: "feed the cat".
    """
    own = anchors.operation_at(anchors.position)
    for place, before in anchors.just_before():
        alike = own is not None and not own.again and own.lemma == before.lemma
        # "Switch the pump on at noon and off after an hour"
        anew = alike and own is not None and not undoes(own, before, anchors.lexicon)
        asked = before.is_asked and not anchors.told.is_repeated(place)
        if asked and not anew and _is_of_the_same(anchors, place):
            return place
    return None


def _is_of_the_same(anchors: Anchors, target: int) -> bool:
    """Whether another instruction is about the thing of this one, or is what it undoes and names no thing."""
    own, other = anchors.operation_at(anchors.position), anchors.operation_at(target)
    if own is None or other is None:
        return False
    if own.object is None:
        # "Take off at noon, land after twenty minutes"
        return undoes(own, other, anchors.lexicon)
    return own.object == other.object
