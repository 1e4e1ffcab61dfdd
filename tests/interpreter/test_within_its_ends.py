"""What has two ends and a length lies between them: "paint the fence between two and four for an hour"."""

import pytest

from interpreter.telling import told

HOUR = 3600.0


@pytest.mark.model
@pytest.mark.parametrize(
    ("lines", "begin", "last"),
    [
        (["Paint the fence between two and four pm for an hour"], 14.0, 15.0),
        (["Paint the fence from two to four pm for half an hour"], 14.0, 15.5),
        (["Mow the lawn between ten and noon, it takes two hours"], 10.0, 10.0),
        (["Mow the lawn between ten and noon", "It takes an hour"], 10.0, 11.0),
        # Without a length that was told, and with one that does not fit, it begins in between.
        (["Paint the fence between two and four pm"], 14.0, 16.0),
        (["Paint the fence between two and four pm for three hours"], 14.0, 16.0),
        (["Start painting the fence between two and four pm for an hour"], 14.0, 16.0),
    ],
)
def test_all_of_what_has_two_ends_lies_between_them_if_it_fits(
    lines: list[str], begin: float, last: float
) -> None:
    skill = told(lines).skills[0]
    now = skill.wish.given.hour + skill.wish.given.minute / 60
    best = skill.skill.satisfaction.best
    assert (best.low / HOUR + now, best.high / HOUR + now) == pytest.approx((begin, last))
    (between,) = (part for part in skill.requirements if part.constraint == "between")
    assert (between.earliest, between.latest) != (None, None)


@pytest.mark.model
def test_each_of_alternatives_has_room_for_all_of_it() -> None:
    (skill,) = told(
        ["Paint the fence between two and three pm or between five and six pm for half an hour"]
    ).skills
    now = skill.wish.given.hour + skill.wish.given.minute / 60
    full = [
        hour
        for hour in (14.5, 14.75, 17.5, 17.75)
        if float(skill.skill.satisfaction((hour - now) * HOUR)) == 1
    ]
    assert full == [14.5, 17.5]


@pytest.mark.model
def test_what_overruns_satisfies_less_and_is_not_lost() -> None:
    task = told(
        ["Write the report between ten and one for two hours", "Call Bob at 11:30 am for ten minutes"]
    )
    report = task.skills[0]
    now = report.wish.given.hour + report.wish.given.minute / 60
    early, late, later = report.skill.satisfaction([(hour - now) * HOUR for hour in (10.5, 11.7, 12.5)])
    assert early == 1 > late > later > 0
    assert all(task.has_time(place) for place in range(2))
