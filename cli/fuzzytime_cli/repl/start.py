"""The conversation on a terminal or a pipe: what reads lines, keeps the time, and writes answers."""

import io
import os
import sys
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import replace
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, TextIO

from rich.text import Text

from fuzzytime.context import Signal
from fuzzytime.errors import FuzzytimeError
from fuzzytime.times import instant_after
from fuzzytime_cli.assembly import Assembly
from fuzzytime_cli.choices import SolverChoice
from fuzzytime_cli.faults import message_of, report
from fuzzytime_cli.options import Moment, Solving, Understanding
from fuzzytime_cli.places import data_folder
from fuzzytime_cli.render import Screen, plain, terminal_width
from fuzzytime_cli.repl.conversation import Conversation
from fuzzytime_cli.repl.plain_words.retiming import IDLE
from fuzzytime_cli.repl.scene import refused
from fuzzytime_cli.repl.turn import Line, Turns
from fuzzytime_cli.session import KeptReading, NotKeptError, open_store

if TYPE_CHECKING:
    from prompt_toolkit import PromptSession

PROMPT = "› "
PLAIN_PROMPT = "> "
BEAT = 1.0
"""Seconds between two looks at the clock."""


def converse(
    session: str = "default",
    *,
    moment: Moment | None = None,
    understanding: Understanding | None = None,
    solving: Solving | None = None,
    kept: bool = True,
) -> None:
    """Hold a conversation until it is left; where input is no terminal, line by line without a prompt."""
    assembly = Assembly.of(moment or Moment(), understanding or Understanding(), solving or Solving())
    clock = _clock_of(assembly)
    folder = data_folder()
    store, trouble = open_store(folder / "sessions.sqlite" if kept and folder is not None else None)
    if trouble:
        report(f"this session is not kept: {trouble}")
    interpreter = assembly.interpreter(personal=False)
    conversation = Conversation(
        store,
        session,
        interpreter,
        lambda name: assembly.solver(SolverChoice(name) if name else None),
        assembly.limits(),
        assembly.settings.number("threshold"),
        personal=assembly.settings.flag("personal"),
        in_order=assembly.settings.flag("in_order"),
        agents=int(assembly.settings.number("agents")),
        horizon=assembly.horizon(),
        given=_given(assembly, understanding or Understanding(), clock(), interpreter.rulebook.signals),
    )
    screen = Screen.of(sys.stdout, dict(os.environ))
    turns = Turns(conversation, screen.width, unicode=screen.unicode)
    talk = Dialogue(turns, clock, screen, bell=assembly.settings.flag("bell"))
    try:
        if screen.interactive and sys.stdin is not None and sys.stdin.isatty():
            _prompted(talk, folder)
        else:
            piped(talk, sys.stdin)
    finally:
        store.close()


def _given(
    assembly: Assembly, understanding: Understanding, now: datetime, signals: Mapping[str, Signal]
) -> tuple[KeptReading, ...]:
    """Give the readings of ``--context`` and ``--ctx``, with their instants."""
    context = assembly.context(understanding, now, signals)
    return tuple(
        KeptReading(reading.signal, instant_after(now, reading.at), reading.value, reading.unit)
        for reading in context.readings
    )


def _clock_of(assembly: Assembly) -> Callable[[], datetime]:
    """Give the clock: the machine's, or one that starts at ``--now`` and goes on from there."""
    begun, first = datetime.now().astimezone(), assembly.moment()
    if assembly.now is None:
        return assembly.moment
    return lambda: instant_after(first, (datetime.now().astimezone() - begun).total_seconds())


class Dialogue:
    """Turns and the clock's beats, one at a time, written to one screen."""

    def __init__(self, turns: Turns, clock: Callable[[], datetime], screen: Screen, *, bell: bool) -> None:
        self.turns, self.clock, self.screen, self.bell = turns, clock, screen, bell
        self.unkept = False
        self.lock = threading.Lock()
        self.over = threading.Event()

    def open(self) -> None:
        """Greet."""
        with self._measured():
            self.screen.write(*self.turns.opened(self.clock()))

    def parted(self, typed: str) -> list[list[str]]:
        """Part what was typed, or pasted, at once: lines that are taken together."""
        lines = typed.splitlines()
        if len(lines) < 2:
            return [lines] if lines else []
        with self.lock:
            return self.turns.together(lines, self.clock())

    def take(self, *lines: str) -> tuple[bool, str]:
        """Answer a line, or instructions said at once; say whether to go on, and what the prompt holds."""
        with self._measured():
            try:
                now = self.clock()
                one = len(lines) == 1
                reply = self.turns.take(lines[0], now) if one else self.turns.take_together(lines, now)
            except NotKeptError as error:
                if not self.turns.asks:
                    raise
                reply = replace(refused(message_of(error)), edit="\n".join(lines))
            except Exception as error:
                # A defect of this program costs whoever types one turn, and not what they are at.
                if not self.turns.asks or os.environ.get("FUZZYTIME_DEBUG"):
                    raise
                reply = refused(message_of(error))
            self.screen.write(*reply.lines)
        return not reply.over, reply.edit

    @contextmanager
    def _measured(self) -> Iterator[None]:
        """Take the turn, on the terminal as wide as it is by now."""
        with self.lock:
            if self.screen.interactive:
                self.turns.width = terminal_width()
                self.screen = replace(self.screen, width=self.turns.width)
            yield

    def warm(self) -> None:
        """Load what reads sentences while the first one is typed, which would else wait for it."""
        with self.lock, suppress(FuzzytimeError, OSError):
            # What is wrong with it the first turn says.
            self.turns.conversation.interpreter.language.read(IDLE, now=self.clock())

    def beat(self) -> None:
        """Say what starts now; a turn that is being taken goes first."""
        if not self.lock.acquire(blocking=False):
            return
        try:
            lines = self._news()
            if lines:
                self.screen.write(*lines)
                if self.bell:
                    self.screen.stream.write("\a")
                self.screen.stream.flush()
        finally:
            self.lock.release()

    def _news(self) -> list[Line]:
        """Give what starts now; that it cannot be kept is said once."""
        try:
            lines = self.turns.tick(self.clock())
        except NotKeptError as error:
            if not self.turns.asks:
                raise
            lines = [] if self.unkept else list(refused(message_of(error)).lines)
            self.unkept = True
        else:
            self.unkept = False
        return lines


@contextmanager
def _beating(talk: Dialogue) -> Iterator[None]:
    """Look at the clock every `BEAT` seconds meanwhile."""

    def run() -> None:
        talk.warm()
        while not talk.over.wait(BEAT):
            talk.beat()

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    try:
        yield
    finally:
        talk.over.set()
        thread.join(2 * BEAT)


def _prompted(talk: Dialogue, folder: Path | None) -> None:
    """Read lines with editing, history and completion; Ctrl-C clears the line, Ctrl-D leaves."""
    from prompt_toolkit.patch_stdout import patch_stdout

    prompt = _prompt(talk, folder)
    with patch_stdout(raw=True):
        talk.screen = Screen(
            sys.stdout, talk.screen.width, talk.screen.colour, talk.screen.unicode, interactive=True
        )
        talk.turns.asks = True
        talk.open()
        going, words = True, ""
        with _beating(talk):
            while going:
                try:
                    going, words = answer_each(talk, prompt.prompt(PROMPT, default=words))
                except KeyboardInterrupt:
                    words = ""
                except EOFError:
                    return


def _prompt(talk: Dialogue, folder: Path | None) -> "PromptSession[str]":
    """Give what a line is typed into; Alt-Enter begins another line."""
    from prompt_toolkit import PromptSession
    from prompt_toolkit.history import InMemoryHistory
    from prompt_toolkit.key_binding import KeyBindings, KeyPressEvent

    from fuzzytime_cli.repl.completion import WordCompleter
    from fuzzytime_cli.repl.history import kept_history

    keys = KeyBindings()

    @keys.add("escape", "enter")
    def _(event: KeyPressEvent) -> None:
        event.current_buffer.insert_text("\n")

    return PromptSession(
        history=kept_history(folder / "history") if folder is not None else InMemoryHistory(),
        completer=WordCompleter.of_rulebook(talk.turns.conversation.interpreter.rulebook),
        complete_while_typing=False,
        key_bindings=keys,
        enable_suspend=True,
    )


def answer_each(talk: Dialogue, typed: str) -> tuple[bool, str]:
    """Answer each line of what was typed or pasted; say whether to go on, and what the prompt holds."""
    going, words = True, ""
    for lines in (parts := talk.parted(typed)):
        if len(parts) > 1:
            talk.screen.write(*(Text(plain(f"{PROMPT}{line}"), style="dim") for line in lines))
        going, words = talk.take(*lines)
        if not going:
            break
    return going, words


def piped(talk: Dialogue, stream: TextIO | None) -> None:
    """Read lines as they come, of a pipe or a plain terminal; answers follow each."""
    typed = stream is not None and stream.isatty()
    if isinstance(stream, io.TextIOWrapper):
        stream.reconfigure(errors="surrogateescape")  # a byte that is no text is shown as an escape
    talk.turns.asks = typed
    talk.open()
    for line in _lines(stream, talk.screen.stream if typed else None):
        talk.beat()
        try:
            going, words = talk.take(line)
            if typed and words:
                # No prompt here holds them: they are shown, to be typed anew.
                talk.screen.write(Text(plain(words)))
        except KeyboardInterrupt:
            if not typed:
                raise
            going = True  # whoever types stops this turn, not the conversation
        talk.screen.stream.flush()
        if not going:
            return


def _lines(stream: TextIO | None, echo: TextIO | None) -> Iterator[str]:
    """Give a stream's lines; a person on a terminal gets a prompt, and Ctrl-C begins a new line."""
    while stream is not None:
        try:
            if echo is not None:
                echo.write(PLAIN_PROMPT)
                echo.flush()
            line = stream.readline()
        except KeyboardInterrupt:
            if echo is None:
                raise
            echo.write("\n")
            continue
        if not line:
            return
        yield line
