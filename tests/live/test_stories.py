"""Runs in simulated time: what is told, and when, as readings, words and commands come and fail to come."""

import itertools
import math

import pytest

from fuzzytime.context import Context
from fuzzytime_cli.live.events import (
    ContextRead,
    Done,
    Dropped,
    End,
    Failed,
    Finished,
    Happens,
    Instructed,
    Late,
    Missed,
    Moved,
    Planned,
    Rejected,
    Silent,
    Start,
    Stopped,
    Trouble,
    Waits,
)
from fuzzytime_cli.live.inbox import Stop
from live.story import Json, NappingClock, told, wish

pytestmark = pytest.mark.model

FLIP = wish("Flip the pancakes when the pan is hot", "flip", duration=60.0)
HOT, SMOKING = 170.0, 250.0


def pan(
    until: float, level: float = 230.0, tau: float = 150.0, since: float = 0.0, begin: float = 30.0
) -> list[Json]:
    """Readings of a pan on its way from ``begin`` to ``level``, every ten seconds."""
    times = [since + 10.0 * i for i in range(1, round((until - since) / 10) + 1)]
    return [reading(t, level + (begin - level) * math.exp(-(t - since) / tau)) for t in times]


def reading(at: float, value: float, signal: str = "pan_temp") -> Json:
    return {"signal": signal, "at_s": at, "value": value}


# -- in time ------------------------------------------------------------------------------------------------


def test_every_skill_starts_and_ends_as_planned() -> None:
    story = told(["Stir the soup now", "Set the table in exactly ten minutes"])
    planned = {one.id: one for one in story.all(Planned)[0].skills}
    assert story.starts == {name: pytest.approx(one.start_s) for name, one in planned.items()}
    assert {end.id: end.at for end in story.all(End)} == {
        name: pytest.approx(one.end_s) for name, one in planned.items()
    }
    assert story.one(Finished).done == ("s1", "s2")
    assert len(story.all(Planned)) == 1


def test_what_is_done_in_passing_starts_in_time_while_its_agent_is_at_work() -> None:
    story = told(["Stir the mix for an hour", "Check the ewe every 20 minutes until eight"])
    assert not story.all(Missed)
    assert story.starts["s1"] == 0.0
    assert {"s2": 1200.0, "s2.2": 2400.0}.items() <= story.starts.items()


def test_what_is_done_in_passing_is_late_only_when_its_time_is_over_and_keeps_nobody() -> None:
    wishes = ["Stir the mix for an hour", "Check the ewe every 20 minutes for an hour", "Ring in an hour"]
    story = told(
        wishes, [{"at_s": 1200.0 + 240.0, "done": "s2"}, {"at_s": 3600.0, "done": "s1"}], by_word=True
    )
    (check,) = (one for one in story.all(Start) if one.id == "s2")
    assert check.end_s == check.done_s > check.at
    late = [one.at for one in story.all(Late) if one.id == "s2"]
    assert late
    assert min(late) >= check.end_s
    # "s2.2" goes on, as nobody said that it is done.
    assert story.starts["s3"] == pytest.approx(3600.0)


def test_an_agent_is_free_before_a_result_is_there() -> None:
    story = told([wish("Boil the eggs now", "eggs", hands_on=60.0, elapsed=600.0), "Set the table soon"])
    start = story.starts["eggs"]
    assert story.one(End, "eggs").at == pytest.approx(start + 60)
    assert story.one(Done, "eggs").at == pytest.approx(start + 600)
    assert story.starts["s2"] < start + 600


def test_the_same_run_tells_the_same() -> None:
    runs = [told([FLIP, "Set the table soon"], pan(150)).documents for _ in range(2)]
    for document in runs[0] + runs[1]:
        document.pop("seconds", None)
    assert runs[0] == runs[1]


def test_an_occurrence_of_a_repetition_starts_once() -> None:
    story = told([wish("Stir the soup every five minutes for twenty minutes", duration=30.0)])
    starts = sorted(story.starts.values())
    assert len(starts) >= 3
    assert all(later - earlier > 100 for earlier, later in itertools.pairwise(starts))


@pytest.mark.parametrize(
    ("wait", "words"),
    [
        ("Take the tents down once the dew is off", "the dew is off"),
        ("Order the parts if the tray is ok", "The tray is ok."),
    ],
)
def test_what_waits_starts_when_somebody_tells_that_it_may(wait: str, words: str) -> None:
    story = told([wait, "Stir the soup now"], [{"say": words, "at_s": 600}])
    assert story.one(Waits).id == "s1"
    assert "s2" in story.starts
    assert story.starts["s1"] == pytest.approx(600, abs=1)
    assert story.one(Finished).unfinished == ()


def test_what_nothing_waits_for_is_no_news() -> None:
    story = told(["Take the tents down once the dew is off"], [{"say": "the tray is ok", "at_s": 600}])
    assert story.one(Finished).unfinished == ("s1",)
    assert "names nothing to do" in story.one(Trouble).message


# -- readings -----------------------------------------------------------------------------------------------


def test_pancakes_are_flipped_when_the_pan_is_hot() -> None:
    story = told([FLIP], pan(600))
    hot_at = 150 * math.log(200 / 60)
    start = story.one(Start, "flip")
    assert hot_at <= start.at <= hot_at + 120
    assert start.satisfaction > 0.9
    # The plan was right long before: later readings refined it.
    assert abs(story.all(Planned)[2].skills[0].start_s - start.at) < 120


def test_a_pan_that_stalls_moves_the_flip_then_rejects_it_and_the_rest_goes_on() -> None:
    stalls = pan(120) + pan(600, level=130, tau=60, since=120, begin=230 - 200 * math.exp(-0.8))
    story = told([FLIP, wish("Set the table in exactly eight minutes", "table", duration=60.0)], stalls)
    rejected = story.all(Rejected)[-1]
    assert rejected.id == "flip"
    assert rejected.reason.startswith("never: pan_temp settles at 1")
    assert 120 < rejected.at < 480
    assert "flip" not in story.starts
    assert story.starts["table"] == pytest.approx(480, abs=90)
    assert story.one(Finished).rejected == ("flip",)


def test_a_pan_that_heats_again_brings_the_flip_back() -> None:
    lines = pan(300, level=120, tau=60) + pan(900, level=235, tau=120, since=300, begin=119)
    story = told([FLIP], lines, context=Context.of({"pan_temp": 30.0}))
    back = [moved for moved in story.of(Moved, "flip") if moved.before_s is None]
    assert back
    start = story.one(Start, "flip")
    heat = 235 - 116 * math.exp(-(start.at - 300) / 120)
    assert HOT <= heat <= SMOKING


def test_a_reading_that_nothing_depends_on_is_told_and_changes_nothing() -> None:
    story = told(["Set the table in exactly five minutes"], [reading(60, 90, "water_temp")])
    assert story.one(ContextRead).matters is False
    assert len(story.all(Planned)) == 1


def test_readings_as_they_were_expected_change_nothing() -> None:
    warm = wish("Set the table when the oven is hot", "table", duration=60.0)
    steady = [reading(t, 100.0, "oven_temp") for t in range(10, 200, 10)]
    # An oven that is hot, and stays so: each reading matters, none is news.
    hot = [{**line, "value": 200.0} for line in steady]
    cook = wish("Stir the soup now", "stir", duration=180.0)
    story = told([cook, warm], hot, context=Context.of({"oven_temp": 200.0}))
    assert all(read.matters for read in story.all(ContextRead) if read.at < story.starts["table"])
    assert len(story.all(Planned)) <= 2


def test_a_sensor_that_dies_is_told_and_what_waits_for_it_has_no_time() -> None:
    story = told(
        [FLIP, wish("Set the table in exactly fifteen minutes", "table")], pan(100, level=120, tau=300)
    )
    silent = story.one(Silent)
    assert (silent.signal, silent.read_s) == ("pan_temp", 100.0)
    assert silent.at == pytest.approx(100 + 300, abs=0.1)
    assert "not enough readings of pan_temp" in story.of(Waits, "flip")[-1].reason
    assert "table" in story.starts
    assert story.all(Finished)[-1].unfinished == ("flip",)


def test_a_sensor_that_speaks_again_is_heard() -> None:
    lines = [*pan(60, level=120, tau=300), reading(500, 200.0), reading(510, 201.0)]
    story = told([FLIP], lines)
    assert story.one(Silent).at < 500
    assert story.starts["flip"] == pytest.approx(500, abs=60)


def test_an_event_ahead_is_known_when_it_is_announced_and_else_when_it_happens() -> None:
    guests = wish("Set the table when the guests arrive", "table", duration=60.0)
    announced = told([guests], [{"signal": "guests_arrive", "at_s": 600, "announced": True}])
    assert announced.starts["table"] == pytest.approx(600, abs=60)
    assert announced.all(Planned)[0].skills[0].start_s == pytest.approx(600, abs=60)
    arrived = told([guests], [{"signal": "guests_arrive", "at_s": 600}])
    assert arrived.starts["table"] >= 600
    assert arrived.one(ContextRead).at == 600


# -- words --------------------------------------------------------------------------------------------------


def test_an_instruction_counts_from_when_it_was_said() -> None:
    said = {"say": "Stir the soup in exactly two minutes", "at_s": 100, "duration": "30 s"}
    story = told(["Set the table in exactly ten minutes"], [said])
    assert story.one(Instructed).ids == ("s2",)
    assert story.starts["s2"] == pytest.approx(220, abs=60)
    assert "s2 was asked for" in story.reasons


def test_what_has_started_stays_where_it_is() -> None:
    said = {"say": "Stir the soup soon", "at_s": 30, "id": "stir", "duration": "30 s"}
    story = told([wish("Set the table now", "table", duration=300.0)], [said])
    assert story.starts["stir"] >= story.one(End, "table").at
    assert story.one(Done, "table").at == pytest.approx(story.starts["table"] + 300)


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ({"say": "stir the soup at 25:61 pm", "at_s": 5}, ""),
        ({"say": "in ten minutes", "at_s": 5}, "nothing to do"),
        ({"say": "stir the soup", "id": "table", "at_s": 5}, "ids must differ"),
        ({"say": "stir the soup", "agent": 2, "at_s": 5}, "one of 1 to 1"),
        ({"say": "stir the soup", "after": "nothing", "at_s": 5}, "'after' must name"),
        ({"done": "nothing", "at_s": 5}, "there is no such skill"),
    ],
)
def test_what_cannot_be_understood_is_told_and_changes_nothing(line: Json, message: str) -> None:
    story = told([wish("Set the table in exactly five minutes", "table")], [line])
    assert message in story.one(Trouble).message
    assert story.one(Trouble).at == 5
    assert story.one(Finished).done == ("table",)
    assert len(story.all(Planned)) == 1


def test_what_is_done_sooner_lets_the_next_start_sooner() -> None:
    wishes = [
        wish("Mix the batter now", "mix", duration=300.0),
        wish("Stir the soup now", "stir", duration=60.0, after=("mix",)),
    ]
    story = told(wishes, [{"done": "mix", "at_s": 100}])
    assert story.one(Done, "mix").at == 100
    assert story.starts["stir"] == pytest.approx(100, abs=1)


def test_what_is_done_by_others_is_not_started() -> None:
    story = told([wish("Set the table in exactly ten minutes", "table")], [{"done": "table", "at_s": 60}])
    assert story.starts == {}
    assert story.one(Finished).done == ("table",)


def test_what_is_dropped_is_not_started_and_what_needs_it_has_no_time() -> None:
    wishes = [
        wish("Mix the batter in exactly five minutes", "mix", duration=60.0),
        wish("Fry the pancakes in ten minutes", "fry", after=("mix",)),
        wish("Set the table in exactly eight minutes", "table"),
    ]
    story = told(wishes, [{"drop": "mix", "at_s": 60, "reason": "no eggs"}])
    assert story.one(Dropped).reason == "no eggs"
    assert set(story.starts) == {"table"}
    assert story.of(Rejected, "fry")


def test_words_about_what_is_asked_for_are_understood_before_the_first_plan() -> None:
    lines = [{"drop": "table"}, {"say": "Feed the cat soon", "id": "cat"}, {"done": "cat"}]
    story = told([wish("Set the table now", "table"), wish("Stir the soup soon", "stir")], lines)
    assert set(story.starts) == {"stir"}
    assert story.one(Finished).done == ("cat", "stir")
    assert story.one(Finished).dropped == ("table",)


def test_by_word_a_skill_goes_on_until_it_is_said_to_be_done() -> None:
    wishes = [
        wish("Mix the batter now", "mix", duration=60.0),
        wish("Stir the soup soon", "stir", duration=60.0, after=("mix",)),
    ]
    story = told(wishes, [{"done": "mix", "at_s": 200}, {"done": "stir", "at_s": 500}], by_word=True)
    assert story.of(Late, "mix")
    assert story.one(Done, "mix").at == 200
    assert 200 <= story.starts["stir"] <= 260


def test_by_word_a_run_ends_where_nobody_is_left_to_say_what_is_done() -> None:
    story = told(
        [wish("Mix the batter now", "mix", duration=60.0)], [{"done": "x", "at_s": 20}], by_word=True
    )
    assert story.one(Finished).unfinished == ("mix",)
    assert story.all(Trouble)[-1].message == "the input has ended: nobody is left to say what is done"


# -- what goes wrong ----------------------------------------------------------------------------------------


def test_a_start_missed_while_the_machine_slept_is_told_and_planned_anew() -> None:
    wishes = [
        wish("Stir the soup in about ten minutes", "stir", duration=60.0),
        wish("Set the table in exactly three minutes", "table", duration=60.0),
    ]
    story = told(wishes, clock=NappingClock(asleep=(100.0, 1000.0)))
    assert {missed.id for missed in story.all(Missed)} == {"stir", "table"}
    assert story.starts == {"stir": pytest.approx(1000)}
    assert "its time passed" in story.one(Rejected, "table").reason
    assert story.one(Start, "stir").satisfaction < 1.0


def test_a_command_that_is_late_is_told_and_the_next_one_waits_for_it() -> None:
    wishes = [
        wish("Mix the batter now", "mix", duration=60.0),
        wish("Set the table in exactly two minutes", "table", duration=60.0),
    ]
    story = told(wishes, takes={"mix": 400.0, "table": 60.0})
    late = story.of(Late, "mix")
    assert late[0].at == pytest.approx(story.starts["mix"] + 61, abs=0.1)
    assert all(one.expected_s > one.at for one in late)
    assert len(late) < 12
    assert story.one(End, "mix").at == pytest.approx(story.starts["mix"] + 400)
    assert story.starts.get("table", math.inf) >= story.one(End, "mix").at


def test_a_command_that_fails_takes_with_it_only_what_needs_it() -> None:
    wishes = [
        wish("Mix the batter now", "mix", duration=60.0),
        wish("Fry the pancakes in ten minutes", "fry", duration=60.0, after=("mix",)),
        wish("Set the table in exactly eight minutes", "table", duration=60.0),
    ]
    story = told(wishes, takes={"mix": (20.0, "the command ended with exit code 1"), "table": 60.0})
    assert story.one(Failed, "mix").at == pytest.approx(story.starts["mix"] + 20)
    assert story.one(Rejected, "fry").reason == "must come after mix, which failed"
    assert story.one(Finished).done == ("table",)


def test_a_command_that_hangs_is_killed_and_the_rest_goes_on() -> None:
    wishes = [
        wish("Mix the batter now", "mix", duration=60.0),
        wish("Set the table in exactly eight minutes", "table", duration=60.0),
    ]
    story = told(wishes, takes={"table": 60.0}, limit=lambda planned: 3 * planned)
    failed = story.one(Failed, "mix")
    assert failed.at == pytest.approx(story.starts["mix"] + 180)
    assert failed.reason == "did not end within 3 min and was killed"
    assert story.hands is not None
    assert story.hands.stopped == ["mix"]
    assert story.one(Finished).done == ("table",)


def test_a_command_that_ends_sooner_frees_its_agent() -> None:
    wishes = [
        wish("Mix the batter now", "mix", duration=300.0),
        wish("Stir the soup now", "stir", duration=60.0, after=("mix",)),
    ]
    story = told(wishes, takes={"mix": 30.0, "stir": 60.0})
    assert story.starts["stir"] == pytest.approx(story.starts["mix"] + 30, abs=1)


def test_somebody_who_stops_a_run_is_told_what_goes_on() -> None:
    wishes = [
        wish("Mix the batter now", "mix", duration=300.0),
        wish("Set the table in exactly eight minutes", "table"),
    ]
    story = told(wishes, arrivals=[(60.0, Stop())])
    stopped = story.one(Stopped)
    assert (stopped.at, stopped.running, stopped.waiting) == (60.0, ("mix",), ("table",))
    assert story.one(Finished).unfinished == ("mix", "table")


# -- what happens by itself ---------------------------------------------------------------------------------


def test_what_happens_by_itself_is_done_by_nobody() -> None:
    story = told(["the guests come at 7 pm", "serve the soup when they arrive"], takes={"s2": 60.0})
    assert [start.id for start in story.all(Start)] == ["s2"]
    assert story.one(Happens).id == "s1"
    assert [one.id for one in story.all(Done)] == ["s1", "s2"]


def test_what_happens_by_itself_needs_no_word_to_be_over() -> None:
    lines: list[Json] = [{"done": "s2", "at_s": 4200}]
    story = told(["I have a meeting at 7 pm for an hour", "stir the soup at 7 pm"], lines, by_word=True)
    assert story.of(Late, "s1") == []
    assert story.one(Done, "s1").at == 7200


def test_what_happens_by_itself_does_so_while_everybody_is_at_work() -> None:
    fry = wish("fry the fish now", hands_on=3600.0, elapsed=3600.0)
    story = told([fry, "the guests come at half past six"], takes={"s1": 3600.0})
    assert story.starts == {"s1": 0, "s2": 1800}


def test_what_happened_while_the_machine_slept_did_so_at_its_time() -> None:
    wishes = ["the guests come at 7 pm", "serve the soup half an hour after the guests come"]
    story = told(wishes, clock=NappingClock(asleep=(3000, 4800)))
    assert story.all(Missed) == []
    assert (story.one(Happens).at, story.one(Happens).planned_s) == (4800, 3600)
    assert story.one(Start).at == 5400


# -- what happens, told anew --------------------------------------------------------------------------------

PARTY = (
    "the guests come at 7 pm",
    "serve the soup five minutes after the guests arrive",
    "set the table 20 minutes before the guests come",
    "light the candles before the guests come",
)


def test_what_comes_late_takes_along_what_is_tied_to_it() -> None:
    story = told(PARTY, [{"say": "the guests are late, they come at half past seven", "at_s": 600}])
    assert story.one(Instructed).ids == ("s1",)
    assert {one.id: one.after_s for one in story.all(Moved)} == {"s1": 5400, "s2": 5700, "s3": 4200}
    assert (story.starts["s1"], story.starts["s2"], story.starts["s3"]) == (5400, 5700, 4200)
    assert "s1 was told anew" in story.reasons


def test_what_has_started_stays_when_the_event_is_late() -> None:
    story = told(PARTY, [{"say": "the guests will be half an hour late", "at_s": 3000}])
    assert (story.starts["s3"], story.starts["s2"]) == (2400, 5700)
    assert story.one(Moved, "s2").before_s == 3900


def test_what_was_taken_to_have_happened_may_be_told_to_come_later() -> None:
    story = told(PARTY, [{"say": "the guests come at half past seven", "at_s": 3660}])
    assert story.starts["s2"] == 5700
    assert story.starts["s5"] == 5400


def test_what_comes_early_is_said_to_leave_no_time_for_what_was_to_be_done_before() -> None:
    story = told(PARTY[:3], [{"say": "they are here", "at_s": 600}])
    assert (story.starts["s1"], story.starts["s2"]) == (600, 900)
    assert "passed" in story.one(Rejected, "s3").reason


def test_what_comes_early_by_a_line_takes_along_what_is_tied_to_it() -> None:
    story = told(PARTY[:2], [{"done": "s1", "at_s": 600}])
    assert story.starts == {"s2": 900}


def test_what_is_cancelled_is_dropped_and_what_is_tied_to_it_rejected() -> None:
    story = told(PARTY[:3], [{"say": "the guests aren't coming", "at_s": 600}])
    assert story.one(Dropped).id == "s1"
    assert {one.id for one in story.all(Rejected)} == {"s2", "s3"}
    assert story.starts == {}


def test_what_comes_after_all_is_planned_again() -> None:
    lines: list[Json] = [
        {"say": "the guests aren't coming", "at_s": 600},
        {"say": "they come at half past seven after all", "at_s": 1200},
    ]
    story = told(PARTY[:3], lines)
    assert story.starts == {"s3": 4200, "s1": 5400, "s2": 5700}


def test_lateness_without_a_length_is_a_problem_that_changes_nothing() -> None:
    story = told(PARTY[:2], [{"say": "the guests are late", "at_s": 600}])
    assert "by how much" in story.one(Trouble).message
    assert story.starts["s1"] == 3600


def test_a_line_that_tells_how_long_something_takes_is_kept() -> None:
    story = told(["stir the soup in ten minutes"], [{"say": "it takes 20 minutes", "at_s": 60}])
    assert story.one(Done).at - story.starts["s1"] == 1200


def test_what_is_forgotten_in_words_is_dropped() -> None:
    lines = [{"say": "forget the soup", "at_s": 60}]
    story = told(["stir the soup in ten minutes", "call mum in 20 minutes"], lines)
    assert story.one(Dropped).id == "s1"
    assert story.starts == {"s2": 1200}


def test_what_is_ready_in_words_is_done() -> None:
    story = told(["boil the eggs now for eight minutes"], [{"say": "the eggs are ready", "at_s": 60}])
    assert story.one(Done).at == 60


@pytest.mark.parametrize("line", ["push everything back by ten minutes", "no, make it eight", "done"])
def test_other_words_about_what_was_asked_for_are_pointed_at(line: str) -> None:
    story = told(["stir the soup in ten minutes"], [{"say": line, "at_s": 60}])
    assert story.one(Trouble).text == line
    assert story.starts == {"s1": 600}
