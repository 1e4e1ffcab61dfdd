"""From a phrase to the time requirement that the rest of the program works with."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from fuzzytime.language.instruction import Question, Remark, RemarkKind
from fuzzytime.language.meaning.days.relations import Relative
from fuzzytime.language.meaning.expressions import (
    Coming,
    Duration,
    Edge,
    Ending,
    HourMark,
    Offset,
    Phrase,
    Range,
    Repeat,
    Rest,
    Said,
    Time,
    TimeWord,
    Wall,
)
from fuzzytime.language.meaning.grounded.moment import Moment
from fuzzytime.language.meaning.grounded.range_instants import at_middle, since
from fuzzytime.language.meaning.instants import Instants
from fuzzytime.language.meaning.joined.distances import LOWER, UPPER, distance_bound, said_length
from fuzzytime.language.meaning.recurrences.series import recurrence_that_comes
from fuzzytime.language.meaning.required.decisions import Deciding
from fuzzytime.language.meaning.required.denied_times import beside
from fuzzytime.language.meaning.required.edges import Edges
from fuzzytime.language.meaning.required.offered_days import on_each_day_offered
from fuzzytime.language.meaning.times_of_day import Clock
from fuzzytime.language.meaning.ungrounded import UngroundedError
from fuzzytime.requirement import Constraint, Recurrence, TimeRequirement, Unit

_NOT_SAID = {
    Constraint.EVERY: "how often is not said: say an interval, as in 'every ten minutes'",
    Constraint.FOR: "how long is not said: say a length or an end, as in 'for ten minutes'",
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Grounded:
    """A requirement, the duration or repetition that its words say, and what needs saying about them."""

    requirement: TimeRequirement
    duration: float | None = None
    recurrence: Recurrence | None = None
    remarks: tuple[Remark, ...] = ()
    questions: tuple[Question, ...] = ()


def grounded(phrase: Phrase, text: str, moment: Moment) -> tuple[Grounded, ...]:
    """Ground a phrase: one requirement; more where it says a start and how long, or one of several days.

    Raises
    ------
    UngroundedError
        If its words name no time.
    """
    try:
        offered = (replace(phrase, said=said) for said in on_each_day_offered(phrase.said, moment))
        first = tuple(_Grounder(one, text, moment).result() for one in offered)
    except OverflowError as error:
        raise UngroundedError("a time must lie in the years 1 to 9999") from error
    if phrase.said.denied:
        return _beside(first, moment)
    if phrase.said.lasting is None:
        return first
    length = phrase.said.lasting
    said = said_length(length, Constraint.FOR, "for")
    return *first, _Grounder(replace(phrase, said=said), text, moment).result()


def _beside(found: tuple[Grounded, ...], moment: Moment) -> tuple[Grounded, ...]:
    """Give the times that are left beside those at which something is not to be done."""
    first, *_ = found
    left = beside([one.requirement for one in found], first.recurrence, moment)
    told = Grounded(requirement=left[0], remarks=first.remarks, questions=first.questions)
    return told, *(Grounded(requirement=one) for one in left[1:])


def _goes_on(time: Time | Duration | Repeat) -> bool:
    """Whether something is done again and again from a time of day on, and no end is said."""
    return isinstance(time, Repeat) and time.until is None and isinstance(time.starting, Wall)


class _Grounder:
    def __init__(self, phrase: Phrase, text: str, moment: Moment) -> None:
        self.phrase = phrase
        self.said = _bounded(phrase.said)
        self.text = phrase.above or text[phrase.span[0] : phrase.span[1]]
        if moment.carried and _goes_on(self.said.time):
            # The last line of a day, "feed the cells every two hours starting at nine", is through all of it.
            moment = replace(moment, since=None)
        self.moment = moment
        self._deciding = Deciding(self.text, phrase.span, moment)

    def result(self) -> Grounded:
        time = self.said.time
        if isinstance(time, Duration):
            return self._of_duration(time)
        if isinstance(time, Repeat):
            return self._of_repeat(time)
        if isinstance(time, TimeWord):
            return self._of_word(time)
        if isinstance(time, Offset) and time.anchor is None:
            return self._of_offset(time)
        return self._of_instants(time)

    def _requirement(
        self,
        constraint: Constraint,
        earliest: float | None,
        latest: float | None,
        *,
        hedges: tuple[str, ...] | None = None,
        word: str | None = None,
        duration: Duration | None = None,
        grain: Unit | None = None,
        recurrence: Recurrence | None = None,
    ) -> TimeRequirement:
        if earliest is not None and latest is not None and latest < earliest:
            raise UngroundedError("a time must not end before it starts")
        t_spec = {Constraint.AT: earliest, Constraint.AFTER: earliest, Constraint.BEFORE: latest}.get(
            constraint
        )
        return TimeRequirement(
            text=self.text,
            span=self.phrase.span,
            constraint=constraint,
            preposition=self.said.preposition,
            word=word,
            fuzziness=self.said.hedges if hedges is None else hedges,
            number=None if duration is None else duration.number,
            unit=None if duration is None else duration.unit,
            grain=grain,
            t_spec=t_spec,
            earliest=earliest,
            latest=latest,
            recurrence=recurrence,
            alternative=self.said.alternative,
        )

    # -- kinds ------------------------------------------------------------------------------------------

    def _of_duration(self, time: Duration) -> Grounded:
        constraint = self.said.constraint or Constraint.AT
        if constraint is Constraint.FOR:
            seconds = time.seconds if time.until is None else (time.seconds + time.until.seconds) / 2
            return Grounded(
                requirement=self._requirement(constraint, None, None, duration=time),
                duration=seconds,
                remarks=self._deciding.of_unit(time),
            )
        return Grounded(requirement=self._counted(time, constraint, 1))

    def _of_offset(self, time: Offset) -> Grounded:
        hedges = (*self.said.hedges, *time.duration.hedges)
        constraint = self.said.constraint or Constraint.AT
        return Grounded(requirement=self._counted(time.duration, constraint, time.direction, hedges))

    def _counted(
        self, time: Duration, constraint: Constraint, direction: int, hedges: tuple[str, ...] | None = None
    ) -> TimeRequirement:
        """Give a time by its distance from now; "at most" makes it a deadline, "at least" a release."""
        said = self.said.hedges if hedges is None else hedges
        if constraint is Constraint.AT and (UPPER | LOWER) & set(said):
            # "More than two weeks ago" is before that.
            earlier = bool(UPPER & set(said)) is (direction > 0)
            constraint = Constraint.BEFORE if earlier else Constraint.AFTER
        near = self.moment.later(time, direction)
        far = near if time.until is None else self.moment.later(time.until, direction)
        if constraint is Constraint.BEFORE:
            return self._requirement(constraint, None, far, hedges=said, duration=time)
        if constraint is Constraint.AFTER:
            return self._requirement(constraint, near, None, hedges=said, duration=time)
        if near != far:
            constraint = Constraint.BETWEEN
        return self._requirement(constraint, min(near, far), max(near, far), hedges=said, duration=time)

    def _of_word(self, time: TimeWord) -> Grounded:
        if time.constraint in _NOT_SAID:
            raise UngroundedError(_NOT_SAID[time.constraint])
        constraint = self.said.constraint or time.constraint
        if constraint is Constraint.VAGUE:
            return Grounded(requirement=self._requirement(constraint, None, None, word=time.word))
        earliest = None if constraint is Constraint.BEFORE else 0.0
        latest = None if constraint is Constraint.AFTER else 0.0
        return Grounded(requirement=self._requirement(constraint, earliest, latest, word=time.word))

    def _of_repeat(self, time: Repeat) -> Grounded:
        recurrence = recurrence_that_comes(time, self.moment)
        grains = [grain_of(wall) for wall in time.walls]
        requirement = self._requirement(
            Constraint.EVERY,
            None,
            None,
            duration=time.every,
            grain=min(grains, key=list(Unit).index, default=None),
            recurrence=recurrence,
        )
        deciding = self._deciding
        chosen = deciding.of_repetition(_own_walls(time, self.said.clocks), recurrence)
        # What was chosen for bounds is said where they stand, and not of a day that stands apart.
        bounded = () if self.said.clocks == () else deciding.of_bounds(time, recurrence)
        remarks = (*chosen, *bounded)
        return Grounded(requirement=requirement, recurrence=recurrence, remarks=remarks)

    def _of_instants(self, time: Time) -> Grounded:
        zone = zone_in(time)
        lasting = self.said.lasting.seconds if self.said.lasting is not None else 0.0
        ends = self.said.constraint is Constraint.BEFORE
        opens = ends and self.said.edge is Edge.START
        behind = self.said.preposition == "after"
        edges = Edges(self.said, self.moment, zone)
        here = replace(self.moment.grounding(zone), lasting=lasting, ends=ends, behind=behind, opens=opens)
        time = at_middle(time) if self.said.constraint in {Constraint.BEFORE, Constraint.AFTER} else time
        found = here.instants(time)
        if isinstance(time, Wall) and _is_at_place(time) and edges.has_begun(time, found):
            # "Before work", said at work: before that of tomorrow.
            found = here.instants(replace(time, days=Relative(1)))
        if self.said.preposition == "since" and isinstance(time, Wall):
            found = since(here, time, found)
        start, end = edges.bounds(time, found)
        constraint = self.said.constraint or distance_bound(self.said)
        if constraint is None:
            constraint = Constraint.AT if start == end else Constraint.BETWEEN
        if constraint is Constraint.BETWEEN and start == end:
            constraint = Constraint.AT
        earliest = None if constraint is Constraint.BEFORE else start
        latest = None if constraint is Constraint.AFTER else end
        if constraint is Constraint.BEFORE and self.said.within is not None:
            constraint, earliest = Constraint.BETWEEN, edges.begin_of(self.said.within, end)
        duration = time.duration if isinstance(time, (Offset, Coming)) else None
        hedges = self.said.hedges if duration is None else (*self.said.hedges, *duration.hedges)
        grain = found.grain if isinstance(time, (Wall, Range, Ending, Rest, HourMark)) else None
        requirement = self._requirement(
            constraint, earliest, latest, hedges=hedges, duration=duration, grain=grain
        )
        remarks, questions = self._deciding.of_instants(found, zone)
        remarks = (*remarks, *self._remarks_on(time, found))
        if edges.has_begun(time, found):
            message = (
                f"{self.text!r} is taken as before {found.end:%H:%M}, as it began at {found.start:%H:%M}"
            )
            remarks = (*remarks, Remark(RemarkKind.POLICY, self.phrase.span, message))
        return Grounded(requirement=requirement, remarks=remarks, questions=questions)

    def _remarks_on(self, time: Time, found: Instants) -> Iterator[Remark]:
        """Say what was chosen for a time beside its half of the day."""
        yield from self._deciding.of_midnight(time, found)
        yield from self._deciding.of_hours(self.said, found)
        yield from self._deciding.of_weekday(time, found)
        if isinstance(time, HourMark) and time.open:
            yield self._deciding.of_hour(found)


def _own_walls(repeat: Repeat, own: Sequence[Clock] | None) -> tuple[Wall, ...]:
    """Give the times of a repetition that its own words say, and no others that are told with it."""
    if own is None:
        return repeat.walls
    # Which half of the day is meant may be told by what stands beside it.
    said = {moment for clock in own for moment in clock.candidates()}
    return tuple(w for w in repeat.walls if w.clock is not None and said.issuperset(w.clock.candidates()))


def _is_at_place(wall: Wall) -> bool:
    """Whether it is a part of any day that somebody is somewhere: "school"."""
    return wall.part is not None and wall.part.place and wall.days is None


def _bounded(said: Said) -> Said:
    """Read "up to tomorrow at seven", "six at most" as a deadline: a time of day is no amount."""
    if (
        said.constraint is not None
        or not isinstance(said.time, (Wall, Ending))
        or not UPPER & set(said.hedges)
    ):
        return said
    return replace(said, constraint=Constraint.BEFORE, edge=Edge.LAST)


def grain_of(wall: Wall) -> Unit:
    """Give the finest unit that it names: the hour, for a part of the day."""
    if wall.clock is not None:
        return wall.clock.grain
    return Unit.HOUR if wall.part is not None or wall.days is None else wall.days.grain


def zone_in(time: Time) -> str | None:
    """Give the zone of its clock, or that of the one that it counts from."""
    if isinstance(time, Wall):
        return time.zone
    if isinstance(time, Range):
        return zone_in(time.first) or zone_in(time.last)
    if isinstance(time, Offset) and time.anchor is not None:
        return zone_in(time.anchor)
    return None
