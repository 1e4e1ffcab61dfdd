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
    Operation,
    Reading,
    about_wishes,
    added_time,
    content_words,
    reported,
    restated,
)
from fuzzytime_cli.formats.clock import Clock
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl import answering, looking
from fuzzytime_cli.repl.commands import command_of, what_if
from fuzzytime_cli.repl.naming import all_called, called, entries_meant, entry_of, running_one, unknown
from fuzzytime_cli.repl.retiming import with_time
from fuzzytime_cli.repl.scene import Reply, Scene, number_of, whole_number

HISTORY = frozenset({AboutKind.DONE, AboutKind.MORE, AboutKind.LATE})
"""What tells how it went, which :undo does not take back."""

ASKED_BACK = {
    AboutKind.WRONG: "what is meant instead? Say: no, at six (or: undo that)",
    AboutKind.UNABLE: "when then? Say: push it back by half an hour (or: make it six; forget it)",
}
"""What is answered to a protest."""


ONE_AT_A_TIME = "one at a time, such as: move the call to six; or: push everything back by an hour"


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
        return _said_anew(scene, words) if added is None else _taken(scene, added)
    names = content_words(operation.object) | {operation.lemma}
    return _taken(scene, About(kind=AboutKind.DONE, names=names, certain=True))


def _said_anew(scene: Scene, words: str) -> Reply | None:
    """Take what is said again with another time as said anew: "no, feed the dog at seven"; else give None.

    Raises
    ------
    FuzzytimeError
        If the instruction asks for more than that.
    """
    language = scene.conversation.interpreter.language
    anew = restated(words, scene.now, language.lexicon)
    if anew is None:
        return None
    reading = language.read(anew, now=scene.now, given=[one.operation for one in scene.plan.skills])
    if len(reading.instructions) != 1:
        return None
    operation, times = reading.instructions[0].operation, reading.instructions[0].requirements
    if operation is None or not times:
        return None
    same = [one for one in scene.plan.skills if one.reading and _is_same(one.operation, operation)]
    same.sort(key=lambda one: number_of(one.identifier) == scene.focus)
    if not same:
        return None
    old, number = same[-1], number_of(same[-1].identifier)
    several = old.reading is not None and len(old.reading.instructions) > 1
    own = old.instruction.requirements if old.instruction is not None else ()
    named = (operation.object or "").lower() in anew.lower()
    if several or not named or len(own) > len(times):
        # The rest of its words stays, and where it stands "them" is nothing: "no, put them out at seven".
        moved = About(kind=AboutKind.MOVE, time=times[0].text)
        anew = with_time(scene, scene.conversation.state.entry(number), moved, own)
    return _run(scene, AboutKind.MOVE, f":edit {number} {anew}")


def _is_same(one: Operation | None, other: Operation) -> bool:
    """Whether two operations do the same with the same, in one place as far as the second tells."""
    if one is None or (one.lemma, one.negated) != (other.lemma, other.negated):
        return False
    places = content_words(other.place) in (frozenset(), content_words(one.place))
    return places and content_words(one.object) == content_words(other.object)


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
    line = _command(scene, about)
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


def _command(scene: Scene, about: About) -> str | None:
    """Give the command that is meant, as it would be typed."""
    match about.kind:
        case AboutKind.UNDO | AboutKind.REDO:
            return f":{about.kind.value}"
        case AboutKind.DONE | AboutKind.MORE:
            return _progress(scene, about)
        case AboutKind.LATE:
            return _late(scene, about)
        case AboutKind.SWAP:
            return _swap(scene, about)
        case AboutKind.UNSTARTED:
            return _unstarted(scene, about)
    return _changing(scene, about)


def _changing(scene: Scene, about: About) -> str | None:
    """Give the command that drops, moves or delays what is meant."""
    if about.everything and about.kind is AboutKind.MOVE:
        raise FuzzytimeError(ONE_AT_A_TIME)
    if about.everything:
        return _dropping_all(scene, about) if about.kind is AboutKind.DROP else f":delay all {_length(about)}"
    if about.corrects and scene.told_last is not None:
        scene = replace(scene, focus=scene.told_last)
    meant = entries_meant(scene, about)
    if not meant:
        return unknown(about.names) if about.certain else None
    if about.text and about.text in content_words(meant[-1].text):
        return None
    numbers = ",".join(str(entry.number) for entry in meant)
    match about.kind:
        case AboutKind.DROP:
            return f":drop {numbers}"
        case AboutKind.DELAY:
            return f":delay {numbers} {_length(about)}"
        case _ if len(meant) == 1:
            return f":edit {numbers} {with_time(scene, meant[0], about)}"
    raise FuzzytimeError(ONE_AT_A_TIME)


def _dropping_all(scene: Scene, about: About) -> str:
    """Give the command that drops everything, but for what is named."""
    if not about.names:
        return ":drop all"
    kept = entries_meant(scene, replace(about, several=True)) or unknown(about.names)
    left = [str(entry.number) for entry in scene.conversation.state.entries if entry not in kept]
    if not left:
        raise FuzzytimeError("nothing else is asked for")
    return f":drop {','.join(left)}"


def _length(about: About) -> str:
    """Give by how much, as a command takes it.

    Raises
    ------
    FuzzytimeError
        If that is not said.
    """
    if about.by is None:
        raise FuzzytimeError("by how much? Say: push it back by ten minutes (or: make it half past six)")
    return _seconds(about.by)


def _seconds(length: float) -> str:
    whole, rest = divmod(abs(length), 60.0)
    return f"{'-' if length < 0 else ''}{f'{whole:g}min' if not rest else f'{abs(length):g}s'}"


def _progress(scene: Scene, about: About) -> str | None:
    """Give the command that says how a skill goes: one that is running, or that need not start any more."""
    longer = about.kind is AboutKind.MORE

    def line(identifier: str) -> str:
        return f":more {identifier} {_length(about)}" if longer else f":done {identifier}"

    one = running_one(scene, about.names)
    if one is not None:
        return line(one.identifier)
    last = next(reversed(all_called(scene, about.names)), None)
    if last is not None and longer:
        return line(last.identifier)
    over = "" if last is None else Clock(scene.now, with_seconds=False).at(last.done)
    if not about.names:
        told = "" if last is None else f"; the last, {last.name}, was done at {over}"
        raise FuzzytimeError(f"nothing is running{told}: say what, such as: the soup is done")
    entry = entry_of(scene, about.names)
    planned = None if entry is None else called(scene, entry.number)
    if planned is not None:
        return None if longer and not about.certain else line(planned)
    if last is not None:
        raise FuzzytimeError(f"{last.name} was done at {over}")
    return unknown(about.names) if about.certain else None


def _unstarted(scene: Scene, about: About) -> str:
    """Give the command that plans anew what was taken to have started.

    Raises
    ------
    FuzzytimeError
        If nothing that is meant has started, or which of several is not said.
    """
    one = running_one(scene, about.names)
    if one is None:
        entry = entry_of(scene, about.names)
        planned = None if entry is None else called(scene, entry.number)
        raise FuzzytimeError(
            f"{planned} is still planned" if planned and about.names else "nothing is running"
        )
    number = number_of(one.identifier)
    text = next(entry.text for entry in scene.conversation.state.entries if entry.number == number)
    return f":edit {number} {text}"


def _late(scene: Scene, about: About) -> str:
    """Give the command that keeps who is late from everything for so long."""
    if about.by is None:
        raise FuzzytimeError(
            "by how much? Say: I'm ten minutes late (nothing starts before then), "
            "or: push everything back by ten minutes"
        )
    busy = [one for one in scene.conversation.running(scene.now) if one.end > scene.now]
    if len(busy) == 1:
        return f":more {busy[0].identifier} {_seconds(about.by)}"
    from fuzzytime.times import instant_after

    until = instant_after(scene.now, about.by)
    day = "" if until.date() == scene.now.date() else f"{until:%Y-%m-%d}T"
    return f":busy {scene.now:%H:%M:%S} {day}{until:%H:%M:%S} late"


def _swap(scene: Scene, about: About) -> str | None:
    if about.both:
        left = [one for one in scene.conversation.state.entries if called(scene, one.number) is not None]
        if len(left) != 2:
            raise FuzzytimeError("which two? Say: swap the call and the soup")
        return f":swap {left[0].number} {left[1].number}"
    found = [entry_of(scene, names) for names in (about.names, about.others)]
    if found[0] is None and found[1] is None:
        return None
    for entry, names in zip(found, (about.names, about.others), strict=True):
        if entry is None:
            return unknown(names)
    return f":swap {' '.join(str(entry.number) for entry in found if entry is not None)}"


def _supposed(scene: Scene, text: str) -> Reply:
    """Show what would come of it: a wish, or what is said of those there are."""
    about = about_wishes(text, scene.now, scene.conversation.interpreter.language.lexicon)
    line = None if about is None or about.text else _supposable(scene, about)
    return what_if(scene, line or text)


def _supposable(scene: Scene, about: About) -> str | None:
    changing = {AboutKind.DROP, AboutKind.MOVE, AboutKind.DELAY, AboutKind.SWAP, AboutKind.LATE}
    return _command(scene, about) if about.kind in changing else None
