"""Where somebody is for a while: "kids are at gran's till five", "while they're out", "when they're back"."""

import pytest

from interpreter.telling import starts, told

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (
            ["kids are at gran's till 5", "clean the oven while they're out", "tea when they're back"],
            {"s3": "17:00"},
        ),
        (
            ["mum is out from 12 to 3", "do the beds while she's out", "call Ana once she's back"],
            {"s2": "12:00", "s3": "15:00"},
        ),
        (
            ["The nurse comes at half ten, usually 20 minutes", "mop the hall while the nurse is here"],
            {"s2": "10:30"},
        ),
        (["vet comes at 10 for half an hour", "muck out once they have gone"], {"s2": "10:30"}),
        (["boiler man between 12 and 4", "shop after he's gone"], {"s2": "16:00"}),
        (["delivery due between 10 and 11", "price it up once it's here"], {"s2": "11:00"}),
        (["Baby naps 1 till 2.30", "pram walk when baby wakes up"], {"s2": "14:30"}),
        (["football practice 4 to 5:15", "put the rice on while Sam's at football"], {"s2": "16:00"}),
        (["kids at swimming 4 to 5", "shop while they swim"], {"s2": "16:00"}),
        (
            ["The bus picks her up at 11.45 and brings her back at 3.30", "cup of tea when she's back"],
            {"s2": "15:33"},
        ),
        (
            ["mum is out from 12 to 3", "clean the bathroom and do the beds while she's out"],
            {"s2": "12:00", "s2.2": "12:25"},
        ),
    ],
)
def test_a_stay_tells_when_somebody_is_out_or_back(lines: list[str], expected: dict[str, str]) -> None:
    found = starts(told(lines))
    assert {name: found[name] for name in expected} == expected


def test_before_somebody_is_up_is_while_they_sleep() -> None:
    made = told(["Anna sleeps until 9", "walk the dog before Anna gets up"])
    assert starts(made) == {"s1": "07:00", "s2": "07:00"}
    assert made.schedule.task.skills[0].time_until_done == 7200


@pytest.mark.parametrize("line", ["wash up if he's still here", "read while the oven is hot"])
def test_a_condition_is_no_stay(line: str) -> None:
    assert len(starts(told(["Tom is here until 9", line]))) < 2


def test_nobody_is_meant_by_another_pronoun() -> None:
    assert len(starts(told(["Dad is out from 2 to 4", "iron while she's out"]))) < 2
