"""Numbers behind "for" that are taken for how many something is for, and for no hour: "dinner for seven"."""

from collections.abc import Iterator, Sequence

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Remark, RemarkKind
from fuzzytime.language.sentence.sketches.sketch import Sketch

HOURS = 12
"""The last hour of a clock: a larger number is none."""

FOR = "for"


def counted_people(text: str, sketch: Sketch, words: Sequence[Word], lexicon: Lexicon) -> Iterator[Remark]:
    """Say how the last number of an order without a time is taken: it may be meant as its hour."""
    first, end = sketch.part.segment.span
    said = [word for word in words if first <= word.start < end and word.text.isalnum()]
    if len(said) <= 2 or said[-2].text != FOR or sketch.phrases or sketch.clauses:
        return
    last = said[-1].text
    number = int(last) if last.isdecimal() else lexicon.numbers.get(last)
    if number is not None and 0 < number <= HOURS:
        span = (said[-2].start, said[-1].end)
        message = f"{text[slice(*span)]!r} is taken for how many it is for: say 'at {last}' for a time"
        yield Remark(RemarkKind.POLICY, span, message)
