"""Where steps begin behind joints, in a sentence that says how long some of them go on.

"Simmer 50 min, lid on", "leave it 10 min, scrub, rinse off", "add pasta and cook 9 minutes": a tree of all of
them takes what is short for a word of the step before it.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from fuzzytime.english import is_participle
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Duration, Phrase
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.requirement import Constraint

LONGEST_THING = 3
"""Words at most of what is to be somewhere, or so: "the oven door shut"."""


def steps_apart(
    words: Sequence[Word], phrases: Sequence[Phrase], lexicon: Lexicon
) -> Iterator[tuple[int, bool]]:
    """Give where steps begin, and whether one only says how a thing is meanwhile: "simmer it, lid on"."""
    times = {place: _lasts(phrase) for phrase in phrases for place in range(phrase.first, phrase.end)}
    said = _Said(words, [word.text for word in words], times, lexicon)
    if not any(times.values()):
        return
    back = False
    for place in range(1, len(words) - 1):
        joint, begin = words[place].text, place + 1
        comma = "," in {joint, words[place - 1].text}
        joins = joint == "," or joint in said.joints
        if not joins or {place, begin} & times.keys() or said.texts[begin] in said.joints:
            continue
        # "Take it off the heat, cover, and rest for ten minutes": verbs alone share what they are done with.
        shared = place == 1 or "," in said.texts[max(0, place - 3) : place - 1]
        lasted = comma and times.get(place - 1 if joint == "," else place - 2, False)
        state = said.state(begin) if comma else 0
        # "Back on ice for 2 min, add SOC": no order stands around where something is.
        alone = lasted and (back or said.is_alone(begin))
        if state or alone or (not shared and said.goes_on(begin, comma=comma)):
            back = state == begin + 1
            ends = state == len(words) or (state and said.texts[state] in ENDS)
            waits = not lexicon.doing.waiting.isdisjoint(said.texts[:place])
            yield words[begin].start, bool(lasted and ends and not waits)


def _lasts(phrase: Phrase) -> bool:
    """Whether it is how long something goes on, or until when: "mow until three, return"."""
    length = phrase.said.constraint is Constraint.FOR and isinstance(phrase.said.time, Duration)
    return length or phrase.said.preposition == "until"


@dataclass(frozen=True, slots=True)
class _Said:
    """The words of a text, and at which of their places a time stands, one that says how long or not."""

    words: Sequence[Word]
    texts: list[str]
    times: dict[int, bool]
    lexicon: Lexicon

    @property
    def joints(self) -> frozenset[str]:
        """The words that stand between steps."""
        return self.lexicon.closed.joints_of_instances

    def goes_on(self, begin: int, *, comma: bool) -> bool:
        """Whether a verb with nothing but how long it goes on stands at a place: "… | cook 9 minutes"."""
        lexicon, verb = self.lexicon, self.texts[begin]
        known = verb in lexicon.timing | lexicon.timing_alone | lexicon.doing.resting
        # "Fix it 15 min in PFA, wash 3 x 5 min"
        return self.times.get(begin + 1, False) and (known or (comma and verb in lexicon.orders))

    def is_alone(self, begin: int) -> bool:
        """Whether a word at a place asks for something by itself: "leave it 10 min, | scrub, …"."""
        lexicon, text = self.lexicon, self.texts[begin]
        # "Can it wait till six, sorry?"
        known = (lexicon.function_words, lexicon.numbers, lexicon.addresses)
        no_step = any(text in words for words in known) or (text,) in lexicon.courtesies
        no_step = no_step or self.texts[-1] == "?"
        says_how = is_participle(text) or text.endswith(("ed", "ly")) or not text.isalpha()
        # "Boil eggs for six minutes, beans for ten"
        return not (no_step or says_how or begin + 1 in self.times) and self._ends(begin + 1)

    def state(self, begin: int) -> int:
        """Give where it ends that a thing is to be somewhere, or so, from a place on; 0 where none is.

        "Simmer 50 min, | lid off for the last five", "… | back in the oven for another ten"
        """
        lexicon = self.lexicon
        states = lexicon.beside.states | lexicon.particles.keys() | lexicon.doing.opening_up
        if self.texts[begin] in lexicon.closed.adverbs_of_repetition & states:
            return begin + 1 if self.texts[begin + 1] in states else 0
        begin += self.texts[begin] in lexicon.closed.the
        for place in range(begin, min(begin + LONGEST_THING, len(self.texts) - 1)):
            text = self.texts[place]
            if place in self.times or not text.isalpha() or text in lexicon.function_words:
                return 0
            if self.texts[place + 1] in states and place + 1 not in self.times:
                return place + 2 if self._ends(place + 2) else 0
        return 0

    def _ends(self, place: int) -> bool:
        """Whether what is said ends at a place, or goes on with when."""
        if place >= len(self.texts) or place in self.times or self.texts[place] in ENDS | {","} | self.joints:
            return True
        return longest_match(self.words, place, self.lexicon.clauses) is not None
