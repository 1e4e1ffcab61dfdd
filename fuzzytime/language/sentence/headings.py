"""Days on lines of their own, which hold for the lines below: "Saturday:", then "feed the cat at 8"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.instruction import Reading, Remark, RemarkKind
from fuzzytime.language.meaning.expressions import Phrase, Wall
from fuzzytime.language.sentence.drafts import Draft, Heading


def under_headings(drafts: Sequence[Draft]) -> list[Draft]:
    """Give drafts of lines said at one moment, each with the day that the nearest line above names alone."""
    found: list[Draft] = []
    heading: Heading | None = None
    for place, draft in enumerate(drafts):
        if place and draft.now != drafts[place - 1].now:
            heading = None
        named = _day_alone(draft)
        leads = named is not None and any(
            _day_alone(below) is None for below in drafts[place + 1 : place + 2]
        )
        if named is not None:
            heading = Heading(named.said, draft.text.strip(" :.-*#"))
        found.append(replace(draft, heading=heading, leads=leads))
    return found


def _day_alone(draft: Draft) -> Phrase | None:
    """Give the day that is all that a text says."""
    if len(draft.phrases) != 1:
        return None
    phrase, words = draft.phrases[0], draft.scanned.words
    time = phrase.said.time
    outside = (*words[: phrase.first], *words[phrase.end :])
    is_day = isinstance(time, Wall) and time.days is not None and time.clock is None and not time.weak
    bound = phrase.said.constraint is not None
    return phrase if is_day and not bound and not any(word.text[0].isalnum() for word in outside) else None


def read_heading(draft: Draft) -> Reading:
    """Give the reading of a day that holds for the lines below it."""
    said = draft.heading.text if draft.heading is not None else draft.text
    span = (0, len(draft.text))
    remark = Remark(RemarkKind.POLICY, span, f"{said!r} is taken as the day of the lines below it")
    return Reading(text=draft.text, now=draft.now, instructions=(), remarks=(remark,))
