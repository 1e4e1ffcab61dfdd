"""Another language is two word tables and a grammar: a small German, of which English knows nothing."""

from dataclasses import replace
from pathlib import Path

import pytest
import yaml

from fuzzytime.language import Times, find_times
from fuzzytime.language.grammar.lexicon import Lexicon
from language.corpus_rows import Row, idle_rules, instant, meant, rows_in
from language.german.rules import grammar
from language.small_language import small_lexicon

FOLDER = Path(__file__).parent / "german"
ROWS = rows_in(FOLDER / "times.yaml")
CORPUS = yaml.load((FOLDER / "times.yaml").read_text("utf-8"), yaml.CSafeLoader)


@pytest.fixture(scope="module")
def german(tmp_path_factory: pytest.TempPathFactory) -> Lexicon:
    """The tables of a language whose lists of words are empty, but for those that German times need."""
    return small_lexicon(FOLDER, tmp_path_factory.mktemp("german") / "lexicon.yaml")


def _times(text: str, row_now: object, lexicon: Lexicon) -> Times:
    return find_times(text, instant(row_now), lexicon, grammar=grammar)


@pytest.mark.parametrize("row", ROWS, ids=str)
def test_a_german_time_means_what_its_row_says(row: Row, german: Lexicon) -> None:
    found = _times(row.phrase, row.now, german)
    assert meant(row, found) == []
    assert found.requirements[0].text == row.phrase


@pytest.mark.parametrize("row", CORPUS["sentences"], ids=lambda row: row["text"])
def test_a_german_sentence_holds_its_time(row: dict[str, str], german: Lexicon) -> None:
    found = _times(row["text"], CORPUS["now"], german)
    assert [one.text for one in found.requirements] == [row["time"]] * bool(row["time"])


@pytest.mark.parametrize(
    ("german_words", "english_words"),
    [
        ("in etwa zwei Minuten", "in about two minutes"),
        ("gegen Mittag", "around noon"),
        ("spätestens um halb sechs", "no later than half past five"),
        ("bald", "soon"),
    ],
)
def test_rule_tables_see_no_difference(german_words: str, english_words: str, german: Lexicon) -> None:
    """The rule tables are asked with canonical words, so that they serve every language."""
    [said] = _times(german_words, CORPUS["now"], german).requirements
    [other] = find_times(english_words, instant(CORPUS["now"])).requirements
    assert replace(said, text="", span=(0, 0)) == replace(other, text="", span=(0, 0))


def test_every_german_rule_has_a_row(german: Lexicon) -> None:
    assert idle_rules(grammar, german, (row.phrase for row in ROWS)) == []


def test_english_is_not_understood(german: Lexicon) -> None:
    found = _times(
        "flip the pancakes in about two minutes, feed the cat at half past six", CORPUS["now"], german
    )
    assert found.requirements == ()
