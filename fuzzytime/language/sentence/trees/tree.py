"""A dependency tree as a value: words with tags, relations and heads, from whatever parser made it."""

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace

from fuzzytime.language.grammar.lexicon import Lexicon


@dataclass(frozen=True, slots=True)
class Node:
    """A word: its place, Penn Treebank tag, dictionary form, and relation to its head as the model says.

    ``may_act`` and ``may_name`` say whether a dictionary has it for a verb, and for a noun or an adjective,
    whatever its tag.
    """

    text: str
    start: int
    end: int
    tag: str
    lemma: str
    relation: str
    head: int
    may_act: bool = True
    may_name: bool = True

    @property
    def lower(self) -> str:
        """The word in lower case."""
        return self.text.lower()

    @property
    def is_verb(self) -> bool:
        """Whether it is tagged as a verb."""
        return self.tag.startswith("VB")

    @property
    def is_bare(self) -> bool:
        """Whether it may be a verb's bare form; that of "set" and "put" is also the past, and tagged so."""
        return self.tag in {"VB", "VBP"} or (self.tag in {"VBD", "VBN"} and self.lower == self.lemma)


@dataclass(frozen=True, slots=True)
class Tree:
    """A text's words, and the tables of their language; the head of a root is itself."""

    text: str
    nodes: tuple[Node, ...]
    lexicon: Lexicon = field(compare=False, repr=False)
    _children: dict[int, tuple[int, ...]] = field(default_factory=dict, init=False, compare=False, repr=False)
    _root: int = field(init=False, compare=False, repr=False)

    def __post_init__(self) -> None:
        roots = (place for place, node in enumerate(self.nodes) if node.head == place)
        object.__setattr__(self, "_root", next(roots, 0))
        below: dict[int, list[int]] = {}
        for place, node in enumerate(self.nodes):
            if node.head != place:
                below.setdefault(node.head, []).append(place)
        self._children.update({head: tuple(places) for head, places in below.items()})

    @property
    def root(self) -> int:
        """The first root; 0 for an empty text, which has none."""
        return self._root

    def children(self, place: int, *relations: str) -> tuple[int, ...]:
        """Give the words below a word, of some relations if any are named."""
        found = self._children.get(place, ())
        return tuple([p for p in found if self.nodes[p].relation in relations]) if relations else found

    def below(self, place: int) -> Iterator[int]:
        """Give a word and all words under it."""
        stack, seen = [place], set()
        while stack:
            here = stack.pop()
            if here not in seen:
                seen.add(here)
                yield here
                stack += self.children(here)

    def said(self, places: Iterable[int]) -> set[str]:
        """Give some words in lower case."""
        return {self.nodes[place].lower for place in places}

    def typed(self, places: Sequence[int]) -> str:
        """Give some words as they were typed, without what stands between them."""
        said = ""
        for place in places:
            node = self.nodes[place]
            joined = place - 1 in places and self.nodes[place - 1].end == node.start
            hyphened = place - 2 in places and self.nodes[place - 2].end + 1 == node.start
            said += self.text[node.start - 1] if hyphened else "" if joined or not said else " "
            said += node.text
        return said

    def reach(self, place: int) -> tuple[int, int]:
        """Give the first word and one past the last word of all under a word."""
        under = list(self.below(place))
        return min(under), max(under) + 1

    def above(self, place: int) -> Iterator[int]:
        """Give the words over a word, up to its root."""
        here, seen = place, {place}
        while (head := self.nodes[here].head) != here and head not in seen:
            seen.add(head)
            yield head
            here = head

    def at(self, start: int, end: int) -> Iterator[int]:
        """Give the words that lie in a stretch of characters."""
        first = bisect_right(self.nodes, start, key=lambda node: node.end)
        behind = bisect_left(self.nodes, end, lo=first, key=lambda node: node.start)
        return iter(range(first, behind))

    def without_carrier(self, carrier: str, text: str, skipped: int) -> "Tree":
        """Give the tree of a text that was parsed behind some words, and without its first characters.

        Parameters
        ----------
        carrier, text
            What was put in front ("please "), and the text.
        skipped
            How many characters of the text were left out.
        """
        dropped = sum(node.start < len(carrier) for node in self.nodes)
        shift = skipped - len(carrier)
        kept = self.nodes[dropped:]
        root = next((p for p, node in enumerate(kept) if node.head < dropped or node.head == p + dropped), 0)
        nodes = tuple(
            replace(
                node,
                text=text[node.start + shift : node.end + shift],
                start=node.start + shift,
                end=node.end + shift,
                head=node.head - dropped if node.head >= dropped else root,
            )
            for node in kept
        )
        return Tree(text, nodes, self.lexicon)

    def changed(
        self, place: int, *, tag: str = "", lemma: str = "", relation: str = "", head: int | None = None
    ) -> "Tree":
        """Give the tree with another tag, dictionary form, relation or head of a word."""
        node = self.nodes[place]
        changed = replace(
            node,
            tag=tag or node.tag,
            lemma=lemma or node.lemma,
            relation=relation or node.relation,
            head=node.head if head is None else head,
        )
        return self.with_nodes((*self.nodes[:place], changed, *self.nodes[place + 1 :]))

    def hung(self, places: Iterable[int], head: int, relation: str = "") -> "Tree":
        """Give the tree with some words hung on another."""
        tree = self
        for place in places:
            tree = tree.changed(place, head=head, relation=relation)
        return tree

    def with_nodes(self, nodes: Iterable[Node]) -> "Tree":
        """Give the tree of the same text with other nodes."""
        return Tree(self.text, tuple(nodes), self.lexicon)


Trees = Callable[[Sequence[str]], list[Tree]]
"""Whatever parses: the trees of some texts, in order."""
