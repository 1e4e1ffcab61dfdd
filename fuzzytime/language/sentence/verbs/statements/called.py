"""Who or what is called by a number or a letter, and acts: "robot 2 cleans the tank", "truck A arrives"."""

from collections.abc import Set as AbstractSet

from fuzzytime.english import is_participle
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.sentence.trees.tags import DETERMINERS, PRESENT, SUBJECTS
from fuzzytime.language.sentence.trees.tree import Node, Tree
from fuzzytime.language.sentence.verbs.statements.statement_trees import singular_verb

LEAST = 3
"""Words of "mum cooks today", at least: "mum cooks" alone tells nothing of when."""

ACTED = frozenset({"while", "when", "if"})
"""Kinds of clauses that name no event: somebody does something in them."""


ACTING = frozenset({"NNS", "NNPS", "VBZ"})
"""Tags of what ends like what one does."""

SINGULAR = frozenset({"NN", "NNP", "JJ"})
"""Tags of one that does something: of "the oven heats" a tree has the first for what those are like."""

NAMING = frozenset({"DT", "PRP$", "JJ", "NN", "NNP", "CD"})
"""Tags of words that stand before who or what it is."""


def with_called(tree: Tree, timed: AbstractSet[int]) -> Tree:
    """Give the tree of "room 12 checks out at ten" its verb, which was taken for a plural.

    ``timed`` are the words about time: one stands right behind the verb, or behind its particle.
    """
    first = 1 if tree.nodes and tree.nodes[0].lower == "the" else 0
    verb = first + 2
    if verb + 1 >= len(tree.nodes):
        return tree
    name, called, acting = tree.nodes[first : verb + 1]
    if not _acts(name, called, acting, tree.lexicon):
        return tree
    particle = verb + 1 if tree.nodes[verb + 1].lower in tree.lexicon.particles else None
    behind = verb + 1 if particle is None or verb + 1 in timed else verb + 2
    if behind not in timed:
        return tree
    told = _acting(tree, verb, {*range(verb + 1), tree.root})
    return told.changed(verb + 1, tag="RP", relation="prt") if behind == verb + 2 else told


def _acts(name: Node, called: Node, word: Node, lexicon: Lexicon) -> bool:
    """Whether a name, a number or a letter, and what may be a verb stand side by side."""
    known = lexicon.machines | lexicon.workers | lexicon.travelling | lexicon.measure_nouns
    numbered, lettered = called.text.isdigit(), len(called.text) == 1 and called.text.isupper()
    if name.lower not in known or not (numbered or lettered) or not word.may_act:
        return False
    finite = word.tag in {"NNS", "VBZ", "NNPS"} and word.lower.endswith("s")
    # "Train 14 guards at nine" asks for it.
    sure = lettered or not name.may_act or word.lower in lexicon.doing.timed | lexicon.passing
    return finite and sure


def worker_doing(tree: Tree, verb: int) -> str | None:
    """Give who does it, called by a number: "robot 2 cleans the tank"; None where nobody is.

    "Machine 3 starts at nine" asks for nothing.
    """
    closed = tree.lexicon.closed
    node = tree.nodes[verb]
    helping = tree.said(tree.children(verb, "aux"))
    if node.lower in tree.lexicon.doing.timed and not tree.children(verb, "dobj"):
        return None
    if not helping <= closed.future | closed.obligation | {"to", "can"} or tree.children(verb, "auxpass"):
        return None
    for place in tree.children(verb, "nsubj"):
        for first in (place - 1, place):
            name = tree.nodes[max(first, 0) : first + 2]
            numbered = len(name) == 2 and name[1].tag == "CD" and name[1].text.isdigit()
            if first >= 0 and numbered and name[0].lower in tree.lexicon.workers and first + 1 < verb:
                acts = node.tag in PRESENT or helping
                return " ".join(part.text for part in name) if acts else None
    return None


def person_due(tree: Tree, verb: int) -> str | None:
    """Give who must do something with a thing: "Tim must hand in his homework"; None for nobody.

    So it is who is asked for: "can Tim wash the car".
    """
    lexicon = tree.lexicon
    over = tree.nodes[verb].head if tree.nodes[verb].relation == "xcomp" else verb
    helping = tree.said(tree.children(verb, "aux")) - {"to"}
    helping |= set() if over == verb else {tree.nodes[over].lower}
    subjects = tree.children(over, "nsubj")
    asked = tree.nodes[0].relation == "aux" and helping <= lexicon.closed.requesting_modals
    due = bool(helping) and (asked or helping <= lexicon.closed.verbs_of_obligation)
    if not due or tree.nodes[verb].tag != "VB" or len(subjects) != 1 or not tree.children(verb, "dobj"):
        return None
    name = tree.nodes[subjects[0]]
    known = name.lower in lexicon.persons - lexicon.closed.persons_addressed and name.tag != "PRP"
    named = known or (name.tag == "NNP" and name.text[0].isupper())
    # "The kids must do their homework", "the night nurse should check bed nine"
    beside = [p for p in tree.children(subjects[0]) if tree.nodes[p].relation not in {"compound", "amod"}]
    led = all(tree.nodes[p].tag in DETERMINERS for p in beside)
    return tree.text[tree.nodes[tree.reach(subjects[0])[0]].start : name.end] if named and led else None


def with_doer(tree: Tree) -> Tree:
    """Give "robot 3 docks at noon", "lena phones the bank" its verb, which was taken for a plural."""
    root = tree.root
    verb = next((p for p in (root, root + 2) if _is_numbered(tree, p)), None)
    if verb is None and (_names_doer(tree) or _is_doing(tree)):
        # "Tom | rings Bob": a tree may have two roots
        return _acting(tree, 1, {p for p, node in enumerate(tree.nodes) if node.head == p})
    return tree if verb is None else _acting(tree, verb, {root})


def _names_doer(tree: Tree) -> bool:
    """Whether words begin with who does something: "lena phones the bank", "tom rings bob", "mum cooks"."""
    lexicon = tree.lexicon
    if len(tree.nodes) < LEAST or tree.nodes[0].lower not in lexicon.people or tree.root not in {0, 1, 2}:
        return False
    does, behind = tree.nodes[1], tree.nodes[2:3]
    bare = singular_verb(does.lower)
    acts = does.lower.endswith("s") and (does.may_act or bare in lexicon.addressing)
    led = any(node.tag in DETERMINERS or node.lower in lexicon.people for node in behind)
    return (
        acts
        and tree.nodes[0].relation not in SUBJECTS
        and (led or bare in lexicon.needing_nothing | lexicon.alone)
    )


def _is_doing(tree: Tree) -> bool:
    """Whether words begin with who does something then: "mum visiting sat"; but "dad meeting at ten"."""
    lexicon = tree.lexicon
    if not tree.nodes[1:] or tree.nodes[0].lower not in lexicon.people or tree.root not in {0, 1}:
        return False
    does, helping = tree.nodes[1], tree.children(tree.root, "aux", "auxpass", "neg")
    acts = does.may_act and is_participle(does.lower) and not helping
    return acts and does.lower not in lexicon.happening | lexicon.taken


def with_event(tree: Tree) -> Tree:
    """Give the tree of "charge drone 2 when drone 1 lands" the verb of its clause, taken for a plural."""
    for verb in range(3, len(tree.nodes)):
        marker, name, called, word = tree.nodes[verb - 3 : verb + 1]
        own = {verb - 2, verb - 1, verb}
        outside = [node.head for node in (name, called, word) if node.head not in own]
        begins = (marker.lower,) in tree.lexicon.clauses and word.tag == "NNS"
        if begins and outside and tree.root not in own and _acts(name, called, word, tree.lexicon):
            told = _acting(tree, verb, {verb - 2}).changed(verb, head=outside[0], relation="advcl")
            return told.changed(verb - 3, head=verb, relation="advmod")
    return tree


def _acting(tree: Tree, verb: int, heads: AbstractSet[int | None]) -> Tree:
    """Give a tree in which what stands before a word does it, and has what hung on ``heads``."""
    lemma = singular_verb(tree.nodes[verb].lower)
    tree = tree.hung([p for p, node in enumerate(tree.nodes) if node.head in heads], verb)
    tree = tree.changed(verb, tag="VBZ", lemma=lemma, head=verb, relation="ROOT")
    # "Drone 4 films the dam", "tom rings bob"
    things = ("appos",) if verb > 1 else ("appos", "ROOT", *SUBJECTS)
    tree = tree.hung([p for p in tree.children(verb, *things) if p > verb][:1], verb, "dobj")
    if verb == 1:
        return tree.changed(0, head=1, relation="nsubj")
    tree = tree.changed(verb - 2, tag="NN", head=verb, relation="nsubj")
    return tree.changed(verb - 1, head=verb - 2, relation="nummod")


def _is_numbered(tree: Tree, place: int | None) -> bool:
    """Whether a plural that may be a verb stands right behind a worker's number."""
    if place is None or not 2 <= place < len(tree.nodes):
        return False
    name, number, word = tree.nodes[place - 2 : place + 1]
    return word.tag == "NNS" and word.may_act and name.lower in tree.lexicon.workers and number.text.isdigit()


def with_clause(tree: Tree) -> Tree:
    """Give the tree of "while Dad milks", "while the stock simmers" its verb, taken for a plural.

    A plural hardly stands behind "while".
    """
    for verb in range(2, len(tree.nodes)):
        word, name = tree.nodes[verb], tree.nodes[verb - 1]
        ends = verb + 1 == len(tree.nodes) or not tree.nodes[verb + 1].text[0].isalnum()
        acts = word.tag in ACTING and word.may_act and word.lower.endswith("s") and name.head == verb
        acts = acts and word.lemma not in tree.lexicon.closed.lemmas_of_be
        first = verb - 1
        while first > 0 and tree.nodes[first - 1].tag in NAMING:
            first -= 1
        kind = tree.lexicon.clauses.get((tree.nodes[first - 1].lower,)) if first else None
        led = first < verb - 1 and tree.nodes[first].tag in DETERMINERS and name.tag in SINGULAR
        named = name.tag == "NNP" or name.lower in tree.lexicon.persons or led
        if kind not in ACTED or not (named and acts and ends):
            continue
        relation = "ROOT" if word.head == verb else "advcl"
        told = tree.changed(verb, tag="VBZ", lemma=singular_verb(word.lower), relation=relation)
        own = (p for p in range(first, verb - 1) if not first <= tree.nodes[p].head < verb - 1)
        told = told.changed(verb - 1, tag="NN" if name.tag == "JJ" else name.tag, relation="nsubj")
        return told.hung(own, verb - 1).changed(first - 1, head=verb, relation="mark")
    return tree
