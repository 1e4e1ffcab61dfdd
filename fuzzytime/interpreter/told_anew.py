"""What happens, told anew: at another time, later, not at all, or now."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from datetime import date, datetime, time

from fuzzytime.interpreter.happening import without_time
from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.interpreter.making import Maker
from fuzzytime.interpreter.request import SpokenWish, Started
from fuzzytime.language import Lexicon, Reading, find_times, is_several
from fuzzytime.language.about_wishes import News, NewsKind, merged_time
from fuzzytime.language.instruction import overlap
from fuzzytime.requirement import TimeRequirement
from fuzzytime.satisfaction import NEVER, Rectangle
from fuzzytime.times import instant_after, seconds_between

REVIVING = frozenset({NewsKind.TIME, NewsKind.THERE})
"""News of what happens after all, though it was cancelled."""


def meant(
    news: News, skills: Sequence[Interpreted], wish: SpokenWish, told: float, lexicon: Lexicon
) -> int | None:
    """Give the position of what news is about; None where nothing was said to happen that it names.

    ``told`` is when it was told, in seconds from now. Of what has the same name that is meant which comes
    next; "it" and "they" are what was spoken of last.
    """
    found = [place for place, one in enumerate(skills) if _may_be(news, one, wish, lexicon)]
    if news.several is None:
        return min(found, key=lambda place: _distance(skills[place], told), default=None)
    fitting = [place for place in found if _is_several(skills[place], lexicon) is news.several]
    return next(reversed(fitting or found), None)


def _may_be(news: News, one: Interpreted, wish: SpokenWish, lexicon: Lexicon) -> bool:
    if one.operation is None or one.skill.duration or not news.is_of(one.operation, lexicon):
        return False
    if one.cancelled and news.kind not in REVIVING:
        return False
    if any(part.anchor is not None for part in one.requirements):
        return False
    if news.kind is NewsKind.LATER and not one.requirements:
        return False
    return news.marked or seconds_between(one.wish.given, wish.given) > 0


def _is_several(one: Interpreted, lexicon: Lexicon) -> bool:
    return one.operation is not None and is_several(one.operation.object or "", lexicon)


def _distance(one: Interpreted, told: float) -> tuple[bool, float]:
    """Say how near what happens is, where all that is still to come is nearer than what is over."""
    moment = moment_of(one)
    return moment < told, abs(moment - told)


def moment_of(one: Interpreted) -> float:
    """Give when something happens, in seconds from now: as it was named, else at the earliest."""
    skill = one.skill
    if skill.preferred is not None:
        return skill.preferred
    return skill.satisfaction.best.low if not skill.satisfaction.best.empty else 0.0


def told_anew(
    made: Interpreted, news: News, wish: SpokenWish, reading: Reading, maker: Maker, told: float
) -> Interpreted:
    """Give what happens as it is told anew; ``told`` is when, in seconds from now.

    Where its first time was over when this was told, it is another: it keeps no identifier.
    """
    by = (*made.told_by, wish.identifier)
    if news.kind is NewsKind.CANCELLED:
        never = replace(made.skill, satisfaction=NEVER)
        reason = "it was told not to happen"
        return replace(made, skill=never, reason=reason, waits=False, cancelled=True, told_by=by)
    if made.instruction is None:
        return made
    sooner = replace(news, by=told - moment_of(made)) if news.kind is NewsKind.THERE else news
    times = (
        _later(sooner, made, wish) if news.time is None else (_chosen(news.time, news, made, wish, maker),)
    )
    instruction = replace(made.instruction, span=news.span, requirements=times)
    anew = _made_again(made, maker.spoken(_wish_anew(wish, made), reading, instruction)[0])
    skill = anew.skill
    if news.kind is NewsKind.THERE:
        skill = replace(skill, satisfaction=Rectangle(told, told), preferred=told)
    return replace(anew, skill=skill, told_by=by)


def on_its_day(one: Interpreted, before: Interpreted, after: Interpreted, maker: Maker) -> Interpreted:
    """Give what is on a day that counts from what was told anew: as many days later, or not at all."""
    if after.cancelled:
        return without_time(one, after)
    first, last = (datetime.combine(_day(told, maker), time()) for told in (before, after))
    if one.instruction is None or one.reading is None or not isinstance(one.wish, SpokenWish):
        return one
    times = tuple(part.shifted(seconds_between(first, last)) for part in one.instruction.requirements)
    moved = replace(one.instruction, requirements=times)
    return replace(_made_again(one, maker.spoken(one.wish, one.reading, moved)[0]), told_by=one.told_by)


def _made_again(old: Interpreted, anew: Interpreted) -> Interpreted:
    """Give what is made again its identifier; it takes as long as was said of it, or given."""
    skill = replace(anew.skill, duration=old.skill.duration, elapsed=old.skill.elapsed)
    return replace(anew, identifier=old.identifier, skill=skill, duration=old.duration)


def _day(one: Interpreted, maker: Maker) -> date:
    """Give the day on which something happens, or would have, where it was cancelled."""
    said = (part.earliest for part in one.requirements if part.earliest is not None)
    first = next(said, None) if one.cancelled else None
    if first is not None:
        return instant_after(one.wish.given, first).date()
    return instant_after(maker.request.now, moment_of(one)).date()


def _wish_anew(wish: SpokenWish, made: Interpreted) -> SpokenWish:
    """Give the wish that tells anew of something, which counts as much as it did."""
    old = made.wish
    return replace(wish, priority=old.priority, agent=old.agent, hands_on=old.hands_on, elapsed=old.elapsed)


def _chosen(
    time: TimeRequirement, news: News, made: Interpreted, wish: SpokenWish, maker: Maker
) -> TimeRequirement:
    """Give the new time, on the old day where it leaves that open; of several that which is nearest."""
    (first, *others), lexicon = made.requirements or (time,), maker.lexicon
    words = merged_time(first.text, made.wish.given, time.text, wish.given, lexicon)
    merged = find_times(words, wish.given, lexicon).requirements
    if not others and words != time.text and len(merged) == 1:
        return replace(merged[0], span=time.span)
    if news.question is None:
        return time
    old = instant_after(maker.request.now, moment_of(made))
    choices, chosen = news.question.choices, news.question.chosen

    def unlikely(choice: datetime) -> tuple[bool, float]:
        hour = choice.hour + choice.minute / 60
        return lexicon.policy.far_from(hour, hour - seconds_between(old, choice) / 3600)

    return time.shifted(seconds_between(choices[chosen], min(choices, key=unlikely)))


def _later(news: News, made: Interpreted, wish: SpokenWish) -> tuple[TimeRequirement, ...]:
    """Give the times that were said, so much later, counted from when that was told."""
    by = news.by + (0.0 if made.wish.moved is None else made.wish.moved.by)
    since = seconds_between(wish.given, made.wish.given)
    words = wish.text[news.span[0] : news.span[1]]
    return tuple(replace(part.shifted(since + by), text=words, span=news.span) for part in made.requirements)


def as_they_happened(skills: Sequence[Interpreted], started: Sequence[Started]) -> list[Interpreted]:
    """Give what happened the moment at which it did: what is tied to it goes by that."""
    begun: Mapping[str, Started] = {one.identifier: one for one in started}
    return [_as_it_happened(one, begun.get(one.identifier)) for one in skills]


def _as_it_happened(one: Interpreted, begun: Started | None) -> Interpreted:
    if begun is None or not one.stated or one.skill.duration or one.cancelled:
        return one
    moment = Rectangle(begun.start, begun.start)
    return replace(one, skill=replace(one.skill, satisfaction=moment, preferred=begun.start))


def asks_beside_another(reading: Reading, news: News) -> bool:
    """Whether words that tell a time ask for something before or after another: "wash it before then"."""
    own = (one for one in reading.instructions if overlap(one.span, news.span))
    return any(
        one.operation is not None and one.operation.is_asked and any(part.anchor for part in one.requirements)
        for one in own
    )
