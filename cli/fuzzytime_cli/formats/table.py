"""The plan as a person sees it: a table, a timeline, what is proved, and what each loss is due to."""

from rich.text import Text

from fuzzytime.interpreter import Interpreted, Plan, Problem, ProblemKind
from fuzzytime.scheduling import Status, explain
from fuzzytime.times import format_duration
from fuzzytime_cli.formats.clock import Clock
from fuzzytime_cli.formats.reasons import reason_of
from fuzzytime_cli.formats.timeline import Window, lane, taken
from fuzzytime_cli.render import fitted, plain, width_of

_EIGHTHS = " ▏▎▍▌▋▊▉█"
_BAR = 10


def bar(satisfaction: float, width: int = _BAR, *, unicode: bool = True) -> str:
    """Draw a satisfaction as a bar of ``width`` columns.

    >>> bar(0.5, 4), bar(1.0, 2), bar(0.5, 4, unicode=False)
    ('██  ', '██', '##  ')
    """
    if not unicode:
        return fitted("#" * round(satisfaction * width), width)
    full, part = divmod(round(satisfaction * width * 8), 8)
    return fitted("█" * full + (_EIGHTHS[part] if part else ""), width)


def style_of(satisfaction: float, *, rejected: bool) -> str:
    """Give the colour that goes with a satisfaction, for those who see colour."""
    if rejected:
        return "red"
    return "green" if satisfaction >= 0.8 else "yellow" if satisfaction >= 0.4 else "red"


class PlanView:
    """One plan laid out for a width; `lines` gives it whole."""

    def __init__(self, plan: Plan, width: int, *, unicode: bool = True) -> None:
        self.plan, self.width, self.unicode = plan, width, unicode
        self.schedule = plan.schedule
        times = [time for skill in self.schedule.skills for time in (skill.start, skill.end)]
        self.clock = Clock.for_times(plan.request.now, times)
        self.labels = {position: plain(skill.identifier) for position, skill in enumerate(plan.skills)}
        self.label_width = min(12, max((width_of(label) for label in self.labels.values()), default=2))

    def lines(self) -> list[Text]:
        """Give the whole view, a line each."""
        if not self.plan.skills:
            return [Text("Nothing to plan."), *self._notes()]
        return [
            *self._table(),
            Text(),
            *self._timeline(),
            Text(),
            *self._summary(),
            *self._losses(),
            *self._notes(),
        ]

    # -- the table ------------------------------------------------------------------------------------------

    def _table(self) -> list[Text]:
        time_width = max(
            width_of(self.clock.of(time)) for s in self.schedule.skills for time in (s.start, s.end)
        )
        time_width = max(5, time_width)
        several = self.plan.request.agents > 1
        fixed = self.label_width + 2 * (time_width + 1) + (3 if several else 0) + 6
        with_bar = self.width >= fixed + 26 + _BAR
        rest = self.width - fixed - (_BAR + 1 if with_bar else 0)
        asked_width = max((width_of(plain(self._asked(skill))) for skill in self.plan.skills), default=0)
        asked_width = min(asked_width, rest * 2 // 5) if rest >= 30 else 0
        name_width = rest - asked_width - (1 if asked_width else 0)
        heading = [fitted("", self.label_width), fitted("start", time_width), fitted("end", time_width)]
        heading += ["by"] if several else []
        heading += (
            [fitted("what", name_width)]
            + ([fitted("", _BAR)] if with_bar else [])
            + ["  ψ ", "asked"][: 1 + bool(asked_width)]
        )
        lines = [Text(" ".join(heading).rstrip(), style="bold")]
        for position in self.schedule.order:
            lines.append(self._row(position, time_width, name_width, asked_width, with_bar=with_bar))
        return lines

    def _row(
        self, position: int, time_width: int, name_width: int, asked_width: int, *, with_bar: bool
    ) -> Text:
        specific, satisfaction = self.schedule.skills[position], self.schedule.satisfactions[position]
        rejected = self.schedule.rejected[position]
        style = style_of(satisfaction, rejected=rejected)
        row = Text(fitted(self.labels[position], self.label_width), style="dim")
        row.append(" " + fitted(self.clock.of(specific.start), time_width), "bold")
        row.append(" " + fitted(self.clock.of(specific.end), time_width), "")
        if self.plan.request.agents > 1:
            row.append(f" {specific.agent:>2}", "")
        row.append(" " + fitted(plain(specific.name), name_width), "")
        if with_bar:
            shown = "rejected" if rejected else bar(satisfaction, unicode=self.unicode)
            row.append(" " + fitted(shown, _BAR), style)
        row.append(f" {satisfaction:4.2f}", style)
        if asked_width:
            row.append(" " + fitted(plain(self._asked(self.plan.skills[position])), asked_width), "dim")
        row.rstrip()
        return row

    def _asked(self, interpreted: Interpreted) -> str:
        if interpreted.requirements:
            return ", ".join(requirement.text for requirement in interpreted.requirements)
        return "any time" if interpreted.instruction is not None else "as given"

    # -- the timeline ---------------------------------------------------------------------------------------

    def _timeline(self) -> list[Text]:
        columns = self.width - self.label_width - 2
        skills = self.schedule.skills
        end = max(max(skill.done, skill.end) for skill in skills)
        for interpreted in self.plan.skills:
            wish = interpreted.skill.satisfaction.acceptable(0.02)
            if not wish.empty and wish.high < 2 * end:
                end = max(end, wish.high)
        window = Window(0.0, max(end * 1.02, 60.0), columns)
        lines = [self._axis(window)]
        for position in self.schedule.order:
            specific = skills[position]
            cells = lane(
                self.plan.skills[position].skill.satisfaction,
                specific.start,
                specific.end,
                specific.done,
                window,
            )
            style = style_of(self.schedule.satisfactions[position], rejected=self.schedule.rejected[position])
            lines.append(self._lane(self.labels[position], cells, style))
        spans = [(busy.start, busy.end) for busy in self.plan.request.busy]
        if spans:
            lines.append(self._lane("busy", taken(spans, window), "dim"))
        legend = "█ at work  " + ("─ goes on by itself  " if any(s.done > s.end for s in skills) else "")
        lines.append(
            Text(f"{' ' * self.label_width} {legend}░▒▓ how well a start there would satisfy", style="dim")
        )
        return lines

    def _axis(self, window: Window) -> Text:
        cells = [" "] * window.columns
        clock = Clock(self.plan.request.now, with_seconds=window.step * 10 < 60)
        for column, time in window.ticks(room=10):
            label = "╵" + clock.of(time)
            if column + width_of(label) <= window.columns:
                cells[column : column + len(label)] = label
        return Text(" " * self.label_width + " " + "".join(cells).rstrip(), style="dim")

    def _lane(self, label: str, cells: list[str], style: str) -> Text:
        line = Text(fitted(label, self.label_width) + " ", style="dim")
        for cell in cells:
            line.append(cell, style if cell == "█" else "dim")
        line.rstrip()
        return line

    # -- what is proved and why -----------------------------------------------------------------------------

    def _summary(self) -> list[Text]:
        schedule, certificate = self.schedule, self.schedule.certificate
        line = Text("Satisfaction ", style="bold")
        line.append(f"{schedule.satisfaction:.3g}", style_of(schedule.geometric_mean, rejected=False))
        if len(self.plan.skills) > 1:
            line.append(f" in all, {schedule.geometric_mean:.2f} on average", "")
        match certificate.status:
            case Status.OPTIMAL:
                proof = "no schedule satisfies better: proved"
            case Status.BOUNDED:
                proof = f"the average is within {certificate.gap:.2%} of the best possible: proved"
            case Status.HEURISTIC:
                proof = "a good schedule, without proof"
            case Status.INFEASIBLE:
                names = ", ".join(self.labels[position] for position in schedule.clash)
                proof = (
                    f"no schedule satisfies everyone: {names} clash"
                    if names
                    else "no schedule satisfies everyone"
                )
        line.append(f" ({proof}; {certificate.method}, {certificate.seconds:.2f} s)", "dim")
        return [line]

    def _losses(self) -> list[Text]:
        lines = []
        for why in explain(self.schedule):
            sentence = reason_of(why, self.plan, self.clock)
            if sentence:
                label = fitted(self.labels[why.position], self.label_width)
                lines.append(Text(f"{label} ", style="dim").append(sentence, ""))
        return lines

    def _notes(self) -> list[Text]:
        notes = [problem for problem in self.plan.problems if problem.kind is ProblemKind.NOTE]
        lines = [Text(f"note: {_where(note)}{plain(note.message)}", style="dim") for note in notes]
        assumed = [
            f"{self.labels[position]} {format_duration(interpreted.skill.duration)}"
            for position, interpreted in enumerate(self.plan.skills)
            if interpreted.duration.assumed
        ]
        if assumed:
            lines.append(Text("assumed durations: " + ", ".join(assumed), style="dim"))
        return lines


def _where(problem: Problem) -> str:
    return f"{plain(problem.identifier)}: " if problem.identifier else ""
