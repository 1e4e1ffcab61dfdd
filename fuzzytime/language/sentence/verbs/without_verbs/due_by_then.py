"""What must be so by a time, or at one, said without a verb: "cat fed by six", "all hands on deck at six"."""

from collections.abc import Collection, Sequence

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.trees.named import is_shut
from fuzzytime.language.sentence.trees.tags import ALL_NOUNS, DETERMINERS, PAST
from fuzzytime.language.sentence.trees.tree import Node, Tree

NAMING = ALL_NOUNS | {"JJ", "CD", "PRP$", "POS"}
"""Tags of the words that name a thing."""

HEADLINED = frozenset({"NN", "NNS"})
"""Tags of the first word of things without an article, of which a plan says what is done with them."""

PLURALS = frozenset({"NNS", "VBZ"})
"""Tags of things of which there are several: a plural in front is often taken for what one does."""


def due_by_then(
    tree: Tree, due: Collection[int], moments: Collection[int], timed: Collection[int], *, listed: bool
) -> Operation | None:
    """Give what a thing must have become, or where it must be, by the deadline right behind that.

    Nothing but times stands behind; ``due`` are the places of the deadline, ``timed`` those of all times. At
    one of ``moments`` all of a kind must be somewhere, and things put off, out or down. At any other time
    something must be done with things that have no article: "actors called for 14:00"; and at a moment where
    it is ``listed`` among what is to come: "fish delivered 9.30", "Ella dropped off 8.15".
    """
    lexicon, nodes = tree.lexicon, tree.nodes
    whole = bool(nodes) and nodes[0].lower in lexicon.closed.universal_determiners and len(nodes) > 1
    led = bool(nodes) and (nodes[0].tag in DETERMINERS or (whole and nodes[1].tag in ALL_NOUNS | PLURALS))
    first = int(led)
    end = next((place for place in range(first, len(nodes)) if place in timed), len(nodes))
    rest = (place for place in range(end, len(nodes)) if nodes[place].relation != "punct")
    if end not in timed or any(place not in timed for place in rest):
        return None
    state = _state(nodes[:end], lexicon, listed=listed)
    if state <= first or _is_ordered(nodes[first:state], lexicon):
        return None
    headlined = nodes[state].tag in PAST and not first and nodes[0].tag in (NAMING if listed else HEADLINED)
    wished = headlined and (listed or end not in moments)
    wished = wished or (end in moments and _is_wished(nodes[:end], state, lexicon))
    if end not in due and (not wished or nodes[state].lower in lexicon.doing.foretold):
        # "Taxi booked for 8.40" is only told.
        return None
    thing, said = tree.typed(range(state)), tree.typed(range(state, end))
    span = (nodes[state].start, nodes[end - 1].end)
    if nodes[state].tag in PAST:
        within = all(node.tag in NAMING | {"IN", "DT"} for node in nodes[first + 1 : state])
        told = nodes[end].lower != "by" and is_shut(nodes[state - 1], nodes[state], lexicon)
        due_now = None if told else "must be"
        done = Operation(
            verb=said, lemma=nodes[state].lemma, span=span, object=thing, due=due_now, stated=told
        )
        return done if within else None
    again = lexicon.closed.adverbs_of_repetition
    behind = [node for node in nodes[state + 1 : end] if node.lower not in again]
    named = all(node.tag in NAMING | DETERMINERS | {"IN"} for node in behind)
    ordered = not first and nodes[first].may_act and nodes[first].lower == nodes[first].lemma
    ordered = ordered and nodes[first].lower not in lexicon.doing.recipients
    if not named or ordered or not _is_thing(nodes[first:state], lexicon):
        # "Report on the sales by friday" may be an order.
        return None
    return Operation(verb="be", lemma="be", span=span, object=thing, place=said, due="must")


def so_alone(tree: Tree) -> Operation | None:
    """Give what a thing must be, or where, where nothing else is said: "lid on" behind "simmer 50 min"."""
    lexicon = tree.lexicon
    nodes = [node for node in tree.nodes if node.relation != "punct"]
    things, state = nodes[nodes[:1] != [] and nodes[0].tag in DETERMINERS : -1], nodes[-1:]
    states = lexicon.particles.keys() | lexicon.doing.opening_up
    if not things or state[0].lower not in states or not all(n.tag in NAMING | PAST for n in things):
        return None
    first, known = things[0], _who_or_what_happens(lexicon)
    if (first.may_act and first.lower == first.lemma) or not known.isdisjoint(n.lower for n in things):
        # "Rinse off", "mum in"
        return None
    span = (state[0].start, state[0].end)
    said = tree.typed(range(len(nodes) - 1))
    return Operation(verb="be", lemma="be", span=span, object=said, place=state[0].text, due="must")


def is_thing_so(tree: Tree, timed: Collection[int]) -> bool:
    """Whether a thing is named, and right before a time what is done with it: "garage door shut by nine"."""
    root, nodes = tree.root, tree.nodes
    led = [p for p in tree.children(root, "compound") if p < root]
    done = root + 2 in timed and nodes[root + 1].tag == "VBN"
    return done and nodes[root].tag in ALL_NOUNS and led == [*range(root)] != []


def _state(nodes: Sequence[Node], lexicon: Lexicon, *, listed: bool) -> int:
    """Give where it begins what is so by then: at what is done last, or else where it is; 0 for nothing."""
    last = len(nodes) - 1
    # "Miked up"
    last -= last > 1 and nodes[last].lower in lexicon.particles and nodes[last - 1].tag in PAST
    if last > 0 and _is_done(nodes[last], nodes[last - 1], lexicon, listed=listed):
        both = (
            last > 2
            and nodes[last - 1].lower in lexicon.closed.additive_conjunctions
            and nodes[last - 2].tag in PAST
        )
        # "Washed and hoovered"
        return last - 2 if both else last
    if last > 0 and nodes[last].tag.startswith("JJ") and nodes[last].lower in lexicon.results:
        # "Camera ready"
        return last
    states = lexicon.beside.states
    return next((place for place in range(1, len(nodes)) if nodes[place].lower in states), 0)


def _is_thing(thing: Sequence[Node], lexicon: Lexicon) -> bool:
    """Whether words name something, of which there may be several: "lights", taken for what one does."""
    doing = lexicon.doing
    acts = doing.arriving | doing.leaving | doing.being | doing.stopping | doing.phases
    several = len(thing) == 1 and thing[0].tag == "VBZ" and thing[0].lemma not in acts
    everyone = len(thing) == 1 and thing[0].lower in lexicon.closed.universal_pronouns
    # "Heating off", "telly off"
    called = len(thing) == 1 and (thing[0].tag == "VBG" or not thing[0].may_act)
    return several or everyone or called or all(node.tag in NAMING for node in thing)


def _is_wished(nodes: Sequence[Node], state: int, lexicon: Lexicon) -> bool:
    """Whether it is wished that something is so at a time, and not told: "mum back at six"."""
    closed = lexicon.closed
    if nodes[0].lower in closed.universal_pronouns | closed.universal_determiners:
        return True
    known = _who_or_what_happens(lexicon)
    things = [node for node in nodes[:state] if node.tag not in DETERMINERS]
    away = nodes[state].lower in lexicon.particles and nodes[state].tag not in PAST
    # "Oven on", "heating off", "porch light on"; but "stew on", "warm up"
    first, last = things[0], things[-1]
    behind = {node.lower for node in nodes[state + 1 :]} - lexicon.closed.adverbs_of_repetition
    one = not behind and not (first.may_act and first.lower == first.lemma)
    named = last.tag in PLURALS or one
    return away and named and known.isdisjoint(node.lower for node in things)


def _who_or_what_happens(lexicon: Lexicon) -> frozenset[str]:
    """Give what is called by words that are told to be somewhere, or on, and not wished to be so."""
    return lexicon.happening | lexicon.taken | lexicon.persons | lexicon.travelling


def _is_done(node: Node, before: Node, lexicon: Lexicon, *, listed: bool) -> bool:
    """Whether a word is what is done with something: "fed"; but "mum arrived" by herself."""
    comes = lexicon.intransitive | lexicon.doing.arriving | lexicon.doing.leaving
    # "Night feed was at four" tells what was.
    done = node.tag == "VBN" or (node.tag == "VBD" and node.lemma not in {node.lower, "be"})
    # "Ann called by six" may tell what was.
    done = done and (listed or not (node.tag == "VBD" and before.tag == "NNP"))
    return done and (node.lemma not in comes or before.lower in lexicon.animals)


def _is_ordered(thing: Sequence[Node], lexicon: Lexicon) -> bool:
    """Whether what stands in front is no thing, but to be done: "get fed", "bring the coats ironed".

    A thing that is called like a verb may be taken for it where nothing stands between: "floor mopped".
    """
    # "Back gate locked by ten"
    named = thing[0].tag in NAMING or thing[0].relation == "compound"
    named = named and thing[-1].tag in NAMING
    alone = len(thing) == 1 or thing[1].tag in {"CD", "IN"}
    becoming = lexicon.causing | lexicon.letting | lexicon.wanting | lexicon.doing.being
    return not (named or alone) or thing[0].lemma in becoming
