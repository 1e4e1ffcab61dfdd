"""A plan as an SVG picture: a lane a skill, ψ as a filled curve, the time it takes as a bar on it."""

import math
from collections.abc import Iterator

import numpy as np

from fuzzytime.interpreter import Interpreted, Plan
from fuzzytime_cli.clock import date_of
from fuzzytime_cli.drawing.chart import sample_times
from fuzzytime_cli.drawing.markup import element, picture, words
from fuzzytime_cli.drawing.svg import path
from fuzzytime_cli.drawing.ticks import ticks
from fuzzytime_cli.formats.series import clock_at, clock_of, folded, shown
from fuzzytime_cli.render import plain, width_of

WIDTH, NAMES, RIGHT, LANE, TOP, BELOW = 820, 202, 76, 38, 26, 12
LEGEND = 16
"""From one line of the legend to the next."""

BARS = {"good": "at work", "fair": "at work, satisfied in part", "poor": "at work, hardly satisfied"}
"""The kinds of bars, by how well the time satisfies."""

CHARACTER = 5.8
"""How wide a small letter is, about, in the units of the picture."""

STYLE = (
    ".label{font:13px system-ui,sans-serif;fill:#222}.small{font:11px system-ui,sans-serif;fill:#666}"
    ".grid{stroke:#e4e4e4}.wish{fill:#1f5fa8;fill-opacity:.22}"
    ".good{fill:#1f5fa8}.poor{fill:#c0392b}.fair{fill:#c98a1b}.busy{fill:#999;fill-opacity:.25}"
    ".waits{stroke:#1f5fa8;stroke-width:3;stroke-dasharray:2 3}"
    "@media(prefers-color-scheme:dark){.label{fill:#eee}.small{fill:#aaa}.grid{stroke:#444}}"
)


def plan_svg(plan: Plan) -> str:
    """Draw the plan as an SVG document."""
    return _Picture(plan).document()


class _Picture:
    """One picture being drawn: the time axis, and a lane a skill in the order of the start times."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        self.skills = plan.schedule.skills
        self.folded = folded(plan)
        self.shown = shown(plan, self.folded)
        planned = [self.skills[place] for place in self.shown if not plan.schedule.rejected[place]]
        ends = [max(skill.done, skill.end) for skill in planned] or [600.0]
        windows = [plan.skills[place].skill.satisfaction.acceptable(0.02) for place in self.shown]
        wishes = [window.high for window in windows if not window.empty and window.high < 2 * max(ends)]
        clock = clock_of(plan)
        self.starts = {
            place: clock_at(plan, place, clock).of(self.skills[place].start) if plan.has_time(place) else ""
            for place in self.shown
        }
        self.left = NAMES + 16 + CHARACTER * max((len(text) for text in self.starts.values()), default=0)
        self.end = max(*ends, *wishes, 60.0) * 1.02
        self.bottom = TOP + LANE * (len(self.shown) + len(plan.waiting))
        self.busy = [busy for busy in plan.request.busy if busy.start < self.end and busy.end > 0]

    def across(self, time: float) -> float:
        """Give the horizontal place of a time."""
        return self.left + min(1.0, max(0.0, time / self.end)) * (WIDTH - self.left - RIGHT)

    def document(self) -> str:
        """Give the whole picture."""
        parts = [*self._head(), *self._axis(), *self._busy()]
        for row, position in enumerate(self.shown):
            parts += self._lane(position, TOP + LANE * (row + 1) - 8)
        for row, waits in enumerate(self.plan.waiting, len(self.shown)):
            parts += self._named(waits, "waits", TOP + LANE * (row + 1) - 8)
        title = f"Plan from {self.plan.request.now:%Y-%m-%d %H:%M}"
        legend, low = self._legend()
        return picture(WIDTH, low + BELOW, title, STYLE, "".join(parts) + legend)

    def _head(self) -> list[str]:
        date = date_of(self.plan.request.now)
        if not self.plan.everything:
            date += ": nothing to plan"
        start = element("text", "start", class_="small", x=self.left - 8, y=TOP - 9, text_anchor="end")
        return [
            element("text", words(date), class_="small", x=8, y=TOP - 9),
            *([start] if any(self.starts.values()) else []),
            element("text", "satisfied", class_="small", x=WIDTH - 6, y=TOP - 9, text_anchor="end"),
        ]

    def _legend(self) -> tuple[str, float]:
        """Say what the shapes mean that the picture has, and how far down that reaches."""
        parts, x, y = [], 8.0, self.bottom + 44
        for kind, text in self._shapes():
            width = 26 + CHARACTER * len(text)
            if x + width > WIDTH:
                x, y = 8.0, y + LEGEND
            if kind == "waits":
                parts.append(element("line", class_=kind, x1=x, y1=y - 4, x2=x + 20, y2=y - 4))
            else:
                parts.append(element("rect", class_=kind, x=x, y=y - 9, width=20, height=9, rx=2))
            parts.append(element("text", text, class_="small", x=x + 26, y=y))
            x += width + 16
        return element("g", "".join(parts), class_="legend"), y

    def _shapes(self) -> Iterator[tuple[str, str]]:
        """Give the kinds of shapes that the picture has, with what they mean."""
        planned = [place for place in self.shown if not self.plan.schedule.rejected[place]]
        kinds = {self._kind(place) for place in planned}
        yield "wish", "how well a start there would satisfy"
        yield from ((kind, text) for kind, text in BARS.items() if kind in kinds)
        if any(self.skills[place].done > self.skills[place].worked_until for place in planned):
            yield "waits", "goes on by itself"
        if self.busy:
            yield "busy", "time that is taken"

    def _kind(self, position: int) -> str:
        """Give the kind of bar that shows how well a skill's time satisfies."""
        satisfaction = self.plan.schedule.satisfactions[position]
        return "good" if satisfaction >= 0.8 else "fair" if satisfaction >= 0.4 else "poor"

    def _axis(self) -> list[str]:
        parts = []
        for tick in ticks(0.0, self.end, 8, self.plan.request.now):
            x, label = self.across(tick.time), words(tick.label)
            parts.append(element("line", class_="grid", x1=x, y1=TOP, x2=x, y2=self.bottom + 4))
            parts.append(
                element("text", label, class_="small", x=x, y=self.bottom + 18, text_anchor="middle")
            )
        return parts

    def _busy(self) -> list[str]:
        parts: list[str] = []
        named = -math.inf  # where the last name ends: of times that overlap, names would too
        for busy in sorted(self.busy, key=lambda taken: taken.start):
            x, end = self.across(busy.start), self.across(busy.end)
            what = plain(busy.what or "busy")
            width, height = max(1.0, end - x), self.bottom - TOP
            title = element("title", words(what))
            parts.append(element("rect", title, class_="busy", x=x, y=TOP, width=width, height=height))
            middle, half = (x + end) / 2, CHARACTER * width_of(what) / 2
            if 2 * half <= width and named <= middle - half:
                named = middle + half + CHARACTER
                name = element("text", words(what), class_="small", x=middle, y=TOP - 9, text_anchor="middle")
                parts.append(name)
        return parts

    def _lane(self, position: int, base: float) -> list[str]:
        interpreted, specific = self.plan.skills[position], self.skills[position]
        satisfaction = self.plan.schedule.satisfactions[position]
        rejected = self.plan.schedule.rejected[position]
        start, end, done = (
            self.across(time) for time in (specific.start, specific.worked_until, specific.done)
        )
        figure = "rejected" if rejected else f"{satisfaction:.2f}"
        if position in self.folded:
            figure = f"+ {len(self.folded[position])}: {figure}"
        if self.plan.schedule.task.agents > 1 and not rejected and not interpreted.skill.happens:
            figure = f"by {specific.agent}: {figure}"
        parts = [
            *self._named(interpreted, figure, base),
            self._wish(interpreted, base),
            element(
                "text", self.starts[position], class_="small", x=self.left - 8, y=base - 5, text_anchor="end"
            ),
        ]
        if rejected:
            return parts
        width = max(2.0, end - start)
        parts.append(
            element("rect", class_=self._kind(position), x=start, y=base - 9, width=width, height=9, rx=2)
        )
        if specific.done > specific.worked_until:
            parts.append(element("line", class_="waits", x1=end, y1=base - 4, x2=done, y2=base - 4))
        return parts

    def _named(self, interpreted: Interpreted, figure: str, base: float) -> list[str]:
        """Name what a lane is of, and say how well its time satisfies."""
        said = element("title", words(interpreted.words or interpreted.skill.name))
        name = words(_shortened(plain(interpreted.skill.name), NAMES - 8)) + said
        return [
            element("text", name, class_="label", x=8, y=base - 5),
            element("line", class_="grid", x1=self.left, y1=base, x2=WIDTH - RIGHT, y2=base),
            element("text", figure, class_="small", x=WIDTH - 6, y=base - 5, text_anchor="end"),
        ]

    def _wish(self, interpreted: Interpreted, base: float) -> str:
        times = sample_times(interpreted.skill.satisfaction, 0.0, self.end, 240)
        up = base - interpreted.skill.satisfaction(times) * (LANE - 14)
        x = np.array([self.across(time) for time in times.tolist()])
        outline = path(np.concatenate([x[:1], x, x[-1:]]), np.concatenate([[base], up, [base]]))
        return element("path", class_="wish", d=outline + "Z")


def _shortened(text: str, width: float) -> str:
    """Cut harmless text to about a width in a label's type; what is cut ends in an ellipsis."""
    ends = np.cumsum([_width(character) for character in text])
    if not text or ends[-1] <= width:
        return text
    return text[: int(np.searchsorted(ends, width - _width("…"), "right"))].rstrip() + "…"


def _width(character: str) -> float:
    """Give about how wide a character of a label is."""
    if character in "mwMW%@…":
        return 12.0
    return 13.0 if width_of(character) > 1 else 9.0 if character.isupper() else 7.2
