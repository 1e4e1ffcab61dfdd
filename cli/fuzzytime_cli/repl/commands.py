"""The commands of the conversation: each a function of what was typed, the conversation, and the moment."""

import textwrap
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import Plan
from fuzzytime.times import instant_after, parse_duration
from fuzzytime_cli.choices import SolverChoice
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl import saving
from fuzzytime_cli.repl.conversation import moves
from fuzzytime_cli.repl.scene import (
    Reply,
    Scene,
    identifier_of,
    number_and_rest,
    number_of,
    position_of,
    said,
    step,
)
from fuzzytime_cli.session import KeptBusy, KeptReading

Run = Callable[[Scene, str], Reply]


@dataclass(frozen=True, slots=True)
class Command:
    """A command: what it takes, what it does in a sentence, and the function."""

    usage: str
    help: str
    run: Run


# -- looking ------------------------------------------------------------------------------------------------


def _list(scene: Scene, _: str) -> Reply:
    from fuzzytime_cli.formats.table import PlanView

    entries = scene.conversation.state.entries
    given = [f"{entry.number:>3}  {entry.given:%H:%M}  {plain(entry.text)}" for entry in entries]
    running = [
        Text(f"running: {one.identifier} {plain(one.name)}, until {one.done:%H:%M:%S}", style="bold")
        for one in scene.conversation.running(scene.now)
    ]
    return Reply((*running, *PlanView(scene.plan, scene.width, unicode=scene.unicode).lines(), "", *given))


def _why(scene: Scene, text: str) -> Reply:
    from fuzzytime_cli.explaining import explanation_lines

    position = position_of(scene, text)
    return Reply(tuple(explanation_lines(scene.plan, position, scene.width, unicode=scene.unicode)))


def _what_if(scene: Scene, text: str) -> Reply:
    from fuzzytime_cli.formats.table import PlanView

    if not text.strip():
        raise FuzzytimeError("an instruction must follow, such as: :what-if call mum at noon")
    state = scene.conversation.state.with_entry(text.strip(), scene.now)
    made = scene.conversation.plan(scene.now, state)
    lines: list[Text | str] = [Text("If you asked for that:", style="bold")]
    lines += PlanView(made, scene.width, unicode=scene.unicode).lines()
    lines += move_lines(scene.plan, made)
    before, after = scene.plan.schedule.geometric_mean, made.schedule.geometric_mean
    lines.append(f"average satisfaction {before:.2f} → {after:.2f}; nothing is changed")
    return Reply(tuple(lines))


def move_lines(before: Plan | None, after: Plan, started: set[str] | None = None) -> list[str]:
    """Say what moved between two plans."""
    lines = []
    for move in moves(before, after, started or set()):
        ends = [
            instant.strftime("%H:%M:%S") if instant is not None else ""
            for instant in (move.before, move.after)
        ]
        name = f"{plain(move.identifier)} {plain(move.name)}"
        if not ends[1]:
            lines.append(f"lost its place: {name}")
        elif not ends[0]:
            lines.append(f"found a place: {name} at {ends[1]}")
        else:
            lines.append(f"moved: {name} from {ends[0]} to {ends[1]}")
    return lines


def _plot(scene: Scene, text: str) -> Reply:
    from fuzzytime_cli.drawing.svg import chart_svg
    from fuzzytime_cli.drawing.terminal import chart_lines
    from fuzzytime_cli.explaining import chart_of
    from fuzzytime_cli.files import replace_file
    from fuzzytime_cli.formats.picture import plan_svg

    which, _, file = text.strip().partition(" ")
    if which.endswith(".svg"):
        replace_file(Path(which), plan_svg(scene.plan))
        return said(f"written: {which}")
    position = position_of(scene, which)
    interpreted = scene.plan.skills[position]
    chart = chart_of(interpreted, scene.plan, position)
    if file.strip():
        replace_file(Path(file.strip()), chart_svg(chart, interpreted.skill.name))
        return said(f"written: {file.strip()}")
    return Reply(tuple(chart_lines(chart, scene.width, unicode=scene.unicode)))


def _now(scene: Scene, _: str) -> Reply:
    return said(
        f"{scene.now:%A %d %B %Y, %H:%M:%S}" + (f" ({scene.now.tzname()})" if scene.now.tzinfo else "")
    )


def _help(scene: Scene, _: str) -> Reply:
    rows: list[str] = []
    for command in COMMANDS.values():
        beginning = f"  :{command.usage:<26} "
        rows += textwrap.wrap(
            command.help,
            max(scene.width, 2 * len(beginning)),
            initial_indent=beginning,
            subsequent_indent=" " * len(beginning),
        )
    head = textwrap.wrap(
        "Type what you want done and when: flip the pancakes in about two minutes.", scene.width
    )
    return Reply((*head, "", *rows))


# -- changing -----------------------------------------------------------------------------------------------


def _drop(scene: Scene, text: str) -> Reply:
    number = number_of(text)
    return step(scene, f":drop {number}", lambda state: state.without(number))


def _edit(scene: Scene, text: str) -> Reply:
    first, _, rest = text.strip().partition(" ")
    number = number_of(first)
    if not rest.strip():
        return Reply(edit=f":edit {number} {scene.conversation.state.entry(number).text}")
    words = rest.strip()
    return step(
        scene, f":edit {number}", lambda state: state.with_changed(number, text=words, given=scene.now)
    )


def _duration(scene: Scene, text: str) -> Reply:
    number, rest = number_and_rest(text, "a duration, such as 4min,")
    seconds = parse_duration(rest)
    if seconds < 0:
        raise FuzzytimeError(f"a duration must be at least 0, got {rest!r}")
    return step(
        scene,
        f":duration {number}",
        lambda state: state.with_changed(number, hands_on=seconds, elapsed=seconds),
    )


def _priority(scene: Scene, text: str) -> Reply:
    number, rest = number_and_rest(text, "a weight, such as 2,")
    try:
        weight = float(rest)
    except ValueError as error:
        raise FuzzytimeError(f"a priority must be a number, got {rest!r}") from error
    if not 1e-3 <= weight <= 1e3:
        raise FuzzytimeError(f"a priority must be between 0.001 and 1000, got {rest!r}")
    return step(scene, f":priority {number}", lambda state: state.with_changed(number, priority=weight))


def _done(scene: Scene, text: str) -> Reply:
    wanted = identifier_of(text)
    running = {one.identifier: one for one in scene.conversation.running(scene.now)}
    if wanted in running:
        scene.conversation.store.note_done(scene.conversation.name, wanted, scene.now)
        return Reply((Text(f"done: {plain(running[wanted].name)}"),), changed=True)
    position = position_of(scene, text)
    number = number_of(scene.plan.skills[position].identifier)
    reply = step(scene, f":done {number}", lambda state: state.without(number))
    return replace(reply, lines=(Text(f"done: {plain(scene.plan.skills[position].skill.name)}"),))


def _ctx(scene: Scene, text: str) -> Reply:
    from fuzzytime.context import parse_assignment

    signals = scene.conversation.interpreter.rulebook.signals
    if not text.strip():
        shown = tuple(_reading_line(one) for one in scene.conversation.state.readings)
        return Reply(shown or ("no readings yet; signals: " + ", ".join(sorted(signals)),))
    reading = parse_assignment(text.strip(), signals)
    kept = KeptReading(reading.signal, instant_after(scene.now, reading.at), reading.value, reading.unit)
    return step(scene, f":ctx {text.strip()}", lambda state: replace(state, readings=(*state.readings, kept)))


def _reading_line(kept: KeptReading) -> str:
    value = "happened" if kept.value is None else f"{kept.value:g} {kept.unit or ''}".rstrip()
    return f"{plain(kept.signal):<18} {plain(value):<12} at {kept.at:%H:%M:%S}"


def _agents(scene: Scene, text: str) -> Reply:
    if not text.strip().isdigit() or not 1 <= int(text) <= 100:
        raise FuzzytimeError(f"agents must be a number from 1 to 100, got {text.strip()!r}")
    return step(scene, f":agents {int(text)}", lambda state: replace(state, agents=int(text)))


def _solver(scene: Scene, text: str) -> Reply:
    name = text.strip()
    if name not in set(SolverChoice):
        raise FuzzytimeError(f"a solver must be one of {', '.join(SolverChoice)}, got {name!r}")
    return step(scene, f":solver {name}", lambda state: replace(state, solver=name))


def _busy(scene: Scene, text: str) -> Reply:
    from fuzzytime_cli.inputs.surroundings import moment_of

    parts = text.split(maxsplit=2)
    if len(parts) < 2:
        raise FuzzytimeError("two times must follow, such as: :busy 12:00 13:00 lunch")
    start, end = (instant_after(scene.now, moment_of(part, scene.now)) for part in parts[:2])
    if end <= start:
        raise FuzzytimeError(f"a busy time must not end before it starts, got {parts[0]} to {parts[1]}")
    kept = KeptBusy(start, end, parts[2] if len(parts) > 2 else "")
    return step(scene, f":busy {text.strip()}", lambda state: replace(state, busy=(*state.busy, kept)))


def _rate(scene: Scene, text: str) -> Reply:
    from fuzzytime_cli.repl.rating import rate

    return rate(scene, text)


def _undo(scene: Scene, _: str) -> Reply:
    what = scene.conversation.store.undo(scene.conversation.name)
    return (
        Reply((Text(f"undone: {plain(what)}"),), changed=True) if what else said("there is nothing to undo")
    )


def _redo(scene: Scene, _: str) -> Reply:
    what = scene.conversation.store.redo(scene.conversation.name)
    return (
        Reply((Text(f"done again: {plain(what)}"),), changed=True)
        if what
        else said("there is nothing to redo")
    )


def _quit(_: Scene, __: str) -> Reply:
    return Reply(over=True)


COMMANDS: Mapping[str, Command] = {
    "list": Command("list", "the schedule, and what you asked for", _list),
    "why": Command("why N", "explain skill N: words, rules, satisfaction, and why then", _why),
    "what-if": Command("what-if TEXT", "what would move if you asked for that too", _what_if),
    "edit": Command("edit N [TEXT]", "say instruction N anew", _edit),
    "drop": Command("drop N", "forget instruction N", _drop),
    "done": Command("done N", "skill N is done", _done),
    "undo": Command("undo", "take the last step back", _undo),
    "redo": Command("redo", "take an undone step again", _redo),
    "duration": Command("duration N 4min", "how long instruction N takes", _duration),
    "priority": Command("priority N 2", "how much instruction N counts", _priority),
    "ctx": Command("ctx [pan_temp=180]", "a reading now; alone: the readings", _ctx),
    "busy": Command("busy 12:00 13:00 lunch", "a time that is taken", _busy),
    "agents": Command("agents 2", "how many can work at once", _agents),
    "solver": Command("solver NAME", "the method that finds the schedule", _solver),
    "rate": Command("rate [N 1-5|too late]", "how a start was, for later plans; alone: your ratings", _rate),
    "plot": Command("plot N [FILE.svg]", "draw the satisfaction of skill N; FILE.svg alone: the plan", _plot),
    "save": Command("save FILE", ".json the session; .ics .csv .html .svg .jsonl the plan", saving.save),
    "load": Command("load FILE", "a saved session, a calendar, or instructions a line", saving.load),
    "now": Command("now", "the moment", _now),
    "help": Command("help", "this list", _help),
    "quit": Command("quit", "leave; everything is kept", _quit),
}
"""Every command by its name."""


BARE = {"help": ":help", "?": ":help", "quit": ":quit", "exit": ":quit"}
"""Words that people type to a prompt, and mean as commands, though they lack the colon."""


def command_of(line: str) -> tuple[Command, str]:
    """Find the command of a line that starts with ``:`` or ``/``, and what follows it.

    An unambiguous beginning of a name will do.

    Raises
    ------
    FuzzytimeError
        If there is no such command.
    """
    from fuzzytime.spelling import suggestion

    name, _, rest = line[1:].strip().partition(" ")
    matching = [key for key in COMMANDS if key.startswith(name.lower())] if name else []
    if name.lower() in COMMANDS:
        return COMMANDS[name.lower()], rest
    if len(matching) == 1:
        return COMMANDS[matching[0]], rest
    raise FuzzytimeError(
        f"there is no command {name!r}{suggestion(name, matching or COMMANDS)}; :help lists them"
    )
