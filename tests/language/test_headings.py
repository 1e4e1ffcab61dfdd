"""Days on lines of their own, which hold for the lines below."""

from datetime import datetime

import pytest

from fuzzytime.language import Language, RemarkKind
from fuzzytime.requirement import TimeRequirement

pytestmark = pytest.mark.model

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - a moment of no zone; a Wednesday
DAY = 86400.0


def _times(*lines: str) -> list[tuple[TimeRequirement, ...]]:
    """Give the times of the instructions of some lines said at one moment."""
    readings = Language.shipped().read_all([(line, NOW) for line in lines])
    return [part.requirements for reading in readings for part in reading.instructions]


def test_a_day_alone_holds_for_the_lines_below_until_the_next() -> None:
    feed, mow, church = _times(
        "Friday", "- feed the cat at 8 am", "- mow the lawn", "Saturday:", "church at 10 am"
    )
    assert [part.earliest for (part,) in (feed, mow, church)] == [
        2 * DAY - 3600,
        2 * DAY - 9 * 3600,
        3 * DAY + 3600,
    ]
    assert mow[0].text == "Friday"


def test_a_day_of_its_own_counts_more_than_that_above() -> None:
    ((call,),) = _times("Friday", "call mum tomorrow")
    assert call.text == "tomorrow"


def test_a_day_that_nothing_follows_is_a_time_alone() -> None:
    ((friday,),) = _times("on friday")
    assert friday.text == "on friday"


def test_what_a_day_above_holds_for_is_said() -> None:
    heading, _ = Language.shipped().read_all([("Friday", NOW), ("mow the lawn", NOW)])
    assert [remark.kind for remark in heading.remarks] == [RemarkKind.POLICY]
