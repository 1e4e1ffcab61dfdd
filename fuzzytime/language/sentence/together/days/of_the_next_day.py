"""Lines of tomorrow, as their first hour is over; lines of the evening, of the night or of tomorrow."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.instruction import Remark, RemarkKind
from fuzzytime.language.meaning.days.relations import Relative
from fuzzytime.language.meaning.expressions import Phrase, Said, Wall
from fuzzytime.language.meaning.grounded.chosen_clocks import EVENING
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.heading import HEADED, Heading
from fuzzytime.language.sentence.together.days.titles import shift_of
from fuzzytime.language.sentence.together.days.windows import clocks_in

TOMORROW = Relative(1)
NEXT_DAY = "tomorrow"
TONIGHT = "tonight"
TODAY = "today"
NOON = 12
"""The hour before which lines are of a morning that is not over."""

UP_SECONDS = 5 * 3600
"""Seconds of a day before which people are up at night, and not early."""


def on_next_day(drafts: Sequence[Draft], *, over: bool = False) -> list[Draft]:
    """Give lines as if "tomorrow:" stood above; none where they name their day.

    They were written in the evening; or, where that is asked, begin at an hour that is ``over``.
    """
    if not (_name_no_day(drafts) and _begin_before_now(drafts) if over else _is_of_evening(drafts)):
        return []
    day = Phrase(Said(Wall(TOMORROW)), 0, 0, (0, 0), HEADED, above=NEXT_DAY)
    timed = next((place for place, draft in enumerate(drafts) if draft.phrases), 0)
    other = TODAY if over else TONIGHT
    message = (
        f"{NEXT_DAY} is taken as the day of this and the other lines: say '{other}:' above them if it is not"
    )
    remark = Remark(RemarkKind.POLICY, (0, len(drafts[timed].text)), message)
    return [
        replace(
            draft,
            heading=Heading(NEXT_DAY, draft.text, draft.scanned, (day,)),
            remarks=(*draft.remarks, *([remark] if place == timed else [])),
        )
        for place, draft in enumerate(drafts)
    ]


def through_night(drafts: Sequence[Draft]) -> list[Draft]:
    """Give what was written in the evening as if "night shift:" stood above; none where no hour is at night.

    "Start at nine", "sandwich at midnight", "check the boilers at two", "finish at six".
    """
    clocks = (moment for draft in drafts for clock in clocks_in(draft) for moment in (clock.candidates(),))
    if not _is_of_evening(drafts) or not any(max(moments) < UP_SECONDS for moments in clocks):
        return []
    night = Phrase(Said(shift_of(Relative(0))), 0, 0, (0, 0), HEADED, above=TONIGHT)
    return [replace(draft, heading=Heading(TONIGHT, draft.text, draft.scanned, (night,))) for draft in drafts]


def _is_of_evening(drafts: Sequence[Draft]) -> bool:
    """Whether lines with times were all written in the evening, and name no day."""
    now = drafts[0].now if drafts else None
    return now is not None and now.time() >= EVENING and _name_no_day(drafts)


def _name_no_day(drafts: Sequence[Draft]) -> bool:
    """Whether several lines with times, written at one moment, name no day."""
    named = any(draft.heading is not None and draft.heading.phrases for draft in drafts)
    alone = sum(bool(draft.phrases) for draft in drafts) <= 1
    return not named and not alone and all(draft.now == drafts[0].now for draft in drafts)


def _begin_before_now(drafts: Sequence[Draft]) -> bool:
    """Whether the first clock time of lines in the order of a day was this morning: "6:45 …" said at nine."""
    clocks = [clock for draft in drafts for clock in clocks_in(draft)]
    now = drafts[0].now
    if now is None or not clocks:
        return False
    first = min(clocks[0].candidates())
    return UP_SECONDS <= first < now.hour * 3600 + now.minute * 60 and now.hour < NOON
