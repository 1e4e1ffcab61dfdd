"""Tables of a small language: the words that its times need, and every other list empty.

A folder holds ``calendar.yaml``, whole, and ``words.yaml``: those rows of ``rules/lexicon.yaml`` that have
words.
"""

import json
from pathlib import Path
from typing import Any

import yaml

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.word_tables import read_lexicon
from fuzzytime.resources import rules_directory

NAMED = ("prepositions", "hedges", "words", "amounts", "clauses", "comparisons", "particles")
"""Sections whose rows are words themselves."""


def small_lexicon(folder: Path, whole: Path) -> Lexicon:
    """Read the tables of a folder, and write the lexicon that they make, empty lists and all, to a file."""
    english = yaml.load((rules_directory() / "lexicon.yaml").read_text("utf-8"), yaml.CSafeLoader)
    rows = _blank(english) | {section: {"source": "none"} for section in NAMED}
    for section, words in yaml.load((folder / "words.yaml").read_text("utf-8"), yaml.CSafeLoader).items():
        rows[section] = rows[section] | words if isinstance(words, dict) else words
    rows["language"] = yaml.load((folder / "calendar.yaml").read_text("utf-8"), yaml.CSafeLoader)["language"]
    whole.write_text(json.dumps(rows, ensure_ascii=False), "utf-8")
    return read_lexicon(whole, folder / "calendar.yaml")


def _blank(node: Any) -> Any:  # noqa: ANN401 - as YAML has it
    """Give a table without its words: its sections, the rows that rules ask for, and empty lists."""
    if isinstance(node, list):
        return []
    if not isinstance(node, dict):
        return node
    return {key: _blank(value) for key, value in node.items()}
