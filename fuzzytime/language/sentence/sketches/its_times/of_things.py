"""Times of the things that something is done with: "cancel my alarm for six", "find a flight after ten".

They say which is meant, and not when to do it.
"""

from collections.abc import Iterator, Sequence

from fuzzytime.language.meaning.days.relations import Deictic, Relative, Which
from fuzzytime.language.meaning.expressions import Offset, Phrase, Range, Repeat, Wall
from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.trees.tree import Node
from fuzzytime.language.sentence.verbs.meant.actions import Action
from fuzzytime.requirement import BOUNDS

OF_THINGS = frozenset({None, "at", "on", "for", "from", "in"})
"""Prepositions of a time that a thing has."""

NAMING = ("NN", "JJ", "DT", "PRP$", "CD", "VBG", "POS", "PDT")
"""How tags begin of the words of a thing's name."""

FARTHEST = 3
"""Words behind a verb at most to the one that belongs to it: "turn my alarm off"."""


def of_things(part: Part, phrases: Sequence[Phrase], action: Action) -> list[Phrase]:
    """Give the times that say which thing is meant."""
    reader = _Things(part, action)
    found = [phrase for phrase in phrases if reader.has(phrase)]
    return found or list(reader.of_purpose(phrases))


class _Things:
    """The things that an action is about."""

    def __init__(self, part: Part, action: Action) -> None:
        self.part, self.tree, self.lexicon = part, part.tree, part.lexicon
        self.nodes, self.verb = part.tree.nodes, action.place
        node = self.nodes[action.place]
        following = self.nodes[action.place + 1 : action.place + 1 + FARTHEST]
        # "Sign me up", "turn my alarm off"
        self.said = {f"{node.lemma} {other.lower}" for other in following}
        moved = self.lexicon.particles.keys() | self.lexicon.places
        if not any(other.lower in moved for other in following[:1]):
            # "Check in on friday" checks nothing.
            self.said.add(node.lemma)

    def has(self, phrase: Phrase) -> bool:
        """Whether a time is of a thing."""
        place = self._behind(phrase)
        if place is None:
            return False
        if self.nodes[place].lower == "than" and self.nodes[place - 1].lower in self.lexicon.beside.ages:
            # "Delete emails older than thirty days"
            return True
        if isinstance(phrase.said.time, Repeat) and self._is_told_of(place, None):
            # "Pack the things we use every day"
            return True
        return (
            self._is_revoked(phrase, place) or self._is_joined(phrase, place) or self._is_found(phrase, place)
        )

    def _behind(self, phrase: Phrase) -> int | None:
        """Give the word right before a time, behind the verb."""
        first = next(self.part.at(phrase.span), 0)
        return first - 1 if first - 1 > self.verb else None

    def _name(self, place: int) -> list[Node]:
        """Give the words of a name that ends at a place: "the half marathon"."""
        first = place
        while first - 1 > self.verb and self.nodes[first - 1].tag.startswith(NAMING):
            first -= 1
        return list(self.nodes[first : place + 1])

    # -- what is cancelled ------------------------------------------------------------------------------

    def _is_revoked(self, phrase: Phrase, place: int) -> bool:
        """Whether it is of what is cancelled or deleted: "cancel my alarm for six"."""
        doing, said = self.lexicon.doing, phrase.said
        declined = not self.said.isdisjoint(doing.declining)
        if not declined and self.said.isdisjoint(doing.revoking):
            return False
        if self._is_recorded(phrase, place):
            # "Delete the messages from this morning"
            return True
        if not isinstance(said.time, (Wall, Range, Repeat)):
            return False
        several = self._is_several(place, declined=declined)
        # "Cancel whatever I've got on the third"
        several = several or self.nodes[self.verb + 1].lower in self.lexicon.closed.free_relatives
        if said.constraint in BOUNDS:
            return several and said.preposition in {"after", "before", "from", "since"}
        if said.preposition not in OF_THINGS or not (declined or several or said.preposition == "for"):
            return False
        return several or self._has_time(place, declined=declined) or self._is_called(phrase, place)

    def _is_several(self, place: int, *, declined: bool) -> bool:
        """Whether all of a kind are meant that has times: "everything", "all my meetings"."""
        closed = self.lexicon.closed
        led = self._name(place)[0].lower in closed.universal_determiners
        return self.nodes[place].lower in closed.wholes or (led and self._has_time(place, declined=declined))

    def _has_time(self, place: int, *, declined: bool) -> bool:
        """Whether a thing has a time: an alarm, a meeting."""
        lexicon, node = self.lexicon, self.nodes[place]
        known = lexicon.beside.timed_things
        if declined:
            known = known | lexicon.taken | lexicon.happening | lexicon.events
        return not known.isdisjoint((node.lower, node.lemma))

    def _is_called(self, phrase: Phrase, place: int) -> bool:
        """Whether a day is of what is called by a clock time: "cancel my nine o'clock tomorrow"."""
        dated = phrase.said.wall.days is not None and phrase.said.wall.clock is None
        clock = self.nodes[place].tag == "CD" or self.nodes[place].lower in self.lexicon.beside.of_clocks
        opened = self._name(place)[0].tag in {"DT", "PRP$"}
        return dated and clock and opened

    # -- what somebody comes to --------------------------------------------------------------------------

    def _is_joined(self, phrase: Phrase, place: int) -> bool:
        """Whether it is of what somebody comes to: "invite dad to dinner on sunday"."""
        doing = self.lexicon.doing
        joins = self._is_listed() or not self.said.isdisjoint(doing.inviting)
        dated = isinstance(phrase.said.time, (Wall, Range, Repeat))
        if not joins or not dated or phrase.said.constraint in BOUNDS:
            return False
        part = phrase.said.wall.part
        if self.nodes[place + 1].lower == "for" and part is not None and part.meal:
            # "Invite Tom for tea tonight"
            return True
        direct = {"invite": {"to"}}.get(self.nodes[self.verb].lemma, {"to", "for"})
        if phrase.said.preposition in direct:
            # "Invite Tom to the four pm on thursday"
            return True
        named = self.nodes[place].tag.startswith(("NN", "VBG"))
        return named and self.nodes[place - len(self._name(place))].lower in {"to", "for"}

    def _is_listed(self) -> bool:
        """Whether somebody is put on a list: "put me down", "put us on the guest list"."""
        who, *behind = (*(node.lower for node in self.nodes[self.verb + 1 :]), "")
        beside = self.lexicon.beside
        person = who in self.lexicon.closed.indirect_objects
        return (
            person and self.nodes[self.verb].lemma in beside.listing and not beside.lists.isdisjoint(behind)
        )

    # -- what is looked for ------------------------------------------------------------------------------

    def _is_found(self, phrase: Phrase, place: int) -> bool:
        """Whether it is of what is looked for or shown: "find a flight leaving after six"."""
        doing = self.lexicon.doing
        finds, shows = (not self.said.isdisjoint(words) for words in (doing.finding, doing.showing))
        if not finds and not shows:
            return False
        if self._is_recorded(phrase, place) or (finds and self._is_sought(phrase, place)):
            return True
        # "Read my schedule for tomorrow"
        return shows and phrase.said.preposition == "for" and self._has_time(place, declined=False)

    def _is_recorded(self, phrase: Phrase, place: int) -> bool:
        """Whether it is since or from when something is: "read my messages from this morning"."""
        said, time = phrase.said, phrase.said.time
        if said.preposition == "since":
            return True
        if self._is_told_of(place, said.preposition):
            return True
        if said.preposition != "from" or not self.nodes[place].tag.startswith("NN"):
            return False
        days = said.wall.days
        present = isinstance(days, Relative) and days.days <= 0
        past = isinstance(days, Deictic) and days.which in {Which.LAST, Which.PAST, Which.THIS}
        return present or past or (isinstance(time, Offset) and time.direction < 0)

    def _is_told_of(self, place: int, preposition: str | None) -> bool:
        """Whether somebody does something with it then: "a recipe I can cook in twenty minutes"."""
        node = self.nodes[place]
        return node.is_verb and node.relation == "relcl" and preposition in {*OF_THINGS, "to"}

    def _is_sought(self, phrase: Phrase, place: int) -> bool:
        """Whether it is of what somebody looks for: "find a sitter for saturday night"."""
        node, days = self.nodes[place], phrase.said.wall.days
        if self._describes(place):
            return not isinstance(phrase.said.time, Offset)
        if not node.tag.startswith("NN") or days is None or phrase.said.constraint in BOUNDS:
            return False
        if phrase.said.preposition == "for":
            return True
        travels = self._sought_things(place) & self.lexicon.beside.travel_things
        seeks = not self.said.isdisjoint(self.lexicon.doing.seeking)
        return seeks and bool(travels) and phrase.said.preposition in OF_THINGS

    def _sought_things(self, place: int) -> set[str]:
        """Give the words of what is looked for, up to a place, in their dictionary form."""
        return {node.lemma for node in self.nodes[self.verb + 1 : place + 1] if node.tag.startswith("NN")}

    def _describes(self, place: int) -> bool:
        """Whether a word says what a thing does, or is: "a train leaving", "restaurants open"."""
        node, before = self.nodes[place], self.nodes[place - 1]
        doing = self.lexicon.doing
        moves = (
            node.tag == "VBG"
            and node.lemma in doing.arriving | doing.leaving | doing.beginning | doing.ending
        )
        so = moves or node.tag == "VBN" or node.lower in self.lexicon.beside.open_things
        return so and place - 1 > self.verb and before.tag.startswith("NN")

    # -- what something is for ---------------------------------------------------------------------------

    def of_purpose(self, phrases: Sequence[Phrase]) -> Iterator[Phrase]:
        """Give times of what an order with its own is for: "pack tonight for the trip on friday".

        Both are days, or both hours: "set the table at six for dinner at seven".
        """
        own: list[Phrase] = []
        for phrase in phrases:
            place, said = self._behind(phrase), phrase.said
            named = place is not None and self.nodes[place].tag.startswith("NN")
            of_thing = said.constraint not in BOUNDS and said.preposition in OF_THINGS
            alike = (one for one in own if _is_day(one, phrase) or _is_hour(one, phrase))
            first = next(alike, None) if named and of_thing else None
            if first is not None and place is not None and self._is_purpose(first, place):
                yield phrase
            else:
                own.append(phrase)

    def _is_purpose(self, own: Phrase, place: int) -> bool:
        """Whether a name that ends at a place is of what "for" or "about" begins, behind an own time."""
        led = place - len(self._name(place))
        inside = next(self.part.at(own.span), 0) < led
        return inside and self.nodes[led].lower in {"for", "about", "to"}


def _is_day(*phrases: Phrase) -> bool:
    """Whether all say on which day."""
    return all(phrase.said.wall.days is not None for phrase in phrases)


def _is_hour(*phrases: Phrase) -> bool:
    """Whether all say at which hour."""
    return all(phrase.said.wall.clock is not None for phrase in phrases)
