"""Names that hold a word about time: of persons, bands, films, brands; of files and tags ("today.md")."""

from itertools import takewhile

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.surroundings.surroundings import Surroundings

NEXT_TO = ("next", "to")
"""Words before somebody who is beside another."""

NUMBER_DIGITS = 3
"""Digits, at least, of a number that a thing is called by and that looks like an hour with minutes."""

TAG, JOINT, DOT = "#", "_", "."
"""The mark before a tag, and those between words of a name that is typed in one."""


def has_surname(piece: Piece, around: Surroundings) -> bool:
    """Whether it is a weekday with a name behind it, right behind a verb: "tell Wednesday Addams".

    Persons whose word is no name may be asked on that day: "call Wednesday Mum".
    """
    place = piece.start + (around.texts[piece.start] in around.lexicon.no_times.notable)
    if place + 1 != piece.end or not around.is_weekday(place) or not around.words[place].capital:
        return False
    name = around.words[piece.end : piece.end + 1]
    if not name or not name[0].capital or around.timely(piece.end):
        return False
    if name[0].text in around.lexicon.persons | around.lexicon.function_words:
        return False
    small = any(word.is_letters and not word.capital for word in around.words)
    before = around.texts[place - 1] if place else ""
    acted = place > 0 and around.opens(place - 1) and before.isalpha()
    acted = acted and before not in around.lexicon.function_words and not around.words[place - 1].capital
    return small and (acted or before in around.lexicon.no_times.notable)


def is_called_like_day(piece: Piece, around: Surroundings) -> bool:
    """Whether it is a weekday as somebody's name, right behind a verb: "text Friday the butler".

    Who that is says the person or the animal behind it, and behind a verb of giving whose is what is given:
    "give Tuesday her dinner". Other words are small: not "Text Friday The Butler".
    """
    place, texts = piece.start, around.texts
    if place + 1 != piece.end or not around.is_weekday(place) or not around.words[place].capital:
        return False
    verb = place - 1
    if verb < 0 or not around.opens(verb) or (around.words[verb].capital and verb):
        return False
    opener, noun = ("", "", *texts[piece.end : piece.end + 2])[-2:]
    somebody = noun in around.lexicon.persons | around.lexicon.animals
    ends = not "".join(texts[piece.end + 2 : piece.end + 3]).isalnum()
    told = opener in around.closed.the and somebody and ends and len(texts) > piece.end + 1
    given = texts[verb] in around.lexicon.no_times.handing and opener in {"his", "her", "its"}
    return told or given


def is_event_of_weekday(piece: Piece, around: Surroundings) -> bool:
    """Whether it is a weekday by which something is called that one is at: "shop at Sunday market"."""
    texts = around.texts
    follower = around.follower(piece)
    named = follower.isalpha() and follower not in around.lexicon.function_words
    place = piece.end - 1
    at = place > 0 and texts[place - 1] == "at" and piece.start in {place - 1, place}
    return at and named and around.is_weekday(place) and not around.timely(piece.end)


def is_whom(place: int, around: Surroundings) -> bool:
    """Whether a preposition at a place, and a name behind it, say who gets or hears something.

    "Give the keys to April", "dine with Dawn", "look after June", "handover to days"; but "push it back to
    April".
    """
    texts, kinds = around.texts, around.lexicon.no_times
    if place < 0 or place + 1 >= len(texts):
        return False
    joint, before = texts[place], texts[place - 1] if place else ""
    if texts[place + 1] in kinds.working:
        return joint in {"to", "from"} and not kinds.handing.isdisjoint(texts[:place])
    if not _is_given_name(place + 1, around):
        return False
    if (
        joint in kinds.together
        or (before, joint) == NEXT_TO
        or (joint in {"after", "for"} and before in kinds.looking)
    ):
        return True
    moved = not around.lexicon.rescheduling.isdisjoint(texts[:place])
    given = not kinds.handing.isdisjoint(texts[:place]) and not moved
    given = given and before not in around.beside.put_off and not around.is_day(place - 1)
    return joint == "to" and given


def _is_given_name(place: int, around: Surroundings) -> bool:
    """Whether a word is a month, a season or a part of the day that persons are called by: "April"."""
    word = around.words[place]
    named = around.texts[place] in around.lexicon.no_times.given_names
    return named and word.capital and any(one.is_letters and not one.capital for one in around.words)


def is_numbered_name(piece: Piece, around: Surroundings) -> bool:
    """Whether its first number belongs to a name with an article: "service the Massey 135 on friday"."""
    words, texts, place = around.words, around.texts, piece.start
    led = place > 1 and texts[place - 2] in around.lexicon.closed.noun_openers
    hour = {":", *around.beside.of_hours, *around.beside.of_clocks}.intersection(texts[place + 1 : place + 2])
    whole = texts[place].isdecimal() and len(texts[place]) >= NUMBER_DIGITS and not hour
    return led and whole and words[place - 1].capital and words[place - 1].is_letters


def is_typed_name(piece: Piece, around: Surroundings) -> bool:
    """Whether its last word is within a tag, or what has an ending, or is joined: "at_noon.sh"."""
    words, texts, last = around.words, around.texts, piece.end - 1
    first = next(place for place in range(last, -1, -1) if not words[place].glued)
    end = piece.end + sum(1 for _ in takewhile(lambda word: word.glued, words[piece.end :]))
    dotted = (texts[place + 1] for place in range(last, end - 1) if texts[place] == DOT)
    return JOINT in texts[first:end] or not around.lexicon.no_times.file_endings.isdisjoint(dotted)
