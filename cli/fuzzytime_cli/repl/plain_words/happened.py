"""What somebody tells to have happened, where something waits for it: "bob called", "the rain stopped"."""

from fuzzytime.language.about_wishes import (
    Said,
    done_at_once,
    is_untold,
    tells_awaited,
    tells_of_somebody,
    written_out,
)
from fuzzytime_cli.repl.scene import Scene, waiting
from fuzzytime_cli.repl.typed import number_of


def happened(scene: Scene, words: str) -> tuple[str, ...]:
    """Give the commands that plan what waits for something now that this is told; none where nothing does.

    Of "call mum when I get home", and then "I got home", that is to call mum as soon as possible.
    """
    waited = [(one, part) for _, one in waiting(scene) for part in one.requirements if is_untold(part)]
    if not waited or words.rstrip().endswith("?"):
        return ()
    # "The coals are white now"
    whole = Said.of(words, scene.now, scene.lexicon)
    said = whole.without_end(whole.table("anew")).text
    reading = scene.language.read(said, now=scene.now)
    if not tells_of_somebody(reading.tokens):
        # "The glue's dry"
        reading = scene.language.read(written_out(said), now=scene.now)
    if not tells_of_somebody(reading.tokens) or any(one.requirements for one in reading.instructions):
        return ()
    found = [
        (one, part)
        for one, part in waited
        if one.reading is not None and tells_awaited(reading.tokens, one.reading.tokens, part, scene.lexicon)
    ]
    lines = (
        f":edit {number_of(one.identifier)} {done_at_once(one.words or '', part)}" for one, part in found
    )
    return tuple(dict.fromkeys(lines))
