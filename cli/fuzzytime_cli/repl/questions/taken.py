"""What is running or planned, as stretches of time that are taken."""

from collections.abc import Iterator
from dataclasses import dataclass
from datetime import datetime, timedelta

from rich.text import Text

from fuzzytime_cli.clock import Clock
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.scene import Reply, Scene, waiting
from fuzzytime_cli.repl.typed import number_of

SHORTEST = timedelta(minutes=1)
"""Below this a gap is none."""


@dataclass(frozen=True, slots=True)
class Taken:
    """A stretch in which hands or who speaks are taken, and by what."""

    start: datetime
    end: datetime
    identifier: str
    name: str

    @property
    def title(self) -> str:
        """What it is called."""
        return plain(f"{self.identifier} {self.name}".strip())

    @property
    def number(self) -> int | None:
        """The number of the instruction that asks for it; None for a busy time."""
        return number_of(self.identifier) if self.identifier else None


def all_taken(scene: Scene) -> list[Taken]:
    """Give what takes hands, or who speaks, as it comes."""
    busy = [
        Taken(kept.start, kept.end, "", kept.what or "a busy time")
        for kept in scene.conversation.state.busy
        if kept.end > scene.now
    ]
    return sorted(
        [*(one for one in all_planned(scene) if one.end - one.start >= SHORTEST), *busy],
        key=lambda one: (one.start, one.end),
    )


def all_planned(scene: Scene) -> Iterator[Taken]:
    """Give all that is running or planned, as it comes."""
    schedule = scene.plan.schedule
    found = [
        Taken(one.start, until, one.identifier, one.name)
        for one in scene.conversation.running(scene.now)
        if (until := one.done if one.happens else one.end) > scene.now
    ]
    for place, one in waiting(scene):
        if scene.plan.has_time(place):
            planned = schedule.skills[place]
            # What one attends keeps nobody's hands, and yet who speaks.
            over = planned.done if one.stated else planned.end
            start, end = scene.plan.instant(planned.start), scene.plan.instant(over)
            found.append(Taken(start, end, one.identifier, one.skill.name))
    yield from sorted(found, key=lambda one: (one.start, one.end))


def reply_of(found: list[Taken], lines: list[str]) -> Reply:
    """Answer with what is taken; the first of it was spoken of then."""
    focus = next((one.number for one in found if one.identifier), None)
    return Reply(tuple(Text(line) for line in lines), focus=focus)


def at(scene: Scene, instant: datetime) -> str:
    """Give when something is, to the minute."""
    return Clock.to_minutes(scene.now).of((instant - scene.now).total_seconds())
