"""Whether a clause compares a thing to a number, which is no time: "when the queue is over 4"."""

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.lexicon import longest_match
from fuzzytime.language.grammar.surroundings.looked_up import LookedUp
from fuzzytime.language.grammar.timetables import has_time

NEARLY = frozenset({"around", "about"})

NEAR = 8
"""Words before a number that decide whether it is an amount."""

SIGNS = frozenset({">", "<"})
"""Marks that compare numbers, and bind a time behind them."""

STATED = frozenset({"when", "if"})
"""Kinds of clauses that say what must be so."""


class Compared(LookedUp):
    """The words of a text, and what clauses in it compare to numbers."""

    def says_how_much(self, piece: Piece) -> bool:
        """Whether a clause says that a thing is a number: "when the queue is over 4", "if load > 4"."""
        place = piece.start - (self.texts[piece.start] not in SIGNS)
        begun = (
            (start, longest_match(self.words, start, self.lexicon.clauses))
            for start in range(max(0, piece.start - NEAR), place - 1)
        )
        begin, marker = max(((start + len(form), form) for start, form in begun if form), default=(0, ()))
        verb, subject = self.texts[place], self.texts[place - 1] if place > 0 else ""
        if not begin or not subject[-1:].isalnum() or subject in self.beside.clock_subjects:
            # "When it is past six"; but "when it climbs past 12"
            return bool(begin) and verb in self.beside.of_readings and self._compares(piece, verb)
        said = self.words[begin:place]
        stem, _, clipped = verb.rpartition("'")
        if stem and f"'{clipped}" in self.closed.present_be and not has_time(stem, self.lexicon):
            # "Once the oven's at 220"
            verb = f"'{clipped}"
        if len(said) == 1 and marker[-1] in self.lexicon.ordinals:
            # "The second bell is at two"
            return False
        # "If the meeting goes past 6", "if Bob works past six"
        untimed = not any(word.capital or has_time(word.text, self.lexicon) for word in said)
        if verb in SIGNS or verb in self.closed.stative_verbs | self.closed.present_be:
            # "Two hours before the fight, which is at eight"
            stated = self.lexicon.clauses.get(marker) in STATED and "," not in self.texts[begin:place]
            return (untimed and stated) or self.texts[piece.start] != "at"
        return untimed and self._compares(piece, verb)

    def _compares(self, piece: Piece, verb: str) -> bool:
        """Whether words behind a verb compare something to a number: "goes past 12", "hovers around 6".

        What is open past 12, or on, is so by the clock.
        """
        form = longest_match(self.words, piece.start, self.lexicon.comparisons)
        if form is None or form in {("at",), ("between",)}:
            return self.texts[piece.start] in {*NEARLY, "between"} and verb in self.beside.kept_at
        state = self.lexicon.standing | self.lexicon.particles.keys() | self.lexicon.doing.hours
        return verb.isalpha() and (verb == "up" or verb not in state)
