"""Entries of a sentence, each with its time: "lights off at eleven, eggs at ten", "at one maths, at two art".

Each names a thing, or how a thing is to be, and no verb holds for two of them. So each is parsed alone: one
tree of all of them has no root that is of all. A state that stands alone is of the thing that had one before:
"stew on at one, stir it at two, off at five".
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.sentence.segments.borrowed import Borrowed
from fuzzytime.language.sentence.segments.segment import Segment
from fuzzytime.language.sentence.segments.waiting import Part, Waiting
from fuzzytime.language.sentence.trees.named import names_one
from fuzzytime.language.sentence.trees.tags import DETERMINERS, NAMING, PAST
from fuzzytime.language.sentence.trees.tree import Node

FINITE = frozenset({"VBZ", "VBD", "VBP", "VB", "MD"})
"""Tags of words in what tells, or asks for, more than when something is."""

INSIDE = frozenset({"IN", "TO", "POS"})
"""Tags of little words in a name: "dinner with Jo", "samples to the lab", "mum's birthday"."""

LONGEST = 6
"""Words of what an entry names at most."""


@dataclass(frozen=True, slots=True)
class _Entry:
    """What stands between two joints: where it begins, and its words that are no time.

    It is ``whole`` where these stand together with all its times on one side, which may ``lead``.
    """

    start: int
    name: tuple[Node, ...]
    whole: bool
    leads: bool
    lexicon: Lexicon

    @property
    def opened(self) -> bool:
        """Whether an article begins it: "feed the cat at eight, the dog at nine" is of one verb."""
        return bool(self.name) and self.name[0].tag in DETERMINERS

    @property
    def state(self) -> tuple[Node, ...]:
        """The words that say where, or how, a thing is to be: "hens in", "lights off", "sam to judo"."""
        lexicon, words = self.lexicon, [node.lower for node in self.name]
        where = lexicon.beside.states | lexicon.particles.keys() | lexicon.doing.opening_up | {"to"}
        stated = (p for p, node in enumerate(self.name) if node.lower in where or (p and node.tag in PAST))
        first = next(stated, len(words))
        return self.name[-1:] if lexicon.results.issuperset(words[-1:]) else self.name[first:]

    @property
    def thing(self) -> tuple[Node, ...]:
        """The words of its name without an article in front, and without the state at its end."""
        return self.name[self.opened : len(self.name) - len(self.state)]

    @property
    def is_state(self) -> bool:
        """Whether somebody is to be somewhere, or a thing said before so: "up at six", "off at five"."""
        return bool(self.state) and not self.thing

    @property
    def carries(self) -> bool:
        """Whether it is a verb with its particle, which another may follow: "turn on at five, off at six"."""
        lexicon, verb = self.lexicon, self.name[0]
        particles = (lexicon.particles.get(node.lower, frozenset()) for node in self.state)
        return len(self.thing) == 1 and any(verb.lemma in carried for carried in particles)

    @property
    def tells(self) -> bool:
        """Whether its words tell what somebody or something does: "swimming starts at four"."""
        words = self.thing[1:] if self.thing else ()
        return self.whole and any(node.tag in FINITE - {"VB", "MD"} for node in words)

    @property
    def is_alone(self) -> bool:
        """Whether its name alone says what one does: "gym at six, a shower, bed at ten"."""
        lexicon, name = self.lexicon, [node.lower for node in self.thing]
        known = lexicon.happening | lexicon.taken | lexicon.lasting
        return len(name) == 1 and (name[0] in known or (name[0],) in lexicon.conversation["by itself"])

    @property
    def names(self) -> bool:
        """Whether it names a thing by itself, of which it says when it is, or is to be so."""
        if not (self.whole or self.is_alone) or not self.thing or len(self.name) > LONGEST:
            return False
        lexicon, first = self.lexicon, self.thing[0].lower
        called = first in lexicon.closed.universal_pronouns
        opens = called or first not in lexicon.function_words | lexicon.numbers.keys()
        worded = all(node.text[0].isalpha() for node in self.name)
        leads_on = self.thing[-1].tag in INSIDE or any(
            node.tag in FINITE or self._leads_on(before, node) for before, node in pairwise(self.thing)
        )
        return opens and worded and not leads_on and not self._asks

    @property
    def asks(self) -> bool:
        """Whether it may begin with an order: "gym at six, then pick up jo at seven"."""
        first, lexicon = self.name[0], self.lexicon
        acts = first.may_act and first.text == first.lemma and not names_one(self.name, lexicon)
        return acts and first.lower not in lexicon.function_words | lexicon.names_like_words

    @property
    def _asks(self) -> bool:
        """Whether its thing is a verb with what that is done with; "get up at seven" asks for no more."""
        lexicon, (first, *further) = self.lexicon, self.thing
        if not first.may_act or first.lower != first.lemma or names_one(self.thing, lexicon):
            return False
        if not further:
            # "Pick up ella from ballet"; but "get up", "tea on the table"
            return self.carries and any(node.tag.startswith("NN") for node in self.state)
        # "Lunch with Dan", "dinner party"; but "bath the baby", "call Ann"
        timed = lexicon.happening | lexicon.taken | lexicon.lasting
        return first.lower not in timed or not (further[0].tag in INSIDE or further[-1].lower in timed)

    def is_apart(self, before: "_Entry", *, listed: bool) -> bool:
        """Whether no verb of the entry before holds for it; a thing begins what is ``listed``."""
        if self.asks and (before.names or (self.leads and len(self.name) > 1)):
            # "The stalls open at ten and close at four"
            return self.lexicon.doing.opening_up.isdisjoint(node.lower for node in before.state)
        if before.tells:
            # "Swimming starts at four, tea on the table by six"; but "bread comes out at ten, pies at noon"
            placed = bool(self.state) and self.state[0].tag not in PAST
            return self.names and placed and not (self.opened or self.asks)
        # "Gym at six, walk bella at seven, dinner at eight"; but "…, the dog at eight"
        return listed and self.names and not (self.opened and (before.asks or not before.names))

    def _leads_on(self, before: Node, node: Node) -> bool:
        """Whether a word is of a sentence, and of no name: "lock the door"; but "dinner with the Lees"."""
        lexicon = self.lexicon
        if node.lower in lexicon.closed.noun_openers:
            return before.tag not in INSIDE
        inside = node.tag in INSIDE and node is not self.thing[-1]
        return node.lower in lexicon.function_words and not inside


def entries_of(one: Waiting, part: Part) -> list[Segment]:
    """Give the entries of a segment, each by itself; none where it is no such list."""
    segment, source = one.segment, one.source
    clauses = (
        longest_match(source.scanned.words, at, one.lexicon.clauses) for at in source.places(*segment.span)
    )
    if segment.verbless or segment.borrowed or any(clauses):
        return []
    further = dict(_further(one, part))
    if not further:
        return []
    ends = [*(one.end_before(start) for start in further), segment.span[1]]
    first = replace(segment, span=(segment.span[0], ends[0]))
    behind = (
        Segment((start, end), addressee=segment.addressee, borrowed=borrowed, entry=True)
        for (start, borrowed), end in zip(further.items(), ends[1:], strict=True)
    )
    return [first, *behind]


def _further(one: Waiting, part: Part) -> Iterator[tuple[int, tuple[Borrowed, ...]]]:
    """Give where further entries begin behind a first that names a thing, with the words that they borrow.

    Times in front tell orders apart as well: "at eight take the cat to the vet, at ten ring work".
    """
    entries = _entries(one, part)
    before = next(entries, None)
    if before is None or not before.whole or not (before.names or before.leads or before.tells):
        return
    leads, listed, stated = before.leads, before.names, before
    for entry in entries:
        if not entry.name:
            # "Stir at two, three and four"
            continue
        if entry.leads is not leads or not (entry.whole or entry.is_alone):
            return
        start = part.tree.nodes[entry.start].start + part.offset
        if entry.is_state and before.tells:
            # "The shop is open at nine and closed at six"
            return
        if entry.is_state:
            # "Stew on at one, stir at two, off at five"; but "flight at ten, taxi at seven, up at six"
            thing = stated.thing if stated.state and not stated.carries else ()
            if not before.carries:
                yield start, (Borrowed(start, part.span(thing[0], thing[-1])),) if thing else ()
        elif entry.is_apart(before, listed=listed):
            yield start, ()
        stated = entry if entry.state and entry.thing else stated
        before = entry


def _entries(one: Waiting, part: Part) -> Iterator[_Entry]:
    """Give what stands between the joints of a segment."""
    nodes, timed = part.tree.nodes, one.timed(part.tree)
    joining = part.lexicon.closed.joints_of_entries
    joints = [place for place, node in enumerate(nodes) if place not in timed and node.lower in joining]
    first = 0
    for end in (*joints, len(nodes)):
        if first < end:
            said = [place for place in range(first, end) if place not in timed]
            said = said[: _before_place(said, nodes)]
            # A time in front of the first may be none of its tree's.
            apart = not first and one.heard_from > 0
            leads = apart or first in timed
            where = range(end - len(said), end) if leads else range(first, first + len(said))
            whole = bool(said) and said == list(where) and (apart or len(said) < len(range(first, end)))
            yield _Entry(first, tuple(nodes[place] for place in said), whole, leads, one.lexicon)
        first = end + 1


def _before_place(said: Sequence[int], nodes: Sequence[Node]) -> int:
    """Give how many words name an entry, where a place stands behind its time: "gym at six in town"."""
    apart = next((at for at in range(1, len(said)) if said[at] - said[at - 1] > 1), len(said))
    behind = [nodes[place] for place in said[apart:]]
    placed = len(behind) > 1 and behind[0].tag == "IN" and all(node.tag in NAMING for node in behind[1:])
    return apart if placed else len(said)
