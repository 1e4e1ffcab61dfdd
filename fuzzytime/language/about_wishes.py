"""What is said about what was asked for already: "no, make it six", "cancel the call", "when do I stir?"."""

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from enum import StrEnum

from fuzzytime.language.finding import find_times
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word, words_of
from fuzzytime.language.sentence.references import content_words
from fuzzytime.requirement import Constraint, TimeRequirement, Unit

ENDS = ".?! "
TO = ("back to ", "forward to ", "to ", "back until ", "until ", "till ")
"""Words between what is moved and the time that it is moved to."""

OPEN = frozenset({"postpone", "delay", "reschedule"})
"""Verbs of which only a time can follow what is moved."""

CLOCKED = frozenset({Unit.HOUR, Unit.MINUTE, Unit.SECOND})
"""The grains of clock times."""

ASKED = frozenset(
    ["i", "we", "you", "need", "begin", "start", "supposed", "due", "happen", "up", "again", "planned"]
)
"""Words of a question that name nothing."""


class AboutKind(StrEnum):
    """What is said of it."""

    DROP = "drop"
    MOVE = "move"
    NEXT = "next"
    ALL = "all"
    WHEN = "when"


@dataclass(frozen=True, slots=True, kw_only=True)
class About:
    """What is said about something asked for: the words that name it, none for the last; and the new time."""

    kind: AboutKind
    names: frozenset[str] = frozenset()
    time: str = ""


def about_wishes(text: str, now: datetime, lexicon: Lexicon) -> About | None:
    """Read what is said about wishes that were said before; None where it may be a wish itself.

    >>> from datetime import datetime
    >>> from fuzzytime.language.finding import shipped_lexicon
    >>> about_wishes("no, make it six", datetime(2026, 3, 4, 9), shipped_lexicon()).time
    'at six'
    """
    said = text.strip(ENDS)
    words = words_of(said)
    opening = 0
    while (form := _opening(words, opening, lexicon)) and opening + len(form) < len(words):
        opening += len(form)
    if not words:
        return None
    said = said[words[opening].start :]
    words = words_of(said)
    return (
        _question(said, words, lexicon)
        or _dropped(said, words, now, lexicon)
        or _corrected(said, words, now, lexicon)
        or _moved(said, words, now, lexicon)
    )


def _opening(words: Sequence[Word], place: int, lexicon: Lexicon) -> tuple[str, ...]:
    """Give what opens a request, as it does a wish: "could you please"."""
    forms = {*lexicon.courtesies, *((word,) for word in lexicon.addresses)} - lexicon.corrections
    return longest_match(words, place, forms) or ()


def _question(said: str, words: Sequence[Word], lexicon: Lexicon) -> About | None:
    whole = tuple(word.text for word in words)
    for kind in (AboutKind.NEXT, AboutKind.ALL):
        if whole in lexicon.conversation[kind.value]:
            return About(kind=kind)
    form = longest_match(words, 0, lexicon.conversation["when"])
    if form is None or len(form) == len(words):
        return None
    names = content_words(said[words[len(form)].start :]) - ASKED
    return About(kind=AboutKind.WHEN, names=names) if names else None


def _dropped(said: str, words: Sequence[Word], now: datetime, lexicon: Lexicon) -> About | None:
    form = longest_match(words, 0, lexicon.conversation["dropping"])
    if form is None:
        return None
    rest = said[words[len(form)].start :] if len(form) < len(words) else ""
    if find_times(rest, now, lexicon).requirements:
        return None
    if not rest or tuple(word.text for word in words_of(rest)) in lexicon.conversation["last"]:
        return About(kind=AboutKind.DROP)
    names = content_words(rest) - {form[0] for form in lexicon.courtesies}
    return About(kind=AboutKind.DROP, names=names) if names else None


def _corrected(said: str, words: Sequence[Word], now: datetime, lexicon: Lexicon) -> About | None:
    place = 0
    while place < len(words):
        form = longest_match(words, place, lexicon.corrections)
        if form is None and words[place].text != ",":
            break
        place += len(form) if form is not None else 1
    if place == 0 or place == len(words) or (place == 1 and words[0].text == "wait"):
        # "Wait ten minutes" is an order
        return None
    rest = said[words[place].start :]
    thing, is_said, new = rest.rpartition(" is ")
    if is_said:
        # "Actually, the dentist is at half past four"
        time, names = _time(new, now, lexicon), content_words(thing)
        return About(kind=AboutKind.MOVE, names=names, time=time) if time and names else None
    time = _time(rest, now, lexicon)
    return About(kind=AboutKind.MOVE, time=time) if time else None


def _moved(said: str, words: Sequence[Word], now: datetime, lexicon: Lexicon) -> About | None:
    verb = words[0].text
    if verb not in lexicon.rescheduling:
        return None
    behind = said[words[0].end :].strip()
    joint = next((to for to in TO if f" {to}" in behind.lower()), "")
    place = behind.lower().rfind(f" {joint}") if joint else 0
    thing, said_time = (behind[:place], behind[place + 1 :]) if joint else ("", "")
    if not joint and verb in OPEN:
        found = find_times(behind, now, lexicon).requirements[-1:]
        thing, said_time = (behind[: found[0].span[0]], behind[found[0].span[0] :]) if found else ("", "")
    pronoun = tuple(word.text for word in words_of(thing)) in lexicon.conversation["last"]
    names = frozenset() if pronoun else content_words(thing)
    time = _time(said_time, now, lexicon) if said_time else ""
    return About(kind=AboutKind.MOVE, names=names, time=time) if time and (names or pronoun) else None


def _time(said: str, now: datetime, lexicon: Lexicon) -> str:
    """Give a new time as it would be said with what is to be done; empty where it is none."""
    joint = next((to for to in TO if said.lower().startswith(to)), "")
    bare = said[len(joint) :]
    tried = (bare, f"at {bare}", f"for {bare}")
    found = [(text, part) for text in tried for part in _whole(text, now, lexicon)]
    if len(found) > 1 and _lacks_preposition(found[0][1]):
        found = found[1:]
    return found[0][0] if found else ""


def _whole(text: str, now: datetime, lexicon: Lexicon) -> tuple[TimeRequirement, ...]:
    """Give the time that a text is, whole."""
    found = find_times(text, now, lexicon).requirements
    return found if len(found) == 1 and found[0].span == (0, len(text)) else ()


def _lacks_preposition(found: TimeRequirement) -> bool:
    """Whether a time is said as "six", "20 minutes", which want "at" and "for" behind what is to be done."""
    clock = found.constraint is Constraint.AT and found.grain in CLOCKED and " at " not in found.text
    length = found.constraint is Constraint.FOR and not found.text.lower().startswith("for ")
    return found.preposition is None and found.word is None and (clock or length)
