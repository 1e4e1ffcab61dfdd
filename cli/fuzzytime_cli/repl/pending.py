"""The question that was put: which of several times is meant."""

from dataclasses import dataclass
from datetime import timedelta

from rich.text import Text

from fuzzytime.interpreter import Plan, Problem
from fuzzytime.language import HALF_OF_DAY_ADVICE, Policy, Question, Reading
from fuzzytime_cli.render import wrapped
from fuzzytime_cli.repl.scene import Scene


@dataclass(frozen=True, slots=True)
class Pending:
    """A question that was put: the next line answers it, by a number, or leaves the choice as it is."""

    entry: int
    question: Question


def question_of(reading: Reading, policy: Policy) -> Question | None:
    """Give the first question of a reading of which more than one answer is likely; else None."""
    return next((one for one in reading.questions if _is_open(one, reading, policy)), None)


def untold_notes(plan: Plan, policy: Policy, pending: Pending | None) -> frozenset[Problem]:
    """Give the notes on which half of a day was taken that tell nothing new.

    The other "two" is at night, and the table says when it is; or it is asked about.
    """
    asked = "" if pending is None else f"s{pending.entry}"
    clear = {
        (one.reading.text, question.span)
        for one in plan.everything
        if one.reading is not None
        for question in one.reading.questions
        if one.wish.identifier == asked or not _is_open(question, one.reading, policy)
    }
    notes = (one for one in plan.problems if one.message.endswith(HALF_OF_DAY_ADVICE))
    return frozenset(one for one in notes if (one.text, one.span) in clear)


def _is_open(question: Question, reading: Reading, policy: Policy) -> bool:
    """Whether the time taken does not come soon, and people are up at one that was not taken."""
    first, last, soon = policy.ahead_from, policy.plausible_to, timedelta(hours=policy.soon_hours)
    chosen = question.choices[question.chosen]
    comes_soon = reading.now is not None and reading.now <= chosen <= reading.now + soon
    others = (choice for choice in question.choices if choice != chosen)
    return not comes_soon and any(first <= choice.time() <= last for choice in others)


def asked_late(scene: Scene, words: str) -> Pending | None:
    """Give the question of what was told last again, where somebody says "pm" only later; else None."""
    entries = scene.conversation.state.entries
    halves = scene.lexicon.conversation["half of the day"]
    if (words.lower().replace(".", ""),) not in halves or not entries:
        return None
    number = entries[-1].number if scene.told_last is None else scene.told_last
    readings = (one.reading for one in scene.plan.everything if one.wish.identifier == f"s{number}")
    asked = (one.questions[0] for one in readings if one is not None and one.questions)
    question = next(asked, None)
    return None if question is None else Pending(number, question)


def question_lines(question: Question, width: int) -> list[Text | str]:
    """Put a question: which of several times is meant, and which one it is taken for."""
    choices = [
        f"{number} for {instant:%A %H:%M}" + (" (taken)" if number == question.chosen + 1 else "")
        for number, instant in enumerate(question.choices, 1)
    ]
    asked = f"Which time did you mean? Type {', '.join(choices)}."
    return [Text(line, style="bold") for line in wrapped(asked, width)]
