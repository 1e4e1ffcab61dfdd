"""Lines of plans as people write them: headings, times, and what is said of other lines."""

from datetime import timedelta

import pytest

from interpreter.telling import SEVEN, starts, told

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (["Swimming 9:30-10:15", "Snack straight after swimming"], {"s2": "10:15"}),
        (["Doors open at noon", "Briefing ten minutes before opening"], {"s2": "11:50"}),
        (["Nap for the little one 1 till 3 pm", "Call Ana while she naps"], {"s2": "13:00"}),
        (["The 1:1 is from 3 to 4 pm", "Send the minutes right after the 1:1"], {"s2": "16:00"}),
    ],
)
def test_what_happens_may_have_the_name_of_what_is_done(lines: list[str], expected: dict[str, str]) -> None:
    found = starts(told(lines))
    assert {name: found[name] for name in expected} == expected


def test_what_is_left_in_the_oven_goes_in_and_comes_out() -> None:
    lines = ["Score the loaves just before they go in", "Bake the loaves at 10 am for 40 minutes"]
    made = told(
        [*lines, "Call Ana 20 minutes before the loaves come out", "Set the table when they come out"]
    )
    found = starts(made)
    assert "09:50" <= found["s1"] < "10:00"
    assert (found["s2"], found["s3"], found["s4"]) == ("10:00", "10:20", "10:40")


def test_what_is_opened_at_a_time_is_shut_behind_that_and_shortly_before_it_is_due() -> None:
    found = starts(told(["Tomorrow", "Open the vents at 9 am, shut them by 5 pm"]))
    assert found["s2"] == "09:00"
    assert "12:00" < found["s2.2"] < "17:00"


@pytest.mark.parametrize(
    ("line", "expected"),
    [("Kids in bed by 9 pm", "20:45"), ("Be off the pitch by 11 am", "10:45"), ("Leave by 9 am", "08:45")],
)
def test_a_deadline_below_a_day_is_kept_as_late_as_one_on_its_own(line: str, expected: str) -> None:
    assert starts(told([line])) == {"s1": expected}
    assert starts(told(["Sunday", line])) == {"s2": expected}


@pytest.mark.parametrize("due", ["by 5 pm", "before 5 pm", "no later than 5 pm", "not after 5 pm"])
def test_a_deadline_below_a_day_satisfies_in_full_until_shortly_before_it(due: str) -> None:
    made = told(["Sunday", f"Send the report {due}"])
    sunday = made.instant(made.schedule.start_times[0])
    four = (sunday.replace(hour=16, minute=0, second=0) - made.instant(0.0)).total_seconds()
    assert float(made.skills[0].skill.satisfaction(four)) == 1.0


def test_before_bed_is_late_on_a_day_that_is_named_above_as_well() -> None:
    made = told(["Sunday", "Bins out before bed"])
    assert starts(made)["s2"] >= "21:00"
    assert made.schedule.satisfactions == (1.0,)


def test_who_is_dropped_off_is_picked_up_shortly_before_that_is_due() -> None:
    found = starts(told(["Drop Mia at nursery 8:45", "Pick Mia up by 5:45"]))
    assert found["s1"] == "08:45"
    assert "17:00" <= found["s2"] <= "17:45"


def test_what_was_loaded_is_unloaded_where_the_way_leads() -> None:
    found = starts(told(["Load the van, 45 min", "Leave at 11:30", "Unload"]))
    assert found == {"s1": "07:00", "s2": "11:30", "s3": "11:31"}


def test_who_gets_ready_before_a_call_calls_nobody() -> None:
    made = told(["call ana at 10, prep 15 min before"])
    assert [skill.name for skill in made.schedule.skills] == ["call ana", "prep"]
    assert starts(made) == {"s1": "10:00", "s1.2": "09:45"}


@pytest.mark.parametrize(
    ("line", "minutes"),
    [
        ("Set 12 tables, 5 minutes each", 60),
        ("Make up rooms 201-206, 25 min each", 150),
        ("Wrap both orders, 6 min each", 12),
        ("Grill two steaks for 3 minutes each", 3),
        ("Weld a batch of 12, 90 seconds each", 18),
        ("Weld the hooks from 9 am, ten of them, 6 min each", 60),
        ("See patients 2-4 pm, 15 mins each", 120),
    ],
)
def test_what_is_done_one_by_one_lasts_for_all(line: str, minutes: float) -> None:
    assert told([line]).schedule.skills[0].duration == 60 * minutes


def test_what_the_calendar_knows_to_become_so_needs_no_reading() -> None:
    made = told(["Tomorrow", "Pick the leeks before it gets dark", "Light the lamps once it is dark"])
    assert starts(made)["s3"] == "19:00"
    assert starts(made)["s2"] < "18:00"
    assert not [problem for problem in made.problems if "tells" in problem.message]


@pytest.mark.parametrize(
    ("clause", "start"),
    [
        ("when the sun sets", "19:00"),
        ("once the sun has gone down", "19:00"),
        ("when night falls", "19:00"),
        ("as soon as the sun is up", "07:00"),
        ("when day breaks", "07:00"),
    ],
)
def test_what_the_sky_does_is_at_a_part_of_the_day(clause: str, start: str) -> None:
    made = told([f"Feed the hens {clause}"], now=SEVEN - timedelta(hours=2))
    assert starts(made) == {"s1": start}
    assert not made.problems


def test_a_level_is_waited_for_or_comes_by_what_is_done_before() -> None:
    assert starts(told(["At 60 degrees add the honey"])) == {}
    found = starts(told(["Heat the milk at 10 am", "At 60 degrees add the honey"]))
    assert found["s1"] == "10:00" < found["s2"]


def test_a_line_behind_several_times_of_one_thing_goes_on_at_the_first() -> None:
    made = told(["Meds at 8, 12, 16 and 20", "Visit ward 3 before 11"])
    assert any(problem.message.startswith("'before 11' is taken as 11:00") for problem in made.problems)


@pytest.mark.parametrize(("line", "latest"), [("bale the hay by 6", "18:00"), ("leave by 6:30", "06:30")])
def test_what_is_due_by_six_tomorrow_is_due_when_people_do_it(line: str, latest: str) -> None:
    made = told(["Tomorrow", line])
    assert any(f"is taken as {latest}" in problem.message for problem in made.problems)


def test_what_is_called_a_truck_or_a_delivery_comes() -> None:
    lines = [
        "Check the formwork before the concrete arrives",
        "Concrete truck 8:30",
        "Compost delivery at 11",
    ]
    found = starts(told([*lines, "Spread it once it's here"]))
    assert found["s1"] < found["s2"] == "08:30"
    assert "11:00" <= found["s4"] < "11:30"


def test_a_clause_behind_two_verbs_is_of_both() -> None:
    found = starts(told(["Pour the slab at 10 am", "Level and float when the slab is poured"]))
    assert "10:00" <= found["s2"] < found["s2.2"]


@pytest.mark.parametrize(
    ("line", "hour"),
    [
        ("Vases out 10.20", "10:20"),
        ("Teardown 4.40, 20 min", "16:40"),
        ("Group B workshop 10-11.30 upstairs", "10:00"),
        ("Rehearsal 12 to 1 (in costume)", "12:00"),
        ("Dive 1 - 9.40, 45 mins", "09:40"),
        ("7.10 crew meeting", "07:10"),
        ("9.04 weather (1 min)", "09:04"),
    ],
)
def test_a_number_behind_a_thing_is_an_hour_where_other_lines_say_when(line: str, hour: str) -> None:
    assert hour in starts(told(["Open the hall at 9", line, "Lock the hall by 6"])).values()


def test_hours_of_four_digits_are_hours_where_one_begins_with_a_zero() -> None:
    lines = ["Unit call 0730", "Lunch 1230", "Break 1500-1515", "Wrap 1830", "Order 1200 bricks"]
    found = starts(told(lines))
    assert [found[name] for name in ("s1", "s2", "s3", "s4")] == ["07:30", "12:30", "15:00", "18:30"]
    assert found["s5"] < "08:00"


@pytest.mark.parametrize(
    ("line", "what"),
    [
        ("Fluid charts totalled at 4", "Fluid charts must be totalled"),
        ("12 chairs stacked 4.30", "12 chairs must be stacked"),
        ("Bed linen changed at 10", "Bed linen must be changed"),
    ],
)
def test_what_is_done_at_an_hour_of_a_list_is_to_do(line: str, what: str) -> None:
    made = told(["Open the hall at 9", line, "Meet at 2.30", "Lock the hall by 6"])
    assert what in [skill.name for skill in made.schedule.skills]


@pytest.mark.parametrize(
    ("line", "hours"),
    [
        ("Rolls in 9.15, out 9.35", ("09:15", "09:35")),
        ("Joint in the oven 11, out 1.15", ("11:00", "13:15")),
        ("Lights on 4, off 5.30", ("16:00", "17:30")),
    ],
)
def test_a_thing_in_two_states_has_both_hours(line: str, hours: tuple[str, str]) -> None:
    found = starts(told(["Open the hall at 9", line, "Meet at 2.30", "Lock the hall by 6"]))
    assert (found["s2"], found["s2.2"]) == hours


@pytest.mark.parametrize(
    "line",
    [
        "Mix 1.50 kg of lime",
        "Boil 12.30 litres",
        "Buy milk 2.50",
        "Scene 14 until about 11",
        "Dive 1, with the new boat",
        "Paint rooms 2-4",
    ],
)
def test_what_counts_or_is_a_name_is_no_hour_beside_them(line: str) -> None:
    made = told(["Open the hall at 9", line, "Lock the hall by 6"])
    assert made.schedule.skills[1].name.split()[1] in line
    assert starts(made)["s2"] < "09:00"


@pytest.mark.parametrize(
    ("line", "hours"),
    [
        ("Wrap 6", ["18:00"]),
        ("Second milking 4, then bed the calves", ["16:00"]),
        ("Consults 11-1", ["11:00"]),
        ("Bottles 11, 1 and 3", ["11:00", "13:00", "15:00"]),
        ("Wool dyeing: 11.20", ["11:20"]),
        ("Sweep the yard 11", ["11:00"]),
        ("Phones on 11.30", ["11:30"]),
        ("Lunch rush 12-2 no deliveries", ["12:00"]),
        ("Milk round 11", ["11:00"]),
        ("Make-up: Ana 11.10, Tom 11.40", ["11:10", "11:40"]),
        ("Bread: mix 11, bake 1.15, 30 min", ["11:00", "13:15"]),
        ("Glue-up on the top 11.30, leave clamped for an hour", ["11:30"]),
        ("Party of 14 at 7.30 pm, cake ten minutes after the doors", ["19:30", "12:10"]),
        ("Evening guests from 7 pm, first dance 7.30", ["19:00", "19:30"]),
    ],
)
def test_a_number_alone_is_an_hour_where_most_lines_say_when(line: str, hours: list[str]) -> None:
    made = starts(told(["Open the hall at 9", "Rehearsal 10.15", "Tea at 10.45", line, "Doors at noon"]))
    assert [made[name] for name in made if name.startswith("s4")][: len(hours)] == hours


@pytest.mark.parametrize("line", ["Stall 4", "Guests: 12", "Simmer 10", "Tables 5 and 6"])
def test_what_is_called_or_counted_is_no_hour_beside_them(line: str) -> None:
    made = told(["Open the hall at 9", "Rehearsal 10.15", "Tea at 10.45", line])
    assert not [time for one in made.skills[3:] for time in one.requirements if time.constraint == "at"]


@pytest.mark.parametrize("way", ["hour and a quarter drive", "75 minutes' drive", "an hour's drive"])
def test_how_long_one_drives_may_be_said_behind_a_comma(way: str) -> None:
    (leaving,) = told([f"Leave at 2, {way}"]).skills
    assert leaving.skill.time_until_done == (3600.0 if "hour's" in way else 4500.0)


def test_lines_that_go_through_a_day_in_order_go_on_further() -> None:
    lines = ["Open the hall at 8", "Sweep it at 10", "Lunch at 1.30", "Count the tickets at 7.15"]
    assert starts(told(lines))["s4"] == "19:15"
    assert starts(told(lines[2:]))["s2"] == "07:15"


def test_what_lines_say_is_hardly_before_the_day_of_those_above_begins() -> None:
    lines = ["Hall open from 1.30", "Staging 2.30", "Full rehearsal at 4.30", "Piano tuner 12 noon"]
    found = starts(told([*lines, "Doors 6.45, concert 7.30"]))
    assert [found["s5"], found["s5.2"]] == ["18:45", "19:30"]
    assert "08:15" in starts(told([*lines[:2], "Doors 8.15"])).values()


def test_what_a_line_below_a_day_says_next_may_be_shortly_before() -> None:
    found = starts(told(["Thursday", "Open 9, lights on 8.45", "Towels at 9.30", "Perm at 11.30"]))
    assert list(found.values()) == ["09:00", "08:45", "09:30", "11:30"]


@pytest.mark.parametrize("line", ["Fish delivered 10.30", "Bread picked up at 10.30", "Noah collected 10.30"])
def test_what_is_done_with_things_among_lines_with_times_is_to_come(line: str) -> None:
    assert starts(told(["Open the hall at 9", "Tea at 9.45", line, "Lunch 12"]))["s3"] == "10:30"
    assert "10:30" not in starts(told([line])).values()


def test_who_awaits_a_delivery_does_other_things_too() -> None:
    found = starts(
        told(["Tea at 9", "Timber delivery 9.30-11.30", "Measure the stairs at 10", "Doors at 12"])
    )
    assert (found["s2"], found["s3"]) == ("09:30", "10:00")


@pytest.mark.parametrize(
    ("line", "hours"), [("11 cut bars", ["11:00"]), ("12 baptism (Jones)", ["12:00"]), ("12 eggs", [])]
)
def test_a_number_in_front_is_an_hour_where_most_lines_begin_with_theirs(line: str, hours: list[str]) -> None:
    found = starts(told(["9.15 open the hall", "10.30 tea", line, "2 pm delivery", "4.30 lock the hall"]))
    assert [found[name] for name in found if name == "s3"] == hours


def test_what_is_to_be_done_at_the_same_time_ends_when_the_other_does() -> None:
    lines = ["Put the chicken in at 5 pm for an hour and a half"]
    made = told([*lines, "Put the potatoes on for 40 minutes so they're done at the same time"])
    assert starts(made) == {"s1": "17:00", "s2": "17:50"}


@pytest.mark.parametrize("state", ["on", "off"])
def test_what_must_be_on_or_off_is_turned_so(state: str) -> None:
    turned = told([f"turn the heating {state} at five"]).schedule.skills[0].duration
    assert told([f"heating {state} at five"]).schedule.skills[0].duration == turned
