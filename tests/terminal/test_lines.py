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
    "line",
    [
        *("# tonight", "  #tonight", "- [x] feed the cat", "[X] feed the cat", "☑ iron", "✓ iron"),
        *("- [-] iron", "- [>] iron", "* DONE iron", "DONE: iron", "CANCELED iron", "x 2026-03-04 iron"),
        *("~~iron~~", "- ~~iron at six~~.", "- [ ] ~~iron~~", "<!-- iron -->", "---", "* * *", "```sh"),
    ],
)
def test_a_comment_and_what_is_done_ask_for_nothing(line: str) -> None:
    assert said_in(line) == ""


@pytest.mark.parametrize("mark", ["- [ ] ", "* [] ", "[ ] ", "☐ ", "•", "▪ "])
def test_an_empty_box_is_no_part_of_what_is_asked_for(mark: str) -> None:
    assert said_in(f"{mark}feed the cat") == "feed the cat"


@pytest.mark.parametrize(
    "line",
    [
        *(
            "1. chop the onions",
            "- feed the cat",
            "• feed the cat",
            "call room #12",
            "[kitchen] wipe the table",
        ),
        *("done by six: the soup", "x-ray at nine", "call ~~mum~~ dad", "-- iron"),
    ],
)
def test_other_marks_are_words(line: str) -> None:
    assert said_in(line) == line


@pytest.mark.parametrize(
    ("line", "heading"),
    [
        ("## Saturday", "Saturday:"),
        ("### **To buy** ###", "To buy:"),
        ("## Call list:", "Call list:"),
        ("# Saturday", "Saturday:"),
        ("# Sat, 7th March", "Sat, 7th March:"),
    ],
)
def test_a_heading_is_one_for_the_lines_below(line: str, heading: str) -> None:
    assert said_in(line) == heading


@pytest.mark.parametrize(
    "line", ["# sat gym at 9", "#saturday", "# Saturday is Ann's", "##", "# friday 9.30"]
)
def test_what_says_more_than_a_day_behind_one_mark_is_a_comment(line: str) -> None:
    assert said_in(line) == ""


def test_all_marks_are_those_of_headings_in_markdown() -> None:
    lines = "# Weekend\n## Saturday\nvet 9.15\n"
    assert [words for _, words in said(lines)] == ["Weekend:", "Saturday:", "vet 9.15"]
    assert [wish.text for wish in wishes_of(Source("todo.md", "# Jobs\nring Jo\n"), NOW)] == [
        "Jobs:",
        "ring Jo",
    ]
    assert said("# Jobs\nring Jo\n") == [(2, "ring Jo")]


@pytest.mark.parametrize(
    "stamp", ["[07/03/2026, 08:41] ", "[3/7/26, 8:41:07 AM] ", "07/03/2026, 08:41 - ", "[2026-03-07 08:41] "]
)
def test_when_a_message_was_sent_is_no_time_of_what_it_says(stamp: str) -> None:
    assert said_in(f"{stamp}Ann Lee: vet at 3.40") == "Ann Lee: vet at 3.40"
    assert said_in("[9:30] Van: load chairs") == "[9:30] Van: load chairs"


def test_what_stands_in_front_of_a_page_of_markdown_is_none_of_it() -> None:
    assert said("---\ntitle: Saturday\ntags:\n  - home\n---\nvet 9.15\n") == [(6, "vet 9.15")]
    assert said("---\nvet at 9.15\n---\n") == [(2, "vet at 9.15")]


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
        ("8am – 6pm | Load in | Dock 2", "8am – 6pm Load in (Dock 2)"),
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


@pytest.mark.model
def test_a_heading_pasted_into_a_conversation_holds_for_the_lines_below() -> None:
    talk = Talk()
    (answer,) = talk.paste("## Saturday", "- [ ] call mum at noon", "- [ ] iron the shirts at two")
    assert "Sat 12:00" in answer
    assert "Sat 14:00" in answer


@pytest.mark.parametrize("hour", ["4.30 pm", "16:30", "4pm", "3 - 4 p.m.", "9:30 – 10:15"])
def test_an_hour_on_a_line_of_its_own_is_that_of_what_is_below(hour: str) -> None:
    assert said(f"{hour}\n\nPortraits\nCake") == [(3, f"{hour} Portraits"), (4, "Cake")]


def test_a_bullet_below_an_hour_is_no_part_of_what_is_then() -> None:
    assert said("4 pm\n- Portraits\n- Cake") == [(2, "4 pm Portraits"), (3, "- Cake")]
    assert said("4 - 5 pm\n- Portraits") == [(1, "4 - 5 pm"), (2, "- Portraits")]


@pytest.mark.parametrize("below", ["5 pm cake", "Sunday:"])
def test_an_hour_alone_stays_so_above_another_or_a_heading(below: str) -> None:
    assert said(f"4.30 pm\n{below}") == [(1, "4.30 pm"), (2, below)]


def test_a_number_alone_is_no_hour() -> None:
    assert said("4\nPortraits") == [(1, "4"), (2, "Portraits")]
