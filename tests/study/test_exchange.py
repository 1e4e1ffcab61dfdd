import csv
import io
import json
from dataclasses import replace

import numpy as np
import pytest

from fuzzytime.errors import FuzzytimeError
from fuzzytime.study import Answers, Design, Participant
from fuzzytime.study.answers.exchange import read_csv, read_json, write_csv, write_json


def as_csv(answers: Answers) -> str:
    stream = io.StringIO()
    write_csv(answers, stream)
    return stream.getvalue()


def as_json(answers: Answers) -> str:
    stream = io.StringIO()
    write_json(answers, stream)
    return stream.getvalue()


def facts(answers: Answers) -> list[object]:
    return [
        (
            replace(person, curves={}),
            {key: curve.tolist() for key, curve in sorted(person.curves.items())},
        )
        for person in answers.participants
    ]


@pytest.fixture(scope="module")
def some(answers: Answers) -> Answers:
    first, second, third = answers.participants[:3]
    odd = {**second.demographics, "culture": '=HYPERLINK("x"), "quoted"\nand a new line'}
    return Answers(
        answers.design,
        (
            replace(first, control=None, excluded="'=1+1"),
            replace(second, demographics=odd),
            replace(third, curves={}, order=(), finished=False, demographics={}),
        ),
    )


def same(one: Answers, other: Answers) -> None:
    for a, b in zip(one.participants, other.participants, strict=True):
        assert {key: curve.tolist() for key, curve in a.curves.items()} == {
            key: curve.tolist() for key, curve in b.curves.items()
        }
        for name in ("name", "group", "order", "demographics", "control", "origin", "finished", "excluded"):
            assert getattr(a, name) == getattr(b, name)


def test_csv_comes_back_exactly(some: Answers) -> None:
    same(read_csv(io.StringIO(as_csv(some), newline=""), some.design), some)


def test_json_comes_back_exactly_with_its_design(some: Answers) -> None:
    again = read_json(as_json(some))
    same(again, some)
    assert again.design.instructions == some.design.instructions


def test_csv_has_one_row_per_sample(some: Answers) -> None:
    rows = list(csv.DictReader(io.StringIO(as_csv(some), newline="")))
    assert len(rows) == 2 * 14 * 800 + 1
    assert list(rows[0])[:4] == ["participant", "actor", "origin", "finished"]
    first = some.participants[0]
    assert rows[0]["instruction"] == first.order[0]
    assert [float(row["time_s"]) for row in rows[:3]] == [0, 4.5, 9]
    assert float(rows[700]["satisfaction"]) == first.curves[first.order[0]][700]


def test_no_cell_is_a_formula(some: Answers) -> None:
    for row in csv.reader(io.StringIO(as_csv(some), newline="")):
        for cell in row:
            assert not cell.startswith(("=", "@", "\t", "\r", "+"))
            assert not cell.startswith("-") or float(cell) < 0


def test_samples_at_other_times_are_interpolated(design: Design) -> None:
    text = (
        "participant,actor,instruction,time_s,satisfaction\n"
        "a,robot,soon,120,0\na,robot,soon,0,1\na,robot,soon,60,1\n"
    )
    (person,) = read_csv(io.StringIO(text), design).participants
    times = design.timeline.times
    expected = np.interp(times, [0, 60, 120], [1, 1, 0], right=0)
    assert person.curves["soon"] == pytest.approx(expected)
    assert person.origin == "imported"


@pytest.mark.parametrize(("delimiter", "point"), [(";", ","), ("\t", ","), (";", "."), (",", ".")])
def test_answers_come_back_from_a_spreadsheet_that_writes_decimal_commas(
    some: Answers, delimiter: str, point: str
) -> None:
    rows = [[cell.replace(".", point) for cell in row] for row in csv.reader(io.StringIO(as_csv(some)))]
    saved = io.StringIO()
    csv.writer(saved, delimiter=delimiter).writerows([*rows, [""] * len(rows[0])])
    text = "\ufeff" + saved.getvalue()
    back = read_csv(io.StringIO(text, newline=""), some.design)
    for person, other in zip(back.participants, some.participants, strict=True):
        assert person.curves.keys() == other.curves.keys()
        for key, curve in person.curves.items():
            assert curve.tolist() == other.curves[key].tolist()


HEAD = "participant,actor,instruction,time_s,satisfaction,control,about_age\n"


@pytest.mark.parametrize(
    ("text", "rule"),
    [
        ("", "x.csv:1: .*header"),
        ("participant,time_s\n", "x.csv:1: .*column 'instruction'"),
        (HEAD + "a,robot,soon,0,1.5,,\n", "x.csv:2: satisfaction must lie in"),
        (HEAD + "a,robot,soon,0,nan,,\n", "x.csv:2: satisfaction must be finite"),
        (HEAD + "a,robot,soon,soon,1,,\n", "x.csv:2: time_s must be a number"),
        (HEAD + "a,robot,later,0,1,,\n", "x.csv:2: an instruction must be one of"),
        (HEAD + "a,dog,soon,0,1,,\n", "x.csv:2: actor must be one of robot, person"),
        (HEAD + ",robot,soon,0,1,,\n", "x.csv:2: a participant must have a name"),
        (HEAD + "a,robot,soon,0,1,,\na,person,soon,1,1,,\n", "x.csv:3: .*one actor"),
        (HEAD + "a,robot,soon,0,1\n", "x.csv:2: a row must have 7 cells, got 5"),
        (HEAD + "a,robot,soon,0,1,,\na,robot,soon,0,1,,\n", "x.csv:2: participant 'a': .*0 s twice"),
        (HEAD + "a,robot,soon,0,1,often,\n", "x.csv:2: participant 'a': control must be a number"),
        (HEAD + "a,robot,soon,0,1,,3\n", "x.csv:2: participant 'a': age must be"),
        (HEAD + 'a,robot,soon,"0,1,,\n', "not valid CSV"),
    ],
)
def test_a_mistake_in_csv_is_said_with_its_line(design: Design, text: str, rule: str) -> None:
    with pytest.raises(FuzzytimeError, match=rule):
        read_csv(io.StringIO(text), design, "x.csv")


@pytest.mark.parametrize(
    "change",
    [
        lambda d: d.pop("participants"),
        lambda d: d.update(schema="fuzzytime-study/9"),
        lambda d: d.update(design="name: x"),
        lambda d: d.update(design=3),
        lambda d: d.update(times_s=[0, 1]),
        lambda d: d.update(times_s=None),
        lambda d: d["participants"][0].pop("actor"),
        lambda d: d["participants"][0].update(control="3"),
        lambda d: d["participants"][0].update(curves=[]),
        lambda d: d["participants"][0]["curves"].update(soon=["x"] * 800),
        lambda d: d["participants"][0]["curves"].update(later=[0] * 800),
    ],
)
def test_json_that_is_no_study_is_refused(some: Answers, change: object) -> None:
    document = json.loads(as_json(some))
    change(document)  # type: ignore[operator]
    with pytest.raises(FuzzytimeError):
        read_json(json.dumps(document))


@pytest.mark.parametrize("text", ["", "[", "[]", "null", "[" * 100_000, '{"schema": "fuzzytime-study/1"}'])
def test_text_that_is_no_document_is_refused(text: str) -> None:
    with pytest.raises(FuzzytimeError, match=r"x\.json(:\d+:\d+)?: "):
        read_json(text, "x.json")


def test_an_imported_curve_may_be_anybodys(design: Design) -> None:
    person = Participant(name="a,b\n'", group="robot", order=("soon",), curves={"soon": np.zeros(800)})
    (again,) = read_csv(io.StringIO(as_csv(Answers(design, (person,))), newline=""), design).participants
    assert again.name == person.name.strip()
