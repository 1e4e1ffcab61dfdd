"""All that is left, or a part of it: "everything from lunch on by ten minutes", "cancel everything else"."""

from dataclasses import replace

from fuzzytime.language.about_wishes.about import About, AboutKind
from fuzzytime.language.about_wishes.lengths import DIRECTIONS, counted
from fuzzytime.language.about_wishes.meant import named_in
from fuzzytime.language.about_wishes.said import FROM, Said

EVERYTHING = "everything"
"""The table of what stands for all that is left."""

SIDES = frozenset({"after", "before"})

FROM_ON = FROM.strip()
"""What stands in front of the first of those that are meant."""

BY = "by"


def every(kind: AboutKind, said: Said) -> About | None:
    """Read which of all that is left are meant: "all but the call", "everything from lunch on"; else None."""
    for place in (n for n in range(1, len(said.words) - 1) if said.forms[n] == "and"):
        behind, first = every(kind, said.behind(place + 1)), said.until(place)
        if behind is not None and behind.joint == "after" and not behind.others and first.names:
            # "Lunch and everything after it"
            return replace(behind, others=first.names, joint=FROM_ON)
    taken = said.opens_with(EVERYTHING)
    if not taken:
        return None
    # "The rest" is all but what was spoken of.
    other, tail = said.until(taken).is_in("all else"), said.behind(taken)
    about = About(kind=kind, everything=True, other=other, certain=True)
    if not tail.words:
        return about
    if (kept := tail.after("except")) is not None:
        return replace(about, names=named_in(kept)) if kept.names else None
    time = tail.text if tail.one_time() is not None else ""
    onwards = tail.without_end(tail.table("onwards"))
    if tail.forms[0] == FROM_ON and onwards != tail and onwards.names:
        return replace(about, others=onwards.behind(1).names, joint=FROM_ON, time=time)
    beside, side = tail.beside(), tail.lexicon.clauses.get(tail.forms[:1])
    if beside is not None and side in SIDES and (beside[1].names or beside[1].is_in("last")):
        return replace(about, others=named_in(beside[1]), joint=side, time=time)
    return replace(about, time=time) if time else None


def every_shifted(said: Said) -> About | None:
    """Read how much later, or earlier, all that is left is to be, or a part of it; None where none is."""
    delaying = said.after("delaying")
    moving = bool(said.forms) and said.forms[0] in said.lexicon.rescheduling
    done = bool(said.forms) and said.forms[0] in said.lexicon.doing.spending
    rest = delaying or (said.behind(1) if moving or done else said)
    ends = [n for n in range(1, len(rest.words)) if rest.behind(n).opens_with("except")]
    if not any(rest.behind(n).opens_with(EVERYTHING) for n in range(len(rest.words))):
        return None
    moves = moving or delaying is not None
    for end in (len(rest.words), *ends):
        found = [one for place in range(1, end) if (one := _shifted_at(rest, place, end, moving=moves))]
        # "Everything before half past one | half an hour earlier": the whole time
        timed = [one for one in found if one.time and one.by is not None]
        if found:
            return timed[-1] if timed else found[0]
    return None


def _shifted_at(rest: Said, place: int, end: int, *, moving: bool) -> About | None:
    """Read what moves up to a place, and behind the end of how far, and how far it moves between them."""
    whole = f"{rest.until(place).text} {rest.behind(end).text}".strip()
    about = every(AboutKind.DELAY, Said(whole, rest.now, rest.lexicon))
    shift = None if about is None else _shift(rest.until(end).behind(place), moving=moving)
    # "Push it all back": by how much is not said
    return None if about is None or shift is None else replace(about, by=shift[0], earlier=shift[1])


def _shift(said: Said, *, moving: bool) -> tuple[float | None, bool] | None:
    """Give by how much words say that something moves, None for nobody knows, and whether that is earlier."""
    left, directions = said.without(*DIRECTIONS)
    earlier = "earlier" in directions and "later" not in directions
    if directions and not left.words:
        return None, earlier
    if not (moving or directions) or not left.words:
        return None
    # "Push everything by ten"
    alone = counted(left.behind(1) if left.forms[0] == BY else left)
    found = alone.length()
    if found is None or found.rest.words:
        return None
    return (-found.seconds if earlier else found.seconds), earlier
