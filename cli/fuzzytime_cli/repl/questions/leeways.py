"""Questions about how late something may start, or how early: "how late can I start the roast?"."""

import math

from rich.text import Text

from fuzzytime.interpreter import Leeway
from fuzzytime.language.about_wishes import About
from fuzzytime_cli.formats.reasons import listed
from fuzzytime_cli.render import plain, wrapped
from fuzzytime_cli.repl.questions.answering import as_named, going_on, nothing_about
from fuzzytime_cli.repl.questions.taken import at
from fuzzytime_cli.repl.scene import Reply, Scene
from fuzzytime_cli.repl.typed import number_of

MOST = 2
"""How many of those that would lose are named."""


def how_far(scene: Scene, about: About) -> Reply:
    """Say how late, or early, that may start which some words name, where nobody else is to lose by it."""
    positions, unknown = as_named(scene, about.names)
    timed = [place for place in positions if scene.plan.has_time(place)]
    if not timed:
        running = going_on(scene, about)
        return Reply(tuple(running)) if running else nothing_about(about.names)
    place = min(timed, key=lambda one: scene.plan.schedule.start_times[one])
    one = scene.plan.skills[place]
    start = at(scene, scene.plan.instant(scene.plan.schedule.start_times[place]))
    told = may_start(scene, place, about) or f"at {start}, and nothing else that is planned waits for it"
    said = f"{plain(one.identifier)} {plain(one.skill.name)}: {told}"
    lines = (Text(line) for line in wrapped(said, scene.width, 6))
    return Reply((*unknown, *lines), focus=number_of(one.identifier))


def may_start(scene: Scene, place: int, about: About) -> str | None:
    """Say until when a skill may start, or from when on, and who would lose beyond that; else None."""
    conversation, plan = scene.conversation, scene.plan
    found = Leeway(
        plan,
        place,
        conversation.request(scene.now, conversation.state),
        conversation.understanding,
        conversation.solver_of(conversation.state.solver),
        conversation.threshold,
        conversation.limits,
    )
    limit = found.earliest() if about.earlier else found.latest()
    if math.isinf(limit.start):
        return None
    if about.earlier and limit.start <= 0.0:
        return "at once: nothing stands in its way"
    starts = {one.identifier: plan.schedule.start_times[n] for n, one in enumerate(plan.skills)}
    names = {one.identifier: plain(one.skill.name) for one in plan.skills}
    losing = [
        f"{name} {names[name]} at {at(scene, plan.instant(starts[name]))}" for name in limit.losing[:MOST]
    ]
    way = "earliest" if about.earlier else "latest"
    why = f", because of {listed(losing)}" if losing else ""
    return f"at {at(scene, plan.instant(limit.start))} at the {way}{why}"
