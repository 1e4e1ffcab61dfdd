"""Which of what was asked for is meant, by names or places; asked where several are called alike."""

from dataclasses import dataclass, replace
from datetime import datetime, time, timedelta

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import content_words
from fuzzytime.language.about_wishes import About, AboutKind, Said, about_wishes
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
from fuzzytime_cli.repl.scene import AskedBackError, Scene, waiting
from fuzzytime_cli.repl.typed import number_of, whole_number
from fuzzytime_cli.session import Entry

BESIDE = timedelta(minutes=15)
"""How far from the time that it is called by something may be planned."""

LONGEST_NAME = 6
"""Words that one of several is called by at most, with its turn."""

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
        return _next_of(scene, about.names)
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


def _next_of(scene: Scene, names: frozenset[str]) -> list[Entry]:
    """Give the entry of what starts next, of what is named so; none where nothing is.

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
    named = {e.identifier for e in scene.conversation.state.entries if names <= words_of_entry(scene, e)}
    starts = [start for start in starts if start[1] in named]
    if names and not starts:
        return []
    if not starts:
        raise FuzzytimeError("nothing starts next (:list shows what is asked for)")
    return [one for one in scene.conversation.state.entries if one.identifier == min(starts)[1]]


@dataclass(frozen=True, slots=True)
class Called:
    """What is still to be done and called by some words: what a line asks for, or one of several things."""

    entry: Entry
    label: str
    name: str
    names: frozenset[str]
    start: datetime | None


def alike(scene: Scene, names: frozenset[str]) -> list[Called]:
    """Give what is called alike by some words and still to be done, in the order of the times."""
    if not names or label_meant(scene, names):
        return []
    found = [one for entry in entries_named(scene, names) for one in _called_of(scene, entry, names)]
    return sorted(found, key=lambda one: (one.start is None, one.start or scene.now, one.label))


def _called_of(scene: Scene, entry: Entry, names: frozenset[str]) -> list[Called]:
    """Give the things of an entry that are called so, where these are several; else the entry."""
    left = [one for _, one in waiting(scene, entry.number)]
    parts = {one.skill.name: one for one in left if names <= content_words(one.skill.name)}
    if len(parts) < BOTH:
        own = left[:1] if called(scene, entry.number) is not None else []
        first = min(starts_of_entry(scene, entry), default=None)
        label = entry.identifier
        return [Called(entry, label, one.skill.name, frozenset({label}), first) for one in own]
    return [
        Called(entry, one.identifier, name, content_words(name), _start_of(scene, one.identifier))
        for name, one in parts.items()
    ]


def _start_of(scene: Scene, identifier: str) -> datetime | None:
    planned = enumerate(scene.plan.skills)
    place = next((n for n, one in planned if one.identifier == identifier and scene.plan.has_time(n)), None)
    return None if place is None else scene.plan.instant(scene.plan.schedule.start_times[place])


def _only(scene: Scene, about: About, entry: Entry) -> Entry:
    """Give the one that is meant of what is called alike: the one that was spoken of last.

    Raises
    ------
    AskedBackError
        If none of them was, or several.
    """
    found = alike(scene, about.names)
    spoken_of = [one.entry for one in found if one.entry.number in {scene.focus, scene.told_last}]
    if len(found) > 1 and len(spoken_of) != 1:
        raise AskedBackError(f"which one: {' or '.join(_told(scene, one) for one in found)}?", about)
    return spoken_of[0] if len(found) > 1 else entry


def sole(scene: Scene, about: About, names: frozenset[str]) -> Entry | None:
    """Give the entry that is meant by some of the words that are said; None where none is.

    Raises
    ------
    FuzzytimeError
        If it is one of several that are called alike.
    """
    entry = entry_of(scene, names)
    try:
        return None if entry is None else _only(scene, replace(about, names=names), entry)
    except AskedBackError as error:
        raise FuzzytimeError(f"{error} Say: {about.kind.value} s1 and s2") from error


def _told(scene: Scene, one: Called) -> str:
    """Tell what tells something apart: "call mum (s1, 18:00)"."""
    time = "" if one.start is None else f", {Clock(scene.now, with_seconds=False).at(one.start)}"
    return f"{one.name} ({one.label}{time})"


def with_label(scene: Scene, words: str, span: tuple[int, int], times: frozenset[time]) -> str | None:
    """Give a line with the label of what it calls by its time; None where it may call something else so.

    Raises
    ------
    FuzzytimeError
        If nothing starts then, or several do, and that is to be changed.
    """
    first, end = span
    schedule, day = scene.plan.schedule, timedelta(days=1)
    starts = {
        one.identifier: scene.plan.instant(schedule.start_times[place])
        for place, one in waiting(scene)
        if scene.plan.has_time(place)
    }
    starts |= {one.identifier: one.start for one in scene.conversation.running(scene.now)}
    apart = {
        label: min(abs(start - datetime.combine(start, time, start.tzinfo)) % day for time in times)
        for label, start in starts.items()
    }
    # What others want as well may be planned beside its time.
    then = [label for label, by in apart.items() if by == min(apart.values()) and by <= BESIDE]
    if len(then) == 1:
        return f"{words[:first]}{then[0]}{words[end:]}"
    if about_wishes(f"{words[:first]}s1{words[end:]}", scene.now, scene.lexicon) is None:
        return None
    if then:
        raise FuzzytimeError(f"several start then: say which, such as: {', '.join(then)}")
    clock = words[first:end].split(maxsplit=1)[1]
    raise FuzzytimeError(f"nothing that is planned starts at {clock} (:list shows what is)")


def _with_label_of_turn(scene: Scene, words: str) -> str:
    """Give a line with the label of what it calls by its turn of those called alike: "the second viewing"."""
    said = Said(words, scene.now, scene.lexicon)
    openers = (n for n, form in enumerate(said.forms) if form in scene.lexicon.closed.noun_openers)
    for first, end in ((n, end) for n in openers for end in range(len(said.words), n + 2, -1)):
        one = said.until(end).behind(first)
        turns, names = one.until(2).places, one.behind(2).names
        called = len(turns) == 1 and end <= first + LONGEST_NAME and all(map(content_words, one.forms[2:]))
        found = alike(scene, names) if called and names else []
        if 1 < len(found) >= abs(turns[0] if found else 0) and not one.behind(2).has_time:
            label = found[turns[0] - (turns[0] > 0)].label
            labelled = f"{words[: said.words[first].start]}{label}{words[said.words[end - 1].end :]}"
            own = entry_of(scene, names | content_words(one.text)) is not None
            # "The second viewing has been moved"
            known = not own and (first == 0 or about_wishes(labelled, scene.now, scene.lexicon) is not None)
            return labelled if known else words
    return words


def with_labels_of_places(scene: Scene, words: str) -> str:
    """Give a line with the label of each that it calls by its place in the list: "the second one"."""
    words = _with_label_of_turn(scene, words)
    left = [label for one in scene.conversation.state.entries if (label := called(scene, one.number))]
    if len(left) == 1:
        left = list(dict.fromkeys(one.identifier for _, one in waiting(scene)))
    said = Said(words, scene.now, scene.lexicon)
    asks = bool(said.opens_with("what"))
    for first in range(len(said.words) - 2, -1, -1):
        one = said.until(first + 3).behind(first)
        # "What's the last thing I do?" is of the plan's.
        known = (
            not (asks and said.behind(first + 3).names)
            and len(one.words) > 2
            and len(one.places) == 1
            and -len(left) <= one.places[0] <= len(left)
        )
        if known and one.forms[0] in scene.lexicon.closed.noun_openers:
            label = left[one.places[0] - (one.places[0] > 0)]
            words = f"{words[: said.words[first].start]}{label}{words[said.words[first + 2].end :]}"
    return words


def which_one(scene: Scene, words: str, asked: About) -> About | None:
    """Give what was asked about with the one that a line names: "the plumber", "the first one", "s2", "2"."""
    found = alike(scene, asked.names)
    number = whole_number(words)
    lexicon = scene.lexicon
    said = about_wishes(f"{AboutKind.DROP} {words if number is None else f's{number}'}", scene.now, lexicon)
    if len(found) <= 1 or said is None or said.kind is not AboutKind.DROP:
        return None
    if said.both:
        return replace(asked, several=True)
    if len(said.places) == 1 and -len(found) <= said.places[0] <= len(found):
        meant = [found[said.places[0] - 1 if said.places[0] > 0 else said.places[0]]]
    else:
        meant = [one for one in found if said.names and said.names <= content_words(one.name) | {one.label}]
    return replace(asked, names=meant[0].names) if len(meant) == 1 else None
