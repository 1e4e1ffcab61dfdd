"""One turn of the conversation: a line typed, an answer, and the schedule drawn again where it changed."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from datetime import datetime

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import Plan, Problem, ProblemKind
from fuzzytime.language import Question
from fuzzytime_cli.faults import underlined
from fuzzytime_cli.formats.table import PlanView
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.commands import Reply, Scene, command_of, move_lines
from fuzzytime_cli.repl.conversation import Conversation, answered
from fuzzytime_cli.session import Started

Line = Text | str
_UNREAD = {ProblemKind.NOT_UNDERSTOOD, ProblemKind.UNREADABLE, ProblemKind.NOTHING_TO_DO}
Ask = Callable[[str], str]
"""Asks a person a question and gives the answer; empty where nobody answers."""


@dataclass(slots=True)
class Turns:
    """A conversation going on: the plan on the screen, and what leads to the next."""

    conversation: Conversation
    width: int
    unicode: bool = True
    plan: Plan | None = None
    version: int = -1

    def opened(self, now: datetime) -> list[Line]:
        """Greet: the schedule of a session that goes on, or what to do in a new one."""
        entries = self.conversation.state.entries
        if not entries:
            self._refresh(now)
            return [
                "Say what you want done and when, for example: flip the pancakes in about two minutes.",
                ":help",
            ]
        lines: list[Line] = [f"Session {plain(self.conversation.name)!r} goes on."]
        return [*lines, *self._redrawn(now)]

    def take(self, line: str, now: datetime, ask: Ask | None = None) -> Reply:
        """Answer a line; every error of what was typed is an answer too."""
        words = line.strip()
        if not words:
            return Reply()
        try:
            if words[0] in ":/":
                command, rest = command_of(words)
                reply = command.run(self._scene(now), rest)
            else:
                reply = self._instruction(words, now, ask)
            if reply.changed:
                reply = replace(reply, lines=(*reply.lines, *self._redrawn(now)))
        except FuzzytimeError as error:
            return Reply((Text(plain(str(error)), style="red"),))
        except OSError as error:
            return Reply((Text(plain(f"{error.filename or ''}: {error.strerror or error}"), style="red"),))
        return reply

    def tick(self, now: datetime) -> list[Line]:
        """Say what has started by now; plan anew where another terminal took a step."""
        lines: list[Line] = []
        if self.plan is None or self.conversation.store.version(self.conversation.name) != self.version:
            return [*self._redrawn(now)] if self.plan is not None else lines
        for started in self.conversation.note_started(self.plan, now):
            lines.append(start_line(started))
        return lines

    # -- inside ---------------------------------------------------------------------------------------------

    def _scene(self, now: datetime) -> Scene:
        plan = self.plan if self.plan is not None else self._refresh(now)
        return Scene(self.conversation, plan, now, self.width, self.unicode)

    def _refresh(self, now: datetime) -> Plan:
        """Plan from a moment on: what has started by then stays."""
        self.version = self.conversation.store.version(self.conversation.name)
        if self.plan is not None:
            self.conversation.note_started(self.plan, now)
        self.plan = self.conversation.plan(now)
        return self.plan

    def _redrawn(self, now: datetime) -> list[Line]:
        before = self.plan
        made = self._refresh(now)
        started = {one.identifier for one in self.conversation.store.started(self.conversation.name)}
        lines: list[Line] = [Text(line, style="yellow") for line in move_lines(before, made, started)]
        for one in self.conversation.running(now):
            lines.append(
                Text(f"running: {one.identifier} {plain(one.name)}, until {one.done:%H:%M:%S}", style="bold")
            )
        lines += PlanView(made, self.width, unicode=self.unicode).lines()
        lines += [line for problem in made.problems for line in problem_lines(problem)]
        return lines

    def _instruction(self, words: str, now: datetime, ask: Ask | None) -> Reply:
        """Keep an instruction that is understood; one that is not is pointed at, and not kept."""
        trial = self.conversation.state.with_entry(words, now)
        made = self.conversation.plan(now, trial)
        entry = trial.entries[-1]
        faults = [problem for problem in made.problems if problem.text == words and problem.kind in _UNREAD]
        own = [
            interpreted for interpreted in made.skills if interpreted.wish.identifier == f"s{entry.number}"
        ]
        if faults and not own:
            return Reply(tuple(line for problem in faults for line in problem_lines(problem)))
        reading = own[0].reading if own else None
        if ask is not None and reading is not None and reading.questions:
            entry = replace(entry, text=_asked(words, reading.questions[0], ask))
        text = entry.text
        self.conversation.change(words, lambda state: state.with_entry(text, now))
        return Reply(changed=True)


def _asked(words: str, question: Question, ask: Ask) -> str:
    """Ask once which of several times is meant, and say it explicitly in the instruction."""
    start, end = question.span
    choices = "  ".join(f"{i}) {choice:%a %H:%M}" for i, choice in enumerate(question.choices, 1))
    reply = ask(f"{plain(words[start:end])!r}: {choices}  [{question.chosen + 1}] ").strip()
    if not reply.isdigit() or not 1 <= int(reply) <= len(question.choices):
        return words
    from fuzzytime_cli.session import Entry

    chosen = question.choices[int(reply) - 1]
    return answered(Entry(number=0, text=words, given=chosen), question.span, chosen).text


def problem_lines(problem: Problem) -> list[Line]:
    """Give a problem as lines, with the words underlined; notes are drawn with the plan."""
    if problem.kind is ProblemKind.NOTE:
        return []
    lines: list[Line] = [Text(plain(problem.message), style="red")]
    if problem.span is not None and problem.text:
        lines += underlined(problem.text, problem.span).split("\n")
    return lines


def start_line(started: Started) -> Text:
    """Announce a start."""
    what = f"{started.start:%H:%M:%S}  start now: {plain(started.name)} ({plain(started.identifier)})"
    return Text(what, style="bold green")
