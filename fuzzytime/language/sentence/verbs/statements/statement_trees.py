"""Trees of what happens, mended where a model takes the verb for a noun: "the train leaves at 8:40"."""

from collections.abc import Set as AbstractSet

from fuzzytime.language.sentence.trees.tags import DETERMINERS, GRAMMATICAL_SUBJECTS, SINGULAR
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.language.sentence.verbs.statements.statements import behind_particles, plural_subject

BESIDE_NAMES = frozenset({"IN", "DT", "PRP$", "JJ", "NN", "NNP", "CD"})
"""Tags of words that say where those are who do something: "the guests in room 12"."""


def as_statement(tree: Tree, timed: AbstractSet[int], travelling: AbstractSet[str]) -> Tree:
    """Give the tree of "the train leaves at 8:40" its verb, which was taken for a plural: "train leaves".

    ``timed`` are the words about time: one stands right behind the verb. What is ``travelling`` leaves.
    """
    tree = _with_being(_with_got(_with_phase(tree, timed, travelling)), timed)
    tree = with_plural(_with_subject(_with_done(tree)), timed)
    root = tree.root
    if behind_particles(tree, root) not in timed:
        return tree
    if tree.nodes[root].tag in {"NN", "JJ"} and tree.nodes[root].may_act and is_led_by_plural(tree, root):
        # "My parents land at four", "the guests in room 12 check out at ten"
        tree = tree.changed(root, tag="VBP", lemma=tree.nodes[root].lower)
        for place in tree.children(root, "nummod"):
            tree = tree.changed(place, head=place - 1)
        return tree
    if root + 1 not in timed:
        return tree
    if tree.nodes[root].tag not in {"NNS", "VBZ"}:
        return tree
    sure = _with_sure(tree, root)
    if sure is not None:
        return sure
    subject = plural_subject(tree, root)
    first, second = tree.nodes[0], tree.nodes[1].tag if len(tree.nodes) > 1 else ""
    # "Print the boarding passes today"
    ordered = root > 1 and first.may_act and first.lower == first.lemma.lower() and second in DETERMINERS
    if subject is None or ordered or tree.children(root, *GRAMMATICAL_SUBJECTS):
        return tree
    described = set(tree.children(root, "det", "poss", "amod", "compound")) - {subject}
    tree = tree.changed(root, tag="VBZ", lemma=singular_verb(tree.nodes[root].lower))
    return tree.changed(subject, relation="nsubj").hung(described, subject)


def _with_sure(tree: Tree, root: int) -> Tree | None:
    """Give "the post office closes at five" its verb, before which a tree has what does it already."""
    named = [p for p in tree.children(root, *GRAMMATICAL_SUBJECTS) if p < root]
    node = tree.nodes[root]
    if node.tag != "NNS" or not named or node.lower not in tree.lexicon.doing.surely_timed:
        return None
    return tree.changed(root, tag="VBZ", lemma=singular_verb(node.lower))


def leaves(tree: Tree, place: int, travelling: AbstractSet[str]) -> bool:
    """Whether a word is what something on its way does: "coach leaves at 8:15", but "rake leaves at nine"."""
    known = 0 < place < len(tree.nodes) and tree.nodes[place - 1].lower in travelling
    return known and tree.nodes[place].lower in tree.lexicon.doing.timed


def _with_phase(tree: Tree, timed: AbstractSet[int], travelling: AbstractSet[str]) -> Tree:
    """Give the tree of "guided tour starts at ten" its verb, where its first word was taken for one."""
    root, nodes = tree.root, tree.nodes
    event = bool(nodes) and nodes[0].lower in tree.lexicon.happening | tree.lexicon.taken
    # "School finishes at three"; but "polish finishes at four"
    sure = (
        p
        for p in range(1 if event else 2, len(nodes))
        if p + 1 in timed and nodes[p].lower in tree.lexicon.doing.surely_timed
    )
    found = (p for p in range(1, len(nodes)) if p + 1 in timed and leaves(tree, p, travelling))
    verb = next(found, next(sure, None))
    if root != 0 or verb is None or nodes[verb].head != root:
        return tree
    if nodes[verb - 1].tag not in SINGULAR and not (event and verb == 1):
        return tree
    if any(node.tag in DETERMINERS or node.tag in {"IN", ",", "CC"} for node in nodes[1:verb]):
        # "Check what starts at ten", "take the bus that leaves at ten"
        return tree
    behind = [p for p in tree.children(root) if p > verb]
    tree = tree.hung(range(verb), verb - 1, "compound").hung(behind, verb)
    tree = tree.changed(verb, tag="VBZ", lemma=singular_verb(nodes[verb].lower), head=verb, relation="ROOT")
    return tree.changed(verb - 1, tag="NN", head=verb, relation="nsubj")


def _with_subject(tree: Tree) -> Tree:
    """Give "the road is closed" what is so, which a tree may hang on the helping verb."""
    root = tree.root
    if tree.nodes[root].tag != "VBN":
        return _with_name(tree)
    helping = [
        p for p in tree.children(root, "auxpass") if tree.nodes[p].lower in tree.lexicon.closed.present_be
    ]
    subjects = [p for verb in helping for p in tree.children(verb, "nsubj")]
    if not subjects:
        return tree
    return tree.changed(subjects[0], head=root, relation="nsubjpass")


def _with_done(tree: Tree) -> Tree:
    """Give "skip collected at three" what is collected, and "desk manned from eight" its participle."""
    root = tree.root
    if tree.children(root, "aux", "dobj"):
        return tree
    nodes = tree.nodes
    taken = [p for p in tree.children(root, "auxpass") if p == root - 1 == 0 and nodes[p].tag == "VB"]
    if nodes[root].tag == "VBN" and taken and nodes[0].lemma not in tree.lexicon.causing:
        return tree.changed(0, tag="NN", relation="nsubjpass")
    sites = tree.lexicon.beside.sites
    named = [
        p
        for p in tree.children(root, "nsubj")
        if p == root - 1 and (nodes[p].tag in {"NN", "NNS"} or nodes[p].lower in sites)
    ]
    so = nodes[root].lower in tree.lexicon.standing | tree.lexicon.results
    if nodes[root].tag == "VBD" and so and named and not tree.children(named[0], "det", "poss"):
        return tree.changed(root, tag="VBN")
    return tree


def _with_name(tree: Tree) -> Tree:
    """Give "at 9:15 Atlas drives to bay 3" who does it, whom a tree took for a part of the verb's name."""
    root = tree.root
    if tree.nodes[root].tag != "VBZ" or tree.children(root, *GRAMMATICAL_SUBJECTS):
        return tree
    named = [p for p in tree.children(root, "compound", "npadvmod") if p == root - 1]
    if not named or tree.nodes[named[0]].tag != "NNP":
        return tree
    return tree.changed(named[0], relation="nsubj")


def _with_got(tree: Tree) -> Tree:
    """Give "I've got a meeting at ten" the verb that it means: to have; and of who comes, what they do."""
    root = tree.root
    if tree.nodes[root].lower != "got" or tree.children(root, "xcomp"):
        return tree
    helping = [
        p
        for p in (*tree.children(root, "aux", "auxpass"), *range(root - 1, root))
        if p >= 0 and tree.nodes[p].lower in tree.lexicon.closed.have_before_got
    ]
    coming = [p for p in tree.children(root, "ccomp") if tree.nodes[p].tag == "VBG"]
    if coming and helping and tree.children(coming[0], "nsubj"):
        told = tree.hung((root, *tree.children(root)), coming[0], "dep")
        return told.changed(coming[0], relation="ROOT", tag="VBZ")
    if not helping or not tree.children(root, "dobj"):
        return tree
    having = tree.changed(root, lemma="have", tag="VBP").hung(helping, root, "dep")
    return having.hung(tree.children(root, "nsubjpass"), root, "nsubj")


def _with_being(tree: Tree, timed: AbstractSet[int]) -> Tree:
    """Give "visiting is two till four" what is then, which was taken for what is done."""
    root = tree.root
    if tree.nodes[root].lower in tree.lexicon.closed.present_be and root + 1 in timed:
        return tree.hung((p for p in tree.children(root, "csubj") if p == root - 1), root, "nsubj")
    return tree


def singular_verb(verb: str) -> str:
    """Give the bare form of a verb in -s."""
    return verb[:-2] if verb.endswith(("sses", "shes", "ches", "xes")) else verb[:-1]


def with_plural(tree: Tree, timed: AbstractSet[int]) -> Tree:
    """Give the tree of "the shops open at nine" its verb, which was taken for how they are."""
    root = tree.root
    if tree.nodes[root].tag != "NNS" or not tree.children(root, "det", "poss"):
        return tree
    verb = root + 1
    if (
        verb + 1 not in timed
        or tree.nodes[verb].lower not in tree.lexicon.doing.several_timed
        or tree.nodes[verb].head != root
    ):
        return tree
    told = tree.hung((p for p in tree.children(root) if p > verb), verb)
    told = told.changed(verb, tag="VBP", lemma=tree.nodes[verb].lower, head=verb, relation="ROOT")
    return told.changed(root, head=verb, relation="nsubj")


def is_led_by_plural(tree: Tree, verb: int) -> bool:
    """Whether several who do something stand before a word that may be a verb, with where they are."""
    led = (p for p in tree.children(verb, "nsubj") if tree.nodes[p].tag == "NNS" and p < verb)
    return any(all(node.tag in BESIDE_NAMES for node in tree.nodes[p + 1 : verb]) for p in led)
