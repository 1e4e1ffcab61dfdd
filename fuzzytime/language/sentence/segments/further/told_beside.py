"""What is told behind an order, or in front of one, which the tree of both does not show.

"Iron a shirt, my train leaves at six", "the guests arrive at seven, hoover the stairs": a tree often has one
of them for a part of the other. Where a joint stands between words that may be both, they are parsed apart.
"""

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.sentence.segments.fronts import CARRIER, is_bare, is_order, is_wish
from fuzzytime.language.sentence.segments.further.overlooked_orders import is_bare_order
from fuzzytime.language.sentence.segments.further.run_on_orders import tells
from fuzzytime.language.sentence.segments.waiting import Waiting
from fuzzytime.language.sentence.trees.tags import DETERMINERS, IMPERATIVE, NOUNS, PRESENT
from fuzzytime.language.sentence.trees.tree import Node, Tree, Trees
from fuzzytime.language.sentence.verbs.meant.orders_before import denied_from
from fuzzytime.language.sentence.verbs.statements.called import with_doer
from fuzzytime.language.sentence.verbs.statements.statement_trees import as_statement

APOSTROPHES = frozenset({"'", "’"})

LEAST = 2
"""Words of an order, or of what is told, at least."""

TELLING = DETERMINERS | NOUNS | {"PRP", "PRP$", "EX"}
"""Tags of the first word of what is told."""

OPEN = frozenset({*PRESENT, "MD", "WDT", "WP", "WRB"})
"""Tags of words in an order that what is told may go on: "find out what time it shuts and the bank opens"."""

WHOLE = ("dobj", "prt", "dative", "prep", "advmod", "npadvmod", "acomp")
"""What an order governs that is said to its end."""


@dataclass(frozen=True, slots=True)
class _Try:
    """An order and what is told on both sides of a joint of the one that waits at a place.

    ``start`` is where the second of both begins, ``begin`` where what is told does. What somebody ``wishes``
    is told as well, and is no order: "the roast has to go in at five".
    """

    one: int
    start: int
    begin: int
    order: str
    told: str
    wishes: bool = False


def told_beside(waiting: Sequence[Waiting], found: Sequence[Tree], trees: Trees) -> dict[int, int]:
    """Give where the second of an order and what is told begins, by the places of those that wait.

    ``found`` are their trees.
    """
    tries = [
        attempt
        for place, (one, tree) in enumerate(zip(waiting, found, strict=True))
        for attempt in _tries(place, one, tree)
    ]
    orders = trees([("" if attempt.wishes else CARRIER) + attempt.order for attempt in tries])
    cut: dict[int, int] = {}
    for attempt, order, told in zip(tries, orders, trees([attempt.told for attempt in tries]), strict=True):
        asked = (
            tells(order) if attempt.wishes else _is_asked(order.without_carrier(CARRIER, attempt.order, 0))
        )
        if attempt.one in cut or not asked:
            continue
        phrases = [phrase.span for phrase in waiting[attempt.one].phrases]
        timed = {p for a, b in phrases for p in told.at(a - attempt.begin, b - attempt.begin)}
        # "Mum wants me to call, text her"
        leads = attempt.begin < attempt.start and any(node.tag == "VB" for node in told.nodes)
        if not leads and _is_told(told, timed):
            cut[attempt.one] = attempt.start
    return cut


def _tries(place: int, one: Waiting, tree: Tree) -> Iterator[_Try]:
    lexicon, source, timed = tree.lexicon, one.source, one.timed(tree)
    sound = source.sound
    joints = lexicon.closed.joints_of_orders - {"then", "also", "please"}
    denied = bool(lexicon.closed.negators_as_typed.intersection(node.lower for node in tree.nodes[:2]))
    may_begin = denied or any(node.may_act and is_bare(node, lexicon) for node in tree.nodes[:1])
    for here in range(LEAST + 1, len(tree.nodes) - 1):
        joint, start = tree.nodes[here - 1].lower, tree.nodes[here].start + one.main
        joined = joint in joints and here - 1 not in timed
        if here in timed or not (joined or (may_begin and _is_parted(tree, here, timed))):
            continue
        before = {*source.places(one.main, start)} - source.covered
        led = any(longest_match(source.scanned.words, word, lexicon.clauses) for word in before)
        if led:
            # "Serve once the rice is done and the beans are done"
            return
        first = sound[one.main : one.end_before(start)].strip()
        second = sound[start : one.segment.span[1]]
        astray = tree.root >= here or any(place > here for place in timed)
        if may_begin and astray and joint != "so" and _may_tell(tree, here):
            yield _Try(place, start, start, first, second)
        if joint in {",", ";", "so"} and _may_order(tree, here):
            yield _Try(place, start, one.main, second, first)
        if joint == "so" and is_wish(tree, here):
            yield _Try(place, start, one.main, second, first, wishes=True)


def _is_parted(tree: Tree, place: int, timed: AbstractSet[int]) -> bool:
    """Whether what is told begins where an order is over: "turn the tv on at eight | the game is starting".

    So it does behind a particle: "bring the washing in | it's raining"; but "text Ann at six I'm late".
    """
    lexicon, (before, node, behind) = tree.lexicon, tree.nodes[place - 1 : place + 2]
    pronoun = node.lower in lexicon.closed.subject_pronouns
    if place - 1 in timed:
        clipped = behind.text[0] in APOSTROPHES
        messages = lexicon.no_times.speaking | lexicon.no_times.sending
        return (pronoun or node.tag in DETERMINERS) and not (clipped and tree.nodes[0].lemma in messages)
    over = (before.lower,) in lexicon.courtesies or before.lower in lexicon.particles
    over = over and all(below < place - 1 for below in tree.children(place - 1))
    return over and pronoun and behind.text[0] in APOSTROPHES


def _may_tell(tree: Tree, place: int) -> bool:
    """Whether words behind a joint may tell something: one of them may be what somebody does."""
    first, *behind = tree.nodes[place:]
    known = first.lower in tree.lexicon.people
    sure = known or _is_surely_timed(behind, tree.lexicon)
    if first.tag in {"NN", "NNS"} and not sure:
        # "School starts at nine"; but "buy stamps, cards and the tea mum likes"
        behind = behind[:1]
    finite = (node.tag in OPEN for node in behind)
    taken = (node.may_act and node.tag in NOUNS | {"NNPS", "VB"} for node in behind)
    return known or (first.tag in TELLING and (any(finite) or any(taken)))


def _may_order(tree: Tree, place: int) -> bool:
    """Whether a bare verb stands behind a joint, and nobody who acts, too: "…, drone 5 the woods"."""
    node, lexicon = tree.nodes[place], tree.lexicon
    known = node.lower in lexicon.function_words | lexicon.workers
    return node.may_act and is_bare(node, lexicon) and not known


def _is_asked(tree: Tree) -> bool:
    """Whether words are an order that is said to its end."""
    lexicon = tree.lexicon
    if not tree.nodes or any(node.tag in OPEN - {"VBP"} for node in tree.nodes[1:]):
        return False
    if is_bare_order(tree, 0, frozenset()):
        # "Text jo at five"
        return True
    verb = tree.root if denied_from(tree, tree.root) == 0 else 0
    node = tree.nodes[verb]
    whole = bool(tree.children(verb, *WHOLE)) or node.lower in lexicon.needing_nothing
    # "Please hoover the stairs": a tree may have that for no verb.
    done = is_order(tree) if node.tag in IMPERATIVE else tree.root == 0 and bool(tree.children(0, "dobj"))
    return whole and done and node.may_act and is_bare(node, lexicon)


def _is_told(tree: Tree, timed: AbstractSet[int]) -> bool:
    """Whether words tell what somebody does, or what is; not what an order names: "paint brushes at ten"."""
    if not tree.nodes:
        return False
    lexicon, first = tree.lexicon, tree.nodes[0]
    known = first.lower in lexicon.people | lexicon.happening | lexicon.taken
    # "Traffic's bad": nobody is to traffic.
    known = known or any(node.tag == "POS" for node in tree.nodes[1:2])
    known = known or first.tag in DETERMINERS or _is_surely_timed(tree.nodes, lexicon)
    if (known or not first.may_act) and not tree.children(tree.root, "relcl"):
        told = as_statement(with_doer(tree), timed, lexicon.travelling)
        verb = told.nodes[told.root]
        # "The train leaves at nine"; but "order the screws today and the drill bits at ten"
        plural = tree.nodes[told.root].tag == "NNS" and first.lower not in lexicon.people
        tree = tree if plural and verb.lower not in lexicon.doing.timed else told
    verbs = (tree.root, *tree.children(tree.root, "aux", "auxpass"))
    return tells(tree) and any(tree.nodes[place].tag in OPEN for place in verbs)


def _is_surely_timed(nodes: Sequence[Node], lexicon: Lexicon) -> bool:
    """Whether a word is hardly anything but what something with a time does: "garden centre shuts"."""
    return not lexicon.doing.surely_timed.isdisjoint(node.lower for node in nodes)
