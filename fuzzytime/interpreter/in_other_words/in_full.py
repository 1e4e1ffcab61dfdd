"""Wishes that lean on the verb of the one before them, said in full: "and dad at seven"."""

from dataclasses import replace

from fuzzytime.errors import InstructionError
from fuzzytime.interpreter.request import Request, SpokenWish, Wish
from fuzzytime.language import Language
from fuzzytime.language.about_wishes import continued


def in_full(request: Request, language: Language) -> Request:
    """Give a request in which no wish leans on the verb of another.

    In a file "call mum at six" may stand on one line, and "and dad at seven" on the next.
    """
    wishes: list[Wish] = []
    for wish in request.wishes:
        before = wishes[-1] if wishes else None
        if isinstance(wish, SpokenWish) and isinstance(before, SpokenWish):
            wishes.append(_in_full(wish, before, language))
        else:
            wishes.append(wish)
    return replace(request, wishes=tuple(wishes))


def _in_full(wish: SpokenWish, before: SpokenWish, language: Language) -> SpokenWish:
    try:
        text = continued(wish.text, wish.given, before.text, before.given, language)
    except InstructionError:
        # Read alone, it says what is wrong with it.
        return wish
    return wish if text is None else replace(wish, text=text)
