"""Times beside an event or a moment: "five minutes after the timer rings", "after the rice is done"."""

from dataclasses import replace
from types import MappingProxyType

from fuzzytime.requirement import Anchor, Condition, Constraint
from fuzzytime.rulebook.adapt import Wanted, adapt
from fuzzytime.rulebook.clauses import wait_for
from fuzzytime.rulebook.extension import added
from fuzzytime.rulebook.lookup import find
from fuzzytime.rulebook.question import Question, Said
from fuzzytime.rulebook.resolution import Share
from fuzzytime.rulebook.sentences import event_named, understand
from fuzzytime.satisfaction import NEVER, SatisfactionFunction, Trapezoid


def on_one_side(question: Question, anchor: Anchor) -> Question | None:
    """Ask the same without the anchor: before or after the time of its event, or of its condition.

    None where the anchor is an event that has not happened, and of which no time is announced.
    """
    requirement = question.requirement
    before = anchor.lag < 0 or requirement.constraint is Constraint.BEFORE
    if event_named(anchor.text, question.tables) is None:
        condition = Condition(text=anchor.text)
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
    moment, reason, notes = _moment(question, anchor)
    if moment is None:
        return Said(satisfaction=NEVER, model="in", reason=reason, notes=notes)
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
    time = moment.best
    # The lag was adapted ahead of 0, where its width belongs; "five minutes before" lies behind 0.
    lag = adapted.satisfaction.shifted(min(2 * anchor.lag, 0.0))
    return Said(
        satisfaction=added(moment, lag),
        model=found.model.name,
        parameters=MappingProxyType({**adapted.parameters, "lag": anchor.lag}),
        shares=(Share(name=found.row.name, source=found.row.source, share=1.0),),
        hedges=adapted.hedges,
        notes=(*notes, *adapted.notes),
        named=max(time.low, 0.0) + anchor.lag,
    )


def not_happened(anchor: Anchor) -> str:
    """Say that an anchor's event has no time."""
    return f"not yet: {anchor.text!r} has not happened, and no time is announced"


def _time_of_event(question: Question, anchor: Anchor) -> float | None:
    """Give when an anchor's event happens next, or happened last."""
    event = event_named(anchor.text, question.tables)
    times = [reading.at for reading in question.context.of_signal(event or "")]
    return next((time for time in times if time >= 0), times[-1] if times else None)


def _moment(
    question: Question, anchor: Anchor
) -> tuple[SatisfactionFunction | None, str | None, tuple[str, ...]]:
    """Give when an anchor is, or why that is not known, and notes about its words."""
    if event_named(anchor.text, question.tables) is not None:
        time = _time_of_event(question, anchor)
        if time is None:
            return None, not_happened(anchor), ()
        return Trapezoid(time, time, time, time), None, ()
    understood = understand(Condition(text=anchor.text), question.tables)
    if understood.formula is None:
        return None, understood.reason, understood.notes
    world = question.world([understood.formula])
    awaited = wait_for(understood.formula, "when", 0.0, 0.0, world, question.horizon)
    return (None if awaited.reason else awaited.satisfaction), awaited.reason, understood.notes
