"""The page of a report: headings, paragraphs, numbered tables and figures, written as HTML."""

import base64
import html
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field


@dataclass(slots=True)
class Page:
    """The parts of a page written so far, and how many tables and figures are among them."""

    parts: list[str] = field(default_factory=list)
    tables: int = 0
    figures: int = 0

    def heading(self, text: str, level: int = 2) -> None:
        """Add a heading."""
        self.parts.append(f"<h{level}>{html.escape(text)}</h{level}>")

    def paragraph(self, text: str, kind: str = "") -> None:
        """Add a paragraph, of a kind that the style knows."""
        self.parts.append(f"<p{f' class={kind}' if kind else ''}>{html.escape(text)}</p>")

    def table(self, caption: str, head: Sequence[str], rows: Iterable[Sequence[str]]) -> None:
        """Add a table; columns of numbers and ranges of numbers stand on the right."""
        self.tables += 1
        listed = list(rows)
        columns = zip(*listed, strict=True) if listed else [()] * len(head)
        kinds = [" class=n" if all(map(_is_number, column)) else "" for column in columns]
        cells = "".join(
            f"<th scope=col{kind}>{html.escape(cell)}</th>" for cell, kind in zip(head, kinds, strict=True)
        )
        body = "".join(
            "<tr>"
            + "".join(f"<td{kind}>{html.escape(cell)}</td>" for cell, kind in zip(row, kinds, strict=True))
            + "</tr>"
            for row in listed
        )
        self.parts.append(
            f"<figure><figcaption><b>Table {self.tables}.</b> {html.escape(caption)}</figcaption>"
            f"<div><table><thead><tr>{cells}</tr></thead><tbody>{body}</tbody></table></div></figure>"
        )

    def figure(self, name: str, caption: str, pictures: Mapping[str, bytes]) -> None:
        """Add a picture, where there is one of that name."""
        if name not in pictures:
            return
        self.figures += 1
        data = base64.b64encode(pictures[name]).decode("ascii")
        label = f"<b>Figure {self.figures}.</b> {html.escape(caption)}"
        self.parts.append(
            f'<figure><img alt="{html.escape(caption)}" src="data:image/svg+xml;base64,{data}">'
            f"<figcaption>{label}</figcaption></figure>"
        )

    @property
    def html(self) -> str:
        """What is between the body's tags."""
        return "".join(self.parts)


_NUMBER = r"(< )?[−\d.,]+(%| [a-z]+)?"
_NUMBERS = re.compile(rf"{_NUMBER}( (to|of) {_NUMBER})?|–")


def _is_number(text: str) -> bool:
    return _NUMBERS.fullmatch(text) is not None
