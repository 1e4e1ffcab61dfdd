"""What happens and is not to be done, while others count from it: "the train leaves at 8:40, be early"."""

from collections.abc import Set as AbstractSet
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.sentence.actions import ARE
from fuzzytime.language.sentence.tree import Tree

SUBJECTS = ("nsubj", "nsubjpass", "expl")
BEFORE_ORDER = ("ccomp", "advcl", "parataxis", "dep", "nsubj", "csubj")
"""How trees join a statement to an order behind it."""

FINITE = frozenset({"VBZ", "VBP", "VBD", "VBG"})
JOINTS = frozenset({",", ";", "-", "so"})
DUE = frozenset({"should", "must", "has", "have", "needs"})
"""Helping verbs of what is asked for."""

PHASES = frozenset(
    {"starts", "begins", "ends", "finishes", "opens", "closes", "leaves", "departs", "arrives"}
)
"""What things with a time of their own do."""

FUTURE = frozenset({"will", "'ll", "’ll"})
TAKING = frozenset({"take", "last", "need", "require"})
ALL_OF_US = frozenset(["everyone", "everybody", "somebody", "someone", "people", "team", "me", "us", "you"])
"""Persons who may be asked: "everyone clean your desks"."""

OTHERS = frozenset({"he", "she"})

NOBODY = frozenset({"nobody", "none", "nothing"})
"""Subjects of what is denied, beside those with "no" before them."""

SURE_PHASES = PHASES - {"leaves"}
"""Those of them that are hardly ever things: "rake leaves at nine"."""

DETERMINERS = frozenset({"DT", "PRP$"})

ASKED = frozenset({"you", "that", "which", "who", "what"})
"""Subjects of no statement of its own."""

COUNTABLE = frozenset({"NN", "NNP"})
NOUNS = frozenset({"NN", "NNP", "NNS"})


def as_statement(tree: Tree, timed: AbstractSet[int], travelling: AbstractSet[str] = frozenset()) -> Tree:
    """Give the tree of "the train leaves at 8:40" its verb, which was taken for a plural: "train leaves".

    ``timed`` are the words about time: one stands right behind the verb. What is ``travelling`` leaves.
    """
    tree = _with_phase(tree, timed, travelling)
    root = tree.root
    if root is None or root + 1 not in timed:
        return tree
    if tree.nodes[root].tag == "NN" and tree.nodes[root].may_act and _is_led_by_plural(tree, root):
        # "My parents land at four"
        verb = replace(tree.nodes[root], tag="VBP")
        return Tree(tree.text, (*tree.nodes[:root], verb, *tree.nodes[root + 1 :]))
    if tree.nodes[root].tag not in {"NNS", "VBZ"}:
        return tree
    subject = _subject(tree, root)
    first, second = tree.nodes[0], tree.nodes[1].tag if len(tree.nodes) > 1 else ""
    # "Print the boarding passes today"
    ordered = root > 1 and first.may_act and first.lower == first.lemma.lower() and second in DETERMINERS
    if subject is None or ordered or tree.children(root, *SUBJECTS):
        return tree
    described = set(tree.children(root, "det", "poss", "amod", "compound")) - {subject}
    nodes = list(tree.nodes)
    nodes[root] = replace(nodes[root], tag="VBZ", lemma=singular_verb(nodes[root].lower))
    nodes[subject] = replace(nodes[subject], relation="nsubj")
    for place in described:
        nodes[place] = replace(nodes[place], head=subject)
    return Tree(tree.text, tuple(nodes))


def leaves(tree: Tree, place: int, travelling: AbstractSet[str]) -> bool:
    """Whether a word is what something on its way does: "coach leaves at 8:15", but "rake leaves at nine"."""
    known = 0 < place < len(tree.nodes) and tree.nodes[place - 1].lower in travelling
    return known and tree.nodes[place].lower in PHASES


def _with_phase(tree: Tree, timed: AbstractSet[int], travelling: AbstractSet[str]) -> Tree:
    """Give the tree of "guided tour starts at ten" its verb, where its first word was taken for one."""
    root, nodes = tree.root, tree.nodes
    sure = (p for p in range(2, len(nodes)) if p + 1 in timed and nodes[p].lower in SURE_PHASES)
    found = (p for p in range(1, len(nodes)) if p + 1 in timed and leaves(tree, p, travelling))
    verb = next(found, next(sure, None))
    if root != 0 or verb is None or nodes[verb].head != root or nodes[verb - 1].tag not in COUNTABLE:
        return tree
    if any(node.tag in DETERMINERS or node.tag in {"IN", ",", "CC"} for node in nodes[1:verb]):
        # "Check what starts at ten", "take the bus that leaves at ten"
        return tree
    turned = [
        replace(node, head=verb - 1, relation="compound")
        if p < verb
        else replace(node, head=verb)
        if node.head == root
        else node
        for p, node in enumerate(nodes)
    ]
    turned[verb] = replace(
        nodes[verb], tag="VBZ", lemma=singular_verb(nodes[verb].lower), head=verb, relation="ROOT"
    )
    turned[verb - 1] = replace(nodes[verb - 1], head=verb, relation="nsubj")
    return Tree(tree.text, tuple(turned))


def _is_led_by_plural(tree: Tree, verb: int) -> bool:
    """Whether several who do something stand right before a word that may be a verb."""
    return any(p == verb - 1 and tree.nodes[p].tag == "NNS" for p in tree.children(verb, "nsubj"))


def _subject(tree: Tree, verb: int) -> int | None:
    """Give the noun that a tree took for a part of a plural that is the verb: "laundry finishes"."""
    for place in tree.children(verb, "compound", "amod"):
        if place == verb - 1 and (tree.nodes[place].tag in COUNTABLE or tree.nodes[verb].lower in PHASES):
            return place
    return None


def singular_verb(verb: str) -> str:
    """Give the bare form of a verb in -s."""
    return verb[:-2] if verb.endswith(("sses", "shes", "ches", "xes")) else verb[:-1]


def order_behind_statement(tree: Tree, root: int, timed: AbstractSet[int]) -> int | None:
    """Give where an order begins behind a statement with a time: "we land at nine, call me"."""
    if tree.nodes[root].tag not in {"VB", "VBP"} or tree.children(root, "mark"):
        return None
    for place in tree.children(root, *BEFORE_ORDER):
        said = [p for p in tree.below(place) if tree.nodes[p].relation != "punct"]
        end = max(said) + 1
        joined = end < root and tree.nodes[end].lower in JOINTS
        marked = [p for p in tree.children(place, "mark", "advmod") if p < place]
        if joined and not marked and not timed.isdisjoint(said) and _is_statement(tree, place):
            # "The bus leaves at nine, so be there"
            return end + 1 + (tree.nodes[end].lower != "so" and tree.nodes[end + 1].lower == "so")
    return None


def second_statement(tree: Tree, place: int, timed: AbstractSet[int]) -> int | None:
    """Give where begins what is told beside something with a time: "doors open at nine, they come at ten".

    ``place`` is that of its verb, behind which a time of its own stands.
    """
    start = _start_of_statement(tree, place)
    if start is None or tree.nodes[start].lower in ASKED or not any(p > place for p in timed):
        return None
    joint = start - 1
    if joint > 0 and tree.nodes[joint].lower == "and" and tree.nodes[joint - 1].text == ",":
        joint -= 1
    joined = joint > 0 and tree.nodes[start - 1].lower in {*JOINTS, "and", "&"}
    return start if joined and joint - 1 in timed else None


def _start_of_statement(tree: Tree, place: int) -> int | None:
    """Give where a statement begins, by the place of its verb, which a tree may take for a plural."""
    node = tree.nodes[place]
    subjects = [p for p in tree.children(place, *SUBJECTS) if p < place]
    if node.tag in FINITE - {"VBG"} and subjects:
        return min(tree.below(subjects[-1]))
    if node.lower in PHASES | {phase[:-1] for phase in PHASES} and place > 0:
        # "The last bus leaves", "doors open"
        singular = node.tag == "NNS" and tree.nodes[place - 1].tag in COUNTABLE
        plural = not node.lower.endswith("s") and tree.nodes[place - 1].tag == "NNS"
        if singular or plural:
            first = place - 1
            while first > 0 and tree.nodes[first - 1].tag in {*DETERMINERS, *COUNTABLE, "JJ", "NNS"}:
                first -= 1
            return first
    return None


def result_behind_statement(tree: Tree, place: int, root: int, timed: AbstractSet[int]) -> int | None:
    """Give where begins what should be so by then: "the boss arrives at ten, coffee should be ready"."""
    helping = {tree.nodes[p].lower for p in tree.children(place, "aux")}
    if place <= root or not helping & DUE or not _is_statement(tree, root) or timed.isdisjoint(range(place)):
        return None
    start = min(p for p in tree.below(place) if tree.nodes[p].relation != "punct")
    return start if start > root and tree.nodes[start - 1].lower in {*JOINTS, "and"} else None


def _is_statement(tree: Tree, place: int) -> bool:
    """Whether a verb before an order says what happens; a tree may take it for who does what is ordered."""
    node = tree.nodes[place]
    if node.relation in SUBJECTS:
        return node.tag in {"VBZ", "NNS"} and _subject(tree, place) is not None
    taken = node.tag == "VBZ" and _subject(tree, place) is not None
    return node.tag in FINITE and (taken or bool(tree.children(place, *SUBJECTS)))


def _has_thing(tree: Tree, verb: int) -> bool:
    """Whether somebody has something, and not to do it: "Tom has his break at ten"."""
    return bool(tree.children(verb, "dobj")) and not tree.children(verb, "xcomp", "ccomp")


def others_do(tree: Tree, verb: int, helping: AbstractSet[str], lexicon: Lexicon) -> bool:
    """Whether somebody who is named does it, and is not asked to: "the kids finish school at three".

    ``helping`` are the verbs that help it.
    """
    node = tree.nodes[verb]
    subjects = [tree.nodes[p] for p in tree.children(verb, "nsubj") if p < verb]
    if not subjects or node.lemma in lexicon.wanting or (node.lemma == "have" and not _has_thing(tree, verb)):
        return False
    called = {subjects[0].lower, *(tree.nodes[p].lower for p in tree.below(verb) if p < verb)}
    named = bool(((lexicon.persons | OTHERS) - ALL_OF_US) & called)
    if not helping and node.tag == "VBZ" and subjects[0].tag in {"NN", "NNP"}:
        # No order ends in -s: "the caretaker cuts the grass"; but a machine may be asked by its name.
        named = named or subjects[0].lower not in lexicon.machines
    if node.tag == "VBG" and helping <= ARE and subjects[0].tag in NOUNS:
        # "Tom is washing the car at five"
        return bool(helping) and (named or subjects[0].lower not in lexicon.machines)
    finite = node.tag in {"VBZ", "VBP"} if not helping else helping <= FUTURE | {"can"}
    return named and finite
