"""Lines that were written in the evening: they are of tomorrow, or go through the night."""

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

UP_SECONDS = 5 * 3600
"""Seconds of a day before which people are up at night, and not early."""


def on_next_day(drafts: Sequence[Draft]) -> list[Draft]:
    """Give what was written in the evening as if "tomorrow:" stood above; none where it names its day.

    One line alone is no day that somebody wrote down.
    """
    if not _is_of_evening(drafts):
        return []
    day = Phrase(Said(Wall(TOMORROW)), 0, 0, (0, 0), HEADED, above=NEXT_DAY)
    timed = next((place for place, draft in enumerate(drafts) if draft.phrases), 0)
    message = (
        f"{NEXT_DAY} is taken as the day of this and the other lines: say 'tonight:' above them if it is not"
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
    named = any(draft.heading is not None and draft.heading.phrases for draft in drafts)
    alone = sum(bool(draft.phrases) for draft in drafts) <= 1
    late = now is not None and now.time() >= EVENING
    return late and not named and not alone and all(draft.now == now for draft in drafts)
