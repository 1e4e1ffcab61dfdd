"""What can go wrong, as values that a terminal can show.

Every error that a person's input can cause is a `FuzzytimeError`; programs catch that one class in one
place. A message gives the rule, then the value that broke it.
"""

from dataclasses import dataclass

WINDOW = 100
"""Characters of a source line that an error shows at most."""


class FuzzytimeError(Exception):
    """Base of every error that input, not a defect of this program, can cause."""


class InstructionError(FuzzytimeError):
    """An instruction that could not be understood, with the words at fault.

    Parameters
    ----------
    message : str
        The rule, then the value.
    text : str
        The instruction as typed.
    span : tuple of int
        First and one past last character of the words at fault.
    """

    def __init__(self, message: str, text: str, span: tuple[int, int]) -> None:
        super().__init__(message)
        self.message = message
        self.text = text
        self.span = span


@dataclass(frozen=True, slots=True, order=True)
class Mistake:
    """One mistake in a file: where it stands, what rule it breaks.

    ``line`` and ``column`` count from 1; ``source`` is the line as it stands in the file.
    """

    path: str
    line: int
    column: int
    key: str
    message: str
    source: str = ""

    @property
    def place(self) -> str:
        """``file:line:column``, as editors and terminals make links of it."""
        return f"{self.path}:{self.line}:{self.column}"

    def __str__(self) -> str:
        """Give place, key and message, then the source line with a caret under the mistake."""
        head = f"{self.place}: {self.key}: {self.message}" if self.key else f"{self.place}: {self.message}"
        if not self.source.strip():
            return head
        first = max(0, self.column - 1 - WINDOW // 2) if len(self.source) > WINDOW else 0
        shown = self.source[first : first + WINDOW].replace("\t", " ")
        return f"{head}\n    {shown}\n    {' ' * (self.column - 1 - first)}^"


class DocumentError(FuzzytimeError):
    """A file that breaks rules: all its mistakes at once, in the order of their places."""

    def __init__(self, mistakes: tuple[Mistake, ...]) -> None:
        self.mistakes = tuple(sorted(mistakes))
        super().__init__("\n".join(map(str, self.mistakes)))


class RefusedError(FuzzytimeError):
    """A request that is well formed but beyond a stated limit, and the limit."""
