"""Which kind of thing a line of a conversation says about the wishes before it."""

from datetime import datetime

from fuzzytime.language.about_wishes.about import About, AboutKind
from fuzzytime.language.about_wishes.asking import asked
from fuzzytime.language.about_wishes.changes import change
from fuzzytime.language.about_wishes.questions import question
from fuzzytime.language.about_wishes.reports import report
from fuzzytime.language.about_wishes.said import Said
from fuzzytime.language.about_wishes.things import without_exclamations
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match

ENDS = ".?! "
MARKS = frozenset({",", ".", "!", "?", "-"})


def about_wishes(text: str, now: datetime, lexicon: Lexicon) -> About | None:
    """Read what is said about wishes that were said before; None where it may be a wish itself.

    >>> from datetime import datetime
    >>> from fuzzytime.language.finding import shipped_lexicon
    >>> about_wishes("no, make it six", datetime(2026, 3, 4, 9), shipped_lexicon()).time
    'at six'
    """
    whole = Said(text.strip(ENDS), now, lexicon)
    if not whole.words:
        return None
    said = _without_courtesies(whole)
    if not said.words or not set(whole.without("answering")[0].forms) - MARKS:
        return About(kind=AboutKind.ANSWER, certain=True)
    found = _read(said)
    plain = without_exclamations(said)
    return found if found is not None or plain == said else _read(plain)


def _read(said: Said) -> About | None:
    return (
        asked(said) or question(said) or change(_without_request(said)) or change(said) or report(said)
    )


def _without_request(said: Said) -> Said:
    """Leave out what makes a question or a suggestion of an order: "could we", "let's"."""
    questions = said.lexicon.questions
    opening = questions["requesting"] | questions["suggesting"] | said.table("letting")
    form = longest_match(said.words, 0, opening)
    return said if form is None or len(form) == len(said.words) else said.behind(len(form))


def _without_courtesies(said: Said) -> Said:
    """Leave out what opens a request, as it does a wish, and thanks: "could you please … thanks"."""
    lexicon = said.lexicon
    opening = {*lexicon.courtesies, *((word,) for word in lexicon.addresses)} - lexicon.corrections
    place = 0
    while form := longest_match(said.words, place, opening):
        if place + len(form) >= len(said.words):
            break
        place += len(form)
    said = said.behind(place)
    for form in sorted(lexicon.courtesies, key=len, reverse=True):
        if len(form) < len(said.words) and said.forms[-len(form) :] == form:
            return said.until(len(said.words) - len(form))
    return said
