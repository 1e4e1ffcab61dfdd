"""What was asked of the time of a skill, in words, and what is missing of it."""

from fuzzytime.interpreter import Interpreted, Moved
from fuzzytime.requirement import asked_words
from fuzzytime.times import format_duration
from fuzzytime_cli.render import plain


def moved_words(moved: Moved | None) -> str:
    """Give by how much a wish was moved, as a signed time; empty where it was not."""
    return "" if moved is None else f"{'+' if moved.by >= 0 else ''}{format_duration(moved.by)}"


def asked_of_time(interpreted: Interpreted) -> str:
    """Say what was asked of its time."""
    if interpreted.requirements:
        words = plain(asked_words(interpreted.requirements))
        asked = f"It asked for “{words}”"
    elif interpreted.in_order:
        asked = "Nothing was said about its time but its place in the order"
    elif interpreted.instruction is not None:
        asked = "Nothing was said about its time"
    else:
        asked = "Its satisfaction was given as a curve"
    if interpreted.wish.moved is not None:
        asked += f", and it was moved by {moved_words(interpreted.wish.moved)}"
    return asked


def waits_sentences(interpreted: Interpreted) -> list[str]:
    """Say what is missing of the time of a skill that has none yet."""
    return [
        f"{asked_of_time(interpreted)}.",
        f"It waits: {plain(interpreted.reason)}.",
        "It is planned once that is told; until then it counts neither for nor against the plan.",
    ]
