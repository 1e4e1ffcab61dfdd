"""Every format is read back by a reader that is not ours."""

import csv
import io
import json
import subprocess
import sys
from datetime import timedelta
from pathlib import Path
from xml.dom import minidom

import icalendar
import pytest

from console import environment
from fuzzytime_cli.formats.series import SHOWN
from terminal.running import ran

NOW = ("--now", "2026-03-04T09:00", "--zone", "Europe/Berlin")
HOSTILE = (
    'Paint "=cmd|/C calc!A0" \x1b]52;c;aGk=\x07 \u202egnp\u202c <script>alert(1)</script> & [red]x[/red] now'
)


def written(tmp_path: Path, kind: str, *arguments: str) -> str:
    done = ran("plan", *arguments, "--format", kind, *NOW, folder=tmp_path)
    assert done.code == 0, done.err
    return done.out


def test_json_lines_are_one_skill_a_line_and_then_the_plan(tmp_path: Path) -> None:
    lines = [json.loads(line) for line in written(tmp_path, "jsonl", "examples/breakfast.txt").splitlines()]
    whole = json.loads(written(tmp_path, "json", "examples/breakfast.txt"))
    assert [line.pop("type") for line in lines] == ["skill"] * 10 + ["plan"]
    assert [line["start_s"] for line in lines[:-1]] == [skill["start_s"] for skill in whole["skills"]]
    assert lines[-1]["satisfaction"] == whole["satisfaction"]


def test_csv_has_one_row_a_skill_in_the_order_of_time(tmp_path: Path) -> None:
    rows = list(csv.DictReader(io.StringIO(written(tmp_path, "csv", "examples/breakfast.txt"))))
    assert len(rows) == 10
    assert [row["start"] for row in rows] == sorted(row["start"] for row in rows)
    assert {row["id"] for row in rows} == {f"s{number}" for number in range(1, 11)}


def test_a_calendar_has_one_event_a_skill_in_utc(tmp_path: Path) -> None:
    whole = json.loads(written(tmp_path, "json", "examples/breakfast.txt"))
    calendar = icalendar.Calendar.from_ical(written(tmp_path, "ics", "examples/breakfast.txt"))
    events = calendar.walk("VEVENT")
    assert sorted(str(event["SUMMARY"]) for event in events) == sorted(s["name"] for s in whole["skills"])
    first = min(event.decoded("DTSTART") for event in events)
    assert first.isoformat() == "2026-03-04T08:00:00+00:00"


def test_what_happens_by_itself_is_in_a_calendar_as_long_as_it_goes_on(tmp_path: Path) -> None:
    told = ("-i", "I have a meeting at 11 pm for two hours", "-i", "The guests come at noon")
    events = icalendar.Calendar.from_ical(written(tmp_path, "ics", *told)).walk("VEVENT")
    meeting, guests = sorted(events, key=lambda event: str(event["SUMMARY"]).lower())
    assert meeting.decoded("DTEND") - meeting.decoded("DTSTART") == timedelta(hours=2)
    assert "DTEND" not in guests
    assert "Thu 01:00" in written(tmp_path, "table", *told)


@pytest.mark.parametrize("kind", ["table", "csv", "html"])
def test_what_is_not_to_be_done_then_is_not_shown_as_asked_for_then(kind: str, tmp_path: Path) -> None:
    assert "not before 6 pm" in written(tmp_path, kind, "-i", "Don't open the oven before 6 pm")


@pytest.mark.parametrize("kind", ["svg", "html"])
def test_pictures_and_pages_are_well_formed_and_load_nothing(kind: str, tmp_path: Path) -> None:
    text = written(tmp_path, kind, "examples/workshop.yaml")
    body = text[text.index("<svg") : text.index("</svg>") + 6]
    document = minidom.parseString(body)  # noqa: S318 - our own output
    assert len(document.getElementsByTagName("rect")) >= 11
    assert "http" not in text.replace("http://www.w3.org/2000/svg", "").replace("http-equiv", "")
    assert "<script" not in text


@pytest.mark.parametrize(
    ("clause", "reading", "word"),
    [
        ("the pan is above 300 degrees", "pan_temp=100", "rejected"),
        ("the washing machine is done", "washer_power=150", "waits"),
        ("the washing machine is done", None, "waits"),
    ],
)
def test_what_has_no_time_has_no_bar_in_a_picture(
    tmp_path: Path, clause: str, reading: str | None, word: str
) -> None:
    wishes = ["-i", f"Hang up the laundry when {clause}", "-i", "Stir the soup now"]
    wishes += ["--ctx", reading] if reading else []
    document = minidom.parseString(written(tmp_path, "svg", *wishes))  # noqa: S318 - our own output
    words = [getattr(node.firstChild, "data", "") for node in document.getElementsByTagName("text")]
    assert {"hang up the laundry", word} <= set(words)
    bars = [node for node in document.getElementsByTagName("rect") if not _in_legend(node)]
    assert len(bars) == 1


def test_a_picture_says_what_its_shapes_mean_and_of_no_others(tmp_path: Path) -> None:
    def legend(*arguments: str) -> list[str]:
        document = minidom.parseString(written(tmp_path, "svg", *arguments))  # noqa: S318 - our own output
        texts = [node for node in document.getElementsByTagName("text") if _in_legend(node)]
        return [getattr(node.firstChild, "data", "") for node in texts]

    shading = "how well a start there would satisfy"
    workshop = [shading, "at work", "goes on by itself", "time that is taken"]
    assert legend("examples/workshop.yaml") == workshop
    assert legend("-i", "Stir the soup now") == [shading, "at work"]
    assert legend("-i", "Flip the pancakes when the pan is hot") == [shading]
    task = tmp_path / "crowd.yaml"
    curves = "".join(
        f"  - {{name: {name}, duration: 10 min, satisfaction: {{trapezoid: [0 s, 60 s, 120 s, {end} s]}}}}\n"
        for name, end in (("weld", 600), ("paint", 1200), ("glue", 1500))
    )
    task.write_text(f"skills:\n{curves}")
    assert legend(str(task)) == [
        shading,
        "at work",
        "at work, satisfied in part",
        "at work, hardly satisfied",
    ]


def test_a_picture_for_several_says_who_does_what(tmp_path: Path) -> None:
    text = written(tmp_path, "svg", "-i", "Stir the soup now", "-i", "Feed the cat now", "--agents", "2")
    assert ">by 1: 1.00<" in text
    assert ">by 2: 1.00<" in text


def test_names_of_taken_times_do_not_cover_each_other(tmp_path: Path) -> None:
    task = tmp_path / "task.yaml"
    task.write_text(
        "now: 2026-03-04T09:00\ninstructions: [Call mum at noon]\nbusy:\n"
        "- {from: '09:10', to: '11:00', what: Spring fair}\n"
        "- {from: '09:20', to: '11:10', what: Autumn show}\n"
        "- {from: '11:20', to: '11:50', what: Tea}\n"
    )
    text = written(tmp_path, "svg", str(task))
    assert [f">{name}</text>" in text for name in ("Spring fair", "Autumn show", "Tea")] == [
        True,
        False,
        True,
    ]
    assert "<title>Autumn show</title>" in text


def test_a_picture_of_nothing_says_so(tmp_path: Path) -> None:
    done = ran("plan", "-i", "flurb at 25:99 pm", "--format", "svg", *NOW, folder=tmp_path)
    assert "Wednesday 4 March 2026: nothing to plan" in done.out


def _in_legend(node: minidom.Element) -> bool:
    group = node.parentNode
    return isinstance(group, minidom.Element) and group.getAttribute("class") == "legend"


def test_typed_text_reaches_no_output_raw(tmp_path: Path) -> None:
    for kind in ("table", "json", "jsonl", "csv", "ics", "html", "svg"):
        text = written(tmp_path, kind, "-i", HOSTILE)
        assert not set(text) & {"\x1b", "\x07", "\u202e", "\u202c", "\x9b"}, kind
        assert "<script>" not in text or kind in {"table", "csv", "ics", "json", "jsonl"}
    assert json.loads(written(tmp_path, "json", "-i", HOSTILE))["skills"][0]["instruction"] == HOSTILE


def test_no_cell_starts_a_formula(tmp_path: Path) -> None:
    rows = csv.reader(
        io.StringIO(written(tmp_path, "csv", "-i", "=1+1 stir the soup now", "-i", "@sum the bill now"))
    )
    for row in rows:
        assert not any(cell.lstrip().startswith(("=", "@", "+", "-")) for cell in row)


def test_a_file_is_written_whole_or_not_at_all(tmp_path: Path) -> None:
    target = tmp_path / "plan.json"
    target.write_text("as it was")
    failed = ran("plan", "no_such_file", "-o", str(target), folder=tmp_path)
    assert failed.code != 0
    assert target.read_text() == "as it was"
    ran("plan", "-i", "stir the soup now", "--format", "json", "-o", str(target), *NOW, folder=tmp_path)
    assert json.loads(target.read_text())["skills"]
    assert [path.name for path in tmp_path.iterdir() if path.name.startswith(".plan")] == []


@pytest.mark.parametrize("columns", ["20", "40", "60", "80", "100", "160"])
def test_the_table_fits_the_screen(columns: str, tmp_path: Path) -> None:
    done = ran("plan", "examples/breakfast.txt", *NOW, folder=tmp_path, COLUMNS=columns)
    widest = max(len(line) for line in done.out.splitlines())
    assert widest <= max(int(columns), 36)


@pytest.mark.parametrize(("name", "value"), [("NO_COLOR", "1"), ("TERM", "dumb"), ("TERM", "xterm")])
def test_a_pipe_gets_no_colour(name: str, value: str, tmp_path: Path) -> None:
    done = ran("plan", "examples/breakfast.txt", *NOW, folder=tmp_path, stdin=b"", **{name: value})
    assert "\x1b" not in done.out


def test_colour_comes_where_it_is_forced(tmp_path: Path) -> None:
    done = ran("plan", "examples/breakfast.txt", *NOW, folder=tmp_path, FORCE_COLOR="1")
    assert "\x1b[" in done.out


def test_a_page_says_each_problem_once(tmp_path: Path) -> None:
    words = ("-i", "Flip the pancakes when the pan is hot", "-i", "Stir the soup for a while")
    page = written(tmp_path, "html", *words)
    assert page.count("not enough readings of pan_temp") == 1
    assert page.count("how long is not said") == 1


def test_notes_with_the_same_advice_are_told_together_and_json_has_them_all(tmp_path: Path) -> None:
    wishes = [word for hour in range(1, 12) for word in ("-i", f"Water plant {hour} at {hour}")]
    table, whole = written(tmp_path, "table", *wishes), json.loads(written(tmp_path, "json", *wishes))
    said = [problem["message"] for problem in whole["problems"] if problem["kind"] == "note"]
    assert len(said) == 11
    assert table.count("note: ") == table.count("say am or pm") == 1
    told = " ".join(table.partition("note: ")[2].split())
    assert told.startswith(f"{said[0].removesuffix(': say am or pm')}; 'at 2' is taken as ")
    assert "; and 3 more: say am or pm" in told
    once = written(tmp_path, "table", "-i", "Call mum at six", "-i", "Call dad at six")
    assert once.count("'at six' is taken as") == 1


def test_seconds_are_shown_where_minutes_are_not_enough(tmp_path: Path) -> None:
    def table(*texts: str) -> str:
        instructions = [part for text in texts for part in ("-i", text)]
        return ran("plan", *instructions, "--now", "2026-03-04T09:00:42", folder=tmp_path).out

    minutes = table("Stir the soup now", "Call mum in about 20 minutes")
    assert "s1 09:01 09:02" in minutes
    assert "s2 09:21 09:31" in minutes
    assert "s1 09:00:42 09:01:42" in table("Stir the soup now")
    later = "Call mum in about 20 minutes"
    assert "s1 09:00:42 09:01:12" in table("Pour the coffee now")
    assert "s1 09:01 09:01" in table("Pour the coffee now", later)
    rows = table("Stir the soup for 20 seconds now", later).splitlines()
    assert [row.split()[1:3] for row in rows[1:3]] == [["09:00:42", "09:01:02"], ["09:21", "09:31"]]


def test_many_occurrences_that_go_as_asked_stand_in_one_row(tmp_path: Path) -> None:
    said = ("-i", "check the ewe every 20 minutes until noon", "-i", "milk at 11 am")
    lines = ran("plan", *said, *NOW, folder=tmp_path).out.splitlines()
    rows = [line for line in lines if "check the ewe" in line or "more, until" in line]
    assert len(rows) == SHOWN + 1
    assert rows[-1].split() == ["…", "10:20", "and", "6", "times", "more,", "until", "12:02"]
    assert len(json.loads(written(tmp_path, "json", *said))["skills"]) == SHOWN + 6 + 1


def test_a_picture_tells_each_start_in_figures(tmp_path: Path) -> None:
    wishes = ("-i", "Wash the car at 11 pm for three hours", "-i", "Sleep at 2 am")
    drawn = ran("plan", *wishes, "--format", "svg", "--now", "2026-03-04T21:00", folder=tmp_path).out
    assert ">start<" in drawn
    assert ">23:00<" in drawn
    assert ">Thu 02:00<" in drawn


@pytest.mark.parametrize(
    ("form", "shown"),
    [
        ("table", b"call Zo\\xeb"),
        ("csv", b"call Zo\xc3\xab"),
        ("ics", b"call Zo\xc3\xab"),
        ("svg", b"Zo\xc3\xab"),
    ],
)
def test_what_a_terminal_has_no_letters_for_is_written_all_the_same(
    form: str, shown: bytes, tmp_path: Path
) -> None:
    written = subprocess.run(
        [sys.executable, "-m", "fuzzytime_cli", "plan", "-i", "Call Zoë soon", "--format", form],
        env={**environment(tmp_path), "PYTHONIOENCODING": "ascii"},
        capture_output=True,
        check=True,
    )
    assert shown in written.stdout
