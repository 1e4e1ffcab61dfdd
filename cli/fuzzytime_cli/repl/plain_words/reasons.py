"""What is said of wishes beside what is only told: "he is tired, cancel the walk", "skip it, I'm tired"."""

from dataclasses import replace

from rich.text import Text

from fuzzytime.language import Reading, content_words, reported
from fuzzytime.language.about_wishes import (
    About,
    AboutKind,
    about_wishes,
    behind_what_is_told,
    tells_of_somebody,
)
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.naming import entry_of, unknown
from fuzzytime_cli.repl.plain_words.leaving_out import Taken
from fuzzytime_cli.repl.plain_words.telling import is_news
from fuzzytime_cli.repl.scene import Reply, Scene
from fuzzytime_cli.repl.which import entries_meant
from fuzzytime_cli.told_states import tells_what_is, told_of_whom

CHANGING = frozenset(
    {AboutKind.DROP, AboutKind.MOVE, AboutKind.DELAY, AboutKind.SWAP, AboutKind.LATE, AboutKind.EXCEPT}
)
"""What changes what is asked for, and so may be supposed."""

FOR_A_REASON = CHANGING | {AboutKind.DONE, AboutKind.MORE, AboutKind.TAKES}
"""What may be said in front of what is only told."""

NOUNS = frozenset({"NN", "NNS"})
"""Tags of what names a thing."""

BY_A_LENGTH = frozenset({AboutKind.DELAY, AboutKind.MORE})
"""What changes when, or how long, something goes on by a length of time."""


def behind_what_tells(scene: Scene, words: str) -> About | None:
    """Read what is said of wishes behind what asks for nothing: "he is tired, cancel the walk".

    Raises
    ------
    FuzzytimeError
        If it names nothing itself, and what is told is of a thing that nothing planned is about.
    """
    language = scene.language
    found = behind_what_is_told(words, scene.now, language.lexicon)
    if found is None:
        return None
    told, about = found
    about = _of_what_is_told(scene, told, about)
    if not about.certain and (
        about.kind not in CHANGING | {AboutKind.UNABLE} or not entries_meant(scene, about)
    ):
        return None
    if not told:
        return about
    reading = language.read(told, now=scene.now)
    if _asks(scene, reading):
        return None
    points = not language.lexicon.closed.anaphors.isdisjoint(words[len(told) :].lower().split())
    things = content_words(" ".join(one.text for one in reading.tokens if one.tag in NOUNS))
    if about.kind in BY_A_LENGTH and _names_nothing(about) and things and not points:
        # "The hob broke, another ten minutes", where nothing is cooked
        unknown(things)
    return about


def _names_nothing(about: About) -> bool:
    return not (about.names or about.places or about.everything or about.both)


def _of_what_is_told(scene: Scene, told: str, about: About) -> About:
    """Let what names nothing be of what is told in front of it: "the dentist rang, move it to four"."""
    if not _names_nothing(about):
        return about
    named = {word: entry_of(scene, frozenset({word})) for word in content_words(told)}
    meant = {entry.number for entry in named.values() if entry is not None}
    names = frozenset(word for word, entry in named.items() if entry is not None)
    return replace(about, names=names) if len(meant) == 1 else about


def _asks(scene: Scene, reading: Reading) -> bool:
    """Whether words ask for something, or say a time."""
    asked = any(one.operation is not None and one.operation.is_asked for one in reading.instructions)
    lexicon = scene.lexicon
    told = tells_what_is(reading, lexicon) or bool(told_of_whom(reading, lexicon)) or _is_fact(scene, reading)
    asked = asked and not told and reported(reading, lexicon) is None
    # "They rang to say monday" says when nothing is to be done.
    told = tells_of_somebody(reading.tokens)
    return asked or (not told and any(one.requirements for one in reading.instructions))


def _is_fact(scene: Scene, reading: Reading) -> bool:
    """Whether words tell what somebody does, or did, and ask for nothing: "the neighbours sleep late"."""
    lexicon = scene.lexicon
    owed = any(
        one.tag == "MD" or one.text.lower() in lexicon.closed.verbs_of_obligation for one in reading.tokens
    )
    timed = any(one.requirements for one in reading.instructions)
    return not owed and not timed and tells_of_somebody(reading.tokens)


def with_reason(scene: Scene, words: str, taken: Taken) -> Reply | None:
    """Take what is said of wishes in front of what asks for nothing: "skip it, I'm too tired"."""
    language = scene.language
    front, mark, why = words.partition(",")
    about = about_wishes(front, scene.now, language.lexicon) if mark and why.strip() else None
    anaphors = language.lexicon.closed.anaphors
    if about is None or about.kind not in FOR_A_REASON or not (about.certain or entries_meant(scene, about)):
        return None
    whole = about_wishes(words, scene.now, language.lexicon)
    if whole is not None and whole.each and all(entry_of(scene, names) for names in whole.each):
        # "Cancel Ann, Bob and Carl"
        return None
    if _names_nothing(about) and anaphors.isdisjoint(front.lower().split()):
        # "Never mind, it works"
        return None
    reading = language.read(why, now=scene.now)
    if _asks(scene, reading) or is_news(scene, why) or entry_of(scene, content_words(why)) is not None:
        return None
    reply = taken(scene, about)
    if reply is None:
        return None
    return replace(reply, lines=(*reply.lines, Text(plain(f"{why.strip()!r} changes nothing"))))
