"""Questions about what there is at some time: "am I free at six?", "what's on at nine?"."""

from dataclasses import replace
from datetime import datetime, timedelta

from rich.text import Text

from fuzzytime.interpreter import MAX_HORIZON, WITHOUT_END
from fuzzytime.language import find_times
from fuzzytime.language.about_wishes import About, AboutKind
from fuzzytime.requirement import Constraint
from fuzzytime.times import seconds_between
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.questions.rooms import beside, gaps_told, is_of_planned, length_of, offer_of, room
from fuzzytime_cli.repl.questions.stretches import bounds_of, on_its_day, time_of
from fuzzytime_cli.repl.questions.taken import SHORTEST, Taken, all_planned, all_taken, at, reply_of
from fuzzytime_cli.repl.scene import Offer, Reply, Scene, said

MOST = 5
"""How many things are told at most."""


def free(scene: Scene, about: About) -> Reply:
    """Say whether one is free at a time, for as long as something takes; or when one is."""
    if not about.time:
        return gaps_told(scene, scene.now)
    time = time_of(scene, about.time)
    first, end = bounds_of(scene, time)
    if first is None:
        # "Can I fit in a run before lunch?"
        return room(scene, about) if about.thing else gaps_told(scene, scene.now)
    scene = _as_far_as(scene, end or first)
    length = length_of(scene, about.thing)[0] if about.thing else timedelta(0)
    window = end if end is not None and end > first else first + max(length, SHORTEST)
    if about.thing and time.constraint is Constraint.AT:
        window = first + max(length, SHORTEST)
    short = [one for one in all_planned(scene) if one.end - one.start < SHORTEST]
    everything = sorted([*all_taken(scene), *short], key=lambda one: one.start)
    meeting = [one for one in everything if one.start < window and max(one.end, one.start + SHORTEST) > first]
    if not meeting:
        behind = next((one for one in all_taken(scene) if one.start >= window), None)
        until = "" if behind is None else f" until {at(scene, behind.start)}, when {behind.title} begins"
        told = said(f"{'no' if about.text else 'yes'}: nothing is planned {about.time}{until}")
        return replace(told, offer=Offer(time=about.time))
    lines = [
        f"{one.title} is from {at(scene, one.start)} to {at(scene, one.end)}"
        if one.end - one.start >= SHORTEST
        else f"{one.title} is at {at(scene, one.start)}"
        for one in meeting
    ]
    whole = end is None or end - first <= SHORTEST or about.thing
    answer = "yes: " if about.text else "no: " if whole else "not all of it: "
    return reply_of(meeting, [answer + lines[0], *lines[1:MOST]])


def during(scene: Scene, about: About) -> Reply:
    """Say what there is at a time, or in a stretch of it."""
    if is_of_planned(scene, about):
        return _between(scene, about)
    time = time_of(scene, about.time)
    first, end = on_its_day(scene, about.time)
    first = scene.now if first is None else first
    # What comes after friday has no end.
    last = (
        max((one.end for one in all_planned(scene)), default=first)
        if time.constraint is Constraint.AFTER
        else first
    )
    over = end if end is not None and end > first else max(first, last) + SHORTEST
    everything = list(all_planned(_as_far_as(scene, over)))
    found = [one for one in everything if one.start < over and (one.end > first or one.start >= first)]
    if found:
        return _all_told(scene, found)
    behind = next((one for one in everything if one.start >= over), None)
    then = "" if behind is None else f"; {behind.title} is at {at(scene, behind.start)}"
    return said(f"nothing is planned then{then}")


def _between(scene: Scene, about: About) -> Reply:
    """Say what there is between two things, or else that one is free."""
    first, over = beside(scene, about)
    found = [one for one in all_planned(scene) if over is not None and first <= one.start < over]
    if found:
        return _all_told(scene, found)
    told = said(f"nothing is planned {about.thing}, from {at(scene, first)} to {at(scene, over or first)}")
    return replace(told, offer=offer_of(scene, first, over))


def _all_told(scene: Scene, found: list[Taken]) -> Reply:
    """Say when each of some things is."""
    lines = [f"{one.title}: {at(scene, one.start)} to {at(scene, one.end)}" for one in found[:MOST]]
    if len(found) > MOST:
        lines.append(f"and {len(found) - MOST} more")
    return reply_of(found, lines)


def then_of(scene: Scene, words: str) -> Reply | None:
    """Say what is planned at the time of a question that is not understood, and names nothing planned.

    None where it is no question, or has no time of its own.
    """
    found = find_times(words, scene.now, scene.lexicon).requirements
    times = [one.text for one in found if one.constraint is not Constraint.FOR]
    if not words.rstrip().endswith("?") or len(times) != 1:
        return None
    told = during(scene, About(kind=AboutKind.DURING, time=times[0]))
    return replace(told, lines=(Text(plain(f"of {times[0]!r} no more is known than the plan:")), *told.lines))


def _as_far_as(scene: Scene, end: datetime) -> Scene:
    """Give the scene with what is repeated until then, where that is further than plans show it."""
    ahead = seconds_between(scene.now, end)
    repeated = any(
        part.recurrence is not None
        for one in scene.plan.everything
        if one.instruction is not None
        for part in one.instruction.requirements
    )
    if not repeated or not WITHOUT_END < ahead < MAX_HORIZON or scene.conversation.horizon is not None:
        return scene
    further = replace(scene.conversation, horizon=ahead)
    return replace(scene, plan=further.plan(scene.now, further.state, previous=scene.plan))
