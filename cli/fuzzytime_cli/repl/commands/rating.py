"""Rating a start in the conversation: how good it was, or which way it was wrong."""

import json
import re
from dataclasses import replace
from datetime import datetime

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import Interpreted
from fuzzytime.requirement import Reference, TimeRequirement, Unit
from fuzzytime.rulebook import Resolution
from fuzzytime.study.answers.rating import Cue, CueKind, Direction, Rating, document_of
from fuzzytime.times import seconds_between
from fuzzytime_cli.personal import personal_table, rating_line
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.scene import Reply, Scene, identifier_of, step
from fuzzytime_cli.repl.typed import got, number_of
from fuzzytime_cli.session import KeptRating

_SAID = re.compile(r"(?:(?P<score>[1-5])(?:/5| of 5)?)?[ ,]*(?:(?:too )?(?P<way>early|late))?", re.IGNORECASE)
_SPOKEN_UNITS = frozenset({Unit.SECOND, Unit.MINUTE, Unit.HOUR})


def rate(scene: Scene, text: str) -> Reply:
    """Keep a rating of a start, planned or past; without words show the ratings and what they amount to.

    Raises
    ------
    FuzzytimeError
        If it is no rating, or the skill has no time that a rating can move.
    """
    name, _, words = text.strip().partition(" ")
    if not name:
        return Reply(tuple(_shown(scene)))
    score, direction = _words(words)
    identifier = identifier_of(scene, name)
    asked, (start, begun) = _asked(scene, identifier), _start(scene, identifier)
    rating = _rating(asked, seconds_between(asked.wish.given, start), score, direction)
    kept = KeptRating(identifier, asked.skill.name, start, json.dumps(document_of(rating)))
    reply = step(scene, f":rate {text.strip()}", lambda state: state.with_rating(kept))
    rated = "rated" if begun else "rated as planned, it has not started"
    lines = (f"{rated}: {rating_line(kept)}", *personal_table(scene.conversation.ratings).lines)
    return replace(reply, lines=tuple(Text(plain(line)) for line in lines))


def _words(text: str) -> tuple[int | None, Direction | None]:
    """Read "4", "too late", "2 too late"."""
    found = _SAID.fullmatch(text.strip())
    if found is None or not text.strip():
        raise FuzzytimeError(f"a rating must be 1 to 5, 'too early' or 'too late'{got(text)}")
    score, way = found["score"], found["way"]
    return (
        int(score) if score is not None else None,
        Direction(f"too {way.lower()}") if way is not None else None,
    )


def _shown(scene: Scene) -> list[Text]:
    kept = scene.conversation.ratings
    if not kept:
        return [Text("no ratings yet: say how a start was, such as :rate 1 4, or :rate 1 too late")]
    amount = personal_table(kept)
    lines = [*map(rating_line, kept), *amount.lines]
    if not scene.conversation.personal:
        lines.append("plans do not follow them: the setting 'personal' is false")
    return [Text(plain(line)) for line in lines]


def _asked(scene: Scene, identifier: str) -> Interpreted:
    """Find a skill, started or not, as the population understood it when it was asked for."""
    conversation = scene.conversation
    given = conversation.state.entry(number_of(identifier)).given
    # Seen from now, its times may have passed.
    skills = conversation.interpreter.interpret(conversation.request(given)).skills
    for interpreted in skills:
        if interpreted.identifier == identifier:
            return interpreted
    known = ", ".join(interpreted.identifier for interpreted in skills) or "none yet"
    raise FuzzytimeError(f"a skill must be one of the list ({known}), got {identifier!r}")


def _start(scene: Scene, identifier: str) -> tuple[datetime, bool]:
    """Give when a skill started or is planned to, and whether it has.

    A planned start may be rated: one sees that it is too late before it comes, and of a start that came while
    the conversation was closed nothing is known.
    """
    for one in scene.conversation.store.started(scene.conversation.name):
        if one.identifier == identifier:
            return one.start, True
    for position, interpreted in enumerate(scene.plan.everything):
        if interpreted.identifier == identifier and scene.plan.has_time(position):
            return scene.plan.instant(scene.plan.schedule.start_times[position]), False
    raise FuzzytimeError(f"a rated skill must have a start, and {identifier} has none")


def _rating(asked: Interpreted, start: float, score: int | None, direction: Direction | None) -> Rating:
    """Give the rating of a start in seconds from when it was asked for, as the interpretation has them."""
    requirement, resolution = _one_time(asked)
    # A wish about the end is one about the start, by the time until the result is there.
    lead = asked.duration.elapsed if requirement.reference is Reference.FINISH else 0.0
    return Rating(
        satisfaction=asked.skill.satisfaction.shifted(lead),
        t_spec=_anchor(requirement),
        start=start + lead,
        cue=_cue(asked, requirement, resolution),
        score=score,
        direction=direction,
    )


def _one_time(asked: Interpreted) -> tuple[TimeRequirement, Resolution]:
    own = [part for part in asked.requirements if part.anchor is None or part.anchor.target is None]
    timed = [
        (requirement, resolution)
        for requirement, resolution in zip(own, asked.resolutions, strict=False)
        if requirement.condition is None and requirement.anchor is None
    ]
    if len(timed) != 1:
        raise FuzzytimeError(
            f"a rated skill must be asked for by one time, {asked.identifier} is by {len(timed) or 'none'}"
        )
    return timed[0]


def _anchor(requirement: TimeRequirement) -> float:
    """Give the time about which widths grow."""
    if requirement.t_spec is not None:
        return requirement.t_spec
    if requirement.earliest is not None and requirement.latest is not None:
        return (requirement.earliest + requirement.latest) / 2
    return 0.0


def _cue(asked: Interpreted, requirement: TimeRequirement, resolution: Resolution) -> Cue | None:
    """Give what may be heard otherwise: a word that has a time of its own, or a preposition with a number."""
    if requirement.word is not None and resolution.parameters.get("t", 0.0) > 0:
        return Cue(CueKind.WORD, requirement.word)
    if requirement.preposition is not None and requirement.unit in _SPOKEN_UNITS:
        return Cue(CueKind.PREPOSITION, requirement.preposition)
    if "w" not in resolution.parameters and "c" not in resolution.parameters:
        raise FuzzytimeError(
            f"a rating moves times and widths, and {requirement.text!r} of {asked.identifier} has none"
        )
    return None
