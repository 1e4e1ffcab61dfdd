"""An instruction's words without one of several things that it asks for, or without one of its times."""

import re
from datetime import datetime

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import Instruction, content_words
from fuzzytime.language.instruction import Span
from fuzzytime.times import instant_after
from fuzzytime_cli.repl.scene import FIRST, Scene, begun_parts
from fuzzytime_cli.repl.typed import number_of
from fuzzytime_cli.session import Entry

BETWEEN = re.compile(r",\s*(?:and\s+)?|\s+and\s+")
"""What stands between several things."""

LEFT = re.compile(r"\s*,\s*(?=,|and\b|$)|\s+(?=,)")
"""What is left over where a time was left out of a list."""


def without_part(scene: Scene, entry: Entry, name: str) -> str:
    """Give an entry's words without one of several things; empty where the others cannot be said alone."""
    read = asked_in(scene, entry.text, entry.given)
    left = [one for one in read if name_of(one) != name]
    if len(left) != len(read) - 1 or not left:
        return ""
    first, end = next(one.span for one in read if one not in left)
    behind = [one.span[0] for one in left if one.span[0] >= end]
    before = entry.text[:first]
    text = before + entry.text[min(behind) :] if behind else without_joints(scene, before)
    verbs = dict.fromkeys(one.operation.verb for one in left if one.operation is not None)
    # "Make the soup at six and the salad at seven", of which the soup is not to be
    texts = (text, *(f"{before}{verb} {entry.text[min(behind) :]}" for verb in verbs if behind))
    same = [(name_of(one), times_of(one, entry.given)) for one in left]
    for said in texts:
        anew = [(name_of(one), times_of(one, entry.given)) for one in asked_in(scene, said, entry.given)]
        if anew == same:
            return said
    return ""


def only_left_out(scene: Scene, entry: Entry, text: str) -> bool:
    """Whether words are those of an entry without one of several things that it asks for."""
    names = dict.fromkeys(name_of(one) for one in asked_in(scene, entry.text, entry.given))
    return len(names) > 1 and any(without_part(scene, entry, name) == text for name in names)


def numbers_kept(scene: Scene, entry: Entry, text: str) -> tuple[int, ...]:
    """Give the numbers of an entry's things that other words of it ask for; none where they are as they were.

    Of "feed the cat and call mum" without the cat the call stays the second: s1.2.
    """
    known = [(one.identifier, one.skill.name) for one in scene.plan.everything]
    known += [(one.identifier, one.name) for one in begun_parts(scene, entry.number)]
    numbers: dict[str, int] = {}
    for identifier, name in known:
        number = int(identifier.partition(".")[2] or FIRST)
        if number_of(identifier) == entry.number:
            numbers[name] = min(number, numbers.get(name, number))
    names = [name_of(one) for one in asked_in(scene, text, entry.given)]
    kept = tuple(numbers.get(name, 0) for name in names)
    as_they_were = kept == tuple(range(FIRST, FIRST + len(kept)))
    return () if 0 in kept or len(set(kept)) < len(kept) or as_they_were else kept


def without_thing(scene: Scene, entry: Entry, names: frozenset[str]) -> str:
    """Give an entry's words without one of several things that it is about; empty where it is about one.

    Raises
    ------
    FuzzytimeError
        If the others do not stand together in its words: "gym for an hour and dinner".
    """
    read = scene.language.read(entry.text, now=entry.given)
    for operation in (one.operation for one in read.instructions):
        said = "" if operation is None else operation.object or ""
        verb = frozenset() if operation is None else {operation.lemma}
        things = [thing for thing in BETWEEN.split(said) if thing]
        left = [thing for thing in things if content_words(thing) != names - verb]
        if 0 < len(left) < len(things):
            if said not in entry.text:
                message = f"that is only part of {said!r}: say :drop {entry.number}, or say it anew"
                raise FuzzytimeError(message)
            front = ", ".join(left[:-1])
            return entry.text.replace(said, f"{front} and {left[-1]}" if front else left[-1], 1)
    return ""


def without_time(scene: Scene, entry: Entry, span: Span) -> str:
    """Give an entry's words without one of the times that it lists: "tablets at eight and noon".

    Raises
    ------
    FuzzytimeError
        If the others cannot be said alone.
    """
    first, end = span
    text = LEFT.sub(" ", f"{entry.text[:first].rstrip()} , {entry.text[end:].lstrip()}")
    said = (text, without_joints(scene, text), f"{entry.text[:first]}at {entry.text[end:].lstrip(' ,')}")
    read = asked_in(scene, entry.text, entry.given)
    same = [times_of(one, entry.given) for one in read if all(part.span != span for part in one.requirements)]
    for words in (" ".join(one.split()) for one in said):
        if [times_of(one, entry.given) for one in asked_in(scene, words, entry.given)] == same:
            return words
    raise FuzzytimeError(f"one of several times cannot be left out of {entry.text!r}: say it anew")


def without_joints(scene: Scene, text: str) -> str:
    """Leave out what joined a thing behind it that is not said any more: "call Ann and"."""
    joints = scene.lexicon.conversation["parting"]
    text = text.rstrip(" ,;")
    while " " in text and (text.rpartition(" ")[2].lower(),) in joints:
        text = text.rpartition(" ")[0].rstrip(" ,;")
    return text


def asked_in(scene: Scene, text: str, given: datetime) -> list[Instruction]:
    """Give what words that were given at a moment ask for, in their order."""
    read = scene.language.read(text, now=given)
    return [one for one in read.instructions if one.operation is not None]


def name_of(one: Instruction) -> str:
    """Give what is done; empty for nothing."""
    return "" if one.operation is None else one.operation.name


def times_of(one: Instruction, given: datetime) -> list[tuple[object, ...]]:
    """Give the times and conditions of what is asked for, but for what it comes before or after."""
    return [
        (
            part.constraint,
            *(
                None if at is None else instant_after(given, at)
                for at in (part.t_spec, part.earliest, part.latest)
            ),
            part.number,
            None if part.condition is None else part.text,
        )
        for part in one.requirements
        if part.anchor is None
    ]
