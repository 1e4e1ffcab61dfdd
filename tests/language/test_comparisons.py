"""Numbers in clauses: on which side of what they are, and what stands behind them."""

from datetime import datetime

import pytest

from fuzzytime.language import Language
from fuzzytime.language.english import grammar
from fuzzytime.language.finding import find_times, shipped_lexicon
from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.language.sentence.clauses.comparisons import comparisons_in
from fuzzytime.requirement import Comparison, Side
from fuzzytime.times import HOUR

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - the wall's own time


def compared(text: str) -> tuple[Comparison, ...]:
    lexicon = shipped_lexicon()
    return comparisons_in(Scanned.of(text, grammar(), lexicon), (0, len(text)))


@pytest.mark.parametrize(
    ("text", "side", "number", "behind"),
    [
        ("the oven is above 150 degrees", Side.ABOVE, 150, "degrees"),
        ("it is hotter than 150 degrees", Side.ABOVE, 150, "degrees"),
        ("the speed exceeds 1,200 rpm", Side.ABOVE, 1200, "rpm"),
        ("the oven is at least 350 \u00b0F", Side.AT_LEAST, 350, "\u00b0F"),
        ("it has heated up to a hundred and fifty", Side.AT_LEAST, 150, ""),
        ("the pan reaches 180 degC", Side.AT, 180, "degC"),
        ("it is at 25.5 degrees", Side.AT, 25.5, "degrees"),
        ("there are 20 parts left", Side.AT, 20, "parts left"),
        ("the roast reaches an internal temperature of 70 degrees", Side.AT, 70, "degrees"),
        ("the soup has cooled down to 60", Side.AT_MOST, 60, ""),
        ("we're down to 50 parts", Side.AT_MOST, 50, "parts"),
        ("only 20% is left", Side.AT_MOST, 20, "% is left"),
        ("it drops below -5 degrees outside", Side.BELOW, -5, "degrees outside"),
        ("the freezer is above minus 18 degrees", Side.ABOVE, -18, "degrees"),
        ("fewer than twenty parts are left", Side.BELOW, 20, "parts are left"),
    ],
)
def test_a_number_stands_on_one_side(text: str, side: Side, number: float, behind: str) -> None:
    (found,) = compared(text)
    assert (found.side, found.number, found.until, found.behind) == (side, number, None, behind)


@pytest.mark.parametrize("text", ["it is between 150 and 180 degrees", "it is at 150 to 180 degrees"])
def test_two_numbers_are_the_ends_of_a_range(text: str) -> None:
    (found,) = compared(text)
    assert (found.side, found.number, found.until, found.behind) == (Side.BETWEEN, 150, 180, "degrees")


def test_hedges_stay_with_their_number() -> None:
    (found,) = compared("the pan is above roughly 150 degrees")
    assert found.fuzziness == ("roughly",)


def test_each_number_of_a_clause_is_found() -> None:
    found = compared("the pan is above 100 degrees but below 150")
    assert [(one.text, one.side) for one in found] == [("above 100", Side.ABOVE), ("below 150", Side.BELOW)]


@pytest.mark.parametrize(
    "text",
    ["the pan is hot", "it is a mess", "the clock shows 8:30", "version 3.1.2 is out", "two eggs boil", ""],
)
def test_other_words_and_numbers_measure_nothing(text: str) -> None:
    assert compared(text) == ()


@pytest.mark.parametrize("how", ["longer than 4", "more than 4", "under 4", "between 4 and 6", "around 4"])
def test_what_a_thing_measures_in_a_clause_is_no_clock_time(how: str) -> None:
    assert find_times(f"wash up when the queue is {how}", None).found == ()


@pytest.mark.parametrize(
    "clause",
    [
        "when the battery < 20",
        "if errors > 5",
        "as soon as load <= 3",
        "unless speed >= 10",
        "when level > 80 or pressure > 12",
    ],
)
def test_a_mark_compares_what_a_clause_is_about(clause: str) -> None:
    (requirement,) = Language.shipped().read(f"Restart it {clause}", now=NOW).instructions[0].requirements
    assert requirement.condition is not None
    assert (requirement.condition.text, len(requirement.condition.comparisons)) == (
        clause,
        clause.count(" or ") + 1,
    )


@pytest.mark.parametrize(
    "how",
    ["when it is past 4", "when the time is around 4", "at 4", "> 4", "if it rains, > 4", "when it's > 4"],
)
def test_the_clock_s_own_number_stays_a_time(how: str) -> None:
    (requirement,) = find_times(f"wash up {how}", NOW).requirements
    assert requirement.earliest == 7 * HOUR
