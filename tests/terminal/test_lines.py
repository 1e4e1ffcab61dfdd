"""What a line of a file asks for: nothing where it is a comment or ticked off; marks of lists say nothing."""

from datetime import datetime

import pytest

from fuzzytime_cli.faults import NoInputError
from fuzzytime_cli.inputs.lines import said_in, wishes_of
from fuzzytime_cli.inputs.source import Source
from terminal.talking import Talk

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - the tests' moment is of no zone


def said(text: str) -> list[tuple[int | None, str]]:
    return [(wish.line, wish.text) for wish in wishes_of(Source("todo.txt", text), NOW)]


@pytest.mark.parametrize(
    "line", ["# tonight", "  #tonight", "- [x] feed the cat", "[X] feed the cat", "☑ iron", "✓ iron"]
)
def test_a_comment_and_what_is_done_ask_for_nothing(line: str) -> None:
    assert said_in(line) == ""


@pytest.mark.parametrize("mark", ["- [ ] ", "* [] ", "[ ] ", "☐ ", "• ", "•", "▪ "])
def test_an_empty_box_is_no_part_of_what_is_asked_for(mark: str) -> None:
    assert said_in(f"{mark}feed the cat") == "feed the cat"


@pytest.mark.parametrize(
    "line", ["1. chop the onions", "- feed the cat", "call room #12", "[kitchen] wipe the table"]
)
def test_other_marks_are_words(line: str) -> None:
    assert said_in(line) == line


def test_a_comment_may_stand_behind_an_instruction() -> None:
    assert said("stir the soup soon  # the red pot\ncall room #12\n") == [
        (1, "stir the soup soon"),
        (2, "call room #12"),
    ]


@pytest.mark.parametrize(
    ("row", "line"),
    [
        ("| 7.30 | Load in, dock 2 | all |", "7.30 Load in, dock 2 (all)"),
        ("| by 8.00 | Truck away | |", "by 8.00 Truck away"),
        ("| Line check | 9.45 - 10 | Ash |", "Line check 9.45 - 10 (Ash)"),
        ("| 11 | Keynote | 45 min | Hall A |", "11 Keynote (45 min) (Hall A)"),
        ("10.30\tMeet the guide\tMr Lee", "10.30 Meet the guide (Mr Lee)"),
        ("9.45 | Line check", "9.45 Line check"),
    ],
)
def test_a_row_of_a_table_is_a_line(row: str, line: str) -> None:
    assert said(row) == [(1, line)]


@pytest.mark.parametrize("line", ["10am vet | 12 lunch | 3pm bank", "vet 10\tlunch 12", "call Ann | Bob"])
def test_entries_with_marks_between_them_are_no_row(line: str) -> None:
    assert said(line) == [(1, line)]


def test_the_heads_of_a_table_are_nothing_to_do() -> None:
    assert said("| Time | What |\n|:---|---|\n| 9.45 | Line check |") == [(3, "9.45 Line check")]


def test_a_list_that_is_all_done_holds_no_instruction() -> None:
    with pytest.raises(NoInputError, match="comments"):
        said("# today\n- [x] feed the cat\n")


@pytest.mark.model
def test_a_list_pasted_into_a_conversation_loses_its_marks_too() -> None:
    talk = Talk()
    talk.paste("# today", "- [x] feed the cat", "- [ ] call mum at noon")
    assert talk.entries == ["call mum at noon"]
