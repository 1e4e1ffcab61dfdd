"""Where further instructions of one sentence begin, by its tree: at bare verbs beside the first."""

from collections.abc import Sequence

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Span
from fuzzytime.language.sentence.segments.further.orders_behind_names import (
    behind_heading,
    behind_named,
    having_done,
)
from fuzzytime.language.sentence.segments.further.orders_in_front import (
    ANY_SUBJECTS,
    COORDINATE,
    behind_joint,
    first_of,
    order_behind_order,
)
from fuzzytime.language.sentence.segments.further.overlooked_orders import is_overlooked
from fuzzytime.language.sentence.segments.orders_beside_times import is_led_by_time
from fuzzytime.language.sentence.trees.tags import FINITE, IMPERATIVE
from fuzzytime.language.sentence.trees.tree import Node, Tree
from fuzzytime.language.sentence.verbs.meant.actions import action_of, gone_to_do
from fuzzytime.language.sentence.verbs.meant.orders_before import denied_from
from fuzzytime.language.sentence.verbs.statements.statements import (
    due_too,
    goes_on,
    order_behind_statement,
    result_behind_statement,
    second_statement,
)

SHORTEST = 2
"""Words of an order at least, before a participle that goes on beside it."""

WANTED = "xcomp"
EMBEDDED = frozenset({"xcomp", "ccomp", "relcl", "acl", "pcomp"})


def further_verbs(tree: Tree, root: int, times: Sequence[Span], *, told: bool) -> list[int]:
    """Give the words at which further instructions of one sentence begin: imperatives beside the first.

    "Chop the onions, fry them and serve": the tree calls them conjuncts, or mistakes them for something
    else; what counts is a bare verb without a subject behind "and" or a comma. What is ``told`` is about who
    was named before.
    """
    timed = {place for span in times for place in tree.at(*span)}
    first = (
        order_behind_order(tree, root, timed),
        order_behind_statement(tree, root, timed),
        behind_named(tree, root, timed),
        behind_heading(tree, root, timed),
    )
    found = [start for start in first if start is not None]
    for place in range(len(tree.nodes)):
        if place in timed and place != root:
            continue
        start = _start_at(tree, place, root, timed)
        if start is None and _is_second_statement(tree, place, root, timed, told=told):
            start = place
        if start is not None and not _is_aim(tree, start, root):
            # "Shoe the horse, and on friday, season the stew"
            apart = start > 0 and tree.nodes[start - 1].text == ","
            found.append(behind_joint(tree, start, timed) if apart else start)
    return found


def _is_aim(tree: Tree, place: int, root: int) -> bool:
    """Whether others do then what an order is for: "post it tonight so they get it tomorrow"."""
    others = tree.lexicon.closed.anaphors | tree.lexicon.closed.third_person_singular
    led = place > 0 and tree.nodes[place - 1].lower == "so" and tree.nodes[place].lower in others
    return led and root < place and tree.nodes[root].is_bare


def _start_at(tree: Tree, place: int, root: int, timed: set[int]) -> int | None:
    """Give where the further instruction of a word begins; None where it has none."""
    told = result_behind_statement(tree, place, root, timed)
    told = second_statement(tree, place, timed) if told is None else told
    told = having_done(tree, place) if told is None else told
    told = due_too(tree, place, root) if told is None else told
    if told is not None:
        return told
    if _goes_on(tree, place, timed) or goes_on(tree, place, root, timed):
        return place
    if _is_gerund_too(tree, place, root):
        return place
    if place > 1 and _follows_so(tree, place, timed):
        return place
    if place > 1 and place != root and is_overlooked(tree, place, timed):
        return place
    if place > 1 and is_led_by_time(tree, place, timed):
        return behind_joint(tree, place, timed)
    if (
        place > 1
        and _is_passive_order(tree, place)
        and tree.nodes[place - 1].lower in tree.lexicon.closed.joints_of_orders
    ):
        return place
    return _start_of_coordinate(tree, place, root, timed)


def _follows_so(tree: Tree, place: int, timed: set[int]) -> bool:
    """Whether a bare verb follows what has a time and "so": "guests are coming at 8, so hoover at 7"."""
    node, before = tree.nodes[place], place - 2
    if before > 0 and tree.nodes[before].text == ",":
        before -= 1
    bare = node.may_act and node.lower == node.lemma
    # "At six or so call mum": that "so" is of the time.
    joint = tree.nodes[place - 1].lower == "so" and place - 1 not in timed
    return bare and joint and before in timed


def _start_of_coordinate(tree: Tree, place: int, root: int, timed: set[int]) -> int | None:
    """Give where begins what a bare verb asks for that the tree joins to the first: "…, and fry them"."""
    node = tree.nodes[place]
    if place in {0, root} or not _is_bare(node, tree.lexicon) or node.relation not in {*COORDINATE, WANTED}:
        return None
    wanted = _is_wanted_too(tree, place, root)
    if node.relation == WANTED and not wanted:
        return None
    denied = denied_from(tree, place)
    helping = [p for p in tree.children(place, "aux") if not (wanted and tree.nodes[p].lower == "to")]
    if tree.children(place, *ANY_SUBJECTS, "mark") or (denied is None and helping):
        return None
    first = min([_behind_place(tree, place), *tree.children(place, "aux")]) if denied is None else denied
    start = behind_joint(tree, first, timed)
    joints = tree.lexicon.closed.joints_of_orders
    if _is_denied(tree):
        # "Don't open the lid or stir the soup"
        joints |= tree.lexicon.closed.denied_alternatives
    if (
        start == 0
        or tree.nodes[start - 1].lower not in joints
        or (_is_embedded(tree, place, root) and not wanted)
    ):
        return None
    if gone_to_do(tree, root) == place:
        return None
    return start if place > root else None


def _is_denied(tree: Tree) -> bool:
    action = action_of(tree)
    return action is not None and action.negated


def _is_wanted_too(tree: Tree, place: int, root: int) -> bool:
    """Whether a verb is joined to the one that is meant below another: "I need to water it and feed him".

    So it is to what is to be remembered.
    """
    action = action_of(tree)
    if action is None or action.negated:
        return False
    remembered = tree.nodes[action.place].lemma in tree.lexicon.doing.remembering
    meant = {*tree.children(action.place, "xcomp")} if remembered else {action.place}
    over = tree.nodes[place].head
    if tree.nodes[place].relation == WANTED:
        # "I have to worm the sheep on friday, wash the car at seven"
        return any(tree.nodes[p].head == over and p < place for p in meant - {root})
    while tree.nodes[over].relation in {"conj", "dep"} and over not in meant:
        over = tree.nodes[over].head
    if tree.nodes[over].relation == "advcl" and tree.nodes[over].tag in FINITE:
        # "I need to feed her before I go out and let her in at six"
        over = tree.nodes[over].head
    return over in meant - {root} and gone_to_do(tree, over) != place


def _goes_on(tree: Tree, place: int, timed: set[int]) -> bool:
    """Whether a participle with its own time goes on beside an order: "simmer it, stirring every ten"."""
    node = tree.nodes[place]
    if node.tag != "VBG" or node.relation in EMBEDDED or node.lemma in tree.lexicon.indicators:
        return False
    behind = next(
        (
            p
            for p in range(place, len(tree.nodes))
            if tree.nodes[p].lower in tree.lexicon.closed.joints_of_orders
        ),
        len(tree.nodes),
    )
    apart = place - 1 in timed or tree.nodes[place - 1].text == ","
    before = any(earlier in timed for earlier in range(place))
    return (
        place >= SHORTEST and apart and before and any(later in timed for later in range(place + 1, behind))
    )


def _is_gerund_too(tree: Tree, place: int, root: int) -> bool:
    """Whether a gerund stands beside the order: "would you mind feeding the cat and walking the dog"."""
    node = tree.nodes[place]
    both = node.tag == tree.nodes[root].tag == "VBG" and root == 0 and node.relation == "conj"
    # "Washing and drying the towels" is one order.
    joined = place > 2 and tree.nodes[place - 1].lower in tree.lexicon.closed.joints_of_orders
    return both and joined and node.head == root and not tree.children(place, *ANY_SUBJECTS, "aux")


def _is_second_statement(tree: Tree, place: int, root: int, timed: set[int], *, told: bool) -> bool:
    """Whether it is what the same thing does next: "the roast goes in at ten and comes out at two"."""
    closed = tree.lexicon.closed
    node = tree.nodes[place]
    beside = (
        node.relation == "conj"
        and node.head == root
        and tree.nodes[place - 1].lower in closed.joints_of_orders
    )
    named = told or bool(tree.children(root, *ANY_SUBJECTS))
    helping = tree.said(tree.children(root, "aux"))
    # "The show will last an hour and start at eight"
    expected = node.tag == "VB" and bool(helping) and helping <= closed.future | {"should"}
    states = named and (expected or tree.nodes[root].tag == node.tag == "VBZ")
    if tree.nodes[root].tag == "VBZ" and named and node.tag == "NNS" and place > 1 and place + 1 in timed:
        # "The plumber fixes the tap and leaves at five"
        beside = tree.nodes[place - 1].lower in closed.joints_of_orders
        states = node.lower in tree.lexicon.doing.timed
    # "Feeds the cows" has who is fed for who does it.
    own = any(p < place for p in tree.children(place, *ANY_SUBJECTS))
    return beside and states and not own and not tree.children(place, "aux")


def _is_passive_order(tree: Tree, place: int) -> bool:
    """Whether it is the "get" of "get dressed", or the "be" of "be gone", beside another order."""
    node, over = tree.nodes[place], tree.nodes[tree.nodes[place].head]
    helps = node.relation in {"aux", "auxpass"} and node.lower in {"get", "be"}
    alone = not tree.children(node.head, *ANY_SUBJECTS, "mark")
    alone = alone and tree.children(node.head, "aux", "auxpass") == (place,)
    return node.tag in IMPERATIVE and helps and over.relation in COORDINATE and alone


def _is_bare(node: Node, lexicon: Lexicon) -> bool:
    """Whether a verb has its bare form, whatever tense it was taken for: "put" is a past form too."""
    past = node.tag in {"VBD", "VBN"} and (node.lower == node.lemma or node.lower in lexicon.doing.past_alike)
    # "Deburr it": what ends in no -s has no other person.
    bare = node.tag in IMPERATIVE or (node.tag == "VBZ" and not node.lower.endswith("s"))
    return bare or past


def _behind_place(tree: Tree, place: int) -> int:
    """Give where it begins with what is said in front of where: "…, and on the way back drop the cheque"."""
    start = first_of(tree, place)
    led = (p for p in tree.children(place, "prep") if p < start and tree.reach(p)[1] == start)
    return next(led, start)


def _is_let(tree: Tree, place: int) -> bool:
    """Whether somebody is let do it."""
    return tree.nodes[tree.nodes[place].head].lemma == "let"


def _is_embedded(tree: Tree, place: int, root: int) -> bool:
    """Whether a verb is joined to one that the instruction is about: "remind me to call mum and buy milk"."""
    for above in tree.above(place):
        if above == root:
            return False
        node = tree.nodes[above]
        # "Leave the dough covered and shape it": a bare verb is no second participle.
        apart = node.tag in {"VBN", "VBG"} and tree.nodes[place].tag == "VB"
        # "Let the dough rest overnight and bake it in the morning": what rests bakes nothing.
        objects = tree.said(tree.children(place, "dobj", "dative"))
        acts = bool(objects & tree.lexicon.closed.it_or_them) and not tree.children(above, "dobj", "dative")
        # "Let me rest for an hour and wake me at four"
        acts = acts or (bool(objects & tree.lexicon.closed.speakers) and _is_let(tree, above))
        apart = apart or (acts and node.relation == "ccomp")
        if node.relation in EMBEDDED and node.tag not in FINITE and not apart:
            return True
    return False
