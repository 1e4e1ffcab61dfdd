"""Times beside an event or a moment: "five minutes after the timer rings", "after the rice is done"."""

from dataclasses import dataclass, replace
from types import MappingProxyType

from fuzzytime.requirement import Anchor, Constraint, TimeRequirement
from fuzzytime.rulebook.resolving.adapt import Wanted, adapt
from fuzzytime.rulebook.resolving.clauses import wait_for
from fuzzytime.rulebook.resolving.extension import added
from fuzzytime.rulebook.resolving.question import Question, Said
from fuzzytime.rulebook.resolving.resolution import Share
from fuzzytime.rulebook.tables.contents import Tables
from fuzzytime.rulebook.wording.lookup import UNIT_LENGTHS, find
from fuzzytime.rulebook.wording.phrases import event_at_end, event_named
from fuzzytime.rulebook.wording.sentences import condition_of, understand
from fuzzytime.satisfaction import NEVER, SatisfactionFunction, Trapezoid


@dataclass(frozen=True, slots=True)
class Unknown:
    """Why a moment is not known, and whether that is only because nobody has told it yet."""

    reason: str | None
    untold: bool


def measured_from_event(requirement: TimeRequirement, tables: Tables) -> TimeRequirement:
    """Give a time of the day that is an event's name as well ("before lunch") as one measured from the event.

    Any other requirement is given as it is.
    """
    of_the_day = requirement.condition is None and requirement.anchor is None and requirement.word is None
    if not of_the_day or event_at_end(requirement.text, tables) is None:
        return requirement
    distance = 0.0
    if requirement.number is not None and requirement.unit is not None:
        distance = requirement.number * UNIT_LENGTHS[requirement.unit]
    before = " before " in f" {requirement.text.lower()} "
    anchor = Anchor(
        text=requirement.text,
        lag=-distance if before else distance,
        exact=distance > 0 or requirement.constraint in (Constraint.AT, Constraint.BETWEEN),
    )
    return replace(requirement, t_spec=None, earliest=None, latest=None, grain=None, anchor=anchor)


def on_one_side(question: Question, anchor: Anchor) -> Question | None:
    """Ask the same without the anchor: before or after the time of its event, or of its condition.

    None where the anchor is an event that has not happened, and of which no time is announced.
    """
    requirement = question.requirement
    before = anchor.lag < 0 or requirement.constraint is Constraint.BEFORE
    if event_named(anchor.text, question.tables) is None:
        condition = condition_of(anchor)
        preposition = "before" if before else "after"
        clause = replace(
            requirement,
            constraint=Constraint.WHEN,
            condition=condition,
            preposition=preposition,
            anchor=None,
        )
        return replace(question, requirement=clause)
    time = _time_of_event(question, anchor)
    if time is None:
        return None
    # Who asks for a time after what has happened already means from now on.
    bound = time + anchor.lag if before else max(time, 0.0) + anchor.lag
    side = Constraint.BEFORE if before else Constraint.AFTER
    return replace(question, requirement=replace(requirement, constraint=side, t_spec=bound, anchor=None))


def at_a_distance(question: Question, anchor: Anchor) -> Said:
    """Resolve a time at a wished-for lag: its ψ and the moment add, by the extension principle."""
    moment, notes = _moment(question, anchor)
    if isinstance(moment, Unknown):
        return Said(satisfaction=NEVER, model="in", reason=moment.reason, untold=moment.untold, notes=notes)
    requirement = replace(question.requirement, constraint=Constraint.AT, t_spec=abs(anchor.lag), anchor=None)
    found = find(requirement, question.tables, question.verb)
    adapted = adapt(
        Wanted(
            model=found.model,
            t=found.row.t,
            width=question.width(found.row, abs(anchor.lag)),
            hedges=found.hedges,
        ),
        requirement,
        question.tables,
    )
    # The lag was adapted ahead of 0, where its width belongs; "five minutes before" lies behind 0.
    lag = adapted.satisfaction.shifted(min(2 * anchor.lag, 0.0))
    return Said(
        satisfaction=added(moment, lag),
        model=found.model.name,
        parameters=MappingProxyType({**adapted.parameters, "lag": anchor.lag}),
        shares=(Share(name=found.row.name, source=found.row.source, share=1.0),),
        hedges=adapted.hedges,
        notes=(*notes, *adapted.notes),
        named=moment.best.low + anchor.lag,
    )


def not_happened(anchor: Anchor) -> str:
    """Say that an anchor's event has no time."""
    return f"not yet: {anchor.text!r} has not happened, and no time is announced"


def _time_of_event(question: Question, anchor: Anchor) -> float | None:
    """Give when an anchor's event happens next, or happened last."""
    event = event_named(anchor.text, question.tables)
    times = [reading.at for reading in question.context.of_signal(event or "")]
    return next((time for time in times if time >= 0), times[-1] if times else None)


def _moment(question: Question, anchor: Anchor) -> tuple[SatisfactionFunction | Unknown, tuple[str, ...]]:
    """Give when an anchor is, or why that is not known, and notes about its words."""
    if event_named(anchor.text, question.tables) is not None:
        time = _time_of_event(question, anchor)
        if time is None:
            return Unknown(not_happened(anchor), untold=True), ()
        return Trapezoid(time, time, time, time), ()
    understood = understand(condition_of(anchor), question.tables, question.context)
    if understood.formula is None:
        return Unknown(understood.reason, untold=not understood.impossible), understood.notes
    world = replace(question, tables=understood.tables).world([understood.formula])
    awaited = wait_for(understood.formula, "when", 0.0, 0.0, world, question.horizon)
    unknown = Unknown(awaited.reason, untold=awaited.untold)
    return (unknown if awaited.reason else awaited.satisfaction), understood.notes
