"""A conversation whose clock the test sets."""

from datetime import datetime, timedelta
from functools import cache
from pathlib import Path

from rich.text import Text

from fuzzytime.interpreter import Interpreter
from fuzzytime.scheduling import THRESHOLD, Auto, Limits
from fuzzytime.times import parse_zone
from fuzzytime_cli.repl.conversation import Conversation
from fuzzytime_cli.repl.turn import Turns
from fuzzytime_cli.session import SessionStore

NINE = datetime(2026, 3, 4, 9, tzinfo=parse_zone("Europe/Berlin"))


@cache
def shipped() -> Interpreter:
    return Interpreter.shipped()


class Talk:
    """Turns with a clock: `say` takes a turn and gives what is answered."""

    def __init__(self, path: Path | None = None) -> None:
        conversation = Conversation(
            SessionStore(path), "test", shipped(), lambda _: Auto(), Limits(), THRESHOLD
        )
        self.turns = Turns(conversation, 80, asks=True)
        self.now = NINE
        self.edit = ""
        self.turns.opened(self.now)

    def say(self, line: str) -> str:
        reply = self.turns.take(line, self.now)
        self.edit = reply.edit
        return _text(reply.lines)

    def paste(self, *lines: str) -> list[str]:
        """Say lines at once; give what is answered to each of those that stand together."""
        answers = []
        for part in self.turns.together(lines, self.now):
            one = len(part) == 1
            reply = self.turns.take(part[0], self.now) if one else self.turns.take_together(part, self.now)
            answers.append(_text(reply.lines))
        return answers

    def wait(self, **by: float) -> str:
        self.now += timedelta(**by)
        return _text(self.turns.tick(self.now))

    @property
    def entries(self) -> list[str]:
        return [entry.text for entry in self.turns.conversation.state.entries]

    @property
    def left(self) -> list[str]:
        """What was asked for, as far as it is still to be done."""
        assert self.turns.plan is not None
        planned = {one.wish.identifier for one in self.turns.plan.everything}
        entries = self.turns.conversation.state.entries
        return [entry.text for entry in entries if entry.identifier in planned]

    def start(self, identifier: str) -> datetime:
        plan = self.turns.plan
        assert plan is not None
        for position, interpreted in enumerate(plan.skills):
            if interpreted.identifier == identifier:
                return plan.instant(plan.schedule.start_times[position])
        raise KeyError(identifier)


def talk_of(*lines: str) -> Talk:
    """Give a conversation in which some lines were said."""
    talk = Talk()
    for line in lines:
        talk.say(line)
    return talk


def _text(lines: object) -> str:
    assert isinstance(lines, (list, tuple))
    return "\n".join(line.plain if isinstance(line, Text) else str(line) for line in lines)
