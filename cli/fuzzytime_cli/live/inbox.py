"""What comes in during a run: at once from other threads, or held until its time."""

import heapq
import itertools
import math
from dataclasses import dataclass, field
from queue import Empty, SimpleQueue
from threading import BoundedSemaphore

from fuzzytime_cli.live.messages import Message, Said

MOST_UNREAD = 10_000
"""Lines that wait to be looked at; whoever writes more waits."""

MOST_HELD = 200_000
"""Messages whose time is still to come."""


@dataclass(frozen=True, slots=True)
class Line:
    """A line as it came, with its place for messages about it."""

    place: str
    text: bytes


@dataclass(frozen=True, slots=True)
class Closed:
    """A source of lines has ended."""

    source: str


@dataclass(frozen=True, slots=True)
class Outcome:
    """A command has ended; ``trouble`` says why it failed, and is empty where it did not."""

    identifier: str
    exit_code: int | None = None
    trouble: str = ""


@dataclass(frozen=True, slots=True)
class Output:
    """A line that a command wrote."""

    identifier: str
    text: str


@dataclass(frozen=True, slots=True)
class Stop:
    """Somebody wishes to stop, by Ctrl-C or a signal."""


Arrival = Line | Closed | Outcome | Output | Stop | Message


@dataclass(slots=True)
class Inbox:
    """Arrivals in their order. Any thread, and a signal's handler, may `put`; one thread does the rest."""

    sources: set[str] = field(default_factory=set)
    _queue: "SimpleQueue[Arrival]" = field(default_factory=SimpleQueue)
    _room: BoundedSemaphore = field(default_factory=lambda: BoundedSemaphore(MOST_UNREAD))
    _first: list[Arrival] = field(default_factory=list)
    _held: list[tuple[float, int, Arrival]] = field(default_factory=list)
    _numbers: "itertools.count[int]" = field(default_factory=itertools.count)

    def put(self, arrival: Arrival) -> None:
        """Add what has just come; lines wait until there is room for them."""
        if isinstance(arrival, Line | Output):
            self._room.acquire()
        self._queue.put(arrival)

    def hold(self, until: float, arrival: Arrival) -> bool:
        """Keep what comes at a later time, and say whether there was room; at one time the order stays."""
        if len(self._held) >= MOST_HELD:
            return False
        heapq.heappush(self._held, (until, next(self._numbers), arrival))
        return True

    def wait(self, seconds: float) -> None:
        """Wait until something has come, or some seconds have passed."""
        try:
            self._first.append(self._queue.get(timeout=seconds) if seconds > 0 else self._queue.get_nowait())
        except Empty:
            return

    def take(self, now: float) -> list[Arrival]:
        """Give what has come, and what was held until now."""
        arrivals, self._first = self._first, []
        while len(arrivals) < MOST_UNREAD:
            try:
                arrivals.append(self._queue.get_nowait())
            except Empty:
                break
        for arrival in arrivals:
            if isinstance(arrival, Line | Output):
                self._room.release()
            elif isinstance(arrival, Closed):
                self.sources.discard(arrival.source)
        while self._held and self._held[0][0] <= now:
            arrivals.append(heapq.heappop(self._held)[2])
        return arrivals

    @property
    def next_time(self) -> float:
        """When the next that is held is due."""
        return self._held[0][0] if self._held else math.inf

    @property
    def is_open(self) -> bool:
        """Whether something may still come."""
        return bool(self.sources or self._held or self._first)

    @property
    def holds_instructions(self) -> bool:
        """Whether an instruction waits for its time."""
        return any(isinstance(arrival, Said) for _, _, arrival in self._held)
