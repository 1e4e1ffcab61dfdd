"""What is told of something planned, as the order that follows from it: "the vet can only see us at five"."""

from datetime import datetime

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import find_times
from fuzzytime.language.about_wishes import About, AboutKind, Said, about_wishes, of_planned
from fuzzytime.requirement import Constraint
from fuzzytime.times import instant_after
from fuzzytime_cli.repl.naming import called, entry_of, part_meant
from fuzzytime_cli.repl.plain_words.known import is_known, verbs_of
from fuzzytime_cli.repl.scene import Scene, waiting
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
    orders = of_planned(
        Said(clause, scene.now, scene.lexicon),
        lambda thing: thing.forms[:1] != (TO,) and is_known(scene, thing, told=False),
        lambda thing, word: word in verbs_of(scene, thing.names),
    )
    lasts = Said(orders[0], scene.now, scene.lexicon).length() if len(orders) > 1 else None
    new = None if lasts is None else lasts.seconds
    return ". ".join(_as_planned(scene, order, new) for order in orders) or None


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
