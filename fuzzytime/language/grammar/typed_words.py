"""The words of a text as they are meant: without fillers, with marks that are left out, spelt as usual."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word, joins, words_of

LONGEST_ELLIPSIS = 4
"""Two points and the numbers on either side."""


MARKS = {" ": "@", ".": ":"}
"""What people type in front of an hour and between it and its minutes, by what may stand there instead."""

TOGETHER = 4
"""Digits of an hour with its minutes."""

HOURS = "h"
"""What people type behind such an hour."""


def with_marks(words: Sequence[Word], hours: frozenset[int]) -> list[Word]:
    """Put "@", which takes no room, before each word behind a space of hours; a point becomes a colon.

    Behind four digits, which may be a year, stands an "h", too.
    """
    found: list[Word] = []
    for word in words:
        if word.start - 1 in hours and not word.glued:
            found += (Word(MARKS[" "], word.start, word.start, glued=False), replace(word, glued=True))
            if len(word.text) == TOGETHER:
                found.append(Word(HOURS, word.end - 1, word.end, glued=True))
            continue
        found.append(replace(word, text=MARKS["."]) if word.start in hours else word)
    return found


def _spelt(word: Word, lexicon: Lexicon) -> Word:
    """Give a word as it is meant: "quater" is a quarter, but "the Weeknd" a name."""
    meant = lexicon.misspelt.get(word.text)
    named = word.capital and word.text in lexicon.no_times.capital_names
    return word if meant is None or named else replace(word, text=meant)


def spelt(text: str, lexicon: Lexicon) -> str:
    """Give a text in which slips that take as much room are written as they are meant: "mow teh lawn".

    So trees of it have what was typed at the same characters.
    """
    for word in words_of(text):
        meant = _spelt(word, lexicon).text
        if meant != word.text and len(meant) == word.end - word.start and meant.isalpha():
            text = f"{text[: word.start]}{meant.capitalize() if word.capital else meant}{text[word.end :]}"
    return text


def as_meant(typed: Sequence[Word], lexicon: Lexicon) -> tuple[Word, ...]:
    """Give words without fillers and marks that say nothing, and cut "-ish" and "'s" off those about time."""
    words = [_spelt(word, lexicon) for word in typed]
    found: list[Word] = []
    for place, word in enumerate(words):
        if word.text in lexicon.fillers or _is_clipped(words, place + 1, lexicon):
            continue
        if word.text == "." and _is_inside(words, place) and lexicon.means(words[place - 1].text, "month"):
            # "September.16th"
            continue
        if _is_dash(words, place):
            found.append(replace(word, text="-"))
        elif _is_upon(words, place, lexicon):
            found.append(replace(word, text="upon"))
        elif _is_shorthand(words, place, lexicon):
            # "B4 noon"
            meant = lexicon.misspelt[words[place - 1].text + word.text]
            found[-1] = replace(found[-1], text=meant, end=word.end)
        elif _is_clipped(words, place, lexicon):
            found.append(replace(word, start=words[place - 1].start, glued=words[place - 1].glued))
        else:
            found += _cut(words, place, lexicon)
    return tuple(found)


def _is_upon(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether "on" says after what something is done: "on arrival", "on your return"; but "put it on"."""
    behind = [word.text for word in words[place + 1 : place + 3]]
    owned = behind[:1] != [] and behind[0] in lexicon.closed.possessives
    return words[place].text == "on" and not lexicon.beside.done_upon.isdisjoint(behind[owned:][:1])


def _is_dash(words: Sequence[Word], place: int) -> bool:
    """Whether a mark is a dash: "3~5 pm", "2026-03-14..2026-03-16"; but "(~7 pm)" is about seven."""
    mark, between = words[place].text, words[place - 1].text.isalnum()
    return (mark == "~" and between and _is_inside(words, place)) or (
        mark == "." and _is_ellipsis(words, place)
    )


def _cut(words: Sequence[Word], place: int, lexicon: Lexicon) -> list[Word]:
    """Cut a word off its ending: "sevenish", "in an hour's time"; a hyphen inside a number is none."""
    word = words[place]
    base, owner = word.text.removesuffix("ish"), word.text.removesuffix("'s")
    if owner != word.text and _is_owner(owner, lexicon) and not _continues(words, place, lexicon):
        middle = word.end - 2
        return [replace(word, text=owner, end=middle), Word("'s", middle, word.end, glued=True)]
    # "On the 25thish"
    ordinal = place > 0 and words[place - 1].is_digits and base in lexicon.beside.ordinal_endings
    known = ordinal or base in lexicon.numbers or base in lexicon.entries
    # "Dish" is no day.
    if base != word.text and len(base) > 1 and known and word.text not in lexicon.entries:
        middle = word.end - 3
        return [replace(word, text=base, end=middle), Word("ish", middle, word.end, glued=True)]
    inside = (
        joins(words, place) and _numeral(words[place - 1], lexicon) and _numeral(words[place + 1], lexicon)
    )
    return [] if inside else [word]


def _is_inside(words: Sequence[Word], place: int) -> bool:
    """Whether no space stands on either side of a word, and a number behind it."""
    behind = words[place + 1 : place + 2]
    return place > 0 and words[place].glued and bool(behind) and behind[0].glued and behind[0].is_digits


def _is_ellipsis(words: Sequence[Word], place: int) -> bool:
    """Whether it is one of two points between typed times, and no space between; but "pages 1..10"."""
    first = place - (words[place - 1].text == ".") if place else place
    around = words[first - 1 : first + 3] if first > 0 else ()
    points = [word.text for word in around[1:3]] == [".", "."]
    typed = points and len(around) == LONGEST_ELLIPSIS and around[0].is_digits and around[0].glued
    return typed and _is_inside(words, first + 1)


def _is_shorthand(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a number ends or begins what is typed for a word: "b4", "2day"; but "seat B4", "2day trip"."""
    if not place or not words[place].glued or not (words[place].is_digits or words[place - 1].is_digits):
        return False
    first, behind = words[place - 1], words[place + 1 : place + 2]
    ends = not behind or not behind[0].glued
    short = "".join(word.text for word in words[place + 1 : place + 3]) in lexicon.misspelt
    known = short or not behind or behind[0].text in lexicon.function_words
    if first.is_digits and not known and behind[0].is_letters:
        return False
    return ends and not (first.glued or first.capital) and first.text + words[place].text in lexicon.misspelt


def _is_clipped(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether an apostrophe stands for what is left out in front of a word: "'til"."""
    if not 0 < place < len(words) or not words[place].glued:
        return False
    mark, text = words[place - 1].text, words[place].text
    return mark == "'" and any(entry.words == (mark, text) for entry in lexicon.entries.get("'", ()))


def _is_owner(text: str, lexicon: Lexicon) -> bool:
    """Whether a word can be what has a time: an hour, or a half."""
    return any(entry.category in {"unit", "fraction"} for entry in lexicon.entries.get(text, ()))


def _continues(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a word is the second of a form: "new year's eve"."""
    before = lexicon.entries.get(words[place - 1].text, ()) if place else ()
    return any(entry.words[1:2] == (words[place].text,) for entry in before)


def _numeral(word: Word, lexicon: Lexicon) -> bool:
    return word.text in lexicon.numbers or word.text in lexicon.ordinals or word.text in lexicon.magnitudes
