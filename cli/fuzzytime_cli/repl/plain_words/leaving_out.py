"""What is not to be once, or on some days: "skip tomorrow's", "skip the noon tablets", "not on fridays"."""

from collections.abc import Callable
from dataclasses import replace
from datetime import datetime, timedelta

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import Interpreted
from fuzzytime.language import find_times
from fuzzytime.language.about_wishes import About, AboutKind, reworded
from fuzzytime.requirement import Constraint
from fuzzytime.times import instant_after
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.commands import anew
from fuzzytime_cli.repl.naming import entry_of, starts_of_entry, words_of_entry
from fuzzytime_cli.repl.scene import Reply, Scene, waiting
from fuzzytime_cli.repl.which import BESIDE, entries_meant
from fuzzytime_cli.repl.without import without_time
from fuzzytime_cli.session import Entry

Taken = Callable[[Scene, About], Reply | None]
"""What takes what is said of wishes as a command."""

DAY = timedelta(days=1)


def left_out(scene: Scene, about: About, taken: Taken) -> Reply | None:
    """Leave an occurrence of a repetition out, or what is done once then: "skip tomorrow's".

    Raises
    ------
    FuzzytimeError
        If nothing is planned then.
    """
    (time,) = find_times(about.time, scene.now, scene.lexicon).requirements[:1]
    if time.recurrence is not None:
        repeated = _repeated(scene, about)
        return _without(scene, about, repeated[-1], about.time) if repeated else None
    if time.constraint is Constraint.AT and time.t_spec is not None:
        return _left_out_at(scene, about, instant_after(scene.now, time.t_spec), taken)
    if time.earliest is None or time.latest is None:
        return None
    first, end = (instant_after(scene.now, side) for side in (time.earliest, time.latest))
    entries, repeated = _named(scene, about), _repeated(scene, about)
    if repeated:
        spoken_of = [entry for entry in repeated if entry.number == scene.focus]
        entry = (spoken_of or repeated)[-1]
        one_day = end - first <= DAY + timedelta(hours=1)
        return _without(scene, about, entry, f"on {first:%Y-%m-%d}" if one_day else about.time)
    then = [e for e in entries if any(first <= start < end for start in starts_of_entry(scene, e))]
    if not about.certain and not about.everything and not (entries and about.names):
        return None
    if then and about.everything:
        return taken(scene, replace(about, kind=AboutKind.DROP))
    if not then:
        raise FuzzytimeError(f"nothing that is planned is {about.time} (:list shows what is)")
    if about.names:
        # Only the gym of "gym at six and call mum at seven"; which of two is asked
        meant = about.names if len(entries) == 1 or len(then) > 1 else frozenset({then[0].identifier})
        return taken(scene, replace(about, kind=AboutKind.DROP, names=meant, time=""))
    raise FuzzytimeError("when then? Say: move it to tomorrow (or: cancel it)")


def _left_out_at(scene: Scene, about: About, at: datetime, taken: Taken) -> Reply | None:
    """Leave out what is planned at an hour: "skip the noon tablets", of those at eight, noon and six.

    Raises
    ------
    FuzzytimeError
        If nothing that is named is planned then, or several are.
    """
    schedule = scene.plan.schedule
    named = {entry.identifier: entry for entry in _named(scene, about)}
    then = [
        one
        for place, one in waiting(scene)
        if one.wish.identifier in named
        and scene.plan.has_time(place)
        and abs(scene.plan.instant(schedule.start_times[place]) - at) <= BESIDE
    ]
    if not named:
        return None
    if len(then) != 1:
        raise FuzzytimeError(f"{len(then) or 'none'} of those is planned {about.time} (:list shows what is)")
    entry = named[then[0].wish.identifier]
    if repeats(then[0]):
        return _without(scene, about, entry, about.time)
    others = [one for _, one in waiting(scene, entry.number) if one.skill.name == then[0].skill.name]
    if len(others) == 1:
        return taken(scene, About(kind=AboutKind.DROP, names=frozenset({then[0].identifier}), certain=True))
    own = then[0].instruction.requirements if then[0].instruction is not None else ()
    span = next((part.span for part in own if part.constraint is Constraint.AT), (0, 0))
    return _said(scene, about, entry, without_time(scene, entry, span))


def _named(scene: Scene, about: About) -> list[Entry]:
    return [e for e in scene.conversation.state.entries if about.names <= words_of_entry(scene, e)]


def _repeated(scene: Scene, about: About) -> list[Entry]:
    """Give the entries that are named, and of something done again and again."""
    named = _named(scene, about)
    return [entry for entry in named if any(repeats(one) for _, one in waiting(scene, entry.number))]


def next_left_out(scene: Scene, about: About) -> Reply | None:
    """Leave out the next one of a repetition: "skip the next one"; None where what is next is done once.

    Raises
    ------
    FuzzytimeError
        If there are others on its day, as only days can be left out.
    """
    meant = entries_meant(scene, about)
    if not meant or not any(repeats(one) for _, one in waiting(scene, meant[0].number)):
        return None
    entry = meant[0]
    days = sorted(start.date() for start in starts_of_entry(scene, entry))
    if days.count(days[0]) > 1:
        raise FuzzytimeError(
            f"one of several on a day cannot be left out: cancel all of {entry.text!r}, or say it anew"
        )
    return _without(scene, about, entry, f"on {days[0]:%Y-%m-%d}")


def _without(scene: Scene, about: About, entry: Entry, out: str) -> Reply:
    """Say a repetition anew, without some days."""
    return _said(scene, about, entry, f"{entry.text.rstrip('.! ')} except {out}")


def _said(scene: Scene, about: About, entry: Entry, text: str) -> Reply:
    reply = anew.reworded(scene, entry.number, text)
    head = Text(plain(f"taken as :edit {entry.number} {text}; :undo takes it back"))
    return replace(reply, lines=(head, *reply.lines), focus=entry.number, taken=about)


def left_out_then(scene: Scene, about: About) -> Reply | None:
    """Do once on another day what was left out just before: "not this monday", "do it on tuesday"."""
    last = scene.taken is not None and scene.taken.kind is AboutKind.EXCEPT
    if (
        not last
        or about.kind is not AboutKind.MOVE
        or about.names
        or not about.time
        or scene.tried is not None
    ):
        return None
    entry = entry_of(scene, frozenset())
    repeated = [] if entry is None else [one for _, one in waiting(scene, entry.number) if repeats(one)]
    if entry is None or not repeated or repeated[0].instruction is None:
        return None
    every = (p for p in repeated[0].instruction.requirements if p.constraint is Constraint.EVERY)
    once = scene.language.read(entry.text[: next(every).span[1]], now=entry.given)
    anew = reworded(once, scene.lexicon, time=about.time, now=scene.now)
    if anew is None:
        return None
    asked = scene.language.read(anew, now=scene.now).instructions
    if any(part.constraint is Constraint.EVERY for one in asked for part in one.requirements):
        # "Not tomorrow", and then "at eleven", is of all that are left.
        return None
    said = {part.constraint for part in find_times(about.time, scene.now, scene.lexicon).requirements}
    if said == {Constraint.FOR} or not any(one.operation is not None for one in asked):
        # "Not on sundays", and then "it takes five minutes", is of all that are left, too.
        return None
    return Reply((Text(plain(f"taken as: {anew}")),), anew=anew)


def repeats(one: Interpreted) -> bool:
    """Whether something is done again and again."""
    return one.instruction is not None and any(
        part.constraint is Constraint.EVERY for part in one.instruction.requirements
    )
