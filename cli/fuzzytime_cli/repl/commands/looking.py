"""Commands of the conversation that look: they show, draw and explain, and change nothing."""

from collections import Counter
from dataclasses import replace
from datetime import datetime

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import Plan
from fuzzytime.times import seconds_between
from fuzzytime_cli.clock import Clock, date_of
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.compared import Move, lengths_of, moves, news_of
from fuzzytime_cli.repl.naming import identifier_meant
from fuzzytime_cli.repl.scene import Reply, Scene, position_of, running_lines, said
from fuzzytime_cli.repl.typed import file_named
from fuzzytime_cli.session import Started, State

MINUTE = 60.0
SVG = ".svg"


def show_list(scene: Scene, _: str) -> Reply:
    """Show the schedule, and what was asked for."""
    from fuzzytime_cli.formats.table import PlanView

    entries = scene.conversation.state.entries
    clock = Clock(scene.now, with_seconds=False)
    given = [f"{entry.number:>3}  {clock.at(entry.given)}  {plain(entry.text)}" for entry in entries]
    running = running_lines(scene.conversation, scene.now)
    return Reply((*running, *PlanView(scene.plan, scene.width, unicode=scene.unicode).lines(), "", *given))


def why(scene: Scene, text: str) -> Reply:
    """Explain a skill."""
    from fuzzytime_cli.explaining import explanation_lines

    position = position_of(scene, identifier_meant(scene, text))
    return Reply(tuple(explanation_lines(scene.plan, position, scene.width, unicode=scene.unicode)))


def what_would_move(scene: Scene, head: str, state: State) -> Reply:
    """Show the schedule that another state would have, and what moves; nothing is changed."""
    from fuzzytime_cli.formats.table import PlanView

    made = scene.conversation.plan(scene.now, state)
    lines: list[Text | str] = [Text(head, style="bold")]
    untold = tuple(problem for problem in made.problems if problem not in scene.plan.problems)
    view = PlanView(replace(made, problems=untold), scene.width, unicode=scene.unicode)
    lines += view.brief(news_of(scene.plan, made), lengths_of(scene.plan, made))
    lines += move_lines(scene.plan, made)
    before, after = scene.plan.schedule.geometric_mean, made.schedule.geometric_mean
    lines.append(f"average satisfaction {before:.2f} → {after:.2f}; nothing is changed")
    return Reply(tuple(lines))


def move_lines(before: Plan | None, after: Plan, started: set[str] | None = None) -> list[str]:
    """Say what moved between two plans, and what was told not to happen."""
    started = started or set()
    lines = _cancelled_lines(before, after, started)
    found = moves(before, after, started)
    several = Counter(_repeated(move) for move in found)
    told = set[tuple[str, bool, bool]]()
    for move in found:
        repeated = _repeated(move)
        if repeated in told:
            continue
        told.add(repeated)
        ends = _ends(move, after.request.now)
        name = f"{plain(move.identifier)} {plain(move.name)}"
        if not ends[1]:
            lines.append(f"lost its place: {name}")
        elif not ends[0]:
            lines.append(f"found a place: {name} at {ends[1]}")
        else:
            lines.append(f"moved: {name} from {ends[0]} to {ends[1]}")
        if several[repeated] > 1:
            lines[-1] += f", and {several[repeated] - 1} more like it"
    return lines


def _cancelled_lines(before: Plan | None, after: Plan, started: set[str]) -> list[str]:
    """Say what was told to happen between two plans, and is told not to any more."""
    told = {wish.identifier: wish for wish in after.request.wishes}
    known = {one.identifier for one in after.everything} | started
    return [
        f"will not happen: {plain(one.identifier)} {plain(one.skill.name)}"
        for one in (() if before is None else before.everything)
        if one.stated and one.identifier not in known and told.get(one.wish.identifier) == one.wish
    ]


def _repeated(move: Move) -> tuple[str, bool, bool]:
    """Give what moves of one thing that is done again and again have in common."""
    return f"{move.identifier.partition('.')[0]} {move.name}", move.before is None, move.after is None


def _ends(move: Move, now: datetime) -> list[str]:
    """Give where a skill was and is, as finely as the two differ; empty where it was or is not planned."""
    instants = [instant for instant in (move.before, move.after) if instant is not None]
    apart = abs(seconds_between(instants[0], instants[-1]))
    clock = Clock(now, with_seconds=True) if 0 < apart < MINUTE else Clock.to_minutes(now)
    return [
        "" if instant is None else clock.of(seconds_between(now, instant))
        for instant in (move.before, move.after)
    ]


def start_line(started: Started) -> Text:
    """Announce a start, or that something happens."""
    what = "now" if started.happens else "start now"
    line = f"{started.start:%H:%M:%S}  {what}: {plain(started.name)} ({plain(started.identifier)})"
    return Text(line, style="bold green")


def plot(scene: Scene, text: str) -> Reply:
    """Draw the satisfaction of a skill on the screen or into a file, or the plan into a file."""
    from fuzzytime_cli.drawing.svg import chart_svg
    from fuzzytime_cli.drawing.terminal import chart_lines
    from fuzzytime_cli.explaining import chart_of
    from fuzzytime_cli.files import replace_file
    from fuzzytime_cli.formats.picture import plan_svg

    which, _, file = text.strip().partition(" ")
    if which.lower().endswith(SVG):
        path = file_named(which)
        replace_file(path, plan_svg(scene.plan))
        return said(f"written: {path}")
    position = position_of(scene, which)
    interpreted = scene.plan.everything[position]
    chart = chart_of(interpreted, scene.plan, position)
    if file.strip():
        path = file_named(file)
        if path.suffix.lower() != SVG:
            raise FuzzytimeError(f"a picture's file must end in {SVG}, got {file.strip()!r}")
        replace_file(path, chart_svg(chart, interpreted.skill.name))
        return said(f"written: {path}")
    reasons = [resolution.reason for resolution in interpreted.resolutions if resolution.reason]
    why_none = [Text(f"no start satisfies: {plain(reason)}", style="yellow") for reason in reasons]
    return Reply((*chart_lines(chart, scene.width, unicode=scene.unicode), *why_none))


def now(scene: Scene, _: str) -> Reply:
    """Say the moment."""
    return said(
        f"{date_of(scene.now)}, {scene.now:%H:%M:%S}"
        + (f" ({scene.now.tzname()})" if scene.now.tzinfo else "")
    )
