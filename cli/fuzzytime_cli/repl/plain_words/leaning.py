"""What leans on what was said before: "and dad at seven", "same again tomorrow", "not the soup, the rice"."""

from dataclasses import replace

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import Reading, content_words
from fuzzytime.language.about_wishes import (
    AT_FIRST,
    AT_LAST,
    About,
    AboutKind,
    Said,
    about_things,
    continued,
    continuing,
    is_person,
    is_thing,
    may_be_thing,
    names_thing,
    reworded,
)
from fuzzytime.requirement import Constraint
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.commands import anew as said_anew
from fuzzytime_cli.repl.commands import changing
from fuzzytime_cli.repl.naming import entry_of, is_named_itself, is_of_one_task, unknown
from fuzzytime_cli.repl.plain_words.known import is_known
from fuzzytime_cli.repl.plain_words.leaving_out import Taken
from fuzzytime_cli.repl.plain_words.telling import is_news
from fuzzytime_cli.repl.scene import Reply, Scene, waiting
from fuzzytime_cli.repl.which import entries_meant
from fuzzytime_cli.session import Entry

NAME = 2
"""Words that somebody is called by at most."""

REDIRECTED = frozenset(
    {AboutKind.DROP, AboutKind.MOVE, AboutKind.DELAY, AboutKind.MORE, AboutKind.DONE, AboutKind.EXCEPT}
)
"""What may have been meant of another: "not the soup, the rice"."""


CHANGED = frozenset({AboutKind.MOVE, AboutKind.DELAY, AboutKind.MORE})
"""What is taken back of what is to stay as it was."""


def leaning(scene: Scene, words: str, reading: Reading, taken: Taken) -> Reply | None:
    """Answer a line that says no verb of its own, or another thing; None where it is a wish.

    Raises
    ------
    FuzzytimeError
        If what it leans on is not there, or cannot be said so.
    """
    last = entry_of(scene, frozenset())
    if last is not None and (reply := _going_on(scene, words, last, taken)) is not None:
        return reply
    ordered = (one.operation for one in reading.instructions)
    orders = any(one is not None and one.is_asked and not is_thing(reading) for one in ordered)
    about = _of_things(scene, words)
    if about is not None and about.time in {AT_FIRST, AT_LAST}:
        return _placed(scene, about, taken)
    if about is None or (orders and not about.certain):
        return None
    if about.kind is AboutKind.INSTEAD:
        return _instead(scene, about, taken)
    if about.kind is AboutKind.OTHER:
        return the_other(scene, about, taken)
    known = entry_of(scene, about.names) if about.names else None
    if about.kind is AboutKind.UNDO or (about.kind is AboutKind.DROP and known is None):
        return _kept_after_all(scene, about, taken)
    if about.certain:
        return taken(scene, about) if known is not None or not about.names else None
    if about.kind is AboutKind.DROP:
        return taken(scene, about)
    told = any(one.operation is not None for one in reading.instructions)
    if known is not None and not (told and not about.corrects):
        return taken(scene, replace(about, corrects=False))
    if last is None or (told and not about.corrects):
        return None
    if about.corrects:
        # "The plumber comes at eleven instead"
        return None if is_news(scene, words) else _instead(scene, about, taken)
    # "The room's only free till four" is no further thing.
    thing = may_be_thing(scene.language.read(about.thing, now=scene.now), scene.lexicon)
    return None if words.endswith("?") or not thing else _continued(f"and {words}", last, scene)


def _of_things(scene: Scene, words: str) -> About | None:
    """Read what a line says of things: "lawn at four" is of what is done with it, where that is to be mown.

    What has a time of its own is rather another: "lunch at one", which is to be bought.
    """
    lexicon = scene.lexicon
    about = about_things(words, scene.now, lexicon)
    if about is None or about.kind is not AboutKind.MOVE or not (about.thing and about.time and about.names):
        return about
    said = [word for word in about.thing.lower().split() if word not in lexicon.closed.noun_openers]
    if len(said) > len(about.names):
        # "Do the dishes at eight"
        return about
    return replace(about, certain=True) if is_of_one_task(scene, about.names) else about


def _going_on(scene: Scene, words: str, last: Entry, taken: Taken) -> Reply | None:
    """Take what says that it goes on, such as by "and"; None where nothing does.

    Raises
    ------
    FuzzytimeError
        If it surely does, and is not understood.
    """
    more = continuing(words, scene.now, scene.lexicon)
    if more is None:
        return None
    names = content_words(more.thing)
    known = more.thing.partition(" ")[0].lower() in scene.lexicon.closed.noun_openers and bool(more.time)
    if known and is_named_itself(scene, names):
        # "Then the post office tomorrow"
        return taken(scene, About(kind=AboutKind.MOVE, names=names, time=more.time))
    last_change = scene.taken if scene.taken is not None and scene.taken.kind in REDIRECTED else None
    if last_change is not None and not more.time and names and entry_of(scene, names) is not None:
        # "Push dinner back by an hour", and then "the bath too"
        others = replace(
            last_change, names=names, each=(), places=(), both=False, several=False, upcoming=False
        )
        return taken(scene, others)
    if last_change is not None and (reply := _by_another(scene, words, last_change, taken)) is not None:
        return reply
    if (reply := _continued(words, last, scene)) is not None:
        return reply
    # "And Sam too" is nothing to do at any time.
    somebody = not more.time and len(more.thing.split()) <= NAME and is_person(more.thing, scene.lexicon)
    if more.certain or somebody:
        raise FuzzytimeError(f"{words!r} leans on {last.text!r}, and is not understood: say it in full")
    return None


def _by_another(scene: Scene, words: str, last: About, taken: Taken) -> Reply | None:
    """Do by another length to another thing what was done last: "and the sheep by half an hour"."""
    said = Said.of(words, scene.now, scene.lexicon)
    found = said.behind(said.opens_with("continuing")).length() if last.by else None
    if found is None or not last.by or not is_known(scene, found.rest, told=False):
        return None
    by = found.seconds if last.by > 0.0 else -found.seconds
    return taken(scene, About(kind=last.kind, names=found.rest.meant, by=by, certain=True))


def _continued(words: str, last: Entry, scene: Scene) -> Reply | None:
    """Take what goes on with the verb that was said last in full; None where it does not."""
    anew = continued(words, scene.now, last.text, last.given, scene.language)
    return None if anew is None else Reply((Text(plain(f"taken as: {anew}")),), anew=anew)


def _placed(scene: Scene, about: About, taken: Taken) -> Reply | None:
    """Have something come first, or last, that is asked for: "soup first, please"; None where it is a wish.

    Raises
    ------
    FuzzytimeError
        If it is a thing, and nothing that is planned is about it.
    """
    if entry_of(scene, about.names) is not None:
        return taken(scene, about)
    if names_thing(about.thing, scene.now, scene.language):
        unknown(about.names)
    return None


def _instead(scene: Scene, about: About, taken: Taken) -> Reply | None:
    """Put another thing in the place of one, or do to it what was done to that."""
    meant = content_words(about.thing)
    before = _before(scene, about)
    if before is not None and before[1].taken is not None and entry_of(before[1], meant) is not None:
        undone, scene = before
        again = replace(before[1].taken, names=meant, places=(), both=False, several=False)
        reply = taken(scene, again)
        return None if reply is None else replace(reply, lines=(*undone.lines, *reply.lines))
    entry = entry_of(scene, about.names) if about.kind is AboutKind.INSTEAD else entry_of(scene, frozenset())
    if entry is None:
        raise FuzzytimeError("nothing that is planned is about that (:list shows what is)")
    language = scene.language
    if about.names and (whole := _another_order(scene, entry, about)) is not None:
        return whole
    if not may_be_thing(language.read(about.thing, now=scene.now), language.lexicon):
        raise FuzzytimeError(f"{about.thing!r} is not understood of {entry.text!r}: say it anew")
    reading = language.read(entry.text, now=entry.given)
    named = about.names if about.kind is AboutKind.INSTEAD else frozenset()
    time = about.time or None
    text = reworded(reading, language.lexicon, thing=about.thing, replaced=named, time=time, now=scene.now)
    if text is None:
        raise FuzzytimeError(f"what {about.thing!r} stands for in {entry.text!r} is not clear: say it anew")
    reply = said_anew.reworded(scene, entry.number, text)
    head = Text(plain(f"taken as :edit {entry.number} {text}; :undo takes it back"))
    return replace(reply, lines=(head, *reply.lines), focus=entry.number, taken=about)


def _another_order(scene: Scene, entry: Entry, about: About) -> Reply | None:
    """Do something else at the time of one: "clean the yard instead of mending the fence"."""
    said = ((about.thing, scene.now), (entry.text, entry.given))
    read = [scene.language.read(text, now=given) for text, given in said]
    asked, old = ([one for one in each.instructions if one.operation is not None] for each in read)
    ordered = len(asked) == 1 and asked[0].operation is not None and asked[0].operation.is_asked
    if not ordered or len(old) != 1 or is_thing(read[0]) or len(about.thing.split()) == 1:
        return None
    # How long the fence takes says nothing of the yard.
    own = [part.text for part in old[0].requirements if part.constraint is not Constraint.FOR]
    text = " ".join([about.thing, *([] if asked[0].requirements else own)])
    reply = said_anew.reworded(scene, entry.number, text)
    head = Text(plain(f"taken as :edit {entry.number} {text}; :undo takes it back"))
    return replace(reply, lines=(head, *reply.lines), focus=entry.number, taken=about)


def _kept_after_all(scene: Scene, about: About, taken: Taken) -> Reply | None:
    """Leave out one of several that were dropped just before: "clear my afternoon", "wait, not the kids"."""
    planned, last = entry_of(scene, about.names), scene.taken
    dropped = last is not None and last.kind is AboutKind.DROP and not last.everything
    if dropped and last is not None and about.names <= last.names and scene.tried is None:
        # "Restore the viewing", which was dropped just before, where there is another
        return changing.undo(scene, "")
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


def _before(scene: Scene, about: About) -> tuple[Reply, Scene] | None:
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


def the_other(scene: Scene, about: About, taken: Taken) -> Reply | None:
    """Do to the other one what was done last: "not that one, the other one".

    Raises
    ------
    FuzzytimeError
        If nothing was done, or which one is meant is not clear.
    """
    before = _before(scene, about)
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
