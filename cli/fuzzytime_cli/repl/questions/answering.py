"""Questions about the plan, answered in a line or two: what comes next, when, for how long."""

from dataclasses import replace
from datetime import datetime

from rich.text import Text

from fuzzytime.interpreter import Interpreted
from fuzzytime.language import content_words, verb_forms
from fuzzytime.language.about_wishes import About, AboutKind
from fuzzytime.times import format_duration, seconds_between
from fuzzytime_cli.clock import Clock
from fuzzytime_cli.render import plain, wrapped
from fuzzytime_cli.repl.naming import (
    FEW,
    LABEL,
    all_called,
    entry_of,
    occasion_words,
    running_one,
    words_begun,
)
from fuzzytime_cli.repl.questions.ends import all_over, how_long_until
from fuzzytime_cli.repl.scene import Reply, Scene, position_of, running_lines, said, waiting
from fuzzytime_cli.repl.typed import number_of

LONG = 300.0
"""Seconds from which on it is said when something is done."""

NOTHING = "nothing is planned: say what you want done, and when"

MOST = 5
"""How many occurrences a question is answered with."""


def coming(scene: Scene, about: About) -> Reply:
    """Say what is going on, and what comes next; or what comes last of all."""
    running = scene.conversation.running(scene.now)
    lines = running_lines(scene.conversation, scene.now)
    schedule = scene.plan.schedule
    left = (place for place, _ in waiting(scene) if scene.plan.has_time(place))
    planned = sorted(left, key=lambda place: (schedule.start_times[place], place))
    last = about.places == (-1,)
    planned = planned[-1:] if last else planned[:1]
    lines, running = ([], []) if last and planned else (lines, running)
    lines += [_start(scene, position) for position in planned]
    meant = [scene.plan.everything[position].identifier for position in planned]
    meant += [one.identifier for one in running]
    return Reply(tuple(lines), focus=number_of(meant[0])) if lines else said(NOTHING)


def when(scene: Scene, about: About) -> Reply:
    """Say when that is planned which all of some words name, or when all is over."""
    if about.everything:
        return all_over(scene)
    positions, told = as_named(scene, about.names)
    schedule = scene.plan.schedule
    timed = [position for position in positions if scene.plan.has_time(position)]
    timed.sort(key=lambda position: schedule.start_times[position])
    positions = [*timed, *(position for position in positions if position not in timed)]
    if about.upcoming:
        positions = positions[:1]
    elif about.text and len({scene.plan.everything[place].wish.identifier for place in positions}) == 1:
        # "When will the dough be done?" is of the last that is done with it.
        positions = positions[-1:]
    lines = [] if about.text and positions else going_on(scene, about)
    lines += [_start(scene, position) for position in positions[:MOST]]
    if len(positions) > MOST:
        lines.append(Text(f"and {len(positions) - MOST} more times"))
    reply = _reply(scene, about, [*told, *lines] if lines else lines, positions)
    # "When will the bread be out?", of which nothing is said in the plan
    over = all_over(scene).lines if about.text and not lines else ()
    return replace(reply, lines=(*reply.lines, *over))


def as_named(scene: Scene, names: frozenset[str]) -> tuple[list[int], list[Text]]:
    """Give what some words name, or those of them that name anything; and what is said of the others."""
    lexicon = scene.lexicon
    small = lexicon.particles.keys() | lexicon.doing.leaving
    # "When's the roast out?", "when do I leave for the shop?"
    positions = _positions(scene, names) or _positions(scene, names - small or names)
    if positions or going_on(scene, About(kind=AboutKind.WHEN, names=names)):
        return positions, []
    known = names.intersection(frozenset[str]().union(*(_words_of(scene, one) for _, one in waiting(scene))))
    positions = _positions(scene, known) if known else []
    small = small | lexicon.function_words | lexicon.closed.third_person | lexicon.closed.anaphors
    unknown = " ".join(sorted(names - known - small))
    return positions, [Text(plain(f"nothing is planned about {unknown}; but there is:"))] if unknown else []


def asked_of(scene: Scene, words: str) -> Reply | None:
    """Answer a question that is not understood, but names what is planned, with when that is; else None."""
    tables = ("asking", "placing", "stating", "helping")
    asking = {word for table in tables for form in scene.lexicon.questions[table] for word in form}
    filling = {word for form in scene.lexicon.conversation["filling"] for word in form}
    labels = frozenset(filter(LABEL.fullmatch, words.lower().rstrip("?").split()))
    small = filling | scene.lexicon.function_words | content_words(" ".join(asking))
    names = labels or content_words(words) - asking - small
    asks = words.rstrip().endswith("?") or not asking.isdisjoint(words.lower().split()[:1])
    # "Is gym before lunch?" is of the gym.
    named = (content_words(word) & names for word in words.split())
    first = next((one for one in named if one), frozenset[str]())
    entry = (entry_of(scene, names) or entry_of(scene, first)) if asks and names else None
    if entry is None:
        return None
    meant = next((said for said in (names, first) if _positions(scene, said)), frozenset({entry.identifier}))
    return when(scene, About(kind=AboutKind.WHEN, names=meant))


def lasting(scene: Scene, about: About) -> Reply:
    """Say how long that takes which some words name."""
    positions = _positions(scene, about.names)
    lines = going_on(scene, about)
    for position in positions[:MOST]:
        interpreted = scene.plan.everything[position]
        skill = interpreted.skill
        lasts, assumed = skill.time_until_done, interpreted.duration.assumed
        by_itself = 0.0 < skill.duration < lasts
        hands = f", hands for {format_duration(skill.duration)}" if by_itself else ""
        if scene.plan.has_time(position):
            # "Library till six" goes on for as long as it is planned.
            planned = scene.plan.schedule.skills[position]
            assumed = assumed and planned.done - planned.start <= lasts
            lasts = planned.done - planned.start
        whole = f"{format_duration(lasts)}{hands}{' (assumed)' if assumed else ''}"
        name = f"{plain(interpreted.identifier)} {plain(skill.name)}"
        lines.append(Text(f"{name}: {whole}"))
    return _reply(scene, about, lines, positions)


def did(scene: Scene, about: About) -> Reply:
    """Say whether something was done, as far as that is known."""
    entry = entry_of(scene, about.names)
    names = about.names if about.names or entry is None else frozenset({entry.identifier})
    running = running_one(scene, names) if names else None
    if running is not None:
        name = f"{plain(running.identifier)} {plain(running.name)}"
        return said(f"not yet: {name} is running until {_at(scene, running.done)}")
    begun = next(reversed(all_called(scene, names)), None) if names else None
    positions = _positions(scene, names)
    if begun is not None:
        name = f"{plain(begun.identifier)} {plain(begun.name)}"
        lines = [Text(f"yes: {name}, from {_at(scene, begun.start)} to {_at(scene, begun.done)}")]
        lines += [_start(scene, position) for position in positions[:1]]
        return Reply(tuple(lines), focus=number_of(begun.identifier))
    if not positions:
        return nothing_about(about.names)
    start = _start(scene, positions[0])
    return Reply((Text("not yet: ") + start,), focus=_focus(scene, positions))


def beside(scene: Scene, about: About) -> Reply:
    """Say what comes before something, or behind it."""
    schedule, positions = scene.plan.schedule, _positions(scene, about.names)
    left = [place for place, _ in waiting(scene) if scene.plan.has_time(place)]
    running = running_one(scene, about.names) if about.names else None
    # "After the cake", which is in the oven, what is done with it then comes.
    named = [place for place in positions if place in left and running is None]
    if not named and running is None:
        return nothing_about(about.names)
    begin = min((schedule.start_times[place] for place in named), default=0.0)
    over = max((schedule.skills[place].end for place in named), default=0.0)
    times = {place: schedule.start_times[place] for place in left if place not in named}
    if about.joint == "before":
        found = sorted((p for p, time in times.items() if time < begin), key=lambda p: -times[p])
    else:
        found = sorted((p for p, time in times.items() if time >= over), key=lambda p: times[p])
    found = found[:FEW]
    if not found:
        return said(f"nothing is planned {about.joint} {plain(about.thing)}")
    return Reply(tuple(_start(scene, place) for place in found), focus=_focus(scene, found))


def going_on(scene: Scene, about: About) -> list[Text]:
    """Say of what is running and named until when it is."""
    clock = Clock(scene.now, with_seconds=True)
    entry = None if about.names else entry_of(scene, about.names)
    names = about.names if entry is None else {entry.identifier}
    return [
        Text(f"{plain(one.identifier)} {plain(one.name)}: running, until {clock.at(one.done)}")
        for one in scene.conversation.running(scene.now)
        if names and names <= words_begun(scene, one) | {one.identifier}
    ]


def why(scene: Scene, about: About) -> Reply:
    """Say why that starts when it does which some words name, and nothing more."""
    from fuzzytime_cli.formats.reasons import why_sentences

    positions = _positions(scene, about.names)
    begun = None if positions else running_one(scene, about.names)
    if begun is not None:
        name = f"{plain(begun.identifier)} {plain(begun.name)}"
        return said(f"{name} has started, and is running until {_at(scene, begun.done)}")
    if not positions:
        entry = entry_of(scene, about.names)
        if entry is not None:
            position_of(scene, str(entry.number))  # what is running, or over, says so
        return nothing_about(about.names)
    name = scene.plan.everything[positions[0]].identifier
    sentences = [*why_sentences(scene.plan, positions[0]), f":why {name} shows words, rules and curve."]
    heading = f"{plain(name)} {plain(scene.plan.everything[positions[0]].skill.name)}"
    lines = [line for sentence in sentences for line in wrapped(f"  {sentence}", scene.width, 6)]
    return Reply((Text(heading, style="bold"), *lines), focus=_focus(scene, positions))


def _reply(scene: Scene, about: About, lines: list[Text], positions: list[int]) -> Reply:
    """Answer with some lines about skills; without lines say that nothing is meant."""
    return Reply(tuple(lines), focus=_focus(scene, positions)) if lines else nothing_about(about.names)


def nothing_about(names: frozenset[str]) -> Reply:
    """Answer that nothing planned is about some words."""
    what = " ".join(sorted(names)) if len(names) <= FEW else "that"
    return said(f"nothing that is planned is about {what}" if names else "nothing is planned")


def _focus(scene: Scene, positions: list[int]) -> int | None:
    return number_of(scene.plan.everything[positions[0]].identifier) if positions else None


def _positions(scene: Scene, names: frozenset[str]) -> list[int]:
    """Give the places of waiting skills that all of some words name; without words of what was spoken of."""
    leaving = scene.lexicon.doing.leaving
    if names and names <= leaving.union(*scene.lexicon.conversation["going"]):
        # "When do I have to leave?"
        going = ((place, one.operation) for place, one in waiting(scene))
        return [place for place, operation in going if operation is not None and operation.lemma in leaving]
    if names:
        labelled = [position for position, one in waiting(scene) if names == {one.identifier}]
        return labelled or [
            position
            for position, one in waiting(scene)
            if names <= _words_of(scene, one) | {one.wish.identifier}
        ]
    entry = entry_of(scene, names)
    return [] if entry is None else [position for position, _ in waiting(scene, entry.number)]


def _words_of(scene: Scene, one: Interpreted) -> frozenset[str]:
    """Give the words that name a skill: those of its name, and its verb in all its forms."""
    verb = frozenset() if one.operation is None else verb_forms(one.operation.lemma, scene.lexicon)
    return content_words(one.skill.name) | verb | occasion_words(scene, one)


def _start(scene: Scene, position: int) -> Text:
    interpreted, schedule = scene.plan.everything[position], scene.plan.schedule
    name = f"{plain(interpreted.identifier)} {plain(interpreted.skill.name)}"
    if position >= len(scene.plan.skills):
        return Text(f"{name}: waits: {plain(interpreted.reason)}")
    if schedule.rejected[position]:
        return Text(f"{name}: rejected (:why {plain(interpreted.identifier)} tells)")
    instant, done = (
        scene.plan.instant(schedule.start_times[position]),
        scene.plan.instant(schedule.skills[position].done),
    )
    over = f", done at {_at(scene, done)}" if interpreted.skill.time_until_done >= LONG else ""
    return Text(f"{name}: at {_at(scene, instant)}, in {how_long_until(scene, instant)}{over}")


def _at(scene: Scene, instant: datetime) -> str:
    return Clock.to_minutes(scene.now).of(seconds_between(scene.now, instant))
