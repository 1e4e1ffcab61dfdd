"""Commands of the conversation that change what is asked for, or what is so; each can be undone."""

from dataclasses import replace
from datetime import datetime

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.times import instant_after, parse_duration
from fuzzytime_cli.bounds import MAX_AGENTS, PRIORITIES
from fuzzytime_cli.choices import SolverChoice
from fuzzytime_cli.clock import Clock
from fuzzytime_cli.render import fitted, plain, width_of, wrapped
from fuzzytime_cli.repl.naming import identifier_meant
from fuzzytime_cli.repl.scene import Reply, Scene, check_sole, identifier_of, position_of, said, step
from fuzzytime_cli.repl.typed import got, number_and_rest, number_of, several_numbers, whole_number
from fuzzytime_cli.repl.without import numbers_kept, without_part
from fuzzytime_cli.session import KeptBusy, KeptReading, Started, State

BRIEF = 60
"""Columns that the name of a step has."""


def drop(scene: Scene, text: str) -> Reply:
    """Forget an instruction, several ("1,3"), or all of them."""
    if text.strip().lower() == "all":
        return step(scene, ":drop all", lambda state: replace(state, entries=()))
    named = several_numbers(text) or [number_of(identifier_meant(scene, text))]

    def dropped(state: State) -> State:
        for one in named:
            state = _without_told_before(scene, state, one)
        return state

    return step(scene, f":drop {','.join(map(str, named))}", dropped)


def _without_told_before(scene: Scene, state: State, number: int) -> State:
    """Drop an instruction, and what told earlier of what it tells anew; the other things of that stay.

    Raises
    ------
    FuzzytimeError
        If these cannot be said alone.
    """
    anew = [one for one in scene.plan.everything if one.told_by[-1:] == (f"s{number}",)]
    others = {one.wish.identifier for one in scene.plan.everything} - {f"s{number}"}
    told = {name: one for one in anew for name in (f"s{number_of(one.identifier)}", *one.told_by)}
    for entry in (one for one in state.entries if one.identifier in told and one.number != number):
        if entry.identifier not in others:
            state = state.without(entry.number)
            continue
        left = without_part(scene, entry, told[entry.identifier].skill.name)
        if not left:
            raise FuzzytimeError(
                f"{entry.text!r} asks for others too: say it anew, with :edit {entry.number}, or :undo this"
            )
        parts = numbers_kept(scene, entry, left)
        state = state.with_changed(entry.number, text=left, parts=parts)
    return state.without(number)


def duration(scene: Scene, text: str) -> Reply:
    """Say how long an instruction takes."""
    number, rest = number_and_rest(text, "a duration, such as 4min,")
    seconds = parse_duration(rest)
    if seconds < 0:
        raise FuzzytimeError(f"a duration must be at least 0, got {rest!r}")
    check_sole(scene, number, rest)
    return step(
        scene,
        f":duration {number}",
        lambda state: state.with_changed(number, hands_on=seconds, elapsed=seconds),
    )


def priority(scene: Scene, text: str) -> Reply:
    """Say how much an instruction counts."""
    number, rest = number_and_rest(text, "a weight, such as 2,")
    try:
        weight = float(rest)
    except ValueError as error:
        raise FuzzytimeError(f"a priority must be a number, got {rest!r}") from error
    least, most = PRIORITIES
    if not least <= weight <= most:
        raise FuzzytimeError(f"a priority must be between {least:g} and {most:g}, got {rest!r}")
    return step(scene, f":priority {number}", lambda state: state.with_changed(number, priority=weight))


def done(scene: Scene, text: str) -> Reply:
    """Say that a skill is done: one that is running, or one that need not start."""
    wanted = identifier_meant(scene, text)
    running = {one.identifier: one for one in scene.conversation.running(scene.now)}
    if wanted in running:
        scene.conversation.store.note_done(scene.conversation.name, wanted, scene.now)
        return Reply((Text(f"done: {plain(running[wanted].name)}"),), changed=True)
    position = position_of(scene, wanted)
    skill, now, schedule = scene.plan.everything[position], scene.now, scene.plan.schedule
    # It stays known: others may refer to it, and what they are tied to has happened.
    begun = Started(skill.identifier, skill.skill.name, now, now, now, happens=skill.stated)
    if scene.plan.has_time(position):
        agent, satisfaction = schedule.skills[position].agent, schedule.satisfactions[position]
        begun = replace(begun, agent=agent, satisfaction=satisfaction)
    scene.conversation.store.note_over(scene.conversation.name, begun)
    return Reply((Text(f"done: {plain(skill.skill.name)}"),), changed=True)


def more(scene: Scene, text: str) -> Reply:
    """Say that a skill that has started goes on for longer, or below 0 for less long."""
    _, rest = number_and_rest(text, "a length of time, such as 5min,")
    wanted, longer = identifier_of(scene, text.split(maxsplit=1)[0]), parse_duration(rest)
    if not longer:
        raise FuzzytimeError(f"a length of time must not be 0, got {rest!r}")
    store, name = scene.conversation.store, scene.conversation.name
    begun = next((one for one in store.started(name) if one.identifier == wanted), None)
    if begun is None:
        raise FuzzytimeError(f"{wanted} has not started (see: :duration)")
    if longer < 0:
        done = max(scene.now, instant_after(begun.done, longer))
        store.note_until(name, wanted, min(begun.end, done), done)
        return _goes_on_until(scene, begun.name, done)
    done = instant_after(max(begun.done, scene.now), longer)
    # Who is at it stays at it; what goes on by itself goes on by itself.
    by_itself = begun.end < scene.now < begun.done
    end = begun.end if by_itself else instant_after(max(begun.end, scene.now), longer)
    store.note_until(name, wanted, end, max(done, end))
    return _goes_on_until(scene, begun.name, max(done, end))


def _goes_on_until(scene: Scene, name: str, done: datetime) -> Reply:
    until = Clock(scene.now, with_seconds=True).at(done)
    return Reply((Text(f"{plain(name)} goes on until {until}"),), changed=True)


def ctx(scene: Scene, text: str) -> Reply:
    """Take a reading; without one show those there are."""
    from fuzzytime.context import parse_assignment

    signals = scene.conversation.interpreter.rulebook.signals
    if not text.strip():
        clock = Clock(scene.now, with_seconds=True)
        conversation = scene.conversation
        readings = (*conversation.given, *conversation.state.readings)
        shown = tuple(_reading_line(one, clock) for one in readings)
        known = wrapped(f"no readings yet; signals: {', '.join(sorted(signals))}", scene.width)
        return Reply(shown or tuple(known))
    reading = parse_assignment(text.strip(), signals)
    kept = KeptReading(reading.signal, instant_after(scene.now, reading.at), reading.value, reading.unit)
    return step(scene, f":ctx {text.strip()}", lambda state: replace(state, readings=(*state.readings, kept)))


def _reading_line(kept: KeptReading, clock: Clock) -> str:
    value = (
        ("happens" if kept.at > clock.now else "happened")
        if kept.value is None
        else f"{kept.value:g} {kept.unit or ''}".rstrip()
    )
    return f"{plain(kept.signal):<18} {plain(value):<12} at {clock.at(kept.at)}"


def agents(scene: Scene, text: str) -> Reply:
    """Say how many can work at once."""
    number = whole_number(text)
    if number is None or not 1 <= number <= MAX_AGENTS:
        raise FuzzytimeError(f"agents must be a number from 1 to {MAX_AGENTS}{got(text)}")
    return step(scene, f":agents {number}", lambda state: replace(state, agents=number))


def in_order(scene: Scene, text: str) -> Reply:
    """Say whether instructions are steps, each after the one before."""
    chosen = text.strip().lower() or "on"
    if chosen not in {"on", "off"}:
        raise FuzzytimeError(f"in-order must be on or off{got(text)}")
    return step(scene, f":in-order {chosen}", lambda state: replace(state, in_order=chosen == "on"))


def solver(scene: Scene, text: str) -> Reply:
    """Choose the method that finds the schedule."""
    name = text.strip()
    if name not in set(SolverChoice):
        raise FuzzytimeError(f"a solver must be one of {', '.join(SolverChoice)}{got(name)}")
    return step(scene, f":solver {name}", lambda state: replace(state, solver=name))


def busy(scene: Scene, text: str) -> Reply:
    """Take a time out of the schedule."""
    from fuzzytime_cli.inputs.surroundings import moment_of

    parts = text.split(maxsplit=2)
    if len(parts) < 2:
        raise FuzzytimeError("two times must follow, such as: :busy 12:00 13:00 lunch")
    start = moment_of(parts[0], scene.now)
    end = moment_of(parts[1], scene.now, since=start)
    if end <= start:
        raise FuzzytimeError(f"a busy time must end after it starts, got {parts[0]} to {parts[1]}")
    from_, until = instant_after(scene.now, start), instant_after(scene.now, end)
    kept = KeptBusy(from_, until, parts[2] if len(parts) > 2 else "")
    reply = step(scene, f":busy {text.strip()}", lambda state: replace(state, busy=(*state.busy, kept)))
    clock = Clock.for_times(scene.now, [start, end])
    what = f": {kept.what}" if kept.what else ""
    return replace(
        reply, lines=(Text(plain(f"taken from {clock.of(start)} to {clock.end_of(start, end)}{what}")),)
    )


def undo(scene: Scene, _: str) -> Reply:
    """Take the last step back."""
    what = scene.conversation.store.undo(scene.conversation.name)
    return Reply((_brief("undone", what),), changed=True) if what else said("there is nothing to undo")


def redo(scene: Scene, _: str) -> Reply:
    """Take an undone step again."""
    what = scene.conversation.store.redo(scene.conversation.name)
    return Reply((_brief("done again", what),), changed=True) if what else said("there is nothing to redo")


def _brief(done: str, what: str) -> Text:
    """Name a step, which may be a long instruction, in a line."""
    words = plain(what)
    return Text(f"{done}: {words if width_of(words) <= BRIEF else fitted(words, BRIEF)}")
