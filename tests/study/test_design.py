import re
from pathlib import Path

import pytest

from fuzzytime.errors import DocumentError, FuzzytimeError
from fuzzytime.study import Design

SMALL = """
fuzzytime-study: 1
name: small
timeline: {start: 0 s, end: 10 min, samples: 20}
groups: {robot: robot}
instructions:
  soon: {say: Start soon!, preposition: in, t: 0 s, word: soon}
"""

PLACEHOLDERS = {"{actor}", "{done}", "{all}", "{minutes}", "{percent}", "{low}", "{high}", "{reason}"}


def test_the_shipped_design_is_that_of_the_paper(design: Design) -> None:
    asked: dict[tuple[str, str | None], set[float]] = {}
    for entry in design.instructions:
        asked.setdefault((entry.preposition, entry.fuzziness), set()).add(entry.t_spec / 60)
    assert asked == {
        ("in", None): {0, 1, 10, 30},
        ("in", "approximately"): {0, 10},
        ("after", None): {1, 10, 30},
        ("after", "approximately"): {10},
        ("before", None): {1, 10, 30},
        ("before", "approximately"): {10},
    }
    assert len(design.instructions) == 14
    assert {entry.word for entry in design.instructions} == {None, "now", "soon"}
    assert design.timeline.step == 4.5
    assert design.timeline.times.shape == (800,)
    assert design.default == 0
    assert design.attention == 300
    assert set(design.groups) == {"robot", "person"}
    assert design.control is not None
    assert (design.control.t_spec, design.control.late, design.control.points) == (600, 180, 5)


def test_every_placeholder_on_the_page_is_one_that_the_page_fills(design: Design) -> None:
    for text in design.texts.values():
        for part in (text,) if isinstance(text, str) else text:
            assert set(re.findall(r"\{.*?\}", part)) <= PLACEHOLDERS


def test_a_small_design_takes_the_shipped_texts(design: Design) -> None:
    small = Design.of_text(SMALL + "texts: {next: Weiter}\n")
    assert small.texts["next"] == "Weiter"
    assert small.texts["back"] == design.texts["back"]
    assert small.attention is None
    assert small.control is None
    assert small.demographics == ()
    assert Design.of_text(small.yaml).instructions == small.instructions


@pytest.mark.parametrize(
    ("old", "new", "place", "rule"),
    [
        ("fuzzytime-study: 1", "fuzzytime-study: 2", "2:18", "between 1 and 1"),
        ("name: small", "nmae: small", "3:1", "did you mean 'name'"),
        ("samples: 20", "samples: 2", "4:46", "between 10 and 10000"),
        ("end: 10 min", "end: 10 parsecs", "4:29", "10 parsecs"),
        ("end: 10 min", "end: -10 min", "4:29", "must lie after the start"),
        ("{robot: robot}", "{}", "5:9", "at least one group"),
        (", t: 0 s", ", t: 11 min", "7:48", "between 0 s and 10 min"),
        ("preposition: in, ", "", "7:9", "missing key 'preposition'"),
        ("word: soon", "wrod: soon", "7:53", "did you mean 'word'"),
        (
            "  soon:",
            "  ../a:",
            "7:3",
            "a key must be at most 60 letters, digits, hyphens, full stops, got '../a'",
        ),
        ("  soon:", "  '':", "7:3", "a key must be"),
        ("name: small", "name: ''", "3:7", "must not be empty"),
        ("{robot: robot}", "{robot: ''}", "5:17", "must not be empty"),
        ("{robot: robot}", "{'': robot}", "5:10", "a group must have a name"),
    ],
)
def test_a_mistake_in_a_design_is_said_with_its_place(old: str, new: str, place: str, rule: str) -> None:
    with pytest.raises(DocumentError) as caught:
        Design.of_text(SMALL.replace(old, new), "small.yaml")
    assert f"small.yaml:{place}: " in str(caught.value)
    assert rule in str(caught.value)


@pytest.mark.parametrize(
    ("more", "rule"),
    [
        ("demographics: {age: {ask: How old?}}", "one of choices, whole and text"),
        ("demographics: {age: {ask: How old?, whole: [1]}}", "must hold 2 items"),
        ("demographics: {age: {ask: How old?, whole: [20, 10]}}", "must not decrease"),
        ("demographics: {age: {ask: '', whole: [10, 20]}}", "must not be empty"),
        ("demographics: {'a/b': {ask: x, text: 9}}", "a key must be"),
        ("demographics: {sex: {ask: Which?, choices: []}}", "two choices or more"),
        ("demographics: {sex: {ask: Which?, choices: [a, a]}}", "two choices or more"),
        ("control: {say: Late?, t: 1 min}", "missing key 'points'"),
        (
            "control: {say: 'The {acotr}?', t: 1 min, late: 0 s, points: 5, lowest: a, highest: b}",
            "nothing is filled in for {acotr} .did you mean 'actor'",
        ),
        ("texts: {task_title: '{doen} of {all}'}", "nothing is filled in for {doen} .did you mean 'done'"),
        ("texts: {tutorial_steps: [a, 'b {c}']}", "nothing is filled in for {c}"),
        ("texts: {nxt: Weiter}", "did you mean 'next'"),
        ("attention: {}", "missing key 'around'"),
        ("default: 2", "between 0 and 1"),
    ],
)
def test_parts_that_may_be_left_out_are_checked_too(more: str, rule: str) -> None:
    with pytest.raises(DocumentError, match=rule):
        Design.of_text(SMALL + more)


def test_all_mistakes_are_said_at_once(tmp_path: Path) -> None:
    path = tmp_path / "design.yaml"
    path.write_text("name: x\ntimeline: 3\ngroups: []\ninstructions: {a: {say: b}}\n")
    with pytest.raises(DocumentError) as caught:
        Design.of_file(path)
    assert len(caught.value.mistakes) >= 5


@pytest.mark.parametrize(
    ("key", "answer", "checked"),
    [
        ("age", " 31 ", "31"),
        ("gender", "female", "female"),
        ("culture", "Färöisch", "Färöisch"),
        ("age", "", ""),
    ],
)
def test_answers_that_were_asked_for_are_taken(design: Design, key: str, answer: str, checked: str) -> None:
    assert design.question(key).checked(answer) == checked


@pytest.mark.parametrize(
    ("key", "answer"),
    [
        ("age", "7"),
        ("age", "1e2"),
        ("age", "٣٣"),
        ("age", "9" * 5000),
        ("gender", "yes"),
        ("culture", "x" * 61),
    ],
)
def test_answers_that_were_not_asked_for_are_refused(design: Design, key: str, answer: str) -> None:
    with pytest.raises(FuzzytimeError, match=key):
        design.question(key).checked(answer)


def test_what_was_not_asked_is_not_found(design: Design) -> None:
    with pytest.raises(FuzzytimeError, match="must be one of in-now"):
        design.instruction("in-2")
    with pytest.raises(FuzzytimeError, match="no question"):
        design.question("income")
