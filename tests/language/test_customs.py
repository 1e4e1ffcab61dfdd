"""Customs of one's own go over the shipped calendar, row by row; a mistake is told where it is."""

from datetime import datetime
from pathlib import Path

import pytest

from console import ROOT
from fuzzytime.errors import DocumentError
from fuzzytime.language import Language, find_times
from fuzzytime.language.grammar.word_tables.layers import is_word_table
from fuzzytime.language.policy import DateOrder
from fuzzytime.resources import rules_directory
from fuzzytime.times import instant_after

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - of no zone
HEAD = "fuzzytime: 1\nlanguage: en\n"


def written(tmp_path: Path, *texts: str) -> list[Path]:
    """Write customs, each without its head."""
    files = [tmp_path / f"customs{number}.yaml" for number in range(len(texts))]
    for file, text in zip(files, texts, strict=True):
        file.write_text(HEAD + text, encoding="utf-8")
    return files


def when(text: str, *customs: Path) -> list[str]:
    """Give the bounds of the times that a text says."""
    language = Language.shipped(customs=customs)
    found = find_times(text, NOW, language.lexicon).requirements
    return [
        f"{instant_after(NOW, bound):%m-%d %H:%M}"
        for one in found
        for bound in (one.earliest, one.latest)
        if bound is not None
    ]


@pytest.mark.parametrize(
    ("customs", "text", "shipped", "own"),
    [
        ('parts: {evening: {from: "16:00"}}', "this evening", ["18:00", "22:00"], ["16:00", "22:00"]),
        ('parts: {evening: {from: "16:00"}}', "this eve", ["18:00", "22:00"], ["16:00", "22:00"]),
        ('parts: {siesta: {from: "13:00", to: "15:00", half: pm}}', "during siesta", [], ["13:00", "15:00"]),
        ("parts: {dusk: {also: the gloaming}}", "at the gloaming", [], ["18:00", "19:00"]),
        (
            'parts: {supper: {from: "19:30", to: "20:00", half: pm, meal: true}}',
            "before supper",
            ["18:00"],
            ["19:30"],
        ),
        ("day_parts: {tonight: {part: evening}}", "tonight", ["20:00", "05 00:00"], ["18:00", "22:00"]),
        ("policy: {date_order: day-month}", "on 4/5", ["04-05 00:00", "04-06 00:00"], ["05-04 00:00"]),
        ('policy: {plausible: {from: "05:00"}}', "tomorrow at 5:30", ["05 17:30"], ["05 05:30"]),
        ("policy: {weekend: {from: friday}}", "this weekend", ["03-07 00:00"], ["03-06 00:00"]),
        ("holidays: {founders' day: {date: 05-04}}", "on founders' day", [], ["05-04 00:00"]),
        ("holidays: {mother's day: {date: 03-25}}", "on mothers day", ["05-10 00:00"], ["03-25 00:00"]),
        ("days: {1: [the morrow]}", "on the morrow", [], ["05 00:00", "06 00:00"]),
        ("days: {1: [the morrow]}", "tomorrow", ["05 00:00", "06 00:00"], ["05 00:00", "06 00:00"]),
    ],
)
def test_what_customs_say_counts(
    tmp_path: Path, customs: str, text: str, shipped: list[str], own: list[str]
) -> None:
    for files, bounds in ((), shipped), (written(tmp_path, customs), own):
        said = when(text, *files)
        assert len(said) >= len(bounds), said
        assert bounds or not said, said
        for found, bound in zip(said, bounds, strict=False):
            assert found.endswith(bound), (text, said)


def test_the_last_customs_win_key_by_key(tmp_path: Path) -> None:
    files = written(
        tmp_path,
        'parts: {evening: {from: "16:00", to: "20:00"}}',
        'parts: {evening: {from: "17:00"}}\npolicy: {date_order: day-month}',
    )
    assert [time[-5:] for time in when("this evening", *files)] == ["17:00", "20:00"]
    policy = Language.shipped(customs=files).lexicon.policy
    assert policy.date_order is DateOrder.DAY_MONTH
    assert policy.soon_hours == Language.shipped().lexicon.policy.soon_hours


def test_lists_that_are_no_words_stay_as_they_are(tmp_path: Path) -> None:
    (customs,) = written(tmp_path, "holidays: {harvest: {hindu star: [4, 21]}}")
    assert when("on onam", customs) == when("on onam") != []


def mistakes(*files: Path) -> list[str]:
    """Give every mistake of customs with its file and place."""
    with pytest.raises(DocumentError) as raised:
        Language.shipped(customs=files)
    return [f"{Path(one.path).name}:{one.line}:{one.column}: {one.message}" for one in raised.value.mistakes]


@pytest.mark.parametrize(
    ("customs", "said"),
    [
        ('parts: {evening: {from: "25:00"}}', "3:25: a time of day must look like 09:30, got '25:00'"),
        ("parts: {evening: {form: 1}}", "3:19: unknown key 'form' (did you mean 'from'?)"),
        ("partz: {}", "3:1: unknown key 'partz' (did you mean 'parts'?)"),
        ("parts: []", "3:8: must be a mapping (key: value), got a list"),
        (
            'parts: {siesta: {from: "13:00", to: "15:00", half: pm, also: [dusk]}}',
            "3:9: words must have one meaning in a table, got 'dusk' twice",
        ),
        (
            "parts: {siesta: {from: noon}}",
            "3:17: missing key 'to'",
        ),
        (
            "holidays: {fair: {date: 05-04}, fair: {date: 05-05}}",
            "3:33: keys must differ, got 'fair' as on line 3",
        ),
        (
            "holidays: {easter: {date: 05-04, islamic: 09-01}}",
            "3:34: must have one of 'date', 'nth', ",
        ),
        ("policy: {weekend: {days: 9}}", "3:26: must be between 1 and 6, got '9'"),
        ("policy: {week_starts: moonday}", "3:23: must be one of the known words, got 'moonday'"),
    ],
)
def test_a_mistake_is_told_where_it_is_and_nowhere_else(tmp_path: Path, customs: str, said: str) -> None:
    found = mistakes(*written(tmp_path, "policy: {date_order: day-month}", customs))
    assert any(one.startswith(f"customs1.yaml:{said}") for one in found), found
    assert all(one.startswith("customs1.yaml:") for one in found), found


def test_mistakes_of_all_files_are_told_at_once(tmp_path: Path) -> None:
    files = written(tmp_path, "partz: {}", "policy: [", "zonez: {}")
    found = mistakes(*files)
    assert [one.partition(":")[0] for one in found] == [file.name for file in files]


def test_customs_are_of_the_language_that_they_are_laid_over(tmp_path: Path) -> None:
    file = tmp_path / "customs.yaml"
    file.write_text("fuzzytime: 1\nlanguage: de\nparts: {}\n", encoding="utf-8")
    assert mistakes(file) == ["customs.yaml:2:11: must be one of the known words, got 'de' (known: en)"]
    file.write_text("parts: {}\n", encoding="utf-8")
    assert [one.partition(": ")[2] for one in mistakes(file)] == [
        "missing key 'fuzzytime'",
        "missing key 'language'",
    ]


def test_word_tables_are_told_from_rule_tables(tmp_path: Path) -> None:
    rules = rules_directory()
    assert is_word_table(rules / "calendar.yaml")
    assert is_word_table(ROOT / "examples" / "tables" / "customs.yaml")
    (tmp_path / "no_language.yaml").write_text("fuzzytime: 1\nparts: {evening: {from: 16:00}}\n")
    assert is_word_table(tmp_path / "no_language.yaml")
    assert not is_word_table(rules / "lookup.yaml")
    (tmp_path / "broken.yaml").write_text("language: [", encoding="utf-8")
    assert not is_word_table(tmp_path / "broken.yaml")


def test_the_example_in_the_book_is_the_one_that_ships() -> None:
    example = (ROOT / "examples" / "tables" / "customs.yaml").read_text(encoding="utf-8")
    assert f"```yaml\n{example}```" in (ROOT / "docs" / "customs.md").read_text(encoding="utf-8")
