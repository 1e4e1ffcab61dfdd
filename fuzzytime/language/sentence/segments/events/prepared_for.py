"""What is prepared for an event in front, and so is done before it: "for dinner at seven, start the lamb"."""

from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.requirement import MOMENTS

LONGEST_NAME = 4
"""Words of what it is for, at most: "the school summer fair"."""

BEFORE = "b4 "
"""What is said instead of "for", as long as it is."""

STARTS = frozenset({".", "!", "?", ";", "\n", "so"})
"""What stands before a sentence, or before what is done for a reason."""

PAUSES = frozenset({",", ";"})
"""What may stand behind an event in front, which a line of entries has for the end of one."""


def with_prepared_for(scanned: Scanned) -> str:
    """Give a text of the same length in which that is done before an event which is done for it."""
    words, text = scanned.words, scanned.text
    for place, word in enumerate(words):
        led = words[place - 1].text if place else "."
        end = _end_of_event(scanned, place + 1) if word.text == "for" and led in STARTS else 0
        if not end:
            continue
        text = text[: word.start] + BEFORE + text[word.end :]
        if words[end].text in PAUSES:
            text = text[: words[end].start] + "," + text[words[end].end :]
    return text


def _end_of_event(scanned: Scanned, place: int) -> int:
    """Give where an event with its clock time ends that is named at a place; 0 without an order behind it."""
    words, lexicon = scanned.words, scanned.lexicon
    owned = place < len(words) and words[place].text in lexicon.closed.noun_openers - {"the"}
    clocks = (piece for piece in scanned.pieces("wall") if owned and piece.start == place + 1)
    # "For a two o'clock lunch, put it in at nine"
    called = max((piece.end for piece in clocks if piece.value.clock and not piece.value.bare), default=0)
    ends = (_end(phrase, scanned, place) for phrase in phrases_of(scanned) if phrase.first > place)
    end = called + 1 if called else next(ends, 0)
    behind = [word.text for word in words[end : end + 2]]
    if not end or len(behind) == 1 or not behind or not words[end - 1].is_letters:
        return 0
    opens = behind[1] in lexicon.closed.noun_openers | lexicon.closed.object_pronouns
    asks = behind[0] in lexicon.orders | PAUSES
    return end if asks or opens else 0


def _end(phrase: Phrase, scanned: Scanned, place: int) -> int:
    """Give where the time of an event ends whose name begins at a place; 0 where none is named."""
    name, lexicon = scanned.words[place : phrase.first], scanned.lexicon
    refused = (
        lexicon.function_words | lexicon.numbers.keys() | lexicon.persons
    ) - lexicon.closed.noun_openers
    named = 0 < len(name) <= LONGEST_NAME and all(w.is_letters and w.text not in refused for w in name)
    at = phrase.said.wall.clock is not None and phrase.said.constraint in MOMENTS
    return phrase.end if named and at else 0
