"""Each phrase of the corpora means what its row says, and texts without time hold none."""

import pytest

from fuzzytime.language import find_times
from fuzzytime.language.english import grammar
from fuzzytime.language.finding import shipped_lexicon
from language.corpus_rows import Row, idle_rules, meant, rows, sentences, texts_without_time


def _is_bound(row: Row) -> bool:
    return any(found.preposition is not None for found in find_times(row.phrase, row.now).requirements)


ROWS = rows()
# Without a preposition, "the fifteenth" and 15/3 may be other things inside a sentence.
BOUND = [row for row in ROWS if _is_bound(row)]


@pytest.mark.parametrize("row", ROWS, ids=str)
def test_a_phrase_means_what_its_row_says(row: Row) -> None:
    assert meant(row, find_times(row.phrase, row.now)) == []


@pytest.mark.parametrize("row", ROWS, ids=str)
def test_a_time_covers_its_whole_phrase(row: Row) -> None:
    said = find_times(row.phrase, row.now).requirements[0].text
    assert said.rstrip(".!") == row.phrase.rstrip(".!")


@pytest.mark.parametrize("row", BOUND[::5], ids=str)
def test_a_time_is_the_same_inside_a_sentence(row: Row) -> None:
    alone = find_times(row.phrase, row.now)
    text = f"call the plumber {row.phrase}, please"
    inside = find_times(text, row.now)
    # At the end of a text a full stop is of the sentence, behind an abbreviation too.
    assert inside.requirements[0].text.rstrip(".") == alone.requirements[0].text.rstrip(".")
    assert inside.requirements[0].t_spec == alone.requirements[0].t_spec


@pytest.mark.parametrize("text", texts_without_time())
def test_a_text_without_time_holds_none(text: str) -> None:
    assert find_times(text, ROWS[0].now).requirements == ()


def test_every_rule_has_a_row() -> None:
    texts = (*(row.phrase for row in ROWS), *(row["text"] for row in sentences()))
    assert idle_rules(grammar(), shipped_lexicon(), texts) == []
