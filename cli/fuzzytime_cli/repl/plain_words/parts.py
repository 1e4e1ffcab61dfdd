"""Several things that one line asks for: another time for one of them, or the line without it."""

import re
from collections.abc import Sequence

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import Interpreted
from fuzzytime.language import content_words, merged_time
from fuzzytime.requirement import Constraint
from fuzzytime_cli.repl.scene import Scene, begun_parts, waiting
from fuzzytime_cli.session import Entry

BETWEEN = re.compile(r",\s*(?:and\s+)?|\s+and\s+")
"""What stands between several things."""


def with_time_of_part(scene: Scene, entry: Entry, time: str, part: str) -> str:
    """Give an entry's words with another time, or length, of one of several things that it asks for.

    Raises
    ------
    FuzzytimeError
        If they would ask for something else then.
    """
    one = _one_of(scene, part)
    length = time.lower().startswith("for ")
    first, end = _time_of(one, length=length)
    if first < end and not length:
        # "Move the lawn to sunday", which was to be mown at ten, leaves it at ten.
        lexicon = scene.lexicon
        time = merged_time(entry.text[first:end], entry.given, time, scene.now, lexicon)
    text = f"{entry.text[:first].rstrip()} {time}{entry.text[end:]}"
    others = [other for other in _parts_of(scene, entry) if other is not one]
    shares = first < end and any((first, end) == _time_of(other, length=length) for other in others)
    return _checked(
        scene,
        entry,
        _each_with_time(scene, entry, one, time) if shares else text,
        _names(scene, entry.text, entry),
    )


def _each_with_time(scene: Scene, entry: Entry, one: Interpreted, time: str) -> str:
    """Give the words of several things, each with the time that they share, but for one that has another.

    Of "make the soup and chill the wine before six" the wine may be chilled at seven.
    """
    said = []
    for part in _parts_of(scene, entry):
        if part.instruction is None:
            continue
        begin, end = _time_of(part, length=False)
        shared = entry.text[begin:end]
        words = " ".join(entry.text[slice(*part.instruction.span)].replace(shared, "").split())
        said.append(f"{_without_joints(scene, words)} {time if part is one else shared}")
    return ", ".join(said)


def swapped_parts(scene: Scene, entry: Entry, parts: Sequence[str | None]) -> str:
    """Give an entry's words with two of its things at each other's times.

    Raises
    ------
    FuzzytimeError
        If the two are not clear, or have no times of their own.
    """
    spans = sorted(_time_of(_one_of(scene, part or ""), length=False) for part in parts)
    (first, end), (begin, over) = spans
    text = entry.text
    if first == end or begin == over or end > begin:
        raise FuzzytimeError(f"which two change places is not clear: say it anew, with :edit {entry.number}")
    swapped = f"{text[:first]}{text[begin:over]}{text[end:begin]}{text[first:end]}{text[over:]}"
    return _checked(scene, entry, swapped, _names(scene, text, entry))


def without_part(scene: Scene, entry: Entry, part: str) -> str:
    """Give an entry's words without one of several things; empty where the others cannot be said alone."""
    one = _one_of(scene, part)
    if one.instruction is None or begun_parts(scene, entry.number):
        # What has begun is known by its place among the others.
        return ""
    spans = [other.instruction.span for other in _parts_of(scene, entry) if other.instruction is not None]
    first, end = one.instruction.span
    behind = [start for start, _ in spans if start >= end]
    before = entry.text[:first]
    text = before + entry.text[min(behind) :] if behind else _without_joints(scene, before)
    left = [other.skill.name for other in _parts_of(scene, entry) if other is not one]
    return text if left == _names(scene, text, entry) else ""


def without_thing(scene: Scene, entry: Entry, names: frozenset[str]) -> str:
    """Give an entry's words without one of several things that it is about; empty where it is about one."""
    read = scene.language.read(entry.text, now=entry.given)
    for operation in (one.operation for one in read.instructions):
        said = "" if operation is None else operation.object or ""
        verb = frozenset() if operation is None else {operation.lemma}
        things = [thing for thing in BETWEEN.split(said) if thing]
        left = [thing for thing in things if content_words(thing) != names - verb]
        if 0 < len(left) < len(things) and said in entry.text:
            front = ", ".join(left[:-1])
            return entry.text.replace(said, f"{front} and {left[-1]}" if front else left[-1], 1)
    return ""


def _without_joints(scene: Scene, text: str) -> str:
    """Leave out what joined a thing behind it that is not said any more: "call Ann and"."""
    joints = scene.lexicon.conversation["parting"]
    text = text.rstrip(" ,;")
    while " " in text and (text.rpartition(" ")[2].lower(),) in joints:
        text = text.rpartition(" ")[0].rstrip(" ,;")
    return text


def first_part(scene: Scene, entry: Entry) -> str | None:
    """Give the label of what starts first of several things that a line asks for; None where there is one."""
    left = [(place, one) for place, one in waiting(scene, entry.number) if scene.plan.has_time(place)]
    times = scene.plan.schedule.start_times
    first = min(left, key=lambda pair: times[pair[0]], default=None)
    return first[1].identifier if first is not None and len(left) > 1 else None


def _parts_of(scene: Scene, entry: Entry) -> list[Interpreted]:
    return [one for one in scene.plan.skills if one.wish.identifier == entry.identifier]


def _one_of(scene: Scene, part: str) -> Interpreted:
    """Give what a label means that has not started.

    Raises
    ------
    FuzzytimeError
        If there is none.
    """
    one = next((one for _, one in waiting(scene) if one.identifier == part), None)
    if one is None or one.instruction is None:
        raise FuzzytimeError(f"{part} has started, and does not move" if part else "which one is not clear")
    return one


def _time_of(one: Interpreted, *, length: bool) -> tuple[int, int]:
    """Give where the time of a thing, or how long it takes, stands; where it has none, where one would."""
    if one.instruction is None:
        return 0, 0
    told = [part for part in one.instruction.requirements if (part.constraint is Constraint.FOR) is length]
    own = [part for part in told if part.anchor is None] or told
    return own[-1].span if own else (one.instruction.span[1],) * 2


def _names(scene: Scene, text: str, entry: Entry) -> list[str]:
    """Give what words ask for, in their order."""
    read = scene.language.read(text, now=entry.given)
    return [one.operation.name for one in read.instructions if one.operation is not None]


def _checked(scene: Scene, entry: Entry, text: str, names: Sequence[str]) -> str:
    """Give words that ask for the same as before.

    Raises
    ------
    FuzzytimeError
        If they ask for something else.
    """
    if _names(scene, text, entry) != list(names):
        raise FuzzytimeError(
            f"how to say that of {entry.text!r} is not clear: say it anew, with :edit {entry.number}"
        )
    return text
