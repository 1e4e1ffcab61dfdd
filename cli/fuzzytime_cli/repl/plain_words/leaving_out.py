"""What is not to be once, or on some days: "skip tomorrow's", "not on fridays", "skip the next one"."""

from collections.abc import Callable
from dataclasses import replace
from datetime import timedelta

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
from fuzzytime_cli.repl.which import entries_meant
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
    (entry,) = entries_meant(scene, about)
    if not any(repeats(one) for _, one in waiting(scene, entry.number)):
        return None
    days = sorted(start.date() for start in starts_of_entry(scene, entry))
    if days.count(days[0]) > 1:
        raise FuzzytimeError(
            f"one of several on a day cannot be left out: cancel all of {entry.text!r}, or say it anew"
        )
    return _without(scene, about, entry, f"on {days[0]:%Y-%m-%d}")


def _without(scene: Scene, about: About, entry: Entry, out: str) -> Reply:
    """Say a repetition anew, without some days."""
    text = f"{entry.text.rstrip('.! ')} except {out}"
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
    if anew is None or any(
        part.constraint is Constraint.EVERY
        for one in scene.language.read(anew, now=scene.now).instructions
        for part in one.requirements
    ):
        # "Not tomorrow", and then "at eleven", is of all that are left.
        return None
    return Reply((Text(plain(f"taken as: {anew}")),), anew=anew)


def repeats(one: Interpreted) -> bool:
    """Whether something is done again and again."""
    return one.instruction is not None and any(
        part.constraint is Constraint.EVERY for part in one.instruction.requirements
    )
