"""One of several times of what is repeated: the first is kept, and the others are told of."""

from datetime import datetime

import pytest

from fuzzytime.language import Language

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - said on the wall clock


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("take the pill every day at six pm or at eight pm", ["at eight pm"]),
        ("take the pill at six pm or at eight pm every day", ["at eight pm every day"]),
        ("on weekdays take the pill at 7, 8 or 9 am", ["8", "9 am"]),
        ("on weekdays take the pill in the morning or in the evening", ["in the evening"]),
    ],
)
def test_of_times_of_a_repetition_the_first_is_taken(text: str, left: list[str]) -> None:
    reading = Language.shipped().read(text, now=NOW)
    unused = [remark for remark in reading.remarks if "is not used" in remark.message]
    assert [text[slice(*remark.span)] for remark in unused] == left
    (instruction,) = reading.instructions
    assert instruction.repeats is not None
