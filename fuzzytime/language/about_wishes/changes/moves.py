"""Wishes that get another time: "push everything back by ten minutes", "move the call to six"."""

import re
from dataclasses import replace

from fuzzytime.language.about_wishes.about import About, AboutKind
from fuzzytime.language.about_wishes.changes.every import every
from fuzzytime.language.about_wishes.lengths import DIRECTIONS, REFERRED, minutes_alone
from fuzzytime.language.about_wishes.meant import about_thing, is_last
from fuzzytime.language.about_wishes.said import CLOCKED, Said
from fuzzytime.language.about_wishes.told.told_of import told_of
from fuzzytime.language.finding import find_times

OFF = frozenset({("off",)})


def delayed(said: Said) -> About | None:
    """Read what is moved by a length, or only back or forward: "push the call back by ten minutes"."""
    delaying, pausing = said.after("delaying"), said.after("pausing")
    # "Pause everything"; but "pause the film at eight"
    delaying = pausing if pausing is not None and pausing.opens_with("everything") else delaying
    rest = delaying if delaying is not None else said.behind(1)
    if delaying is None and said.forms[:1] and said.forms[0] not in said.lexicon.rescheduling:
        return None
    if delaying is not None and not rest.words:
        return About(kind=AboutKind.DELAY, certain=True)
    towards = any(f" {joint}" in f" {rest.text.lower()}" for joint in said.towards)
    if towards or not rest.words or not rest.is_one:
        return None
    thing, directions = rest.without(*DIRECTIONS)
    slight = thing.ends_with("slightly") if directions else 0
    slid = thing.until(len(thing.words) - slight)
    if slight and (is_last(slid) or slid.names):
        # "Move it a bit later", "push the call back a bit"
        text = f"{' '.join(thing.forms[-slight:])} later"
        earlier = "later" not in directions
        about = about_thing(AboutKind.DELAY, slid, certain=is_last(slid))
        return replace(about, text=text, earlier=earlier)
    # "Push it all back" says no length.
    whole = thing.is_in("everything") or is_last(thing)
    found = None if whole else thing.length() or minutes_alone(thing, directed=bool(directions))
    if found is None:
        if thing.has_time or (delaying is None and not directions):
            return None
    elif delaying is None and (
        found.joint == "for" or not (directions or said.forms[0] in said.lexicon.moving)
    ):
        # "Put the meat back for ten minutes"
        return None
    earlier = "earlier" in directions and "later" not in directions
    by = None if found is None else -found.seconds if earlier else found.seconds
    moved = thing if found is None else found.rest
    named, referred = moved.without(*REFERRED)
    if moved.is_in("both") or ("everything" in referred and not named.names):
        every = not moved.is_in("both")
        return About(
            kind=AboutKind.DELAY, both=not every, everything=every, by=by, earlier=earlier, certain=True
        )
    if not named.names and not referred and (delaying is None or named.words):
        return None
    # Who pushes a table back says no length of time.
    certain = delaying is not None or (found is not None and found.joint == "by")
    return replace(about_thing(AboutKind.DELAY, named, certain=certain), by=by, earlier=earlier)


def moved(said: Said) -> About | None:
    """Read a new time for what has one: "move the call to six", "Ann can only do four"."""
    if (able := _able(said) or told_of(said)) is not None:
        return able
    delaying = said.after("delaying")
    if delaying is None and said.forms[:1] and said.forms[0] not in said.lexicon.rescheduling:
        return None
    behind = (delaying or said.behind(1)).text
    joint = next((to for to in said.towards if f" {to}" in f" {behind.lower()}"), "")
    if not joint:
        if delaying is not None:
            return _moved_at(said, behind)
        return _moved_somewhen(said)
    places = [found.start() for found in re.finditer(f" {joint}", f" {behind.lower()}")]
    # "To quarter to six" is one time.
    times = (place for place in places if Said(behind[place:].strip(), said.now, said.lexicon).as_time())
    place = next(times, places[-1])
    thing = Said(behind[:place].rstrip(), said.now, said.lexicon)
    # "Move s2 up to nine"
    thing = thing.without_end(said.table("later") | said.table("earlier"))
    # "Put the gutters off till friday"
    thing = thing.without_end(OFF) if said.forms[0] == "put" else thing
    new = Said(behind[place:].strip(), said.now, said.lexicon)
    if not thing.words:
        return None
    meant = About(kind=AboutKind.MOVE, everything=True, certain=True) if thing.is_in("both") else None
    if (meant := meant or every(AboutKind.MOVE, thing)) is not None:
        # "Move everything after three to tomorrow" keeps the hours.
        day = new.one_time() or Said(new.as_time(), said.now, said.lexicon).one_time()
        text = new.as_time() if day is not None and day.grain not in {None, *CLOCKED} else ""
        return replace(meant, text=text)
    about = about_thing(AboutKind.MOVE, thing)
    if not (about.names or about.places or about.upcoming) and not is_last(thing):
        return None
    if time := new.as_time():
        # "Move the essay to tomorrow", of which nobody knows, is no errand.
        certain = said.forms[0] in said.lexicon.moving and not thing.has_time
        return replace(about, time=time, bare=new.is_bare(time), certain=certain or about.certain)
    beside = Said(new.text[len(joint) :], said.now, said.lexicon).beside()
    return None if beside is None else replace(about, time=beside[0], others=beside[1].names)


def _able(said: Said) -> About | None:
    """Read when somebody can do what was asked for: "they can only do four", "Ann can make it at one"."""
    for place in range(1, len(said.words) if said.is_one else 0):
        who, told = said.until(place), said.behind(place).after("saying")
        rest = told or said.behind(place).after("able at")
        time = rest.as_time() if rest is not None and rest.words else ""
        # "Well she can make it at one"
        front, they = who.until(len(who.words) - 1), who.behind(len(who.words) - 1).is_in("they")
        # "Well she can make it at one"; but "ask Bob if he can come at one"
        last = who.without_exclamations().is_in("they") or (they and front.ends_with("saying") > 0)
        last = last or who.is_in("speaker")
        if they and not last:
            continue
        if rest is not None and time and (last or who.names):
            names, sure = frozenset() if last else who.names, last or told is None
            return About(kind=AboutKind.MOVE, names=names, time=time, bare=rest.is_bare(time), certain=sure)
    return None


def _moved_somewhen(said: Said) -> About | None:
    """Read what is to be moved, where when to is not said: "move the gym"."""
    thing = said.behind(1)
    named = bool(thing.names) or is_last(thing)
    known = said.forms[0] in said.lexicon.moving and thing.is_one and thing.words and not thing.has_time
    # "Put the soup on"
    known = known and named and thing.forms[-1] not in said.lexicon.particles
    return replace(about_thing(AboutKind.UNABLE, thing), told=True) if known else None


def _moved_at(said: Said, behind: str) -> About | None:
    """Read a new time that stands without a word between: "postpone the call tomorrow"."""
    found = find_times(behind, said.now, said.lexicon).requirements[-1:]
    if not found:
        return None
    first = found[0].span[0]
    thing = Said(behind[:first].rstrip(), said.now, said.lexicon)
    time = Said(behind[first:], said.now, said.lexicon).as_time()
    if not thing.words:
        # "Reschedule for friday"
        return About(kind=AboutKind.MOVE, time=time, certain=True) if time else None
    return replace(about_thing(AboutKind.MOVE, thing), time=time) if time else None
