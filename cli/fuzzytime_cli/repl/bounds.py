"""Times that something is only not to start before: "not before noon", "from six"."""

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import find_times
from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime.times import instant_after
from fuzzytime_cli.clock import Clock
from fuzzytime_cli.repl.scene import Scene, waiting
from fuzzytime_cli.session import Entry


def bound_in(scene: Scene, time: str) -> TimeRequirement | None:
    """Give a time, whole, that something is only not to start before; None where it is another."""
    found = find_times(time, scene.now, scene.lexicon).requirements
    if len(found) != 1 or found[0].span != (0, len(time)) or found[0].constraint is not Constraint.AFTER:
        return None
    # From now on anything is.
    return found[0] if (found[0].t_spec or 0.0) > 0.0 and found[0].anchor is None else None


def check_bound(scene: Scene, entry: Entry, time: str, part: str | None) -> None:
    """Refuse to let what has a time of its own start at a bound that it keeps already.

    Raises
    ------
    FuzzytimeError
        If it does: a call at three is not before two.
    """
    bound = bound_in(scene, time)
    if bound is None:
        return
    for place, one in waiting(scene, entry.number):
        meant = part in {None, one.identifier} and scene.plan.has_time(place)
        timed = any(told.constraint is Constraint.AT for told in one.requirements)
        start = scene.plan.instant(scene.plan.schedule.start_times[place]) if meant and timed else None
        if start is not None and start >= instant_after(scene.now, bound.t_spec or 0.0):
            at = Clock(scene.now, with_seconds=False).at(start)
            raise FuzzytimeError(f"{one.skill.name} is at {at}, and so {time} already: nothing is changed")
