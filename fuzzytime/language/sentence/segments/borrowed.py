"""Words said once that hold in a further wish too: "the dog must be walked by nine and the cat fed by ten".

Such a wish is parsed with the words that it borrows, which keep the places where they were said.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from fuzzytime.language.instruction import Span
from fuzzytime.language.sentence.trees.tree import Tree


@dataclass(frozen=True, slots=True)
class Borrowed:
    """A stretch of words said before, and the place in the text before which they are heard again."""

    at: int
    span: Span


def with_borrowed(text: str, span: Span, borrowed: Sequence[Borrowed]) -> str:
    """Give the words of a stretch with those that it borrows: "the cat must be fed by ten"."""
    return " ".join(text[a:b] for a, b in _stretches(text, span, borrowed))


def in_place(tree: Tree, text: str, one: Span, heard: Span, borrowed: Sequence[Borrowed]) -> Tree:
    """Give the tree of what was ``heard`` of a stretch with borrowed words, with the places of all.

    They count from the stretch's start on. ``text`` is the whole text; those of borrowed words are before it.
    """
    if not borrowed:
        return tree
    nodes, first = list(tree.nodes), 0
    for a, b in _stretches(text, heard, borrowed):
        end, moved = first + b - a, a - one[0] - first
        for place, node in enumerate(tree.nodes):
            if first <= node.start < end:
                nodes[place] = replace(node, start=node.start + moved, end=node.end + moved)
        first = end + 1
    return Tree(text[slice(*one)], tuple(nodes), tree.lexicon)


def _stretches(text: str, span: Span, borrowed: Sequence[Borrowed]) -> Iterator[Span]:
    """Give the stretches of a text one behind the other, without spaces at their ends."""
    here, last = span
    inside = (words for words in borrowed if here <= words.at <= last)
    for words in sorted(inside, key=lambda words: words.at):
        kept = here + len(text[here : words.at].rstrip())
        if kept > here:
            yield here, kept
        yield words.span
        here = words.at
    yield here, last
