"""The everyday profile reads time words as a person does."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from fuzzytime.documents.nodes import Mapping, Node, Reader, Scalar
from fuzzytime.requirement import Constraint, Reference, TimeRequirement, Unit
from fuzzytime.resources import rules_directory
from fuzzytime.rulebook import Resolution, Rulebook
from fuzzytime.satisfaction import ALWAYS, SatisfactionFunction
from fuzzytime.times import DAY, HOUR, MINUTE
from rulebook.requirements_of import ahead, said, word

RULEBOOK = Rulebook.shipped()


def psi(requirement: TimeRequirement) -> SatisfactionFunction:
    return RULEBOOK.resolve(requirement).satisfaction


def at(hours: float, grain: Unit, *hedges: str, preposition: str = "at") -> TimeRequirement:
    return said(Constraint.AT, preposition=preposition, t_spec=hours * HOUR, grain=grain, fuzziness=hedges)


def test_about_ten_minutes_loses_nothing_five_minutes_off() -> None:
    function = psi(ahead("in", 10, Unit.MINUTE, "about"))
    assert function([5 * MINUTE, 15 * MINUTE]).tolist() == [1.0, 1.0]
    assert function(20 * MINUTE) == pytest.approx(0.5, abs=0.01)
    assert function(25 * MINUTE) == pytest.approx(0.0, abs=0.01)


def test_two_five_minute_jobs_both_in_about_ten_minutes_satisfy_fully() -> None:
    function = psi(ahead("in", 10, Unit.MINUTE, "about"))
    starts = np.arange(0.0, 30 * MINUTE, 10.0)
    products = function(starts) * function(starts + 5 * MINUTE)
    assert products.max() == 1.0


def test_sharp_is_narrower_than_said_plainly_and_about_is_wider() -> None:
    lengths = [psi(at(9, Unit.HOUR, *hedges)).acceptable().length for hedges in (("sharp",), (), ("about",))]
    assert lengths == sorted(lengths)
    assert lengths[0] < 10 * MINUTE
    assert lengths[2] < HOUR


def test_a_time_said_to_the_minute_is_meant_more_finely_than_a_full_hour() -> None:
    assert psi(at(9.5, Unit.MINUTE)).support.length < psi(at(9, Unit.HOUR)).support.length


def test_a_clock_time_close_by_is_no_wider_than_the_same_time_ahead() -> None:
    assert psi(at(1 / 60, Unit.HOUR)).support.length <= psi(ahead("in", 1)).support.length


@pytest.mark.parametrize("preposition", ["by", "before", "within", "no later than", "until"])
def test_earlier_than_a_deadline_is_never_worse(preposition: str) -> None:
    function = psi(said(Constraint.BEFORE, preposition=preposition, t_spec=3 * HOUR))
    assert (function(np.linspace(0, 3 * HOUR, 50)) == 1).all()
    assert function(3.5 * HOUR) == 0.0


@pytest.mark.parametrize("verb", ["leave", "wake up", "be", "set off"])
def test_much_earlier_than_a_deadline_is_worse_for_what_is_done_when_it_is_time(verb: str) -> None:
    deadline = said(Constraint.BEFORE, preposition="by", t_spec=6 * HOUR, grain=Unit.HOUR)
    function = RULEBOOK.resolve(deadline, verb=verb).satisfaction
    assert function(5.8 * HOUR) == 1
    assert 0.2 < function(0.0) < 0.5
    assert function(6.5 * HOUR) == 0


@pytest.mark.parametrize(
    ("verb", "grain"), [("set", Unit.HOUR), ("cook", Unit.HOUR), ("get", Unit.HOUR), ("leave", Unit.DAY)]
)
def test_earlier_is_never_worse_for_work_and_by_a_day(verb: str, grain: Unit) -> None:
    deadline = said(Constraint.BEFORE, preposition="by", t_spec=6 * HOUR, grain=grain)
    function = RULEBOOK.resolve(deadline, verb=verb).satisfaction
    assert (function(np.linspace(0, 6 * HOUR, 50)) == 1).all()


def test_after_prefers_soon_after_and_falls_slowly() -> None:
    values = psi(said(Constraint.AFTER, preposition="after", t_spec=8 * HOUR))(
        np.array([7.5, 8.0, 8.75, 10.0, 11.0]) * HOUR
    )
    assert values[:3].tolist() == [0.0, 1.0, 1.0]
    assert 1 > values[3] > values[4] > 0


def test_not_before_asks_for_nothing_but_patience() -> None:
    function = psi(said(Constraint.AFTER, preposition="not before", t_spec=HOUR))
    assert function([0.9 * HOUR, HOUR, 40 * HOUR]).tolist() == [0.0, 1.0, 1.0]


def test_between_is_full_between_its_ends() -> None:
    requirement = said(Constraint.BETWEEN, preposition="between", earliest=HOUR, latest=2 * HOUR)
    assert psi(requirement).best.low == HOUR
    assert psi(requirement).best.high == 2 * HOUR


def test_a_part_of_the_day_is_full_inside_and_fuzzy_at_its_ends() -> None:
    function = psi(said(Constraint.BETWEEN, earliest=21 * HOUR, latest=27 * HOUR, grain=Unit.HOUR))
    assert function([20 * HOUR, 24 * HOUR, 27.5 * HOUR]).tolist() == [0.0, 1.0, 0.0]
    assert 0 < function(21 * HOUR) < 1


@pytest.mark.parametrize(
    "tomorrow",
    [
        said(Constraint.AT, t_spec=15 * HOUR, grain=Unit.DAY),
        said(Constraint.BETWEEN, earliest=15 * HOUR, latest=39 * HOUR, grain=Unit.DAY),
    ],
    ids=["at", "between"],
)
def test_tomorrow_means_its_waking_hours(tomorrow: TimeRequirement) -> None:
    midnight = 15 * HOUR
    values = psi(tomorrow)(midnight + np.array([0, 3, 10, 15, 19, 23.5]) * HOUR)
    assert values.tolist() == [0.0, 0.0, 1.0, 1.0, 1.0, 0.0]


@pytest.mark.parametrize("hour", [0.5, 5.0, 14.0, 22.0, 23.5])
def test_today_can_begin_at_once_at_any_hour(hour: float) -> None:
    today = said(
        Constraint.BETWEEN, earliest=-hour * HOUR, latest=(24 - hour) * HOUR, grain=Unit.DAY, word=None
    )
    assert psi(today)(0.0) == 1.0
    assert psi(today)(DAY) == 0.0


def test_vague_words_lie_in_the_order_that_people_mean() -> None:
    words = ["now", "very soon", "soon", "in a bit", "in a while", "later", "much later"]
    halves = [psi(word(text)).acceptable() for text in words]
    middles = [(half.low + half.high) / 2 for half in halves]
    assert middles == sorted(middles)


def test_soon_is_good_within_five_minutes_and_hopeless_after_twenty() -> None:
    values = psi(word("soon"))(np.array([0, 5, 10, 20]) * MINUTE)
    assert values.tolist() == pytest.approx([1.0, 1.0, 2 / 3, 0.0])


def test_very_soon_is_a_row_of_its_own_also_where_very_is_a_hedge() -> None:
    assert psi(word("soon", "very")) == psi(word("very soon"))


def test_as_soon_as_possible_loses_with_each_minute() -> None:
    values = psi(word("as soon as possible"))(np.array([2, 5, 10, 30]) * MINUTE)
    assert (np.diff(values) < 0).all()


def test_eventually_is_satisfied_at_any_time() -> None:
    assert psi(word("eventually")) == ALWAYS


@pytest.mark.parametrize("hedge", ["shortly before", "just before", "well before"])
def test_a_point_before_an_anchor_lies_before_it(hedge: str) -> None:
    function = psi(at(3, Unit.HOUR, hedge, preposition="before"))
    assert function.best.high < 3 * HOUR
    assert function.acceptable().low > 0.5 * HOUR


@pytest.mark.parametrize("hedge", ["shortly after", "just after", "well after"])
def test_a_point_after_an_anchor_lies_after_it(hedge: str) -> None:
    assert psi(at(3, Unit.HOUR, hedge, preposition="after")).best.low >= 3 * HOUR


def test_almost_six_lies_before_six() -> None:
    best = psi(at(3, Unit.HOUR, "almost")).best
    assert (best.low + best.high) / 2 < 3 * HOUR


def test_at_least_and_at_most_turn_a_time_into_a_side() -> None:
    at_least, at_most = (psi(ahead("in", 10, Unit.MINUTE, hedge)) for hedge in ("at least", "at most"))
    assert at_least(5 * MINUTE) == 0.0
    assert at_least.best.low == 10 * MINUTE
    assert at_most([0.0, 10 * MINUTE]).tolist() == [1.0, 1.0]


def test_an_unknown_hedge_is_noted_and_taken_as_none() -> None:
    resolution = RULEBOOK.resolve(ahead("in", 10, Unit.MINUTE, "plusminus"))
    assert resolution.satisfaction == psi(ahead("in", 10))
    assert resolution.notes == ("unknown hedge 'plusminus': taken as none",)


def test_an_unknown_word_is_noted_and_satisfied_at_any_time() -> None:
    resolution = RULEBOOK.resolve(word("anon"))
    assert resolution.satisfaction == ALWAYS
    assert "anon" in resolution.notes[0]


def test_a_finish_is_reached_by_starting_earlier() -> None:
    by_six = said(Constraint.BEFORE, preposition="by", t_spec=HOUR, reference=Reference.FINISH)
    resolution = RULEBOOK.resolve(by_six, duration=3 * MINUTE, elapsed=20 * MINUTE)
    assert resolution.satisfaction.best.high == 40 * MINUTE
    assert resolution.reason is None


def test_what_cannot_finish_in_time_says_so() -> None:
    by_six = said(Constraint.BEFORE, preposition="by", t_spec=10 * MINUTE, reference=Reference.FINISH)
    resolution = RULEBOOK.resolve(by_six, duration=3 * MINUTE, elapsed=20 * MINUTE)
    assert resolution.reason is not None
    assert resolution.reason.startswith("cannot finish in time: it takes 20 min")


def test_throughout_averages_over_the_execution() -> None:
    requirement = said(
        Constraint.BETWEEN,
        preposition="between",
        earliest=HOUR,
        latest=2 * HOUR,
        reference=Reference.THROUGHOUT,
    )
    function = RULEBOOK.resolve(requirement, duration=HOUR).satisfaction
    assert function(HOUR) == pytest.approx(1.0, abs=1e-3)
    assert function(1.5 * HOUR) == pytest.approx(0.5 + 0.05, abs=0.01)


def test_throughout_an_open_time_is_averaged_within_the_horizon() -> None:
    requirement = said(Constraint.VAGUE, word="eventually", reference=Reference.THROUGHOUT)
    function = RULEBOOK.resolve(requirement, duration=HOUR, horizon=10 * HOUR).satisfaction
    assert function(5 * HOUR) == 1.0


@pytest.mark.parametrize("constraint", [Constraint.FOR, Constraint.EVERY])
def test_durations_and_series_bind_no_start(constraint: Constraint) -> None:
    assert psi(said(constraint, preposition="for", number=8, unit=Unit.MINUTE)) == ALWAYS


@pytest.mark.parametrize("constraint", list(Constraint))
@pytest.mark.parametrize("preposition", [None, "in", "by", "after", "between", "amid"])
@pytest.mark.parametrize(
    "times", [{}, {"t_spec": 600.0}, {"earliest": 60.0}, {"latest": 90.0, "earliest": 60.0}]
)
def test_nothing_is_ever_without_a_row(
    constraint: Constraint, preposition: str | None, times: dict[str, Any]
) -> None:
    resolution = RULEBOOK.resolve(said(constraint, preposition=preposition, **times))
    values = resolution.satisfaction(np.linspace(0, DAY, 100))
    assert ((values >= 0) & (values <= 1)).all()
    assert constraint is Constraint.WHEN or resolution.shares


def lexicon(section: str) -> list[str]:
    """Give the words of a section, without those that language never hands on: vague repetitions."""
    reader = Reader.of_file(rules_directory() / "lexicon.yaml")
    entries = reader.mapping(reader.mapping(reader.root(), "")[section], section)
    return [text for text, entry in entries.items() if text != "source" and not _is_repetition(entry)]


def _is_repetition(entry: Node) -> bool:
    fields = entry.entries if isinstance(entry, Mapping) else ()
    return any(
        key.text == "constraint" and isinstance(value, Scalar) and value.text == "every"
        for key, value in fields
    )


@pytest.mark.parametrize("section", ["prepositions", "words", "hedges"])
def test_every_word_that_language_knows_has_a_row(section: str) -> None:
    tables = RULEBOOK.tables
    rows = {"prepositions": tables.prepositions, "words": tables.words, "hedges": tables.time_hedges}[section]
    assert [text for text in lexicon(section) if text not in rows] == []


def test_a_user_s_file_overrides_rows_by_name(tmp_path: Path) -> None:
    mine = tmp_path / "mine.yaml"
    mine.write_text(
        "fuzzytime: 1\nwords: {soon: {breakpoints: [0, 0, 1 h, 2 h]}}\nwidth: {base: 1 min, growth: 0}\n"
    )
    rulebook = Rulebook.shipped(files=[mine])

    def resolved(requirement: TimeRequirement) -> Resolution:
        return rulebook.resolve(requirement)

    assert resolved(word("soon")).satisfaction.best.high == HOUR
    assert resolved(word("soon")).shares[0].source == f"{mine}:2"
    assert resolved(ahead("in", 10)).parameters["w"] == 60.0
    assert resolved(word("later")).satisfaction == psi(word("later"))


def test_an_entry_for_an_exact_combination_wins_over_adapting(tmp_path: Path) -> None:
    mine = tmp_path / "mine.yaml"
    mine.write_text(
        "fuzzytime: 1\n"
        "entries:\n"
        "  - name: lunch break\n"
        "    on: {preposition: in, hedge: about, number: 10, unit: minute}\n"
        "    breakpoints: [9 min, 10 min, 11 min, 12 min]\n"
    )
    rulebook = Rulebook.shipped(files=[mine])
    exact = rulebook.resolve(ahead("in", 10, Unit.MINUTE, "about"))
    assert exact.model == "lunch break"
    assert exact.satisfaction.support.low == 9 * MINUTE
    assert rulebook.resolve(ahead("in", 10)).satisfaction == psi(ahead("in", 10))


def test_rows_say_where_they_stand() -> None:
    share = RULEBOOK.resolve(ahead("in", 10)).shares[0]
    line = int(share.source.removeprefix("rules/lookup.yaml:"))
    lines = (rules_directory() / "lookup.yaml").read_text(encoding="utf-8").splitlines()
    assert lines[line - 1].strip().startswith("in:")
