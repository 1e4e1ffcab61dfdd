"""Parsing of YAML documents to trees of texts, from the events of PyYAML's C parser.

Nothing is converted and nothing is followed: ``on`` stays ``on``, ``1:30`` stays ``1:30``, an alias is a
mistake and not a bomb.
"""

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import yaml

from fuzzytime.documents.tree import MAX_DEPTH, Mapping, Node, Place, Scalar, Sequence, TreeError

MAX_NODES = 16_000
MAX_LINES = 20_000

_LOADER: type[yaml.SafeLoader] = getattr(yaml, "CSafeLoader", yaml.SafeLoader)

TOO_DEEP = "maximum nesting depth"
"""What a parser's own refusal of deep nesting says."""

DEPTH_REFUSED = f"nesting must not be deeper than {MAX_DEPTH}"

Note = Callable[[Place, str], None]
"""Takes a mistake that does not stop reading."""


def parse_tree(text: str, note: Note) -> Node:
    """Give the tree of one plain document; aliases, anchors, tags and merge keys are noted and read over.

    Raises
    ------
    TreeError
        If it is not well-formed, empty, several documents, or beyond `MAX_DEPTH`, `MAX_NODES` or `MAX_LINES`.
    """
    if text.count("\n") > MAX_LINES:
        raise TreeError(f"a file must not have more than {MAX_LINES:,} lines", MAX_LINES, 0)
    builder = _Builder(note)
    try:
        for event in yaml.parse(text, Loader=_LOADER):
            builder.take(event)
    except yaml.MarkedYAMLError as error:
        raise _syntax_error(text, error) from error
    except yaml.reader.ReaderError as error:
        at = min(error.position, len(text))
        start = text.rfind("\n", 0, at) + 1
        raise TreeError(f"not valid YAML: {error.reason}", text.count("\n", 0, at), at - start) from error
    if builder.document is None:
        raise TreeError("the file must not be empty", 0, 0)
    return builder.document


def _syntax_error(text: str, error: yaml.MarkedYAMLError) -> TreeError:
    """Say where to look: at a tab, at a quote or bracket of an earlier line that is still open, or there."""
    mark, begun = error.problem_mark, error.context_mark
    if mark is not None and TOO_DEEP in (error.problem or ""):
        # Newer parsers refuse what is nested far deeper before they give its first brackets.
        return TreeError(DEPTH_REFUSED, mark.line, mark.column)
    if mark is None:
        return TreeError(f"not valid YAML: {error.problem or error}", 0, 0)
    if text[mark.index : mark.index + 1] == "\t":
        return TreeError(
            "not valid YAML: lines must be indented by spaces, got a tab", mark.line, mark.column
        )
    problem = " ".join(part for part in (error.problem, error.context) if part)
    opened = text[begun.index : begun.index + 1] if begun is not None else ""
    if begun is not None and opened and opened in "[{\"'" and begun.line < mark.line:
        return TreeError(
            f"not valid YAML: {opened!r} is not closed: {error.problem}", begun.line, begun.column
        )
    return TreeError(f"not valid YAML: {problem}", mark.line, mark.column)


@dataclass(slots=True)
class _Open:
    """A collection whose end has not come yet."""

    event: yaml.CollectionStartEvent
    children: list[Node] = field(default_factory=list)


class _Builder:
    """Puts events together to a tree, without recursion."""

    def __init__(self, note: Note) -> None:
        self.document: Node | None = None
        self._note = note
        self._stack: list[_Open] = []
        self._nodes = 0

    def take(self, event: yaml.Event) -> None:
        """Take the next event."""
        mark = event.start_mark
        if (
            type(event) is yaml.ScalarEvent
            and event.anchor is None
            and event.tag is None
            and mark is not None
        ):
            # Most events are plain values, and files have thousands.
            self._nodes += 1
            if self._nodes <= MAX_NODES:
                quoted = event.style not in (None, "")
                self._add(Scalar(event.value, mark.line, mark.column, mark.index, quoted))
                return
            self._nodes -= 1
        if isinstance(event, yaml.CollectionEndEvent):
            self._add(self._closed(self._stack.pop()))
            return
        place = _place(event)
        if isinstance(event, yaml.DocumentStartEvent) and self.document is not None:
            raise TreeError("a file must hold one document", place.line, place.column)
        if isinstance(event, yaml.NodeEvent):
            self._nodes += 1
            if self._nodes > MAX_NODES:
                raise TreeError(
                    f"a file must not hold more than {MAX_NODES:,} values", place.line, place.column
                )
            self._node(event, place)

    def _node(self, event: yaml.NodeEvent, place: Place) -> None:
        if isinstance(event, yaml.AliasEvent):
            self._note(place, f"aliases are not allowed, got '*{event.anchor}'")
            self._add(Scalar("", place.line, place.column, place.index, refused=True))
            return
        if event.anchor is not None:
            self._note(place, f"anchors are not allowed, got '&{event.anchor}'")
        if isinstance(event, yaml.ScalarEvent | yaml.CollectionStartEvent) and event.tag is not None:
            tag = event.tag.replace("tag:yaml.org,2002:", "!!")
            self._note(place, f"tags are not allowed, got '{tag}'")
        if isinstance(event, yaml.ScalarEvent):
            quoted = event.style not in (None, "")
            self._add(Scalar(event.value, place.line, place.column, place.index, quoted))
        elif isinstance(event, yaml.CollectionStartEvent):
            if len(self._stack) >= MAX_DEPTH:
                raise TreeError(DEPTH_REFUSED, place.line, place.column)
            self._stack.append(_Open(event))

    def _add(self, node: Node) -> None:
        if self._stack:
            self._stack[-1].children.append(node)
        else:
            self.document = node

    def _closed(self, opened: _Open) -> Node:
        place = _place(opened.event)
        if isinstance(opened.event, yaml.SequenceStartEvent):
            return Sequence(tuple(opened.children), place.line, place.column, place.index)
        entries = []
        for key, value in zip(opened.children[::2], opened.children[1::2], strict=True):
            if isinstance(key, Scalar) and key.text == "<<" and not key.quoted:
                self._note(Place(key.line, key.column, key.index), "merge keys are not allowed, got '<<'")
                entries.append((replace(key, refused=True), value))
            elif isinstance(key, Scalar):
                entries.append((key, value))
            else:
                at = Place(key.line, key.column, key.index)
                self._note(at, "a key must be a text, got a list or a mapping")
        return Mapping(tuple(entries), place.line, place.column, place.index)


def _place(event: yaml.Event) -> Place:
    """Give the place of an event; only events made by hand have none."""
    mark = event.start_mark
    return Place(mark.line, mark.column, mark.index) if mark is not None else Place(0, 0, 0)
