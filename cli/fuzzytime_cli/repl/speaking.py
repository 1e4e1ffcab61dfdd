"""Plain words about what was asked for already, taken as the commands that they mean."""

from collections.abc import Sequence
from dataclasses import replace
from datetime import datetime

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import (
    About,
    AboutKind,
    Language,
    Reading,
    about_wishes,
    added_time,
    content_words,
    reported,
)
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl import answering, looking
from fuzzytime_cli.repl.commands import command_of, what_if
from fuzzytime_cli.repl.meant import command_meant
from fuzzytime_cli.repl.retiming import said_anew
from fuzzytime_cli.repl.scene import Reply, Scene, whole_number

HISTORY = frozenset({AboutKind.DONE, AboutKind.MORE, AboutKind.LATE})
"""What tells how it went, which :undo does not take back."""

ASKED_BACK = {
    AboutKind.WRONG: "what is meant instead? Say: no, at six (or: undo that)",
    AboutKind.UNABLE: "when then? Say: push it back by half an hour (or: make it six; forget it)",
}
"""What is answered to a protest."""


def are_about(language: Language, lines: Sequence[str], now: datetime) -> list[bool]:
    """Tell of each line whether it is, or may be, about wishes that were said before.

    Raises
    ------
    InstructionError
        If a line is too long.
    """
    readings = language.read_independent([(line, now) for line in lines])
    return [
        about_wishes(line, now, language.lexicon) is not None or bool(reported(reading, language.lexicon))
        for line, reading in zip(lines, readings, strict=True)
    ]


def reply_about(scene: Scene, words: str) -> Reply | None:
    """Answer what is said about wishes that were said before; None where the words are a wish themselves.

    Raises
    ------
    FuzzytimeError
        If nothing that is known can be meant, or which of several is not said.
    """
    about = about_wishes(words, scene.now, scene.conversation.interpreter.language.lexicon)
    if about is None:
        return _told(scene, words)
    match about.kind:
        case AboutKind.NEXT | AboutKind.ANSWER:
            return answering.coming(scene)
        case AboutKind.ALL:
            return looking.show_list(scene, "")
        case AboutKind.CLOCK:
            return looking.now(scene, "")
        case AboutKind.WHEN:
            return answering.when(scene, about)
        case AboutKind.LASTING:
            return answering.lasting(scene, about)
        case AboutKind.WHY:
            return answering.why(scene, about)
        case AboutKind.SUPPOSE:
            return _supposed(scene, about.text)
        case _:
            return _taken(scene, about)


def _told(scene: Scene, words: str) -> Reply | None:
    """Take what somebody tells to have done as done: "I've fed the cat"; None where nothing is told.

    Raises
    ------
    FuzzytimeError
        If nothing that is known was done.
    """
    language = scene.conversation.interpreter.language
    reading = language.read(words, now=scene.now)
    operation = reported(reading, language.lexicon)
    if operation is None:
        _check_labels(scene, reading)
        added = added_time(words, scene.now, language.lexicon)
        if added is not None:
            return _taken(scene, added)
        anew = said_anew(scene, words)
        return None if anew is None else _run(scene, AboutKind.MOVE, anew)
    names = content_words(operation.object) | {operation.lemma}
    return _taken(scene, About(kind=AboutKind.DONE, names=names, certain=True))


def _check_labels(scene: Scene, reading: Reading) -> None:
    """Refuse to make a wish of what names another by its label: "start s2", "s2 at eight".

    Raises
    ------
    FuzzytimeError
        If something is to be done with a label, or begins with one.
    """
    labels = {entry.identifier for entry in scene.conversation.state.entries}
    objects = (one.operation.object for one in reading.instructions if one.operation is not None)
    for said in (reading.text.partition(" ")[0], *objects):
        if said in labels:
            raise FuzzytimeError(
                f"{said} was asked for already, and this is not understood of it; say: move {said} to six, "
                f"push {said} back by ten minutes, drop {said}, {said} is done, why {said}"
            )


def _taken(scene: Scene, about: About) -> Reply | None:
    """Run the command that is meant; None where the words may be a wish of their own."""
    if about.kind in ASKED_BACK:
        raise FuzzytimeError(ASKED_BACK[about.kind])
    line = command_meant(scene, about)
    if line is None:
        return None
    return _run(scene, about.kind, line)


def _run(scene: Scene, kind: AboutKind, line: str) -> Reply:
    """Run a command, and say which."""
    command, rest = command_of(line)
    number = rest.partition(" ")[0].partition(".")[0].lstrip("s")
    numbers = rest.partition(" ")[0].split(",")
    dropped = "; ".join(_text_of(scene, one) for one in numbers) if kind is AboutKind.DROP else ""
    reply = command.run(scene, rest)
    focus = whole_number(number) if kind is not AboutKind.DROP else None
    if not (reply.changed or scene.tried is not None):
        return replace(reply, focus=focus)
    if kind in {AboutKind.UNDO, AboutKind.REDO}:
        return reply
    back = "" if kind in HISTORY and not line.startswith(":busy") else "; :undo takes it back"
    head = Text(plain(f"taken as {line}{f' ({dropped})' if dropped else ''}{back}"))
    return replace(reply, lines=(head, *reply.lines), focus=focus)


def _text_of(scene: Scene, number: str) -> str:
    return next((one.text for one in scene.conversation.state.entries if str(one.number) == number), "")


def _supposed(scene: Scene, text: str) -> Reply:
    """Show what would come of it: a wish, or what is said of those there are."""
    about = about_wishes(text, scene.now, scene.conversation.interpreter.language.lexicon)
    line = None if about is None or about.text else _supposable(scene, about)
    return what_if(scene, line or text)


def _supposable(scene: Scene, about: About) -> str | None:
    changing = {AboutKind.DROP, AboutKind.MOVE, AboutKind.DELAY, AboutKind.SWAP, AboutKind.LATE}
    return command_meant(scene, about) if about.kind in changing else None
