"""Lines of a file that lean on the one before them, and lines that are about others."""

import pytest

from fuzzytime.interpreter import ProblemKind
from interpreter.telling import starts, told

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    ("lines", "names"),
    [
        (["call mum at six pm", "and dad at seven pm"], ["call mum", "call dad"]),
        (["dust it at noon", "and the rug too", "same for lamps"], ["dust it", "dust the rug", "dust lamps"]),
        (["call mum at six pm", "and dinner at seven pm"], ["call mum", "dinner"]),
        (["add the salt at noon", "and stir"], ["add the salt", "stir"]),
        (["and dad at seven pm"], ["dad"]),
    ],
)  # fmt: skip
def test_a_line_goes_on_with_the_verb_of_the_line_before(lines: list[str], names: list[str]) -> None:
    assert [one.skill.name for one in told(lines).interpretation.skills] == names


def test_a_file_and_a_sentence_say_the_same() -> None:
    lines = ["call mum at six pm", "and dad at seven pm"]
    assert list(starts(told(lines)).values()) == list(starts(told([", ".join(lines)])).values())


@pytest.mark.parametrize(
    "line", ["swap the two calls", "cancel both calls", "Swap the call and the soup.", "drop both calls"]
)
def test_what_is_about_others_is_pointed_at(line: str) -> None:
    lines = ["call mum at six pm", "call dad at seven pm", "cook the soup at noon"]
    made = told([*lines, line]).interpretation
    assert [one.skill.name for one in made.skills] == ["call mum", "call dad", "cook the soup"]
    (problem,) = [one for one in made.problems if one.kind is ProblemKind.NOTHING_TO_DO]
    assert "is about what was asked for before" in problem.message


@pytest.mark.parametrize(
    "line", ["cancel both subscriptions", "swap the tyres and the oil", "cancel the cab"]
)
def test_what_is_about_things_is_asked_for(line: str) -> None:
    assert [one.skill.name for one in told(["call mum at six pm", line]).interpretation.skills][1:] == [line]


@pytest.mark.parametrize(
    ("line", "start"),
    [
        ("water the plants every monday except this monday", "2026-03-16"),
        ("water the plants every day at ten except on 2026-03-04 except on 2026-03-05", "2026-03-06"),
    ],
)
def test_a_repetition_goes_on_behind_what_is_left_out(line: str, start: str) -> None:
    plan = told([line])
    assert f"{plan.instant(plan.schedule.start_times[0]):%Y-%m-%d}" == start
