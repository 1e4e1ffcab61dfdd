"""Readings from comma-separated values."""

from datetime import datetime
from zoneinfo import ZoneInfo

import pytest

from fuzzytime.context import Context, Signal, read_context_lines
from fuzzytime.errors import DocumentError

SIGNALS = {
    "pan_temp": Signal(name="pan_temp", unit="degC", low=0, high=350),
    "oven_temp": Signal(name="oven_temp", unit="degC", low=0, high=350),
    "timer": Signal(name="timer", event=True),
}
NOW = datetime(2026, 3, 4, 9, 0, tzinfo=ZoneInfo("Europe/Berlin"))


def read(text: str | bytes) -> Context:
    return read_context_lines(text, "readings.csv", NOW, SIGNALS)


def values(context: Context) -> list[tuple[str, float, float | None]]:
    return [(r.signal, r.at, None if r.value is None else round(r.value, 6)) for r in context.readings]


def test_a_row_is_a_reading_where_a_column_names_the_signal() -> None:
    read_in = read(
        "signal,at_s,value,unit\npan_temp,-5,356,degF\npan_temp,-60,80,\n\npan_temp,0,180 degC,\ntimer,60,,\n"
    )
    assert values(read_in) == [
        ("pan_temp", -60, 80),
        ("pan_temp", -5, 180),
        ("pan_temp", 0, 180),
        ("timer", 60, None),
    ]


@pytest.mark.parametrize("delimiter", [",", ";", "\t"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_a_row_is_a_moment_where_columns_name_signals(delimiter: str, encoding: str, end: str) -> None:
    rows = ["at,pan_temp,oven_temp", "2026-03-04T08:59:30,80,", "2026-03-04 08:59,75,20", '"",,']
    raw = end.join(rows).replace(",", delimiter).encode(encoding)
    assert values(read(raw)) == [("oven_temp", -60, 20), ("pan_temp", -60, 75), ("pan_temp", -30, 80)]


@pytest.mark.parametrize(("delimiter", "point"), [(";", ","), ("\t", ","), (";", "."), (",", ".")])
def test_decimals_may_have_a_comma_where_cells_have_another_sign_between(delimiter: str, point: str) -> None:
    rows = ["at_s|pan_temp", "-1.5|+60.25", "-60|.5 degC", "-70|140 degF"]
    text = "\n".join(row.replace(".", point).replace("|", delimiter) for row in rows)
    assert values(read(text)) == [("pan_temp", -70, 60), ("pan_temp", -60, 0.5), ("pan_temp", -1.5, 60.25)]


@pytest.mark.parametrize(
    ("text", "place", "message"),
    [
        ("at_s,pan_tmp\n0,3", "1:6", "unknown signal 'pan_tmp' (did you mean 'pan_temp'?)"),
        ("signal,at_s,valu\npan_temp,0,3", "1:13", "unknown column 'valu' (did you mean 'value'?)"),
        ("at_s,pan_temp,pan_temp\n0,3,4", "1:6", "columns must differ, got 'pan_temp' twice"),
        ("at_s,pan_temp\n0,3\n-5,hot", "3:4", "a value must be a number and perhaps a unit"),
        ("at_s,pan_temp,oven_temp\n0,3,900", "2:5", "'oven_temp' must lie between 0 and 350 degC, got 900"),
        ("at_s,pan_temp\nsoon,3", "2:1", "'at_s' must be a number of seconds, got 'soon'"),
        ("pan_temp,at_s\n3,nan", "2:3", "'at_s' must be finite"),
        ("pan_temp,at\n3,9 o'clock", "2:3", "a date and time must look like"),
        ("pan_temp,at_s\n3,5", "2:3", "a reading must not lie in the future, got 5 s"),
        ("at_s,pan_temp\n0,3,4", "2:1", "a row must have as many cells as the head, 2, got 3"),
        ("at_s,pan_temp\n,3", "2:1", "a row must have a time"),
        ("signal,value,unit\npan_temp,3,kg", "2:10", "a value in 'kg' cannot be converted to 'degC'"),
        ("signal,value\n,3", "2:1", "'signal' must be a name"),
        ('at_s,pan_temp\n0,"3', "2:1", "a row must be cells with commas between"),
        (b"at_s,pan_temp\n0,\xff", "2:3", "text must be UTF-8, got byte 0xff"),
        (b"\xff\xfea", "1:1", "text that begins as UTF-16 must be UTF-16"),
    ],
)
def test_a_cell_that_is_wrong_is_named(text: str | bytes, place: str, message: str) -> None:
    with pytest.raises(DocumentError) as caught:
        read(text)
    (mistake,) = caught.value.mistakes
    assert (f"{mistake.line}:{mistake.column}", message in mistake.message) == (place, True)


def test_all_wrong_rows_come_at_once() -> None:
    with pytest.raises(DocumentError) as caught:
        read("at_s,pan_temp\n0,hot\n0,3\nx,3\n0\n")
    assert [mistake.line for mistake in caught.value.mistakes] == [2, 4, 5]


def test_readings_are_bounded() -> None:
    with pytest.raises(DocumentError, match="at most 200,000 readings"):
        read("at_s,pan_temp\n" + "".join(f"-{n},20\n" for n in range(200_002)))
