"""Where steps begin behind joints, in a sentence that says how long some of them go on.

"Simmer 50 min, lid on", "leave it 10 min, scrub, rinse off", "add pasta and cook 9 minutes": a tree of all of
them takes what is short for a word of the step before it.
"""

from collections.abc import Iterator, Mapping, Sequence

from fuzzytime.english import is_participle
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Duration, Phrase
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.requirement import Constraint

LONGEST_THING = 3
"""Words at most of what is to be somewhere, or so: "the oven door shut"."""

ALONE = 2
"""Words of an order with what it is done with, at least."""


def steps_apart(
    words: Sequence[Word], phrases: Sequence[Phrase], lexicon: Lexicon
) -> Iterator[tuple[int, bool]]:
    """Give where steps begin, and whether one only says how a thing is meanwhile: "simmer it, lid on"."""
    times = {place: phrase for phrase in phrases for place in range(phrase.first, phrase.end)}
    if not any(map(_is_length, phrases)):
        return
    joints, back = lexicon.closed.joints_of_instances, False
    for place in range(1, len(words) - 1):
        text = words[place].text
        if place in times or not (text == "," or text in joints) or words[place - 1].text in ENDS:
            continue
        begin = place + 1
        if begin in times or words[begin].text in joints:
            continue
        comma = "," in {text, words[place - 1].text}
        lasted = times.get(place - 1 if text == "," or not comma else place - 2)
        # "Take it off the heat, cover, and rest for ten minutes": verbs alone share what they are done with.
        alone = any(words[at].text == "," for at in (place - 2, place - 3)) or place < ALONE
        goes_on = not alone and _goes_on(words, begin, times, lexicon, comma=comma)
        lasts = comma and lasted is not None and _is_length(lasted)
        state = _is_state(words, begin, times, lexicon) if comma else 0
        # "Back on ice for 2 min, add SOC": no order stands around where something is.
        if goes_on or state or (lasts and (back or _is_alone(words, begin, times, lexicon))):
            back = state == begin + 1
            waits = any(words[at].text in lexicon.doing.waiting for at in range(place))
            ends = state == len(words) or (state and words[state].text in ENDS)
            yield words[begin].start, bool(lasts and state and ends and not waits)


def _is_length(phrase: Phrase) -> bool:
    """Whether it is how long something goes on, or until when: "mow until three, return"."""
    if phrase.said.preposition == "until":
        return True
    return phrase.said.constraint is Constraint.FOR and isinstance(phrase.said.time, Duration)


def _goes_on(
    words: Sequence[Word], begin: int, times: Mapping[int, Phrase], lexicon: Lexicon, *, comma: bool
) -> bool:
    """Whether a verb with nothing but how long it goes on stands at a place: "… | cook 9 minutes"."""
    verbs = lexicon.timing | lexicon.timing_alone | lexicon.doing.resting
    # "Fix it 15 min in PFA, wash 3 x 5 min"
    verbs |= lexicon.orders if comma else frozenset()
    length = times.get(begin + 1)
    return words[begin].text in verbs and length is not None and _is_length(length)


def _is_alone(words: Sequence[Word], begin: int, times: Mapping[int, Phrase], lexicon: Lexicon) -> bool:
    """Whether a word stands at a place that asks for something by itself: "leave it 10 min, | scrub, …"."""
    text = words[begin].text
    known = text in lexicon.function_words or text in lexicon.numbers or not words[begin].is_letters
    # "Can it wait till six, sorry?"
    known = known or text in lexicon.addresses or (text,) in lexicon.courtesies or words[-1].text == "?"
    said = known or is_participle(text) or text.endswith(("ed", "ly"))
    # "Boil eggs for six minutes, beans for ten"
    return not said and begin + 1 not in times and _ends(words, begin + 1, times, lexicon)


def _is_state(words: Sequence[Word], begin: int, times: Mapping[int, Phrase], lexicon: Lexicon) -> int:
    """Give where it ends that a thing is to be somewhere, or so, from a place on; 0 where none is.

    "Simmer 50 min, | lid off for the last five"
    """
    states = lexicon.beside.states | lexicon.particles.keys() | lexicon.doing.opening_up
    again = lexicon.closed.adverbs_of_repetition & lexicon.particles.keys()
    if words[begin].text in again and words[begin + 1].text in states:
        # "Back in the oven for another ten, then turn it"
        return begin + 1
    begin += words[begin].text in lexicon.closed.the
    for place in range(begin, min(begin + LONGEST_THING, len(words) - 1)):
        text = words[place].text
        if place in times or not words[place].is_letters or text in lexicon.function_words:
            return 0
        if words[place + 1].text in states and place + 1 not in times:
            return place + 2 if _ends(words, place + 2, times, lexicon) else 0
    return 0


def _ends(words: Sequence[Word], place: int, times: Mapping[int, Phrase], lexicon: Lexicon) -> bool:
    """Whether what is said ends at a place, or goes on with when."""
    if place >= len(words) or place in times or words[place].text in ENDS | {","}:
        return True
    joined = words[place].text in lexicon.closed.joints_of_instances
    return joined or longest_match(words, place, lexicon.clauses) is not None
