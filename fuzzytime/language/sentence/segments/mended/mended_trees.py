"""Trees mended where a word that is done was taken for a thing, or a thing for what is done."""

from collections.abc import Set as AbstractSet

from fuzzytime.language.sentence.segments.mended.amounts import with_amounts
from fuzzytime.language.sentence.segments.mended.forms_of_be import (
    with_clipped,
    with_future,
    with_owners_place,
    with_states,
    with_there,
)
from fuzzytime.language.sentence.segments.mended.joined_things import with_list
from fuzzytime.language.sentence.segments.mended.mended_verbs import (
    does_to_person,
    with_thing_done,
    with_verb,
)
from fuzzytime.language.sentence.trees.tags import NOUNS
from fuzzytime.language.sentence.trees.tree import Tree

LEAST_DONE = 3
"""Words of "do ward 7"."""

NTH = 3
"""Words before the thing in "prune the second rose"."""

BESIDE_DONE = frozenset({"prep", "agent", "npadvmod", "advmod", "punct", "cc", "conj", "prt"})
"""How what hangs on a participle that names nothing."""

OF_TIMES = frozenset({"prep", "pobj", "punct", "nummod"})
"""How what hangs on a word that stands beside when."""

TWO = 2
"""Words of "let's film" before what is done, of "remind me", of a thing and where it is: "oven on"."""

WITHIN = ("advcl", "xcomp", "relcl", "acl", "ccomp")
"""How a tree hangs such a verb on the clause before it."""


def as_done(tree: Tree) -> Tree:
    """Give an order its verb, where what is called like one was taken for it."""
    if not tree.nodes:
        return tree
    tree = with_owners_place(with_future(with_states(with_there(with_clipped(tree)))))
    tree = _with_manner(_with_name_in_front(_with_numbered_things(with_amounts(tree))))
    tree = does_to_person(tree) or tree
    mended = _does_named(tree) or _lets(tree) or _does_nth(tree)
    mended = mended or _lets_know(tree) or with_verb(tree)
    return with_list(_wants_done(mended or tree))


def as_somewhere(tree: Tree, timed: AbstractSet[int]) -> Tree:
    """Give "home by five" a place in front, which a tree takes for what is done: nothing is homed.

    What it is for may stand behind it, and not how it is done: "up at five to pack".
    """
    first, somewhere = tree.nodes[0], tree.lexicon.closed.adverbs_of_arrival & tree.lexicon.beside.states
    aim, root = max(timed, default=0) + 1, tree.root
    led = first.lower in tree.lexicon.beside.states and timed == {*range(1, aim)} and root == aim + 1
    if led and first.tag in {"RB", "RP", "IN"} and tree.nodes[aim].lower == "to":
        return tree.changed(0, tag="RB", relation="ROOT", head=0).changed(root, relation="advcl", head=0)
    alone = {node.relation for node in tree.nodes[1:]} <= OF_TIMES
    return tree.changed(0, tag="RB") if alone and first.is_verb and first.lower in somewhere else tree


def as_thing(tree: Tree, timed: AbstractSet[int]) -> Tree:
    """Give "porch light off at one", "another viewing at two" the thing, which a tree has for what is done.

    Nothing is porched, nobody does the viewing, and no team meets anything at a "team meeting".
    """
    end, again = min(timed - {0}, default=0), tree.lexicon.closed.adverbs_of_repetition
    if [node.tag for node in tree.nodes[:end]] == ["DT", "VBG"]:
        return tree.changed(0, relation="det").changed(1, tag="NN")
    if _names_event(tree, end):
        for place in range(end - 1):
            tree = tree.changed(place, relation="compound")
        return tree.changed(end - 1, tag="NN")
    said = [node for node in tree.nodes[:end] if node.lower not in again]
    if len(said) < TWO or said[-1].lower not in tree.lexicon.particles or said[0].may_act:
        return tree
    named = said[0].is_bare and all(node.tag.startswith("NN") for node in said[1:-1])
    return tree.changed(0, tag="NN") if named else tree


def _names_event(tree: Tree, end: int) -> bool:
    """Whether the words before a time are nouns, and the last of them what happens: "team meeting"."""
    last = end - 1
    if last <= 0 or tree.root != last or tree.nodes[last].tag != "VBG":
        return False
    event = any(tree.nodes[last].lower in words for words in (tree.lexicon.happening, tree.lexicon.taken))
    return event and all(node.tag.startswith("NN") for node in tree.nodes[:last])


def _with_manner(tree: Tree) -> Tree:
    """Give "start the addition, dropwise over an hour" its adverb, which a tree takes for a second verb."""
    for place in range(1, len(tree.nodes)):
        node = tree.nodes[place]
        known = node.may_act or not node.lower.endswith(tuple(tree.lexicon.closed.endings_of_manner))
        if node.is_verb and not known and node.relation == "conj":
            tree = tree.changed(place, tag="RB", relation="advmod").hung(tree.children(place), node.head)
    return tree


def _does_named(tree: Tree) -> Tree | None:
    """Give "do the school run" its verb: nobody who is asked to do something has an article."""
    root = tree.root
    if not tree.nodes or tree.nodes[0].lower != "do" or tree.nodes[0].relation != "aux" or root < LEAST_DONE:
        return None
    subjects = tree.children(root, "nsubj")
    led = bool(subjects) and tree.nodes[root - 1] is tree.nodes[subjects[0]] and tree.nodes[1].tag == "DT"
    if not led or tree.nodes[0].head != root or tree.nodes[-1].text == "?" or tree.children(root, "dobj"):
        return None
    return with_thing_done(tree, root).changed(root - 1, relation="compound", head=root)


def _lets_know(tree: Tree) -> Tree | None:
    """Give "let ben know" its verb, which a tree takes for one that helps another."""
    root, nodes = tree.root, tree.nodes
    helps = bool(nodes) and nodes[0].lower in tree.lexicon.letting and nodes[0].relation == "aux"
    if not helps or nodes[0].head != root or nodes[root].lemma != "know":
        return None
    return tree.changed(0, head=0, relation="ROOT", tag="VB").changed(root, head=0, relation="ccomp")


def _with_numbered_things(tree: Tree) -> Tree:
    """Give what has a number as a thing, which was taken for what is done: "start pump 2", "test pump 1"."""
    for thing in range(1, len(tree.nodes) - 1):
        verb, node, number = tree.nodes[thing - 1 : thing + 2]
        named = node.tag.startswith("VB") and node.lower in tree.lexicon.machines and number.tag == "CD"
        if not named or not verb.may_act or verb.lower != verb.lemma or verb.tag not in {"VB", "VBP", "NN"}:
            continue
        first = node.head == thing or (node.head == thing - 1 and node.relation in {"xcomp", "ccomp", "dobj"})
        if not first:
            continue
        tree = tree.hung(tree.children(thing), thing - 1).changed(thing - 1, tag="VB")
        if node.head == thing:
            tree = tree.changed(thing - 1, relation="ROOT", head=thing - 1)
        tree = tree.changed(thing, tag="NN", relation="dobj", head=thing - 1)
        tree = tree.changed(thing + 1, relation="nummod", head=thing)
    return tree


def _with_name_in_front(tree: Tree) -> Tree:
    """Give "telly for half an hour" the thing that it names, which was taken for how the rest is."""
    if tree.root != 1 or tree.nodes[1].tag != "IN" or tree.nodes[0].head != 1:
        return tree
    if tree.nodes[0].lower not in tree.lexicon.happening | tree.lexicon.taken:
        return tree
    return tree.changed(0, tag="NN", relation="ROOT", head=0).changed(1, relation="prep", head=0)


def _does_nth(tree: Tree) -> Tree | None:
    """Give "prune the second rose" its thing, which was taken for what rose: behind a number it is one."""
    if len(tree.nodes) <= NTH:
        return None
    first, led, number, thing = tree.nodes[: NTH + 1]
    counted = led.tag == "DT" and number.lower in tree.lexicon.ordinals and number.relation == "nsubj"
    if not counted or number.head != NTH or thing.tag != "VBD" or not first.may_act:
        return None
    return with_thing_done(tree, NTH).changed(1, head=NTH).changed(2, relation="amod", head=NTH)


def _wants_done(tree: Tree) -> Tree:
    """Give "I'd like the lawn mown" what is to be done, where that was taken for what the lawn is like.

    "I want the book called Dune" names one.
    """
    root = tree.root
    if tree.nodes[root].lemma not in tree.lexicon.doing.wishing or not tree.children(root, "nsubj"):
        return tree
    for done in tree.children(root, "ccomp"):
        if tree.nodes[done].tag == "VBD" and _is_of_thing(tree, done):
            # "I want the van washed": what is to be done was taken for what was.
            return tree.changed(done, tag="VBN")
    for thing in tree.children(root, "dobj"):
        for done in tree.children(root, "xcomp"):
            if thing < done and "to" in tree.said(tree.children(done, "aux")):
                # "I'd like the kettle to come on at six"
                return tree.changed(done, relation="ccomp").changed(thing, relation="nsubj", head=done)
        for done in tree.children(thing, "acl"):
            named = [p for p in tree.children(done) if tree.nodes[p].relation not in BESIDE_DONE]
            if done == thing + 1 and tree.nodes[done].tag == "VBN" and not named:
                told = tree.changed(done, relation="ccomp", head=root)
                return told.changed(thing, relation="nsubj", head=done)
    return tree


def _is_of_thing(tree: Tree, done: int) -> bool:
    """Whether something is done with a named thing, and nobody says when: "I want the van washed"."""
    subjects = tree.children(done, "nsubj", "nsubjpass")
    named = bool(subjects) and tree.nodes[subjects[0]].tag in NOUNS
    return named and not tree.children(done, "mark", "dobj")


def _lets(tree: Tree) -> Tree | None:
    """Give "let's film at noon" its second verb, which was taken for a thing."""
    if len(tree.nodes) <= TWO or tree.root != 0 or tree.nodes[0].lower != "let":
        return None
    us, done = tree.nodes[1], tree.nodes[TWO]
    if us.lower not in {"'s", "’s", "us"} or us.head != TWO or done.tag != "NN" or not done.may_act:
        return None
    return tree.changed(TWO, tag="VB", relation="ccomp").changed(1, relation="nsubj")


def as_order(tree: Tree) -> Tree:
    """Give a tree a verb for its first word, which has an object and was taken for a noun: "phone them"."""
    tree = _with_manner(tree)
    root = tree.root
    first = tree.nodes[0] if tree.nodes else None
    if first is None or root != 0 or not first.tag.startswith("NN") or not first.may_act:
        return tree
    return tree.changed(0, tag="VB") if tree.children(0, "dobj") else tree


def as_acting(tree: Tree) -> Tree:
    """Give what one does next its verb, which may be a plural too: "robot 2 cleans the tank, then docks"."""
    if not tree.nodes or tree.root != 0 or tree.nodes[0].tag not in {"NNS", "VB"}:
        return tree
    return tree.changed(0, tag="VBZ")


def with_reminded(tree: Tree) -> Tree:
    """Give "remind me once it is over to lock up" what is to be done, which a tree hangs on the clause.

    What says more of a word of the clause stays there: "remind me when it is time to leave".
    """
    root = tree.root
    if root != 0 or tree.nodes[0].lemma not in tree.lexicon.addressing or tree.children(root, "xcomp"):
        return tree
    reminded = tree.children(root, "dobj", "dative")
    for verb in range(TWO + 1, len(tree.nodes)):
        to = verb - 1
        node = tree.nodes[verb]
        led = tree.nodes[to].lower == "to" and tree.nodes[to].head == verb and node.tag == "VB"
        if not reminded or not led or node.relation not in WITHIN or node.head == root:
            continue
        if not _ends_clause(tree, to - 1):
            continue
        return tree.changed(verb, head=root, relation="xcomp")
    return tree


def _ends_clause(tree: Tree, place: int) -> bool:
    """Whether no verb and no word that "to" says more of stands at a place."""
    node = tree.nodes[place]
    site = node.lower in tree.lexicon.beside.sites
    return site or not (node.tag.startswith(("VB", "MD")) or node.lower in tree.lexicon.doing.more_said_of)
