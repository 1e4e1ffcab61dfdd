"""The plan as a person sees it: a table, a timeline, what is proved, and what each loss is due to."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

from rich.text import Text

from fuzzytime.interpreter import Plan
from fuzzytime.requirement import asked_words
from fuzzytime.scheduling import Status
from fuzzytime_cli.drawing.ticks import axis
from fuzzytime_cli.formats.asked import moved_words
from fuzzytime_cli.formats.degrees import BAR, bar, style_of, summary
from fuzzytime_cli.formats.notes import note_lines
from fuzzytime_cli.formats.reasons import MOST_SECONDS, loss_lines, waits_line
from fuzzytime_cli.formats.series import clock_at, clock_of, folded, going_on, shown, waiting
from fuzzytime_cli.formats.timeline import TAKEN, Window, lane, legend, shades, taken
from fuzzytime_cli.render import fitted, plain, width_of, wrapped_text

MOST_ROWS = 14
"""Rows of a table that is shown whole after each change."""

NEXT_ROWS = 3
"""What starts next, of a longer one."""


FAR = 0.5
"""Share of the time until all is over from which on the timeline does not begin now, but with the work."""

HOURS_AHEAD = 6 * 3600.0
"""Seconds that the work must lie ahead for that."""

BEFORE = 0.1
"""Share of what the timeline then shows that it begins before the work."""


@dataclass(frozen=True, slots=True)
class _Columns:
    """Widths of the table's columns; a column that does not fit has none."""

    time: int
    end: int
    agent: int
    name: int
    bar: int
    asked: int


class PlanView:
    """One plan laid out for a width; whom skills lost to is looked for within ``seconds``."""

    def __init__(
        self, plan: Plan, width: int, *, unicode: bool = True, seconds: float = MOST_SECONDS
    ) -> None:
        self.seconds = seconds
        self.plan, self.width, self.unicode = plan, width, unicode
        self.schedule = plan.schedule
        self.folded = folded(plan)
        self.shown = shown(plan, self.folded)
        self.going_on = going_on(plan)
        self.clock = clock_of(plan)
        self.listed = [*self.shown, *waiting(plan)]
        self.labels = [plain(interpreted.identifier) for interpreted in plan.everything]
        labels = [self.labels[position] for position in self.listed]
        labels += ["busy"] if plan.request.busy else []
        self.label_width = min(12, max(map(width_of, labels), default=2))

    def lines(self) -> list[Text]:
        """Give the whole view, a line each."""
        if not self.plan.everything:
            return [Text("Nothing to plan."), *note_lines(self.plan, self.labels)]
        timeline = [Text(), *self._timeline()] if self.plan.skills else []
        return [
            *self._table(self.listed),
            *timeline,
            Text(),
            *wrapped_text(summary(self.plan), self.width),
            *(
                line
                for loss in (*self._losses(), *self._waiting())
                for line in wrapped_text(loss, self.width, self.label_width + 1)
            ),
            *(line for note in note_lines(self.plan, self.labels) for line in wrapped_text(note, self.width)),
        ]

    def brief(self, news: Collection[int], lengths: Collection[int]) -> list[Text]:
        """Give the table alone, with what is lost by what is news, and the ``lengths`` that are assumed.

        Of a long table only what is news is shown, and what starts next.
        """
        if not self.plan.everything:
            return [Text("Nothing is planned."), *note_lines(self.plan, self.labels, lengths)]
        rows = self.listed
        if len(rows) > MOST_ROWS:
            rows = [place for n, place in enumerate(rows) if n < NEXT_ROWS or place in news]
        lines = self._table(rows)
        if len(rows) < len(self.listed):
            lines.append(Text(f"… and {len(self.listed) - len(rows)} more (:list shows all)", style="dim"))
        proved = self.schedule.certificate.status is Status.OPTIMAL
        below = [] if proved else [(summary(self.plan), 0)]
        below += [(loss, self.label_width + 1) for loss in self._losses(news)]
        below += [(line, self.label_width + 1) for line in self._waiting(news)]
        below += [(note, 0) for note in note_lines(self.plan, self.labels, lengths)]
        return lines + [part for line, indent in below for part in wrapped_text(line, self.width, indent)]

    def sentences(self) -> list[str]:
        """Give what is proved, and why each loss, as plain sentences."""
        if not self.plan.everything:
            return ["Nothing to plan."]
        said = (summary(self.plan), *self._losses(), *self._waiting(), *note_lines(self.plan, self.labels))
        names = self.plan.skills
        goes_on = [
            f"{self.labels[place]} {plain(names[place].skill.name)}: and so on, {plain(words)}"
            for place, words in self.going_on.items()
        ]
        return [*(line.plain for line in said), *goes_on]

    def asked(self, position: int) -> str:
        """Give the words about time of a skill."""
        interpreted = self.plan.everything[position]
        if interpreted.requirements:
            words = asked_words(interpreted.requirements)
        elif interpreted.in_order:
            words = "in order"
        else:
            words = "any time" if interpreted.instruction is not None else "as given"
        return ", ".join(filter(None, (moved_words(interpreted.wish.moved), words)))

    def times(self, position: int) -> tuple[str, str]:
        """Give when a skill starts and is done, by the clock; one that has no time does neither."""
        if not self.plan.has_time(position):
            return "–", "–"
        specific, clock = self.schedule.skills[position], clock_at(self.plan, position, self.clock)
        return clock.of(specific.start), clock.end_of(specific.start, specific.done)

    def doer(self, position: int) -> str:
        """Give the agent that does a skill; what has no time, or happens by itself, is nobody's."""
        somebody = self.plan.has_time(position) and not self.plan.skills[position].skill.happens
        return str(self.schedule.skills[position].agent) if somebody else "–"

    def degree(self, position: int) -> tuple[str, str]:
        """Give how well a skill's time satisfies, as a word and a number, of which the second may be none."""
        if position >= len(self.plan.skills):
            return "waits", ""
        satisfaction = self.schedule.satisfactions[position]
        if self.schedule.rejected[position]:
            return "rejected", f"{satisfaction:.2f}"
        return bar(satisfaction, unicode=self.unicode), f"{satisfaction:.2f}"

    # -- the table ------------------------------------------------------------------------------------------

    def _columns(self, positions: Sequence[int]) -> _Columns:
        """Share the width: bar and asked words give way first, then the end, then the name is cut."""
        further = [self.folded[position][0] for position in positions if position in self.folded]
        times = map(self.times, (*positions, *further))
        time, longest_end = (max(5, *map(width_of, moments)) for moments in zip(*times, strict=True))
        agent = 2 if self.plan.request.agents > 1 else 0
        fixed = self.label_width + (time + 1) + (agent + 1 if agent else 0) + len(" 0.00")
        end = longest_end if self.width >= fixed + longest_end + 16 else 0
        fixed += end + 1 if end else 0
        bar_width = BAR if self.width >= fixed + 26 + BAR else 0
        rest = self.width - fixed - (bar_width + 1 if bar_width else 0) - 1
        longest_name = max(width_of(plain(self.plan.everything[i].skill.name)) for i in positions)
        longest_asked = max(width_of(plain(self.asked(i))) for i in positions)
        asked = min(longest_asked, max(rest * 2 // 5, rest - longest_name - 1)) if rest >= 30 else 0
        name = min(longest_name, rest - (asked + 1 if asked else 0))
        return _Columns(time, end, agent, max(4, name), bar_width, asked)

    def _table(self, positions: Sequence[int]) -> list[Text]:
        columns = self._columns(positions)
        cells = [fitted("", self.label_width), fitted("start", columns.time)]
        cells += [fitted("end", columns.end)] if columns.end else []
        cells += ["by"] if columns.agent else []
        cells += [fitted("what", columns.name)]
        cells += [fitted("satisfied" if columns.bar else "", columns.bar + 5 if columns.bar else 4)]
        cells += ["asked"] if columns.asked else []
        heading = Text(" ".join(cells).rstrip(), style="bold")
        rows = [heading]
        for position in positions:
            rows.append(self._row(position, columns))
            if position in self.folded:
                rows.append(self._further(self.folded[position], columns))
            last = self.folded.get(position, (position,))[-1]
            if last in self.going_on:
                rows.append(self._so_on(self.going_on[last], columns))
        return rows

    def _further(self, positions: tuple[int, ...], columns: _Columns) -> Text:
        """Give one row for further occurrences of a repetition: how many, and from when to when."""
        first, last = (self.schedule.skills[place] for place in (positions[0], positions[-1]))
        begins, ends = self.clock.of(first.start), self.clock.end_of(first.start, last.done)
        return self._more(begins, f"and {len(positions)} times more, until {ends}", columns)

    def _so_on(self, words: str, columns: _Columns) -> Text:
        """Give the row behind the last occurrence that is planned, of what goes on: "every two days"."""
        return self._more("", f"and so on, {plain(words)}", columns)

    def _more(self, begins: str, words: str, columns: _Columns) -> Text:
        row = fitted("…", self.label_width) + " " + fitted(begins, columns.time)
        row += " " * (columns.end + 1 if columns.end else 0) + " " * (3 if columns.agent else 0)
        return Text(f"{row} {fitted(words, self.width - width_of(row) - 1)}".rstrip(), style="dim")

    def _row(self, position: int, columns: _Columns) -> Text:
        name, style = self.plan.everything[position].skill.name, self._style(position)
        start, end = self.times(position)
        row = Text(fitted(self.labels[position], self.label_width), style="dim")
        row.append(" " + fitted(start, columns.time), "bold")
        if columns.end:
            row.append(" " + fitted(end, columns.end), "not dim")
        if columns.agent:
            row.append(f" {self.doer(position):>2}", "not dim")
        row.append(" " + fitted(plain(name), columns.name), "not dim")
        degree, figure = self.degree(position)
        if columns.bar:
            row.append(" " + fitted(degree, BAR), style)
        row.append(f" {figure or ('' if columns.bar else '–'):>4}", style)
        if columns.asked:
            row.append(" " + fitted(plain(self.asked(position)), columns.asked), "dim")
        row.rstrip()
        return row

    def _style(self, position: int) -> str:
        """Give the colour of a skill that is planned; what waits is no fault of anybody's."""
        if position >= len(self.plan.skills):
            return "dim"
        return style_of(self.schedule.satisfactions[position], rejected=self.schedule.rejected[position])

    # -- the timeline ---------------------------------------------------------------------------------------

    def _timeline(self) -> Iterator[Text]:
        end = self._end()
        window = Window(self._begin(end), end, self.width - self.label_width - 2)
        yield self._axis(window)
        lanes = [
            (self.labels[position], self._cells(position, window), self._style(position))
            for position in self.shown
        ]
        taken_by = [(busy.start, busy.end) for busy in self.plan.request.busy]
        spans = [(begin, over) for begin, over in taken_by if begin < window.end and over > window.start]
        if spans:
            lanes.append((fitted("busy", self.label_width), taken(spans, window), "dim"))
        for label, cells, style in lanes:
            yield self._lane(label, cells, style)
        drawn = {cell for _, cells, _ in lanes for cell in cells}
        indent = self.label_width + 1
        if told := legend(drawn):
            yield from wrapped_text(Text(f"{' ' * indent}{told}", style="dim"), self.width, indent)

    def _cells(self, position: int, window: Window) -> list[str]:
        """Give the lane of a skill; of one that is rejected only when it would have satisfied."""
        function, planned = self.plan.skills[position].skill.satisfaction, self.schedule.skills[position]
        if self.schedule.rejected[position]:
            return shades(function, window)
        return lane(function, planned.start, planned.worked_until, planned.done, window)

    def _end(self) -> float:
        """Give where the timeline ends: behind all work, and behind wishes that end not much later."""
        planned = [position for position in self.shown if not self.schedule.rejected[position]]
        skills = self.schedule.skills
        last = max((max(skills[place].done, skills[place].end) for place in planned), default=600.0)
        wishes = [self.plan.skills[place].skill.satisfaction.acceptable(0.02).high for place in self.shown]
        return max(60.0, 1.02 * max([last, *(wish for wish in wishes if wish < 2 * last)]))

    def _begin(self, end: float) -> float:
        """Give where the timeline begins: now, or a little before all work that is far ahead."""
        starts = (self.schedule.start_times[place] for place in self.shown if self.plan.has_time(place))
        first = min(starts, default=0.0)
        return first - BEFORE * (end - first) if first > max(HOURS_AHEAD, FAR * end) else 0.0

    def _axis(self, window: Window) -> Text:
        span, now = (window.start, window.end), self.plan.request.now
        line = axis(window.columns, window.columns // 10, span, now, window.column)
        return Text(f"{' ' * self.label_width} {line}", style="dim")

    def _lane(self, label: str, cells: list[str], style: str) -> Text:
        line = Text(fitted(label, self.label_width) + " ", style="dim")
        for cell in cells:
            line.append(cell, style if cell == TAKEN else "dim")
        line.rstrip()
        return line

    # -- what is lost, and why ------------------------------------------------------------------------------

    def _waiting(self, among: Collection[int] | None = None) -> Iterator[Text]:
        """Say what each skill without a time waits for."""
        for position in waiting(self.plan):
            if among is not None and position not in among:
                continue
            label = fitted(self.labels[position], self.label_width)
            yield Text(f"{label} ", style="dim").append(waits_line(self.plan, position), "not dim")

    def _losses(self, among: Collection[int] | None = None) -> Iterator[Text]:
        for position, sentence in loss_lines(self.plan, self.seconds):
            if among is not None and position not in among:
                continue
            if position is None:
                yield Text(sentence, style="dim")
                continue
            label = fitted(self.labels[position], self.label_width)
            yield Text(f"{label} ", style="dim").append(sentence, "not dim")
