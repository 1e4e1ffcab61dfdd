"""Times at which something is not to be done: "call ann, not on friday", "tomorrow except at noon"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Duration, Phrase, Repeat
from fuzzytime.language.meaning.joined.weekdays_left_out import weekdays_in
from fuzzytime.requirement import STRETCHES


def denied(words: Sequence[Word], phrases: Sequence[Phrase], lexicon: Lexicon) -> list[Phrase]:
    """Give times with what denies them: "not at noon" is a time beside noon."""
    texts = [word.text for word in words]
    found: list[Phrase] = []
    for phrase in phrases:
        between = set(texts[found[-1].end : phrase.first]) if found else set()
        again = bool(between) and found[-1].said.denied and between <= lexicon.closed.denied_alternatives
        # "Not at six or at eight"
        place = phrase.first if again else _denying(texts, phrase, lexicon)
        if place is None:
            found.append(phrase)
            continue
        said, span = replace(phrase.said, denied=True), (words[place].start, phrase.span[1])
        found.append(replace(phrase, said=said, first=place, span=span))
    return found


def _denying(texts: Sequence[str], phrase: Phrase, lexicon: Lexicon) -> int | None:
    """Give the place of the word that denies a time behind it; None without one."""
    place = phrase.first - 1
    if place < 0 or phrase.said.denied:
        return None
    if texts[place] in lexicon.beside.denying_times:
        # "The film is not at six" tells, "why not at six" asks.
        held = place > 0 and texts[place - 1] in lexicon.beside.before_no_denial
        return None if held else place
    if texts[place] in lexicon.beside.denying_weekdays:
        # "Every day, no sundays"
        repeated = not lexicon.beside.repeating.isdisjoint(texts[:place])
        return place if repeated and weekdays_in(phrase.said.time) and _is_plural(phrase) else None
    if texts[place] in lexicon.beside.leaving_out_of_all:
        all_said = not lexicon.beside.repeating.isdisjoint(texts[:place])
        return place if all_said and phrase.said.constraint not in STRETCHES else None
    left_out = texts[place] in lexicon.beside.leaving_out
    return None if not left_out or isinstance(phrase.said.time, Duration) else place


def _is_plural(phrase: Phrase) -> bool:
    """Whether weekdays are named by nothing else: "sundays"."""
    return isinstance(phrase.said.time, Repeat) and phrase.said.preposition is None
