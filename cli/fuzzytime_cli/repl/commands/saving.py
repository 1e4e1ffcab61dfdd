"""Files in the conversation: what is saved, what is loaded."""

from dataclasses import replace
from pathlib import Path

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.times import WEEK, instant_after
from fuzzytime_cli.choices import PlanFormat
from fuzzytime_cli.clock import date_of
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.conversation import Conversation
from fuzzytime_cli.repl.scene import UNREAD, Reply, Scene, problem_lines, said, step
from fuzzytime_cli.repl.typed import file_named, got
from fuzzytime_cli.session import KeptBusy, State

AHEAD = 13 * WEEK
"""How far a calendar is read at least, in seconds: a conversation may go on for long."""

MOST_FAULTS = 3
"""Lines of a file that are pointed at: the rest is counted."""


def save(scene: Scene, text: str) -> Reply:
    """Write the session, or the plan in another form, to a file.

    Raises
    ------
    FuzzytimeError
        If no file is named, or one of another kind.
    """
    from fuzzytime_cli.files import replace_file
    from fuzzytime_cli.formats import written
    from fuzzytime_cli.session import state_text

    path = file_named(text)
    kind = PlanFormat.of_file(path)
    if kind is None or kind is PlanFormat.TABLE:
        exports = sorted(f".{kind}" for kind in PlanFormat if kind not in {PlanFormat.TABLE, PlanFormat.JSON})
        raise FuzzytimeError(
            "a file must follow that ends in .json (the session) "
            f"or {' '.join(exports)} (the plan){got(text)}"
        )
    session = kind is PlanFormat.JSON
    replace_file(
        path, state_text(_shared(scene.conversation)) + "\n" if session else written(scene.plan, kind)
    )
    return said(f"written: {path}")


def _shared(conversation: Conversation) -> State:
    """Give the state as others may have it: ratings stay with the person."""
    return replace(conversation.state, ratings=())


def load(scene: Scene, text: str) -> Reply:
    """Take a saved session, add a calendar's busy times, or add instructions from a file.

    Raises
    ------
    FuzzytimeError
        If no file is named, or it cannot be read.
    """
    from fuzzytime_cli.inputs.lines import wishes_of
    from fuzzytime_cli.inputs.source import read_source
    from fuzzytime_cli.inputs.task_file import is_task_file
    from fuzzytime_cli.session import state_of

    if not text.strip():
        raise FuzzytimeError("a file must follow: a saved session, a calendar (.ics), or instructions a line")
    path = file_named(text)
    if path.suffix.lower() == ".ics":
        return _load_calendar(scene, path)
    source = read_source(str(path))
    if path.suffix.lower() == ".json":
        loaded = state_of(source.text)
        return step(scene, f":load {path}", lambda state: replace(loaded, ratings=state.ratings))
    if is_task_file(source):
        raise FuzzytimeError(
            f"{path} is a task file, which fuzzytime plan and run read (here: instructions a line)"
        )
    return _load_lines(scene, path, [wish.text for wish in wishes_of(source, scene.now)])


def _load_lines(scene: Scene, path: Path, texts: list[str]) -> Reply:
    """Add the instructions that are understood; of the others, as many as fit are pointed at."""

    def added(state: State, lines: list[str]) -> State:
        for line in lines:
            state = state.with_entry(line, scene.now)
        return state

    known = scene.conversation.state
    trial = added(known, texts)
    made = scene.conversation.understanding.interpret(scene.conversation.request(scene.now, trial))
    planned = {interpreted.wish.identifier for interpreted in made.everything}
    faulty = {problem.text for problem in made.problems if problem.kind in UNREAD}
    new = trial.entries[len(known.entries) :]
    unread = [entry for entry in new if entry.identifier not in planned and entry.text in faulty]
    kept = [entry.text for entry in new if entry not in unread]
    faults = [problem for problem in made.problems if problem.text in {entry.text for entry in unread}]
    lines = [line for problem in faults[:MOST_FAULTS] for line in problem_lines(problem, scene.width)]
    if unread:
        lines.append(Text(f"{len(unread)} of {len(new)} lines are not understood, and not kept", style="red"))
    if not kept:
        return Reply(tuple(lines))
    reply = step(scene, f":load {path}", lambda state: added(state, kept))
    return replace(reply, lines=tuple(lines))


def _load_calendar(scene: Scene, path: Path) -> Reply:
    """Add the times that a calendar takes, for some months or as far as is planned."""
    from fuzzytime_cli.inputs.calendar import read_calendar

    ahead = max(AHEAD, scene.conversation.horizon or 0.0)
    taken = read_calendar(path, scene.now, ahead)
    found = tuple(
        KeptBusy(instant_after(scene.now, busy.start), instant_after(scene.now, busy.end), busy.what)
        for busy in taken.busy
    )
    known = frozenset(scene.conversation.state.busy)
    new = tuple(one for one in found if one not in known)
    again = f", {len(found) - len(new)} of them known" if len(new) < len(found) else ""
    lines = [Text(plain(sentence), style="red") for sentence in taken.unread]
    until = date_of(instant_after(scene.now, ahead))
    lines.append(Text(f"{len(found)} busy times read, until {until}{again}"))
    if not new:
        return Reply(tuple(lines))
    reply = step(scene, f":load {path}", lambda state: replace(state, busy=(*state.busy, *new)))
    return replace(reply, lines=tuple(lines))
