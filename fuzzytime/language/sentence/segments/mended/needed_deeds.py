"""Who has or needs what: "may has choir", "the cars need washing", which trees take for other things.

Who has something is taken for a month or a number: "year seven has gym". What is done is taken for a thing,
or the need for what helps.

Who speaks needs things: "we need cleaning products"; and so does what has a noun behind.
"""

from collections.abc import Set as AbstractSet

from fuzzytime.english import PARTICIPLE, is_participle
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.sentence.trees.tree import Tree

OF_THINGS = frozenset({"det", "poss", "amod", "compound", "nummod"})
"""Relations of the words before a thing that are said of it."""

JOINED = frozenset({"conj", "cc", "punct"})
"""Relations of what goes on behind."""

LONGEST = 4
"""Words before a verb of having or needing, at most: "june and april have choir"."""

NAMING = frozenset({"DT", "PRP$", "NN", "NNS", "NNP", "NNPS", "CD", "CC", "POS"})
"""Tags of words that name who has something."""

NO_OWNERS = frozenset({"WP", "WDT", "EX", "RB", "IN", "DT", "CC", "TO"})
"""Tags of a word alone that is nobody who has something."""


def with_owner(tree: Tree, timed: AbstractSet[int]) -> Tree:
    """Give "may has a lesson", "room nine needs cleaning" who has or needs it."""
    verb = _owning(tree)
    known = tree.root == verb and any(tree.nodes[p].tag != "CD" for p in tree.children(verb, "nsubj"))
    if not verb or known or tree.nodes[tree.root].tag == "VBN" or not timed.isdisjoint(range(verb)):
        return tree
    root, joint = tree.root, next((p for p in range(1, verb) if tree.nodes[p].tag == "CC"), verb)
    needs = tree.nodes[verb].lower.removesuffix("s") in tree.lexicon.doing.needing
    owner = _hang_name(tree, range(joint), verb, "nsubj")
    if joint < verb:
        subject = owner.children(verb, "nsubj")[0]
        owner = _hang_name(owner.changed(joint, head=subject, relation="cc"), range(joint + 1, verb), subject)
    owner = owner.hung((p for p in range(verb + 1, len(tree.nodes)) if tree.nodes[p].head < verb), verb)
    if root > verb and needs:
        owner = owner.changed(root, head=verb, relation="xcomp")
    elif root > verb:
        # "Year two has swimming at nine"
        owner = owner.changed(root, head=verb, relation="dobj", tag="NN")
        owner = owner.hung((p for p in tree.children(root) if p > root), verb)
    lemma = "need" if needs else "have"
    finite = "VBZ" if tree.nodes[verb].lower.endswith("s") else "VBP"
    return owner.changed(verb, tag=finite, lemma=lemma, relation="ROOT", head=verb)


def _owning(tree: Tree) -> int:
    """Give the place of a verb of having or needing behind a name; 0 where there is none."""
    closed, nodes = tree.lexicon.closed, tree.nodes
    first_words = enumerate(nodes[: LONGEST + 1])
    verb = next((p for p, node in first_words if node.lower in closed.having_or_needing), 0)
    if not 0 < verb < len(nodes) - 1:
        return 0
    if nodes[verb + 1].tag == "VBN" or nodes[verb + 1].lower in closed.negators:
        return 0
    named = all(node.tag in NAMING for node in nodes[1:verb])
    # "The kids have swimming at four": a tree has that for what they have done.
    having = nodes[verb + 1].tag == "VBG" and nodes[verb].relation == "aux"
    several = any(node.tag in {"CC", "CD"} for node in nodes[1:verb]) or having
    alone = verb == 1 and nodes[0].tag not in NO_OWNERS and (nodes[0].tag != "PRP" or having)
    first = nodes[0].tag in NAMING or nodes[1].tag == "CD"
    sure = nodes[verb].lower.endswith("s") or several
    return verb if named and sure and (alone or (verb > 1 and first)) else 0


def _hang_name(tree: Tree, places: range, head: int, relation: str = "conj") -> Tree:
    """Give a name that hangs on a verb, or on another name, by its noun: "room nine"."""
    noun = places[-1]
    if tree.nodes[noun].tag == "CD" and len(places) > 1:
        noun -= 1
        tree = tree.changed(noun + 1, head=noun, relation="nummod")
    for place in range(places[0], noun):
        kept = tree.nodes[place].relation
        tree = tree.changed(place, head=noun, relation=kept if kept in OF_THINGS else "compound")
    tag = tree.nodes[noun].tag
    return tree.changed(
        noun, head=head, relation=relation, tag=tag if tag.startswith(("NN", "PRP")) else "NN"
    )


def with_needed_deed(tree: Tree, timed: AbstractSet[int]) -> Tree:
    """Give "the cars need washing", "I need an hour to cook" what must be done with which thing."""
    if tree.nodes and tree.nodes[tree.root].lemma == "need":
        lengths = [place for place in tree.children(tree.root, "dobj", "npadvmod") if place in timed]
        below = [p for place in lengths for p in tree.children(place, "acl", "relcl")]
        for deed in (*tree.children(tree.root, "advcl"), *below) if lengths else ():
            if tree.nodes[deed].tag == "VB" and "to" in tree.said(tree.children(deed, "aux")):
                return tree.changed(deed, head=tree.root, relation="xcomp")
    for need in range(1, len(tree.nodes) - 1):
        if tree.root in {need, need + 1} and _needs_deed(tree, need, timed):
            return _mended(tree, need)
    return tree


def _needs_deed(tree: Tree, need: int, timed: AbstractSet[int]) -> bool:
    """Whether a thing stands before a verb of needs, and behind it what is done, of which nothing is."""
    thing, word, deed = (tree.nodes[place] for place in (_thing(tree, need), need, need + 1))
    behind = [
        node for place, node in enumerate(tree.nodes[need + 2 : need + 3], need + 2) if place not in timed
    ]
    # "The oven needs cleaning": a tree may have several needs there, that are like an oven.
    called = thing.tag.startswith("NN") or (thing.relation == "amod" and thing.head == need)
    called = called or thing.lower in tree.lexicon.closed.universal_pronouns | {"it", "they"}
    needs = word.lower.removesuffix("s") in tree.lexicon.doing.needing and not tree.children(
        need, "neg", "aux"
    )
    done = is_participle(deed.lower) and need + 1 not in timed
    return called and needs and done and not any(node.tag.startswith(("NN", "DT", "PRP")) for node in behind)


def _thing(tree: Tree, need: int) -> int:
    """Give what needs something: "room" of "room nine needs cleaning"."""
    numbered = tree.nodes[need - 1].tag == "CD"
    return need - 1 - (numbered and need - 2 in tree.children(need, "nsubj"))


def _mended(tree: Tree, need: int) -> Tree:
    thing, deed = _thing(tree, need), need + 1
    nodes = tree.nodes
    for place, node in enumerate(nodes):
        if place in {thing, need, deed} or node.head not in {need, deed}:
            continue
        of_thing = place < thing and node.relation in OF_THINGS
        head = thing if of_thing else need if place < need or node.relation in JOINED else deed
        tree = tree.changed(place, head=head)
    finite = "VBZ" if nodes[need].lower.endswith("s") else "VBP"
    tree = tree.changed(
        need, tag=finite, lemma=nodes[need].lower.removesuffix("s"), relation="ROOT", head=need
    )
    named = "NN" if nodes[thing].tag == "JJ" else nodes[thing].tag
    tree = tree.changed(thing, tag=named, relation="nsubj", head=need)
    lemma = nodes[deed].lemma if nodes[deed].tag == "VBG" else _bare(nodes[deed].lower, tree.lexicon)
    return tree.changed(deed, tag="VBG", lemma=lemma, relation="xcomp", head=need)


def _bare(deed: str, lexicon: Lexicon) -> str:
    """Give the bare form of a verb that is known, or else what is left of it: "washing", "mopping"."""
    stem = deed.removesuffix(PARTICIPLE)
    forms = (stem, f"{stem}e", stem[:-1] if stem[-1:] == stem[-2:-1] else stem)
    return next((form for form in forms if form in lexicon.orders), stem)
