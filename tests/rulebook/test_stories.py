"""Stories: readings and a requirement in, satisfaction and its reason out, by the shipped context tables."""

import numpy as np
import pytest

from fuzzytime.context import Context, Reading
from fuzzytime.requirement import Anchor, Constraint
from fuzzytime.rulebook import Resolution, Rulebook
from fuzzytime.satisfaction import Floats, Sampled
from fuzzytime.times import HOUR, MINUTE
from rulebook.requirements_of import ahead, said, when, word

RULEBOOK = Rulebook.shipped()
PAN_IS_HOT = when("when the pan is hot", "pan", "hot")


def readings(name: str, times: Floats, values: Floats, noise: float = 1.0) -> Context:
    noisy = values + np.random.default_rng(7).normal(0, noise, times.size)
    return Context.of({name: list(zip(times.tolist(), noisy.tolist(), strict=True))})


def approach(times: Floats, start: float, level: float, tau: float) -> Floats:
    return np.asarray(level + (start - level) * np.exp(-(times - times[0]) / tau))


MINUTES_OF_HEAT = np.arange(-120.0, 1, 2)
HEATING = readings("pan_temp", MINUTES_OF_HEAT, approach(MINUTES_OF_HEAT, 20, 230, 150))


def resolved(requirement: object, context: Context, **given: object) -> Resolution:
    return RULEBOOK.resolve(requirement, context, **given)  # type: ignore[arg-type]


# -- a pan that heats, stalls, cools, falls silent ----------------------------------------------------------


def test_a_heating_pan_will_be_hot_and_pancakes_are_flipped_soon_after() -> None:
    resolution = resolved(PAN_IS_HOT, HEATING, verb="flip")
    hot_at = 150 * np.log(210 / 40) - 120
    assert resolution.reason is None
    assert resolution.parameters["t"] == pytest.approx(hot_at, abs=15)
    assert resolution.satisfaction(0) < 0.05
    assert resolution.satisfaction(hot_at + 30) > 0.9
    assert resolution.satisfaction(hot_at + 10 * MINUTE) == 0
    assert resolution.shares[1].name == "flip-when-hot"
    assert resolution.shares[1].share == 1.0


def test_without_a_rule_for_it_the_sentence_s_own_condition_is_awaited() -> None:
    resolution = resolved(when("when the oven is hot", "oven", "hot"), Context.of({"oven_temp": 120.0}))
    assert [share.name for share in resolution.shares] == ["when"]
    assert 2 * MINUTE < resolution.parameters["t"] < 15 * MINUTE


def test_a_very_hot_pan_takes_longer_also_where_a_rule_speaks() -> None:
    very = resolved(when("when the pan is very hot", "frying pan", "hot", "very"), HEATING, verb="flip")
    plain = resolved(PAN_IS_HOT, HEATING, verb="flip")
    half = [float(r.satisfaction.acceptable().low) for r in (plain, very)]
    assert half[0] < half[1]
    assert [atom.text for atom in very.shares[1].atoms] == ["pan is hot"]


def test_a_pan_that_stalls_is_never_hot_and_says_where_it_settles() -> None:
    times = np.arange(-300.0, 1, 3)
    stalled = readings("pan_temp", times, approach(times, 20, 150, 120))
    resolution = resolved(PAN_IS_HOT, stalled)
    assert resolution.reason is not None
    assert resolution.reason.startswith("never: pan_temp settles at 1")
    assert float(resolution.reason.split()[4]) == pytest.approx(150, abs=3)
    assert resolution.satisfaction.support.empty


@pytest.mark.parametrize("seconds", [60, 180])
def test_a_few_distant_readings_tell_a_stalled_pan_as_well(seconds: float) -> None:
    values = [20, 90, 130, 148, 150, 150] if seconds == 60 else [20, 100, 135, 148, 150, 150]
    times = [-seconds * (len(values) - 1 - place) for place in range(len(values))]
    stalled = Context.of({"pan_temp": list(zip(times, values, strict=True))})
    reason = resolved(PAN_IS_HOT, stalled).reason
    assert reason is not None
    assert reason.startswith("never: pan_temp settles at 15")


def test_a_pan_that_has_long_stalled_settles_where_it_is() -> None:
    values = [20, 60, 95, 120, 138, 150, 158, 161, 162, 163, 162, 162]
    stalled = Context.of({"pan_temp": [(30.0 * (place - 11), value) for place, value in enumerate(values)]})
    assert resolved(PAN_IS_HOT, stalled).reason == "never: pan_temp settles at 164 \u00b0C"


def test_a_rule_that_looks_further_back_than_the_readings_says_so() -> None:
    resolution = resolved(ahead("in", 10), Context.of({"queue": 9}))
    assert any(note.startswith("the rule 'busy-more-lenient' cannot tell") for note in resolution.notes)
    steady = Context.of({"queue": [(-60.0 * place, 9) for place in range(15)]})
    assert not any("cannot tell" in note for note in resolved(ahead("in", 10), steady).notes)


@pytest.mark.parametrize("before", [[(-732, 100), (-712, 140)], [(-600, 100)], [(-900, 150), (-600, 150)]])
def test_one_reading_after_a_silence_is_believed_where_few_tell_otherwise(
    before: list[tuple[float, float]],
) -> None:
    alone = resolved(PAN_IS_HOT, Context.of({"pan_temp": 100}))
    after = resolved(PAN_IS_HOT, Context.of({"pan_temp": [*before, (0, 100)]}))
    assert after.parameters["t"] == pytest.approx(alone.parameters["t"], abs=15)


def test_a_pan_that_cools_is_cool_later() -> None:
    times = np.arange(-120.0, 1, 2)
    cooling = readings("pan_temp", times, approach(times, 200, 20, 100))
    resolution = resolved(when("when the pan is warm", "pan", "warm"), cooling)
    assert resolution.reason is None
    hot = resolved(PAN_IS_HOT, cooling)
    assert hot.reason is not None
    assert hot.reason.startswith("never: pan_temp")


def test_a_sensor_that_died_is_said() -> None:
    resolution = resolved(PAN_IS_HOT, HEATING.shifted(-20 * MINUTE))
    assert resolution.reason == "not enough readings of pan_temp (the last is 20 min old, more than 5 min)"


def test_without_a_reading_it_is_said_which_is_missing() -> None:
    assert resolved(PAN_IS_HOT, Context.empty).reason == "not enough readings of pan_temp"


def test_a_pan_that_is_hot_now_is_used_now() -> None:
    hot = Context.of({"pan_temp": 200.0})
    resolution = resolved(PAN_IS_HOT, hot)
    assert resolution.parameters["t"] == 0
    assert resolution.satisfaction.best.low == 0


def test_not_hot_is_the_contrary() -> None:
    assert resolved(when("when the pan is not hot", "pan", "hot", negated=True), HEATING).parameters["t"] == 0
    assert resolved(when("when the pan is no longer hot", "pan", "hot"), HEATING).parameters["t"] == 0


def test_until_and_while_follow_the_same_condition() -> None:
    until = resolved(when("until the pan is hot", "pan", "hot", preposition="until"), HEATING).satisfaction
    during = resolved(when("while the pan is hot", "pan", "hot", preposition="while"), HEATING).satisfaction
    assert until([0, 20]).tolist() == pytest.approx([1, 1], abs=0.02)
    assert until(10 * MINUTE) == 0
    assert during(0) < 0.02
    assert during(10 * MINUTE) == 1
    assert during.best.low < 5 * MINUTE


def test_what_goes_on_until_a_condition_holds_is_too_late_when_it_holds() -> None:
    resolution = resolved(
        when("until the pan is hot", "pan", "hot", preposition="until"), Context.of({"pan_temp": 220.0})
    )
    assert resolution.reason == "too late: pan is hot already holds"


def test_an_unknown_thing_and_an_unknown_term_are_said() -> None:
    assert resolved(when("when the moon is blue", "moon", "blue"), HEATING).reason == (
        "nothing tells 'when the moon is blue'"
    )
    reason = resolved(when("when the pan is purple", "pan", "purple"), HEATING).reason
    assert reason == "'pan' has no term 'purple' (known: cold, warm, hot, smoking)"


def test_a_clause_of_another_form_is_understood_by_its_words() -> None:
    resolution = resolved(when("once the water in the pot finally boils"), Context.of({"water_temp": 99.8}))
    assert resolution.parameters["t"] == 0


def test_the_trace_shows_readings_forecast_degrees_and_psi_on_one_axis() -> None:
    resolution = resolved(PAN_IS_HOT, HEATING)
    trace = resolution.trace
    assert trace is not None
    (pan,) = trace.signals
    assert (pan.name, pan.unit) == ("pan_temp", "degC")
    assert pan.reading_times[0] == -120
    assert (pan.forecast_low <= pan.forecast_median).all()
    assert (pan.forecast_median <= pan.forecast_high).all()
    assert trace.times[0] <= -119
    assert trace.times.size == trace.low.size == trace.high.size == trace.satisfaction.size <= 401
    ((text, degrees),) = trace.atoms
    assert text == "pan is hot"
    assert degrees.shape == trace.times.shape
    ahead_of_now = trace.times >= 0
    np.testing.assert_allclose(
        trace.satisfaction[ahead_of_now], resolution.satisfaction(trace.times[ahead_of_now])
    )


# -- kitchen ------------------------------------------------------------------------------------------------


def test_soon_is_sooner_when_the_meal_is_near() -> None:
    near = resolved(word("soon"), Context.of({"time_to_meal": "4 min"})).satisfaction
    usual = resolved(word("soon"), Context.empty).satisfaction
    ample = resolved(word("soon"), Context.of({"time_to_meal": "1h30"})).satisfaction
    assert near.support.high < usual.support.high < ample.support.high


def test_rice_is_done_some_time_after_it_was_put_on() -> None:
    resolution = resolved(when("once the rice is done", "rice", "done"), Context((Reading("rice_on", -300),)))
    assert resolution.satisfaction.best.low == pytest.approx(12 * MINUTE, abs=1)
    waiting = resolved(when("once the rice is done", "rice", "done"), Context.empty)
    assert waiting.reason == "not yet: rice_on has not happened"


def test_a_timer_that_has_not_rung_is_waited_for_and_an_announced_one_counts() -> None:
    rings = when("when the timer rings", "timer", "rings")
    assert resolved(rings, Context.empty).reason == "not yet: timer has not happened"
    announced = resolved(rings, Context((Reading("timer", 300.0),))).satisfaction
    assert announced([299, 300, 360]).tolist() == [0, 1, 1]
    rung = resolved(rings, Context((Reading("timer", -60.0),))).satisfaction
    assert rung(0) == 1


def test_a_distance_from_an_event_adds_to_it() -> None:
    anchor = Anchor(text="the timer rings", lag=300.0, exact=True)
    after = said(Constraint.AFTER, "five minutes after the timer rings", preposition="after", anchor=anchor)
    resolution = resolved(after, Context((Reading("timer", 600.0),)))
    best = resolution.satisfaction.best
    assert (best.low + best.high) / 2 == pytest.approx(900)
    missing = resolved(after, Context.empty)
    assert missing.reason == "not yet: 'the timer rings' has not happened, and no time is announced"


def test_a_distance_before_an_event_lies_before_it() -> None:
    anchor = Anchor(text="the guests arrive", lag=-600.0, exact=True)
    before = said(Constraint.BEFORE, preposition="before", anchor=anchor)
    best = resolved(before, Context((Reading("guests_arrive", 3600.0),))).satisfaction.best
    assert (best.low + best.high) / 2 == pytest.approx(3000)


def test_a_distance_from_a_fuzzy_moment_is_as_fuzzy() -> None:
    anchor = Anchor(text="the pan is hot", lag=300.0, exact=True)
    after = said(Constraint.AFTER, preposition="after", anchor=anchor)
    function = resolved(after, HEATING).satisfaction
    crisp = resolved(
        said(Constraint.AFTER, preposition="after", anchor=Anchor(text="timer rings", lag=300.0, exact=True)),
        Context((Reading("timer", 120.0),)),
    ).satisfaction
    assert isinstance(function, Sampled)
    assert function.support.length > crisp.support.length
    assert function(420) > 0.9


def test_on_one_side_of_an_event() -> None:
    guests = Context((Reading("guests_arrive", 3600.0),))
    before = said(Constraint.BEFORE, preposition="before", anchor=Anchor(text="the guests arrive"))
    after = said(Constraint.AFTER, preposition="after", anchor=Anchor(text="the guests arrive"))
    assert resolved(before, guests).satisfaction([0, 3600, 5000]).tolist() == [1, 1, 0]
    assert resolved(after, guests).satisfaction([0, 3600, 4000]).tolist() == [0, 1, 1]
    unknown = resolved(before, Context.empty)
    assert unknown.reason is None
    assert "any time from now on counts as before it" in unknown.notes[0]
    assert resolved(after, Context.empty).reason is not None
    past = resolved(after, Context((Reading("guests_arrive", -7200.0),)))
    assert past.satisfaction(0) == 1


def test_another_instruction_as_an_anchor_binds_by_order_only() -> None:
    requirement = said(Constraint.AFTER, preposition="after", anchor=Anchor(text="boil the eggs", target=0))
    resolution = resolved(requirement, Context.empty)
    assert resolution.satisfaction(0) == 1
    assert resolution.notes == ("depends on another instruction: 'boil the eggs'",)


# -- household ----------------------------------------------------------------------------------------------


def test_laundry_is_done_only_when_the_machine_has_been_idle_for_a_while() -> None:
    done = when("when the washing machine is done", "washing machine", "done")
    times = np.arange(-600.0, 1, 10)
    paused = readings("washer_power", times, np.where(times < -30, 500.0, 1.0), noise=0)
    idle = readings("washer_power", times, np.where(times < -240, 500.0, 1.0), noise=0)
    assert resolved(done, idle).parameters["t"] == 0
    assert 2 * MINUTE < resolved(done, paused).parameters["t"] < 4 * MINUTE
    assert resolved(done, idle).shares[1].name == "laundry-done"


def test_a_running_machine_is_not_guessed_to_stop() -> None:
    times = np.arange(-600.0, 1, 10)
    running = readings("washer_power", times, np.full(times.size, 500.0), noise=0)
    resolution = resolved(when("when the laundry is done", "laundry", "done"), running)
    assert resolution.reason == "not yet: washer_power is at 500 W"
    assert resolution.untold


def test_a_full_house_is_given_more_room() -> None:
    busy = resolved(ahead("in", 10), Context.of({"people_home": 5.0}))
    calm = resolved(ahead("in", 10), Context.of({"people_home": 1.0}))
    assert busy.parameters["w"] == pytest.approx(1.4 * calm.parameters["w"])


def test_a_room_warms_up_without_a_known_level() -> None:
    times = np.arange(-1200.0, 1, 60)
    warming = readings("room_temp", times, approach(times, 16, 22, 2400), noise=0.05)
    resolution = resolved(when("when the room is warm", "room", "warm"), warming)
    assert resolution.reason is None
    assert 0 < resolution.parameters["t"] < 2 * HOUR


# -- workshop -----------------------------------------------------------------------------------------------


def test_a_weld_is_cool_only_when_it_no_longer_cools_fast() -> None:
    times = np.arange(-300.0, 1, 5)
    cooling = readings("weld_temp", times, approach(times, 600, 22, 360), noise=1.0)
    resolution = resolved(when("when the weld is cool", "weld", "cool"), cooling)
    cool_at = 360 * np.log(578 / 33) - 300
    assert cool_at < resolution.parameters["t"] < cool_at + 5 * MINUTE
    assert resolution.shares[1].name == "cool-through"


def test_a_busy_robot_is_given_more_room_and_the_explanation_says_why() -> None:
    busy = Context.of({"queue": [(-900, 8), (0, 8)]})
    resolution = resolved(ahead("in", 10), busy)
    plain = resolved(ahead("in", 10), Context.empty)
    assert resolution.parameters["w"] == pytest.approx(1.5 * plain.parameters["w"])
    share = resolution.shares[1]
    assert share.name == "busy-more-lenient"
    assert share.source.startswith("rules/workshop.yaml:")
    assert [atom.text for atom in share.atoms] == [
        "workload is very busy mostly in the last about 10 min",
        "workload is very busy",
    ]
    assert share.atoms[1].reading == 8


def test_a_robot_that_is_busy_by_its_only_reading_is_given_some_of_that_room() -> None:
    plain = resolved(ahead("in", 10), Context.empty)
    busy = resolved(ahead("in", 10), Context.of({"queue": 8}))
    assert busy.parameters["w"] == pytest.approx(1.2 * plain.parameters["w"])


def test_soon_waits_behind_a_full_queue() -> None:
    idle, full = (resolved(word("soon"), Context.of({"queue": count})) for count in (0.0, 10.0))
    assert idle.satisfaction.support.high < full.satisfaction.support.high


def test_a_print_is_done_when_its_progress_says_so() -> None:
    progress = Context.of({"print_progress": [(-3600, 10), (-1800, 25), (0, 40)]})
    resolution = resolved(when("once the print is finished", "print", "finished"), progress)
    assert resolution.parameters["t"] == pytest.approx(2 * HOUR, rel=0.05)


def test_glue_sets() -> None:
    resolution = resolved(when("when the glue is dry", "glue", "dry"), Context((Reading("glue_on", -600.0),)))
    assert resolution.satisfaction([300, 900, 1250]).tolist() == pytest.approx([0.0, 0.5, 1.0], abs=0.01)


@pytest.mark.parametrize("now", [229.0, 100.0])
def test_what_is_forecast_for_a_while_holds_for_that_while_only(now: float) -> None:
    requirement = when("while the pan is hot", "pan", "hot", preposition="while")
    resolution = resolved(requirement, Context.of({"pan_temp": now}))
    horizon = 40 * MINUTE
    assert resolution.satisfaction(horizon - 1) == pytest.approx(1.0, abs=0.01)
    assert resolution.satisfaction(horizon + 1) == 0.0
