"""Word tables are read whole, and every mistake in them has its line and column."""

import re
from pathlib import Path

import pytest

from fuzzytime.errors import DocumentError
from fuzzytime.language import read_lexicon, shipped_lexicon
from fuzzytime.language.finding import shipped_grammar
from fuzzytime.resources import rules_directory

LEXICON = (rules_directory() / "lexicon.yaml").read_text("utf-8")
CALENDAR = (rules_directory() / "calendar.yaml").read_text("utf-8")


def mistakes(tmp_path: Path, lexicon: str = LEXICON, calendar: str = CALENDAR) -> list[str]:
    """Give the mistakes of two files, without their folder."""
    (tmp_path / "lexicon.yaml").write_text(lexicon, "utf-8")
    (tmp_path / "calendar.yaml").write_text(calendar, "utf-8")
    try:
        read_lexicon(tmp_path / "lexicon.yaml", tmp_path / "calendar.yaml")
    except DocumentError as error:
        return [f"{Path(m.path).name}:{m.line}:{m.column}: {m.key}: {m.message}" for m in error.mistakes]
    return []


def test_the_shipped_tables_have_no_mistake(tmp_path: Path) -> None:
    assert mistakes(tmp_path) == []


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            "  by:              {constraint: before",
            "  by:              {constraint: beside",
            r"prepositions\.by\.constraint: must be one of",
        ),
        (
            "  about:           {side: before",
            "  about:           {sied: before",
            r"hedges\.about\.sied: unknown key 'sied' \(did you mean 'side'\?\)",
        ),
        (
            "  soon:                {constraint: vague",
            "  soon:                {constraint: never",
            r"words\.soon\.constraint: must be one of",
        ),
        (
            "  a few:        {quantity: [2, 3, 4, 6]",
            "  a few:        {quantity: [2, 3, 6, 4]",
            r"amounts\.a few: corners must not decrease",
        ),
        ("amounts:\n", "amounts:\n  a few: {}\n", r"amounts\.a few: keys must differ"),
        ("results: [", "result: [", r"unknown key 'result'"),
    ],
)
def test_a_mistake_among_the_words_is_located(tmp_path: Path, old: str, new: str, said: str) -> None:
    assert old in LEXICON
    changed = LEXICON.replace(old, new, 1)
    line = changed[: changed.index(new)].count("\n") + 1
    found = mistakes(tmp_path, lexicon=changed)
    assert any(re.search(said, mistake) for mistake in found), found
    assert any(re.match(rf"lexicon\.yaml:({line}|{line + 1}|\d+):\d+:", mistake) for mistake in found)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            '  noon:       {from: "12:00"',
            '  noon:       {from: "25:00"',
            r"parts\.noon\.from: a time of day must look like 09:30, got '25:00'",
        ),
        (
            "  epiphany:          {date: 01-06",
            "  epiphany:          {date: 13-06",
            r"holidays\.epiphany\.date: a day of the year must look like 12-24",
        ),
        (
            "  labor day:         {nth: [1, monday, september]}",
            "  labor day:         {nth: [1, monday]}",
            r"holidays\.labor day\.nth: must hold 3 items, got 2",
        ),
        (
            "  week:    [week",
            "  wek:     [week",
            r"units\.wek: a unit must be a number of known units, got 'wek'",
        ),
        ("  America/Denver:", "  America/Dever: ", r"zones\.America/Dever: a zone must be an IANA name"),
        (
            "  week_starts: monday",
            "  week_starts: mondy",
            r"policy\.week_starts: must be one of the known words, got 'mondy' \(did you mean 'monday'",
        ),
        ("  0: [monday, mon]", "  9: [monday, mon]", r"weekdays\.9: must be between 0 and 6, got '9'"),
    ],
)
def test_a_mistake_in_the_calendar_is_located(tmp_path: Path, old: str, new: str, said: str) -> None:
    assert old in CALENDAR
    changed = CALENDAR.replace(old, new, 1)
    line = changed[: changed.index(new)].count("\n") + 1
    found = mistakes(tmp_path, calendar=changed)
    assert any(re.match(rf"calendar\.yaml:{line}:\d+: ", m) and re.search(said, m) for m in found), found


def test_mistakes_of_both_files_are_told_in_one_run(tmp_path: Path) -> None:
    found = mistakes(
        tmp_path,
        LEXICON.replace("side: after", "side: afer", 1),
        CALENDAR.replace("half: am", "half: a", 1),
    )
    assert {mistake.split(":")[0] for mistake in found} == {"lexicon.yaml", "calendar.yaml"}


def test_words_with_two_meanings_in_one_table_are_a_mistake(tmp_path: Path) -> None:
    found = mistakes(tmp_path, LEXICON.replace("also: [bout, abt,", "also: [bout, nearly,", 1))
    assert len(found) == 1
    assert "words must have one meaning in a table, got 'nearly' twice" in found[0]


def test_every_word_that_a_rule_names_can_be_typed() -> None:
    assert all(literal == literal.lower() and " " not in literal for literal in shipped_grammar().literals)


def test_the_rows_that_a_rulebook_may_have_are_the_keys_of_the_tables() -> None:
    names = {
        entry.value.name
        for row in shipped_lexicon().entries.values()
        for entry in row
        if entry.category.startswith("preposition")
    }
    assert {"in", "at", "by", "before", "until", "no later than", "after", "from", "not before"} <= names | {
        "in"
    }
