"""What happens under the name of what is done, or of its moment: "school run 8:15", "closing time 18:00".

A tree takes the second noun for the verb of the first. Yet one thing and a bare verb do not agree, and
behind such a name stands its time alone.
"""

from collections.abc import Collection, Sequence

from fuzzytime.language.instruction import Operation
from fuzzytime.language.meaning.expressions import Duration, Phrase, Range
from fuzzytime.language.meaning.phrases import is_at_clock
from fuzzytime.language.sentence.trees.tags import DETERMINERS
from fuzzytime.language.sentence.trees.tree import Node, Tree

LONGEST = 2
"""Words before the last of such a name at most."""

NOUNS = frozenset({"NN", "NNP", "JJ"})
BARE = frozenset({"VB", "VBP", "VBD", "NN"})
LEADING = frozenset({*DETERMINERS, "CD"})
"""Tags of the first word of a name."""


LONGEST_MOMENT = 4
"""Words in front of what ends such a name, fewer than that."""


def with_named_deed(tree: Tree, timed: Collection[int]) -> Tree:
    """Give the tree of such a name a noun for its root."""
    root = tree.root
    first = _first_word(tree, timed)
    if tree.nodes[root].tag == "NN" or not names_deed(tree, first, root):
        return tree
    apart = [place for place in range(len(tree.nodes)) if not first <= place <= root]
    alone = all(place in timed or not tree.nodes[place].text[0].isalnum() for place in apart)
    if not alone or any(first <= place <= root for place in timed):
        return tree
    beside = [place for place in tree.children(root) if place in apart]
    named = tree.changed(root, tag="NN", lemma=tree.nodes[root].lower)
    return named.hung(range(first, root), root, "compound").hung(beside, root, "npadvmod")


def _first_word(tree: Tree, timed: Collection[int]) -> int:
    """Give the first word that is no time."""
    return next((place for place in range(len(tree.nodes)) if place not in timed), 0)


def deed_at(tree: Tree, timed: Collection[int], phrases: Sequence[Phrase]) -> Operation | None:
    """Give a deed that is named beside its clock time: it takes as long as what its last word asks for."""
    root, start = tree.root, _first_word(tree, timed)
    if tree.nodes[root].tag != "NN" or not names_deed(tree, start, root):
        return None
    first, last = tree.nodes[start], tree.nodes[root]
    nth = first.lower in tree.lexicon.ordinals
    named = all(_is_of_name(node) or (nth and node is first) for node in tree.nodes[start:root])
    # "Second coat two hours later"; but "school run" is done at a time by the clock
    if not named or not (any(map(_is_clocked, phrases)) or (nth and phrases)):
        return None
    return Operation(
        verb=tree.text[first.start : last.end].lower(), lemma=last.lower, span=(first.start, last.end)
    )


def _is_of_name(node: Node) -> bool:
    """Whether a word belongs to the name behind it, and is no order by itself: "legal read"."""
    return node.relation == "compound" or (node.relation == "amod" and not node.may_act)


def chores_at(
    tree: Tree, timed: Collection[int], phrases: Sequence[Phrase], *, led: bool
) -> Operation | None:
    """Give what is done with things that alone are named beside when: "the dishes after dinner".

    These are several, or one thing that is done without another verb: "laundry tonight, 20 mins". Where a
    clause has ``led`` to it, that says when.
    """
    named = [place for place, node in enumerate(tree.nodes) if place not in timed and node.text[0].isalnum()]
    if not named or not (led or any(map(_tells_when, phrases))):
        return None
    root = tree.nodes[tree.root]
    several = root.tag == "NNS" and tree.lexicon.persons.isdisjoint((root.lower, root.lemma))
    done = several or (root.tag != "RB" and (root.lower,) in tree.lexicon.conversation["by itself"])
    if named[-1] != tree.root or not done:
        return None
    if any(not _describes(tree.nodes[place], first=place == named[0]) for place in named[:-1]):
        return None
    first, last = tree.nodes[named[0]], tree.nodes[named[-1]]
    return Operation(
        verb=tree.text[first.start : last.end].lower(), lemma=last.lower, span=(first.start, last.end)
    )


def _describes(node: Node, *, first: bool) -> bool:
    """Whether a word belongs to the name of things: its article or number, or what says which they are."""
    return (first and node.tag in LEADING) or (node.tag in NOUNS and not node.may_act)


def _tells_when(phrase: Phrase) -> bool:
    """Whether a time is no length."""
    return not isinstance(phrase.said.time, Duration) or phrase.said.constraint is not None


def _is_clocked(phrase: Phrase) -> bool:
    """Whether a time has its hour, or is from one to another."""
    time = phrase.said.time
    return isinstance(time, Range) or phrase.said.wall.clock is not None


def names_deed(tree: Tree, start: int, root: int) -> bool:
    """Whether words name one deed, up to the last, which may be a verb: "first shot", but no "paint shed"."""
    lexicon = tree.lexicon
    node, first = tree.nodes[root], tree.nodes[start].lower
    if not 0 < root - start <= LONGEST or node.tag not in BARE or not node.may_act:
        return False
    orders = lexicon.chores | lexicon.ordering | lexicon.doing.by_the_day | lexicon.dosing | lexicon.alone
    deeds = lexicon.lasting | lexicon.taken | lexicon.happening | lexicon.events
    made = first in lexicon.appointing and node.lower in lexicon.rescheduling
    if made or (first in orders and node.lower not in deeds):
        # "Alarm set eight am" asks for one.
        return False
    bare = node.lower == node.lemma.lower() or first in lexicon.ordinals
    # "Drone shot an hour before sunset"
    past = node.lower in lexicon.closed.deeds_like_the_past
    bare = bare or past
    moves = lexicon.doing.several_timed | lexicon.doing.arriving | lexicon.doing.leaving
    return (
        bare
        and node.lower not in (moves - deeds) | lexicon.persons
        and all(
            # Whom one asks, one asks to shoot.
            _names(tree, place, start) or (past and tree.nodes[place].lower in lexicon.machines)
            for place in range(start, root)
        )
    )


def _names(tree: Tree, place: int, start: int) -> bool:
    """Whether a word before it names one thing, and nobody who would do it."""
    lexicon = tree.lexicon
    node = tree.nodes[place]
    if node.relation == "compound" and node.lower in lexicon.taken:
        # "Vet visit 10am"
        return True
    # A team or crew has its talk or call; a robot and Dad do what is said behind them.
    doers = (lexicon.persons - lexicon.workers) | (lexicon.workers & lexicon.machines) | lexicon.addressing
    if node.lower in doers or (place > start and node.tag == "NNP") or node.text.isupper():
        return False
    return node.tag in NOUNS or node.lower in lexicon.ordinals


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
    if (
        not 0 < len(before) < LONGEST_MOMENT
        or tree.nodes[named[-1]].lower not in lexicon.closed.named_moments
    ):
        return None
    counted = lexicon.closed.ends_of_rows | lexicon.ordinals.keys() | lexicon.function_words
    if before[-1].lower in counted or (before[0].may_act and phrases[0].said.preposition is not None):
        return None
    last = tree.nodes[named[-1]]
    name = tree.text[before[0].start : last.end]
    return Operation(verb=last.lower, lemma="be", span=(last.start, last.end), object=name, stated=True)
