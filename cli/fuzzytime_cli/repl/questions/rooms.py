"""Questions about where there is room, for something or at all: "is there time for a nap before lunch?"."""

from collections.abc import Iterator
from dataclasses import replace
from datetime import datetime, timedelta

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import Interpreted
from fuzzytime.language.about_wishes import About, without_article
from fuzzytime.requirement import Constraint
from fuzzytime.times import format_duration
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.compared import moves
from fuzzytime_cli.repl.naming import entries_named, entry_of, part_meant, running_one, unknown
from fuzzytime_cli.repl.questions.stretches import bounds_of, time_of
from fuzzytime_cli.repl.questions.taken import SHORTEST, all_planned, all_taken, at
from fuzzytime_cli.repl.scene import Offer, Reply, Scene, said, waiting

MOST = 5
"""How many gaps are told at most."""


def room(scene: Scene, about: About) -> Reply:
    """Say whether something fits in before a time, or before something else."""
    length, assumed = length_of(scene, about.thing) if about.thing else (SHORTEST, False)
    if about.by is not None:
        length, assumed = timedelta(seconds=about.by), False
    since, until = scene.now, None
    if about.thing and about.names and not about.time and entry_of(scene, about.names) is None:
        return _as_tried(scene, about)
    if is_of_planned(scene, about):
        since, until = beside(scene, about)
    elif about.time:
        time = time_of(scene, about.time)
        first, end = bounds_of(scene, time)
        if time.constraint is Constraint.BEFORE or time.preposition in {"by", "before"}:
            until = end or first
        elif first is not None:
            since, until = max(since, first), end if end is not None and end > first else first + length
            until = None if time.constraint is Constraint.AFTER else until
    if not about.thing and about.by is None:
        return gaps_told(scene, since, until, about.joint)
    what = (
        f"{about.thing} ({_long(length)}{', assumed' if assumed else ''})" if about.thing else _long(length)
    )
    fitting = [gap for gap in _gaps(scene, since, until) if gap[1] is None or gap[1] - gap[0] >= length]
    if fitting:
        begin, over = fitting[0 if about.thing or about.joint != "before" else -1]
        yes = "" if about.upcoming else "yes: "
        told = said(f"{yes}{what} fits in at {at(scene, begin)}{_until(scene, over)}")
        lasting = f" for {_long(length)}" if about.by is not None else ""
        offer = Offer(_wish_for(scene, about.thing) + lasting, about.text)
        return replace(told, offer=offer if about.thing else offer_of(scene, begin, over))
    limit = "" if until is None else f" before {at(scene, until)}"
    return replace(said(f"no: {what} does not fit in{limit}"), offer=Offer())


def _as_tried(scene: Scene, about: About) -> Reply:
    """Say where something would be planned beside what only a wish can tell: "before it goes in".

    Raises
    ------
    FuzzytimeError
        If nothing tells that.
    """
    length = "" if about.by is None else f" for {_long(timedelta(seconds=about.by))}"
    thing = _wish_for(scene, about.thing) + length
    trial = scene.conversation.state.with_entries([f"{thing} {about.text}"], scene.now)
    plan = scene.conversation.plan(scene.now, trial, previous=scene.plan)
    name = trial.entries[-1].identifier
    own = [place for place, one in enumerate(plan.skills) if one.wish.identifier == name]
    parts = (part for place in own for part in plan.skills[place].requirements)
    if not any(part.anchor is not None and part.anchor.target is not None for part in parts):
        return unknown(about.names)
    if any(map(plan.has_time, own)) and not moves(scene.plan, plan, set()):
        begin = min(plan.instant(plan.schedule.start_times[place]) for place in own)
        return replace(said(f"yes: {thing} fits in at {at(scene, begin)}"), offer=Offer(thing, about.text))
    return replace(said(f"no: {thing} does not fit in {about.text}"), offer=Offer())


def is_of_planned(scene: Scene, about: About) -> bool:
    """Whether a question is of what is planned, and not of a time that is called so: "before lunch"."""
    known = all(entry_of(scene, names) is not None for names in (about.names, about.others) if names)
    return bool(about.names) and (known or not about.time)


def beside(scene: Scene, about: About) -> tuple[datetime, datetime | None]:
    """Give from when to when it is before something else, after it, or between two.

    Raises
    ------
    FuzzytimeError
        If there is no such thing, or it has no time.
    """
    start, end = _planned(scene, about.names)
    if about.others:
        first, second = sorted([(start, end), _planned(scene, about.others)])
        return max(scene.now, first[1]), second[0]
    return (max(scene.now, end), None) if about.joint == "after" else (scene.now, start)


def apart(scene: Scene, about: About) -> Reply:
    """Say how long it is between two things, or behind one until the next, and what is planned there."""
    first, over = beside(scene, about)
    taken = all_taken(scene)
    behind = next((one for one in taken if one.start >= first), None)
    over = over or (None if behind is None else behind.start)
    if over is None:
        return said(f"nothing is planned {plain(about.thing)}, from {at(scene, first)} on")
    if over < first:
        return said(f"no time: they overlap, from {at(scene, over)} to {at(scene, first)}")
    named = [one for one in taken if first <= one.start < over]
    beside_it = [f"with {one.title}, {at(scene, one.start)} to {at(scene, one.end)}" for one in named[:MOST]]
    told = said(f"{_long(over - first)}, from {at(scene, first)} to {at(scene, over)}")
    told = replace(told, lines=(*told.lines, *map(Text, beside_it)))
    return replace(told, offer=Offer() if named else offer_of(scene, first, over))


def _planned(scene: Scene, names: frozenset[str]) -> tuple[datetime, datetime]:
    """Give from when to when that is planned which some words name, or is running.

    Raises
    ------
    FuzzytimeError
        If there is no such thing, or it has no time.
    """
    running = running_one(scene, names)
    entry = entry_of(scene, names) or unknown(names)
    # The call that is planned is meant before one that waits.
    for number in dict.fromkeys([one.number for one in entries_named(scene, names)] + [entry.number]):
        part = part_meant(scene, number, names) if running is None else running.identifier
        left = {one.identifier for _, one in waiting(scene, number)}
        planned = [one for one in all_planned(scene) if one.identifier in left or one.number == number]
        mine = [one for one in planned if part in {None, one.identifier}]
        if mine:
            return mine[0].start, min(one.end for one in mine)
    raise FuzzytimeError("when that is, is not planned")


def offer_of(scene: Scene, begin: datetime, over: datetime | None) -> Offer:
    """Give a gap as what may be taken next."""
    if over is None:
        return Offer(time=f"after {at(scene, begin)}")
    return Offer(time=f"between {at(scene, begin)} and {at(scene, over)}")


def gaps_told(scene: Scene, since: datetime, until: datetime | None = None, joint: str = "") -> Reply:
    """Say when one is free from some time on, until another or until the day's last thing is over."""
    if not all_taken(scene) and until is None and since <= scene.now:
        return said("free all the time: nothing is planned")
    gaps = list(_gaps(scene, since, until))
    if not gaps:
        return said("not free then")
    told = [
        f"from {at(scene, begin)} on" if over is None else f"from {at(scene, begin)} to {at(scene, over)}"
        for begin, over in gaps
    ]
    kept = [*told[: MOST - 1], *told[-1:]] if len(told) > MOST else told
    nearest = gaps[-1] if joint == "before" else gaps[0] if joint or len(gaps) == 1 else None
    offer = Offer() if nearest is None else offer_of(scene, *nearest)
    return replace(said(f"free {', '.join(kept)}"), offer=offer)


def _gaps(
    scene: Scene, since: datetime, until: datetime | None
) -> Iterator[tuple[datetime, datetime | None]]:
    """Give the stretches in which nothing is planned; the last has no end where none is given."""
    begin = since
    for one in all_taken(scene):
        if until is not None and one.start >= until:
            break
        if one.start - begin >= SHORTEST:
            yield begin, one.start
        begin = max(begin, one.end)
    if until is None or until - begin >= SHORTEST:
        yield begin, until


def length_of(scene: Scene, thing: str) -> tuple[timedelta, bool]:
    """Give how long something takes, and whether that is assumed: "a nap", "call mum"."""
    one = _asked_for(scene, thing)
    return (
        (SHORTEST, True)
        if one is None
        else (timedelta(seconds=one[1].skill.duration), one[1].duration.assumed)
    )


def _wish_for(scene: Scene, thing: str) -> str:
    """Give how a thing is wished for: "have a nap", "call mum"."""
    one = _asked_for(scene, thing)
    return thing if one is None else one[0]


def _asked_for(scene: Scene, thing: str) -> tuple[str, Interpreted] | None:
    """Give how a thing is wished for, and what comes of that; None where it is not understood."""
    words = without_article(thing, scene.lexicon)
    for text in (words, f"have {words}"):
        trial = scene.conversation.state.with_entries([text], scene.now)
        made = scene.conversation.understood(scene.now, trial)
        name = trial.entries[-1].identifier
        own = [one for one in made.everything if one.wish.identifier == name and one.skill.duration > 0]
        if own:
            return text, own[-1]
    return None


def _long(length: timedelta) -> str:
    return format_duration(length.total_seconds())


def _until(scene: Scene, over: datetime | None) -> str:
    return "" if over is None else f", with room until {at(scene, over)}"
