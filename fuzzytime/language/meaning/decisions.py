"""What the policy decided where words leave it open: said in a sentence, and as a question."""

from dataclasses import dataclass
from datetime import datetime

from fuzzytime.language.instruction import Question, Remark, RemarkKind, Span
from fuzzytime.language.meaning.expressions import Wall
from fuzzytime.language.meaning.instants import Instants
from fuzzytime.language.meaning.moment import Moment
from fuzzytime.language.meaning.recurrence import CalendarRecurrence
from fuzzytime.requirement import Recurrence


@dataclass(frozen=True, slots=True)
class Deciding:
    """The words of a time and where they stand, and the moment whose policy decides."""

    text: str
    span: Span
    moment: Moment

    def of_repetition(self, walls: tuple[Wall, ...], recurrence: Recurrence) -> tuple[Remark, ...]:
        """Say which half of the day was chosen for clock times that are repeated."""
        remarks = []
        for wall in walls:
            clock = wall.clock
            if clock is None or wall.part is not None or not isinstance(recurrence, CalendarRecurrence):
                continue
            chosen = recurrence.time_of_day(wall, clock)
            others = [seconds for seconds in clock.candidates() if seconds != chosen]
            if others:
                remarks.append(self._taken(_hours(chosen), _hours(others[0])))
        return tuple(dict.fromkeys(remarks))

    def of_instants(
        self, found: Instants, zone: str | None
    ) -> tuple[tuple[Remark, ...], tuple[Question, ...]]:
        """Say what was chosen, and give it as a question where the policy asks."""
        remarks, questions = [], []
        now = self.moment.now
        if zone is not None and now is not None and now.tzinfo is None:
            remarks.append(self._noted(": the zone is not used, as the time now has none"))
        if found.is_point and self.moment.skips(found.start, zone):
            remarks.append(
                self._noted(" does not exist on that day, as clocks change: taken as long after the change")
            )
        if found.choices:
            others = " or ".join(f"{choice:%H:%M}" for choice in found.choices if choice != found.start)
            remarks.append(self._taken(f"{found.start:%H:%M}", others))
            if self.moment.policy.ask:
                chosen = found.choices.index(found.start)
                questions.append(Question(self.span, self._with_zone(found.choices), chosen))
        return tuple(remarks), tuple(questions)

    def _taken(self, chosen: str, others: str) -> Remark:
        return self._noted(f" is taken as {chosen}, not {others}: say am or pm")

    def _noted(self, message: str) -> Remark:
        return Remark(RemarkKind.POLICY, self.span, f"{self.text!r}{message}")

    def _with_zone(self, choices: tuple[datetime, ...]) -> tuple[datetime, ...]:
        zone = None if self.moment.now is None else self.moment.now.tzinfo
        return tuple(choice.replace(tzinfo=zone) for choice in choices)


def _hours(seconds: int) -> str:
    return f"{seconds // 3600:02}:{seconds // 60 % 60:02}"
