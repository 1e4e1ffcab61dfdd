"""Errors as a terminal shows them, and the exit code of each: the one place where they are caught."""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

from fuzzytime.errors import DocumentError, FuzzytimeError, InstructionError
from fuzzytime_cli.exits import Exit
from fuzzytime_cli.render import plain


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


def underlined(text: str, span: tuple[int, int]) -> str:
    """Give a text, made harmless, with marks under the words of a span."""
    start, end = span
    before, words = plain(text[:start]), plain(text[start:end])
    return f"    {before}{words}{plain(text[end:])}\n    {' ' * len(before)}{'^' * max(1, len(words))}"


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
