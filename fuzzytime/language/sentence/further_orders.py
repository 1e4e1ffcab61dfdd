"""Where further instructions of one sentence begin, by its tree: at bare verbs beside the first."""

from collections.abc import Sequence

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Span
from fuzzytime.language.sentence.actions import ARE, gone_to_do
from fuzzytime.language.sentence.orders_beside_times import (
    IMPERATIVE,
    JOINTS,
    is_led_by_time,
    is_order_before_time,
    stands_alone,
)
from fuzzytime.language.sentence.segments import ARTICLES
from fuzzytime.language.sentence.statements import (
    FUTURE,
    being_behind_order,
    goes_on,
    order_behind_statement,
    result_behind_statement,
    second_statement,
)
from fuzzytime.language.sentence.tree import Node, Tree

SHORTEST = 2
"""Words of an order at least, before a participle that goes on beside it."""

TELLING = frozenset({"should", "will", "'ll", "must"})
"""Helping verbs of what is told behind an order: "watch the rice, it should be done in ten minutes"."""

PAST_ALIKE = frozenset({"lay", "saw"})
"""Bare verbs that are the past of another."""

THEM = frozenset({"it", "them"})
FINITE = frozenset({"VBZ", "VBD", "VBP", "MD"})
SUBJECTS = ("nsubj", "nsubjpass", "csubj", "expl")
EMBEDDED = frozenset({"xcomp", "ccomp", "relcl", "acl", "pcomp"})
COORDINATE = ("conj", "dep", "parataxis", "ccomp", "advcl", "appos")


def further_verbs(tree: Tree, root: int, lexicon: Lexicon, times: Sequence[Span] = ()) -> list[int]:
    """Give the words at which further instructions of one sentence begin: imperatives beside the first.

    "Chop the onions, fry them and serve": the tree calls them conjuncts, or mistakes them for something
    else; what counts is a bare verb without a subject behind "and" or a comma.
    """
    timed = {place for span in times for place in tree.at(*span)}
    first = (_follows_order(tree, root), order_behind_statement(tree, root, timed))
    found = [start for start in first if start is not None]
    for place in range(len(tree.nodes)):
        if place in timed and place != root:
            continue
        start = _start_at(tree, place, root, timed, lexicon)
        if start is not None:
            found.append(start)
    return found


def _start_at(tree: Tree, place: int, root: int, timed: set[int], lexicon: Lexicon) -> int | None:
    """Give where the further instruction of a word begins; None where it has none."""
    told = result_behind_statement(tree, place, root, timed)
    told = second_statement(tree, place, timed) if told is None else told
    told = being_behind_order(tree, place, timed) if told is None else told
    if told is not None:
        return told
    if _goes_on(tree, place, timed, lexicon) or _is_second_statement(tree, place, root):
        return place
    if goes_on(tree, place, root, timed):
        return place
    if place > 1 and place != root:
        if _follows_so(tree, place, timed):
            return place
        if _is_overlooked(tree, place, timed, lexicon):
            return place
        if is_led_by_time(tree, place, timed, lexicon):
            return _behind_joint(tree, place, timed)
    if place > 1 and _is_passive_order(tree, place) and tree.nodes[place - 1].lower in JOINTS:
        return place
    return _start_of_coordinate(tree, place, root, timed)


def _follows_so(tree: Tree, place: int, timed: set[int]) -> bool:
    """Whether a bare verb follows what has a time and "so": "guests are coming at 8, so hoover at 7"."""
    node, before = tree.nodes[place], place - 2
    if before > 0 and tree.nodes[before].text == ",":
        before -= 1
    bare = node.may_act and node.lower == node.lemma
    return bare and tree.nodes[place - 1].lower == "so" and before in timed


def _start_of_coordinate(tree: Tree, place: int, root: int, timed: set[int]) -> int | None:
    """Give where begins what a bare verb asks for that the tree joins to the first: "…, and fry them"."""
    node = tree.nodes[place]
    if place in {0, root} or not _is_bare(node) or node.relation not in COORDINATE:
        return None
    denied = _denied_from(tree, place)
    if tree.children(place, *SUBJECTS, "mark") or (denied is None and tree.children(place, "aux")):
        return None
    if any(tree.nodes[p].lower == node.lower for p in tree.children(root, "dobj")):
        # "Weld seam 3 at 11 and seam 4 at 12"
        return None
    start = _behind_joint(tree, _behind_place(tree, place) if denied is None else denied, timed)
    if start == 0 or tree.nodes[start - 1].lower not in JOINTS or _is_embedded(tree, place, root):
        return None
    if gone_to_do(tree, root) == place:
        return None
    return start if place > root or _leads(tree, place, root) else None


def _denied_from(tree: Tree, place: int) -> int | None:
    """Give where a verb begins that is denied: "fill it but don't switch it on"."""
    helping = tree.children(place, "aux")
    denied = bool(tree.children(place, "neg")) and [tree.nodes[p].lower for p in helping] == ["do"]
    return helping[0] if denied else None


def _is_overlooked(tree: Tree, place: int, timed: set[int], lexicon: Lexicon) -> bool:
    """Whether it is an order that a tree took for something else: "wipe the rug and empty the bins"."""
    alone = tree.nodes[place].lower in lexicon.alone
    return (
        (_governs(tree, place, lexicon) and (alone or place + 1 not in timed))
        or is_order_before_time(tree, place, timed)
        or (
            place - 2 in timed and (stands_alone(tree, place, lexicon) or _has_numbered(tree, place, lexicon))
        )
    )


def _has_numbered(tree: Tree, place: int, lexicon: Lexicon) -> bool:
    """Whether what may be a verb stands before what is called by a number: "…, clear bay 3"."""
    behind = tree.nodes[place + 1 : place + 3]
    called = len(behind) > 1 and behind[0].lower in lexicon.machines and behind[1].tag == "CD"
    return called and tree.nodes[place].may_act and tree.nodes[place - 1].text == ","


def _goes_on(tree: Tree, place: int, timed: set[int], lexicon: Lexicon) -> bool:
    """Whether a participle with its own time goes on beside an order: "simmer it, stirring every ten"."""
    node = tree.nodes[place]
    if node.tag != "VBG" or node.relation in EMBEDDED or node.lemma in lexicon.indicators:
        return False
    behind = next(
        (p for p in range(place, len(tree.nodes)) if tree.nodes[p].lower in JOINTS), len(tree.nodes)
    )
    apart = place - 1 in timed or tree.nodes[place - 1].text == ","
    before = any(earlier in timed for earlier in range(place))
    return (
        place >= SHORTEST and apart and before and any(later in timed for later in range(place + 1, behind))
    )


def _is_second_statement(tree: Tree, place: int, root: int) -> bool:
    """Whether it is what the same thing does next: "the roast goes in at ten and comes out at two"."""
    node = tree.nodes[place]
    beside = node.relation == "conj" and node.head == root and tree.nodes[place - 1].lower in JOINTS
    named = bool(tree.children(root, *SUBJECTS))
    told = tree.nodes[root].tag == node.tag == "VBZ" and named
    # "The show will last an hour and start at eight"
    helping = {tree.nodes[p].lower for p in tree.children(root, "aux")}
    told = told or (named and bool(helping) and helping <= FUTURE | {"should"} and node.tag == "VB")
    return beside and told and not tree.children(place, *SUBJECTS, "aux")


def _behind_joint(tree: Tree, start: int, timed: set[int]) -> int:
    """Give where an instruction begins with the time in front: "…, and by seven have the soup ready"."""
    first = start
    while first and first - 1 in timed:
        first -= 1
    behind = first
    while behind and (behind - 1 in timed or tree.nodes[behind - 1].lower == ","):
        behind -= 1
    # "Boil it, and before that, wash it"
    led = behind > 0 and tree.nodes[behind - 1].lower in {"and", "&", "but"}
    return behind if led else first


def _governs(tree: Tree, place: int, lexicon: Lexicon) -> bool:
    """Whether a word taken for no verb has an object, or a particle: "wipe the rug and empty the bins"."""
    node, before = tree.nodes[place], tree.nodes[place - 1].lower
    if node.tag == "NN" and before in {"and", "&", ","} and node.lower in lexicon.alone:
        return True
    if node.tag not in {"NN", "NNP", "JJ"} or before not in JOINTS or place + 2 >= len(tree.nodes):
        return False
    behind, further = tree.nodes[place + 1].lower, tree.nodes[place + 2].lower
    if node.lower in lexicon.particles.get(behind, ()):
        return True
    bare = node.tag == "NN" and not tree.children(place, "det", "amod", "compound", "poss", "nummod")
    if bare and (behind in THEM or (tree.nodes[place + 1].tag == "IN" and further in THEM)):
        # "Leave it for an hour and pat it dry", "move the sofa, vacuum behind it"
        return True
    if node.relation in COORDINATE and node.may_act and behind in ARTICLES and tree.children(place, "dobj"):
        # "The painters come at nine, clear the room"
        return True
    return node.relation == "conj" and before in {"and", "&"} and behind in ARTICLES


def _is_passive_order(tree: Tree, place: int) -> bool:
    """Whether it is the "get" of "get dressed", beside another order."""
    node, over = tree.nodes[place], tree.nodes[tree.nodes[place].head]
    bare = node.tag in IMPERATIVE and node.relation == "auxpass" and node.lemma == "get"
    return bare and over.relation in COORDINATE and not tree.children(node.head, *SUBJECTS)


def _is_bare(node: Node) -> bool:
    """Whether a verb has its bare form, whatever tense it was taken for: "put" is a past form too."""
    past = node.tag in {"VBD", "VBN"} and (node.lower == node.lemma or node.lower in PAST_ALIKE)
    # "Deburr it": what ends in no -s has no other person.
    bare = node.tag in IMPERATIVE or (node.tag == "VBZ" and not node.lower.endswith("s"))
    return bare or past


def _follows_order(tree: Tree, root: int) -> int | None:
    """Give where the root begins, if it is a second order: "weld it, wait" has its first below it.

    So has a statement behind an order: "bring my coat, we leave at three".
    """
    subjects = tree.children(root, *SUBJECTS)
    start = min([root, *tree.below(subjects[0])]) if subjects else _first_of(tree, root)
    brought = [p for p in tree.children(root, "aux") if p == start - 1 and tree.nodes[p].lower == "have"]
    # "Scrub the potatoes, have them peeled"
    start = min([start, *brought])
    joint = tree.nodes[start - 1].lower if start else ""
    helping = {tree.nodes[p].lower for p in tree.children(root, "aux") if p not in brought}
    telling = TELLING | ARE if tree.nodes[root].tag == "VBG" else TELLING
    if joint not in JOINTS or (subjects and joint != ",") or not helping <= telling:
        return None
    before = [p for p in tree.children(root, *COORDINATE, "csubj") if p < start]
    # "Saw the board, sand the edges": a past form in front is an order, as nobody is named.
    # "Using a fork, mash them" says how.
    verbs = [p for p in before if p == 0 and _is_verb(tree, p) and tree.nodes[p].tag != "VBG"]
    orders = [*(p for p in before if tree.nodes[p].tag == "VB"), *verbs]
    # "Get dressed, we start in ten minutes"
    orders += [p for p in before if _is_passive(tree, p)]
    if joint == ",":
        # "Deglaze with wine, reduce it": a verb that the model does not know.
        orders += [p for p in tree.children(root, "advmod", "nsubj") if _is_unknown(tree, p, start)]
    if subjects and not brought:
        bare = (p for p in orders if tree.nodes[p].tag == "VB" and _first_of(tree, p) == 0)
        orders = [*bare, *(p for p in orders if _is_passive(tree, p))]
    ordered = any(
        not tree.children(p, *SUBJECTS, "aux", "mark") and all(a > p for a in tree.children(p, "advmod"))
        for p in orders
    )
    return start if ordered else None


def _is_passive(tree: Tree, place: int) -> bool:
    """Whether a participle stands behind a "get" that begins an order: "get dressed"."""
    helping = tree.children(place, "auxpass")
    return tree.nodes[place].tag == "VBN" and 0 in helping and tree.nodes[0].lemma == "get"


def _is_verb(tree: Tree, place: int) -> bool:
    """Whether a word is a verb, or has an object: "lower the hook"."""
    return tree.nodes[place].is_verb or (tree.nodes[place].may_act and bool(tree.children(place, "dobj")))


def _is_unknown(tree: Tree, place: int, end: int) -> bool:
    """Whether the first word of some before a comma is an order that was taken for a thing."""
    said = tree.reach(place)
    return place == 0 and tree.nodes[0].tag == "NN" and 1 < said[1] <= end and bool(tree.children(0, "prep"))


def _leads(tree: Tree, place: int, root: int) -> bool:
    return root in tree.below(place)


def _first_of(tree: Tree, place: int) -> int:
    """Give where the instruction of a verb begins: adverbs right before it belong to it."""
    start = place
    while start and _is_own_adverb(tree.nodes[start - 1], place):
        start -= 1
    return start


def _behind_place(tree: Tree, place: int) -> int:
    """Give where it begins with what is said in front of where: "…, and on the way back drop the cheque"."""
    start = _first_of(tree, place)
    led = (p for p in tree.children(place, "prep") if p < start and tree.reach(p)[1] == start)
    return next(led, start)


def _is_own_adverb(node: Node, verb: int) -> bool:
    return node.tag in {"RB", "UH"} and node.head == verb and node.lower != "so"


def _is_embedded(tree: Tree, place: int, root: int) -> bool:
    """Whether a verb is joined to one that the instruction is about: "remind me to call mum and buy milk"."""
    for above in tree.above(place):
        if above == root:
            return False
        node = tree.nodes[above]
        # "Leave the dough covered and shape it": a bare verb is no second participle.
        apart = node.tag in {"VBN", "VBG"} and tree.nodes[place].tag == "VB"
        # "Let the dough rest overnight and bake it in the morning": what rests bakes nothing.
        acts = any(tree.nodes[p].lower in THEM for p in tree.children(place, "dobj"))
        apart = apart or (acts and node.relation == "ccomp" and not tree.children(above, "dobj", "dative"))
        if node.relation in EMBEDDED and node.tag not in FINITE and not apart:
            return True
    return False
