"""Each phrase of the corpora means what its row says, and texts without time hold none."""

from functools import cache

import pytest

from fuzzytime.language import Times, find_times
from fuzzytime.language.english import grammar
from fuzzytime.language.finding import shipped_lexicon
from language.corpus_rows import Row, idle_rules, meant, rows, sentences, texts_without_time

ROWS = rows()
SOME = 5
"""So many rows stand together, of which one is said inside a sentence, too."""


@cache
def _alone(row: Row) -> Times:
    return find_times(row.phrase, row.now)


def _is_bound(row: Row) -> bool:
    return any(found.preposition is not None for found in _alone(row).requirements)


@pytest.mark.parametrize("row", ROWS, ids=str)
def test_a_phrase_means_what_its_row_says_from_its_first_word_to_its_last(row: Row) -> None:
    found = _alone(row)
    assert meant(row, found) == []
    assert found.requirements[0].text.rstrip(".!") == row.phrase.rstrip(".!")


@pytest.mark.parametrize("first", range(0, len(ROWS), 20 * SOME))
def test_a_time_is_the_same_inside_a_sentence(first: int) -> None:
    for place in range(first, min(first + 20 * SOME, len(ROWS)), SOME):
        # Without a preposition, "the fifteenth" and 15/3 may be other things inside a sentence.
        row = next(filter(_is_bound, ROWS[place : place + SOME]), None)
        if row is None:
            continue
        inside = find_times(f"call the plumber {row.phrase}, please", row.now).requirements[0]
        alone = _alone(row).requirements[0]
        # At the end of a text a full stop is of the sentence, behind an abbreviation too.
        assert inside.text.rstrip(".") == alone.text.rstrip(".")
        assert inside.t_spec == alone.t_spec


@pytest.mark.parametrize("text", texts_without_time())
def test_a_text_without_time_holds_none(text: str) -> None:
    assert find_times(text, ROWS[0].now).requirements == ()


def test_every_rule_has_a_row() -> None:
    texts = (*(row.phrase for row in ROWS), *(row["text"] for row in sentences()))
    assert idle_rules(grammar(), shipped_lexicon(), texts) == []
