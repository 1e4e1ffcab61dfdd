"""Clauses in front without a comma: "once the glue is dry sand the edges".

One tree of the whole mostly goes wrong, and no word says where the clause ends. So it is tried: wherever a
word may be an order, the words before it are parsed as a clause, and those from it on as what is to be done.
"""

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.sentence.clauses.conditions import ITS
from fuzzytime.language.sentence.clauses.levels import level_end
from fuzzytime.language.sentence.segments.waiting import Waiting
from fuzzytime.language.sentence.segments.whole_clauses import BINDING, EVENTFUL, binds, is_clause
from fuzzytime.language.sentence.trees.tags import DETERMINERS, SUBJECTS
from fuzzytime.language.sentence.trees.tree import Node, Tree, Trees
from fuzzytime.language.sentence.verbs.meant.actions import is_doubtful
from fuzzytime.language.sentence.verbs.meant.orders_before import denied_from

CARRIER = "please "
"""Words behind which a parser sees an order."""

OPENING = frozenset({"DT", "PRP", "PRP$"})
"""Tags of words that begin what an order is about."""

NAMING = frozenset({"JJ", "NN", "NNS", "NNP", "CD", "POS"})
"""Tags of words behind an article that name one thing."""

COMPARED = frozenset({"JJR", "RBR"})
"""Tags of words whose dictionary form is another, and that may be a verb: "lower the blinds"."""

ENDING = frozenset({"JJ", "VBN", "RP"})
"""Tags of words that end what is said of something, and behind which no thing stands: "the pan is hot"."""

OF_EVENTS = frozenset({"of", "during"})
"""The last words of markers behind which a noun stands: "on the day of the party", "during the film"."""


@dataclass(frozen=True, slots=True)
class Front:
    """Where a clause in front begins, and where what is to be done does."""

    start: int
    main: int


@dataclass(frozen=True, slots=True)
class _Try:
    """A place at which what is to be done may begin, with the clause before it; ``names`` are of persons."""

    one: int
    names: AbstractSet[str]
    kind: str
    front: Front
    clause: str
    order: str


def fronts_of(
    waiting: Sequence[Waiting], found: Sequence[Tree], fronts: Sequence[Tree], trees: Trees
) -> dict[int, Front]:
    """Give the clauses in front of those that wait, by their places.

    ``found`` are their trees, ``fronts`` those of what stands before a comma in front of them.
    """
    tries = [
        attempt
        for place, (one, tree, front) in enumerate(zip(waiting, found, fronts, strict=True))
        for attempt in (
            *_behind_level(place, one),
            *_tries(place, one, tree),
            *_with_order(place, one, tree, front),
        )
    ]
    clauses = trees([_as_event(attempt) for attempt in tries])
    orders = trees([CARRIER + attempt.order for attempt in tries])
    led: dict[int, Front] = {}
    for attempt, clause, carried in zip(tries, clauses, orders, strict=True):
        order = carried.without_carrier(CARRIER, attempt.order, 0)
        wished = bool(order.nodes) and is_wish(order, 0)
        asks = is_order(order) or wished
        # "If it rains | hoover the hall"
        governs = order.root == 0 and any(node.tag in DETERMINERS for node in order.nodes[1:2])
        governs = governs and bool(order.children(0, "dobj", "pobj"))
        beside = order.lexicon.places | order.lexicon.particles.keys()
        asks = asks or (governs and order.nodes[0].lower not in beside)
        if attempt.one not in led and is_clause(clause, attempt.kind, wished=wished) and asks:
            led[attempt.one] = attempt.front
    return led


def _behind_level(place: int, one: Waiting) -> Iterator[_Try]:
    """Give the place behind a level: "at 90% | stop charging"."""
    words, source = one.source.scanned.words, one.source
    first = next(iter(source.places(*one.segment.span)), None)
    end = level_end(words, first, one.lexicon) if first is not None else None
    if first is None or end is None or end >= len(words) or one.main != one.segment.span[0]:
        return
    start, main, last = words[first].start, words[end].start, one.segment.span[1]
    if main < last:
        clause = source.sound[start : words[end - 1].end]
        yield _Try(place, one.lexicon.people, "when", Front(start, main), clause, source.sound[main:last])


def _tries(place: int, one: Waiting, tree: Tree) -> Iterator[_Try]:
    """Give the places behind the first marker at which a bare verb may stand."""
    words, source = one.source.scanned.words, one.source
    marker = next((marker for marker in one.markers() if marker.end < len(words)), None)
    if marker is None:
        return
    first, end = words[marker.end].start, one.segment.span[1]
    for here, node in enumerate(tree.nodes):
        start = node.start + one.main
        opens = may_be_done(tree, here) or is_wish(tree, here)
        # "Once the first batch | is out"
        is_so = any(one.lower in tree.lexicon.closed.stative_verbs for one in tree.nodes[here + 1 : here + 2])
        if start <= first or here == 0 or not opens or (is_so and may_be_done(tree, here)):
            continue
        timed = one.timed(tree)
        # "If they're not here by ten | start without them": a time counts nothing
        counted = here - 1 not in timed and _is_counted(tree, here)
        if here in timed or counted or binds(tree, here - 1):
            continue
        if _is_event_before_order(tree, here):
            continue
        clause = source.sound[first:start].strip(" ,")
        kind = "after" if words[marker.end - 1].text in OF_EVENTS else marker.kind
        order = source.sound[start:end]
        yield _Try(place, tree.lexicon.people, kind, Front(marker.start, start), clause, order)


def _with_order(place: int, one: Waiting, tree: Tree, front: Tree) -> Iterator[_Try]:
    """Give the order in what stands before a comma: "after the meeting send the notes, book the room".

    A wish is there if behind the comma stands no more than a time: "after lunch I'll mow it, 40 minutes".
    """
    words, source = one.source.scanned.words, one.source
    marker = one.leading_marker()
    if marker is None or marker.end >= len(words):
        return
    first, end = words[marker.end].start, one.segment.span[1]
    only_timed = one.timed(tree).issuperset(range(len(tree.nodes)))
    timed = {p for a, b in (phrase.span for phrase in source.phrases) for p in front.at(a, b)}
    for here, node in enumerate(front.nodes):
        start = node.start + one.segment.span[0]
        sure = here > 0 and only_timed and is_wish(front, here)
        if start > first and here not in timed and (sure or _may_begin(front, here)):
            clause = source.sound[first:start].strip(" ,")
            order = source.sound[start:end].partition(",")[0]
            yield _Try(place, front.lexicon.people, marker.kind, Front(marker.start, start), clause, order)


def may_be_done(tree: Tree, place: int) -> bool:
    """Whether a word may be a bare verb: by its dictionary, or as no noun is followed by an article.

    "If it rains deburr the plate"
    """
    lexicon = tree.lexicon
    node, behind = tree.nodes[place], tree.nodes[place + 1 : place + 2]
    led = any(one.tag in DETERMINERS for one in behind) and node.tag not in BINDING
    # "When the light turns green"; but "when the timer goes varnish the chair"
    becomes = node.tag in {"JJ", "RB"} and tree.nodes[place - 1].lemma in lexicon.doing.being
    becomes = becomes and not (led and node.lower in lexicon.orders)
    return (node.may_act or led) and is_bare(node, lexicon) and not becomes


def is_wish(tree: Tree, place: int) -> bool:
    """Whether it begins to be said what is to be done, or be so: "when it is dark | I want to lock up"."""
    behind = tree.nodes[place + 1 : place + 3]
    if tree.nodes[place].tag in {"DT", "PRP$"}:
        # "Before the guests arrive | the hall must be swept"
        due = tree.lexicon.closed.obligation | tree.lexicon.closed.verbs_of_obligation
        thing = next((node for node in tree.nodes[place + 1 :] if node.tag not in NAMING), None)
        return bool(behind) and thing is not None and (thing.tag in {"VBZ", "MD"} or thing.lower in due)
    asks = any(node.tag == "MD" or node.lemma in tree.lexicon.wanting for node in behind[:1])
    # "If it rains I have to bring in the washing"
    asks = asks or [node.lemma for node in behind] == ["have", "to"]
    return asks and tree.nodes[place].lower in tree.lexicon.closed.first_and_second_person


def _is_event_before_order(tree: Tree, place: int) -> bool:
    """Whether what may be a verb names an event, with an order behind: "the school run drop it off"."""
    lexicon = tree.lexicon
    node, behind = tree.nodes[place], tree.nodes[place + 1 : place + 2]
    named = node.lower in lexicon.lasting | lexicon.happening | lexicon.taken
    # "Once ann is home call bob"
    called = node.lower in lexicon.addressing and len(tree.nodes) == place + 2
    return named and not called and any(one.may_act and is_bare(one, lexicon) for one in behind)


def is_bare(node: Node, lexicon: Lexicon) -> bool:
    """Whether a word may be a verb's bare form, whatever it was taken for: "lower", "lay"."""
    # "When it's done ring the bell": a tree has that for what goes on.
    known = node.tag in COMPARED or node.lower in lexicon.doing.past_alike | lexicon.addressing
    return node.lower == node.lemma.lower() or known


def _as_event(attempt: _Try) -> str:
    """Give a clause to be parsed; one word that may be an event as one: "after work"."""
    clause = attempt.clause
    if attempt.kind in EVENTFUL and clause.isalpha():
        return f"the {clause}"
    # "If its above 40 open the vent"
    first, space, rest = clause.partition(" ")
    if space and first.lower() in attempt.names:
        # "If maya rings": a tree has a small name and its verb for one thing
        return f"she {rest}"
    return f"it is {rest}" if space and first.lower() == ITS else clause


def _may_begin(tree: Tree, place: int) -> bool:
    """Whether what is to be done may begin with a word inside a clause in front: it governs something.

    "The flight pack the bags", "the rice is done turn off the heat", "the pan is hot add butter".
    """
    lexicon = tree.lexicon
    node, behind = tree.nodes[place], tree.nodes[place + 1 : place + 2]
    if not place or not may_be_done(tree, place) or _is_counted(tree, place):
        return False
    before = tree.nodes[place - 1]
    if binds(tree, place - 1):
        return False
    if not behind:
        # "When the battery is low dock, charge and wait"
        return node.lower in lexicon.alone and before.tag in ENDING
    led = behind[0].tag in DETERMINERS or behind[0].lower in lexicon.closed.object_pronouns
    carried = node.lower in lexicon.particles.get(behind[0].lower, ())
    further = tree.nodes[place + 2 : place + 3]
    about = behind[0].tag == "IN" and bool(further) and further[0].lower in lexicon.closed.object_pronouns
    named = behind[0].tag.startswith("NN") and (node.is_verb or before.tag in ENDING)
    # "When the bell rings go to the gate, open it"
    goes = node.lower in lexicon.intransitive and behind[0].tag in {"IN", "TO"}
    return led or carried or about or named or goes


def _is_counted(tree: Tree, place: int) -> bool:
    """Whether a noun is counted: "below 2 bar", "before the last frost"; but "at 70 turn it on"."""
    ends = tree.lexicon.closed.ends_of_rows
    one = any(tree.nodes[p].lower in ends for p in tree.children(place, "amod") if p < place)
    node, following = tree.nodes[place], tree.nodes[place + 1 : place + 2]
    acts = any(
        behind.tag in OPENING or node.lower in tree.lexicon.particles.get(behind.lower, ())
        for behind in following
    )
    return (tree.nodes[place - 1].tag == "CD" or one) and node.tag == "NN" and not acts


def is_order(tree: Tree) -> bool:
    """Whether words begin with what is to be done, or is not: "don't open it"."""
    denied = denied_from(tree, tree.root)
    first = tree.root if denied is None else denied
    return first == 0 and not is_doubtful(tree) and not tree.children(0, *SUBJECTS)
