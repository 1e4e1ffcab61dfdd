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
from fuzzytime_cli.repl.naming import entry_of, is_named_itself, is_of_one_task, unknown
from fuzzytime_cli.repl.plain_words.known import is_known
from fuzzytime_cli.repl.plain_words.leaving_out import Taken
from fuzzytime_cli.repl.plain_words.redirected import (
    REDIRECTED,
    all_but,
    before_last,
    kept_after_all,
    the_other,
)
from fuzzytime_cli.repl.plain_words.telling import is_news
from fuzzytime_cli.repl.scene import Reply, Scene
from fuzzytime_cli.session import Entry

NAME = 2
"""Words that somebody is called by at most."""


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
        return kept_after_all(scene, about, taken)
    if about.certain:
        kept = all_but(scene, known, taken) if about.kind is AboutKind.DROP else None
        return kept or (taken(scene, about) if known is not None or not about.names else None)
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
    before = before_last(scene, about)
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
