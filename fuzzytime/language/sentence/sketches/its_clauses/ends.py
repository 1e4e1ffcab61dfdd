"""Where a clause ends: at a mark, or before another time or clause."""

from collections.abc import Sequence

from fuzzytime.language.grammar.lexicon import longest_match
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.meaning.phrases import places_in
from fuzzytime.language.sentence.segments.leading_markers import goes_on_behind
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.requirement import Constraint

ENDS = frozenset({",", ":", "(", ")"})
"""Marks at which a clause ends: "until golden (about ten minutes)"."""

OR_ELAPSED = "elapsed.or_elapsed"
"""The rule of a length that is over, behind "or"."""

LONGEST_STATE = 2
"""Words of what something becomes at most: "until golden brown"."""

BEFORE = "before"

ASKED = 4
"""Words from "ask" on, before "if", at most: who is asked is one of them."""


class ClauseEnds:
    """The ends of clauses among the words of an instruction, of which some are covered by times."""

    def __init__(self, tree: Tree, words: Sequence[Word], phrases: Sequence[Phrase]) -> None:
        self.tree, self.words, self.phrases = tree, words, phrases
        self.lexicon, self.covered = tree.lexicon, places_in(phrases)

    def of(self, first: int) -> int:
        """Give where a clause ends that begins at a word: at a mark, or at "and" and a time."""
        return next((p for p in range(first, len(self.words)) if self._is_mark(first, p)), len(self.words))

    def _is_mark(self, first: int, place: int) -> bool:
        """Whether a clause from ``first`` on ends before a word.

        That is a mark, "and" or "or" before a time or another clause, or what begins a condition.
        """
        text = self.words[place].text
        if self._adds_condition(first, place) or self._is_asked(first, place) or self._lasts(first, place):
            return True
        if place > first and place not in self.covered and self._turns_away(place):
            return True
        if text in {",", ":"} and (self._is_inside(place) or self._goes_on(place)):
            return False
        if any(phrase.first == place and phrase.rule == OR_ELAPSED for phrase in self.phrases):
            # "Until it browns or ten minutes have passed"
            return True
        if place == first + 1 and text == BEFORE and place not in self.covered:
            # "After soundcheck before doors", as "between" and "and" are read
            return True
        if (
            text not in self.lexicon.closed.conjunctions
            or place + 1 >= len(self.words)
            or place - 1 in self.covered
        ):
            return text in ENDS
        # "Before you leave and again when you get back", "… and again every two hours"
        again = self.words[place + 1].text == "again" and place + 2 < len(self.words)
        behind = place + 1 + again
        clause = longest_match(self.words, behind, self.lexicon.clauses)
        bound = any(one.first == behind and (again or one.said.preposition) for one in self.phrases)
        return bound or bool(clause and self.lexicon.clauses[clause])

    def _lasts(self, first: int, place: int) -> bool:
        """Whether a length begins behind what something becomes: "until doubled | about an hour"."""
        said = [word.text for word in self.words[first:place]]
        state = 0 < len(said) <= LONGEST_STATE and said[0] not in self.lexicon.closed.condition_openers
        lengths = (phrase for phrase in self.phrases if phrase.first == place)
        return state and any(phrase.said.constraint is Constraint.FOR for phrase in lengths)

    def _adds_condition(self, first: int, place: int) -> bool:
        """Whether another condition begins: "after the nap | if it's dry"; but "when you see if it is"."""
        denied = self.words[place].text in self.lexicon.beside.excepting
        begin = place + denied
        if place <= first or place in self.covered or begin + 1 >= len(self.words):
            return False
        before = {word.text for word in self.words[max(first, place - ASKED) : place]}
        further = self.words[begin].text in self.lexicon.closed.further_conditions
        return further and self.lexicon.doing.learning.isdisjoint(before)

    def _turns_away(self, place: int) -> bool:
        """Whether a courtesy or a reason begins: "when it is hot | please stir", "… | because Ann comes"."""
        closed, text = self.lexicon.closed, self.words[place].text
        behind = {word.text for word in self.words[place + 1 : place + 2]}
        # "… | so that we can leave", "… | so we can leave"
        so = text == "so" and not behind.isdisjoint(closed.subordinators_of_purpose | closed.subject_pronouns)
        courtesy = longest_match(self.words, place, self.lexicon.courtesies)
        return courtesy is not None or so or text in closed.subordinators_of_reason

    def _is_asked(self, first: int, place: int) -> bool:
        """Whether what somebody is asked to do begins: "remind me when it is over | to take out the dog"."""
        word, nodes = self.words[place], self.tree.nodes
        found = self.tree.at(word.start, word.end) if word.text == "to" and place > first else ()
        verbs = (nodes[p].head for p in found if nodes[p].relation == "aux")
        led = (
            verb for verb in verbs if nodes[verb].relation == "xcomp" and nodes[verb].head == self.tree.root
        )
        return any(nodes[nodes[verb].head].start < self.words[first].start for verb in led)

    def _goes_on(self, place: int) -> bool:
        """Whether a clause in front goes on behind a comma: "when it is hot, and the oil shimmers, …"."""
        last = len(self.words) - 1
        return self.words[last].text == "," and goes_on_behind(self.words, place, last, self.lexicon)

    def _is_inside(self, place: int) -> bool:
        """Whether a mark joins digits, as in "below 1,200", or words of one time."""
        if place in self.covered:
            return True
        around = self.words[place - 1 : place + 2]
        return len(around) == 3 and all(word.glued for word in around[1:]) and around[2].is_digits
