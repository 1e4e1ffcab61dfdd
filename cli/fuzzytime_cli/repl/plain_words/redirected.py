"""What was done last, done to another one instead, or to all but one: "no, the other one", "not the gym"."""

from dataclasses import replace

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import content_words
from fuzzytime.language.about_wishes import About, AboutKind, Said
from fuzzytime_cli.repl.commands import changing
from fuzzytime_cli.repl.naming import entry_of
from fuzzytime_cli.repl.plain_words.leaving_out import Taken
from fuzzytime_cli.repl.scene import Reply, Scene, waiting
from fuzzytime_cli.repl.which import entries_meant
from fuzzytime_cli.session import Entry

REDIRECTED = frozenset(
    {AboutKind.DROP, AboutKind.MOVE, AboutKind.DELAY, AboutKind.MORE, AboutKind.DONE, AboutKind.EXCEPT}
)
"""What may have been meant of another: "not the soup, the rice"."""


CHANGED = frozenset({AboutKind.MOVE, AboutKind.DELAY, AboutKind.MORE})
"""What is taken back of what is to stay as it was."""


def the_other(scene: Scene, about: About, taken: Taken) -> Reply | None:
    """Do to the other one what was done last: "not that one, the other one".

    Raises
    ------
    FuzzytimeError
        If nothing was done, or which one is meant is not clear.
    """
    before = before_last(scene, about)
    if before is None or before[1].taken is None:
        raise FuzzytimeError("what of the other one? Say: cancel the other one, move the other one to six")
    undone, scene = before
    last = before[1].taken
    meant = entries_meant(scene, last)
    left = [e for e in scene.conversation.state.entries if waiting(scene, e.number) and e not in meant]
    # Of two calls among other things the other is the other call.
    verbs = {verb for entry in meant for verb in _verbs(scene, entry)}
    alike = [entry for entry in left if not verbs.isdisjoint(_verbs(scene, entry))]
    left = alike if len(alike) == 1 else left
    if len(left) != 1:
        changing.redo(scene, "")
        raise FuzzytimeError(f"{len(left)} others are left: say which, such as: the call")
    again = replace(last, names=frozenset({left[0].identifier}), places=(), both=False, several=False)
    reply = taken(scene, again)
    return None if reply is None else replace(reply, lines=(*undone.lines, *reply.lines))


def by_another_length(scene: Scene, about: About, taken: Taken) -> Reply | None:
    """Move by another length what was moved last: "half an hour earlier", "no, an hour"; None for others."""
    last = scene.taken
    length = Said(about.time, scene.now, scene.lexicon).length() if about.corrects else None
    moved = last is not None and last.kind in {AboutKind.DELAY, AboutKind.MORE}
    if (
        last is None
        or not last.by
        or not moved
        or length is None
        or length.rest.words
        or scene.tried is not None
    ):
        return None
    undone, before = _without_last(scene)
    reply = taken(before, replace(last, by=length.seconds if last.by > 0.0 else -length.seconds))
    return None if reply is None else replace(reply, lines=(*undone.lines, *reply.lines))


def kept_after_all(scene: Scene, about: About, taken: Taken) -> Reply | None:
    """Leave out one of several that were dropped just before: "clear my afternoon", "wait, not the kids"."""
    planned, last = entry_of(scene, about.names), scene.taken
    dropped = last is not None and last.kind is AboutKind.DROP and not last.everything
    if dropped and last is not None and about.names <= last.names and scene.tried is None:
        # "Restore the viewing", which was dropped just before, where there is another
        return changing.undo(scene, "")
    if (reply := all_but(scene, planned, taken)) is not None:
        return reply
    if about.kind is AboutKind.UNDO and planned is not None:
        if last is not None and last.kind in CHANGED and planned.number == scene.told_last:
            # "Leave the gravy as it was", which was put off just before
            return replace(changing.undo(scene, ""), focus=planned.number)
        raise FuzzytimeError(f"{planned.text!r} is planned, and stays")
    if last is None or last.kind is not AboutKind.DROP or scene.tried is not None:
        return None
    undone, before = _without_last(scene)
    kept = entry_of(before, about.names)
    if kept is None:
        changing.redo(scene, "")
        return None
    again = replace(last, names=about.names)
    if not last.everything:
        left = [entry.identifier for entry in entries_meant(before, last) if entry.number != kept.number]
        if len(left) != 1:
            return undone if not left else None
        again = About(kind=AboutKind.DROP, names=frozenset(left))
    if [entry.number for entry in before.conversation.state.entries] == [kept.number]:
        # Nothing else was dropped.
        return replace(undone, focus=kept.number)
    reply = taken(before, again)
    return None if reply is None else replace(reply, lines=(*undone.lines, *reply.lines))


def all_but(scene: Scene, planned: Entry | None, taken: Taken) -> Reply | None:
    """Move all again but for one of those that were: "everything an hour later", and "no, not lunch"."""
    last = scene.taken
    moved = last is not None and last.kind is AboutKind.DELAY and last.everything
    if last is None or planned is None or not moved or not planned.moved_by or scene.tried is not None:
        return None
    undone, before = _without_last(scene)
    try:
        reply = taken(before, replace(last, names=last.names | {planned.identifier}))
    except FuzzytimeError:
        # Nothing else is left that moves.
        return replace(undone, focus=planned.number)
    return None if reply is None else replace(reply, lines=(*undone.lines, *reply.lines))


def before_last(scene: Scene, about: About) -> tuple[Reply, Scene] | None:
    """Take back what was done last, if it may have been meant of another thing; give the scene before it."""
    if scene.taken is None or scene.taken.kind not in REDIRECTED or scene.tried is not None:
        return None
    meant = content_words(about.thing)
    dropped = scene.taken.names
    if about.names and dropped and not about.names & dropped:
        return None
    if about.thing and entry_of(scene, meant) is None:
        return None
    return _without_last(scene)


def _without_last(scene: Scene) -> tuple[Reply, Scene]:
    """Take back what was done last; give the answer to that, and the scene before it."""
    undone = changing.undo(scene, "")
    return undone, replace(scene, plan=scene.conversation.plan(scene.now, previous=scene.plan))


def _verbs(scene: Scene, entry: Entry) -> list[str]:
    asked = [one.operation for _, one in waiting(scene, entry.number)]
    return [one.lemma for one in asked if one is not None and not one.stated]
