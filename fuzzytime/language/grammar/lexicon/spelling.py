"""Words about time as they are often mistyped: letters swapped, left out, doubled, or others beside them."""

from collections.abc import Collection, Iterable, Iterator, Mapping

VOWELS = "aeiou"

KEYS = ("qwertyuiop", "asdfghjkl", "zxcvbnm")
"""Letters as they stand on a keyboard, each row half a key further right than the one above."""

LEAST = 5
"""Letters of a word, at least, in which a key beside the right one is known: shorter ones become others."""


def _beside(letter: str) -> str:
    """Give the letters whose keys touch that of one: those beside it, and two above and below."""
    row = next((row for row, keys in enumerate(KEYS) if letter in keys), None)
    if row is None:
        return ""
    column = KEYS[row].index(letter)
    near = {-1: (0, 1), 0: (-1, 1), 1: (-1, 0)}
    places = [(row + up, column + side) for up, sides in near.items() for side in sides]
    return "".join(KEYS[r][c] for r, c in places if 0 <= r < len(KEYS) and 0 <= c < len(KEYS[r]))


def misspellings(words: Iterable[str], known: Collection[str]) -> Mapping[str, str]:
    """Give what is meant by each misspelling of some words, except by what is a word itself.

    >>> found = misspellings(["quarter", "every"], {"very"})
    >>> found["quater"], found["qaurter"], "very" in found
    ('quarter', 'quarter', False)
    """
    found: dict[str, str] = {}
    for word in words:
        for typed in _mistyped(word):
            if typed not in known:
                found.setdefault(typed, word)
    return found


def clipped(words: Iterable[str], known: Collection[str]) -> Mapping[str, str]:
    """Give what may be meant by some words whose last letter is left out or doubled: "soo", "laterr".

    >>> clipped(["soon", "now"], {"no"})
    {'soo': 'soon', 'soonn': 'soon', 'noww': 'now'}
    """
    typed = ((slip, word) for word in words for slip in (word[:-1], word + word[-1]))
    return {slip: word for slip, word in typed if slip not in known}


def _mistyped(word: str) -> Iterator[str]:
    """Give a word with one slip that leaves its first and its last letter in place, or swaps the last two."""
    for place in range(1, len(word) - 1):
        yield word[:place] + word[place + 1] + word[place] + word[place + 2 :]
        yield word[:place] + word[place + 1 :]
        yield word[:place] + word[place] + word[place:]
        others = VOWELS.replace(word[place], "") if word[place] in VOWELS else ""
        others += _beside(word[place]) if len(word) >= LEAST else ""
        yield from (word[:place] + letter + word[place + 1 :] for letter in others)
