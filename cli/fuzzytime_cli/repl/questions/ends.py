"""Questions about when all is over, and whether it will be in time."""

from dataclasses import replace
from datetime import datetime

from rich.text import Text

from fuzzytime.interpreter import Interpreted
from fuzzytime.language.about_wishes import About
from fuzzytime.times import format_duration, seconds_between
from fuzzytime_cli.render import plain, wrapped
from fuzzytime_cli.repl.questions.stretches import bounds_of, time_of
from fuzzytime_cli.repl.questions.taken import at
from fuzzytime_cli.repl.scene import Reply, Scene, is_for_others, said, waiting
from fuzzytime_cli.repl.typed import number_of

SOON = 90.0
"""Seconds below which it is said to the second how long it is until a start."""

MOST = 5
"""How many that are late are told."""


def on_time(scene: Scene, about: About) -> Reply:
    """Say whether all that is left has its time, and else what has not; or whether it is over by a time."""
    from fuzzytime_cli.formats.reasons import loss_lines

    if about.time:
        return _is_over_by(scene, about.time)
    left = {place for place, _ in waiting(scene)}
    told = loss_lines(scene.plan)
    late = [(place, words) for place, words in told if place is not None and place in left]
    whole = all_over(scene)
    if not late:
        answer = "no" if about.text else "yes"
        return replace(
            whole, lines=(Text(f"{answer}: everything that is planned has its time"), *whole.lines)
        )
    said_of = [f"  {scene.plan.everything[place].identifier} {plain(words)}" for place, words in late[:MOST]]
    lines = [line for words in said_of for line in wrapped(words, scene.width, 6)]
    focus = number_of(scene.plan.everything[late[0][0]].identifier)
    return Reply((Text("yes:" if about.text else "not all of it:"), *lines, *whole.lines), focus=focus)


def _is_over_by(scene: Scene, words: str) -> Reply:
    """Say whether all is over by a time."""
    ends = _ends(scene)
    if not ends:
        return said("nothing is planned")
    first, last = bounds_of(scene, time_of(scene, words))
    by = last or first
    answer = "yes" if by is not None and max(ends) <= by else "no"
    return said(f"{answer}: all that is planned is done at {at(scene, max(ends))}")


def all_over(scene: Scene) -> Reply:
    """Say when the last of all is done."""
    ends = _ends(scene)
    if not ends:
        return said("nothing is planned")
    return said(f"all is done at {at(scene, max(ends))}, in {how_long_until(scene, max(ends))}")


def _ends(scene: Scene) -> list[datetime]:
    """Give when each is done of what is planned, or running; of what only happens where nothing else is."""
    schedule, skills = scene.plan.schedule, scene.plan.skills
    ends = [
        (scene.plan.instant(one.done), is_for_others(skills[position]) or _only_happens(skills[position]))
        for position, one in enumerate(schedule.skills)
        if scene.plan.has_time(position)
    ]
    ends += [(one.done, False) for one in scene.conversation.running(scene.now)]
    # "Is everything done before five?" is not when the guests have come.
    return [end for end, happens in ends if not happens] or [end for end, _ in ends]


def _only_happens(one: Interpreted) -> bool:
    return one.stated and not one.skill.time_until_done


def how_long_until(scene: Scene, instant: datetime) -> str:
    """Give how long it is until then; in whole minutes, as clock times are, where it is some."""
    left = max(0.0, seconds_between(scene.now, instant))
    return format_duration(60.0 * round(left / 60.0) if left >= SOON else left)
