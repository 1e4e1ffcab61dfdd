"""The question that was put: which of several times is meant."""

from dataclasses import dataclass

from rich.text import Text

from fuzzytime.language import Policy, Question
from fuzzytime_cli.repl.scene import Scene

HALVES = frozenset({"am", "pm"})
"""Which half of the day is meant, said alone."""


@dataclass(frozen=True, slots=True)
class Pending:
    """A question that was put: the next line answers it, by a number, or leaves the choice as it is."""

    entry: int
    question: Question


def asked_late(scene: Scene, words: str) -> Pending | None:
    """Give the question of what was told last again, where somebody says "pm" only later; else None."""
    entries = scene.conversation.state.entries
    if words.lower().replace(".", "") not in HALVES or not entries:
        return None
    number = entries[-1].number if scene.told_last is None else scene.told_last
    readings = (one.reading for one in scene.plan.everything if one.wish.identifier == f"s{number}")
    asked = (one.questions[0] for one in readings if one is not None and one.questions)
    question = next(asked, None)
    return None if question is None else Pending(number, question)


def matters(question: Question, policy: Policy) -> bool:
    """Whether a time that was not taken may be meant: six in the morning may, four in the morning hardly."""
    others = (choice for place, choice in enumerate(question.choices) if place != question.chosen)
    return any(policy.ahead_from <= choice.time() <= policy.plausible_to for choice in others)


def question_lines(question: Question) -> list[Text | str]:
    """Put a question: which of several times is meant, and which one it is taken for."""
    choices = [
        f"{number} for {instant:%A %H:%M}" + (" (taken)" if number == question.chosen + 1 else "")
        for number, instant in enumerate(question.choices, 1)
    ]
    return [Text(f"Which time did you mean? Type {', '.join(choices)}.", style="bold")]
