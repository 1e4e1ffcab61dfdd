"""Errors as a terminal shows them, and the exit code of each: the one place where they are caught."""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

from fuzzytime.errors import DocumentError, FuzzytimeError, InstructionError
from fuzzytime_cli.exits import Exit
from fuzzytime_cli.render import plain, width_of


class NoInputError(FuzzytimeError):
    """The input is not there or holds nothing."""


class ConfigError(FuzzytimeError):
    """A setting or a rule table that breaks a rule."""


class UsageError(FuzzytimeError):
    """A flag that breaks a rule."""


@contextmanager
def as_config() -> Iterator[None]:
    """Count errors inside as errors of the configuration: rule tables, settings."""
    try:
        yield
    except (ConfigError, NoInputError):
        raise
    except FuzzytimeError as error:
        raise ConfigError(str(error)) from error


@contextmanager
def as_usage(flag: str) -> Iterator[None]:
    """Count errors inside as errors of a flag."""
    try:
        yield
    except FuzzytimeError as error:
        raise UsageError(f"{flag}: {error}") from error


SHOWN_AROUND = 60
"""How many characters of a text are shown on each side of the words that are pointed at."""


def underlined(text: str, span: tuple[int, int]) -> str:
    """Give a text, made harmless, with marks under the words of a span; a long one is cut around them.

    >>> print(underlined("stir it half past", (8, 17)))
        stir it half past
                ^^^^^^^^^
    """
    start, end = span
    before, words, after = plain(text[:start]), plain(text[start:end]), plain(text[end:])
    before = before if len(before) <= SHOWN_AROUND else f"…{before[-SHOWN_AROUND:]}"
    words = words if len(words) <= 2 * SHOWN_AROUND else f"{words[: 2 * SHOWN_AROUND]}…"
    after = after if len(after) <= SHOWN_AROUND else f"{after[:SHOWN_AROUND]}…"
    return f"    {before}{words}{after}\n    {' ' * width_of(before)}{'^' * max(1, width_of(words))}"


def report(message: str) -> None:
    """Write a message to standard error, made harmless line by line."""
    if sys.stderr is not None:
        lines = "\n".join(plain(line) for line in message.split("\n"))
        sys.stderr.write(lines.encode("utf-8", "backslashreplace").decode("utf-8") + "\n")


def exit_of(error: BaseException) -> Exit:
    """Report an error and give its exit code; what is no `FuzzytimeError` is this program's defect."""
    if isinstance(error, KeyboardInterrupt):
        return Exit.INTERRUPT
    if isinstance(error, BrokenPipeError):
        return Exit.CLOSED_PIPE
    if isinstance(error, InstructionError):
        report(f"fuzzytime: {error.message}\n{underlined(error.text, error.span)}")
        return Exit.BAD_DATA
    if isinstance(error, FuzzytimeError):
        report(str(error) if isinstance(error, DocumentError) else f"fuzzytime: {error}")
        return next((code for kind, code in _CODES if isinstance(error, kind)), Exit.BAD_DATA)
    if isinstance(error, OSError):
        where = f"{error.filename}: " if error.filename else ""
        report(f"fuzzytime: {where}{error.strerror or error}")
        return Exit.IO_ERROR
    if isinstance(error, MemoryError):
        report("fuzzytime: out of memory; a smaller task or a shorter horizon needs less")
        return Exit.FAILURE
    if os.environ.get("FUZZYTIME_DEBUG"):
        raise error
    kind = type(error).__name__
    report(f"fuzzytime: this should not happen ({kind}: {error}); FUZZYTIME_DEBUG=1 shows where")
    return Exit.FAILURE


_CODES: tuple[tuple[type[FuzzytimeError], Exit], ...] = (
    (NoInputError, Exit.NO_INPUT),
    (ConfigError, Exit.BAD_CONFIG),
    (UsageError, Exit.USAGE),
)
