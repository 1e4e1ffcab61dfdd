"""A plan as an SVG picture: a lane a skill, ψ as a filled curve, the time it takes as a bar on it."""

import numpy as np

from fuzzytime.interpreter import Interpreted, Plan
from fuzzytime_cli.drawing.chart import sample_times, since_midnight
from fuzzytime_cli.drawing.markup import element, picture, words
from fuzzytime_cli.drawing.svg import path
from fuzzytime_cli.drawing.ticks import round_times
from fuzzytime_cli.formats.clock import Clock

WIDTH, LEFT, RIGHT, LANE, TOP, BOTTOM = 820, 210, 62, 38, 18, 34
STYLE = (
    ".label{font:13px system-ui,sans-serif;fill:#222}.small{font:11px system-ui,sans-serif;fill:#666}"
    ".grid{stroke:#e4e4e4}.wish{fill:#1f5fa8;fill-opacity:.18;stroke:#1f5fa8;stroke-opacity:.5}"
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
        planned = [skill for skill, out in zip(self.skills, plan.schedule.rejected, strict=True) if not out]
        ends = [max(skill.done, skill.end) for skill in planned] or [600.0]
        windows = [interpreted.skill.satisfaction.acceptable(0.02) for interpreted in plan.skills]
        wishes = [window.high for window in windows if not window.empty and window.high < 2 * max(ends)]
        self.end = max(*ends, *wishes, 60.0) * 1.02
        self.bottom = TOP + LANE * len(self.skills)

    def across(self, time: float) -> float:
        """Give the horizontal place of a time."""
        return LEFT + min(1.0, max(0.0, time / self.end)) * (WIDTH - LEFT - RIGHT)

    def document(self) -> str:
        """Give the whole picture."""
        parts = [*self._axis(), *self._busy()]
        for row, position in enumerate(self.plan.schedule.order):
            parts += self._lane(position, TOP + LANE * (row + 1) - 8)
        title = f"Plan from {self.plan.request.now:%Y-%m-%d %H:%M}"
        return picture(WIDTH, self.bottom + BOTTOM, title, STYLE, "".join(parts))

    def _axis(self) -> list[str]:
        clock = Clock(self.plan.request.now, with_seconds=self.end < 300)
        parts = []
        for time in round_times(0.0, self.end, 8, since_midnight(self.plan.request.now)):
            x, label = self.across(time), words(clock.of(time))
            parts.append(element("line", class_="grid", x1=x, y1=TOP, x2=x, y2=self.bottom + 4))
            parts.append(
                element("text", label, class_="small", x=x, y=self.bottom + 18, text_anchor="middle")
            )
        return parts

    def _busy(self) -> list[str]:
        parts = []
        for busy in self.plan.request.busy:
            if busy.start < self.end and busy.end > 0:
                x, end = self.across(busy.start), self.across(busy.end)
                title = element("title", words(busy.what or "busy"))
                width, height = max(1.0, end - x), self.bottom - TOP
                parts.append(element("rect", title, class_="busy", x=x, y=TOP, width=width, height=height))
        return parts

    def _lane(self, position: int, base: float) -> list[str]:
        interpreted, specific = self.plan.skills[position], self.skills[position]
        satisfaction = self.plan.schedule.satisfactions[position]
        rejected = self.plan.schedule.rejected[position]
        kind = "good" if satisfaction >= 0.8 else "fair" if satisfaction >= 0.4 else "poor"
        start, end, done = (self.across(time) for time in (specific.start, specific.end, specific.done))
        said = element("title", words(getattr(interpreted.wish, "text", specific.name)))
        figure = "rejected" if rejected else f"{satisfaction:.2f}"
        parts = [
            element("text", words(_shortened(specific.name, 30)) + said, class_="label", x=8, y=base - 5),
            self._wish(interpreted, base),
            element("text", figure, class_="small", x=WIDTH - 6, y=base - 5, text_anchor="end"),
        ]
        if rejected:
            return parts
        width = max(2.0, end - start)
        parts.append(element("rect", class_=kind, x=start, y=base - 9, width=width, height=9, rx=2))
        if specific.done > specific.end:
            parts.append(element("line", class_="waits", x1=end, y1=base - 4, x2=done, y2=base - 4))
        return parts

    def _wish(self, interpreted: Interpreted, base: float) -> str:
        times = sample_times(interpreted.skill.satisfaction, 0.0, self.end, 240)
        up = base - interpreted.skill.satisfaction(times) * (LANE - 14)
        x = np.array([self.across(time) for time in times.tolist()])
        outline = path(np.concatenate([x[:1], x, x[-1:]]), np.concatenate([[base], up, [base]]))
        return element("path", class_="wish", d=outline + "Z")


def _shortened(text: str, most: int) -> str:
    return text if len(text) <= most else text[: most - 1] + "…"
