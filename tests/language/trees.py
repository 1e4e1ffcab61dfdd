"""Dependency trees built by hand, so that tests of the sentence need no model."""

from fuzzytime.language import shipped_lexicon
from fuzzytime.language.sentence.trees.tree import Node, Tree


def tree(*rows: str) -> Tree:
    """Build a tree from rows of ``word tag relation head`` or ``word/lemma tag relation head``.

    A head is a word's text; that of the root is itself. Words are joined by spaces.
    """
    split = [row.split() for row in rows]
    words = [row[0].split("/")[0] for row in split]
    nodes, place = [], 0
    for row, word in zip(split, words, strict=True):
        lemma = row[0].split("/")[1] if "/" in row[0] else word.lower()
        nodes.append(Node(word, place, place + len(word), row[1], lemma, row[2], words.index(row[3])))
        place += len(word) + 1
    return Tree(" ".join(words), tuple(nodes), shipped_lexicon())


PLACE_THE_PAN = tree(
    "Place VB ROOT Place",
    "the DT det pan",
    "pan NN dobj Place",
    "on IN prep Place",
    "a DT det stove",
    "stove NN pobj on",
    "in IN prep Place",
    "about RB advmod four",
    "four CD nummod minutes",
    "minutes/minute NNS pobj in",
)
"""The paper's figure of a dependency tree."""
