"""Events by which it is said when something is done, though they may be places: "ring the bell at kick-off".

Where that was told, it is when: "the wedding is at three", "take photos at the wedding".
What hardly is a place waits for it; what may be one is one where nothing happens.
"""

from collections.abc import Iterator, Sequence

from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Remark, RemarkKind, Span, overlap
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.references.anchors import Anchors
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import Edge, TimeRequirement

LONGEST = 4
"""Words of the name of an event at most: "the first tea break"."""


def at_events(
    sketch: Sketch, words: Sequence[Word], text: str, anchors: Anchors
) -> tuple[list[TimeRequirement], list[Remark]]:
    """Give what events an instruction is to be done at, and remarks on those of which nothing is known."""
    found: list[TimeRequirement] = []
    remarks: list[Remark] = []
    if sketch.operation is None or sketch.operation.stated or sketch.phrases:
        return found, remarks
    for span, is_moment in events_in(sketch, words):
        said = text[slice(*span)]
        marker, _, name = said.partition(" ")
        clause = Clause("while", marker.lower(), span, span, object=name, is_event=True, edge=Edge.START)
        target = anchors.target_of(clause)
        operation = None if target is None else anchors.operation_at(target)
        happens = operation is not None and operation.stated
        if happens or is_moment:
            found.append(anchors.of_clause(clause, said, name, target if happens else None))
        if is_moment and not happens:
            remarks.append(untold(said, span))
    return found, remarks


def untold(said: str, span: Span) -> Remark:
    """Point at words that wait for something of which nothing is known so far."""
    message = f"{said!r} counts when readings or an instruction tell it, and none so far does"
    return Remark(RemarkKind.UNRESOLVED, span, message)


def events_in(sketch: Sketch, words: Sequence[Word]) -> Iterator[tuple[Span, bool]]:
    """Give the stretches of "at" and an event behind it, and whether that is hardly a place."""
    lexicon = sketch.lexicon
    first, end = sketch.part.segment.span
    places = [place for place, word in enumerate(words) if first <= word.start < end]
    for place in places:
        behind = [p for p in places if place < p <= place + LONGEST]
        if words[place].text not in lexicon.closed.prepositions_of_events or any(
            overlap(_span(words, place), span) for span in sketch.heard
        ):
            continue
        for last in behind:
            texts = [words[p].text for p in range(place + 1, last + 1)]
            over = last == places[-1] or words[last + 1].text in lexicon.function_words | {",", ";", ")"}
            happens = texts[-1] in lexicon.happening | lexicon.taken | lexicon.events
            # "Change the oil at the next service"
            moment = any(tuple(texts[-len(form) :]) == form for form in lexicon.moments)
            moment = moment or (happens and texts[-2:-1] == ["next"])
            if over and (moment or happens):
                # In a break that was told of, or at what hardly is a place
                yield (words[place].start, words[last].end), moment and words[place].text == "at"
                break


def _span(words: Sequence[Word], place: int) -> Span:
    return words[place].start, words[place].end
