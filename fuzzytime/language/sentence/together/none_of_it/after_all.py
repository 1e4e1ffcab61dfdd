"""What is meant instead of a thing: "wash the car, I mean the van, at three"; and what is let be."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.instruction import Operation, Remark, RemarkKind
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.taken_back.corrected_things import (
    AFTER_ALL,
    CorrectedThing,
    corrected_things,
    retractions,
)
from fuzzytime.language.sentence.sketches.sketch import Sketch, text_between
from fuzzytime.language.sentence.together.none_of_it.orders_again import told_again


def after_all(sketches: Sequence[Sketch], draft: Draft) -> tuple[list[Sketch], list[Remark]]:
    """Give what is done with the things that are meant, and say which were taken back."""
    said = draft.scanned.words
    things = {thing.new[0]: thing for thing in corrected_things(said, draft.phrases, draft.lexicon)}
    corrected = [remark.span for remark in draft.remarks if remark.kind is RemarkKind.CORRECTED]
    let_be = {said[words.start].start for words in retractions(said, draft.lexicon, corrected)}
    found: list[Sketch] = []
    remarks: list[Remark] = []
    retracted = False
    for sketch in sketches:
        if found and sketch.part.segment.verbless and _is_or_else(found[-1], sketch, draft.text):
            remarks.append(_not_chosen(sketch, draft.text))
            continue
        if found and sketch.part.segment.span[0] in let_be:
            remarks.append(_retracted(found.pop(), sketch, draft.text))
            retracted = True
            continue
        if retracted and _is_done_by_oneself(sketch):
            continue
        retracted = False
        thing = things.get(sketch.part.segment.span[0])
        before = found[-1] if found else None
        anew = None if before is None else told_again(before, sketch, draft)
        if anew is not None:
            found[-1], remark = anew
            remarks += [] if remark is None else [remark]
            continue
        if before is None or thing is None or sketch.part.segment.connective != AFTER_ALL:
            if before is not None and _is_time_again(found, sketch, things, draft.text):
                found[-1] = _timed(before, sketch)
            else:
                found.append(sketch)
            continue
        old, new = draft.text[slice(*thing.old)], draft.text[slice(*thing.new)]
        if before.operation is not None:
            before = replace(before, operation=_instead(before.operation, old, new))
        found[-1] = _timed(before, sketch)
        remarks.append(Remark(RemarkKind.CORRECTED, thing.old, f"{old!r} is corrected by {new!r}"))
    return found, remarks


def _is_or_else(before: Sketch, sketch: Sketch, text: str) -> bool:
    """Whether "or" joins another thing to the one before: "call Eva at three or Tom at four"."""
    return text_between(before, sketch, text).strip(" ,").lower() in before.lexicon.closed.alternatives


def _not_chosen(sketch: Sketch, text: str) -> Remark:
    """Say that the second of two things is left out."""
    span = sketch.part.segment.span
    return Remark.noted(text, span, "is not used: of what 'or' joins, the first is taken")


def _retracted(before: Sketch, sketch: Sketch, text: str) -> Remark:
    """Say that what was asked for is let be."""
    first, last = before.part.segment.span, sketch.part.segment.span
    message = f"{text[slice(*first)]!r} is taken back by {text[slice(*last)]!r}"
    return Remark(RemarkKind.CORRECTED, (first[0], last[1]), message)


def _is_done_by_oneself(sketch: Sketch) -> bool:
    """Whether who lets something be says who does it: "forget that, I'll do it myself"."""
    operation, tree = sketch.operation, sketch.part.tree
    named = tree.said(tree.children(tree.root, "nsubj"))
    anaphor = (
        operation is not None and (operation.object or "").lower() in sketch.lexicon.closed.singular_anaphors
    )
    return anaphor and bool(named & sketch.lexicon.closed.first_person)


def _instead(operation: Operation, old: str, new: str) -> Operation:
    """Give an operation with another thing, wherever it names the first."""
    if old in (operation.place or ""):
        return replace(operation, place=(operation.place or "").replace(old, new))
    if old in (operation.object or ""):
        return replace(operation, object=(operation.object or "").replace(old, new))
    return replace(operation, object=new)


def _timed(before: Sketch, sketch: Sketch) -> Sketch:
    """Give a sketch with what is said of time beside the thing that is meant, and its words."""
    before = before.reaching(sketch)
    if sketch.phrases:
        return replace(before, phrases=sketch.phrases, references=sketch.references)
    return replace(before, clauses=(*before.clauses, *sketch.clauses))


def _is_time_again(
    found: Sequence[Sketch], sketch: Sketch, things: dict[int, CorrectedThing], text: str
) -> bool:
    """Whether a time alone is said right behind the thing that is meant: "No, Bob. At six."."""
    end = found[-1].part.segment.span[1]
    corrected = any(thing.new[1] == end for thing in things.values())
    alone = bool(sketch.phrases) and sketch.operation is None
    first, last = sketch.part.segment.span
    heard = sum(b - a for a, b in (phrase.span for phrase in sketch.phrases))
    return corrected and alone and heard >= last - first and not text[end:first].strip(" .,")
