"""Events by which it is said when something is done, though they may be places: "ring the bell at kick-off".

Where that was told, it is when: "the wedding is at three", "take photos at the wedding".
What hardly is a place waits for it; what may be one is one where nothing happens.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Remark, RemarkKind, Span, overlap
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.references.anchors import Anchors
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import Constraint, Edge, TimeRequirement

LONGEST = 4
"""Words of the name of an event at most: "the first tea break"."""


def at_events(
    sketch: Sketch, words: Sequence[Word], text: str, anchors: Anchors
) -> tuple[list[TimeRequirement], list[Remark]]:
    """Give what events an instruction is to be done at, and remarks on those of which nothing is known."""
    found: list[TimeRequirement] = []
    remarks: list[Remark] = []
    for span, is_moment in _events_at(sketch, words):
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


def without_moments(sketch: Sketch, words: Sequence[Word], text: str) -> Sketch:
    """Give what is to be done without what hardly is a place, and says when: "go home at the bell"."""
    for span, is_moment in _events_at(sketch, words):
        operation = sketch.operation
        if is_moment and operation is not None:
            said = text[slice(*span)]
            thing, place = _without(operation.object, said), _without(operation.place, said)
            sketch = replace(sketch, operation=replace(operation, object=thing, place=place))
    return sketch


def _without(name: str | None, said: str) -> str | None:
    """Give the words of a name without those of what is said in it, with or without its hyphens."""
    words = "[- ]".join(map(re.escape, re.split("[- ]", said)))
    left = re.sub(words, "", name or "", count=1, flags=re.IGNORECASE)
    return " ".join(left.split()) or None if left != name else name


def _events_at(sketch: Sketch, words: Sequence[Word]) -> Iterator[tuple[Span, bool]]:
    """Give the events at which something is to be done of which no words say when."""
    timed = any(phrase.said.constraint is not Constraint.FOR for phrase in sketch.phrases)
    if sketch.operation is not None and not sketch.operation.stated and not timed:
        yield from events_in(sketch, words)


def untold(said: str, span: Span) -> Remark:
    """Point at words that wait for something of which nothing is known so far."""
    message = f"{said!r} counts when readings or an instruction tell it, and none so far does"
    return Remark(RemarkKind.UNRESOLVED, span, message)


def events_in(sketch: Sketch, words: Sequence[Word]) -> Iterator[tuple[Span, bool]]:
    """Give the stretches of "at" and an event behind it, and whether that is hardly a place."""
    lexicon = sketch.lexicon
    first, end = sketch.part.segment.span
    places = [place for place, word in enumerate(words) if first <= word.start < end]
    begins = None if sketch.operation is None else sketch.operation.span[0]
    for place in places:
        behind = [p for p in places if place < p <= place + LONGEST]
        if words[place].text not in lexicon.closed.prepositions_of_events or any(
            overlap(_span(words, place), span) for span in sketch.heard
        ):
            continue
        for last in behind:
            texts = [words[p].text for p in range(place + 1, last + 1)]
            over = last == places[-1] or words[last + 1].text in lexicon.function_words | {",", ";", ")"}
            # "At the bell go home"
            over = over or words[last + 1].start == begins or words[last + 1].text in lexicon.indicators
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
