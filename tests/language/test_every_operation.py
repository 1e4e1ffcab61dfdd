"""Whatever is done can be done around six: no verb and no thing makes an hour an amount."""

from datetime import datetime

import pytest
import yaml

from fuzzytime.language import find_times
from fuzzytime.resources import rules_directory

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001
TIMES = (
    "around six", "about four", "roughly six", "sixish", "at 6ish", "at about five", "by three",
    "by about six", "before six", "after six", "until six", "between five and six",
    "in about ten minutes", "at half past six",
)  # fmt: skip

AMOUNTS = ({"lower it", "rotate it", "adjust it", "turn up it", "turn down it"}, {"by", "until"})
"""What is done by so much: "turn it up by three"."""

TOPICS = ({"the picture", "the song", "the movie", "the film", "the book"}, {"about"})
"""What may be about three of something."""


def chores() -> list[tuple[str, str]]:
    """Give every operation that the table of durations knows, with each of its things."""
    table = yaml.load((rules_directory() / "durations.yaml").read_text("utf-8"), yaml.CSafeLoader)
    operations = table["durations"]["operations"]
    return [
        (verb, f"the {thing}" if thing else "it")
        for verb, row in operations.items()
        for thing in row.get("objects", {"": None})
    ]


@pytest.mark.parametrize("time", TIMES)
def test_an_hour_behind_any_chore_is_read(time: str) -> None:
    unread = []
    for verb, thing in chores():
        text = f"{verb} {thing} {time}"
        found = {requirement.text for requirement in find_times(text, NOW).requirements}
        if time not in found and not may_be_none(f"{verb} it" if thing == "it" else thing, time):
            unread.append(text)
    assert unread == []


def may_be_none(thing: str, time: str) -> bool:
    """Whether a time behind a thing may as well be something else."""
    first, *_ = time.split()
    return any(thing in things and first in words for things, words in (AMOUNTS, TOPICS))
