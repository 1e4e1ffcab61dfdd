"""What nobody sees in a text is no word of it: codes for terminals, marks that order what is seen."""

from datetime import datetime

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.language import Language, find_times
from fuzzytime.language.unseen import without_unseen

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - the tests' moment is of no zone
CODES = (
    "\x1b[0m",
    "\x1b[1;31m",
    "\x1b[K",
    "\x1b]0;10 minutes\x07",
    "\x1b]8;;http://at.noon\x1b\\",
    "\x1b(B",
    "\x9b3m",
    "\x07",
    "\u202e",
    "\u200b",
    "\ufeff",
)


@pytest.fixture(scope="module")
def language() -> Language:
    return Language.shipped()


@pytest.mark.parametrize("code", CODES)
def test_a_code_around_words_changes_nothing(language: Language, code: str) -> None:
    text = f"{code}Call mum {code}at five past ten{code}"
    (instruction,) = language.read(text, now=NOW).instructions
    (requirement,) = instruction.requirements
    assert instruction.operation is not None
    assert instruction.operation.name == "call mum"
    assert requirement.t_spec == 65 * 60
    assert text[slice(*requirement.span)] == "at five past ten"
    assert language.read(text, now=NOW).text == text
    assert [part.t_spec for part in find_times(text, NOW).requirements] == [65 * 60]


@given(st.text(st.sampled_from("a 0m[];\x1b\x07\x9b\\\u200b\n\té?"), max_size=40))
def test_all_else_stays_in_its_place(text: str) -> None:
    left = without_unseen(text)
    assert len(left) == len(text)
    assert all(new in {old, " "} for old, new in zip(text, left, strict=True))
    assert not any(character in left for character in "\x1b\x07\x9b")
    assert text.isprintable() <= (left == text)


def test_marks_inside_of_words_stay() -> None:
    assert without_unseen("می\u200cخواهم a\u200bb\tc\n") == "می\u200cخواهم a\u200bb\tc\n"
