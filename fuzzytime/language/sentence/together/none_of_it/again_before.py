"""What was asked for right before, done again without a time: "repeat twice", "once more"."""

import re

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.sketches.sketch import Sketch

TURNS = re.compile(r"x\s?\d{1,2}|\d{1,2}\s?x", re.IGNORECASE)
"""How many times, as typed: "4x", "x 3"."""


def times_again(sketch: Sketch, draft: Draft) -> int | None:
    """Give how many times what was asked for before is done again; None where a sketch says no such thing.

    "Repeat until it shines" is for nobody knows how often.
    """
    first, end = sketch.part.segment.span
    if sketch.phrases or sketch.clauses:
        return None
    words = draft.scanned.words
    said = [word.text for word in words if first <= word.start < end and word.is_letters]
    if (
        not repeats(sketch.operation, draft.lexicon)
        and tuple(said) not in draft.lexicon.conversation["again"]
    ):
        return None
    counted = [int(word.text) for word in words if word.is_digits and first <= word.start < end]
    pieces = draft.scanned.pieces("times")
    counted += [int(piece.value) for piece in pieces if first <= words[piece.start].start < end]
    return max([1, *counted])


def repeats(operation: Operation | None, lexicon: Lexicon) -> bool:
    """Whether what was done is to be done again, which is not named: "repeat twice more"."""
    if operation is None or operation.lemma not in lexicon.doing.repeating or operation.stated:
        return False
    # "Repeat 4x"
    counted = TURNS.fullmatch(operation.object or "") is not None
    return counted or (operation.object or "it").lower() in lexicon.closed.singular_anaphors
