"""What is said of wishes in usual words: "allow an hour for the call" is "make the call an hour"."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from datetime import datetime

from fuzzytime.english import is_participle
from fuzzytime.language import Lexicon
from fuzzytime.language.about_wishes import (
    Said,
    bare,
    counted,
    in_full,
    later_by,
    without_request,
    written_out,
)

SLOT = "<"
"""How what is left open in a way to say something begins: "<thing>"."""

TIMES = frozenset({"<time>", "<old>"})
LENGTH, MORE = "<length>", "<more>"
DOING, PURPOSE, THING = "<doing>", "<purpose>", "<thing>"
ANY = "<any>"
SOMEBODY = "<somebody>"
OPEN = frozenset({ANY, SOMEBODY})
"""Where a time is left open, a length of time, what one is at, and anything; else what was asked for."""

OF_ITSELF = ("cancel", "move")
"""How what is told of a thing itself is said, and of nothing that only has to do with it."""

SHIFTING = ("push", "bring")
"""How what is only later or earlier is said."""

MARK = re.compile(r"['\u2019]s$")
"""What tells whose something is, or is short for "is", or "has"."""

PRONOUN = re.compile(r"\w+")
"""Who a clause is of, without what is short for "is", or "will"."""

LONGEST = 24
"""Words of a line that is read so."""


AT, FOR = "at ", "for "
THE, TO = "the", "to "

Slots = Mapping[str, Said]
Way = Sequence[frozenset[str]]


def in_usual_words(
    text: str, now: datetime, lexicon: Lexicon, is_known: Callable[[Said, bool], bool]
) -> str | None:
    """Give a line as the table of ways has it; None where no way to say something about wishes is in it.

    Of each thing that stands in it, ``is_known`` tells whether it was asked for; it is told whether the line
    may tell of something else.

    >>> from fuzzytime.language import shipped_lexicon
    >>> now = datetime(2026, 3, 4, 9)
    >>> in_usual_words("allow an hour for the call", now, shipped_lexicon(), lambda thing, told: True)
    'make the call an hour'
    """
    whole = Said.of(text, now, lexicon)
    plain = bare(whole).without_end(whole.table("instead"))
    asked = bare(without_request(plain)) if plain.words else plain
    texts = (whole.text, plain.text, asked.text)
    # "Sarah's late", but "Sarah's meeting"
    for line in dict.fromkeys(one for text in texts for one in (text, written_out(text))):
        for usual, way, found in _fitting(Said(line, now, lexicon)):
            shifts = usual.startswith(SHIFTING) and LENGTH in found
            slots = {**found, LENGTH: counted(found[LENGTH])} if shifts else found
            of_itself = usual.startswith(OF_ITSELF) and (_slot(way[0]) not in {"", SOMEBODY} or THE in way[0])
            if not _is_meant(slots, is_known, told=bool(of_itself)):
                continue
            if usual != ANY:
                return _with_slots(usual, slots)
            # "Ann says the call can wait till six", "Ann says she can't come before six"
            who, told = slots.get(SOMEBODY), slots[ANY]
            told = told if who is None or not is_known(who, who.is_one) else of_whom(who, told)
            if (behind := in_usual_words(told.text, now, lexicon, is_known)) is not None:
                return behind
    return None


def of_whom(who: Said, told: Said) -> Said:
    """Give what is told of "he", or "they", as what is told of who that is."""
    pronoun = PRONOUN.match(told.text) if told.words and told.opens_with("they") else None
    if pronoun is None:
        return told
    text = f"{who.text}{told.text[pronoun.end() :]}".replace("'ll ", " will ")
    return Said(text, told.now, told.lexicon)


def _fitting(said: Said) -> Iterator[tuple[str, Way, Slots]]:
    """Give the ways that fit a line, with what stands in their slots: first those with most other words."""
    words = frozenset(said.forms)
    found = [
        (-taken, place, usual, way, slots)
        for place, (usual, way) in enumerate(said.lexicon.ways if len(said.words) <= LONGEST else ())
        if all("" in one or _slot(one) or one & words for one in way)
        for taken, slots in _filled(said, way)
    ]
    yield from (one[2:] for one in sorted(found, key=lambda one: one[:2]))


def _slot(place: frozenset[str]) -> str:
    return next((one for one in place if one.startswith(SLOT)), "")


def _filled(said: Said, way: Way) -> Iterator[tuple[int, Slots]]:
    """Give each way in which the slots stand for all that is said, with how many other words there are."""
    if not way:
        yield from () if said.words else ((0, {}),)
        return
    place, rest = way[0], way[1:]
    if "" in place:
        yield from _filled(said, rest)
    if not said.words:
        return
    if (slot := _slot(place)) == "":
        if said.forms[0] in place:
            yield from ((taken + 1, slots) for taken, slots in _filled(said.behind(1), rest))
        return
    following = rest[0] if rest and "" not in rest[0] and not _slot(rest[0]) else None
    for end in range(1, len(said.words) + 1) if rest else (len(said.words),):
        if following is None or (end < len(said.words) and said.forms[end] in following):
            behind = _filled(said.behind(end), rest)
            yield from ((taken, {slot: said.until(end), **slots}) for taken, slots in behind)


def _is_meant(slots: Slots, is_known: Callable[[Said, bool], bool], *, told: bool) -> bool:
    times = [said for name, said in slots.items() if name in TIMES]
    things = [said for name, said in slots.items() if name not in TIMES | OPEN | {LENGTH, MORE}]
    return (
        all(said.words for said in slots.values())
        and all(is_participle(said.forms[0]) for name, said in slots.items() if name == DOING)
        and all(is_known(said, told) for said in things)
        and all(map(_time, times))
        and all(_is_length(said) for name, said in slots.items() if name == LENGTH)
        and all(_is_length(in_full(said)) for name, said in slots.items() if name == MORE)
    )


def _time(said: Said) -> str:
    """Give it as a new time; empty where it is none, or counts from the old one: "an hour later"."""
    told = said.forms in said.lexicon.connectives or said.places or not said.is_one
    time = "" if told or later_by(said) is not None else said.as_time()
    return "" if time.lower().startswith(FOR) else time


def _is_length(said: Said) -> bool:
    found = said.length()
    return found is not None and not found.rest.words and not found.joint


def _with_slots(usual: str, slots: Slots) -> str:
    for name, said in slots.items():
        text = _time(said).removeprefix(AT) if name in TIMES else said.text
        text = text.removeprefix(TO) if name == PURPOSE else text
        text = in_full(said).text if name in {LENGTH, MORE} else text
        # "The lecture's been moved to two"
        text = said.label or MARK.sub("", text) if name == THING else text
        if name == THING and len(said.words) > 1 and said.forms[:1] in said.table("last"):
            # "That call"
            text = f"{THE} {said.behind(1).text}"
        usual = usual.replace({DOING: THING, MORE: LENGTH}.get(name, name), text)
    return usual
