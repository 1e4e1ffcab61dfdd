"""What happens under the name of what is done: "school run 8:15", "ward visit 11:30", "lobby call 7:00".

A tree takes the second noun for the verb of the first. Yet one thing and a bare verb do not agree, and
behind such a name stands its time alone.
"""

from collections.abc import Collection, Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation
from fuzzytime.language.meaning.expressions import Phrase, Range, Wall
from fuzzytime.language.sentence.trees.tree import Tree

LONGEST = 2
"""Words before the last of such a name at most."""

NOUNS = frozenset({"NN", "NNP", "JJ"})
BARE = frozenset({"VB", "VBP", "VBD", "NN"})
COMPOUND = "compound"


def with_named_deed(tree: Tree, timed: Collection[int], lexicon: Lexicon) -> Tree:
    """Give the tree of such a name a noun for its root."""
    root = tree.root
    if root is None or tree.nodes[root].tag == "NN" or not timed or not names_deed(tree, root, lexicon):
        return tree
    behind = range(root + 1, len(tree.nodes))
    alone = all(place in timed or not tree.nodes[place].text[0].isalnum() for place in behind)
    if not alone or any(place <= root for place in timed):
        return tree
    nodes = list(tree.nodes)
    nodes[root] = replace(nodes[root], tag="NN", lemma=nodes[root].lower)
    for place in range(root):
        nodes[place] = replace(nodes[place], relation=COMPOUND, head=root)
    for place in behind:
        if nodes[place].head == root:
            nodes[place] = replace(nodes[place], relation="npadvmod")
    return tree.with_nodes(nodes)


def deed_at(tree: Tree, phrases: Sequence[Phrase], lexicon: Lexicon) -> Operation | None:
    """Give a deed that is named before its clock time: it takes as long as what its last word asks for."""
    root = tree.root
    if root is None or tree.nodes[root].tag != "NN" or not names_deed(tree, root, lexicon):
        return None
    if any(node.relation != COMPOUND for node in tree.nodes[:root]) or not any(map(_is_clocked, phrases)):
        return None
    first, last = tree.nodes[0], tree.nodes[root]
    return Operation(
        verb=tree.text[first.start : last.end].lower(), lemma=last.lower, span=(first.start, last.end)
    )


def _is_clocked(phrase: Phrase) -> bool:
    """Whether a time has its hour, or is from one to another."""
    time = phrase.said.time
    return isinstance(time, Range) or (isinstance(time, Wall) and time.clock is not None)


def names_deed(tree: Tree, root: int, lexicon: Lexicon) -> bool:
    """Whether words name one deed, up to the last, which may be a verb: "first shot", but no "paint shed"."""
    node, first = tree.nodes[root], tree.nodes[0].lower
    if not 0 < root <= LONGEST or node.tag not in BARE or not node.may_act:
        return False
    orders = lexicon.chores | lexicon.ordering | lexicon.doing.by_the_day | lexicon.dosing | lexicon.alone
    deeds = lexicon.lasting | lexicon.taken | lexicon.happening | lexicon.events
    if first in lexicon.appointing or (first in orders and node.lower not in deeds):
        # "Alarm set eight am" asks for one.
        return False
    bare = node.lower == node.lemma.lower() or first in lexicon.ordinals
    moves = lexicon.doing.several_timed | lexicon.doing.arriving | lexicon.doing.leaving
    return bare and node.lower not in moves - deeds and all(_names(tree, p, lexicon) for p in range(root))


def _names(tree: Tree, place: int, lexicon: Lexicon) -> bool:
    """Whether a word before it names one thing, and nobody who would do it."""
    node = tree.nodes[place]
    # A team or crew has its talk or call; a robot and Dad do what is said behind them.
    doers = (lexicon.persons - lexicon.workers) | (lexicon.workers & lexicon.machines) | lexicon.addressing
    if node.lower in doers or (place and node.tag == "NNP") or node.text.isupper():
        return False
    return node.tag in NOUNS or node.lower in lexicon.ordinals
