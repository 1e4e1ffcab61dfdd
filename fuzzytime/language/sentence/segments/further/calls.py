"""Who is called where no comma shows it: "robot 1 fetch the crate and robot 2 stack it", "Ann set the table".

The tree mostly has the second for another thing that is fetched, so that words tell: a name, or a worker's
with a number, and a bare verb that governs something.
"""

from collections.abc import Container, Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.sentence.segments.fronts import is_bare
from fuzzytime.language.sentence.segments.segment import DASHES, Segment
from fuzzytime.language.sentence.segments.waiting import Part, Waiting
from fuzzytime.language.sentence.trees.tags import DETERMINERS
from fuzzytime.language.sentence.trees.tree import Node

NUMBERED = 2
"""Words of "robot 2"."""

MARKS = frozenset({",", ":"})
"""What may stand behind a name that is called."""

PARTICLES = frozenset({"IN", "RP"})
"""Tags of words that say where: "out the door"."""

LEADING = PARTICLES | {"TO", "RB"}
"""Tags of words that an order without an object may go on with: "dock at the gate"."""

FINITE = frozenset({"VBZ", "VBD", "MD"})
"""Tags of what is said to be so."""

SHORTEST_CALL = 3
"""Words of an instruction at least that names who is asked: a name, a comma, what is to be done."""


def called_first(one: Waiting, part: Part) -> list[Segment]:
    """Give the segment without whom it calls: "robot 2 weld the frame", "let robot 2 weld it"."""
    timed = one.timed(part.tree)
    first = next(part.tree.at(one.behind_time, one.behind_time + 1), 0)
    found = None if one.segment.addressee is not None else _called_at(one, part, first, timed)
    if found is None:
        return []
    called, verb = found
    return [replace(one.segment, span=(verb.start + part.offset, one.segment.span[1]), addressee=called)]


def called_next(one: Waiting, part: Part) -> list[Segment]:
    """Cut a segment where it calls another: "…, robot 2 stack it", "… and Bob, stack it"."""
    first, last = one.segment.span
    nodes = part.tree.nodes
    # The words about time of a long list are looked for once.
    timed = one.timed(part.tree)
    for place in range(2, len(nodes)):
        joined = nodes[place - 1].lower in part.lexicon.closed.joints_of_orders
        # "Robot 1 and robot 2 stack the boxes"
        together = joined and place - 1 == _length_of_name(nodes, 0, part.lexicon)
        found = _called_at(one, part, place, timed) if joined and not together else None
        if found is None:
            continue
        end = one.end_before(nodes[place].start + part.offset)
        if end > part.offset:
            called, verb = found
            further = Segment((verb.start + part.offset, last), addressee=called)
            return [replace(one.segment, span=(first, end)), further]
    return []


def _called_at(one: Waiting, part: Part, place: int, timed: Container[int]) -> tuple[str, Node] | None:
    """Give the name that is called at a place, and the verb behind it; None where nobody is called."""
    lexicon = part.lexicon
    nodes = part.tree.nodes
    leads = nodes[place : place + 1] and nodes[place].lower in (
        lexicon.letting | lexicon.causing | lexicon.addressing
    )
    name = place + bool(leads)
    length = _length_of_name(nodes, name, lexicon)
    verb = name + length
    if not length or verb >= len(nodes) or name in timed or (leads and length < NUMBERED):
        return None
    asked = leads or (place > 0 and one.segment.addressee is not None and length == NUMBERED)
    if nodes[verb].text in MARKS or (asked and nodes[verb].tag == "TO"):
        # Behind "robot 2:", "tell robot 2 to", "tell robot 1 to sweep and robot 2 to"
        verb += 1
    elif (nodes[verb].lower,) in lexicon.courtesies:
        # "Anna please take the bus"
        verb += 1
    called = " ".join(node.text for node in nodes[name : name + length])
    if place == name and one.segment.addressee is None and _is_asked(nodes, verb, lexicon):
        return called, nodes[verb]
    return (called, nodes[verb]) if _is_order(nodes, verb, timed, lexicon, sure=length == NUMBERED) else None


def _is_asked(nodes: Sequence[Node], place: int, lexicon: Lexicon) -> bool:
    """Whether words ask who was named before them for something: "sarah | can you feed the cat"."""
    closed = lexicon.closed
    asking, whom = ([node.lower for node in nodes[place:]] + ["", ""])[:2]
    return asking in closed.requesting_modals and whom in closed.second_person


def _length_of_name(nodes: Sequence[Node], place: int, lexicon: Lexicon) -> int:
    """Give how many words name somebody at a place: a worker and a number, a name, a person; 0 for none."""
    name, following = nodes[place : place + 1], nodes[place + 1 : place + 2]
    if not name:
        return 0
    if name[0].lower in lexicon.workers and following and following[0].tag == "CD":
        return NUMBERED
    # "… and Bob stack it": bob is a verb, too, which has no capital inside a sentence.
    named = name[0].tag == "NNP" and name[0].text[0].isupper() and (place > 0 or not name[0].may_act)
    called = name[0].lower in lexicon.persons | lexicon.workers and not name[0].may_act
    return int(named or called or name[0].lower in lexicon.names_like_words)


def _is_order(
    nodes: Sequence[Node], verb: int, timed: Container[int], lexicon: Lexicon, *, sure: bool
) -> bool:
    """Whether a bare verb stands there that governs something; behind a name that is ``sure`` also alone."""
    if verb >= len(nodes) or not nodes[verb].may_act or not is_bare(nodes[verb], lexicon) or verb in timed:
        return False
    if verb + 1 == len(nodes) or verb + 1 in timed:
        return sure
    if nodes[verb].tag in PARTICLES:
        # "Everyone out the door at nine"
        return False
    behind = nodes[verb + 1]
    carried = nodes[verb].lower in lexicon.particles.get(behind.lower, ())
    if carried or behind.tag in DETERMINERS or behind.lower in lexicon.closed.object_pronouns:
        return True
    # "Robot 2 fetch water"; but "robot 2 charge level is low"
    named = behind.tag.startswith("NN") and not any(node.tag in FINITE for node in nodes[verb + 1 :])
    return sure and (named or behind.tag in LEADING)


def addressed(one: Waiting, part: Part) -> list[Segment]:
    """Give the segment without the name before its first comma, or behind its last, of who is asked.

    A name begins with a capital, and is no verb: "Wash, peel and slice the apples" asks nobody by name.
    """
    nodes = part.tree.nodes
    if one.segment.addressee is not None or len(nodes) < SHORTEST_CALL:
        return []
    first, last = one.segment.span
    # As in "Robot 3: dock at noon", with a number behind it, or "arm A: pick part 3".
    lettered = nodes[0].lower in part.lexicon.workers and len(nodes[1].text) == 1 and nodes[1].text.isupper()
    mark = 1 + (nodes[1].tag == "CD" or lettered)
    for name, rest in ((nodes[:mark], nodes[mark + 1 :]), (nodes[-1:], nodes[:-2])):
        separator = nodes[mark] if name[0] is nodes[0] else nodes[-2]
        # "Robot 3 - dock at noon", "lock up at ten - Janet"; but "dinner at seven - pasta"
        known = name[0].lower in part.lexicon.people and _asks(one, part, rest)
        dash = separator.text in DASHES and (known or mark == len(name) == NUMBERED)
        if (dash or separator.text in {",", ":"}) and rest and _is_name(one, part, name):
            span = part.span(rest[0], rest[-1])
            span = (span[0], last) if name[0] is nodes[0] else (first, span[1])
            called = " ".join(node.text for node in name)
            segment = replace(one.segment, span=span, addressee=called)
            if Waiting.of(one.position, one.source, segment).text:
                return [segment]
    return []


def _asks(one: Waiting, part: Part, nodes: Sequence[Node]) -> bool:
    """Whether words begin with what is done and with what: "set up", but "hospital appointment", "call"."""
    lexicon, timed = part.lexicon, one.timed(part.tree)
    said = [node for node in nodes if part.tree.nodes.index(node) not in timed and node.text.isalnum()]
    happens = lexicon.happening | lexicon.taken
    return len(said) > 1 and said[0].may_act and is_bare(said[0], lexicon) and said[0].lower not in happens


def _is_name(one: Waiting, part: Part, nodes: Sequence[Node]) -> bool:
    """Whether words call somebody, or a machine by its number."""
    name = nodes[0]
    places = one.source.places(*part.span(name, nodes[-1]))
    known = name.text[0].isupper() or name.lower in part.lexicon.persons | part.lexicon.machines
    machine = len(nodes) > 1 and name.lower in part.lexicon.machines
    # "Bob, mow the lawn": who is called like a verb, before what is done.
    called = name.tag == "NNP" and part.tree.root == part.tree.nodes.index(name) + 2
    return (
        known
        and name.text.isalpha()
        and (machine or called or not name.may_act)
        and one.source.covered.isdisjoint(places)
    )
