"""Wishes that lean on two planned things: "a rest between the round and lunch"."""

from fuzzytime.language.about_wishes import Said
from fuzzytime_cli.repl.plain_words.known import is_known
from fuzzytime_cli.repl.scene import Scene


def wish_between_planned(scene: Scene, words: str) -> str | None:
    """Give a wish for what is between two planned things in words that the language knows; else None."""
    said = Said.of(words, scene.now, scene.lexicon).without_exclamations()
    closed = scene.lexicon.closed
    if said.asks:
        return None
    for place in (n for n, word in enumerate(said.forms) if n and word in closed.prepositions_of_two_ends):
        front, behind = said.until(place), said.behind(place + 1)
        for joint in (n for n, word in enumerate(behind.forms) if n and word == "and"):
            both = behind.until(joint), behind.behind(joint + 1)
            if all(one.words and is_known(scene, one, told=False) for one in both):
                return f"{front.text} after {both[0].text} and before {both[1].text}"
    return None
