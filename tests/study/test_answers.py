from dataclasses import replace

import numpy as np
import pytest

from fuzzytime.errors import FuzzytimeError
from fuzzytime.study import Answers, Participant


def changed(answers: Answers, position: int, **changes: object) -> Answers:
    people = list(answers.participants)
    people[position] = replace(people[position], **changes)  # type: ignore[arg-type]
    return Answers(answers.design, tuple(people))


def with_curve(person: Participant, key: str, curve: np.ndarray) -> dict[str, np.ndarray]:
    return {**person.curves, key: curve}


def test_everybody_who_answered_attentively_counts(answers: Answers) -> None:
    assert answers.counted == answers.participants
    assert answers.set_aside == ()
    assert [len(answers.members(group)) for group in ("robot", "person", None)] == [16, 16, 32]


def test_groups_are_counted_where_there_are_several(answers: Answers) -> None:
    assert answers.head_count == "32 participants (16 robot, 16 person)"
    alone = replace(answers.design, groups={"robot": "robot"})
    assert Answers(alone, answers.members("robot")).head_count == "16 participants"
    assert Answers(alone, answers.members("robot")[:1]).head_count == "1 participant"


def test_rows_are_the_same_participants_in_every_instruction(answers: Answers) -> None:
    robots = answers.subjective("robot")
    assert list(robots) == [entry.key for entry in answers.design.instructions]
    for row, person in enumerate(answers.members("robot")):
        for key, drawn in robots.items():
            assert (drawn.values[row] == person.curves[key]).all()


def test_a_curve_that_is_0_around_its_time_sets_its_participant_aside(answers: Answers) -> None:
    times = answers.design.timeline.times
    person = answers.participants[3]
    late = np.where(times > 900.0, 1.0, 0.0)
    some = changed(answers, 3, curves=with_curve(person, "in-10", late))
    assert [entry.name for entry in some.set_aside] == [person.name]
    assert some.set_aside[0].reason == "attention check: nothing drawn around the time of in-10"
    assert len(some.counted) == 31
    # A start exactly five minutes off is within the check.
    edge = np.where(times >= 900.0, 1.0, 0.0)
    assert not changed(answers, 3, curves=with_curve(person, "in-10", edge)).set_aside


def test_who_stopped_early_or_is_excluded_is_set_aside_with_the_reason(answers: Answers) -> None:
    person = answers.participants[0]
    open_one = {key: curve for key, curve in person.curves.items() if key != "soon"}
    assert changed(answers, 0, curves=open_one).set_aside[0].reason == "answered 13 of 14 instructions"
    assert changed(answers, 0, excluded="joked").set_aside[0].reason == "excluded: joked"


def test_a_study_without_participants_that_count_says_so(answers: Answers) -> None:
    with pytest.raises(FuzzytimeError, match="no participant has answered"):
        Answers(answers.design, ()).subjective()
    excluded = Answers(answers.design, tuple(replace(p, excluded="test") for p in answers.participants))
    with pytest.raises(FuzzytimeError, match=r"of the group 'robot' has answered.*32 are set aside"):
        excluded.subjective("robot")
