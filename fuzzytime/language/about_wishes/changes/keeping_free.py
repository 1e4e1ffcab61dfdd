"""Time that is kept for something, or for nothing: "block four to five for email", "keep friday free"."""

from fuzzytime.language.about_wishes.about import About, AboutKind
from fuzzytime.language.about_wishes.said import CLOCKED, Said, one_time
from fuzzytime.requirement import Constraint


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
