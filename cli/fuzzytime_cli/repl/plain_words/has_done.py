"""What somebody tells to have done, taken as done: "I've fed the cat", "the boards are cut"."""

from fuzzytime.language import (
    About,
    AboutKind,
    Operation,
    Reading,
    content_words,
    perhaps_reported,
    told_result,
)
from fuzzytime_cli.repl.naming import entry_of
from fuzzytime_cli.repl.plain_words.leaving_out import Taken
from fuzzytime_cli.repl.scene import Reply, Scene


def perhaps_done(scene: Scene, reading: Reading, taken: Taken) -> Reply | None:
    """Take as done what words may tell to be, where that is known: "plants watered", "the bins are out"."""
    perhaps = perhaps_reported(reading, scene.lexicon)
    if perhaps is not None and (reply := done(scene, perhaps, taken)) is not None:
        return reply
    names = told_result(reading, scene.lexicon)
    reply = taken(scene, About(kind=AboutKind.DONE, names=names)) if names else None
    if names and reply is None and (entry := entry_of(scene, content_words(reading.text))) is not None:
        # "The wine's in", of putting it there
        particles = scene.lexicon.particles.keys() & set(reading.text.lower().split())
        said = particles <= set(entry.text.lower().split())
        about = About(kind=AboutKind.DONE, names=frozenset({entry.identifier}))
        reply = taken(scene, about) if particles and said else None
    return reply


def done(scene: Scene, operation: Operation, taken: Taken) -> Reply | None:
    """Take something as done; None where nothing that is planned, or has begun, is like it."""
    anaphor = (operation.object or "").lower() in scene.lexicon.closed.anaphors
    things = frozenset[str]() if anaphor else content_words(operation.object)
    # "Got the milk" is of whatever was to be done with it.
    tried = [things | {operation.lemma}]
    tried += [things] if things and (operation.lemma,) in scene.lexicon.conversation["done with"] else []
    replies = (taken(scene, About(kind=AboutKind.DONE, names=names)) for names in tried)
    return next((reply for reply in replies if reply is not None), None)
