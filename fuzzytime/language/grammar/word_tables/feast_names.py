"""How the name of a feast is written otherwise: "st. andrews day", "good fri", "presidents day"."""

from collections.abc import Iterator, Mapping, Sequence

from fuzzytime.language.grammar.lexicon import Form

POSSESSIVE = "'s"

APOSTROPHE = "'"

MOST = 64
"""Ways that are given of one name, at most."""


def otherwise(form: Form, shortened: Mapping[str, Sequence[Form]]) -> Iterator[Form]:
    """Give other ways to write a name, given what its words are shortened to.

    >>> list(otherwise(("ash", "wednesday"), {"wednesday": [("wed",)]}))
    [('ash', 'wed')]
    >>> [" ".join(way) for way in otherwise(("father's", "day"), {})]
    ['fathers day', "fathers ' day", 'father day']
    """
    ways: list[Form] = [()]
    place = 0
    while place < len(form):
        text, behind = form[place], form[place + 1 : place + 2]
        owned = place + 1 < len(form) and (text.endswith(POSSESSIVE) or behind == (APOSTROPHE,))
        here = _owners(text) if owned else [(text,), *shortened.get(text, ())]
        ways = [(*before, *word) for before in ways for word in here][:MOST]
        place += 2 if owned and behind == (APOSTROPHE,) else 1
    yield from (way for way in dict.fromkeys(ways) if way != form)


def _owners(text: str) -> list[Form]:
    """Give the ways to write whose day it is: "father's", "fathers", "fathers'", "father"."""
    owner = text.removesuffix(POSSESSIVE)
    if owner != text:
        several = owner + ("es" if owner.endswith("s") else "s")
        return [(text,), (several,), (several, APOSTROPHE), (owner,)]
    one = text.removesuffix("s")
    return [(text, APOSTROPHE), (text,), (one + POSSESSIVE,)]
