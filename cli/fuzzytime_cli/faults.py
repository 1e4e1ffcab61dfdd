"""Errors as a terminal shows them, and the exit code of each: the one place where they are caught."""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

from fuzzytime.errors import DocumentError, FuzzytimeError, InstructionError
from fuzzytime_cli.exits import Exit
from fuzzytime_cli.render import fitted, plain, terminal_width, width_of


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


def underlined(text: str, span: tuple[int, int], width: int | None = None) -> str:
    """Give a text, made harmless, with marks under the words of a span; a long one is cut around them.

    Parameters
    ----------
    text, span
        A text, and the first and one past last of its characters that are pointed at.
    width
        Columns that there are; None for those of the terminal that shows errors, if there is one.

    >>> print(underlined("stir it half past", (8, 17)))
        stir it half past
                ^^^^^^^^^
    >>> print(underlined("stir it half past, and then serve the soup", (8, 17), 28))
        …ir it half past, and …
               ^^^^^^^^^
    """
    start, end = span
    before, words, after = plain(text[:start]), plain(text[start:end]), plain(text[end:])
    room = max(24, width or _width_of_errors()) - 4
    words = _cut(words, min(2 * SHOWN_AROUND, room))
    around = min(SHOWN_AROUND, max(0, room - width_of(words)) // 2)
    if width_of(before) + width_of(words) + width_of(after) > room or around == SHOWN_AROUND:
        before, after = _cut(before[::-1], around)[::-1], _cut(after, around)
    return f"    {before}{words}{after}\n    {' ' * width_of(before)}{'^' * max(1, width_of(words))}"


def _cut(text: str, width: int) -> str:
    return text if width_of(text) <= width else fitted(text, width)


def _width_of_errors() -> int:
    """Give the columns of the terminal that shows errors; elsewhere there is room."""
    shown = sys.stderr is not None and sys.stderr.isatty()
    return terminal_width() if shown else 4 * SHOWN_AROUND + 4


def report(message: str) -> None:
    """Write a message to standard error, made harmless line by line."""
    if sys.stderr is not None:
        lines = "\n".join(plain(line) for line in message.split("\n"))
        sys.stderr.write(lines.encode("utf-8", "backslashreplace").decode("utf-8") + "\n")


def exit_of(error: BaseException) -> Exit:
    """Report an error and give its exit code."""
    if isinstance(error, KeyboardInterrupt | BrokenPipeError):
        return code_of(error)  # whoever stopped it, or went away, knows
    if code_of(error) is Exit.FAILURE and _was_stopped(error):
        return Exit.INTERRUPT
    if isinstance(error, InstructionError):
        report(f"fuzzytime: {error.message}\n{underlined(error.text, error.span)}")
        return code_of(error)
    if code_of(error) is Exit.FAILURE and os.environ.get("FUZZYTIME_DEBUG"):
        raise error
    placed = isinstance(error, DocumentError) or isinstance(error.__cause__, DocumentError)
    report(message_of(error) if placed else f"fuzzytime: {message_of(error)}")
    return code_of(error)


def _was_stopped(error: BaseException) -> bool:
    """Whether an error comes of Ctrl-C: Python gives it another name where a class is being made."""
    behind = error.__cause__ or error.__context__
    return behind is not None and (isinstance(behind, KeyboardInterrupt) or _was_stopped(behind))


def message_of(error: BaseException) -> str:
    """Say what an error is; what is no `FuzzytimeError` is this program's defect."""
    match error:
        case InstructionError():
            return error.message
        case FuzzytimeError():
            return str(error)
        case OSError():
            return (
                f"{error.filename}: {error.strerror or error}"
                if error.filename
                else str(error.strerror or error)
            )
        case MemoryError():
            return "out of memory; a smaller task or a shorter horizon needs less"
        case _:
            kind = type(error).__name__
            return f"this should not happen ({kind}: {error}); FUZZYTIME_DEBUG=1 shows where"


def code_of(error: BaseException) -> Exit:
    """Give the exit code of an error."""
    return next((code for kind, code in _CODES if isinstance(error, kind)), Exit.FAILURE)


_CODES: tuple[tuple[type[BaseException], Exit], ...] = (
    (KeyboardInterrupt, Exit.INTERRUPT),
    (BrokenPipeError, Exit.CLOSED_PIPE),
    (NoInputError, Exit.NO_INPUT),
    (ConfigError, Exit.BAD_CONFIG),
    (UsageError, Exit.USAGE),
    (FuzzytimeError, Exit.BAD_DATA),
    (OSError, Exit.IO_ERROR),
)
