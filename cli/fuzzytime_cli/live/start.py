"""A run put together: plan, clock, sources of news, whoever does the skills, and where events go."""

import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from fuzzytime.interpreter import Interpreter, Request
from fuzzytime.scheduling import Limits, Solver
from fuzzytime.times import MINUTE
from fuzzytime_cli.choices import RunFormat
from fuzzytime_cli.exits import Exit
from fuzzytime_cli.faults import NoInputError
from fuzzytime_cli.live.clock import Clock, MachineClock, SimulatedClock
from fuzzytime_cli.live.dispatcher import Dispatcher
from fuzzytime_cli.live.display import Display, EventLines, EventScreen
from fuzzytime_cli.live.events import Began
from fuzzytime_cli.live.feeds import CHUNK, follow_into, play, read_into, reader_of
from fuzzytime_cli.live.inbox import Inbox, Stop
from fuzzytime_cli.live.ledger import Phase
from fuzzytime_cli.live.loop import carry_out
from fuzzytime_cli.live.messages import Listener
from fuzzytime_cli.live.outlook import Outlook
from fuzzytime_cli.live.pace import Pace
from fuzzytime_cli.live.planning import Planning, Solving
from fuzzytime_cli.live.programs import Command, Programs, Rehearsal
from fuzzytime_cli.live.progress import Ends, Executor, Nobody, Progress
from fuzzytime_cli.render import Screen

LIMIT_FACTOR = 3.0
"""A command may take so many times as long as planned, where no limit is given."""

LIMIT_LEAST = MINUTE
"""And at least so many seconds."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Settings:
    """How to run.

    Parameters
    ----------
    speed
        Seconds of the run in one of the machine's; None to simulate.
    command
        What does the skills; None where events are all.
    limit
        Seconds after which a command is killed; None for `LIMIT_FACTOR` times what was planned.
    by_word
        Whether a skill goes on until somebody says that it is done.
    stay
        Whether to wait for instructions when all is done.
    follow
        A file that lines are read from, instead of standard input.
    listen
        Whether to read standard input.
    """

    speed: float | None = 1.0
    command: Command | None = None
    limit: float | None = None
    by_word: bool = False
    stay: bool = False
    follow: Path | None = None
    listen: bool = True

    def limit_of(self, planned: float) -> float:
        """Give the seconds that a command may take."""
        return self.limit if self.limit is not None else max(LIMIT_LEAST, LIMIT_FACTOR * planned)

    @property
    def ends(self) -> Ends:
        """How the end of a skill is known; a rehearsed command takes as long as planned."""
        if self.by_word:
            return Ends.BY_WORD
        return Ends.BY_COMMAND if self.command is not None and self.speed is not None else Ends.BY_PLAN


def run(
    request: Request,
    interpreter: Interpreter,
    solver: Solver,
    threshold: float,
    limits: Limits,
    settings: Settings,
    output_format: RunFormat | None,
) -> Exit:
    """Carry out a request in time, telling what happens on standard output."""
    inbox = Inbox()
    executor = _executor(request, settings, inbox)
    display = _display(request, output_format)
    listener = Listener(request.now, interpreter.rulebook.signals)
    with _stoppable(inbox) as stopped, _listening(inbox, listener, settings):
        planning = Planning(
            request, interpreter, Solving(solver, threshold, replace(limits, stopped=stopped))
        )
        pace, reasons = Pace.at(settings.speed or 1.0), ["the run begins"]
        dispatcher = Dispatcher(
            Outlook(planning, pace, reasons),
            Progress(executor, settings.ends, pace, reasons, settings.limit_of),
        )
        began = Began(
            at=0.0,
            now=request.now.isoformat(),
            speed=settings.speed,
            agents=request.agents,
            threshold=threshold,
            ends=settings.ends.value,
        )
        display.tell(began)
        clock: Clock = SimulatedClock() if settings.speed is None else MachineClock(settings.speed)
        try:
            ended = carry_out(dispatcher, clock, inbox, listener, display.tell, stay=settings.stay)
        finally:
            if isinstance(executor, Programs):
                executor.close()
    if not ended:
        return Exit.INTERRUPT
    return _exit_of(dispatcher)


def _executor(request: Request, settings: Settings, inbox: Inbox) -> Executor:
    """Give whoever does the skills: a simulation only says what would be done."""
    if settings.command is None:
        return Nobody()
    if settings.speed is None:
        return Rehearsal(settings.command, request.now)
    return Programs(settings.command, request.now, inbox)


def _exit_of(dispatcher: Dispatcher) -> Exit:
    """Give bad data where nothing could be read, and failure where something that started failed."""
    if not dispatcher.ledger.tasks and not dispatcher.outlook.without_time and dispatcher.outlook.told:
        return Exit.BAD_DATA
    return Exit.FAILURE if dispatcher.ledger.in_phase(Phase.FAILED) else Exit.FINE


def _display(request: Request, output_format: RunFormat | None) -> Display:
    screen = Screen.of(sys.stdout, dict(os.environ))
    if output_format is RunFormat.TEXT or (output_format is None and sys.stdout.isatty()):
        return EventScreen(screen, request.now)
    return EventLines(sys.stdout, request.now)


@contextmanager
def _stoppable(inbox: Inbox) -> Iterator[Callable[[], bool]]:
    """Take Ctrl-C and the wish to terminate as news, once; a second time ends the program as ever.

    Gives what says whether it was wished.
    """
    wished = threading.Event()

    def stop(number: int, frame: object) -> None:
        del number, frame
        signal.signal(signal.SIGINT, signal.default_int_handler)
        wished.set()
        inbox.put(Stop())

    before = {number: signal.signal(number, stop) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield wished.is_set
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


@contextmanager
def _listening(inbox: Inbox, listener: Listener, settings: Settings) -> Iterator[None]:
    """Let lines come in: all at once in a simulation, else by threads until the run is over."""
    over = threading.Event()
    simulated = settings.speed is None
    if settings.follow is not None and settings.follow.is_dir():
        raise NoInputError(f"{settings.follow}: what is followed must be a file, and it is a folder")
    try:
        if settings.follow is not None and simulated:
            _play_file(inbox, settings.follow, listener)
        elif settings.follow is not None:
            follow_into(inbox, settings.follow, over)
        elif settings.listen and simulated:
            play(inbox, "<stdin>", reader_of(sys.stdin), listener)
        elif settings.listen:
            read_into(inbox, "<stdin>", reader_of(sys.stdin))
        yield
    finally:
        over.set()


def _play_file(inbox: Inbox, path: Path, listener: Listener) -> None:
    try:
        with path.open("rb") as recording:
            play(inbox, str(path), lambda: recording.read(CHUNK), listener)
    except FileNotFoundError as error:
        raise NoInputError(f"{path}: there is no such file") from error
