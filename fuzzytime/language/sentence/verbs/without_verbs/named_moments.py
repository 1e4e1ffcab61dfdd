"""Moments that have a name: "call time 6:00", "closing time 18:00"."""

from collections.abc import Sequence

from fuzzytime.language.instruction import Operation
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.meaning.phrases import is_at_clock
from fuzzytime.language.sentence.trees.tree import Tree

LONGEST = 4
"""Words in front of what ends such a name, fewer than that."""


def named_moment(tree: Tree, phrases: Sequence[Phrase], offset: int) -> Operation | None:
    """Give what happens at the one clock time of a line, which names nothing else than that moment.

    ``offset`` is where the tree begins in the text. No order has a bare "time" beside a clock time without a
    preposition; "make time at six" is one.
    """
    lexicon = tree.lexicon
    if len(phrases) != 1 or not is_at_clock(phrases[0]):
        return None
    timed = set(tree.at(phrases[0].span[0] - offset, phrases[0].span[1] - offset))
    named = [p for p, node in enumerate(tree.nodes) if p not in timed and any(map(str.isalnum, node.text))]
    before = [tree.nodes[place] for place in named[:-1]]
    if not 0 < len(before) < LONGEST or tree.nodes[named[-1]].lower not in lexicon.closed.named_moments:
        return None
    counted = lexicon.closed.ends_of_rows | lexicon.ordinals.keys() | lexicon.function_words
    if before[-1].lower in counted or (before[0].may_act and phrases[0].said.preposition is not None):
        return None
    last = tree.nodes[named[-1]]
    name = tree.text[before[0].start : last.end]
    return Operation(verb=last.lower, lemma="be", span=(last.start, last.end), object=name, stated=True)
