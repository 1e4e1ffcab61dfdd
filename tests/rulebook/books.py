"""Rulebooks for tests: the shipped tables, with lines of one's own over them."""

from pathlib import Path

from fuzzytime.rulebook import Profile, Rulebook
from fuzzytime.rulebook.tables.documents import Document, load


def book(tmp_path: Path, text: str, profile: Profile = Profile.EVERYDAY) -> Rulebook:
    """The shipped lookup and durations with one more table, and without the shipped contexts."""
    mine = tmp_path / "mine.yaml"
    mine.write_text(f"fuzzytime: 1\n{text}", encoding="utf-8")
    documents = [
        Document.shipped("lookup.yaml"),
        Document.shipped("durations.yaml"),
        Document(mine, str(mine)),
    ]
    return Rulebook(load(documents, profile), profile)
