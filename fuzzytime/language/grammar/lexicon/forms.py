"""Ways to say something, as the words that they are matched by."""

from collections.abc import Iterable, Mapping, Sequence
from typing import TypeVar

from fuzzytime.language.grammar.words import Word, joins, words_of

Form = tuple[str, ...]
Meaning = TypeVar("Meaning")


class Forms(dict[Form, Meaning]):
    """Ways to say something, and what each means: found by their first words."""

    def __init__(self, meanings: Mapping[Form, Meaning]) -> None:
        super().__init__(meanings)
        self._beginning: dict[str, list[Form]] = {}
        for form in meanings:
            self._beginning.setdefault(form[0], []).append(form)

    @classmethod
    def of(cls, forms: Iterable[Form]) -> "Forms[None]":
        """Give ways to say one thing."""
        return Forms(dict.fromkeys(forms))

    def beginning(self, word: str) -> Sequence[Form]:
        """Give those that begin with a word."""
        return self._beginning.get(word, ())


def matched_to(words: Sequence[Word], start: int, form: Form) -> int:
    """Give the end of a form that stands at a place, or 0; a hyphen may join its words."""
    at = start + 1
    for text in form[1:]:
        if at < len(words) and words[at].text != text and joins(words, at):
            at += 1
        if at >= len(words) or words[at].text != text:
            return 0
        at += 1
    return at


def longest_match(words: Sequence[Word], start: int, forms: Iterable[Form]) -> Form | None:
    """Give the longest of some forms that stands at a place, or None."""
    first = words[start].text
    likely = forms.beginning(first) if isinstance(forms, Forms) else forms
    longest: Form | None = None
    for form in likely:
        longer = form[0] == first and (longest is None or len(form) > len(longest))
        if longer and matched_to(words, start, form):
            longest = form
    return longest


def form_of(text: str) -> Form:
    """Give a way to say something as the words it is matched by."""
    if text.isascii() and text.replace(" ", "").isalpha():
        # Most are plain words, and thousands are read at every start.
        return tuple(text.lower().split())
    return tuple(word.text for word in words_of(text))
