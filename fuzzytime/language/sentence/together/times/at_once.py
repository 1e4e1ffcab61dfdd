"""What is to be done at once, behind something else: "mix it and immediately chill it"."""

from dataclasses import replace

from fuzzytime.language.instruction import overlap
from fuzzytime.language.meaning.expressions import Duration, Phrase, TimeWord
from fuzzytime.language.meaning.joined.distances import later_by
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.language.sentence.sketches.sketch import Sketch, text_between
from fuzzytime.requirement import Unit

AT_ONCE = frozenset({"immediately", "right now"})
"""The words for the moment of speaking that may be the moment of something else, too."""

WAITED_FOR = frozenset({"when", "if", "after"})
"""Clauses that say what comes before."""


def at_once(sketches: list[Sketch], text: str) -> list[Sketch]:
    """Let what is done at once be right after what the same sentence says before, or when that is so."""
    found: list[Sketch] = []
    for sketch in sketches:
        told = sketch
        places = [place for place, phrase in enumerate(sketch.phrases) if _is_at_once(phrase, text)]
        if places and any(clause.kind in WAITED_FOR for clause in sketch.clauses):
            told = _without(sketch, sketch.phrases[places[0]])
        elif places and found and _is_joined(found[-1], sketch, text):
            phrase = sketch.phrases[places[0]]
            right_after = later_by(Duration(((0, Unit.SECOND),)))
            phrases = list(sketch.phrases)
            phrases[places[0]] = replace(phrase, said=right_after)
            told = replace(sketch, phrases=tuple(phrases))
        found.append(told)
    return found


def _is_at_once(phrase: Phrase, text: str) -> bool:
    time = phrase.said.time
    said = text[slice(*phrase.span)].lower().split()
    return isinstance(time, TimeWord) and time.word in AT_ONCE and "now" not in said


def _without(sketch: Sketch, left_out: Phrase) -> Sketch:
    """Leave out a time, which a clause says already."""
    return replace(sketch.keeping(lambda one: one is not left_out), joints=(*sketch.joints, left_out.span))


def _is_joined(before: Sketch, sketch: Sketch, text: str) -> bool:
    """Whether both are in one sentence, and the one before is done."""
    between = text_between(before, sketch, text)
    operation = before.operation
    # As in "the machine finishes at 11:20, empty it straight away".
    over = (
        operation is not None and operation.stated and bool(before.phrases) and sketch.operation is not None
    )
    done = operation is not None and (not operation.stated or over)
    return (
        done and not ENDS & set(between) and not overlap(before.part.segment.span, sketch.part.segment.span)
    )
