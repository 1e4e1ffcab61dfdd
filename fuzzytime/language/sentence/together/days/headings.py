"""Times on lines of their own, which hold for the lines below: "Saturday:", "Before the guests come:"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.instruction import Reading, Remark, RemarkKind, Span
from fuzzytime.language.meaning.calendar import Calendar
from fuzzytime.language.meaning.expressions import Phrase, TimeWord, Wall, wall_of
from fuzzytime.language.meaning.joined.told_apart import told_apart
from fuzzytime.language.meaning.phrases import places_in
from fuzzytime.language.meaning.times_of_day import Clock
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.heading import Heading
from fuzzytime.language.sentence.segments.lists.heads import is_meal
from fuzzytime.language.sentence.segments.lists.things_needed import is_marked
from fuzzytime.language.sentence.sketches.sketch import sketch_of
from fuzzytime.language.sentence.together.days.dated_lines import days_gone_on_with, heads_lines, with_dates
from fuzzytime.language.sentence.together.days.periods_above import (
    in_week,
    is_plan_title,
    plan_period,
    week_of,
    when_begun,
    with_plan,
)
from fuzzytime.language.sentence.together.days.titles import (
    LONGEST,
    begins_order,
    held,
    hours_of,
    is_of_calendar,
    name_of,
    names_day,
    title_of,
)
from fuzzytime.language.sentence.together.days.windows import clocks_in

DISTANCE = 4
"""Words of such a length at most: "three to four weeks"."""

CALLED = 2
"""Words that call a worker: "Robot 2:"."""


def under_headings(drafts: Sequence[Draft]) -> list[Draft]:
    """Give drafts of lines said at one moment, each with the time that the nearest line above names alone.

    A part of the day, or a clause, is of the day that a line above it names, and a weekday of the week.
    """
    drafts = with_plan(with_dates(drafts))
    headings = [
        (plan_period(draft) if is_plan_title(drafts, place) else None)
        or _heading_of(draft, heads=heads_lines(drafts, place), above=_is_above_marks(drafts, place))
        for place, draft in enumerate(drafts)
    ]
    if headings and headings[0] is None:
        headings[0] = title_of(drafts) or (_list_of(drafts[0]) if len(drafts) > 1 else None)
    gone_on = days_gone_on_with(drafts)
    found: list[Draft] = []
    heading: Heading | None = None
    day: Heading | None = None
    week: Calendar | None = None
    latest, numbered = 0, False
    for place, draft in enumerate(drafts):
        if place and draft.now != drafts[place - 1].now:
            heading = day = week = None
        named, begun = headings[place], plan_period(draft)
        if begun is not None:
            heading, day, week = begun, begun, week_of(begun)
            draft = replace(draft, remarks=(*draft.remarks, *when_begun(draft)))  # noqa: PLW2901
        if named is not None:
            named = replace(named, phrases=in_week(named.phrases, week))
            week = week_of(named) or week
        else:
            draft = replace(draft, phrases=in_week(draft.phrases, week))  # noqa: PLW2901
        if numbered and draft.step is not None and named is None:
            # "3) The day before" heads nothing below "4) On moving day".
            heading = None
        hours = [] if heading is None or named is not None else clocks_in(draft)
        if heading is not None and _is_over(heading, hours, latest):
            heading = _of_whole_day(heading) or day
        latest = 0 if named is not None else max([latest, *(min(clock.candidates()) for clock in hours)])
        if named is not None:
            heading, numbered = _on_day(named, day), draft.step is not None
            day = named if named.is_day or any(map(names_day, named.phrases)) else day
        if named is not None and named.happens:
            found.append(replace(draft, remarks=(*draft.remarks, _remark_on(named, (0, len(draft.text))))))
            continue
        found.append(
            replace(
                draft, heading=heading or gone_on[place], leads=named is not None and _holds(headings, place)
            )
        )
    return found


def _holds(headings: Sequence[Heading | None], place: int) -> bool:
    """Whether a heading has lines below it, or one for some of them."""
    heading, below = headings[place], headings[place + 1 : place + 2]
    if heading is None or not below:
        return False
    finer = not below[0].is_day or (week_of(heading) and not week_of(below[0])) if below[0] else True
    return below[0] is None or (heading.is_day and bool(finer))


def _is_above_marks(drafts: Sequence[Draft], place: int) -> bool:
    """Whether a line without a bullet stands above one with it: "Once a month", "- Degrease the chain"."""
    here, below = drafts[place], drafts[place + 1 : place + 2]
    return not is_marked(here.text) and here.step is None and any(is_marked(one.text) for one in below)


def _heading_of(draft: Draft, *, heads: bool, above: bool) -> Heading | None:
    """Give what a line names that says a time, and nothing else, or that ``heads`` others.

    ``above`` lines with marks it may be any time.
    """
    if heads:
        return Heading(name_of(draft), draft.text, draft.scanned, held(draft, draft.phrases))
    marked = draft.text.rstrip(" *_").endswith(":")
    if marked and (called := _called(draft)) is not None:
        return Heading(called, draft.text, draft.scanned, addressee=called)
    if marked and _is_title(draft):
        days = [phrase for phrase in draft.phrases if not _names_thing(phrase, draft)]
        return Heading(name_of(draft), draft.text, draft.scanned, held(draft, days))
    if marked and (hours := hours_of(draft)) is not None:
        return hours
    above = above or _counts_back(draft)
    if len(draft.parts) != 1 or not (marked or above or len(draft.phrases) == 1):
        return None
    if marked or above:
        sketch = sketch_of(draft, draft.parts[0])
        phrases, clauses = sketch.phrases, sketch.clauses
    else:
        phrases, clauses = draft.phrases, ()
    heard = [*(phrase.span for phrase in phrases), *(clause.span for clause in clauses)]
    if not heard or any(isinstance(p.said.time, TimeWord) for p in phrases):
        return None
    # As in "Saturday in the garden:", where more than the day is named.
    titled = marked and sketch.operation is None and any(p.said.is_day for p in phrases)
    if _says_more(draft, heard) and not titled:
        return None
    part = phrases[0].said.wall.part if phrases else None
    if (not (marked or above) and not is_of_calendar(phrases[0])) or any(map(_is_meal, phrases)):
        return None
    if not marked and part is not None and part.meal and not part.place:
        # "Sunday lunch" is one.
        return None
    return Heading(name_of(draft), draft.text, draft.scanned, held(draft, phrases), clauses)


def _list_of(first: Draft) -> Heading | None:
    """Give what a line names as a list, with its day: "jobs for thursday", "closing down list"."""
    timed = places_in(first.phrases)
    beside = (word for place, word in enumerate(first.scanned.words) if place not in timed)
    words = [word.text for word in beside if word.is_letters]
    named = [word for word in words if word not in first.lexicon.function_words]
    days = all(phrase.said.is_day and is_of_calendar(phrase) for phrase in first.phrases)
    if not days or len(words) > LONGEST or begins_order(first):
        return None
    is_list = named[-1:] and named[-1] in first.lexicon.beside.titles_of_lists
    return Heading(name_of(first), first.text, first.scanned, held(first, first.phrases)) if is_list else None


def _is_over(heading: Heading, hours: Sequence[Clock], latest: int) -> bool:
    """Whether hours are behind the part of a day that heads lines: "Monday morning", then "lunch 12.30".

    So is one that is in front of it, and of the ``latest`` that was said below the heading.
    """
    part = None if heading.day is None else wall_of(heading.day.said.time).part
    if part is None or part.half.is_late:
        return False
    outside = (
        clock.candidates()
        for clock in hours
        if all(not part.start <= moment <= part.end for moment in clock.candidates())
    )
    return any(
        moments[0] < latest or min(moments, key=lambda one: max(part.start - one, one - part.end)) > part.end
        for moments in outside
    )


def _of_whole_day(heading: Heading) -> Heading | None:
    """Give a heading of a part of a day as one of its day, if it names that."""
    walls = ((phrase, phrase.said.time) for phrase in heading.phrases)
    whole = [
        phrase.at(replace(day, part=None)) for phrase, day in walls if isinstance(day, Wall) and day.days
    ]
    return replace(heading, phrases=tuple(whole)) if whole else None


def _is_title(draft: Draft) -> bool:
    """Whether a line with a colon says what the lines below are about: "Saturday, garden:", "Bakery:".

    It has no times but days, and asks for nothing.
    """
    named = [word for word in draft.scanned.words if word.is_letters]
    timed = places_in(draft.phrases)
    beside = [
        word for place, word in enumerate(draft.scanned.words) if place not in timed and word.is_letters
    ]
    if not beside or beside[0].text in draft.lexicon.function_words or len(named) > LONGEST:
        return False
    if not all(phrase.said.is_day and is_of_calendar(phrase) for phrase in draft.phrases):
        return False
    return not begins_order(draft)


def _names_thing(phrase: Phrase, draft: Draft) -> bool:
    """Whether a part of the day calls what stands behind it: "Morning round:"."""
    words = draft.scanned.words
    return not names_day(phrase) and phrase.end < len(words) and words[phrase.end].is_letters


def _called(draft: Draft) -> str | None:
    """Give who is called by a number, and asked for nothing: "Robot 2:"."""
    words = [word for word in draft.scanned.words if word.text[0].isalnum()]
    if len(words) != CALLED or words[0].text not in draft.lexicon.workers or not words[1].is_digits:
        return None
    return draft.text[words[0].start : words[1].end]


def _counts_back(draft: Draft) -> bool:
    """Whether a line begins with so long before something, or what was said: "two weeks before the move"."""
    texts = [word.text for word in draft.scanned.words]
    sides = draft.lexicon.beside.before_or_after
    before = next((place for place, text in enumerate(texts) if text in sides), len(texts))
    return 0 < before <= DISTANCE and draft.scanned.around.is_unit(before - 1)


def _says_more(draft: Draft, heard: Sequence[Span]) -> bool:
    """Whether words stand outside of some stretches."""
    words = (word for word in draft.scanned.words if word.text[0].isalnum())
    return any(not any(first <= word.start < end for first, end in heard) for word in words)


def _is_meal(phrase: Phrase) -> bool:
    """Whether a time may as well be a thing: "Dinner:"."""
    said = phrase.said
    return is_meal(said.time) and said.wall.clock is None and said.preposition is None


def _on_day(heading: Heading, above: Heading | None) -> Heading:
    """Give a heading that names no day on that of a line above."""
    own = heading.is_day or any(map(names_day, heading.phrases))
    if above is None or above.day is None or own:
        return heading
    if heading.addressee is not None:
        return replace(heading, phrases=above.phrases, clauses=above.clauses)
    told = [told_apart(phrase.said, above.day.said) for phrase in heading.phrases]
    phrases = [
        phrase if said is None else replace(phrase, said=said)
        for phrase, said in zip(heading.phrases, told, strict=True)
    ]
    if not any(told):
        phrases = [above.day, *phrases]
    return replace(heading, phrases=tuple(phrases), name=f"{above.name}, {heading.name}")


def read_heading(draft: Draft) -> Reading:
    """Give the reading of a time that holds for the lines below it."""
    heading = draft.heading or Heading(draft.text, draft.text, draft.scanned)
    remarks = when_begun(draft) or (_remark_on(heading, (0, len(draft.text))),)
    return Reading(text=draft.text, now=draft.now, instructions=(), remarks=remarks)


def _remark_on(heading: Heading, span: Span) -> Remark:
    """Say for what the lines below take a heading."""
    what = "day" if heading.is_day and not heading.clauses else "time"
    message = f"{heading.name!r} is taken as the {what} of the lines below it"
    if not heading.phrases and not heading.clauses:
        message = f"{heading.name!r} is taken as what the lines below it are about"
    if heading.addressee is not None:
        message = f"{heading.name!r} is taken as who is asked in the lines below it"
    return Remark(RemarkKind.POLICY, span, message)


def day_above(heading: Heading | None) -> Calendar | None:
    """Give the day that a line above names."""
    day = None if heading is None else heading.day
    return None if day is None else day.said.wall.days
