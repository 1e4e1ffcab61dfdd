"""What is asked for said anew: its words with another time in place of their own."""

import re
from collections.abc import Sequence
from dataclasses import replace
from datetime import datetime, timedelta
from itertools import combinations

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import Interpreted
from fuzzytime.language import find_times, reported
from fuzzytime.language.about_wishes import About, AboutKind, Said, in_its_place, merged_time, with_names
from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime.times import format_duration
from fuzzytime_cli.repl.bounds import bound_in
from fuzzytime_cli.repl.naming import called, part_meant, starts_of_entry, words_of_entry
from fuzzytime_cli.repl.parts import in_a_part, placed_at, untied, with_time_of_part
from fuzzytime_cli.repl.scene import Scene, check_sole, waiting
from fuzzytime_cli.repl.which import entries_meant
from fuzzytime_cli.session import Entry
from fuzzytime_cli.told_states import tells_what_is

IDLE = "rest"
"""What is done in a sentence of which only the time matters."""

SOME = 600.0
"""Seconds that vague words are where tables say nothing of them."""

DAY_SECONDS = 86400.0

FOR = "for "
"""What stands before a length of time."""

BE = "be"
"""The verb of what has only a name: "lunch at one"."""

BOUNDS = frozenset({Constraint.BEFORE, Constraint.AFTER})
"""What is asked for until, or from, a time."""

AT = re.compile(r"(^| )at ")
"""The preposition of a time that is no bound."""


def wished_instead(scene: Scene, words: str) -> str | None:
    """Give the command that says in the place of an instruction another: "forget that, call Ann at six".

    None where the words let nothing be, or wish for nothing behind that.

    Raises
    ------
    FuzzytimeError
        If several, or so many as there are not, are to be let be.
    """
    language = scene.language
    found = in_its_place(words, scene.now, language.lexicon)
    if found is None:
        return None
    about, wish = found
    if about.corrects and scene.told_last is not None:
        scene = replace(scene, focus=scene.told_last)
    meant = entries_meant(scene, about)
    if len(meant) != 1:
        return None
    old = [one.operation for one in scene.plan.everything if one.wish.identifier == meant[0].identifier]
    reading = language.read(wish, now=scene.now, given=old)
    asked = [one.operation for one in reading.instructions if one.operation is not None]
    told = wish.split()[0].lower() in language.lexicon.closed.condition_openers
    told = told or tells_what_is(reading, language.lexicon) or reported(reading, language.lexicon) is not None
    if told or not asked or asked[0].negated:
        # "Never mind, it works", "cancel the slides, Priya is doing them", "forget the soup, I've made some"
        return None
    part = part_meant(scene, meant[0].number, about.names)
    name = next((one.skill.name for _, one in waiting(scene) if one.identifier == part), "")
    wish = with_names(wish, next(iter(old), None), language.lexicon)
    if name:
        wish = in_a_part(scene, meant[0], name, wish)
    elif about.names and (len(old) > 1 or not about.names <= words_of_entry(scene, meant[0])):
        # "The soup is off, make a salad", of which more was asked for than the soup
        return None
    return f":edit {meant[0].number} {wish}" if wish else None


def with_time(
    scene: Scene,
    entry: Entry,
    about: About,
    own: Sequence[TimeRequirement] | None = None,
    part: str | None = None,
) -> str:
    """Give an entry's words with another time, or length, in place of its own; of several, of those given.

    A number alone ("make it six") counts what the entry counts: six minutes where it has ten of them. Of
    several things that an entry asks for, ``part`` labels the one that is meant.

    Raises
    ------
    FuzzytimeError
        If it has several.
    """
    about = replace(about, time=_by_name(scene, entry, about.time))
    said = find_times(about.time, scene.now, scene.lexicon).requirements
    if [one.constraint for one in said] == [Constraint.FOR] and said[0].span == (0, len(about.time)):
        # "Half an hour for the call"
        about = replace(about, time=f"{FOR}{about.time.removeprefix(FOR)}")
    if part is not None:
        return with_time_of_part(scene, entry, about.time, part)
    mine = [one for one in scene.plan.everything if one.wish.identifier == entry.identifier]
    if len(mine) == 1 and mine[0].told_by:
        # "They are ten minutes late" has no time of its own to be replaced.
        return f"{mine[0].skill.name} {about.time} instead"
    reading = scene.language.read(entry.text, now=entry.given)
    every = [part for one in reading.instructions for part in one.requirements]
    parts = every if own is None else own
    if about.number and len(parts) == 1:
        recounted = _recounted(scene, entry, parts[0], about.number)
        if recounted:
            return recounted
    length = about.time.lower().startswith(FOR)
    if length:
        check_sole(scene, entry.number, about.time[len(FOR) :])
    times = _replaced(scene, parts, about.time)
    if not times:
        # How long it is to be watered says nothing of for how long it is dry, in "water it if it's dry".
        clauses = [p.span[0] for p in parts if p.condition is not None or p.anchor is not None]
        end = min((first for first in clauses if first), default=len(entry.text.rstrip(".! ")))
        return f"{entry.text[:end].rstrip(' ,')} {about.time} {entry.text[end:]}".rstrip()
    first, end = times[0].span
    lexicon = scene.lexicon
    time = merged_time(*_time_before(scene, entry, entry.text[first:end]), about.time, scene.now, lexicon)
    repeated = times[0].constraint is Constraint.EVERY and time == about.time
    if about.bare and times[0].constraint in BOUNDS and times[0].preposition and times[0].anchor is None:
        # "By seven", and then "make it eight", is by eight.
        time = AT.sub(rf"\1{times[0].preposition} ", time, count=1)
    if len(times) > 1 and (firmer := _without_vague(entry, times)) is not None:
        return with_time(scene, firmer, about)
    if len(times) > 1 or repeated:
        raise FuzzytimeError(f"instruction {entry.number} has several times: say it anew, with :edit")
    text = untied(scene, "".join(placed_at(scene, entry.text, (first, end), time)))
    return text if length else f"{text}{_length_lost(scene, entry, mine, text)}"


def _replaced(scene: Scene, parts: Sequence[TimeRequirement], time: str) -> list[TimeRequirement]:
    """Give those of an entry's times that another stands in the place of."""
    length = time.lower().startswith(FOR)
    times = [part for part in parts if (part.constraint is Constraint.FOR) is length]
    # "If it rains, close the window at six": the condition stays.
    times = [part for part in times if part.constraint is not Constraint.WHEN] or times
    if bound_in(scene, time) is None:
        return times
    # What is to be done by four, or after something else, and not before two
    return [part for part in times if part.constraint is not Constraint.BEFORE and not _follows(scene, part)]


def _follows(scene: Scene, part: TimeRequirement) -> bool:
    """Whether it says what something comes after: "after lunch", "after that"."""
    said = Said(part.text, scene.now, scene.lexicon).beside()
    return part.anchor is not None or (said is not None and said[1].is_in("last"))


def _without_vague(entry: Entry, times: Sequence[TimeRequirement]) -> Entry | None:
    """Give an entry with the one of its times that is not vague: "today at some point"; None for several."""
    vague = [part for part in times if part.constraint is Constraint.VAGUE]
    if len(vague) != len(times) - 1:
        return None
    text = entry.text
    for first, end in sorted((one.span for one in vague), reverse=True):
        text = f"{text[:first].rstrip()}{text[end:]}"
    return replace(entry, text=text)


def _by_name(scene: Scene, entry: Entry, time: str) -> str:
    """Give a time with the name of what has only its label in it, or "that": "after s1", "before that"."""
    beside = Said(time, scene.now, scene.lexicon).beside()
    if beside is None or not (beside[1].label or beside[1].is_in("last")):
        return time
    last = scene.focus if scene.focus != entry.number else None
    label = beside[1].label or (called(scene, last) if last is not None else None)
    other = next((one for one in scene.plan.everything if one.identifier == label), None)
    if other is None or other.operation is None:
        return time
    operation = other.operation
    names = operation.object if other.stated and operation.lemma != BE else other.skill.name
    return f"{time.removesuffix(beside[1].text)}{names or other.skill.name}"


def _length_lost(scene: Scene, entry: Entry, mine: Sequence[Interpreted], text: str) -> str:
    """Give how long goes on what other words say no length of: "move it to five", of "from two to four"."""
    known = mine[0].instruction if len(mine) == 1 else None
    if known is None or known.duration is None:
        return ""
    state = scene.conversation.state.with_changed(entry.number, text=text, given=scene.now)
    anew = scene.conversation.understood(scene.now, state).everything
    instructions = [one.instruction for one in anew if one.wish.identifier == entry.identifier]
    lost = bool(instructions) and all(one is None or one.duration is None for one in instructions)
    return f" for {format_duration(known.duration)}" if lost else ""


def _time_before(scene: Scene, entry: Entry, words: str) -> tuple[str, datetime]:
    """Give the time that an entry has so far, and when that was said: it may be put off."""
    starts = starts_of_entry(scene, entry) if entry.moved_by else []
    if len(starts) != 1:
        return words, entry.given
    (start,) = starts
    day = "" if start.date() == scene.now.date() else f" on {start:%Y-%m-%d}"
    return f"at {start:%H:%M}{day}", scene.now


def days_on(scene: Scene, entry: Entry, days: int) -> str:
    """Give an entry's words with a day that lies so many days behind the one that it has.

    Raises
    ------
    FuzzytimeError
        If it has no day, or several times.
    """
    starts = starts_of_entry(scene, entry)
    if not starts:
        raise FuzzytimeError(f"instruction {entry.number} has no day: say it anew, with :edit")
    day = min(starts) + timedelta(days=days)
    if day.date() < scene.now.date():
        raise FuzzytimeError(f"that would be on {day:%A}, which is over")
    return with_time(scene, entry, About(kind=AboutKind.MOVE, time=f"on {day:%Y-%m-%d}"))


def some_time(scene: Scene, words: str) -> float:
    """Give how long vague words are, in seconds: "a bit later" is from when it fully satisfies."""
    skill = scene.conversation.interpreter.skill(f"{IDLE} {words}", now=scene.now)
    begin = skill.satisfaction.best.low
    return begin if 0.0 < begin < DAY_SECONDS else SOME


def _recounted(scene: Scene, entry: Entry, time: TimeRequirement, number: str) -> str:
    """Give an entry's words with another number of units in its time; empty where it counts none."""
    if time.number is None or time.unit is None:
        return ""
    start, end = time.span
    breaks = [at for at in range(start, end + 1) if at in {start, end} or entry.text[at] == " "]
    # The shortest words that say the length: without a preposition, or a hedge.
    for first, last in sorted(combinations(breaks, 2), key=lambda pair: pair[1] - pair[0]):
        said = f"for {entry.text[first:last].strip()}"
        found = find_times(said, entry.given, scene.lexicon).requirements
        if len(found) == 1 and found[0].span == (0, len(said)) and _counts_alike(found[0], time):
            unit = time.unit.value + ("" if (number.lower(),) in scene.lexicon.conversation["one"] else "s")
            gap = " " if first > start else ""
            return f"{entry.text[:first]}{gap}{number} {unit}{entry.text[last:]}"
    return ""


def _counts_alike(one: TimeRequirement, other: TimeRequirement) -> bool:
    return one.constraint is Constraint.FOR and (one.number, one.unit) == (other.number, other.unit)
