"""What is told of something planned, as the order that follows from it: "the vet can only see us at five"."""

from collections.abc import Sequence
from datetime import datetime

from fuzzytime.english import is_participle
from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import find_times, verb_forms
from fuzzytime.language.about_wishes import (
    About,
    AboutKind,
    Said,
    about_wishes,
    goes_on_until,
    of_planned,
    open_hours,
    opening_correction,
)
from fuzzytime.requirement import Constraint
from fuzzytime.times import format_duration, instant_after
from fuzzytime_cli.repl.conversation import exactly
from fuzzytime_cli.repl.naming import called, entry_of, part_meant, words_of_entry
from fuzzytime_cli.repl.plain_words.known import is_known, verbs_of
from fuzzytime_cli.repl.plain_words.leaving_out import repeats
from fuzzytime_cli.repl.plain_words.telling import is_news
from fuzzytime_cli.repl.scene import Scene, is_for_others, waiting
from fuzzytime_cli.session import Entry

TO, BEFORE = "to", "before "

IT = " it "
"""What was spoken of last, in an order."""


def order_told(scene: Scene, clause: str) -> str | None:
    """Give the orders that follow from what a clause tells of something planned; None where nothing is told.

    Raises
    ------
    FuzzytimeError
        If what "it" is cannot be told from what it is to come before, or after.
    """
    said = Said(clause, scene.now, scene.lexicon)
    if event := _of_event(scene, said):
        return event
    if bounded := _of_open_hours(scene, said):
        return bounded
    if ending := _of_end(scene, said):
        return ending
    orders = of_planned(
        said,
        lambda thing: thing.forms[:1] != (TO,) and is_known(scene, thing, told=False),
        lambda thing, word: word in verbs_of(scene, thing.names),
    )
    if any(form in scene.lexicon.closed.anaphors for form in said.forms):
        _check_whose(scene, orders)
    lasts = Said(orders[0], scene.now, scene.lexicon).length() if len(orders) > 1 else None
    new = None if lasts is None else lasts.seconds
    return ". ".join(_as_planned(scene, order, new) for order in orders) or None


def _of_event(scene: Scene, clause: Said) -> str:
    """Give the event that others come before, or after, with the time that is told of it by its verb.

    Of "half an hour before closing" that is "closing is at six" where it is said that "we close at six".
    """
    told = clause.behind(opening_correction(clause)).without_exclamations()
    anchors = (part.anchor for one in scene.plan.everything for part in one.requirements)
    events = {anchor.text.split()[-1] for anchor in anchors if anchor is not None}
    for place in range(1, len(told.words) - 1):
        time = told.behind(place + 1).as_time()
        bare = told.behind(place + 1).one_time() is not None and not time.lower().startswith("for ")
        verb = told.forms[place].removesuffix("s")
        named = (one for one in events if is_participle(one) and one in verb_forms(verb, scene.lexicon))
        if time and bare and (event := next(named, None)) is not None:
            return f"{event} is {time}"
    return ""


def _check_whose(scene: Scene, orders: Sequence[str]) -> None:
    """Refuse to bound what others do by what they want of something: "the customer wants it before three".

    Raises
    ------
    FuzzytimeError
        If that is told of one who comes.
    """
    for about in (about_wishes(order, scene.now, scene.lexicon) for order in orders):
        entry = None if about is None or not about.names else entry_of(scene, about.names)
        mine = [] if entry is None else [one for _, one in waiting(scene, entry.number)]
        comes = any(map(is_for_others, mine))
        read = find_times("" if about is None else about.time, scene.now, scene.lexicon).requirements
        if comes and about is not None and any(one.constraint is Constraint.BEFORE for one in read):
            raise FuzzytimeError(f"what is to be {about.time} is not said: say it with its name")


def _of_open_hours(scene: Scene, clause: Said) -> str:
    """Give the orders for all that is to be done where it is open only then; empty where nothing is."""
    where, bound = open_hours(clause) or (None, "")
    if where is None or is_news(scene, clause.text):
        return ""
    names, place = where.names, where.forms[-1:] in where.table("belonging")
    # "The feed store" is where feed is bought.
    tried = [names, names - frozenset(where.forms[-1:])] if place else [names]
    for named in tried if not where.is_in("last") else [frozenset[str]()]:
        last = entry_of(scene, frozenset()) if not named else None
        there = [
            one.identifier
            for one in scene.conversation.state.entries
            if (one == last if not named else named <= words_of_entry(scene, one))
            and any(not asked.stated for _, asked in waiting(scene, one.number))
        ]
        orders = [_bounded(scene, label, bound) for label in there]
        changes = [order for order in orders if order.startswith("move")]
        if orders:
            return ". ".join(changes or orders[:1])
    return ""


def _bounded(scene: Scene, label: str, bound: str) -> str:
    """Give the order by which something is done while it is open: what has its time, right before the end."""
    order = _as_planned(scene, f"move {label} to {bound}", None)
    (read,) = find_times(bound, scene.now, scene.lexicon).requirements[:1]
    mine = [one for _, one in waiting(scene) if one.identifier == label]
    if not order.startswith("move") or read.constraint is not Constraint.BEFORE or len(mine) != 1:
        return order
    end = read.t_spec if read.latest is None else read.latest
    start = None if end is None else instant_after(scene.now, end - mine[0].skill.time_until_done)
    timed = any(told.constraint is Constraint.AT for told in mine[0].requirements)
    return f"move {label} to {exactly(start)}" if timed and start is not None and start > scene.now else order


def _of_end(scene: Scene, clause: Said) -> str:
    """Give the order by which something goes on until the time that is told; empty where none is known.

    Raises
    ------
    FuzzytimeError
        If it is done again and again.
    """
    what, time = goes_on_until(clause) or (None, "")
    if what is None or not is_known(scene, what, told=False):
        return ""
    entry = entry_of(scene, what.meant)
    part = None if entry is None else part_meant(scene, entry.number, what.meant)
    mine = [] if entry is None else waiting(scene, entry.number)
    if entry is not None and any(repeats(one) for _, one in mine):
        raise FuzzytimeError(
            f"{entry.text!r} is done again and again: say it anew, with :edit {entry.number}"
        )
    label = part or (mine[0][1].identifier if len(mine) == 1 else "")
    starts = [_end_of(scene, place, 0.0) for place, one in mine if one.identifier == label]
    if len(starts) != 1 or starts[0] is None:
        return ""
    # "Half past nine" is the next one once practice has begun.
    (read,) = find_times(time, starts[0], scene.lexicon).requirements[:1]
    return f"make {label} {format_duration(read.t_spec)}" if read.t_spec else ""


def _as_planned(scene: Scene, order: str, lasts: float | None) -> str:
    """Give an order with the names of what "it" is; what is planned so already is only shown.

    ``lasts`` is how long it takes from now on, where that was told as well.

    Raises
    ------
    FuzzytimeError
        If what "it" is cannot be told from what it is to come before, or after.
    """
    about = about_wishes(order, scene.now, scene.lexicon)
    if about is None or about.kind is not AboutKind.MOVE or not about.time:
        return order
    named = Said(about.time, scene.now, scene.lexicon).beside()
    entry, beside = entry_of(scene, about.names), None
    if named is not None and is_known(scene, named[1], told=False):
        beside = entry_of(scene, named[1].meant)
    if named is not None and beside is not None and named[1].is_in("last"):
        # "So groceries before that"
        order = f"{order.removesuffix(named[1].text)}{beside.identifier}"
    if not about.names and beside is not None and entry == beside:
        # "He has to be back before the viewing", which was spoken of last
        others = [e for e in scene.conversation.state.entries if e != beside and called(scene, e.number)]
        if len(others) != 1:
            raise FuzzytimeError(f"what is to be {about.time} is not said: say it with its name")
        entry, order = others[0], order.replace(IT, f" {others[0].identifier} ", 1)
    if entry is not None and _is_so(scene, entry, about, beside, lasts):
        return f"when is {entry.identifier}"
    return order


def _is_so(scene: Scene, entry: Entry, about: About, beside: Entry | None, lasts: float | None) -> bool:
    """Whether what has a time of its own is over by then anyway: homework at four is done before tea."""
    read = find_times(about.time, scene.now, scene.lexicon).requirements[:1]
    if beside is None and (not read or read[0].constraint is not Constraint.BEFORE):
        return False
    if beside is not None and not about.time.lower().startswith(BEFORE):
        return False
    part = part_meant(scene, entry.number, about.names)
    mine = [(n, one) for n, one in waiting(scene, entry.number) if part in {None, one.identifier}]
    ends = [
        end
        for place, one in mine
        if any(told.constraint is Constraint.AT for told in one.requirements)
        and (end := _end_of(scene, place, lasts or one.skill.time_until_done)) is not None
    ]
    if beside is None:
        bound = read[0].t_spec if read[0].latest is None else read[0].latest
        until = None if bound is None else instant_after(scene.now, bound)
    else:
        starts = [_end_of(scene, place, 0.0) for place, _ in waiting(scene, beside.number)]
        until = min((start for start in starts if start is not None), default=None)
    return bool(ends) and len(ends) == len(mine) and until is not None and max(ends) <= until


def _end_of(scene: Scene, place: int, lasts: float) -> datetime | None:
    """Give when something is planned to be over; None where it has no time."""
    planned = scene.plan.has_time(place)
    return (
        instant_after(scene.plan.instant(scene.plan.schedule.start_times[place]), lasts) if planned else None
    )
