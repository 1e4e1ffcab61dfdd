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


def test_a_list_that_is_all_done_holds_no_instruction() -> None:
    with pytest.raises(NoInputError, match="comments"):
        said("# today\n- [x] feed the cat\n")


@pytest.mark.model
def test_a_list_pasted_into_a_conversation_loses_its_marks_too() -> None:
    talk = Talk()
    talk.paste("# today", "- [x] feed the cat", "- [ ] call mum at noon")
    assert talk.entries == ["call mum at noon"]
