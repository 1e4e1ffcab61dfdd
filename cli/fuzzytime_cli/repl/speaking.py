"""Plain words about what was asked for already, taken as the commands that they mean."""

from dataclasses import replace

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import About, AboutKind, about_wishes, content_words
from fuzzytime.requirement import Constraint
from fuzzytime.times import format_duration
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl import changing, looking
from fuzzytime_cli.repl.scene import Reply, Scene, said
from fuzzytime_cli.session import Entry

MOST = 5
"""How many occurrences a question is answered with."""


def reply_about(scene: Scene, words: str) -> Reply | None:
    """Answer what is said about wishes that were said before; None where the words are a wish themselves.

    Raises
    ------
    FuzzytimeError
        If what is meant has several times, and which one to change is not said.
    """
    about = about_wishes(words, scene.now, scene.conversation.interpreter.language.lexicon)
    if about is None:
        return None
    match about.kind:
        case AboutKind.NEXT:
            return _next(scene)
        case AboutKind.ALL:
            return looking.show_list(scene, "")
        case AboutKind.WHEN:
            return _when(scene, about.names)
        case _:
            return _changed(scene, about)


def _changed(scene: Scene, about: About) -> Reply | None:
    """Drop or change the entry that is meant; None where none is."""
    entry = _entry(scene, about.names)
    if entry is None:
        return None
    if about.kind is AboutKind.DROP:
        reply, taken = changing.drop(scene, str(entry.number)), f":drop {entry.number} ({entry.text})"
    else:
        text = _with_time(scene, entry, about.time)
        reply, taken = changing.edit(scene, f"{entry.number} {text}"), f":edit {entry.number} {text}"
    return replace(reply, lines=(Text(plain(f"taken as {taken}; :undo takes it back")), *reply.lines))


def _entry(scene: Scene, names: frozenset[str]) -> Entry | None:
    """Give the latest entry that all of some words name, or the latest."""
    called: dict[str, frozenset[str]] = {}
    for interpreted in scene.plan.skills:
        name = interpreted.wish.identifier
        called[name] = called.get(name, frozenset()) | content_words(interpreted.skill.name)
    entries = scene.conversation.state.entries[::-1]
    own = (entry for entry in entries if names <= content_words(entry.text))
    # "It" in its words is what it is called by.
    by_name = (e for e in entries if names <= called.get(f"s{e.number}", frozenset()) | content_words(e.text))
    return next(own, None) or next(by_name, None)


def _with_time(scene: Scene, entry: Entry, time: str) -> str:
    """Give an entry's words with another time, or length, in place of its own."""
    length = time.lower().startswith("for ")
    reading = scene.conversation.interpreter.language.read(entry.text, now=entry.given)
    parts = [part for one in reading.instructions for part in one.requirements]
    mine = [part for part in parts if (part.constraint is Constraint.FOR) is length]
    if len(mine) > 1 or any(part.constraint is Constraint.EVERY for part in mine):
        raise FuzzytimeError(f"instruction {entry.number} has several times: say it anew, with :edit")
    if not mine:
        return f"{entry.text.rstrip('.! ')} {time}"
    first, end = mine[0].span
    return f"{entry.text[:first]}{time}{entry.text[end:]}"


def _next(scene: Scene) -> Reply:
    """Say what is going on, and what comes next."""
    lines = [
        Text(f"running: {plain(one.identifier)} {plain(one.name)}, until {one.done:%H:%M:%S}")
        for one in scene.conversation.running(scene.now)
    ]
    coming = sorted(
        (start, position)
        for position, start in enumerate(scene.plan.schedule.start_times)
        if not scene.plan.schedule.rejected[position]
    )
    lines += [_start(scene, position) for _, position in coming[:1]]
    return Reply(tuple(lines)) if lines else said("nothing is planned")


def _when(scene: Scene, names: frozenset[str]) -> Reply:
    """Say when that is planned which all of some words name."""
    schedule = scene.plan.schedule
    found = [
        position
        for position, interpreted in enumerate(scene.plan.skills)
        if names <= content_words(interpreted.skill.name)
    ]
    found.sort(key=lambda position: (schedule.rejected[position], schedule.start_times[position]))
    lines = [_start(scene, position) for position in found[:MOST]]
    if len(found) > MOST:
        lines.append(Text(f"and {len(found) - MOST} more times"))
    return (
        Reply(tuple(lines)) if lines else said(f"nothing that is planned is about {' '.join(sorted(names))}")
    )


def _start(scene: Scene, position: int) -> Text:
    interpreted, schedule = scene.plan.skills[position], scene.plan.schedule
    name = f"{plain(interpreted.identifier)} {plain(interpreted.skill.name)}"
    if schedule.rejected[position]:
        return Text(f"{name}: rejected (:why {plain(interpreted.identifier)} tells)")
    start = schedule.start_times[position]
    day = "" if scene.plan.instant(start).date() == scene.now.date() else f"{scene.plan.instant(start):%a} "
    return Text(f"{name}: at {day}{scene.plan.instant(start):%H:%M}, in {format_duration(max(0.0, start))}")
