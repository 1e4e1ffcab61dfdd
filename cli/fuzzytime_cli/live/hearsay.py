"""Plain words of a run about what was asked for already: "forget the soup", "the rice is ready"."""

from collections.abc import Sequence

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import Lexicon, content_words
from fuzzytime.language.about_wishes import About, AboutKind, about_wishes
from fuzzytime_cli.live.messages import Said, Told, Word

WORDS = {AboutKind.DROP: Word.DROP, AboutKind.DONE: Word.DONE}
"""What can be told of a skill in words as by a line of its own."""

Named = Sequence[tuple[str, str]]
"""Identifiers with what they name, what was said last at the end."""


def heard_about(said: Said, lexicon: Lexicon, running: Named, waiting: Named) -> Told | None:
    """Give the word about a skill that an instruction is; None where it is a wish of its own.

    Raises
    ------
    FuzzytimeError
        If it is about what was asked for already, and a run does not take that in words.
    """
    about = about_wishes(said.wish.text, said.wish.given, lexicon)
    if about is None or about.kind is AboutKind.TAKES or (about.told and about.kind not in WORDS):
        # How long it takes is told as an instruction is, and so is that it is late.
        return None
    known = _meant(about, running, waiting)
    if not known and not about.certain:
        return None
    word = WORDS.get(about.kind)
    if word is not None and len(known) == 1:
        return Told(at=said.at, comes=said.comes, word=word, identifier=known[0])
    if word is not None:
        which = ", ".join(known) or "there is no such skill"
        raise FuzzytimeError(f'{word.value} which? ({which}); or by its id, such as {{"{word.value}": "s1"}}')
    raise FuzzytimeError(
        f"it is about what was asked for before ({about.kind.value}), which a run takes as "
        'lines such as {"done": "s1"} and {"drop": "s1"}, and as instructions said anew'
    )


def _meant(about: About, running: Named, waiting: Named) -> list[str]:
    """Give the skills that are meant: those that some words name, else what is running."""
    if about.names:
        every = (*running, *waiting)
        return [name for name, words in every if about.names <= content_words(words)]
    return [name for name, _ in running]
