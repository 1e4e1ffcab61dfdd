"""Who is asked, by name, before a comma or behind one: "robot 3, dock at noon", "dock at noon, robot 3"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.sentence.segments.segment import Segment
from fuzzytime.language.sentence.segments.waiting import Part, Waiting
from fuzzytime.language.sentence.trees.tree import Node

SHORTEST_CALL = 3
"""Words of an instruction at least that names who is asked: a name, a comma, what is to be done."""


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
        dash = separator.text == "-" and mark == 2
        if (dash or separator.text in {",", ":"}) and rest and _is_name(one, part, name):
            span = part.span(rest[0], rest[-1])
            span = (span[0], last) if name[0] is nodes[0] else (first, span[1])
            called = " ".join(node.text for node in name)
            segment = replace(one.segment, span=span, addressee=called)
            if Waiting.of(one.position, one.source, segment).text:
                return [segment]
    return []


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
