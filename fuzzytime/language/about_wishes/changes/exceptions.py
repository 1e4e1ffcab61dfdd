"""What is not to be once, or on some days: "skip tomorrow's"; and what is kept free: "keep friday free"."""

from fuzzytime.language.about_wishes.about import About, AboutKind
from fuzzytime.language.about_wishes.said import AT, CLOCKED, FOR, Said
from fuzzytime.language.finding import one_time
from fuzzytime.requirement import Constraint

OF = ("'s", "’s", "'", "’")

STRETCHES = frozenset({Constraint.BETWEEN, Constraint.BEFORE, Constraint.AFTER})
"""Times in which there may be much."""

LONGEST_CLOCK = 4
"""Words of a clock time at most."""

LONGEST_DAY = 3
"""Words that a day has at most in front of what it is of."""


def cleared(said: Said) -> About | None:
    """Read a stretch of which all is to go: "clear my afternoon", "cancel everything after three"."""
    rest = said.after("clearing")
    whole = rest if rest is not None else said.after("dropping")
    everything = None if whole is None else whole.after("everything")
    stretch = everything if everything is not None and everything.words else rest
    if stretch is None or not stretch.has_time or stretch.label:
        return None
    time = stretch.as_time()
    read = one_time(time, said.now, said.lexicon) if time else None
    if read is None or read.constraint not in STRETCHES:
        return None
    return About(kind=AboutKind.DROP, everything=True, time=time, certain=True)


def exception(said: Said) -> About | None:
    """Read when something is not to be that was asked for; None where it may be a wish."""
    skipped = said.after("skipping")
    denied = None if skipped is not None else said.after("denying")
    rest = skipped or denied or said.after("dropping")
    if rest is None or not rest.words or rest.places:
        return None
    time, thing = _clock_and_thing(rest) or _day_and_thing(rest)
    # "Not on friday" and "no swimming today", but "no, today"
    corrects = said.forms[0] == "no" and not thing.words
    if not time or rest.forms[0] == "," or corrects:
        return None
    names = frozenset() if thing.is_in("last") else thing.names
    # "Cancel the gym on friday" may be to be done then, and "skip rope" is.
    certain = not thing.words and (skipped is not None or denied is not None)
    # "Cancel today" is of all that is then.
    whole = not thing.words and skipped is None and denied is None
    return About(kind=AboutKind.EXCEPT, names=names, time=time, everything=whole, certain=certain)


def _clock_and_thing(said: Said) -> tuple[str, Said] | None:
    """Give the hour at which something is not to be, and what that is: "the noon tablets"; None for none."""
    opened = said.forms[0] in said.lexicon.closed.noun_openers
    for end in range(min(LONGEST_CLOCK + 1, len(said.words) - 1), 1 if opened else len(said.words), -1):
        clock, thing = said.until(end).behind(1), said.behind(end)
        time = one_time(f"{AT}{clock.text}", said.now, said.lexicon)
        # "The two tablets" are counted.
        told = time is not None and time.constraint is Constraint.AT and time.grain in CLOCKED
        if told and not clock.as_number() and thing.names and not thing.has_time:
            return f"{AT}{clock.text}", thing
    return None


def _day_and_thing(said: Said) -> tuple[str, Said]:
    """Give the one day, or part of one, that is named, and what it is of: "tomorrow's walk"."""
    forms, text = said.forms, said.text
    owner = next((n for n, word in enumerate(forms) if word.endswith(OF)), None)
    if owner is not None:
        word = said.words[owner]
        day = text[: word.start] + text[word.start : word.end].rstrip("s").rstrip("'’")
        if (time := _as_day(day, said)) and owner < LONGEST_DAY:
            thing = said.behind(owner + 1)
            return time, thing
    of, time = said.parted()
    if not said.has_time or not time:
        # "Cancel dinner" is of dinner, and not of its time.
        return "", said
    return _as_day(time, said), Said(of, said.now, said.lexicon)


def _as_day(text: str, said: Said) -> str:
    """Give a text where it is a day or a part of one, or several; else nothing."""
    bare = text.strip()
    bare = bare[len(FOR) :] if bare.lower().startswith(FOR) else bare
    time = Said(bare, said.now, said.lexicon).one_time()
    if time is None:
        return ""
    # "Not on fridays"
    days = time.constraint is Constraint.EVERY and time.recurrence is not None
    once = time.constraint is Constraint.BETWEEN and time.recurrence is None
    return bare if days or once else ""


def kept_free(said: Said) -> About | None:
    """Read for what time is kept; None where a thing is: "set the dough aside", "keep the door free"."""
    away, blocked, kept = (said.after(name) for name in ("being away", "blocking", "keeping free"))
    if away is not None:
        return _kept(away, away.behind(len(away.words)))
    if blocked is not None:
        place = (*blocked.forms, "for").index("for")
        return _kept(blocked.until(place), blocked.behind(place))
    for place in range(1, len(kept.words) if kept is not None else 0):
        behind = None if kept is None else kept.behind(place).after("kept free")
        if kept is not None and behind is not None:
            return _kept(kept.until(place), behind)
    return None


def _kept(stretch: Said, behind: Said) -> About | None:
    """Give what is said of a stretch of time, or of a length, that is kept for a thing."""
    thing = behind.behind(1).text if behind.forms[:1] == ("for",) else ""
    time = stretch.text if stretch.one_time() else stretch.as_time() if stretch.words else ""
    read = one_time(time, stretch.now, stretch.lexicon) if time else None
    if read is None or read.recurrence is not None:
        return None
    lasts = read.constraint is Constraint.FOR and bool(thing)
    until = read.preposition in {"until", "till"} and not thing
    if not (lasts or until or read.constraint is Constraint.BETWEEN):
        return None
    # What a part of a day is kept for may be anywhere in that.
    wish = f"{thing} {stretch.as_time()}" if thing and (lasts or read.grain in CLOCKED) else ""
    return About(kind=AboutKind.BLOCK, time=time, thing=thing, text=wish, certain=True)
