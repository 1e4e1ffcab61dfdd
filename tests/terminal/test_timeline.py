"""The lanes of a plan on a terminal."""

from datetime import datetime
from pathlib import Path

import pytest

from fuzzytime.satisfaction import NEVER, Bell, Sampled, SatisfactionFunction, Trapezoid, Triangle
from fuzzytime_cli.clock import Clock
from fuzzytime_cli.drawing.ticks import axis, ticks
from fuzzytime_cli.formats.timeline import SHADES, Window, shades
from terminal.running import ran

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - of no zone
DAYS = Window(0.0, 5 * 86400.0, 72)


@pytest.mark.parametrize(
    "narrow",
    [
        Triangle(100_030, 100_060, 100_090),
        Trapezoid(-5, 0, 0, 5),
        Bell(centre=100_060, width=10, slope=2),
        Sampled([431_990, 431_995, 431_999], [0, 1, 0]),
    ],
)
def test_a_wish_narrower_than_a_column_is_seen(narrow: SatisfactionFunction) -> None:
    row = shades(narrow, DAYS)
    assert row.count(SHADES[-1]) == 1
    assert row[DAYS.column(narrow.best.low)] == SHADES[-1]


@pytest.mark.parametrize("plain", [NEVER, Trapezoid(-5, 0, 500_000, 500_000)])
def test_what_says_nothing_of_the_time_has_an_empty_lane(plain: SatisfactionFunction) -> None:
    assert set(shades(plain, DAYS)) == {" "}


@pytest.mark.model
@pytest.mark.parametrize(
    ("text", "begins"),
    [
        ("Call mum in two minutes", "09:00"),
        ("Call mum at 11 am", "09:00"),
        ("Call mum tomorrow at noon", "Thu 12:00"),
        ("Call mum on saturday at noon", "Sat 12:00"),
    ],
)
def test_a_picture_begins_now_unless_all_is_far_ahead(tmp_path: Path, text: str, begins: str) -> None:
    lines = ran("plan", "-i", text, "--now", "2026-03-04T09:00", folder=tmp_path).out.splitlines()
    axis_line = next(line for line in lines if "╵" in line)
    assert axis_line.split("╵")[1].strip().startswith(begins)


def test_a_column_has_the_shade_of_its_best_start() -> None:
    assert "".join(shades(Trapezoid(2, 4, 6, 8), Window(0, 10, 10))) == "  ▒▓▓▓▓▒  "


@pytest.mark.parametrize("columns", [30, 46, 66, 120])
@pytest.mark.parametrize("days", [0.001, 0.01, 0.2, 3, 6, 10, 40, 300, 500, 3000])
def test_words_of_an_axis_are_whole_and_apart(columns: int, days: float) -> None:
    window = Window(0.0, days * 86400.0, columns)
    line = axis(columns, columns // 10, (window.start, window.end), NOW, window.column)
    assert len(line) <= columns
    labels = line.split("╵")[1:]
    shown = {tick.label for most in range(1, 13) for tick in ticks(window.start, window.end, most, NOW)}
    assert labels
    assert {label.rstrip() for label in labels} <= shown
    assert all(label.endswith(" ") for label in labels[:-1])


@pytest.mark.parametrize(
    ("seconds", "shown"),
    [
        (0, "09:00"),
        (86_400, "Thu 09:00"),
        (7 * 86_400, "11 Mar 09:00"),
        (363 * 86_400, "02 Mar 2027 09:00"),
        (-3600 * 10, "03 Mar 23:00"),
    ],
)
def test_a_time_names_its_day_and_its_year_where_they_are_others(seconds: float, shown: str) -> None:
    assert Clock.to_minutes(NOW).of(seconds) == shown


def test_an_end_names_its_day_where_it_is_another_than_that_of_the_start() -> None:
    clock = Clock.to_minutes(NOW)
    assert clock.end_of(86_400, 86_400 + 600) == "09:10"
    assert clock.end_of(14 * 3600, 16 * 3600) == "Thu 01:00"


@pytest.mark.model
@pytest.mark.parametrize(
    ("wishes", "told", "untold"),
    [
        (["Call mum at 11 am"], ["█", "░▒▓"], ["─", "×"]),
        (["Boil the eggs in two minutes"], ["█", "─ goes on by itself", "░▒▓"], ["× time"]),
        (["Dentist on the 12th at 3 pm", "Visit gran next christmas"], ["█", "×"], ["─", "░▒▓"]),
    ],
)
def test_the_legend_says_what_each_mark_means_and_of_no_others(
    wishes: list[str], told: list[str], untold: list[str], tmp_path: Path
) -> None:
    said = [part for wish in wishes for part in ("-i", wish)]
    out = ran("plan", *said, "--now", "2026-03-04T09:00", folder=tmp_path).out
    legend = " ".join(out[out.index("█ at work") :].split("\n\n")[0].split())
    assert [mark for mark in told if f"{mark} " in f"{legend} "] == told
    assert not any(mark in legend for mark in untold)
