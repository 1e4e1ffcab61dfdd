"""What is typed behind a command: numbers of instructions, and files."""

from pathlib import Path

from fuzzytime.errors import FuzzytimeError

MOST_REPEATED = 40
"""Characters that are repeated of what was typed where something else should have been."""

MOST_DIGITS = 9
"""Of a number that somebody types."""

QUOTES = "\"'"
"""What may stand around the name of a file."""


def got(text: str) -> str:
    """Repeat, behind what should have been said, what was; nothing where nothing was."""
    words = text.strip()
    return f", got {words[:MOST_REPEATED]!r}" if words else ""


def whole_number(text: str) -> int | None:
    """Read a whole number that somebody may have meant; None where it is none.

    >>> whole_number(" 12 "), whole_number("²"), whole_number("9" * 5000)
    (12, None, None)
    """
    digits = text.strip()
    return int(digits) if digits.isdecimal() and len(digits) <= MOST_DIGITS else None


def number_of(text: str) -> int:
    """Read an instruction's number.

    Raises
    ------
    FuzzytimeError
        If it is none.
    """
    digits = text.strip().removeprefix("s").partition(".")[0]
    number = whole_number(digits)
    if number is None:
        raise FuzzytimeError(f"a number from the list must follow, such as 2{got(text)}")
    return number


def several_numbers(text: str) -> list[int]:
    """Read the numbers of several instructions: "1,3", "1 3"; none where it is not several.

    Raises
    ------
    FuzzytimeError
        If one of them is none.
    """
    if "," in text:
        return [number_of(part) for part in text.split(",")]
    parts = text.split()
    numbered = len(parts) > 1 and all(whole_number(part.removeprefix("s")) is not None for part in parts)
    return [number_of(part) for part in parts] if numbered else []


def number_and_rest(text: str, what: str) -> tuple[int, str]:
    """Read an instruction's number, and what follows it.

    Raises
    ------
    FuzzytimeError
        If one of them is missing.
    """
    first, _, rest = text.strip().partition(" ")
    if not rest.strip():
        raise FuzzytimeError(f"a number and {what} must follow{got(text)}")
    return number_of(first), rest.strip()


def file_named(text: str) -> Path:
    """Give the file that a command names; quotes around its name are none of it, as in a shell."""
    name = text.strip()
    quoted = len(name) > 1 and name[0] == name[-1] and name[0] in QUOTES
    return Path(name[1:-1] if quoted else name).expanduser()
