"""Events as a person reads them on a terminal."""

import shlex
from dataclasses import dataclass, field
from datetime import datetime
from typing import Protocol, TextIO

from rich.text import Text

from fuzzytime.times import format_duration
from fuzzytime_cli.clock import Clock
from fuzzytime_cli.faults import report, underlined
from fuzzytime_cli.formats.degrees import bar, style_of
from fuzzytime_cli.formats.table import PlanView
from fuzzytime_cli.live import events as told
from fuzzytime_cli.live.events import Event
from fuzzytime_cli.render import Screen, plain

_NAME = 9


class Display(Protocol):
    """Where events go."""

    def tell(self, event: Event) -> None:
        """Show or write an event."""
        ...


@dataclass(slots=True)
class EventLines:
    """Events as JSON, one a line, each flushed at once."""

    stream: TextIO
    origin: datetime

    def tell(self, event: Event) -> None:
        """Write an event; a problem is said on standard error as well, where a person may see it."""
        import json

        if isinstance(event, told.Trouble):
            report(f"{event.place or 'fuzzytime'}: {event.message}")
        self.stream.write(json.dumps(told.document_of(event, self.origin), allow_nan=False) + "\n")
        self.stream.flush()


@dataclass(slots=True)
class EventScreen:
    """Events as lines for people: the plan first, then what happens."""

    screen: Screen
    origin: datetime
    planned: bool = field(default=False, init=False)

    def tell(self, event: Event) -> None:
        """Show an event; what only a program needs is left out."""
        lines = self._plan(event) if isinstance(event, told.Planned) else self._lines(event)
        if lines:
            self.screen.write(*lines)
            self.screen.stream.flush()

    def _plan(self, event: told.Planned) -> list[Text]:
        """Show the first plan whole; of later ones why they were made."""
        if self.planned:
            return [self._line(event.at, "planned", plain(f"because {', '.join(event.because)}"), "dim")]
        self.planned = True
        view = PlanView(event.plan, self.screen.width, unicode=self.screen.unicode)
        return [*view.lines(), Text()]

    def _line(self, at: float, kind: str, words: str, style: str = "") -> Text:
        return Text(f"{self._clock(at)}  {kind:<{_NAME}} {words}", style=style)

    def _clock(self, at: float | None) -> str:
        return "no time" if at is None else Clock(self.origin, with_seconds=True).of(at)

    def _lines(self, event: Event) -> list[Text]:
        at, kind = event.at, event.type
        match event:
            case told.Start():
                line = self._line(at, kind, f"{_who(event)}, until {self._clock(event.end_s)} ", "bold green")
                drawn = bar(event.satisfaction, unicode=self.screen.unicode).rstrip()
                line.append(f" {drawn} {event.satisfaction:.2f}", style_of(event.satisfaction))
                ran = [] if event.command is None else [plain(shlex.join(event.command))]
                return [line, *(self._line(at, "command", words, "dim") for words in ran)]
            case told.Happens(done_s=done):
                until = f", until {self._clock(done)}" if done > at else ""
                return [self._line(at, kind, f"{_who(event)}{until}", "bold")]
            case told.End() | told.Done():
                return [self._line(at, kind, _who(event), "green" if kind == "done" else "")]
            case told.Moved(before_s=before, after_s=after):
                moved = f"{_who(event)}: {self._clock(before)} → {self._clock(after)}"
                return [self._line(at, kind, moved, "yellow")]
            case told.Late(expected_s=expected):
                late = f"{_who(event)}, now expected until {self._clock(expected)}"
                return [self._line(at, kind, late, "yellow")]
            case told.Missed(planned_s=planned):
                missed = f"{_who(event)}: it was to start at {self._clock(planned)}"
                return [self._line(at, kind, missed, "red")]
            case told.Rejected(reason=reason) | told.Failed(reason=reason) | told.Dropped(reason=reason):
                why = f": {plain(reason)}" if reason else ""
                return [self._line(at, kind, f"{_who(event)}{why}", "red")]
            case told.Waits(reason=reason):
                return [self._line(at, kind, f"{_who(event)}: {plain(reason)}")]
            case _:
                return self._news(event)

    def _news(self, event: Event) -> list[Text]:
        at, kind = event.at, event.type
        match event:
            case told.ContextRead(matters=True):
                value = "" if event.value is None else f" {event.value:g} {event.unit or ''}"
                return [self._line(at, kind, plain(f"{event.signal}{value}".rstrip()), "dim")]
            case told.Silent():
                age = format_duration(event.max_age_s)
                return [self._line(at, kind, f"{plain(event.signal)} was not read for {age}", "red")]
            case told.Instructed(ids=ids, text=text):
                return [self._line(at, kind, plain(f"{text} ({', '.join(ids)})"), "bold")]
            case told.Wrote(id=identifier, text=text):
                return [self._line(at, kind, f"{plain(identifier)}: {plain(text)}", "dim")]
            case told.Trouble():
                place = f"{plain(event.place)}: " if event.place else ""
                lines = [self._line(at, kind, f"{place}{plain(event.message)}", "red")]
                if event.text is not None and event.span is not None:
                    lines += [Text(line) for line in underlined(event.text, event.span).split("\n")]
                return lines
            case told.Stopped():
                running = plain(", ".join(event.running)) or "nothing"
                waiting = plain(", ".join(event.waiting)) or "nothing"
                return [self._line(at, kind, f"running: {running}; not started: {waiting}", "yellow")]
            case told.Finished():
                return self._end(event)
            case _:
                return []

    def _end(self, event: told.Finished) -> list[Text]:
        parts = [f"{len(event.done)} done"]
        for name in ("failed", "dropped", "rejected", "unfinished"):
            identifiers = getattr(event, name)
            if identifiers:
                parts.append(f"{name}: {plain(', '.join(identifiers))}")
        mean, least = event.satisfaction["geometric_mean"], event.satisfaction["least"]
        if event.done:
            parts.append(f"satisfaction {mean:.2f}, least {least:.2f}")
        return [self._line(event.at, event.type, "; ".join(parts), "bold")]


def _who(event: Event) -> str:
    return plain(f"{getattr(event, 'name', '')} ({getattr(event, 'id', '')})")
