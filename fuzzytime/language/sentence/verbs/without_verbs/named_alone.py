"""What stands beside when, where no verb is understood: "toolbox talk first thing", "on the road by 6:30".

A plan names most things so. A noun names what is done then; words that begin with where somebody is name no
one, and whoever is asked is to be there.
"""

from collections.abc import Collection, Sequence

from fuzzytime.english import looks_plural
from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.trees.tags import DETERMINERS
from fuzzytime.language.sentence.trees.tree import Node, Tree

NOUNS = ("NN", "VBG", "CD")
"""How the tags begin of what something is called by."""

FIRST = (*NOUNS, "JJ")
"""How the tag of the first word of a name begins."""

INSIDE = (*FIRST, "DT", "PRP$", "PDT", "VBN", "POS", "IN", "TO", "CC", "RB", "RP", "HYPH", "SYM")
"""How the tags begin of what a name, or a place, may hold: no verb of somebody."""

MARKS = frozenset({",", ";", "(", "–", "+"})
"""What ends a name before it."""

PLACES = frozenset({"in", "on"})
"""Where things are put that are only named: "lights out" and "doors open" happen."""

THINGS = frozenset({"NN", "NNS", "VBZ"})
"""Tags of things: a plural in front is often taken for what one does."""


def named_alone(
    tree: Tree, heard: Collection[int], *, chained: bool = False, entry: bool = False
) -> Operation | None:
    """Give what is named beside times and clauses, whose places are ``heard``; None for what is no name.

    What is ``chained`` to another name may be called with its article: "yoga, then a shower". What stands
    beside its hour in an ``entry`` of a timetable names something in any words: "18:25 the half".
    """
    said = _said(tree, heard)
    there = _with_aim(tree, said)
    if there is not None:
        return there
    nodes = [tree.nodes[place] for place in said]
    named = entry or all(_is_inside(tree, place) for place in said)
    if not nodes or not named or _denies(tree, nodes):
        return None
    name, span = _lowered(tree.typed(said)), (nodes[0].start, nodes[-1].end)
    if _is_where(tree, nodes):
        return Operation(verb="be", lemma="be", span=span, place=name)
    heads = [node for node in nodes if node.head not in said or tree.nodes[node.head] is node]
    if entry and heads:
        return Operation(verb=name, lemma=heads[0].lemma, span=span)
    # "Half a tin at six"
    opener = nodes[nodes[0].tag == "PDT" and len(nodes) > 1]
    opened = opener.tag in DETERMINERS
    another = opener.lower in tree.lexicon.closed.indefinite_determiners
    if opened and not (chained or another):
        # "The dog at seven" goes on with the verb said last; but "a short walk before lunch".
        return None
    if not heads or not (opened or nodes[0].tag.startswith((*FIRST, "VB"))) or not _is_noun(heads[0]):
        return None
    return Operation(verb=name, lemma=heads[0].lemma, span=span)


def _with_aim(tree: Tree, said: Sequence[int]) -> Operation | None:
    """Give where somebody is to be, and what for: "up at five to pack"; None where both are not said."""
    nodes = tree.nodes
    aim = next((p for p in said if nodes[p].lower == "to" and nodes[p].head == p + 1), None)
    there = [place for place in said if aim is not None and place < aim]
    if aim is None or len(there) != 1 or not _is_where(tree, [nodes[there[0]]]) or nodes[aim + 1].tag != "VB":
        return None
    first = nodes[there[0]]
    purpose = tree.typed([place for place in said if place >= aim])
    span = (first.start, first.end)
    return Operation(verb="be", lemma="be", span=span, place=first.lower, purpose=purpose)


def _said(tree: Tree, heard: Collection[int]) -> list[int]:
    """Give the places of the words beside what is heard, up to a mark: "piano at ten, 2 people"."""
    said: list[int] = []
    for place, node in enumerate(tree.nodes):
        if said and node.text in MARKS:
            break
        if place not in heard and (node.text[0].isalnum() or node.tag == "POS"):
            said.append(place)
    return said


def _is_inside(tree: Tree, place: int) -> bool:
    """Whether a word may be in a name: none that somebody does, nor a helping verb."""
    return tree.nodes[place].tag.startswith(INSIDE) or _is_noun(tree.nodes[place])


def _is_noun(node: Node) -> bool:
    """Whether a word is a noun, or was taken for a verb and is none, or for what one does: "rolls at ten"."""
    return (
        node.tag.startswith(NOUNS)
        or (node.tag.startswith("VB") and not node.may_act)
        or (node.tag == "VBZ" and looks_plural(node.lower))
    )


def _is_where(tree: Tree, nodes: Sequence[Node]) -> bool:
    """Whether words begin with where somebody, or something, is: "up", "online", "on the road"."""
    lexicon, first = tree.lexicon, nodes[0]
    alone = first.tag == "RB" and first.lower not in lexicon.function_words
    if len(nodes) == 1:
        return alone or first.lower in lexicon.beside.states
    return first.lower in lexicon.beside.states and nodes[-1].tag.startswith("NN")


def _denies(tree: Tree, nodes: Sequence[Node]) -> bool:
    """Whether words say what is not to be."""
    closed = tree.lexicon.closed
    return not (closed.negators | closed.negative_pronouns | {"no"}).isdisjoint(node.lower for node in nodes)


def _lowered(said: str) -> str:
    return said[:1].lower() + said[1:] if said[1:2].islower() else said


def put_there(tree: Tree, timed: Sequence[int], *, lasts: bool) -> Operation | None:
    """Give what is named with "in" or "on" and a time behind it as to be put there; None for all else.

    Who comes in does so alone ("mum in at six"), and what happens is on ("dinner on at six").
    """
    lexicon = tree.lexicon
    nodes = tree.nodes
    first = 1 if nodes and nodes[0].tag in DETERMINERS else 0
    place = next((p for p in range(first + 1, len(nodes)) if nodes[p].lower in PLACES), 0)
    behind = "".join(node.lower for node in nodes[place + 1 : place + 2])
    # "5.30 chicken in, 1 hr 20"
    ends = place + 1 in timed or (lasts and behind in {"", ","})
    if not place or not ends or place in timed:
        return None
    # "Spuds in 12.20 for an hour"; but "withdrawals in by six", "lights on at six"
    goes_in = lasts and nodes[place].lower == "in" and behind != "by"
    if nodes[place].tag == "IN" and not goes_in:
        return None
    things = nodes[first:place]
    thing = things[-1]
    named = {node.lower for node in things}
    known = named & (lexicon.happening | lexicon.taken | lexicon.persons | lexicon.travelling)
    acts = thing.lower == thing.lemma and thing.may_act
    # "Lamb in at eleven for two hours", which a tree takes for a verb
    verbs = lexicon.orders.union(lexicon.intransitive, lexicon.needing_nothing, lexicon.particles["in"])
    verbs = verbs.union(lexicon.addressing, lexicon.lasting, lexicon.circling, lexicon.doing.errands)
    mistaken = thing.is_verb and goes_in and thing.lower not in verbs
    others = any(node.tag not in THINGS | {"JJ"} for node in things[:-1])
    if known or others or not (mistaken or (thing.tag in THINGS and not acts)):
        return None
    if thing.tag == "VBZ" and len(things) > 1:
        # "The bus comes in at nine"
        return None
    said = tree.typed(range(place))
    span = (nodes[place].start, nodes[place].end)
    lowered = said[:1].lower() + said[1:] if nodes[0].text[1:].islower() else said
    return Operation(verb="put", lemma="put", span=span, object=lowered, particle=nodes[place].lower)
