"""By how much something is to be later or earlier: "ten minutes later", "a bit earlier"."""

from dataclasses import replace
from datetime import datetime

from fuzzytime.language.about_wishes.about import About, AboutKind
from fuzzytime.language.about_wishes.meant import is_last
from fuzzytime.language.about_wishes.said import FOR, Length, Said
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.requirement import Unit

DIRECTIONS = ("later", "earlier")

REFERRED = ("last", "everything")
"""Tables of what stands for what was asked for."""

DAYS = {"a day on": 1, "a day back": -1, "a week on": 7, "a week back": -7}
"""By how many days what is said in each of these tables is later."""


def by_length(said: Said) -> tuple[float, Said] | None:
    """Give by how much something is to be later, below 0 for earlier, and the rest; None without either."""
    rest, directions = said.without(*DIRECTIONS)
    found = rest.length() if directions else None
    if found is None:
        return None
    # "The wake up call an hour later"
    return found.seconds if "later" in directions else -found.seconds, found.rest


def later_by(said: Said) -> tuple[About, Said] | None:
    """Read what is to be later or earlier by a length, or by some, and what stands beside that; else None."""
    if (found := by_length(said)) is not None:
        return About(kind=AboutKind.DELAY, by=found[0]), found[1]
    for place in range(len(said.words)):
        slight = longest_match(said.words, place, said.table("slightly"))
        if not slight:
            continue
        way = said.behind(place + len(slight))
        directions = way.without(*DIRECTIONS)
        if way.words and directions[1] and not directions[0].words:
            text = f"{' '.join(slight)} later"
            earlier = "earlier" in directions[1]
            return About(kind=AboutKind.DELAY, text=text, earlier=earlier), said.until(place)
    return None


def days_on(said: Said) -> int:
    """Give by how many days a new time is later that counts from the old one: "the day after"; 0 for none."""
    return next((days for name, days in DAYS.items() if said.is_in(name)), 0)


def by_how_much(text: str, asked: About, now: datetime, lexicon: Lexicon) -> About | None:
    """Give what was asked about with the length that a line is; None where it says anything else.

    It goes the way that it was said to, unless the answer says another: "bring it forward", "by an hour".
    """
    rest, directions = Said.of(text, now, lexicon).without(*DIRECTIONS, "more")
    found = rest.length()
    if found is None or found.rest.words:
        return None
    earlier = "earlier" in directions or (asked.earlier and "later" not in directions)
    return replace(asked, by=-found.seconds if earlier else found.seconds)


def counted(said: Said) -> Said:
    """Give a number alone as so many minutes: "Tom is running fifteen late"."""
    return Said(f"{said.text} {Unit.MINUTE}s", said.now, said.lexicon) if said.as_number() else said


def one_alone(said: Said) -> Length | None:
    """Give the length that is one of its unit, at the end, and the rest: "my next free hour"."""
    unit = said.words[-1].start if said.words else 0
    one = Said(f"1 {said.text[unit:]}", said.now, said.lexicon).length()
    whole = said.words and one is not None and not one.rest.words
    return replace(one, rest=said.until(len(said.words) - 1)) if one is not None and whole else None


def in_full(said: Said) -> Said:
    """Give a length without what says that it is more: of "another hour" that is one hour."""
    length = said.without("more")[0]
    alone = one_alone(length) if len(length.words) == 1 else None
    return length if alone is None else Said(f"1 {length.text}", said.now, said.lexicon)


def minutes_alone(said: Said, *, directed: bool) -> Length | None:
    """Give the minutes that a number alone counts: "push it by ten", "push everything back ten"."""
    place = len(said.words) - 1
    # "S1" is one word.
    number = said.behind(place).as_number() if place > 0 and not said.words[place].glued else ""
    joint = said.forms[place - 1 : place] == ("by",)
    if not number or not (joint or directed):
        return None
    rest = said.until(place - joint)
    counted = Said(f"{number} {Unit.MINUTE}s", said.now, said.lexicon).length()
    # "Push the boxes by ten" has a deadline.
    known = directed or any(rest.is_in(name) for name in (*REFERRED, "both"))
    return replace(counted, joint="by" if joint else "", rest=rest) if counted and known else None


def lengthened(said: Said) -> About | None:
    """Read how much longer or shorter something takes, or how long: "shorten the call to ten minutes".

    By how much may not be said: "shorten the call".
    """
    longer, shorter = said.after("lengthening"), said.after("shortening")
    rest = longer or shorter
    joint = max((n for n, word in enumerate(rest.forms) if word in {"by", "to"}), default=0) if rest else 0
    if rest is not None and rest.words and not joint and not rest.has_time:
        return About(kind=AboutKind.MORE, names=rest.meant, earlier=longer is None, certain=is_last(rest))
    if rest is None or not joint:
        return None
    thing, behind = rest.until(joint), rest.behind(joint + 1)
    found = behind.length() if behind.words else None
    if found is None or found.rest.words or not (thing.meant or is_last(thing)):
        return None
    about = About(kind=AboutKind.TAKES, names=thing.meant, time=f"{FOR}{behind.text}", certain=is_last(thing))
    if rest.forms[joint] == "to":
        return about
    by = found.seconds if longer is not None else -found.seconds
    return replace(about, kind=AboutKind.MORE, by=by, time="", certain=True)
