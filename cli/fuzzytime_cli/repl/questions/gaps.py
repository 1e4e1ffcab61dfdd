"""Questions about what there is at some time, and where there is room: "am I free at six?"."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from datetime import datetime, timedelta

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import MAX_HORIZON, WITHOUT_END
from fuzzytime.language import About, without_article
from fuzzytime.requirement import Constraint
from fuzzytime.times import format_duration, seconds_between
from fuzzytime_cli.clock import Clock
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.naming import entry_of, part_meant, unknown
from fuzzytime_cli.repl.questions.stretches import bounds_of, on_its_day, time_of
from fuzzytime_cli.repl.scene import Reply, Scene, said, waiting
from fuzzytime_cli.repl.typed import number_of

MOST = 5
"""How many things, or gaps, are told at most."""

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


def free(scene: Scene, about: About) -> Reply:
    """Say whether one is free at a time, for as long as something takes; or when one is."""
    if not about.time:
        return _gaps_told(scene, scene.now)
    time = time_of(scene, about.time)
    first, end = bounds_of(scene, time)
    if first is None:
        # "Can I fit in a run before lunch?"
        return room(scene, about) if about.thing else _gaps_told(scene, scene.now)
    scene = _as_far_as(scene, end or first)
    length = _length_of(scene, about.thing)[0] if about.thing else timedelta(0)
    window = end if end is not None and end > first else first + max(length, SHORTEST)
    if about.thing and time.constraint is Constraint.AT:
        window = first + max(length, SHORTEST)
    short = [one for one in _all(scene) if one.end - one.start < SHORTEST]
    everything = sorted([*_taken(scene), *short], key=lambda one: one.start)
    meeting = [one for one in everything if one.start < window and max(one.end, one.start + SHORTEST) > first]
    if not meeting:
        behind = next((one for one in _taken(scene) if one.start >= window), None)
        until = "" if behind is None else f" until {_at(scene, behind.start)}, when {behind.title} begins"
        return said(f"{'no' if about.text else 'yes'}: nothing is planned {about.time}{until}")
    lines = [
        f"{one.title} is from {_at(scene, one.start)} to {_at(scene, one.end)}"
        if one.end - one.start >= SHORTEST
        else f"{one.title} is at {_at(scene, one.start)}"
        for one in meeting
    ]
    whole = end is None or end - first <= SHORTEST or about.thing
    answer = "yes: " if about.text else "no: " if whole else "not all of it: "
    return _reply(meeting, [answer + lines[0], *lines[1:MOST]])


def room(scene: Scene, about: About) -> Reply:
    """Say whether something fits in before a time, or before something else."""
    length, assumed = _length_of(scene, about.thing) if about.thing else (SHORTEST, False)
    since, until = scene.now, None
    if about.names:
        entry = entry_of(scene, about.names) or unknown(about.names)
        schedule = scene.plan.schedule
        part = part_meant(scene, entry.number, about.names)
        mine = [
            place
            for place, one in waiting(scene, entry.number)
            if scene.plan.has_time(place) and part in {None, one.identifier}
        ]
        if not mine:
            raise FuzzytimeError("when that is, is not planned")
        instants = [scene.plan.instant(schedule.start_times[place]) for place in mine]
        ends = [scene.plan.instant(schedule.skills[place].end) for place in mine]
        since, until = (max(since, min(ends)), None) if about.joint == "after" else (since, min(instants))
    elif about.time:
        time = time_of(scene, about.time)
        first, end = bounds_of(scene, time)
        if time.constraint is Constraint.BEFORE or time.preposition in {"by", "before"}:
            until = end or first
        elif first is not None:
            since, until = max(since, first), end if end is not None and end > first else first + length
    if not about.thing:
        return _gaps_told(scene, since, until)
    what = f"{about.thing} ({_long(length)}{', assumed' if assumed else ''})"
    for begin, over in _gaps(scene, since, until):
        if over is None or over - begin >= length:
            return said(f"yes: {what} fits in at {_at(scene, begin)}{_until(scene, over)}")
    limit = "" if until is None else f" before {_at(scene, until)}"
    return said(f"no: {what} does not fit in{limit}")


def during(scene: Scene, about: About) -> Reply:
    """Say what there is at a time, or in a stretch of it."""
    time = time_of(scene, about.time)
    first, end = on_its_day(scene, about.time)
    first = scene.now if first is None else first
    # What comes after friday has no end.
    last = (
        max((one.end for one in _all(scene)), default=first) if time.constraint is Constraint.AFTER else first
    )
    over = end if end is not None and end > first else max(first, last) + SHORTEST
    everything = list(_all(_as_far_as(scene, over)))
    found = [one for one in everything if one.start < over and (one.end > first or one.start >= first)]
    if found:
        lines = [f"{one.title}: {_at(scene, one.start)} to {_at(scene, one.end)}" for one in found[:MOST]]
        if len(found) > MOST:
            lines.append(f"and {len(found) - MOST} more")
        return _reply(found, lines)
    behind = next((one for one in everything if one.start >= over), None)
    then = "" if behind is None else f"; {behind.title} is at {_at(scene, behind.start)}"
    return said(f"nothing is planned then{then}")


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


def _gaps_told(scene: Scene, since: datetime, until: datetime | None = None) -> Reply:
    """Say when one is free from some time on, until another or until the day's last thing is over."""
    if not _taken(scene) and until is None and since <= scene.now:
        return said("free all the time: nothing is planned")
    gaps = list(_gaps(scene, since, until))
    if not gaps:
        return said("not free then")
    told = [
        f"from {_at(scene, begin)} on" if over is None else f"from {_at(scene, begin)} to {_at(scene, over)}"
        for begin, over in gaps
    ]
    kept = [*told[: MOST - 1], *told[-1:]] if len(told) > MOST else told
    return said(f"free {', '.join(kept)}")


def _gaps(
    scene: Scene, since: datetime, until: datetime | None
) -> Iterator[tuple[datetime, datetime | None]]:
    """Give the stretches in which nothing is planned; the last has no end where none is given."""
    begin = since
    for one in _taken(scene):
        if until is not None and one.start >= until:
            break
        if one.start - begin >= SHORTEST:
            yield begin, one.start
        begin = max(begin, one.end)
    if until is None or until - begin >= SHORTEST:
        yield begin, until


def _taken(scene: Scene) -> list[Taken]:
    """Give what takes hands, or who speaks, as it comes."""
    busy = [
        Taken(kept.start, kept.end, "", kept.what or "a busy time")
        for kept in scene.conversation.state.busy
        if kept.end > scene.now
    ]
    return sorted(
        [*(one for one in _all(scene) if one.end - one.start >= SHORTEST), *busy],
        key=lambda one: (one.start, one.end),
    )


def _all(scene: Scene) -> Iterator[Taken]:
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


def _length_of(scene: Scene, thing: str) -> tuple[timedelta, bool]:
    """Give how long something takes, and whether that is assumed: "a nap", "call mum"."""
    words = without_article(thing, scene.lexicon)
    for text in (words, f"have {words}"):
        trial = scene.conversation.state.with_entries([text], scene.now)
        made = scene.conversation.understood(scene.now, trial)
        name = trial.entries[-1].identifier
        own = [one for one in made.everything if one.wish.identifier == name and one.skill.duration > 0]
        if own:
            return timedelta(seconds=own[-1].skill.duration), own[-1].duration.assumed
    return SHORTEST, True


def _reply(found: list[Taken], lines: list[str]) -> Reply:
    focus = next((number_of(one.identifier) for one in found if one.identifier), None)
    return Reply(tuple(Text(line) for line in lines), focus=focus)


def _long(length: timedelta) -> str:
    return format_duration(length.total_seconds())


def _at(scene: Scene, instant: datetime) -> str:
    return Clock.to_minutes(scene.now).of((instant - scene.now).total_seconds())


def _until(scene: Scene, over: datetime | None) -> str:
    return "" if over is None else f", with room until {_at(scene, over)}"
