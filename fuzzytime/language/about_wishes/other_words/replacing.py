"""Lines that say several things: "forget that, call Ann at six", "cancel the call and move the soup"."""

import re
from dataclasses import replace
from datetime import datetime

from fuzzytime.language.about_wishes.about import About, AboutKind
from fuzzytime.language.about_wishes.corrections import opening_correction
from fuzzytime.language.about_wishes.reading import about_wishes
from fuzzytime.language.about_wishes.said import Said
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Operation

TAKEN = frozenset(AboutKind) - {
    AboutKind.ANSWER,
    AboutKind.SUPPOSE,
    AboutKind.INSTEAD,
    AboutKind.LIKE,
    AboutKind.OTHER,
    AboutKind.WRONG,
    AboutKind.UNABLE,
}
"""What may be said beside another thing in one line."""

WHOLE = frozenset({AboutKind.UNDO, AboutKind.SWAP, AboutKind.OTHER})
"""What is said of two, or in two ways: "never mind, leave it"."""

MOST_APART = 5
"""How many things a line is read as at most."""

OF_OTHERS = frozenset({AboutKind.DROP, AboutKind.MOVE, AboutKind.DELAY, AboutKind.SWAP})
"""What is rather said of something else that was asked for than in its place."""

SENTENCES = re.compile(r"(?<=[.!?;])\s+(?:and\s+(?:then\s+)?)?", re.IGNORECASE)
CLAUSES = re.compile(
    r"(?:(?<=[.!?;])|,)\s+(?:and\s+(?:then\s+)?|then\s+)?|\s+and\s+(?:then\s+)?", re.IGNORECASE
)
"""What stands between what is said one after the other in a line."""


def said_apart(text: str, now: datetime, lexicon: Lexicon) -> list[str]:
    """Part a line that says several things of what was asked for; else give it whole.

    Sentences are apart where one is surely about that, clauses where each is.

    >>> from datetime import datetime
    >>> from fuzzytime.language.finding import shipped_lexicon
    >>> said_apart("cancel the call and move the soup to six", datetime(2026, 3, 4, 9), shipped_lexicon())
    ['cancel the call', 'move the soup to six']
    """
    whole = about_wishes(text, now, lexicon)
    if (whole is not None and (whole.kind in WHOLE or whole.told)) or in_its_place(
        text, now, lexicon
    ) is not None:
        return [text]
    for marks, every in ((CLAUSES, True), (SENTENCES, False)):
        parts = [part.rstrip(",.;! ") for part in marks.split(text) if part.strip(",.;! ")]
        if not 1 < len(parts) <= MOST_APART:
            continue
        said = [about_wishes(part, now, lexicon) for part in parts]
        if whole is not None and said[0] is not None and whole == replace(said[0], by=whole.by):
            # "The dishes took longer, another ten minutes"
            return [text]
        kinds = [None if one is None else one.kind for one in said]
        sure = any(one is not None and one.certain and one.kind in TAKEN for one in said)
        if all(kind in TAKEN for kind in kinds) if every else sure:
            # "Thanks. What's next?"
            left = [n for n, kind in enumerate(kinds) if kind is not AboutKind.ANSWER]
            # "Never mind, cancel that" lets one thing be, and says so twice.
            again = {n for n in left if n + 1 in left and _is_said_again(said[n], said[n + 1])}
            return [parts[n] for n in left if n not in again or f"{parts[n]} and " in text]
    return [text]


def _is_said_again(about: About | None, behind: About | None) -> bool:
    """Whether what lets the last thing be only opens what says which one: "never mind, forget the film"."""
    if about is None or behind is None or not about.kind is behind.kind is AboutKind.DROP:
        return False
    return not (about.names or about.places or about.everything or about.both or about.other)


def behind_an_answer(text: str, now: datetime, lexicon: Lexicon) -> str:
    """Leave out what only answers in front of something else: "ok fine, now", "sure, call Bob at six".

    What corrects is no mere answer: "no, at seven".

    >>> from datetime import datetime
    >>> from fuzzytime.language.finding import shipped_lexicon
    >>> behind_an_answer("ok fine, now", datetime(2026, 3, 4, 9), shipped_lexicon())
    'now'
    """
    said = rest = Said.of(text, now, lexicon)
    while rest.words and (taken := rest.opens_with("answering")) and not opening_correction(rest):
        rest = rest.behind(taken)
        if rest.forms[:1] == (",",) and len(rest.words) > 1:
            end = rest.behind(1).text
            return text[text.index(end) :] if end in text else end
    return text if said.words else ""


def in_its_place(text: str, now: datetime, lexicon: Lexicon) -> tuple[About, str] | None:
    """Give what a line lets be, and the wish that it says behind that; None where it does not.

    The wish is no more than what stands there: who reads it must see whether it asks for something.

    >>> from datetime import datetime
    >>> from fuzzytime.language.finding import shipped_lexicon
    >>> about, wish = in_its_place("forget that, call Ann at six", datetime(2026, 3, 4, 9), shipped_lexicon())
    >>> about.kind.value, wish
    ('drop', 'call Ann at six')
    """
    said = Said.of(text, now, lexicon)
    for place in range(1, len(said.words)):
        # "S1.2" is one word.
        inside = said.words[place].glued and all(word.glued for word in said.words[place + 1 : place + 2])
        if inside or said.forms[place : place + 1] not in said.table("parting"):
            continue
        about = about_wishes(said.until(place).text, now, lexicon)
        if about is None or about.kind is not AboutKind.DROP or about.everything:
            continue
        rest = said.behind(place)
        while rest.forms[:1] in said.table("parting"):
            rest = rest.behind(1)
        rest = rest.without_end(said.table("instead"))
        again = about_wishes(rest.text, now, lexicon)
        wish = again is None or not (again.certain or again.text or again.kind in OF_OTHERS)
        return (about, rest.text) if rest.words and wish else None
    return None


def with_names(wish: str, before: Operation | None, lexicon: Lexicon) -> str:
    """Give a wish with whom it is about in the place of "her", whom only what it stands for names."""
    if before is None or not before.object:
        return wish
    for word in words_of(wish):
        if word.text in lexicon.closed.third_person_objects:
            return f"{wish[: word.start]}{before.object}{wish[word.end :]}"
    return wish
