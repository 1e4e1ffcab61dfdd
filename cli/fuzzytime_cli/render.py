"""What reaches a person's terminal: text made harmless, in columns, with colour only where it is wanted."""

import unicodedata
from dataclasses import dataclass
from typing import TYPE_CHECKING, TextIO

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.console import Console
    from rich.text import Text


# Marks that reorder or hide text; the joiners of emoji and scripts (U+200C, U+200D) stay.
_INVISIBLE = frozenset("\u00ad\u061c\u180e\u200b\u200e\u200f\u2028\u2029\u2060\ufeff")
_REORDERING = frozenset(map(chr, (*range(0x202A, 0x202F), *range(0x2066, 0x206A))))


def plain(text: str) -> str:
    r"""Make text harmless: every control, reordering and unprintable character becomes an escape to read.

    >>> print(plain("stir \x1b[31mred\x07"))
    stir \x1b[31mred\x07
    """
    if text.isascii() and text.isprintable():
        return text
    return "".join(map(_harmless, text))


def _harmless(character: str) -> str:
    category = unicodedata.category(character)
    unsafe = category in {"Cc", "Cs", "Co", "Cn", "Zl", "Zp"}
    if (
        unsafe
        or character in _INVISIBLE
        or character in _REORDERING
        or "\U000e0000" <= character <= "\U000e007f"
    ):
        return character.encode("unicode_escape").decode("ascii")
    return character


def width_of(text: str) -> int:
    """Count the terminal columns of harmless text: wide characters take two, combining ones none."""
    if text.isascii():
        return len(text)
    return sum(_columns(character) for character in text)


def _columns(character: str) -> int:
    if unicodedata.combining(character) or character in "\u200c\u200d\ufe0e\ufe0f":
        return 0
    return 2 if unicodedata.east_asian_width(character) in "WF" else 1


def fitted(text: str, width: int) -> str:
    """Cut or fill harmless text to exactly ``width`` columns; what is cut ends in an ellipsis."""
    if width_of(text) <= width:
        return text + " " * (width - width_of(text))
    kept, used = [], 0
    for character in text:
        columns = _columns(character)
        if used + columns > width - 1:
            break
        kept.append(character)
        used += columns
    return "".join(kept) + "…" * (width > 0) + " " * (width - 1 - used)


def wrapped(line: str, width: int, indent: int | None = None) -> list[str]:
    """Break a line of harmless text between words where it is too long; a word that is too long stays whole.

    What follows is indented by ``indent`` columns; if that is not given, by two more than the line itself.

    >>> wrapped("  moved: stir the soup", 16)
    ['  moved: stir', '    the soup']
    """
    begin = _beginning(line, indent)
    first, *others = _lines_of(line, width, len(begin))
    return [line[first], *(begin + line[piece] for piece in others)]


def wrapped_text(line: "Text", width: int, indent: int | None = None) -> "list[Text]":
    """Break a styled line as `wrapped` does a plain one."""
    begin = line.blank_copy(_beginning(line.plain, indent))
    first, *others = _lines_of(line.plain, width, len(begin))
    return [line[first], *(begin + line[piece] for piece in others)]


def _beginning(text: str, indent: int | None) -> str:
    """Give what the second line and those after it begin with."""
    return " " * (len(text) - len(text.lstrip(" ")) + 2 if indent is None else indent)


def _lines_of(text: str, width: int, indent: int) -> list[slice]:
    """Give which part of a text each line has: ``width`` columns the first, less the indent the others."""
    own = len(text) - len(text.lstrip(" "))
    pieces, start, room = [], 0, width
    while width_of(text[start:]) > room:
        end = _break(text, max(start, own), start, room)
        if end is None:
            break
        pieces.append(slice(start, end))
        start, room = end + 1, width - indent
    return [*pieces, slice(start, len(text))]


def _break(text: str, after: int, start: int, room: int) -> int | None:
    """Give the last space up to which a text from ``start`` on has room, else the next one, else None."""
    used, found = 0, None
    for at in range(start, len(text)):
        if text[at] == " " and at > after:
            if used > room:
                return at if found is None else found
            found = at
        used += _columns(text[at])
    return found


def terminal_width() -> int:
    """Give the columns that there are now: by COLUMNS, or of the terminal; 80 where there is none."""
    import shutil

    return max(20, shutil.get_terminal_size((80, 24)).columns)


@dataclass(frozen=True, slots=True)
class Screen:
    """A stream to write to, with what it can show."""

    stream: TextIO
    width: int
    colour: bool
    unicode: bool
    interactive: bool

    @classmethod
    def of(cls, stream: TextIO, environment: dict[str, str], width: int | None = None) -> "Screen":
        """Look at a stream and the environment: NO_COLOR, FORCE_COLOR, TERM, COLUMNS."""
        interactive = stream.isatty()
        dumb = environment.get("TERM", "") == "dumb"
        wanted = bool(environment.get("FORCE_COLOR")) or (interactive and not dumb)
        encoding = (getattr(stream, "encoding", None) or "utf-8").lower().replace("-", "")
        return cls(
            stream,
            width or terminal_width(),
            wanted and not environment.get("NO_COLOR"),
            encoding.startswith("utf"),
            interactive and not dumb,
        )

    def console(self) -> "Console":
        """Give a Rich console that adds nothing of its own: no markup, no highlighting, no emoji."""
        from rich.console import Console

        return Console(
            file=self.stream,
            width=self.width,
            force_terminal=self.colour or None,
            no_color=not self.colour,
            color_system="standard" if self.colour else None,
            markup=False,
            highlight=False,
            emoji=False,
            legacy_windows=False,
            soft_wrap=True,
        )

    def _parts(self, line: "Text | str") -> "Sequence[Text | str]":
        return wrapped(line, self.width) if isinstance(line, str) else wrapped_text(line, self.width)

    def write(self, *lines: "Text | str") -> None:
        """Write lines of harmless text, styled where this screen shows colour.

        A terminal would break those that are too long within words; whoever reads a pipe wants them whole.
        """
        if self.stream.isatty():
            lines = tuple(part for line in lines for part in self._parts(line))
        if self.colour:
            console = self.console()
            for line in lines:
                console.print(line)
            return
        text = "".join(f"{line}\n" for line in lines)
        if not self.unicode:
            text = text.translate(_ASCII)
        self.stream.write(text)


_PAIRS = '█# ▓% ▒+ ░. ▋# ▊# ▉# ─- │| └` ├| ╵| ·. …~ –- —- −- ×x ’\' “" ”" ✓+ ▲^ ▼v ●*'
_ASCII = str.maketrans(
    {pair[0]: pair[1] for pair in _PAIRS.split()}
    | dict.fromkeys("▏▎▍▌", " ")
    | {"→": "->", "←": "<-", "≤": "<=", "≥": ">=", "ψ": "psi", "μ": "mu", "ε": "eps", "°": "deg "}
)
