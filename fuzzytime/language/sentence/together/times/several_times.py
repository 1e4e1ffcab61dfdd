"""Several times of one thing: all are meant ("at seven and at eight"), or one ("at seven or at eight")."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.calendar import Fields, is_day_of_month, is_weekday
from fuzzytime.language.meaning.days.relations import Relative
from fuzzytime.language.meaning.expressions import Duration, Phrase, Repeat, TimeWord
from fuzzytime.language.meaning.joined.bounded_repeats import is_of_day
from fuzzytime.language.sentence.sketches.around_events.at_events import events_in
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.together.times.said_again import apart, with_shared_clock, with_shared_part
from fuzzytime.requirement import BOUNDS, Constraint

ON_CONDITION = "if_it_is.at_on_condition"
"""The rule of a clock time that a condition of the calendar stands behind."""

LIST = 2
"""Weekdays side by side, without "and", that are hardly a list."""


TYPED_JOINTS = frozenset({"/", "+"})
"""Marks between two clock times that are both meant."""

MERIDIEMS = frozenset({"am", "pm", "noon", "midnight"})
"""Words that end a clock time, and are no day."""


def of_several_times(sketch: Sketch, words: Sequence[Word]) -> list[Sketch]:
    """Give one sketch for each time that is meant, or one of which each time is an alternative.

    "At seven and at six" asks for two, "at seven or at eight" for one; "tomorrow, by noon" is one time.
    """
    closed = sketch.lexicon.closed
    joining = closed.additions | closed.alternatives
    for place in range(len(sketch.phrases) - 1):
        group, joints = _joined(sketch.phrases[place:], words, sketch.lexicon)
        several = len(group) > LIST and (all(map(_is_weekday, group)) or all(map(_is_clock, group)))
        # "Friday at nine, saturday at ten"
        several = several or all(map(_is_whole, group))
        if len(group) > 1 and (several or joints & joining - {","}):
            rest = [phrase for phrase in sketch.phrases if phrase not in group]
            if joints & closed.alternatives:
                shared = _with_part_behind(_with_month_behind(with_shared_part(group, words)))
                # "Today if you can, otherwise tomorrow at ten": today at any time
                near = any(isinstance(one.said.wall.days, Relative) for one in shared)
                first, *others = _on_one_day(shared if near else with_shared_clock(shared), words)
                others = [
                    _bound_as(first, replace(one, said=replace(one.said, alternative=True))) for one in others
                ]
                return [_with(sketch, [*rest, first, *others])]
            times = with_shared_clock(with_shared_part(_with_month_behind(apart(group)), words))
            return [_with(sketch, [*rest, one]) for one in times]
    return [sketch]


def _joined(
    phrases: Sequence[Phrase], words: Sequence[Word], lexicon: Lexicon
) -> tuple[list[Phrase], set[str]]:
    """Give the first time with those that are joined to it, and the words that join them."""
    closed = lexicon.closed
    group, joints = [phrases[0]], set[str]()
    for following in phrases[1:]:
        between = {word.text for word in words[group[-1].end : following.first]}
        if between & lexicon.beside.second_choice:
            # "Today if you can, otherwise tomorrow", "at noon or, failing that, at two"
            between -= lexicon.beside.courteous | closed.singular_anaphors
        if between <= {"/"} and _is_weekday(group[-1]) and _is_weekday(following):
            # "Monday wednesday and friday", as it is said; "mon/wed/fri", "tue/thu at six"
            between = {"&"} if between else {","}
        if between and between <= TYPED_JOINTS and _is_clock(group[-1]) and _is_clock(following):
            # "7am/7pm", "7am + 7pm"
            between = {"&"}
        pair = (group[-1], following)
        if not between and (all(map(_is_clock, pair)) or all(map(_is_whole, pair))):
            # "For 6 am 6 15 am and 6 30 am", as it is said
            between = {","}
        if not between or between - closed.additions - closed.alternatives:
            break
        either = not between.isdisjoint(closed.alternatives)
        both = not either and _are_two_of_a_day(group[-1], following)
        if not both and not all(_is_when(one) or (either and one.said.constraint in BOUNDS) for one in pair):
            break
        group.append(following)
        joints |= between
    return group, joints


def _with(sketch: Sketch, phrases: Sequence[Phrase]) -> Sketch:
    """Give a sketch with some of its times, which may have got a day or a clock time, in their order."""
    references = {
        phrase.span: reference for phrase, reference in zip(sketch.phrases, sketch.references, strict=True)
    }
    times = tuple(sorted(phrases, key=lambda phrase: phrase.span))
    return replace(sketch, phrases=times, references=tuple(references[time.span] for time in times))


def _on_one_day(phrases: Sequence[Phrase], words: Sequence[Word]) -> list[Phrase]:
    """Give clock times the day, or the part of it, that one of them is on: "tomorrow at six or at seven".

    A day in front of its clock time is lent to none before: "at five or tomorrow at nine".
    """
    whole = phrases[-1].said.wall if _ends_with_day(phrases[-1], words) else None
    found = []
    for phrase in phrases:
        wall = phrase.said.wall
        dated = wall.days is not None or wall.part is not None
        whole = wall if wall.clock is not None and dated else whole
        alone = wall.clock is not None and not dated and whole is not None
        found.append(phrase.at(replace(whole, clock=wall.clock)) if whole and alone else phrase)
    return found


def _bound_as(first: Phrase, phrase: Phrase) -> Phrase:
    """Give a number alone the side of the time before it: "by six or eight"."""
    said, bound = phrase.said, first.said
    if bound.constraint not in BOUNDS or said.preposition is not None or said.constraint is not None:
        return phrase
    return replace(phrase, said=replace(said, constraint=bound.constraint, preposition=bound.preposition))


def _ends_with_day(phrase: Phrase, words: Sequence[Word]) -> bool:
    """Whether a day, or a part of it, stands behind a clock time: "at seven tomorrow".

    A condition holds for its own time alone: "at seven, or at eight if it's sunday".
    """
    if phrase.rule == ON_CONDITION:
        return False
    wall, last = phrase.said.wall, words[phrase.end - 1].text
    dated = wall.clock is not None and (wall.days is not None or wall.part is not None)
    before = [word.text for word in words[phrase.first : phrase.end - 1]]
    return dated and last.isalpha() and "at" not in before[1:] and last not in MERIDIEMS


def _with_month_behind(phrases: Sequence[Phrase]) -> list[Phrase]:
    """Give days of a list the month, and the year, of the last of them: "on the 5th, 6th or 9th of may"."""
    last = _days_of(phrases[-1])
    if last is None or last.day is None or last.month is None:
        return list(phrases)
    found = []
    for phrase in phrases:
        days = _days_of(phrase)
        if days is not None and is_day_of_month(days):
            dated = replace(days, month=last.month, year=last.year)
            found.append(phrase.at(replace(phrase.said.wall, days=dated)))
        else:
            found.append(phrase)
    return found


def _with_part_behind(phrases: Sequence[Phrase]) -> list[Phrase]:
    """Give weekdays the part of the day behind the last of them: "saturday or sunday morning"."""
    said = phrases[-1].said
    part = said.wall.part if said.wall.clock is None else None
    if part is None or said.preposition is not None or not all(map(_is_weekday, phrases)):
        return list(phrases)
    walls = ((phrase, phrase.said.wall) for phrase in phrases)
    return [phrase if wall.is_timed else phrase.at(replace(wall, part=part)) for phrase, wall in walls]


def _days_of(phrase: Phrase) -> Fields | None:
    days = phrase.said.wall.days
    return days if isinstance(days, Fields) else None


def _are_two_of_a_day(first: Phrase, second: Phrase) -> bool:
    """Whether one of two is beside a meal, and both bound no stretch: "before breakfast and at six"."""
    meals = [one for one in (first, second) if _is_beside_meal(one)]
    others = [one for one in (first, second) if not _is_beside_meal(one)]
    if not meals or not all(_is_when(one) and is_of_day(one.said.time) for one in others):
        return False
    parts = {one.said.constraint: one.said.wall.part for one in meals}
    begins, ends = parts.get(Constraint.AFTER), parts.get(Constraint.BEFORE)
    # "Before dinner and after work"
    return begins is None or ends is None or begins.end > ends.start


def _is_weekday(phrase: Phrase) -> bool:
    """Whether it is a day of the week, with or without a time of day."""
    return is_weekday(phrase.said.wall.days)


def _is_clock(phrase: Phrase) -> bool:
    """Whether it is a clock time of a day that is not said."""
    return phrase.said.wall.clock is not None and phrase.said.wall.days is None


def _is_whole(phrase: Phrase) -> bool:
    """Whether it is a clock time of a day that is said."""
    return phrase.said.wall.clock is not None and phrase.said.wall.days is not None


def _is_beside_meal(phrase: Phrase) -> bool:
    """Whether it is before or after a meal of a day that is not said."""
    said, part = phrase.said, phrase.said.wall.part
    beside = said.constraint in BOUNDS and said.preposition in {"before", "after"}
    return beside and part is not None and part.meal and is_of_day(said.time)


def _is_when(phrase: Phrase) -> bool:
    """Whether it is a time at which something may be done, and not a bound, a length or a repetition."""
    said = phrase.said
    if isinstance(said.time, TimeWord):
        return (said.constraint or said.time.constraint) is Constraint.AT
    if isinstance(said.time, Duration):
        return said.constraint is Constraint.AT
    return said.constraint in {None, Constraint.AT, Constraint.BETWEEN} and not isinstance(said.time, Repeat)


def also_at_events(sketch: Sketch, words: Sequence[Word]) -> list[Sketch]:
    """Give one sketch for the time, and one for what hardly is a place and is joined to that by "and"."""
    if not sketch.asks or not sketch.phrases:
        return [sketch]
    ends = {phrase.end for phrase in sketch.phrases}
    for span, is_moment in events_in(sketch, words):
        at = next(place for place, word in enumerate(words) if word.start == span[0])
        joint = at - 1
        if is_moment and joint in ends and words[joint].text in sketch.lexicon.closed.additions:
            heard = (*sketch.joints, (words[joint].start, span[1]))
            return [replace(sketch, joints=heard), replace(sketch, phrases=(), references=(), joints=heard)]
    return [sketch]
