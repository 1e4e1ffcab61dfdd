"""Ways to say something, as the words that they are matched by."""

from collections.abc import Iterable, Sequence

from fuzzytime.language.grammar.words import Word, joins, words_of


def matched_to(words: Sequence[Word], start: int, form: tuple[str, ...]) -> int:
    """Give the end of a form that stands at a place, or 0; a hyphen may join its words."""
    at = start + 1
    for text in form[1:]:
        if at < len(words) and words[at].text != text and joins(words, at):
            at += 1
        if at >= len(words) or words[at].text != text:
            return 0
        at += 1
    return at


def longest_match(
    words: Sequence[Word], start: int, forms: Iterable[tuple[str, ...]]
) -> tuple[str, ...] | None:
    """Give the longest of some forms that stands at a place, or None."""
    found = [f for f in forms if words[start].text == f[0] and matched_to(words, start, f)]
    return max(found, key=len, default=None)


def form_of(text: str) -> tuple[str, ...]:
    """Give a way to say something as the words it is matched by."""
    if text.isascii() and text.replace(" ", "").isalpha():
        # Most are plain words, and thousands are read at every start.
        return tuple(text.lower().split())
    return tuple(word.text for word in words_of(text))
