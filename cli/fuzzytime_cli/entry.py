"""Where the command begins: whatever takes time to import is imported where Ctrl-C is no error."""

import gc
import signal
import sys
import threading
from contextlib import suppress

INTERRUPTED = 130
"""`Exit.INTERRUPT`, before anything is imported."""

SELDOM = 200_000
"""New objects after which Python looks for circles that nobody refers to any more."""

AGAIN = 0.02
"""Seconds after which a Ctrl-C comes again that came where nothing can be stopped."""


def main() -> None:
    """Run the command as the shell does; end quietly if somebody stops it before it has begun."""
    try:
        sys.unraisablehook = interrupt_again
        # Most of what a short command makes stays until its end: looking through it every 700 objects, and
        # once more on the way out, takes a fifth of its time.
        gc.set_threshold(SELDOM)
        from fuzzytime_cli.app import main as command

        command()
    except KeyboardInterrupt:
        raise SystemExit(INTERRUPTED) from None


def interrupt_again(ignored: "sys.UnraisableHookArgs") -> None:
    """Send a Ctrl-C again that came while something was tidied away: there Python would only print it."""
    if not issubclass(ignored.exc_type, KeyboardInterrupt):
        sys.__unraisablehook__(ignored)
        return
    timer = threading.Timer(AGAIN, _interrupt)
    timer.daemon = True
    with suppress(RuntimeError):  # at the very end no thread begins any more
        timer.start()


def _interrupt() -> None:
    """Send a Ctrl-C to the main thread, so that what it waits for ends at once."""
    if sys.platform == "win32":
        signal.raise_signal(signal.SIGINT)
    else:
        signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT)
