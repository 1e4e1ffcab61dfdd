"""What is said about wishes, as a value."""

from dataclasses import dataclass
from enum import StrEnum

AT_ONCE = "right now"
"""The time of what is to be done at once, or has begun."""

AT_FIRST = "as soon as possible"
"""The time of what is to be done before all else."""

AT_LAST = "last"
"""The time of what is to be done behind all else."""


class AboutKind(StrEnum):
    """What is said of them."""

    DROP = "drop"
    MOVE = "move"
    DELAY = "delay"
    SWAP = "swap"
    UNDO = "undo"
    REDO = "redo"
    DONE = "done"
    MORE = "more"
    TAKES = "takes"
    LATE = "late"
    STARTED = "started"
    UNSTARTED = "unstarted"
    UNABLE = "unable"
    WRONG = "wrong"
    NEXT = "next"
    ALL = "all"
    WHEN = "when"
    LASTING = "lasting"
    WHY = "why"
    CLOCK = "clock"
    SUPPOSE = "suppose"
    ANSWER = "answer"
    AGAIN = "again"
    LIKE = "like"
    INSTEAD = "instead"
    OTHER = "other"
    REVERSE = "reverse"
    STOP = "stop"
    EXCEPT = "except"
    FREE = "free"
    ROOM = "room"
    DID = "did"
    BESIDE = "beside"
    DURING = "during"
    ON_TIME = "on time"
    HOW = "how"
    BLOCK = "block"
    LEEWAY = "leeway"
    APART = "apart"


@dataclass(frozen=True, slots=True, kw_only=True)
class About:
    """What is said about something asked for.

    Parameters
    ----------
    kind
        What is said.
    names
        The words that name what is meant; none for what was spoken of last.
    each
        The words that name each of several things, where these are listed: "the call and the soup".
    others
        The words that name the second one, of what is swapped.
    places
        Which of those that are left to do are meant, counted from 1, or from the last, which is -1: "the
        second one", "the last two".
    several
        Whether all are meant that are named so: "the calls".
    everything
        Whether all is meant that is left to do, but for what is named, if anything is.
    both
        Whether the two that are left are meant.
    time
        The new time, or what comes before or after it, as it would be said with what is to be done.
    number
        The new time as it was said where that is a number alone ("make it six"), which may count what was
        counted before; else empty.
    bare
        Whether the new time was said without a preposition: what was to be done "by seven" is then so by it.
    by
        Seconds: by how much later, earlier (below 0), or longer; None where that is not said.
    text
        What is supposed: "what if I call mum at six" has "call mum at six"; how much later, where that is
        vague: "a bit later"; the kind of what somebody asks how to say; what one may be that is not free; or
        what there is to be room beside: "before the call".
    thing
        What stands in the place of something that was asked for, or is wished beside it: "the roses" of "same
        for the roses", "dad" of "no, dad".
    joint
        The word in front of it where it has one: "for".
    days
        By how many days the new time is later than the old one: "the day after"; 0 where it does not say so.
    earlier
        Whether what is to be later by nobody knows how much is to be earlier.
    other
        Whether the one is meant that is not the last: "the other one".
    upcoming
        Whether the one is meant that starts next.
    corrects
        Whether it corrects what was said before ("no, half past six"), whatever was answered since.
    told
        Whether it tells how something is, and asks for nothing: "the gym is off", of what is named itself.
    certain
        Whether nothing else can be meant; where it can, what names nothing that was asked for is a wish.
    """

    kind: AboutKind
    names: frozenset[str] = frozenset()
    each: tuple[frozenset[str], ...] = ()
    others: frozenset[str] = frozenset()
    places: tuple[int, ...] = ()
    several: bool = False
    everything: bool = False
    both: bool = False
    time: str = ""
    number: str = ""
    bare: bool = False
    by: float | None = None
    text: str = ""
    thing: str = ""
    joint: str = ""
    days: int = 0
    earlier: bool = False
    other: bool = False
    upcoming: bool = False
    corrects: bool = False
    told: bool = False
    certain: bool = False
