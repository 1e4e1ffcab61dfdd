"""The commands for all that is left, or a part of it: "push everything from lunch on by ten minutes"."""

from dataclasses import replace
from datetime import datetime

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language.about_wishes import About
from fuzzytime.times import instant_after
from fuzzytime_cli.repl.naming import LABEL, called, entry_of, starts_of_entry, unknown
from fuzzytime_cli.repl.plain_words.progress import length_said
from fuzzytime_cli.repl.questions.stretches import is_within
from fuzzytime_cli.repl.scene import Scene, is_for_others, waiting
from fuzzytime_cli.repl.which import entries_meant
from fuzzytime_cli.session import Entry

FROM_ON, AFTER = "from", "after"


def delaying_all(scene: Scene, about: About) -> str:
    """Give the command that puts off everything, or those of it that are meant.

    Raises
    ------
    FuzzytimeError
        If none is.
    """
    meant = _meant(scene, about)
    sole = waiting(scene, meant[0].number) if meant is not None and len(meant) == 1 else []
    if any(is_for_others(one) for _, one in sole):
        raise FuzzytimeError(f"not moved, since it was told, not asked for: {sole[0][1].skill.name}")
    numbers = "all" if meant is None else ",".join(str(entry.number) for entry in meant)
    return f":delay {numbers} {length_said(scene, about)}"


def dropping_all(scene: Scene, about: About) -> str:
    """Give the command that drops everything, or those of it that are meant.

    Raises
    ------
    FuzzytimeError
        If none is.
    """
    meant = _meant(scene, about)
    return f":drop {'all' if meant is None else ','.join(str(entry.number) for entry in meant)}"


def entries_of_all(scene: Scene, about: About) -> list[Entry]:
    """Give the entries that are meant, or all.

    Raises
    ------
    FuzzytimeError
        As `dropping_all`.
    """
    meant = _meant(scene, about)
    return list(scene.conversation.state.entries) if meant is None else meant


def _meant(scene: Scene, about: About) -> list[Entry] | None:
    """Give the entries that are meant; None for all.

    Raises
    ------
    FuzzytimeError
        If there are none, or nothing is known of what they are beside, or but for.
    """
    labels = frozenset(filter(LABEL.fullmatch, about.names))
    kept = [one for one in scene.conversation.state.entries if one.identifier in labels]
    if names := about.names - labels:
        kept += entries_meant(scene, replace(about, names=names, several=True, other=False)) or unknown(names)
    if about.other and scene.focus is not None:
        kept = [one for one in scene.conversation.state.entries if one.number == scene.focus]
    asked = [one for one in scene.conversation.state.entries if one not in kept]
    beside = entry_of(scene, about.others) if about.joint else None
    if about.joint and beside is None and not about.time:
        unknown(about.others)
    if beside is not None and (starts := starts_of_entry(scene, beside)):
        found = [one for one in asked if _is_beside(scene, one, beside, about.joint, starts)]
    elif about.time:
        found = [one for one in asked if is_within(scene, one, about.time)]
    elif not kept:
        return None
    else:
        found = [one for one in asked if called(scene, one.number) is not None]
    if not found:
        when = f"planned {about.time}" if about.time else "left"
        raise FuzzytimeError(f"nothing else is {when} (:list shows what is)")
    return found


def _is_beside(scene: Scene, entry: Entry, other: Entry, joint: str, starts: list[datetime]) -> bool:
    """Whether all that is left to do of an entry starts from another on, or after it, or before it."""
    if entry == other:
        return joint == FROM_ON
    own = starts_of_entry(scene, entry)
    # What has lost its place was to be at its best time.
    best = [one.skill.satisfaction.best for _, one in waiting(scene, entry.number)]
    own = own or [instant_after(scene.now, one.low) for one in best if not one.empty]
    if joint in {FROM_ON, AFTER}:
        return bool(own) and min(own) >= min(starts)
    return bool(own) and max(own) < min(starts)
