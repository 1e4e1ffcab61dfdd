"""What somebody tells to have done, taken as done: "I've fed the cat", "the boards are cut"."""

from fuzzytime.language import Operation, Reading, content_words, perhaps_reported, told_result
from fuzzytime.language.about_wishes import About, AboutKind, Said, written_out
from fuzzytime_cli.repl.naming import entry_of
from fuzzytime_cli.repl.plain_words.leaving_out import Taken
from fuzzytime_cli.repl.scene import Reply, Scene, waiting
from fuzzytime_cli.session import Entry


def perhaps_done(scene: Scene, reading: Reading, taken: Taken) -> Reply | None:
    """Take as done what words may tell to be, where that is known: "plants watered", "the bins are out"."""
    perhaps = perhaps_reported(reading, scene.lexicon)
    if perhaps is not None and (reply := done(scene, perhaps, taken)) is not None:
        return reply
    if (begun := _under_way(scene, reading.text)) is not None:
        return taken(scene, About(kind=AboutKind.STARTED, names=frozenset({begun.identifier})))
    names = told_result(reading, scene.lexicon)
    reply = taken(scene, About(kind=AboutKind.DONE, names=names)) if names else None
    if names and reply is None and (entry := entry_of(scene, content_words(reading.text))) is not None:
        # "The wine's in", of putting it there
        particles = scene.lexicon.particles.keys() & set(reading.text.lower().split())
        said = particles <= set(entry.text.lower().split())
        about = About(kind=AboutKind.DONE, names=frozenset({entry.identifier}))
        reply = taken(scene, about) if particles and said else None
    return reply


def _under_way(scene: Scene, words: str) -> Entry | None:
    """Give what is told to have begun and goes on by itself: "the lamb's in", of roasting it; else None."""
    said = Said.of(written_out(words), scene.now, scene.lexicon)
    closed, closing = scene.lexicon.closed, said.ends_with("under way")
    if not closing or (closed.third_person_be | closed.have).isdisjoint(said.forms):
        return None
    left, _ = said.until(len(said.words) - closing).without("being", "perfect", "happened", "anew")
    entry = entry_of(scene, left.names) if left.names else None
    alone = entry is not None and any(
        one.skill.time_until_done > one.skill.duration for _, one in waiting(scene, entry.number)
    )
    return entry if alone else None


def done(scene: Scene, operation: Operation, taken: Taken) -> Reply | None:
    """Take something as done; None where nothing that is planned, or has begun, is like it."""
    anaphor = (operation.object or "").lower() in scene.lexicon.closed.anaphors
    things = frozenset[str]() if anaphor else content_words(operation.object)
    # "Got the milk" is of whatever was to be done with it.
    tried = [things | {operation.lemma}]
    tried += [things] if things and (operation.lemma,) in scene.lexicon.conversation["done with"] else []
    replies = (taken(scene, About(kind=AboutKind.DONE, names=names)) for names in tried)
    return next((reply for reply in replies if reply is not None), None)
