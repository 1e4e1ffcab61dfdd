"""Words about time as they are often mistyped: letters swapped, left out, doubled, or another vowel."""

from collections.abc import Collection, Iterable, Iterator, Mapping

VOWELS = "aeiou"


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
        if word[place] in VOWELS:
            yield from (word[:place] + vowel + word[place + 1 :] for vowel in VOWELS if vowel != word[place])
