"""A day, or a repetition, in front of a list: "tomorrow: bank 10, dentist 3", "weekdays - gym 7, run 8"."""

import re
from collections.abc import Sequence
from itertools import takewhile

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.grammar.words import Word, words_of
from fuzzytime.language.instruction import blanked
from fuzzytime.language.meaning.expressions import Phrase, TimeWord, Wall
from fuzzytime.language.sentence.segments.lists.entries import Entry

HEAD = re.compile(r"\s*([^\d\W][^:,;]*?)\s*(?::(?=\s)|\s[-–—](?=\s))")
"""What may be a head, up to its mark."""

LIST = ": …"
"""What stands for a list behind a head."""

LONGEST = 6
"""Words of a head at most."""

FEW = 3
"""Words at most of an entry that says only what there is to do."""

LEAST = 2
"""Entries of a list at least."""

FULL_STOPS = frozenset({".", "!", "?"})
"""Marks that end a sentence, but not behind a time alone."""


def head_of(line: str, grammar: Grammar, lexicon: Lexicon) -> tuple[Phrase, int] | None:
    """Give the day or repetition that heads a line, and where the list behind its mark begins."""
    found = HEAD.match(line)
    if found is None or len(words_of(found[1])) > LONGEST:
        return None
    scanned = Scanned.of(found[1] + LIST, grammar, lexicon)
    phrases = [one for one in phrases_of(scanned) if is_head(one)]
    whole = [one for one in phrases if not one.first and one.span[1] == len(found[1])]
    return (whole[0], found.end()) if whole else None


def with_time_in_front(scanned: Scanned) -> str:
    """Give a text of the same length in which no full stop parts a time in front from what is then.

    So it is in lists: "10:30 am. Registration", "Monday. Call Ann". Nor does "1 pm is" from "lunch time".
    """
    (first, *_) = phrases_of(scanned) or (None,)
    leads = first is not None and not first.first and not isinstance(first.said.time, TimeWord)
    behind = scanned.words[first.end :] if first is not None and leads else ()
    if len(behind) < LEAST or behind[0].glued is behind[1].glued:
        is_then = len(behind) > LEAST and behind[0].text in scanned.lexicon.closed.present_be
        told = list(takewhile(lambda word: word.is_letters, behind)) if is_then else []
        return blanked(scanned.text, [(told[0].start, told[0].end)] if _is_time(told) else [])
    part = None if first is None else first.said.wall.part
    if behind[0].text not in FULL_STOPS or (part is not None and part.event):
        # Another sentence begins behind "7:30 bedtime!".
        return scanned.text
    return scanned.text[: behind[0].start] + "," + scanned.text[behind[0].end :]


def _is_time(told: Sequence[Word]) -> bool:
    """Whether words end in what it is time for: "is snack time"."""
    return bool(told) and told[-1].text == "time"


def is_head(phrase: Phrase) -> bool:
    """Whether a time is a day, or a part of one, and no hour."""
    time = phrase.said.time
    # "Lunch: soup, bread" is what there is for it.
    bound = phrase.said.preposition is not None or not is_meal(time)
    return isinstance(time, Wall) and time.clock is None and bound


def is_meal(time: object) -> bool:
    """Whether it is a meal of any day."""
    return isinstance(time, Wall) and time.days is None and time.part is not None and time.part.meal


def headed(items: Sequence[str], grammar: Grammar, lexicon: Lexicon) -> bool:
    """Whether commas stand between the entries of a list with a head, in the first of the texts around them.

    Some of them have a time; or all say in a few words what there is to do, the first in one, as what is
    bought may be several things: "today: bins, post, milk", but "today: buy milk, bread".
    """
    head = head_of(items[0], grammar, lexicon)
    if head is None:
        return False
    entries = [items[0][head[1] :], *items[1:]]
    read = [Entry.of(entry, grammar, lexicon) for entry in entries]
    if len(read) < LEAST or not all(entry.things for entry in read):
        return False
    timed = [entry.opens and (entry.clocked or entry.timed(listed=True)) for entry in read]
    if timed[0] and any(timed[1:]):
        return True
    said = [words_of(entry) for entry in entries]
    plain = all(
        0 < len(words) <= FEW
        and all(word.is_letters and word.text not in lexicon.function_words for word in words)
        for words in said
    )
    return plain and len(said[0]) == 1 and not any(timed)
