"""Orders behind "and" or a comma which the tree of both does not show: "shear the sheep and bleed the taps".

A verb that is a noun too, or that the model does not know, is taken for a second thing. Where it has a thing
of its own behind it, both parts are parsed apart; if both are orders, they were two. So they are where words
say it that no tree shows: "feed the cat at six and text ann".
"""

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass

from fuzzytime.language.grammar.lexicon import longest_match
from fuzzytime.language.sentence.segments.fronts import CARRIER
from fuzzytime.language.sentence.segments.further.orders_in_front import behind_joint
from fuzzytime.language.sentence.segments.further.overlooked_orders import is_bare_order
from fuzzytime.language.sentence.segments.further.run_on_orders import governs, is_whole
from fuzzytime.language.sentence.segments.waiting import Waiting
from fuzzytime.language.sentence.trees.tags import DETERMINERS, IMPERATIVE
from fuzzytime.language.sentence.trees.tree import Tree, Trees
from fuzzytime.language.sentence.verbs.meant.actions import action_of

LEAST = 3
"""Words of an order with its thing and a joint behind them, at least."""

OPENING = DETERMINERS | {"PDT"}


@dataclass(frozen=True, slots=True)
class _Try:
    """A place at which a further order may begin, in the text and behind its joint, with both parts.

    It is ``sure`` where its words alone say that it is one; ``apart`` behind a time or a particle.
    """

    one: int
    start: int
    sure: bool
    apart: bool
    before: str
    behind: str


def orders_behind_joints(waiting: Sequence[Waiting], found: Sequence[Tree], trees: Trees) -> dict[int, int]:
    """Give where a second order begins, by the places of those that wait; ``found`` are their trees."""
    tries = [
        attempt
        for place, (one, tree) in enumerate(zip(waiting, found, strict=True))
        for attempt in _tries(place, one, tree)
    ]
    before = trees([CARRIER + attempt.before for attempt in tries])
    behind = trees([CARRIER + attempt.behind for attempt in tries])
    cut: dict[int, int] = {}
    for attempt, first, second in zip(tries, before, behind, strict=True):
        one = first.without_carrier(CARRIER, attempt.before, 0)
        other = second.without_carrier(CARRIER, attempt.behind, 0)
        # "Swim at seven and ring Bob at nine", "clean up and order pizza"
        alone = attempt.apart and bool(one.nodes) and _is_done_alone(one)
        whole = alone or (is_whole(one, timed=True) and governs(one))
        if whole and (attempt.sure or (governs(other) and other.nodes[0].tag in IMPERATIVE)):
            cut.setdefault(attempt.one, attempt.start)
    return cut


def _tries(place: int, one: Waiting, tree: Tree) -> Iterator[_Try]:
    source, timed, covered = one.source, one.timed(tree), one.source.covered
    main = one.main + max(one.behind_time, _behind_asking(tree))
    marked: int | None = None
    for here in range(LEAST, len(tree.nodes) - 1):
        # "…, this evening board the ferry"
        first = behind_joint(tree, here, set(timed))
        led = tree.nodes[first - 1]
        sure = _is_surely_done(tree, here, timed)
        joined = led.lower in tree.lexicon.closed.joints_of_orders
        if first < LEAST or not joined or not (sure or _may_act_on(tree, here, timed)):
            continue
        start, verb = (tree.nodes[at].start + one.main for at in (first, here))
        words = (word for word in source.places(main, start) if word not in covered)
        clauses = (w for w in words if longest_match(source.scanned.words, w, tree.lexicon.clauses))
        marked = next(clauses, None) if marked is None else marked
        if marked is not None and led.text != ",":
            # "Stir it when the chefs salt the soup and pepper the steak": what is in a clause.
            continue
        before = source.sound[main : led.start + one.main].strip()
        apart = first - 2 in timed or tree.nodes[first - 2].tag == "RP"
        yield _Try(place, start, sure, apart, before, source.sound[verb : one.segment.span[1]])


def _is_done_alone(tree: Tree) -> bool:
    """Whether words begin with an order that has no thing: "swim", "clean up"."""
    first, *behind = tree.nodes
    carried = any(first.lower in tree.lexicon.particles.get(node.lower, ()) for node in behind[:1])
    return first.lower in tree.lexicon.needing_nothing or carried


def _behind_asking(tree: Tree) -> int:
    """Give where an order begins behind words that only ask for it: "can you | brew the tea", "let's | …"."""
    lexicon = tree.lexicon
    action = action_of(tree)
    before = tree.nodes[: action.place] if action is not None and not action.negated else ()
    leads = lexicon.letting | lexicon.forgetting | lexicon.doing.remembering
    asks = {node.lower for node in before} & lexicon.closed.first_and_second_person
    asks |= {node.lemma for node in before} & leads
    known = all(
        node.tag == "PRP"
        or node.relation in {"aux", "neg"}
        or node.lower in lexicon.function_words
        or node.lemma in lexicon.wanting | leads
        for node in before
    )
    return tree.nodes[len(before)].start if asks and known else 0


def _may_act_on(tree: Tree, place: int, timed: AbstractSet[int]) -> bool:
    """Whether a word has a thing behind it that it may be done with: "back up the files"."""
    node, behind, *further = tree.nodes[place : place + 3]
    if not timed.isdisjoint({place, place + 1}) or node.lower in tree.lexicon.function_words:
        return False
    third = further[0].tag if further and place + 2 not in timed else ""
    opens = behind.tag in OPENING or behind.lower in tree.lexicon.closed.indefinite_determiners
    # "Dust mum's piano", "fetch leo"
    owned = third == "POS" or (node.may_act and behind.lower in tree.lexicon.names and not _is_asked(tree))
    carried = node.lower in tree.lexicon.particles.get(behind.lower, ()) and third in DETERMINERS
    # "Discharge bed four"
    counted = behind.tag == "NN" and third == "CD"
    return node.text.isalpha() and node.tag not in DETERMINERS and (opens or owned or carried or counted)


def _is_surely_done(tree: Tree, place: int, timed: AbstractSet[int]) -> bool:
    """Whether words say that it is an order, and not of one asked."""
    return not _is_asked(tree) and is_bare_order(tree, place, timed)


def _is_asked(tree: Tree) -> bool:
    """Whether what is to be done is somebody's who is asked: "remind me to call Bob and text Ann"."""
    asked = tree.nodes[tree.root].lemma in tree.lexicon.addressing
    return asked and bool(tree.children(tree.root, "xcomp", "ccomp"))
