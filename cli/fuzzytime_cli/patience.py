"""What is shown on a terminal's standard error once something takes a while, and taken back at its end."""

import os
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager

AFTER = 0.5
"""Seconds after which somebody wants to know that something is going on."""


def can_show() -> bool:
    """Say whether standard error is a terminal on which something can be taken back."""
    return sys.stderr is not None and sys.stderr.isatty() and os.environ.get("TERM") != "dumb"


@contextmanager
def after_a_while(start: Callable[[], None], stop: Callable[[], None]) -> Iterator[None]:
    """Start what is shown if the block takes longer than `AFTER`, and stop it in any case."""
    timer = threading.Timer(AFTER, start)
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
        timer.join()
        stop()


@contextmanager
def told(words: str) -> Iterator[None]:
    """Say on a terminal what goes on meanwhile: "planning 1,000 instructions"."""
    if not can_show():
        yield
        return
    with ExitStack() as shown:

        def start() -> None:
            from rich.console import Console

            console = Console(stderr=True, markup=False, highlight=False, emoji=False)
            shown.enter_context(console.status(f"{words} …"))

        with after_a_while(start, shown.close):
            yield
