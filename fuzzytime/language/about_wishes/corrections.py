"""What corrects what was said before, or adds to it: "no, …", "actually, …", "… instead", "at seven"."""

from datetime import datetime

from fuzzytime.language.about_wishes.about import About, AboutKind
from fuzzytime.language.about_wishes.said import FROM, Said
from fuzzytime.language.finding import find_times
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.requirement import TimeRequirement

MARKS = frozenset({",", ".", ";", "!", "-"})
"""What may stand behind the words that correct."""


def opening_correction(said: Said) -> int:
    """Count the words with which a line says that it corrects: "no wait, actually"."""
    place = 0
    while place < len(said.words):
        form = longest_match(said.words, place, said.lexicon.corrections)
        if form is None and said.forms[place] not in MARKS:
            break
        place += len(form) if form is not None else 1
    # "Wait ten minutes" is an order, and "no later" a bound.
    order = place == 1 and said.forms[0] in said.lexicon.doing.waiting
    return 0 if order or said.forms[:2] in {("no", "later"), ("no", "earlier")} else place


def restated(text: str, now: datetime, lexicon: Lexicon) -> str | None:
    """Give what a line says in the place of what was said before; None where no word says so.

    >>> from datetime import datetime
    >>> from fuzzytime.language.finding import shipped_lexicon
    >>> restated("no, feed the dog at seven instead", datetime(2026, 3, 4, 9), shipped_lexicon())
    'feed the dog at seven'
    """
    said = Said.of(text, now, lexicon)
    place = opening_correction(said)
    rest = said.behind(place)
    closing = max((form for form in _closing(said) if rest.forms[-len(form) :] == form), key=len, default=())
    kept = rest.until(len(rest.words) - len(closing))
    return kept.text if kept.words and (place or closing) else None


def added_time(text: str, now: datetime, lexicon: Lexicon, *, wish: bool = False) -> About | None:
    """Read a line that is a time and nothing else, as what was asked for last has it; else give None.

    What is read as a ``wish`` is one, but for "one pm works better", "tomorrow, I mean".

    >>> from datetime import datetime
    >>> from fuzzytime.language.finding import shipped_lexicon
    >>> added_time("At seven.", datetime(2026, 3, 4, 9), shipped_lexicon()).time
    'at seven'
    """
    said = Said.of(text, now, lexicon).without_exclamations()
    told = said.without_end(lexicon.courtesies | said.table("instead"))
    said = told.without_end(said.table("preferring") | said.table("meaning"))
    if wish and said == told:
        return None
    if (counted := _counted_at(said)) is not None:
        return counted
    # "Post 11" is an errand, rather than after eleven.
    errand = said.forms[:1] and said.forms[0] in lexicon.doing.errands
    time = "" if errand else said.as_time()
    # "Four" may count anything, but "four to five" has two ends.
    time = time if said.has_time or said != told or time.startswith(FROM) else ""
    number = said.as_number() if len(said.words) == 1 else ""
    if not time or said.places:
        return None
    bare = said.is_bare(time)
    return About(kind=AboutKind.MOVE, time=time[0].lower() + time[1:], number=number, bare=bare)


def _counted_at(said: Said) -> About | None:
    """Read a new time of one that is named by its place: "the second one tomorrow"."""
    listed = {form[-1] for form in said.table("listed")}
    for place in (place for place in range(2, len(said.words)) if said.forms[place - 1] in listed):
        places, time = said.until(place).places, said.behind(place).as_time()
        if len(places) == 1 and time:
            return About(kind=AboutKind.MOVE, places=places, time=time, certain=True)
    return None


def _closing(said: Said) -> frozenset[tuple[str, ...]]:
    """Give what says "instead" behind a new time, but not what joins a step to another: "then"."""
    return said.table("instead") - said.lexicon.connectives.keys()


def without_closing(text: str, now: datetime, lexicon: Lexicon) -> str:
    """Give a line without what only closes it behind a time: "breakfast at ten then"; not "before then"."""
    said = Said.of(text, now, lexicon)
    closing = said.table("preferring") & lexicon.connectives.keys()
    form = next((form for form in closing if said.forms[-len(form) :] == form != said.forms), None)
    rest = said.until(len(said.words) - len(form or ()))
    behind_time = any(_is_told(part) for part in _closing_times(rest))
    # "An hour before then" is one time.
    counts = any(part.span[0] < len(rest.text) for part in _closing_times(said))
    return rest.text if form is not None and behind_time and not counts else text


def _closing_times(said: Said) -> list[TimeRequirement]:
    found = find_times(said.text, said.now, said.lexicon).requirements
    return [part for part in found if part.span[1] == len(said.text)]


def _is_told(part: TimeRequirement) -> bool:
    """Whether a time is whole: a day, an hour, or a length."""
    return any(side is not None for side in (part.t_spec, part.earliest, part.latest, part.number))
