"""Where lines come from: standard input and followed files, read by threads; recordings, read at once."""

import io
import os
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TextIO

from fuzzytime.context.lines import LONGEST_LINE
from fuzzytime_cli.live.inbox import Closed, Inbox, Line
from fuzzytime_cli.live.messages import Listener

CHUNK = 1 << 16
POLL = 0.1
"""Seconds between two looks at a followed file."""

Read = Callable[[], bytes]


def lines_of(read: Read) -> Iterator[bytes]:
    """Split what is read into lines; of one that is too long only as much as shows that it is."""
    pending = b""
    while chunk := read():
        *whole, pending = (pending + chunk).split(b"\n")
        yield from (line[: LONGEST_LINE + 1] for line in whole)
        pending = pending[: LONGEST_LINE + 1]
    if pending:
        yield pending


def reader_of(stream: TextIO) -> Read:
    """Give what reads a stream as it comes, past its buffer where there is a file below.

    A thread that waits inside Python's buffer would keep the program from ending.
    """
    try:
        descriptor = stream.fileno()
    except (OSError, ValueError, io.UnsupportedOperation):
        return lambda: stream.buffer.read(CHUNK)
    return lambda: os.read(descriptor, CHUNK)


def read_into(inbox: Inbox, source: str, read: Read) -> None:
    """Put lines into the inbox from a thread, as they come."""
    inbox.sources.add(source)

    def run() -> None:
        try:
            for number, line in enumerate(lines_of(read), 1):
                inbox.put(Line(f"{source}:{number}", line))
        finally:
            inbox.put(Closed(source))

    threading.Thread(target=run, name=f"lines of {source}", daemon=True).start()


def follow_into(inbox: Inbox, path: Path, over: threading.Event) -> None:
    """Put lines into the inbox as they are written to a file: what it holds already, and what is added.

    A file that is not there yet is waited for; one that was replaced or cut is read from its beginning.
    """
    read_into(inbox, str(path), _Tail(path, over).read)


class _Tail:
    """A file that others write to."""

    def __init__(self, path: Path, over: threading.Event) -> None:
        self.path, self.over = path, over
        self.stream: io.FileIO | None = None

    def read(self) -> bytes:
        """Wait until there is more, and give it; nothing once all is over."""
        while not self.over.is_set():
            try:
                if chunk := self._more():
                    return chunk
            except OSError:
                self._close()  # not there, or not now
            self.over.wait(POLL)
        self._close()
        return b""

    def _more(self) -> bytes:
        if self.stream is None:
            self.stream = io.FileIO(self.path)
        if chunk := self.stream.read(CHUNK):
            return chunk
        now, then = self.path.stat(), os.fstat(self.stream.fileno())
        if (now.st_ino, now.st_dev) != (then.st_ino, then.st_dev):
            self._close()
        elif now.st_size < self.stream.tell():
            self.stream.seek(0)
        return b""

    def _close(self) -> None:
        if self.stream is not None:
            self.stream.close()
            self.stream = None


def play(inbox: Inbox, source: str, read: Read, listener: Listener) -> None:
    """Hold all lines of a recording, each until its time; one without a time comes with the line before."""
    time = 0.0
    for number, line in enumerate(lines_of(read), 1):
        message = listener.heard(line, f"{source}:{number}", time)
        if message is None:
            continue
        # Lines need not be in order; what is announced comes with the line before.
        time = max(0.0, min(message.at, message.comes))
        if not inbox.hold(time, message):
            return
