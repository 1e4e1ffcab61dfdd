"""The command that plain words about what was asked for mean."""

from collections.abc import Callable, Mapping
from dataclasses import replace

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import content_words
from fuzzytime.language.about_wishes import AT_FIRST, AT_ONCE, About, AboutKind
from fuzzytime.times import instant_after, parse_duration
from fuzzytime_cli.clock import Clock
from fuzzytime_cli.repl.bounds import check_bound
from fuzzytime_cli.repl.conversation import exactly
from fuzzytime_cli.repl.naming import (
    called,
    entry_of,
    label_meant,
    part_meant,
    running_one,
    starts_of_entry,
    unknown,
    words_of_entry,
)
from fuzzytime_cli.repl.parts import first_part, swapped_parts
from fuzzytime_cli.repl.plain_words.of_all import delaying_all, dropping_all
from fuzzytime_cli.repl.plain_words.progress import (
    as_typed,
    blocked,
    late,
    length_asked,
    length_said,
    progress,
    unstarted,
)
from fuzzytime_cli.repl.plain_words.retiming import days_on, with_time
from fuzzytime_cli.repl.plain_words.shifting import behind_its_other
from fuzzytime_cli.repl.questions.leeways import may_start
from fuzzytime_cli.repl.scene import AskedBackError, Scene, waiting
from fuzzytime_cli.repl.which import entries_meant, sole
from fuzzytime_cli.repl.without import without_part, without_thing
from fuzzytime_cli.session import Entry

ONE_AT_A_TIME = (
    "one at a time, such as: move the call to six; cancel the call; or: push everything back by an hour"
)


def command_meant(scene: Scene, about: About) -> str | None:
    """Give the command that is meant, as it would be typed; None where it may be a wish of its own.

    Raises
    ------
    FuzzytimeError
        If nothing that is known can be meant, or which of several is not said.
    """
    match about.kind:
        case AboutKind.UNDO if about.text and scene.taken is None:
            # "No, leave it", where nothing was changed
            if about.certain:
                raise FuzzytimeError("nothing was changed: it stays as it is")
            return None
        case AboutKind.UNDO | AboutKind.REDO:
            return _stepping(about)
        case AboutKind.DROP if about.corrects and scene.taken is not None:
            # "Scratch that", of what was changed
            return ":undo"
    return COMMANDS.get(about.kind, _changing)(scene, about)


def _stepping(about: About) -> str:
    """Give the command that takes the last step back, or again.

    Raises
    ------
    FuzzytimeError
        If several are meant.
    """
    if about.both:
        raise FuzzytimeError(f"one step at a time: say {about.kind.value}, and then {about.kind.value} again")
    return f":{about.kind.value}"


def _changing(scene: Scene, about: About) -> str | None:
    """Give the command that drops, moves or delays what is meant."""
    if about.everything and about.kind is AboutKind.MOVE:
        raise FuzzytimeError(ONE_AT_A_TIME)
    if about.everything:
        if about.kind is AboutKind.DROP:
            return dropping_all(scene, about)
        return delaying_all(scene, about)
    if about.corrects and scene.told_last is not None:
        scene = replace(scene, focus=scene.told_last)
    meant = entries_meant(scene, about)
    if not meant:
        return unknown(about.names) if about.certain else None
    again = about.kind is AboutKind.MOVE and about.text
    if again and about.text in content_words(meant[-1].text):
        return None
    numbers = ",".join(str(entry.number) for entry in meant)
    match about.kind:
        case AboutKind.DROP:
            return _dropping(scene, about, meant)
        case AboutKind.DELAY:
            return _delaying(scene, about, meant)
        case _ if about.time == AT_FIRST and (other := _of_two(scene, meant[0])) is not None:
            # Two that have their times each take the other's: "do the second one first"
            return f":swap {other} {numbers}"
        case _ if len(meant) == 1 and about.days:
            return f":edit {numbers} {days_on(scene, meant[0], about.days)}"
        case _ if len(meant) == 1:
            part = part_meant(scene, meant[0].number, about.names)
            check_bound(scene, meant[0], about.time, part)
            return f":edit {numbers} {with_time(scene, meant[0], about, part=part)}"
    raise FuzzytimeError(ONE_AT_A_TIME)


def _delaying(scene: Scene, about: About, meant: list[Entry]) -> str:
    """Give the command that puts off what is meant: perhaps one of several things that a line asks for.

    Raises
    ------
    FuzzytimeError
        If that has started.
    """
    if about.by is None and not about.text and len(meant) == 1:
        # By how much the laundry can be earlier, is told who asks whether it can.
        message = length_asked(about)
        raise AskedBackError(f"{message}{_within(scene, meant[0], about)}", replace(about, certain=True))
    numbers, length = ",".join(str(entry.number) for entry in meant), length_said(scene, about)
    part = part_meant(scene, meant[0].number, about.names) if len(meant) == 1 else None
    by = parse_duration(length.lstrip("-")) * (-1 if length[0] == "-" else 1)
    if part is None and len(meant) == 1 and (words := behind_its_other(scene, meant[0], by)) is not None:
        return f":edit {numbers} {words}"
    if part is None:
        return f":delay {numbers} {length}"
    schedule = scene.plan.schedule
    starts = [
        scene.plan.instant(schedule.start_times[place])
        for place, one in waiting(scene, meant[0].number)
        if one.identifier == part and not schedule.rejected[place]
    ]
    if not starts:
        raise FuzzytimeError(f"{part} has started, or is not planned: it is not put off")
    then = instant_after(starts[0], by)
    return f":edit {numbers} {with_time(scene, meant[0], replace(about, time=exactly(then)), part=part)}"


def _within(scene: Scene, entry: Entry, about: About) -> str:
    """Say how far something may be earlier, or later; nothing where no limit is, or no time."""
    left = [place for place, _ in waiting(scene, entry.number) if scene.plan.has_time(place)]
    found = may_start(scene, left[0], about) if len(left) == 1 else None
    return f"; it may start {found}" if found else ""


def _dropping(scene: Scene, about: About, meant: list[Entry]) -> str:
    """Give the command that forgets what is meant: of "clean the hall and the kitchen", perhaps the hall."""
    numbers = ",".join(str(entry.number) for entry in meant)
    if len(meant) == 1 and about.each:
        named = {part_meant(scene, meant[0].number, names) for names in about.each} - {None}
        if 1 < len(named) < len(waiting(scene, meant[0].number)):
            raise FuzzytimeError(ONE_AT_A_TIME)
    part = first_part(scene, meant[0]) if about.upcoming else part_meant(scene, meant[0].number, about.names)
    rest = without_thing(scene, meant[0], about.names) if len(meant) == 1 else ""
    if len(meant) == 1 and part and not rest:
        # "Forget the roses", of "water the roses, then mow the lawn"; what is running is only ended
        names = (one.skill.name for one in scene.plan.everything if one.identifier == part)
        name = next(names, None)
        anew = "" if name is None else without_part(scene, meant[0], name)
        return f":edit {numbers} {anew}" if anew else f":done {part}"
    left = {one.skill.name for entry in meant for _, one in waiting(scene, entry.number)}
    told = [name for name in left if about.names <= content_words(name)]
    if len(meant) == 1 and not (rest or label_meant(scene, about.names)) and 0 < len(told) < len(left):
        raise FuzzytimeError(f"which one: {' or '.join(sorted(told))}?")
    if len(meant) == 1 and not rest and not about.names <= words_of_entry(scene, meant[0]):
        # The eggs, of which nothing became, of "milk, eggs and bread"
        raise FuzzytimeError(f"that is only part of {meant[0].text!r}: say :drop {numbers}, or say it anew")
    return f":edit {numbers} {rest}" if rest else f":drop {numbers}"


def _of_two(scene: Scene, entry: Entry) -> int | None:
    """Give the number of the other of two that are left; None where there are others, or one has no time.

    Raises
    ------
    FuzzytimeError
        If it is the second of them already.
    """
    left = [one for one in scene.conversation.state.entries if called(scene, one.number) is not None]
    timed = all(
        one.requirements and all(part.anchor is None for part in one.requirements)
        for one in scene.plan.everything
    )
    others = [one for one in left if one.number != entry.number]
    if not timed or len(others) != 1:
        return None
    own, other = (min(starts_of_entry(scene, one), default=None) for one in (entry, others[0]))
    if own is not None and other is not None and own <= other:
        raise FuzzytimeError(f"{entry.text!r} comes first already")
    return others[0].number


def _stopping(scene: Scene, about: About) -> str | None:
    """Give the command that ends what is running, or else forgets what is named, or was spoken of last."""
    one = running_one(scene, about.names)
    if one is not None:
        return f":done {one.identifier}"
    entry = entry_of(scene, about.names)
    if entry is None:
        return None if about.names else unknown(frozenset())
    return f":drop {entry.number}"


def _reversing(scene: Scene, about: About) -> str | None:
    """Give the command that changes the order of two back, or the other way round."""
    last = scene.taken
    if last is not None and last.kind in {AboutKind.SWAP, AboutKind.MOVE}:
        return ":undo"
    if (
        last is not None
        and last.kind is AboutKind.DELAY
        and last.by is not None
        and scene.told_last is not None
    ):
        # "Push the sheep back by an hour", which was to be an hour earlier
        return f":delay {scene.told_last} {as_typed(-2.0 * last.by)}"
    return _swap(scene, replace(about, both=True))


def _started(scene: Scene, about: About) -> str | None:
    """Give the command that has start now what somebody says to have started.

    Raises
    ------
    FuzzytimeError
        If it is taken to be running already, or another leaves no hands free to start it.
    """
    clock = Clock(scene.now, with_seconds=True)
    one = running_one(scene, about.names)
    if one is not None:
        raise FuzzytimeError(f"{one.name} has started, and is running until {clock.at(one.done)}")
    running = scene.conversation.running(scene.now)
    busy = [other for other in running if other.end > scene.now and not other.happens]
    if len(busy) >= scene.plan.request.agents:
        raise FuzzytimeError(
            f"{busy[0].name} is running until {clock.at(busy[0].end)}, and nothing else is begun beside it: "
            f"say first: done {busy[0].identifier}"
        )
    return _changing(scene, replace(about, kind=AboutKind.MOVE, time=AT_ONCE))


def _swap(scene: Scene, about: About) -> str | None:
    if about.both and not about.names and scene.taken is not None and scene.taken.kind is AboutKind.SWAP:
        # "Swap them back"
        return ":undo"
    if about.both:
        left = [one for one in scene.conversation.state.entries if called(scene, one.number) is not None]
        left = [one for one in left if about.names <= words_of_entry(scene, one)]
        if len(left) != 2:
            raise FuzzytimeError("which two? Say: swap the call and the soup")
        return f":swap {left[0].number} {left[1].number}"
    if about.places:
        # "Swap the first two"
        return f":swap {' '.join(str(entry.number) for entry in entries_meant(scene, about))}"
    found = [sole(scene, about, names) for names in (about.names, about.others)]
    if found[0] is None and found[1] is None:
        return None
    for entry, names in zip(found, (about.names, about.others), strict=True):
        if entry is None:
            return unknown(names)
    if found[0] == found[1] and found[0] is not None:
        parts = [part_meant(scene, found[0].number, names) for names in (about.names, about.others)]
        return f":edit {found[0].number} {swapped_parts(scene, found[0], parts)}"
    return f":swap {' '.join(str(entry.number) for entry in found if entry is not None)}"


COMMANDS: Mapping[AboutKind, Callable[[Scene, About], str | None]] = {
    AboutKind.STOP: _stopping,
    AboutKind.REVERSE: _reversing,
    AboutKind.DONE: progress,
    AboutKind.MORE: progress,
    AboutKind.LATE: late,
    AboutKind.BLOCK: blocked,
    AboutKind.SWAP: _swap,
    AboutKind.STARTED: _started,
    AboutKind.UNSTARTED: unstarted,
}
"""What gives the command for each kind; else it drops, moves or delays."""
