"""Several things that one line asks for: another time for one of them, or the line without it."""

from collections.abc import Collection, Sequence
from datetime import datetime

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import Interpreted
from fuzzytime.language import find_times
from fuzzytime.language.about_wishes import Said, merged_time
from fuzzytime.language.instruction import Span
from fuzzytime.requirement import Constraint
from fuzzytime.times import format_duration, instant_after
from fuzzytime_cli.repl.bounds import bound_in
from fuzzytime_cli.repl.scene import Scene, waiting
from fuzzytime_cli.repl.without import asked_in, name_of, times_of, without_joints, without_part
from fuzzytime_cli.session import Entry


def with_time_of_part(scene: Scene, entry: Entry, time: str, part: str) -> str:
    """Give an entry's words with another time, or length, of one of several things that it asks for.

    Raises
    ------
    FuzzytimeError
        If they would ask for something else then.
    """
    one = _one_of(scene, part)
    length = time.lower().startswith("for ")
    bound = bound_in(scene, time) is not None
    first, end = _time_of(one, length=length, bound=bound)
    if first < end and not length:
        # "Move the lawn to sunday", which was to be mown at ten, leaves it at ten.
        lexicon = scene.lexicon
        time = merged_time(entry.text[first:end], entry.given, time, scene.now, lexicon)
    front, behind = placed_at(scene, entry.text, (first, end), time)
    others = [other for other in _parts_of(scene, entry) if other is not one]
    shares = first < end and any((first, end) == _time_of(other, length=length) for other in others)
    if shares:
        return _checked(scene, entry, {one.skill.name}, _each_with_time(scene, entry, one, time))
    # "On friday" would be of the next one, too.
    then = _on_its_day(scene, entry, others, len(entry.text) - len(behind))
    texts = [untied(scene, front + behind), untied(scene, front + then)]
    if any((part.t_spec or 0.0) > 0.0 for part in find_times(time, scene.now, scene.lexicon).requirements):
        # What comes behind another may at a time of its own.
        end = one.instruction.span[1] if one.instruction is not None else 0
        texts.append(f"{entry.text[:end].rstrip()} {time}{entry.text[end:]}")
    if not length:
        texts.append(_apart(scene, entry, one, time))
    return _checked(scene, entry, {one.skill.name}, *texts)


def _apart(scene: Scene, entry: Entry, one: Interpreted, time: str) -> str:
    """Give an entry's words with one of its things in a sentence of its own; empty where that cannot be.

    Of "meet Jo at ten, then write for an hour, then lunch at one" the second thing may be done at two.
    """
    known = one.instruction
    lasts = f"for {format_duration(known.duration)} " if known is not None and known.duration else ""
    text = in_a_part(scene, entry, one.skill.name, f"{one.skill.name} {lasts}{time}")
    # "After the hedge" may be taken for where.
    read = (other for other in asked_in(scene, text, scene.now) if name_of(other) == one.skill.name)
    return text if any(part.text in time for other in read for part in other.requirements) else ""


def in_a_part(scene: Scene, entry: Entry, name: str, words: str) -> str:
    """Give an entry's words with others in place of one of its things; empty where they cannot be said so."""
    left = without_part(scene, entry, name).rstrip(".! ")
    return f"{left}. {words[:1].upper()}{words[1:]}" if left else ""


def placed_at(scene: Scene, text: str, span: Span, time: str) -> tuple[str, str]:
    """Give words up to a new time in the place of the old one, and those behind it.

    What it comes "after" stands behind how long it takes, which would else be said of that.
    """
    front, behind = text[: span[0]].rstrip(), text[span[1] :]
    length = find_times(behind.lstrip(), scene.now, scene.lexicon).requirements[:1]
    lasts = any(part.constraint is Constraint.FOR and part.span[0] == 0 for part in length)
    if lasts and Said(time, scene.now, scene.lexicon).beside() is not None:
        end = len(behind) - len(behind.lstrip()) + length[0].span[1]
        front, behind = f"{front} {behind[:end].strip()}", behind[end:]
    return f"{front} {time}".lstrip(), behind


def _on_its_day(scene: Scene, entry: Entry, others: Sequence[Interpreted], end: int) -> str:
    """Give what stands from some place on in an entry, with its day said of the first time in it."""
    times = (part for one in others if one.instruction is not None for part in one.instruction.requirements)
    behind = sorted(
        (part.span, part.t_spec) for part in times if part.span[0] >= end and part.t_spec is not None
    )
    if not behind:
        return entry.text[end:]
    (_, over), t_spec = behind[0]
    day = instant_after(entry.given, t_spec).date()
    return f"{entry.text[end:over]} {'today' if day == scene.now.date() else f'on {day}'}{entry.text[over:]}"


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
        said.append(f"{without_joints(scene, words)} {time if part is one else shared}")
    return ", ".join(said)


def swapped_parts(scene: Scene, entry: Entry, parts: Sequence[str | None]) -> str:
    """Give an entry's words with two of its things at each other's times.

    Raises
    ------
    FuzzytimeError
        If the two are not clear, or have no times of their own.
    """
    both = [_one_of(scene, part or "") for part in parts]
    spans = sorted(_time_of(one, length=False) for one in both)
    (first, end), (begin, over) = spans
    text = entry.text
    if first == end or begin == over or end > begin:
        raise FuzzytimeError(f"which two change places is not clear: say it anew, with :edit {entry.number}")
    swapped = f"{text[:first]}{text[begin:over]}{text[end:begin]}{text[first:end]}{text[over:]}"
    return _checked(scene, entry, {one.skill.name for one in both}, untied(scene, swapped))


def untied(scene: Scene, text: str) -> str:
    """Leave out what ties things with times of their own to those before: "mow the lawn, then rest at one".

    What was moved behind them would else take them along.
    """
    for one in reversed(asked_in(scene, text, scene.now)):
        # What is only not before a time goes on behind the others.
        timed = any(
            part.t_spec is not None and part.anchor is None and part.constraint is not Constraint.AFTER
            for part in one.requirements
        )
        for part in one.requirements if timed else ():
            if part.anchor is not None and tuple(part.text.lower().split()) in scene.lexicon.connectives:
                first, end = part.span
                text = f"{without_joints(scene, text[:first])} and {text[end:].lstrip()}"
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


def _time_of(one: Interpreted, *, length: bool, bound: bool = False) -> tuple[int, int]:
    """Give where the time of a thing, or how long it takes, stands; where it has none, where one would.

    A ``bound`` leaves what comes behind another there: "then knots", which are not before seven.
    """
    if one.instruction is None:
        return 0, 0
    told = [part for part in one.instruction.requirements if (part.constraint is Constraint.FOR) is length]
    own = [part for part in told if part.anchor is None] or ([] if bound else told)
    return own[-1].span if own else (one.instruction.span[1],) * 2


def _checked(scene: Scene, entry: Entry, changed: Collection[str], *texts: str) -> str:
    """Give the first words that ask for the same as before, at the same times but for what is changed.

    Raises
    ------
    FuzzytimeError
        If all ask for something else, or would move others along.
    """

    def asked(text: str, now: datetime) -> list[tuple[str, str]]:
        named = [(name_of(one), one) for one in asked_in(scene, text, now)]
        return sorted((name, "" if name in changed else repr(times_of(one, now))) for name, one in named)

    before = asked(entry.text, entry.given)
    for text in texts:
        if asked(text, scene.now) == before:
            return text
    raise FuzzytimeError(
        f"how to say that of {entry.text!r} is not clear: say it anew, with :edit {entry.number}"
    )
