import csv
import io
import json
import re
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.errors import DocumentError
from fuzzytime.satisfaction import Trapezoid
from fuzzytime.study import Answers, Design, Participant, simulate
from fuzzytime.study.answers.as_csv import read_csv, write_csv
from fuzzytime.study.answers.as_json import read_json, write_json


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
        ("", "1:1: .*header"),
        ("participant,time_s\n", "1:1: .*column 'instruction'"),
        (HEAD.replace("control", "actor"), "1:13: columns must differ"),
        (HEAD.replace("about_age", "about_ages"), "1:59: the study asks nothing for 'about_ages'.*about_age"),
        (HEAD + "a,robot,soon,0,1.5,,\n", "2:16: satisfaction must lie in"),
        (HEAD + "a,robot,soon,0,nan,,\n", "2:16: satisfaction must be finite"),
        (HEAD + "a,robot,soon,soon,1,,\n", "2:14: time_s must be a number"),
        (HEAD + "a,robot,later,0,1,,\n", "2:9: an instruction must be one of"),
        (HEAD + "a,dog,soon,0,1,,\n", "2:3: actor must be one of robot, person"),
        (HEAD + "a,,soon,0,1,,\n", "2:3: actor must be one of robot, person"),
        (HEAD + ",robot,soon,0,1,,\n", "2:1: a participant must have a name"),
        (HEAD + "a,robot,soon,0,1,,\na,person,soon,1,1,,\n", "3:3: .*one actor"),
        (HEAD + "a,robot,soon,0,1,2,\na,robot,soon,1,1,3,\n", "3:18: .*one control, got '3' and '2'"),
        (HEAD + "a,robot,soon,0,1\n", "2:1: a row must have 7 cells, got 5"),
        (HEAD + "a,robot,soon,0,1,,\na,robot,soon,0,1,,\n", "3:14: .*0 s twice"),
        (HEAD + "a,robot,soon,0,1,often,\n", "2:18: control must be a number"),
        (HEAD + "a,robot,soon,0,1,2.5,\n", "2:18: control must be a whole number"),
        (HEAD + "a,robot,soon,0,1,6,\n", "2:18: the answer must be one of 1 to 5"),
        (HEAD + "a,robot,soon,0,1,,\na,robot,soon,1,1,,3\n", "3:19: age must be"),
        (HEAD + 'a,robot,soon,"0,1,,\n', "2:1: not valid CSV"),
        (
            HEAD.replace("control", "finished") + "a,robot,soon,0,1,perhaps,\n",
            "2:18: finished must be 1 or 0",
        ),
        (HEAD.replace("control", "origin") + "a,robot,soon,0,1,drawn,\n", "2:18: origin must be one of page"),
        (HEAD.replace("control", "shown") + "a,robot,soon,0,1,first,\n", "2:18: shown must be a number"),
    ],
)
def test_a_mistake_in_csv_is_said_with_its_line(design: Design, text: str, rule: str) -> None:
    with pytest.raises(DocumentError, match=f"^x.csv:{rule}"):
        read_csv(io.StringIO(text), design, "x.csv")


def test_what_is_true_of_a_participant_may_stand_in_one_row_only(design: Design) -> None:
    head = "participant,actor,instruction,time_s,satisfaction,finished,control,about_age,notes\n"
    text = head + "a,robot,soon,0,1,,,,x\na,,soon,60,0,FALSE,3,30,y\n"
    (person,) = read_csv(io.StringIO(text), design).participants
    assert (person.group, person.control, person.finished) == ("robot", 3, False)
    assert person.demographics == {"age": "30"}


@pytest.mark.parametrize(
    ("change", "rule"),
    [
        (lambda d, _p: d.pop("participants"), "missing key 'participants'"),
        (lambda d, _p: d.update(schema="fuzzytime-study/9"), "schema: .*must have the schema"),
        (lambda d, _p: d.update(design=3), "design: must be a text"),
        (
            lambda d, _p: d.update(times_s=[0, 1]),
            r"curves\.[a-z0-9-]+: .*as many samples as times, 2, got 800",
        ),
        (lambda d, _p: d.update(times_s=None), "times_s: must be a list"),
        (lambda d, _p: d.update(times_s=["x"]), r"times_s\[0\]: must be a finite number"),
        (lambda d, _p: d["times_s"].__setitem__(1, 0.0), "0 s twice"),
        (lambda d, _p: d["participants"].append(3), r"participants\[3\]: must be an object"),
        (lambda d, _p: d["participants"].append(d["participants"][0]), r"\[3\].participant: .*must differ"),
        (lambda _d, p: p.pop("actor"), r"participants\[0\]: missing key 'actor'"),
        (lambda _d, p: p.update(actor="dog"), "actor: must be one of robot, person"),
        (lambda _d, p: p.update(participant=" "), "participant: a participant must have a name"),
        (lambda _d, p: p.update(participant="\ud800"), "participant: must be a text"),
        (lambda _d, p: p.update(origin="drawn"), "origin: must be one of page"),
        (lambda _d, p: p.update(finished="no"), "finished: must be true or false"),
        (lambda _d, p: p.update(excluded=""), "excluded: .*needs a reason"),
        (lambda _d, p: p.update(control="3"), "control: must be a whole number or null"),
        (lambda _d, p: p.update(control=6), "control: the answer must be one of 1 to 5"),
        (lambda _d, p: p.update(order=["soon", "soon"]), r"order\[1\]: instructions must differ"),
        (lambda _d, p: p.update(order=["later"]), r"order\[0\]: an instruction must be one of"),
        (lambda _d, p: p.update(about={"age": 3}), "about.age: must be a text"),
        (lambda _d, p: p.update(about={"age": "3"}), "about.age: age must be a whole number"),
        (lambda _d, p: p.update(about={"name": "x"}), "about.name: there is no question"),
        (lambda _d, p: p.update(curves=[]), "curves: must be an object"),
        (lambda _d, p: p["curves"].update(soon=[0, *["x"] * 799]), r"curves.soon\[1\]: must be a finite"),
        (
            lambda _d, p: p["curves"]["soon"].__setitem__(7, 2),
            r"curves.soon\[7\]: must lie in \[0, 1\], got 2",
        ),
        (lambda _d, p: p["curves"].update(later=[0] * 800), "curves.later: an instruction must be one of"),
    ],
)
@pytest.mark.parametrize("indent", [None, 1])
def test_json_that_is_no_study_is_refused_with_its_place(
    some: Answers, change: Callable[..., object], rule: str, indent: int | None
) -> None:
    document = json.loads(as_json(some))
    change(document, document["participants"][0])
    text = json.dumps(document, indent=indent)
    with pytest.raises(DocumentError, match=rule) as caught:
        read_json(text, "x.json")
    (mistake,) = caught.value.mistakes
    assert text.split("\n")[mistake.line - 1] == mistake.source
    path = re.findall(r"[^.\[\]]+", mistake.key)
    value = document
    for step in path:
        value = value[int(step)] if step.isdigit() and isinstance(value, list) else value[step]
    shown = json.dumps(value)
    assert mistake.source[mistake.column - 1 :].startswith(shown if indent is None else shown[:1])


def test_a_mistake_in_the_design_of_json_is_said_to_be_there(some: Answers) -> None:
    document = json.loads(as_json(some)) | {"design": "name: x"}
    with pytest.raises(DocumentError, match=r"^x\.json:design:1:1: missing key"):
        read_json(json.dumps(document), "x.json")


@pytest.mark.parametrize("text", ["", "[", "[]", "null", "[" * 100_000, '{"schema": "fuzzytime-study/1"}'])
def test_text_that_is_no_document_is_refused(text: str) -> None:
    with pytest.raises(DocumentError, match=r"^x\.json:\d+:\d+: "):
        read_json(text, "x.json")


def test_an_imported_curve_may_be_anybodys(design: Design) -> None:
    person = Participant(name="a,b\n'", group="robot", order=("soon",), curves={"soon": np.zeros(800)})
    (again,) = read_csv(io.StringIO(as_csv(Answers(design, (person,))), newline=""), design).participants
    assert again.name == person.name.strip()


TINY = """
fuzzytime-study: 1
name: tiny
timeline: {start: 0 s, end: 10 min, samples: 10}
groups: {robot: robot, person: person}
instructions:
  soon: {say: Start soon!, preposition: in, t: 0 s, word: soon}
  in-5: {say: Start in 5 minutes!, preposition: in, t: 5 min}
demographics: {age: {ask: How old?, whole: [1, 99]}}
control: {say: Late?, t: 5 min, late: 1 min, points: 5, lowest: low, highest: high}
"""


@pytest.fixture(scope="module")
def tiny() -> Answers:
    design = Design.of_text(TINY)
    return simulate(design, {entry.key: Trapezoid(0, 100, 200, 500) for entry in design.instructions}, 3)


VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=3), inner, max_size=3),
    max_leaves=4,
)


@given(st.data())
def test_whatever_json_holds_it_is_read_or_refused_with_a_place(tiny: Answers, data: st.DataObject) -> None:
    document = json.loads(as_json(tiny))
    parent, steps = document, data.draw(st.integers(1, 5))
    for _ in range(steps):
        key = data.draw(st.sampled_from(sorted(parent) if isinstance(parent, dict) else range(len(parent))))
        if isinstance(parent[key], dict | list) and parent[key]:
            parent = parent[key]
    key = data.draw(st.sampled_from(sorted(parent) if isinstance(parent, dict) else range(len(parent))))
    parent[key] = data.draw(VALUES)
    text = json.dumps(document, indent=data.draw(st.sampled_from([None, 2])))
    try:
        read_json(text, "x.json")
    except DocumentError as error:
        for mistake in error.mistakes:
            assert mistake.path.startswith("x.json")
            if mistake.path == "x.json":
                assert text.split("\n")[mistake.line - 1][mistake.column - 1 :]


@given(st.integers(0, 40), st.integers(0, 10), st.text(max_size=8))
def test_whatever_a_cell_holds_it_is_read_or_refused_with_a_place(
    tiny: Answers, line: int, column: int, cell: str
) -> None:
    rows = list(csv.reader(io.StringIO(as_csv(tiny), newline="")))
    rows[line][column] = cell
    saved = io.StringIO()
    csv.writer(saved).writerows(rows)
    try:
        read_csv(io.StringIO(saved.getvalue(), newline=""), tiny.design, "x.csv")
    except DocumentError as error:
        (mistake,) = error.mistakes
        assert 1 <= mistake.line <= saved.getvalue().count("\n") + 1
