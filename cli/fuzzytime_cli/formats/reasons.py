"""Why each skill starts when it does, in words: a line under the plan, and sentences for who asks."""

from collections.abc import Sequence

from fuzzytime.interpreter import Plan
from fuzzytime.satisfaction import Either, Interval
from fuzzytime.scheduling import (
    Alternative,
    Bond,
    Limits,
    Neighbour,
    Schedule,
    Status,
    Why,
    elsewhere,
    explain,
)
from fuzzytime.skills import Busy
from fuzzytime_cli.clock import Clock
from fuzzytime_cli.formats.asked import asked_of_time, waits_sentences
from fuzzytime_cli.formats.whole import SHOWN, how_near, is_same, product_of
from fuzzytime_cli.render import plain

MINUTE = 60.0

MOST_NAMED = 3
"""How many others a sentence names."""

MOST_SECONDS = 1.0
"""Time spent at most on all lines under a plan; to whom what is left then lost is not looked for."""

SHARE = 0.2
"""And at most such a share of the time that the plan itself was given."""

WORTH_NAMING = 0.2
"""Others that would lose a smaller share of what the first would lose are not named."""


def explaining(limits: Limits) -> float:
    """Give the seconds that all lines under a plan may take, by the limits under which it is made."""
    return min(MOST_SECONDS, SHARE * limits.seconds)


def loss_lines(plan: Plan, seconds: float = MOST_SECONDS) -> list[tuple[int | None, str]]:
    """Give for each skill that is not fully satisfied its position, and in a line what that is due to.

    Whoever shows a line says which skill it is of. Where time was over, a last line, of no skill, says for
    how many that was not looked for.
    """
    short = [position for position, got in enumerate(plan.schedule.satisfactions) if got < 1 - SHOWN]
    found = explain(plan.schedule, short, limits=Limits(seconds=seconds))
    lines: list[tuple[int | None, str]] = [(why.position, _loss(why, plan)) for why in found]
    left = sum(not why.sought for why in found)
    if left:
        lines.append(
            (None, f"to whom {left} of these lost was not looked for: time was over (explain tells)")
        )
    return lines


def _loss(why: Why, plan: Plan) -> str:
    name = plain(plan.skills[why.position].skill.name)
    if plan.schedule.rejected[why.position]:
        return f"{name}: rejected: {_rejection(why, plan)}"
    if why.lost < SHOWN:
        return f"{name}: {why.alone:.2f} is the most it can have: {_limit(why, plan)}"
    if not why.neighbours:
        return f"{name}: lost {why.lost:.2f}"
    return f"{name}: lost {why.lost:.2f} to {_takers(why, plan)}"


def _rejection(why: Why, plan: Plan) -> str:
    own = plan.skills[why.position].reason
    if own:
        return plain(own)
    first = plan.rejected_before(why.position)
    if first is not None:
        return f"must come after {name_of(plan, first)}, which is rejected"
    if why.alone <= plan.schedule.threshold:
        return _limit(why, plan)
    if not _is_lost(why, plan):
        return f"alone it could have {why.alone:.2f}"
    return f"alone it could have {why.alone:.2f}, which it lost to {_takers(why, plan)}"


def _is_lost(why: Why, plan: Plan) -> bool:
    """Whether others have the time of what is rejected."""
    own = plan.skills[why.position].reason or plan.rejected_before(why.position) is not None
    return not own and why.alone > plan.schedule.threshold and bool(why.neighbours)


def _limit(why: Why, plan: Plan) -> str:
    """Say why it could not have more even alone."""
    if why.appointments:
        taken = listed([_appointment(busy, plan) for busy in why.appointments])
        return f"its best time is taken by {taken}"
    if why.ideal - why.alone > SHOWN:
        return "its best time is over"
    if why.ideal == 0:
        return "no time satisfies"
    return "no time satisfies it more"


def _appointment(busy: Busy, plan: Plan) -> str:
    clock = Clock.for_times(plan.request.now, [busy.start, busy.end])
    span = f"{clock.of(busy.start)} to {clock.of(busy.end)}"
    return f"{plain(busy.what)} ({span})" if busy.what else f"an appointment ({span})"


def _takers(why: Why, plan: Plan) -> str:
    """Name the neighbours, each with how it binds: "toast the bread, which wants the same minutes"."""
    least = WORTH_NAMING * why.neighbours[0].loss
    worth = [neighbour for neighbour in why.neighbours if neighbour.loss >= least]
    named, parts = worth[:MOST_NAMED], []
    for bond in dict.fromkeys(neighbour.bond for neighbour in named):
        alike = [neighbour for neighbour in named if neighbour.bond is bond]
        names = listed([name_of(plan, neighbour.position) for neighbour in alike])
        parts.append(f"{names}, which {_bond(why.position, alike, plan)}")
    more = len(worth) - len(named)
    return "; and to ".join(parts) + (f"; and to {more} more" if more else "")


def _bond(position: int, alike: Sequence[Neighbour], plan: Plan) -> str:
    match alike[0].bond:
        case Bond.OVERLAP:
            return "wants the same minutes" if len(alike) == 1 else "want the same minutes"
        case Bond.CHAIN:
            return "would have to make room"
        case Bond.ORDER:
            first = {entry.first for entry in plan.schedule.task.precedences if entry.second == position}
            return "must come first" if alike[0].position in first else "must come after it"


def clash_sentence(plan: Plan) -> str:
    """Say which skills cannot all be satisfied."""
    clash = plan.schedule.clash
    names = listed([name_of(plan, position) for position in clash])
    if not clash:
        return "no schedule satisfies everyone: proved"
    if len(clash) == 1:
        return f"no schedule satisfies everyone: {names} cannot be satisfied at all"
    if len(clash) == 2:
        return f"no schedule satisfies everyone: {names} exclude each other"
    return (
        f"no schedule satisfies everyone: {names} cannot all be had, though any {len(clash) - 1} of them can"
    )


def waits_line(plan: Plan, position: int) -> str:
    """Say what a skill without a time waits for."""
    return f"{name_of(plan, position)}: waits: {plain(plan.everything[position].reason)}"


def name_of(plan: Plan, position: int) -> str:
    """Give a skill's name, with its identifier where another skill has the same name."""
    interpreted = plan.everything[position]
    name = plain(interpreted.skill.name)
    shared = interpreted.skill.name in plan.shared_names
    return f"{name} ({plain(interpreted.identifier)})" if shared else name


def listed(names: Sequence[str]) -> str:
    """Join names as a sentence does: a, b and c."""
    return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)


def why_sentences(plan: Plan, position: int) -> list[str]:
    """Explain one start as a person would: what was asked, who took it, what a minute would cost."""
    if position >= len(plan.skills):
        return waits_sentences(plan.everything[position])
    (why,) = explain(plan.schedule, [position])
    sentences = [_asked(why, plan), _got(why, plan)]
    if why.alternative is not None and why.lost >= SHOWN:
        sentences.append(_instead(why, plan))
    if not plan.schedule.rejected[position]:
        sentences.append(_minutes(why, plan))
    return [sentence for sentence in sentences if sentence]


def _asked(why: Why, plan: Plan) -> str:
    """Say what was asked, and which starts would be best if nothing else were to be done."""
    asked = asked_of_time(plan.skills[why.position])
    if why.best.starts.empty:
        # Why it is rejected is told next.
        return f"{asked}." if plan.schedule.rejected[why.position] else f"{asked}, and {_limit(why, plan)}."
    span = ", or ".join(_span(starts, plan) for starts in _as_good(why, plan))
    if why.alone >= 1 - SHOWN:
        return f"{asked}: alone it would be fully satisfied {span}."
    return f"{asked}: alone it would have {why.alone:.2f} at most, {span}; {_limit(why, plan)}."


def _as_good(why: Why, plan: Plan) -> list[Interval]:
    """Give the starts that would be best: those of each alternative, where there are some."""
    function = plan.skills[why.position].skill.satisfaction
    if not isinstance(function, Either):
        return [why.best.starts]
    parts = (one for one in function.functions if not one.support.empty)
    best = [
        one.best for one in parts if float(one(one.best.high)) >= why.alone - SHOWN and one.best.high >= 0
    ]
    return sorted(best, key=lambda starts: starts.low) or [why.best.starts]


def _span(starts: Interval, plan: Plan) -> str:
    ends = [end for end in (starts.low, starts.high) if end < float("inf")]
    clock = Clock.for_times(plan.request.now, [round(end) for end in ends])
    first, last = clock.of(starts.low), clock.of(ends[-1])
    if len(ends) == 1:
        return "by any start from now on" if round(starts.low) == 0 else f"by any start from {first} on"
    if first == last:
        return f"by a start at {first}"
    return f"by any start from {first} to {last}"


def _got(why: Why, plan: Plan) -> str:
    clock = Clock.for_times(plan.request.now, [why.start])
    start = clock.of(why.start)
    if plan.schedule.rejected[why.position]:
        lost = _is_lost(why, plan)
        told = f"it lost its time to {_takers(why, plan)}" if lost else _rejection(why, plan)
        return f"It is rejected: {told}."
    if why.lost < SHOWN:
        return f"It starts at {start} and has {why.satisfaction:.2f}: nothing stands in its way."
    to = f" to {_takers(why, plan)}" if why.neighbours else ""
    return f"It starts at {start} and has {why.satisfaction:.2f}; it lost {why.lost:.2f}{to}."


def _instead(why: Why, plan: Plan) -> str:
    """Say what its best time would cost whom."""
    alternative = why.alternative
    if alternative is None:
        return ""
    when = Clock.for_times(plan.request.now, [round(alternative.start)]).of(alternative.start)
    own = f"Started at {when} it would have {alternative.satisfactions[why.position]:.2f}"
    schedule = plan.schedule
    if alternative.cost < schedule.weighted_cost - SHOWN:
        return (
            f"{own}, and the whole {product_of(alternative, schedule)}: better than what this search found."
        )
    paying = [neighbour for neighbour in why.neighbours if neighbour.loss >= SHOWN][:MOST_NAMED]
    falls = [
        (name_of(plan, neighbour.position), f"{neighbour.satisfaction:.2f} to {neighbour.instead:.2f}")
        for neighbour in paying
    ]
    same = is_same(schedule, alternative)
    if not same:
        falls.append(
            ("the whole", f"{product_of(schedule, schedule)} to {product_of(alternative, schedule)}")
        )
    if not falls:
        return f"{own}, and the whole would be no better."
    (name, change), *rest = falls
    changes = listed([f"{name} would fall from {change}", *(f"{one} from {by}" for one, by in rest)])
    skills = plan.schedule.task.skills
    more = [entry for entry in paying if skills[entry.position].priority > skills[why.position].priority]
    if more:
        changes += (
            f"; {listed([name_of(plan, entry.position) for entry in more])} came with a higher priority"
        )
    return f"{own}, but {changes}" + ("; the whole would be no better." if same else ".")


def _minutes(why: Why, plan: Plan) -> str:
    """Say what a minute earlier and a minute later would cost."""
    schedule = plan.schedule
    parts = []
    for by, word in ((-MINUTE, "earlier"), (MINUTE, "later")):
        time = why.start + by
        if time < 0:
            continue
        found = elsewhere(schedule, why.position, Interval(time, time))
        if found is None:
            parts.append(f"a minute {word} is not free")
            continue
        parts.append(
            f"a minute {word} it would have {found.satisfactions[why.position]:.2f}"
            + ("" if len(plan.skills) == 1 else _cost_to_whole(schedule, found))
        )
    if not parts:
        return ""
    text = "; ".join(parts)
    return f"{text[0].upper()}{text[1:]}.{_proof(schedule)}"


def _proof(schedule: Schedule) -> str:
    """Say whether better schedules are ruled out: where not, a minute that gains is no surprise."""
    match schedule.certificate.status:
        case Status.OPTIMAL:
            return " No schedule satisfies better: proved."
        case Status.BOUNDED:
            near = how_near(schedule)
            return f" {near[0].upper()}{near[1:]}: more time (--time-limit) may find better."
        case _:
            return ""


def _cost_to_whole(schedule: Schedule, other: Alternative) -> str:
    if is_same(schedule, other):
        return ", at no cost to the whole"
    return f", and the whole {product_of(other, schedule)} instead of {product_of(schedule, schedule)}"
