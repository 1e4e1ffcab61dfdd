"""Where orders begin behind what happens, and lines of timetables: "lunch at noon, cook it beforehand"."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Phrase, Wall


def listed(phrases: Sequence[Phrase], words: Sequence[Word], lexicon: Lexicon) -> Iterator[int]:
    """Give where the lines of a timetable begin: "10:00 stretch 10:15 walk"; not "10:00, 10:15"."""
    clocks = [phrase for phrase in phrases if _is_clock(phrase)]
    if not clocks or clocks[0].first > 0:
        return
    for before, clock in pairwise(clocks):
        between = [other for other in phrases if before.end <= other.first < clock.first]
        told = (word for word in words[before.end : clock.first] if word.is_letters)
        if not between and any(word.text not in lexicon.function_words for word in told):
            yield clock.first


def behind_happening(phrases: Sequence[Phrase], words: Sequence[Word], lexicon: Lexicon) -> Iterator[int]:
    """Give where an order begins behind what happens: "lunch at noon, cook it beforehand"."""
    first = next(iter(phrases), None)
    if first is None or not first.first or longest_match(words, 0, lexicon.clauses) is not None:
        # "After the wedding on the 21st, call mum"
        return
    # "My dentist appointment at ten, …" names what happens, "call at ten, …" asks for it.
    named = (
        all(word.text in lexicon.closed.noun_openers | lexicon.taken for word in words[: first.first])
        and first.first > 1
    )
    # "Vet 10, dentist 3"
    listed = first.first == 1 and words[0].text in lexicon.taken and len(phrases) > 1
    if not (named or listed) and words[first.first - 1].text not in lexicon.happening:
        return
    behind = first.end + 1
    if behind < len(words) and words[first.end].text in {",", "-", ":"}:
        taken = lexicon.function_words | lexicon.places | lexicon.closed.alternatives
        if words[behind].is_letters and words[behind].text not in taken and phrases[-1].first != behind:
            yield behind


def _is_clock(phrase: Phrase) -> bool:
    """Whether it is a clock time alone, without a preposition."""
    time = phrase.said.time
    return phrase.said.preposition is None and isinstance(time, Wall) and time.clock is not None
