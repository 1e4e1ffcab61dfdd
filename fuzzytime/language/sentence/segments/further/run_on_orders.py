"""Orders one behind the other without a joint: "feed the baby at six bath her at seven".

So is an order behind what is told with its time: "the gym opens at six remind me to pack". One tree of
both mostly goes wrong, as it does for clauses in front (``fronts``). So it is tried: wherever a bare verb
governs something and nothing joins it to what stands before, both parts are parsed.
"""

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass

from fuzzytime.language.grammar.lexicon import longest_match
from fuzzytime.language.sentence.segments.fronts import CARRIER, is_bare, is_order
from fuzzytime.language.sentence.segments.further.overlooked_orders import is_bare_order
from fuzzytime.language.sentence.segments.waiting import Waiting
from fuzzytime.language.sentence.segments.whole_clauses import COMPLEMENTS, binds
from fuzzytime.language.sentence.trees.named import topic_of
from fuzzytime.language.sentence.trees.tags import DETERMINERS, SINGULAR
from fuzzytime.language.sentence.trees.tree import Tree, Trees
from fuzzytime.language.sentence.verbs.meant.orders_before import denied_from
from fuzzytime.language.sentence.verbs.statements.beside_orders import subjects_before

LEAST = 2
"""Words of an order that another may stand behind, at least."""

OBJECTS = ("dobj", "prt", "dative", "npadvmod", "prep", "advmod")
"""What an order governs that is whole."""


FINITE = frozenset({"VBZ", "VBD"})
"""Tags of what somebody does, or did."""


@dataclass(frozen=True, slots=True)
class _Try:
    """A place at which a further order may begin, with both parts.

    ``timed`` where a time ends the first, ``tells`` where that may be no order, ``sure`` where the
    words of the second alone say that it is one.
    """

    one: int
    start: int
    timed: bool
    tells: bool
    sure: bool
    before: str
    behind: str


def run_on_orders(waiting: Sequence[Waiting], found: Sequence[Tree], trees: Trees) -> dict[int, int]:
    """Give where the second of two orders begins without a joint, by the places of those that wait.

    ``found`` are their trees.
    """
    tries = [
        attempt
        for place, (one, tree) in enumerate(zip(waiting, found, strict=True))
        for attempt in _tries(place, one, tree)
    ]
    carriers = ["" if attempt.tells else CARRIER for attempt in tries]
    before = trees([carrier + one.before for carrier, one in zip(carriers, tries, strict=True)])
    behind = trees([CARRIER + attempt.behind for attempt in tries])
    # "Play some rain sounds" has its object in a tree of its own alone.
    alone = trees([attempt.behind for attempt in tries])
    cut: dict[int, int] = {}
    for attempt, carrier, first, second, own in zip(tries, carriers, before, behind, alone, strict=True):
        one = first.without_carrier(carrier, attempt.before, 0)
        other = second.without_carrier(CARRIER, attempt.behind, 0)
        whole = tells(one) if attempt.tells else is_whole(one, timed=attempt.timed)
        surely = attempt.timed or not attempt.tells or _is_state(one)
        whole = whole and (surely or _is_done_with_it(other, 0))
        whole = whole and (attempt.sure or governs(other) or governs(own))
        if attempt.one not in cut and whole:
            cut[attempt.one] = attempt.start
    return cut


def _tries(place: int, one: Waiting, tree: Tree) -> Iterator[_Try]:
    lexicon = tree.lexicon
    if len(tree.nodes) <= LEAST or topic_of(tree) is not None:
        return
    source, end, timed = one.source, one.segment.span[1], one.timed(tree)
    tells = not tree.nodes[0].may_act or _is_told_by_name(tree)
    for here in range(LEAST, len(tree.nodes) - 1):
        if here in timed or not _may_begin(tree, here, timed):
            continue
        if tells and here - 1 not in timed and not _may_be_state(tree, here):
            # "The kids have to make their beds"
            continue
        led = next((place for place in range(here - 1, -1, -1) if place not in timed), 0)
        joined = tree.nodes[led].lower in lexicon.closed.joints_of_orders
        if joined and not _is_listed(tree, here, timed):
            # "Set the table, and by seven have the soup ready"
            continue
        first = here - (tree.nodes[here - 1].lower in lexicon.beside.turning)
        start, verb = (tree.nodes[at].start + one.main for at in (first, here))
        # "Gran's here till sunday make up the spare bed"
        own: AbstractSet[int] = source.covered if here - 1 in timed else frozenset()
        words = [at for at in source.places(one.main, start) if at not in own]
        if any(longest_match(source.scanned.words, word, lexicon.clauses) is not None for word in words):
            # "Stir it when the chef asks the waiter": what is in a clause.
            return
        said = source.sound[one.main : start].strip()
        bare = is_bare_order(tree, here, timed)
        sure = here - 1 in timed and (bare or _is_carried(tree, here, timed))
        yield _Try(place, start, here - 1 in timed, tells, sure, said, source.sound[verb:end])


def _may_begin(tree: Tree, place: int, timed: AbstractSet[int]) -> bool:
    """Whether a bare verb with an object stands behind a word that does not lead to it."""
    lexicon = tree.lexicon
    node, before, behind = tree.nodes[place - 1 : place + 2][1], tree.nodes[place - 1], tree.nodes[place + 1]
    if not node.may_act or not is_bare(node, lexicon) or binds(tree, place - 1):
        return False
    where = lexicon.places | lexicon.particles.keys() | lexicon.closed.prepositions_of_way
    if node.tag in {"IN", "RP", "TO"} or node.lower in where:
        # "Walk him round the block", "put it back the way it was"
        return False
    if _is_listed(tree, place, timed):
        return behind.tag.startswith("NN") and not tree.children(place, "aux", "mark")
    joints = lexicon.closed.joints_of_orders | lexicon.closed.alternatives | {"to"}
    if before.lower in joints or (before.tag == "POS" and before.relation == "case"):
        # "Give dad's dog its pill"
        return False
    if before.tag == "PRP" and before.lower in lexicon.closed.personal_pronouns:
        # "…, I need it at nine"
        return False
    if not timed >= {*tree.children(place, "aux", "mark")} or not before.text[-1].isalnum():
        return False
    if place + 1 in timed:
        # "Open the hatch wait ten seconds and close it"
        return node.lower in lexicon.doing.waiting
    led = behind.tag in DETERMINERS or behind.lower in lexicon.closed.object_pronouns
    if place - 1 in timed:
        # "The fair is on friday book two tickets", "… at six order pizza", "… at six lock up"
        named = node.lower in lexicon.orders - lexicon.persons and behind.tag.startswith("NN")
        bare = is_bare_order(tree, place, timed) or _is_carried(tree, place, timed)
        led = led or behind.tag == "CD" or named or bare
    further = tree.nodes[place + 2 : place + 3]
    carried = node.lower in lexicon.particles.get(behind.lower, ())
    # "Gran's here till sunday make up the bed"
    carried = (carried or (behind.tag == "RP" and behind.head == place)) and bool(further)
    return led or (carried and (further[0].tag in DETERMINERS or place - 1 in timed))


def _is_carried(tree: Tree, place: int, timed: AbstractSet[int]) -> bool:
    """Whether a verb has its particle behind it, and no thing before its time: "… at six lock up at nine"."""
    node, behind = tree.nodes[place], tree.nodes[place + 1]
    particle = node.lower in tree.lexicon.particles.get(behind.lower, ())
    return particle and (place + 2 == len(tree.nodes) or place + 2 in timed)


def _may_be_state(tree: Tree, place: int) -> bool:
    """Whether the words before a place may say how one is, or what one cannot: "i'm tired | let me sleep"."""
    lexicon = tree.lexicon
    closed = lexicon.closed
    before = tree.nodes[:place]
    said = any(node.lemma in closed.lemmas_of_be or node.relation == "neg" for node in before[1:])
    leads = (lexicon.letting | lexicon.causing | lexicon.doing.watching) - closed.lemmas_of_be
    if not said and tree.nodes[place + 1].lower in closed.it_or_them:
        # "The cake needs forty minutes | take it out"; but "the nurse said take it at ten"
        said = any(node.tag in FINITE | {"VBP"} and node.head == tree.root for node in before[1:])
        leads = (leads - lexicon.doing.needing) | lexicon.doing.learning | lexicon.doing.saying
        leads |= lexicon.intransitive - lexicon.doing.being
    return place > LEAST and said and leads.isdisjoint(node.lemma for node in before)


def _is_state(tree: Tree) -> bool:
    """Whether words say to their end how one is, or what one cannot."""
    root = tree.root
    helping = tree.children(root, "aux", "auxpass")
    denied = tree.children(root, "neg") and any(tree.nodes[place].tag == "MD" for place in helping)
    if tree.nodes[root].lemma in tree.lexicon.closed.lemmas_of_be:
        return bool(tree.children(root, *COMPLEMENTS))
    being = any(tree.nodes[place].lemma in tree.lexicon.closed.lemmas_of_be for place in helping)
    return bool(denied) or being


def _is_done_with_it(tree: Tree, verb: int) -> bool:
    """Whether something is done with what was spoken of: "take it out"."""
    return any(tree.nodes[p].lower in tree.lexicon.closed.it_or_them for p in tree.children(verb, "dobj"))


def _is_listed(tree: Tree, place: int, timed: AbstractSet[int]) -> bool:
    """Whether a word begins a stretch with its time behind another: "feed fish at 8, | walk dog at 9"."""
    if place < LEAST or tree.nodes[place - 1].text != "," or place - LEAST not in timed:
        return False
    behind = (at for at in range(place, len(tree.nodes)) if tree.nodes[at].text == ",")
    return next(behind, len(tree.nodes)) - 1 in timed


def is_whole(tree: Tree, *, timed: bool) -> bool:
    """Whether an order is said to its end, and is none that leads to what others do: "let the kids"."""
    # "Don't boil the milk just warm it"
    lexicon = tree.lexicon
    denied = denied_from(tree, tree.root) == 0
    if not is_order(tree) or not is_bare(tree.nodes[0], lexicon):
        return False
    verb = tree.root if denied else 0
    doing, lemma = lexicon.doing, tree.nodes[verb].lemma
    leads = lemma in lexicon.letting | lexicon.causing | lexicon.wanting | lexicon.addressing | doing.watching
    named = any(tree.nodes[place].tag != "CD" for place in tree.children(verb, *OBJECTS))
    # "Do the ironing"
    named = named or any(tree.children(place, "det") for place in tree.children(verb, "xcomp", "ccomp"))
    return (timed or not leads) and named


def _is_told_by_name(tree: Tree) -> bool:
    """Whether one word is named, and behind it what it does at a time: "bank shuts at four"."""
    named, does = tree.nodes[:LEAST]
    return named.tag in SINGULAR and does.lower in tree.lexicon.doing.timed


def tells(tree: Tree) -> bool:
    """Whether words tell what somebody does, or what is, from their first: "we're having guests at seven"."""
    if len(tree.nodes) > LEAST and _is_told_by_name(tree):
        return True
    root = tree.root
    if not tree.nodes or not tree.nodes[root].is_verb:
        return False
    subjects = subjects_before(tree, root)
    verbs = (root, *tree.children(root, "aux", "auxpass"))
    # "Mum's coming": a tree may have it for her own.
    finite = any(tree.nodes[place].tag in FINITE | {"VBP", "MD"} for place in verbs)
    return finite and any(tree.reach(place)[0] == 0 for place in subjects)


def governs(tree: Tree) -> bool:
    """Whether an order has an object, with which nobody does another thing: "cake mix the shop sells"."""
    objects = tree.children(0, "dobj", "dative", "ccomp", "npadvmod")
    described = any(tree.children(place, "relcl") for place in objects)
    described = described or any(tree.nodes[place].tag in FINITE for place in tree.children(0, "ccomp"))
    return is_order(tree) and bool(objects) and not described
