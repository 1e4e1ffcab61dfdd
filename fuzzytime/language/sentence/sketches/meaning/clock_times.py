"""What was said last: a clock time, which one without am or pm hardly precedes, and a day, to count from."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from datetime import time, timedelta

from fuzzytime.language.instruction import Reading, RemarkKind, Span, overlap
from fuzzytime.language.meaning.grounded.chosen_clocks import CLOSE, EVENING, FOLLOWING
from fuzzytime.language.meaning.grounded.part_instants import EARLY
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.policy import Policy
from fuzzytime.requirement import BOUNDS, SAID_WHEN, Constraint, Reference, TimeRequirement, Unit

A_DAY = 86400.0
A_WEEK = 7 * A_DAY
"""Seconds of a day and of a week; what is longer names no day."""


NIGHT_SECONDS = A_DAY / 2 + 1
"""What goes on over midnight for longer leaves open which half of the day is meant."""


@dataclass(frozen=True, slots=True)
class LastSaid:
    """The clock time, and the day, that were said last, in seconds from now; None where none was.

    ``night`` is from when to when something goes on over midnight, as was told; ``begun`` is the first clock
    time of a line, ``forward`` how many of them came later than the one before, on ``lines`` before this, and
    ``earliest`` and ``latest`` the ends of all, ``nightly`` how many are at night. ``released`` is the last
    clock time that is no deadline: what is due "before bed" is no clue that the next line is behind it, nor
    are deadlines among the latest. ``early`` says that the first may be as early as people are up, ``over``
    that it may be a little while ago, ``usual`` that things are done at their usual hours. ``ahead`` is the
    day that those before it count from.
    """

    clock: float | None = None
    day: float | None = None
    night: tuple[float, float] | None = None
    begun: float | None = None
    forward: int = 0
    lines: int = 0
    earliest: float | None = None
    latest: float | None = None
    nightly: int = 0
    released: float | None = None
    early: bool = False
    over: bool = False
    usual: bool = True
    ahead: float | None = None

    @property
    def in_order(self) -> bool:
        """Whether lines go through a day in its order, as far as is known."""
        return self.forward >= IN_ORDER and self.forward >= MOSTLY * self.lines

    @property
    def may_be_over(self) -> bool:
        """Whether the next line may be a little while ago, as all before it are."""
        return self.over and (self.clock is None or self.clock < 0)

    @property
    def since(self) -> float | None:
        """The clock time that the next line goes on from: the latest of lines in order, if one went back."""
        if self.clock is None or self.latest is None or not self.in_order:
            return self.clock
        return self.latest if 0 < self.latest - self.clock < A_DAY / 2 else self.clock

    @property
    def due_since(self) -> float | None:
        """The clock time that it goes on from where it is not behind a deadline that was said last."""
        return None if self.released == self.clock else self.released

    @property
    def astray(self) -> int:
        """How many lines begin earlier than the one before, or at night."""
        return self.lines - self.forward + self.nightly

    def policy(self, shipped: Policy) -> Policy:
        """Give the policy for the next line: the first of all may be ``early``."""
        first = self.early and self.clock is None
        return replace(shipped, plausible_from=EARLY, ahead_from=EARLY) if first else shipped

    @property
    def opened(self) -> float | None:
        """The earliest clock time of enough lines, before which another is hardly meant."""
        return self.earliest if self.lines >= SEVERAL else None

    def behind(self, before: "LastSaid") -> "LastSaid":
        """Give the same, with how far lines have gone on from what was said before."""
        last, begun = before.begun, before.begun if self.begun is None else self.begun
        if last is None or begun is None:
            return replace(self, begun=begun)
        opened = [end for end in (before.earliest, last, begun) if end is not None]
        released = [end for end in (before.latest, before.released, self.released) if end is not None]
        return replace(
            self,
            begun=begun,
            forward=before.forward + (begun > last),
            lines=before.lines + (begun != last),
            earliest=min(opened),
            latest=max(released, default=None),
        )


IN_ORDER = 2
"""Times that come later than the one before, from which on lines go through a day in its order."""

MOSTLY = 2 / 3
"""The part of lines, at least, that come later than the one before where they go through a day."""

SEVERAL = 3
"""Lines with another clock time than the one before, from which on the earliest is where a day begins."""

UP = time(5)
"""Before it, what lines say is at night."""

NOTHING = LastSaid()


def last_said(requirements: Iterable[TimeRequirement], before: LastSaid) -> LastSaid:
    """Give the last clock time and day that are said; those of before where there are none."""
    for requirement in requirements:
        begin, latest = requirement.earliest, requirement.latest
        length = 0.0 if begin is None or latest is None else latest - begin
        if begin is not None and length <= A_WEEK and requirement.constraint in SAID_WHEN:
            # Of a weekend, its last day.
            named = requirement.grain in {*SUB_DAY, Unit.DAY} or length > A_DAY
            before = replace(before, day=begin + max(0.0, length - A_DAY)) if named else before
        offered = requirement.constraint is Constraint.AFTER and requirement.alternative
        if requirement.constraint in SAID_WHEN | BOUNDS and requirement.grain in SUB_DAY and not offered:
            due = requirement.reference is Reference.THROUGHOUT
            if latest is not None and (begin is None or due or latest - begin > FOLLOWING.total_seconds()):
                # "Charge overnight and be ready at seven", "be off by seven"
                begin = latest
            before = replace(before, clock=before.clock if begin is None else begin)
    return before


def night_told(reading: Reading, before: LastSaid) -> LastSaid:
    """Add from when to when something goes on over midnight and begins soon: a shift from 19:30 to 07:30.

    So do lines in order of which the earliest is in the evening.
    """
    now = reading.now
    if now is not None and before.opened is not None and before.in_order and before.night is None:
        evening = (now + timedelta(seconds=before.opened)).time() >= EVENING
        before = replace(before, night=(before.opened, before.opened + A_DAY / 2) if evening else None)
    stated = (one for one in reading.instructions if one.operation is not None and one.operation.stated)
    for part in (part for one in stated for part in one.requirements):
        # "Night shift till six"
        until = part.constraint is Constraint.BEFORE and part.preposition == "until"
        first, last = 0.0 if until else part.earliest, part.latest
        spans = until or part.constraint is Constraint.BETWEEN
        if now is None or first is None or last is None or not spans:
            continue
        over = (now + timedelta(seconds=last)).date() - (now + timedelta(seconds=first)).date()
        if over.days == 1 and last - first < NIGHT_SECONDS and first <= CLOSE.total_seconds():
            before = replace(before, night=(first, last))
    return before


def said_in(reading: Reading, before: LastSaid) -> LastSaid:
    """Give what was said last behind a reading, by what was said before it."""
    # What goes on overnight is no clue to the hours of the lines behind it.
    firsts = [one for one in _first_times(reading) if not _goes_on(one)]
    clocks = (last_said([one], NOTHING).clock for one in firsts)
    begun = next((clock for clock in clocks if clock is not None), None)
    now = reading.now
    at_night = now is not None and begun is not None and (now + timedelta(seconds=begun)).time() < UP
    # Who writes a list at half past two is up, and so is who is at work then.
    at_night = at_night and now is not None and now.time() >= UP and before.night is None
    said = last_said(_times_in(reading), before)
    counted = any(one.day_of is not None for one in reading.instructions)
    released = [one for one in firsts if one.constraint is not Constraint.BEFORE]
    said = replace(
        said,
        clock=last_said(firsts, before).clock,
        released=last_said(released, replace(before, clock=before.released)).clock,
        begun=begun,
        nightly=before.nightly + at_night,
        ahead=before.ahead if counted else said.day,
    )
    return night_told(reading, said.behind(before))


def _goes_on(one: TimeRequirement) -> bool:
    """Whether a time is as long as a night."""
    length = 0.0 if one.earliest is None or one.latest is None else one.latest - one.earliest
    return one.grain in SUB_DAY and length > FOLLOWING.total_seconds()


def _times_in(reading: Reading) -> Iterator[TimeRequirement]:
    """Give the times of what is asked for or told: what is not understood is no clue to others."""
    wrong = [one.span for one in reading.remarks if one.kind is RemarkKind.NOT_UNDERSTOOD]
    for instruction in reading.instructions:
        if instruction.operation is not None or not any(overlap(instruction.span, span) for span in wrong):
            yield from instruction.requirements


def _first_times(reading: Reading) -> Iterator[TimeRequirement]:
    """Give the same, but of several times of one thing only the first: there the next line goes on."""
    seen: set[Span] = set()
    for one in reading.instructions:
        again = one.operation is not None and one.operation.span in seen
        seen |= set() if one.operation is None else {one.operation.span}
        yield from () if again else (part for part in _times_in(reading) if part in one.requirements)
