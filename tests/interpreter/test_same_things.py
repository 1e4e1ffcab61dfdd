"""What is done with one thing, where no words say when, is done in the order said."""

import pytest

from interpreter.telling import told

pytestmark = pytest.mark.model


def follows(*lines: str) -> list[tuple[int, int]]:
    """Give which of some lines wait for which, because of the order said."""
    return [(entry.first, entry.second) for entry in told(list(lines)).interpretation.order]


@pytest.mark.parametrize(
    "lines",
    [
        ("peel the potatoes", "boil the potatoes"),
        ("wash the van soon", "polish the van"),
        ("iron the shirts by six pm", "fold the shirts"),
        ("sand the door", "paint the door after ten"),
        ("warm up the gripper", "pick the first tray once it is warm", "inspect the tray"),
    ],
)
def test_a_thing_is_worked_on_in_the_order_said(lines: tuple[str, ...]) -> None:
    assert follows(*lines) == [(len(lines) - 2, len(lines) - 1)]


def test_others_may_come_between() -> None:
    assert follows("peel the pears", "whip the cream", "slice the pears", "stew the pears") == [
        (0, 2),
        (2, 3),
    ]


@pytest.mark.parametrize(
    "lines",
    [
        ("serve the soup at seven pm", "heat the soup"),
        ("paint the fence", "repair the fence at ten"),
        ("air the room", "sweep the room by noon"),
        ("water the roses every hour", "prune the roses"),
        ("peel the potatoes", "boil the eggs"),
        ("wash the pan", "wash the small pan"),
        ("the cake is ready at six pm", "cut the cake"),
        ("varnish the desk an hour after breakfast", "sand the desk"),
    ],
)
def test_times_and_other_things_say_more_than_the_order(lines: tuple[str, str]) -> None:
    assert follows(*lines) == []


def test_two_agents_do_not_share_what_must_follow() -> None:
    plan = told(["peel the potatoes", "boil the potatoes", "wash the spinach", "chop the spinach"], agents=2)
    peeled, boiled, washed, chopped = plan.schedule.start_times
    assert peeled + plan.skills[0].skill.duration <= boiled
    assert washed + plan.skills[2].skill.duration <= chopped


def test_what_is_done_once_more_is_done_shortly_before_it_is_due() -> None:
    plan = told(["let the dog out around nine pm and again before ten pm"])
    first, again = plan.schedule.start_times
    assert again - first > 45 * 60


@pytest.mark.parametrize(
    ("line", "second"),
    [
        ("Mow the lawn on friday and rake it in the evening", "Fri 18:30"),
        ("Soak the beans tonight and cook them at ten in the morning", "Thu 10:00"),
        ("Drain the boiler on tuesday and refill it on wednesday", "Wed 09:00"),
        ("Drain the boiler on tuesday and descale it overnight", "Tue 23:00"),
        ("Pack tonight and leave at five am", "Thu 05:00"),
    ],
)
def test_what_comes_next_is_behind_the_day_said_before_it(line: str, second: str) -> None:
    made = told([line])
    first, then = made.schedule.start_times
    assert first < then
    assert f"{made.instant(then):%a %H:%M}" == second
