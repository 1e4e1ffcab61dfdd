"""Customs of one's own over the shipped calendar: row by row, and each mistake in the file where it is."""

from collections.abc import Collection, Iterable, Iterator
from pathlib import Path

from fuzzytime.documents.nodes import Mapping, Node, Reader, Scalar, Sequence
from fuzzytime.errors import DocumentError
from fuzzytime.language.grammar.lexicon import Form, form_of

ALSO = "also"
"""The key of a row under which other ways to say it stand: an upper file adds to them."""

WHOLE = frozenset({"holidays"})
"""Sections in which an upper row says anew all that is said of its thing but ALSO: a feast has one day."""

LANGUAGE = "language"
"""The key that a word table has, and a rule table has not."""

TELLING = frozenset(
    {LANGUAGE, "parts", "day_parts", "holidays", "seasons", "zones", "usual_hours", "hours_on_days", "policy"}
)
"""Keys by which a word table is told from a rule table, also where it forgets to say its language."""

HEAD = ("fuzzytime", LANGUAGE)
"""What every word table begins with."""


def is_word_table(path: Path) -> bool:
    """Whether a file says of what language it is or what the parts of a day are, as no rule table does.

    Raises
    ------
    OSError
        If it cannot be read.
    """
    try:
        root = Reader.of_file(path).root()
    except DocumentError:
        return False
    return isinstance(root, Mapping) and any(name.text in TELLING for name, _ in root.entries)


class LayeredReader(Reader):
    """A document and those laid over it, read as one; what is wrong is noted in the one that holds it."""

    def __init__(self, path: str, source: bytes | str) -> None:
        super().__init__(path, source)
        # By identity, as nodes of two files may be equal; with the node, so that its identity stays its own.
        self._upper: dict[int, tuple[Node, Reader]] = {}

    def layered(self, paths: Iterable[Path], sections: Collection[str]) -> Node:
        """Give the document's tree with those of other files laid over it, the last one on top.

        Rows are laid over rows of the same name, key by key, and lists of words are added to; a word that
        an upper row has is taken from every other row of its section.

        A file that is no YAML document is told among the mistakes, and left out.

        Raises
        ------
        OSError
            If a file cannot be read.
        """
        root = self.root()
        for path in paths:
            try:
                upper = Reader.of_file(path)
                tree = upper.root()
            except DocumentError as error:
                self.mistakes += error.mistakes
                continue
            # One list, so that the mistakes of all are told together.
            self.mistakes += upper.mistakes
            upper.mistakes = self.mistakes
            found = upper.mapping(tree, "", (*HEAD, *sections), HEAD)
            lower = self.mapping(root, "")
            if LANGUAGE in found and isinstance(spoken := lower.get(LANGUAGE), Scalar):
                upper.choice(found[LANGUAGE], LANGUAGE, (spoken.text,))
            if isinstance(tree, Mapping) and isinstance(root, Mapping):
                self._upper.update((id(node), (node, upper)) for node in _nodes(tree))
                known = tuple(entry for entry in tree.entries if entry[0].text in found)
                root = self._over(root, known)
        return root

    def mistake(self, node: Node, key: str, message: str, offset: int = 0) -> None:
        """Note a mistake at a node, in the document that it is from."""
        owner = self._owner(node)
        if owner is self:
            super().mistake(node, key, message, offset)
        else:
            owner.mistake(node, key, message, offset)

    def is_over(self, first: Node, second: Node) -> bool:
        """Whether the first of two nodes is from a file laid over that of the second, which is the lowest."""
        return self._owner(first) is not self and self._owner(second) is self

    def _owner(self, node: Node) -> Reader:
        """Give the document that a node is from."""
        return self._upper[id(node)][1] if id(node) in self._upper else self

    def _over(self, root: Mapping, sections: Iterable[tuple[Scalar, Node]]) -> Mapping:
        """Lay the sections of an upper file over a tree."""
        lower = {name.text: (name, node) for name, node in root.entries}
        for name, node in sections:
            if name.text in lower:
                section = _without(lower[name.text][1], _said(node))
                laid = self._laid(section, node, rows_whole=name.text in WHOLE)
                lower[name.text] = (name, laid)
            else:
                lower[name.text] = (name, node)
        return Mapping(tuple(lower.values()), root.line, root.column, root.index)

    def _laid(self, lower: Node, upper: Node, *, rows_whole: bool = False) -> Node:
        """Lay a node over one that has the same name."""
        if isinstance(lower, Sequence):
            items = upper.items if isinstance(upper, Sequence) else (upper,)
            return self._made(Sequence((*lower.items, *items), upper.line, upper.column, upper.index), upper)
        if not (isinstance(lower, Mapping) and isinstance(upper, Mapping)):
            return upper
        below = {name.text: (name, node) for name, node in lower.entries}
        further = []
        for name, node in upper.entries:
            key, row = below.get(name.text, (None, None))
            if key is None or row is None:
                below[name.text] = (name, node)
            elif self._owner(key) is self._owner(name):
                # Said twice in one file, which is for the reader to tell.
                further.append((name, node))
            else:
                below[name.text] = (name, self._laid(_ways(row) if rows_whole else row, node))
        entries = (*below.values(), *further)
        return self._made(Mapping(entries, upper.line, upper.column, upper.index), upper)

    def _made(self, node: Node, upper: Node) -> Node:
        """Say of a node put together which file its place is in."""
        self._upper[id(node)] = (node, self._owner(upper))
        return node


def _nodes(node: Node) -> Iterator[Node]:
    """Every node below one, keys too."""
    yield node
    if isinstance(node, Sequence):
        for item in node.items:
            yield from _nodes(item)
    elif isinstance(node, Mapping):
        for name, value in node.entries:
            yield name
            yield from _nodes(value)


def _lists(section: Node) -> Iterator[Sequence]:
    """Give the lists of words of a section: its rows, or the other ways to say them."""
    if isinstance(section, Sequence):
        yield section
    for _, row in section.entries if isinstance(section, Mapping) else ():
        if isinstance(row, Sequence):
            yield row
        elif isinstance(row, Mapping):
            yield from (
                node for name, node in row.entries if name.text == ALSO and isinstance(node, Sequence)
            )


def _said(section: Node) -> frozenset[Form]:
    """Give the words that a section has: names of rows, and what stands in their lists."""
    names = [name.text for name, _ in section.entries] if isinstance(section, Mapping) else []
    words = [item.text for one in _lists(section) for item in one.items if isinstance(item, Scalar)]
    return frozenset(map(form_of, (*names, *words)))


def _without(section: Node, said: frozenset[Form]) -> Node:
    """Give a section of a lower file without the words that the upper one has."""
    lists = {id(one) for one in _lists(section)}

    def kept(node: Node) -> Node:
        if isinstance(node, Sequence) and id(node) in lists:
            items = [one for one in node.items if not (isinstance(one, Scalar) and form_of(one.text) in said)]
            return Sequence(tuple(items), node.line, node.column, node.index)
        if isinstance(node, Mapping):
            entries = tuple((name, kept(value)) for name, value in node.entries)
            return Mapping(entries, node.line, node.column, node.index)
        return node

    return kept(section)


def _ways(row: Node) -> Node:
    """Give a row with nothing but the other ways to say it."""
    if not isinstance(row, Mapping):
        return row
    kept = tuple(entry for entry in row.entries if entry[0].text == ALSO)
    return Mapping(kept, row.line, row.column, row.index)
