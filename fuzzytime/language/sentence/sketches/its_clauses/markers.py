"""What begins a clause besides the markers of the lexicon, and which of those begin none."""

from collections.abc import Sequence

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.sentence.clauses.before_markers import OF, BeforeMarker
from fuzzytime.language.sentence.clauses.conditions import is_wish
from fuzzytime.language.sentence.segments.events.event_edges import BY, OF_EDGES, edge_of, is_event
from fuzzytime.language.sentence.sketches.its_clauses.ends import ASKED, ClauseEnds
from fuzzytime.language.sentence.trees.reasons import AS, begins_reason
from fuzzytime.language.sentence.trees.tags import SUBJECTS
from fuzzytime.requirement import Edge

WITH_DASH = (("after",), ("before",))
"""Markers that are the first of a word where a dash is glued to them."""


class ClauseMarkers:
    """The words of an instruction that begin clauses."""

    def __init__(self, before: BeforeMarker, ends: ClauseEnds) -> None:
        self.tree, self.words, self.lexicon = ends.tree, ends.words, ends.lexicon
        self.before, self.ends, self.covered = before, ends, ends.covered

    def begins_none(self, place: int, form: tuple[str, ...]) -> bool:
        """Whether a marker of the lexicon begins no clause at a place."""
        return (
            _leads_nowhere(form, self.words, place)
            or _is_part_of_word(form, self.words, place, self.lexicon)
            or is_wish(self.tree, self.words[place:])
            or self._inquires(place, form)
            or self._marks(place, form)
            or self._says_why(place, form)
            or self._is_of_verb(place)
            or self._counts(place, form)
        )

    def _counts(self, place: int, form: tuple[str, ...]) -> bool:
        """Whether it says how often, of a time that is all behind it: "once at noon and twice at night"."""
        end = place + len(form)
        if not self.lexicon.beside.one_time.issuperset(form) or end not in self.covered:
            return False
        end = next((p for p in range(end, len(self.words)) if p not in self.covered), len(self.words))
        behind = {word.text for word in self.words[end : end + 1]}
        return behind <= self.lexicon.closed.additions | self.lexicon.beside.polite_ends

    def _is_of_verb(self, place: int) -> bool:
        """Whether it belongs to the verb right before it: "look after the baby"."""
        if not place or self.words[place].text != "after":
            return False
        before = self.words[place - 1]
        lemmas = {self.tree.nodes[p].lemma for p in self.tree.at(before.start, before.end)}
        return not self.lexicon.doing.taking_care.isdisjoint(lemmas)

    def other(self, place: int) -> tuple[str, ...] | None:
        """Give what begins a clause at a place though the lexicon has no such marker."""
        return self._awaited(place) or self._bounded(place) or self._inverted(place) or self._edged(place)

    def edge(self, place: int) -> tuple[Edge, int] | None:
        """Give the end of an event that is named at a place, and where the event's name begins."""
        return edge_of(self.words, place, self.covered, self.lexicon)

    def _awaited(self, place: int) -> tuple[str, ...] | None:
        """Give the "for" of "wait for the kettle to boil" as what begins a clause."""
        before = self.words[place - 1].text if place else ""
        if (
            self.words[place].text != "for"
            or before not in self.lexicon.doing.waiting
            or place in self.covered
        ):
            return None
        tree = self.tree
        marks = (p for p in tree.at(self.words[place].start, self.words[place].end))
        return ("for",) if any(tree.nodes[p].relation == "mark" for p in marks) else None

    def _inquires(self, place: int, form: tuple[str, ...]) -> bool:
        """Whether "if" begins what is asked or found out: "ask Tom if he's free", "see if it's dry"."""
        if form not in {("if",), ("when",)}:
            return False
        before = [word.text for p, word in enumerate(self.words[:place]) if p not in self.covered]
        found = " ".join(before[-2:]) in self.lexicon.doing.finding_out
        if form == ("when",):
            # "Find out when the shops close"
            return found
        found = found or bool(self.lexicon.doing.inquiring & {*before[-1:]})
        return found or not self.lexicon.doing.asking.isdisjoint(before[-ASKED:])

    def _marks(self, place: int, form: tuple[str, ...]) -> bool:
        """Whether "as" says what something is called or counted from then on: "mark the rent as paid".

        Or that it is as it was to be: "start at six as planned".
        """
        behind = place + len(form)
        while behind < len(self.words) and self.words[behind].text in self.lexicon.closed.before_states:
            behind += 1
        known = any(word.text in self.lexicon.doing.marking for word in self.words[:place])
        if form != ("as",) or behind >= len(self.words):
            return False
        if not known and self.words[behind].text not in self.lexicon.closed.foreseen:
            return False
        joints = self.lexicon.closed.end_of_an_event | self.lexicon.closed.end_of_an_order
        # "Log the heat as it rises" goes on as that does.
        over = behind + 1 == len(self.words) or behind + 1 in self.covered
        return over or self.words[behind + 1].text in joints

    def _says_why(self, place: int, form: tuple[str, ...]) -> bool:
        """Whether "as" begins a reason: "book by noon, as places are limited"."""
        word = self.words[place]
        said = self.tree.at(word.start, word.end) if form == (AS,) else ()
        return any(begins_reason(self.tree, node) for node in said)

    def _bounded(self, place: int) -> tuple[str, ...] | None:
        """Give the "of" of "within an hour of calling", "for the last hour of roasting" as what begins it."""
        counts = self.before.bound(place) is not None or self.before.closes(place)
        return (OF,) if self.words[place].text == OF and counts else None

    def _inverted(self, place: int) -> tuple[str, ...] | None:
        """Give the "should" of "should the bell ring, …", which its tree has as "if", as what begins it."""
        word = self.words[place]
        leads = any(self.tree.nodes[p].lower == "if" != word.text for p in self.tree.at(word.start, word.end))
        return (word.text,) if leads and word.text in self.lexicon.closed.conditional_inversion else None

    def _edged(self, place: int) -> tuple[str, ...] | None:
        """Give the "by" of "by the end of the lesson" as what begins a clause."""
        text = self.words[place].text
        known = text in OF_EDGES and place not in self.covered
        if (
            known
            and text == "by"
            and not self._is_by_whom(place)
            and is_event(self.words, place + 1, self.ends.of(place + 1), self.covered, self.lexicon)
        ):
            # "By kick-off", "by knocking-off time"
            return BY
        return (text,) if known and self.edge(place + 1) is not None else None

    def _is_by_whom(self, place: int) -> bool:
        """Whether it is who does it: "the pills prescribed by the dentist"; not "be up by the dentist"."""
        tree, word = self.tree, self.words[place]
        by = (p for p in tree.at(word.start, word.end) if tree.nodes[p].relation == "agent")
        done = [tree.nodes[p].head for p in by]
        whose = any(verb != tree.root or tree.children(verb, *SUBJECTS) for verb in done)
        behind = self.words[place + 1 : self.ends.of(place + 1)]
        return whose and not self.lexicon.persons.isdisjoint(one.text for one in behind)


def _leads_nowhere(form: tuple[str, ...], words: Sequence[Word], place: int) -> bool:
    """Whether a marker stands alone: "mow the front before and the back after"."""
    behind = place + len(form)
    return behind < len(words) and words[behind].text in {"and", "or"}


def _is_part_of_word(form: tuple[str, ...], words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a marker with a hyphen begins a word that is no event: "pre-heat", "a post-party mess".

    So does "after" where one is glued to it: "the after-school club".
    """
    if form[-1] != "-":
        dash = [word for word in words[place + len(form) : place + len(form) + 2] if word.glued]
        return form in WITH_DASH and [word.text for word in dash[:1]] == ["-"] and len(dash) > 1
    event, behind = (words[p] if p < len(words) else None for p in (place + len(form), place + len(form) + 1))
    named = event is not None and event.glued and event.text in lexicon.happening | lexicon.taken
    over = behind is None or behind.text in lexicon.function_words or not behind.is_letters
    return not (named and over and words[place + 1].glued)
