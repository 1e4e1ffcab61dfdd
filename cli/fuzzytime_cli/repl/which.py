"""Which of what was asked for is meant, by names or places; asked where several are called alike."""

from dataclasses import replace

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import About, AboutKind, about_wishes, content_words
from fuzzytime_cli.clock import Clock
from fuzzytime_cli.repl.naming import (
    called,
    entries_named,
    entry_of,
    label_meant,
    starts_of_entry,
    unknown,
    words_of_entry,
)
from fuzzytime_cli.repl.scene import AskedBackError, Scene, number_of, waiting, whole_number
from fuzzytime_cli.session import Entry

BOTH = 2
"""How many "both" are."""


def entries_meant(scene: Scene, about: About) -> list[Entry]:
    """Give the entries that are meant by names, by their places, or as both that are left, as they stand.

    Raises
    ------
    FuzzytimeError
        If there are not so many.
    """
    left = [one for one in scene.conversation.state.entries if called(scene, one.number) is not None]
    if about.both and about.kind is AboutKind.DROP:
        # "Both done", of which one is running
        running = {number_of(one.identifier) for one in scene.conversation.running(scene.now)}
        left = [e for e in scene.conversation.state.entries if e in left or e.number in running]
    if about.both:
        left = [one for one in left if about.names <= words_of_entry(scene, one)]
        if len(left) != BOTH:
            what = f" that {'is' if len(left) == 1 else 'are'} about {' '.join(sorted(about.names))}"
            count = f"{len(left) or 'none'} {'is' if len(left) == 1 else 'are'} left"
            raise FuzzytimeError(f"{count}{what if about.names else ''}: say which, such as: the call")
        return left
    if about.other:
        last = scene.told_last if scene.focus is None else scene.focus
        left = [one for one in left if one.number != last]
        if len(left) != 1:
            raise FuzzytimeError(f"{len(left)} others are left: say which, such as: the call")
        return left
    if about.upcoming:
        return _next_of(scene)
    if about.places:
        if max(abs(place) for place in about.places) > len(left):
            raise FuzzytimeError(f"{len(left)} {'is' if len(left) == 1 else 'are'} left (:list shows which)")
        return [left[place - 1 if place > 0 else place] for place in about.places]
    entry = entry_of(scene, about.names)
    if entry is None and about.each:
        return _each_of(scene, about)
    if entry is None or not about.several:
        return [] if entry is None else [_only(scene, about, entry)]
    asked = [one for one in scene.plan.everything if not one.stated]
    named = {one.wish.identifier for one in asked if about.names <= content_words(one.skill.name)}
    # "The guests" are those who come, and not what waits for them.
    return [one for one in left if one.identifier in named] if entry.identifier in named else [entry]


def _each_of(scene: Scene, about: About) -> list[Entry]:
    """Give the entry of each of several things that are listed; none where none is known.

    Raises
    ------
    FuzzytimeError
        If only some are.
    """
    found = [entry_of(scene, names) for names in about.each]
    if any(found) and None in found:
        unknown(about.each[found.index(None)])
    return list(dict.fromkeys(entry for entry in found if entry is not None))


def _next_of(scene: Scene) -> list[Entry]:
    """Give the entry of what starts next.

    Raises
    ------
    FuzzytimeError
        If nothing does.
    """
    schedule = scene.plan.schedule
    starts = [
        (schedule.start_times[place], one.wish.identifier)
        for place, one in waiting(scene)
        if scene.plan.has_time(place)
    ]
    if not starts:
        raise FuzzytimeError("nothing starts next (:list shows what is asked for)")
    return [one for one in scene.conversation.state.entries if one.identifier == min(starts)[1]]


def alike(scene: Scene, names: frozenset[str]) -> list[Entry]:
    """Give the entries still to be done that are called alike by some words, in the order of their times."""
    if not names or label_meant(scene, names):
        return []
    found = [entry for entry in entries_named(scene, names) if called(scene, entry.number) is not None]
    timed = [(min(starts_of_entry(scene, entry), default=None), entry.number, entry) for entry in found]
    return [one[-1] for one in sorted(timed, key=lambda one: (one[0] is None, one[0] or scene.now, one[1]))]


def _only(scene: Scene, about: About, entry: Entry) -> Entry:
    """Give the one that is meant of what is called alike: the one that was spoken of last.

    Raises
    ------
    AskedBackError
        If none of them was.
    """
    found = alike(scene, about.names)
    if len(found) <= 1:
        return entry
    spoken_of = next((one for one in found if one.number in {scene.focus, scene.told_last}), None)
    if spoken_of is None:
        raise AskedBackError(f"which one: {' or '.join(_told(scene, one) for one in found)}?", about)
    return spoken_of


def _told(scene: Scene, entry: Entry) -> str:
    """Tell of an entry what tells it apart: "call mum (s1, 18:00)"."""
    name = next(one.skill.name for one in scene.plan.everything if one.wish.identifier == entry.identifier)
    start = min(starts_of_entry(scene, entry), default=None)
    time = "" if start is None else f", {Clock(scene.now, with_seconds=False).at(start)}"
    return f"{name} ({entry.identifier}{time})"


def which_one(scene: Scene, words: str, asked: About) -> About | None:
    """Give what was asked about with the one that a line names: "the plumber", "the first one", "s2", "2"."""
    found = alike(scene, asked.names)
    number = whole_number(words)
    lexicon = scene.conversation.interpreter.language.lexicon
    said = about_wishes(f"{AboutKind.DROP} {words if number is None else f's{number}'}", scene.now, lexicon)
    if len(found) <= 1 or said is None or said.kind is not AboutKind.DROP:
        return None
    if said.both:
        return replace(asked, several=True)
    if len(said.places) == 1 and -len(found) <= said.places[0] <= len(found):
        meant = [found[said.places[0] - 1 if said.places[0] > 0 else said.places[0]]]
    else:
        meant = [one for one in found if said.names and said.names <= words_of_entry(scene, one)]
    return replace(asked, names=frozenset({meant[0].identifier})) if len(meant) == 1 else None
