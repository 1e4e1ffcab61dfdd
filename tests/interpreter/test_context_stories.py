"""Stories over the whole road: readings and a sentence in, a schedule or a reason out."""

from datetime import datetime

import numpy as np
import pytest

from fuzzytime.context import Context, Reading
from fuzzytime.interpreter import Interpreter, Plan, ProblemKind, Request, SpokenWish, plan
from fuzzytime.times import MINUTE

NOW = datetime(2026, 3, 4, 17)  # noqa: DTZ001 - the stories' moment is of no zone
Points = list[tuple[float, float]]


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.shipped()


def approach(seconds: float, start: float, level: float, tau: float, noise: float = 0.5) -> Points:
    """Readings of the last seconds, every five, that approach a level."""
    times = np.arange(-seconds, 1, 5)
    values = level + (start - level) * np.exp(-(times - times[0]) / tau)
    values += np.random.default_rng(1).normal(0, noise, times.size)
    return list(zip(times.tolist(), values.tolist(), strict=True))


def straight(seconds: float, start: float, end: float, step: float = 30) -> Points:
    """Readings of the last seconds on a straight line."""
    times = np.arange(-seconds, 1, step)
    return list(zip(times.tolist(), np.linspace(start, end, times.size).tolist(), strict=True))


def happens(event: str, minutes: float) -> Context:
    """An event so many minutes from now."""
    return Context((Reading(event, minutes * MINUTE),))


def told(interpreter: Interpreter, context: Context, *sentences: str) -> Plan:
    wishes = tuple(SpokenWish(text=text, given=NOW) for text in sentences)
    return plan(Request(now=NOW, wishes=wishes, context=context), interpreter)


def rejection(made: Plan) -> str:
    (reason,) = [problem.message for problem in made.problems if problem.kind is ProblemKind.REJECTED]
    return reason


HEATING = approach(120, 20, 230, 150)
ON_TIME = [
    # -- kitchen: a pan that heats or cools, water, an oven, a roast
    ("Flip the pancakes when the pan is hot", {"pan_temp": HEATING}, (1.6, 3.3)),
    ("Sear the steak when the pan is very hot", {"pan_temp": HEATING}, (1.7, 3.5)),
    ("Add the butter as soon as the pan is warm", {"pan_temp": approach(20, 20, 230, 150)}, (0, 1)),
    ("Take the pan off when the pan is too hot", {"pan_temp": approach(60, 220, 330, 150)}, (0, 1)),
    ("Wash the pan once it has cooled down", {"pan_temp": approach(200, 200, 22, 200)}, (3, 9)),
    ("Wipe the stove when the pan is no longer hot", {"pan_temp": approach(200, 230, 22, 200)}, (0, 0)),
    ("Add the pasta when the water boils", {"water_temp": straight(60, 60, 75, 5)}, (1.5, 2.5)),
    ("Put the cake in when the oven is preheated", {"oven_temp": approach(180, 20, 210, 300)}, (4, 9)),
    (
        "Put the pizza in once the oven reaches 220 degrees",
        {"oven_temp": approach(300, 20, 250, 500)},
        (9, 15),
    ),
    ("Stir the sauce when it is hotter than 300 °F", {"pan_temp": approach(60, 20, 230, 150)}, (0.5, 4)),
    (
        "Drain the oil when the pan has cooled to 60 degrees",
        {"pan_temp": approach(200, 200, 22, 200)},
        (1, 5),
    ),
    ("Charge the robot when the battery is below 20%", {"battery": straight(1800, 40, 30, 300)}, (25, 45)),
    ("Order screws when fewer than 50 parts are left", {"parts_left": straight(600, 80, 60, 60)}, (4, 12)),
    ("Take the roast out when the roast is done", {"core_temp": straight(1200, 40, 60)}, (9, 16)),
    ("Set the table soon", {"time_to_meal": [(0, 240)]}, (0, 2)),
    # -- household: a machine, a room, rain, a battery
    (
        "Hang up the laundry when the washing machine is done",
        {"washer_power": [*straight(600, 400, 400)[:-4], (-90, 2), (-60, 2), (-30, 2), (0, 2)]},
        (1, 3),
    ),
    ("Take off the jacket when the room is warm", {"room_temp": straight(1800, 14, 18.5, 120)}, (0.5, 60)),
    ("Hang out the washing when the weather is dry", {"rain": straight(3600, 0, 0, 600)}, (0, 0)),
    ("Bring in the chairs when it rains", {"rain": [(-900, 0), (0, 2)]}, (0, 0)),
    ("Start the vacuum when the robot is charged", {"battery": straight(1800, 50, 60, 300)}, (90, 125)),
    # -- workshop: parts that cool, a printer, a magazine that runs out, a compressor
    ("Paint the bracket when the bracket is cool", {"weld_temp": approach(180, 400, 22, 360, 2)}, (12, 20)),
    ("Remove the part when the print is done", {"print_progress": straight(1200, 70, 90, 60)}, (9, 12)),
    ("Refill the magazine when the stock is low", {"parts_left": straight(600, 80, 60, 60)}, (15, 26)),
    ("Clean the bench when the compressor is full", {"air_pressure": approach(60, 1, 8, 60, 0.02)}, (1, 4)),
]


@pytest.mark.parametrize(("sentence", "readings", "between"), ON_TIME, ids=[row[0] for row in ON_TIME])
def test_a_skill_starts_when_its_condition_holds(
    interpreter: Interpreter, sentence: str, readings: dict[str, Points], between: tuple[float, float]
) -> None:
    made = told(interpreter, Context.of(readings), sentence)
    (start,), (satisfaction,) = made.schedule.start_times, made.schedule.satisfactions
    assert between[0] <= start / MINUTE <= between[1]
    assert satisfaction > 0.9


BY_EVENTS = [
    ("Take the cake out five minutes after the timer rings", happens("timer", 5), (7.5, 12.5)),
    ("Take the cake out five minutes after the timer rings", happens("timer", -2), (0.5, 5.5)),
    ("Take the cake out when the timer rings", happens("timer", 10), (10, 12)),
    ("Light the candles ten minutes before the guests arrive", happens("guests_arrive", 20), (6, 14)),
    ("Light the candles before the guests arrive", happens("guests_arrive", 20), (0, 20)),
    ("Drain the pasta when it is al dente", happens("pasta_in", -2), (6, 7)),
    ("Serve the rice five minutes after the rice is done", happens("rice_on", -5), (14, 20)),
    ("Take the cake out when the cake is done", happens("dish_in", -20), (14, 17)),
    ("Sweep the floor before lunch", happens("lunch", 60), (0, 60)),
    ("Sweep the floor half an hour before lunch", happens("lunch", 60), (24, 36)),
    ("Close the blinds at sunset", happens("sunset", 60), (58, 62)),
    ("Open the door when the doorbell rings", happens("doorbell", 0), (0, 2)),
    ("Vacuum the kitchen after the baby falls asleep", happens("baby_asleep", 15), (15, 28)),
    ("Drill the frame when the glue is dry", happens("glue_on", -10), (19, 22)),
    ("Pack the box two hours after the paint is on", happens("paint_on", -10), (99, 121)),
]


@pytest.mark.parametrize(("sentence", "context", "between"), BY_EVENTS)
def test_a_skill_is_timed_by_an_event(
    interpreter: Interpreter, sentence: str, context: Context, between: tuple[float, float]
) -> None:
    made = told(interpreter, context, sentence)
    (start,), (satisfaction,) = made.schedule.start_times, made.schedule.satisfactions
    assert between[0] <= start / MINUTE <= between[1]
    assert satisfaction > 0.95
    assert ProblemKind.UNRESOLVED not in {problem.kind for problem in made.problems}


NEVER = [
    (
        "Flip the pancakes when the pan is hot",
        Context.of({"pan_temp": approach(400, 20, 150, 100)}),
        "never: pan_temp settles at 150 °C",
    ),
    (
        "Flip the pancakes when the pan is hotter than 5000 degrees",
        Context.empty,
        "never: pan_temp lies between -10 and 400 °C, so it is not above 5000 °C",
    ),
]

UNTOLD = [
    (
        "Flip the pancakes when the pan is hot",
        Context.of({"pan_temp": HEATING}).shifted(-10 * MINUTE),
        "not enough readings of pan_temp (the last is 10 min old, more than 5 min)",
    ),
    ("Flip the pancakes when the pan is hot", Context.empty, "not enough readings of pan_temp"),
    (
        "Take the cake out five minutes after the timer rings",
        Context.empty,
        "not yet: 'the timer rings' has not happened, and no time is announced",
    ),
    (
        "Hang up the laundry when the washing machine is done",
        Context.of({"washer_power": straight(600, 400, 400)}),
        "not yet: washer_power is at 400 W",
    ),
    ("Mow the lawn at noon unless it rains", Context.of({"rain": 3.0}), "not yet: rain is at 3 mm/h"),
    (
        "Charge the robot when the battery falls below 20 %",
        Context.of({"battery": 45.0}),
        "not yet: battery is at 45 %",
    ),
    ("Flip the pancakes when the moon is blue", Context.empty, "nothing tells 'when the moon is blue'"),
    ("Flip the pancakes at noon if the moon is blue", Context.empty, "nothing tells 'if the moon is blue'"),
]


@pytest.mark.parametrize(("sentence", "context", "reason"), NEVER, ids=[row[2] for row in NEVER])
def test_what_never_comes_is_rejected_with_its_reason_and_the_rest_is_planned(
    interpreter: Interpreter, sentence: str, context: Context, reason: str
) -> None:
    made = told(interpreter, context, sentence, "Set the table soon")
    assert made.schedule.rejected == (True, False)
    assert rejection(made).endswith(reason)
    assert made.schedule.satisfactions[1] == 1.0


@pytest.mark.parametrize(("sentence", "context", "reason"), UNTOLD, ids=[row[2] for row in UNTOLD])
def test_what_nobody_has_told_yet_is_waited_for_and_is_no_loss(
    interpreter: Interpreter, sentence: str, context: Context, reason: str
) -> None:
    made = told(interpreter, context, sentence, "Set the table soon")
    assert [one.reason for one in made.waiting] == [reason]
    assert [one.skill.name for one in made.skills] == ["set the table"]
    assert made.schedule.satisfaction == 1.0
    assert ProblemKind.REJECTED not in {problem.kind for problem in made.problems}


def test_a_busy_robot_takes_times_more_loosely(interpreter: Interpreter) -> None:
    weld = "Weld the bracket in ten minutes"
    lengths = [
        told(interpreter, Context.of({"queue": straight(600, tasks, tasks, 60)}), weld)
        .skills[0]
        .skill.satisfaction.acceptable()
        .length
        for tasks in (0, 8)
    ]
    assert lengths[0] < lengths[1]


def test_soon_means_another_time_to_an_idle_robot_than_to_a_busy_one(interpreter: Interpreter) -> None:
    last = [
        told(interpreter, Context.of({"queue": float(tasks)}), "Sort the screws soon")
        .skills[0]
        .skill.satisfaction.acceptable()
        .high
        for tasks in (0, 9)
    ]
    assert last[0] < 5 * MINUTE < 20 * MINUTE < last[1]


def test_a_cold_oven_has_not_baked(interpreter: Interpreter) -> None:
    cake = "Take the cake out when the cake is done"
    hot, cold = (
        told(
            interpreter,
            happens("dish_in", -40).merged(Context.of({"oven_temp": straight(2400, *ends)})),
            cake,
        )
        for ends in ((200, 200), (21, 21))
    )
    assert hot.schedule.start_times == (0.0,)
    assert cold.schedule.start_times[0] > 0 or cold.schedule.rejected == (True,)


def test_dinner_is_cooked_by_readings_and_by_the_clock_together(interpreter: Interpreter) -> None:
    made = told(
        interpreter,
        Context.of({"pan_temp": HEATING, "time_to_meal": 25 * MINUTE}),
        "Flip the pancakes when the pan is hot",
        "Set the table soon",
        "Light the candles in about twenty minutes",
        "Serve dinner by 17:30",
    )
    flip, table, candles, _ = made.schedule.start_times
    assert 1.6 * MINUTE <= flip <= 3.5 * MINUTE
    assert table < candles
    assert min(made.schedule.satisfactions) > 0.9


@pytest.mark.parametrize(
    "sentence",
    [
        "Mow the lawn at noon unless it rains",
        "Call Ann at noon, not while the baby sleeps",
        "Ring the bell at noon unless the moon is blue",
    ],
)
def test_nothing_is_left_out_by_what_nothing_tells_of(interpreter: Interpreter, sentence: str) -> None:
    made = told(interpreter, Context.empty, sentence)
    assert made.schedule.rejected == (False,)
    assert any("so that no time is left out by it" in problem.message for problem in made.problems)


SEVERAL = [
    ("when the pan is hot and the oven is hot", (4, 9)),
    ("when both the pan and the oven are hot", (4, 9)),
    ("when the pan is hot or the oven is hot", (1.6, 3.3)),
    ("when the pan is hot but not smoking", (1.6, 3.3)),
    ("when the pan is neither cold nor hot", (0, 0)),
    ("when the pan is hot and the timer rings", (12, 12.1)),
    ("when the pan has been hot for two minutes", (3.6, 5.3)),
    ("after the pan has been hot for about two minutes", (3.6, 6)),
    ("before the pan is hot", (0, 0)),
    ("unless the pan is hot", (0, 0)),
    ("if the pan is hot", (1.6, 3.3)),
    ("once the timer has rung", (12, 12.1)),
]


@pytest.mark.parametrize(("clause", "minutes"), SEVERAL)
def test_every_part_of_a_clause_counts(
    interpreter: Interpreter, clause: str, minutes: tuple[float, float]
) -> None:
    context = Context.of({"pan_temp": HEATING, "oven_temp": approach(180, 20, 210, 300)})
    made = told(interpreter, context.merged(happens("timer", 12)), f"Fry the eggs {clause}")
    (start,) = made.schedule.start_times
    assert minutes[0] * MINUTE - 1 <= start <= minutes[1] * MINUTE + 1


def test_a_part_of_a_clause_that_no_signal_tells_is_said(interpreter: Interpreter) -> None:
    made = told(
        interpreter, Context.of({"pan_temp": 200}), "Fry the eggs when the pan is hot and the cook is happy"
    )
    assert [one.reason for one in made.waiting] == ["nothing tells 'cook is happy'"]
    assert made.waiting[0].resolutions[0].untold


def test_the_row_of_a_clause_shows_the_sentence_s_own_condition_and_its_readings(
    interpreter: Interpreter,
) -> None:
    context = Context.of({"pan_temp": 200, "oven_temp": 100})
    made = told(interpreter, context, "Wipe the table when the pan is hot and the oven is not hot")
    row, *_ = made.skills[0].resolutions[0].shares
    assert row.name == "when"
    assert [(atom.text, atom.degree.low, atom.reading) for atom in row.atoms] == [
        ("pan is hot", 1, 200),
        ("oven is hot", 0, 100),
    ]
    assert row.degree.low == 1


def test_events_are_known_in_every_regular_tense(interpreter: Interpreter) -> None:
    for clause in ("when the guests arrive", "once the guests have arrived", "after the guests arrived"):
        made = told(interpreter, happens("guests_arrive", 30), f"Make coffee {clause}")
        (start,) = made.schedule.start_times
        assert 30 * MINUTE <= start <= 31 * MINUTE, clause


def test_a_sensor_that_comes_back_is_believed_from_then_on(interpreter: Interpreter) -> None:
    before = [(time - 600, value) for time, value in HEATING]
    context = Context.of({"pan_temp": [*before, (-20.0, 150.0), (-10.0, 155.0), (0.0, 160.0)]})
    (start,) = told(interpreter, context, "Flip the pancakes when the pan is hot").schedule.start_times
    assert 1 * MINUTE <= start <= 3 * MINUTE


def test_it_is_what_was_worked_on_before_where_nothing_makes_the_own_thing_so(
    interpreter: Interpreter,
) -> None:
    steps = ("Heat the pan", "Fry the onions once it's hot, about eight minutes")
    made = told(interpreter, Context.of({"pan_temp": HEATING}), *steps)
    assert 1.6 * MINUTE - 1 <= made.schedule.start_times[1] <= 3.3 * MINUTE + 1


def test_the_weather_is_nothing_that_was_worked_on(interpreter: Interpreter) -> None:
    made = told(interpreter, Context.empty, "Pick up the parcel", "Water the tomatoes when it's cooler")
    assert [one.waits for one in made.everything] == [False, True]
