"""What is told beside what has a time: what the same one does next, and what others do then."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.instruction import Operation
from fuzzytime.language.meaning.phrases import is_at_clock
from fuzzytime.language.sentence.references.mentions import Mentions
from fuzzytime.language.sentence.segments.further.same_doers import tells_more
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.language.sentence.sketches.sketch import Sketch, are_steps, text_between
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.language.sentence.trees.tags import SUBJECTS
from fuzzytime.requirement import Constraint, Reference

BREAKS = frozenset({",", "-", "–", ";"})
"""Marks between an order and what is told of it."""


def told_beside(sketches: list[Sketch], text: str) -> list[Sketch]:
    """Give what is told without a time that of what is told before it in its sentence.

    What the same one does comes next ("Kestrel takes off at nine, surveys the field"); what others do is then
    ("I'm on break from two to three, Dee covers").
    """
    found: list[Sketch] = []
    for sketch in sketches:
        told = sketch
        if tells_more(sketch.part) and sketch.operation is not None:
            goes_on = bool(found) and _is_on(found[-1], sketch)
            told = sketch if goes_on else _done_next(sketch, sketch.operation, text)
        elif found and _is_then(found[-1], sketch, text) and sketch.operation is not None:
            before = found[-1]
            told = replace(sketch, operation=replace(sketch.operation, due=None, stated=True))
            told = told.under(before.times, before.clauses)
        elif found and _may_only(found[-1], sketch, text):
            found[-1] = found[-1].under(sketch.times).reaching(sketch)
            continue
        found.append(told)
    return found


def _is_beside(before: Sketch, sketch: Sketch, text: str) -> bool:
    """Whether a comma alone stands between two parts."""
    return text_between(before, sketch, text).strip() in BREAKS and not sketch.part.segment.connective


def _may_only(before: Sketch, sketch: Sketch, text: str) -> bool:
    """Whether it is said when alone an order can be done: "ring her, she's only free between 11 and 12"."""
    tree, root = sketch.part.tree, sketch.part.tree.root
    if not tree.nodes or not before.is_open or not _is_beside(before, sketch, text):
        return False
    subjects = tree.said(tree.children(root, *SUBJECTS))
    only = any(node.lower == "only" for node in tree.nodes)
    is_so = tree.nodes[root].lemma in before.lexicon.closed.lemmas_of_be and bool(
        subjects & before.lexicon.closed.third_person
    )
    return only and is_so and bool(sketch.times)


def _done_next(sketch: Sketch, operation: Operation, text: str) -> Sketch:
    """Give what one does who was named before, behind what that one did before it."""
    segment = sketch.part.segment
    told = _done_by(operation, segment.doer or "", asked=segment.doer == segment.addressee)
    if segment.connective or sketch.clauses or bool(sketch.times) or _lasts(sketch):
        return replace(sketch, operation=told)
    return _behind(replace(sketch, operation=told), text)


def _behind(sketch: Sketch, text: str, connective: str = "then") -> Sketch:
    """Give what is told as what comes behind what is told before it, at the comma or "and" between them."""
    segment = sketch.part.segment
    before = text[: segment.span[0]].rstrip()
    joint = len(before) - (len("and") if before.lower().endswith("and") else 1)
    joined = replace(segment, connective=connective, connective_span=(joint, len(before)))
    return replace(sketch, part=replace(sketch.part, segment=joined))


def from_then_on(sketches: Sequence[Sketch], text: str, apart: str) -> list[Sketch]:
    """Give the first of some steps the time from which on all are: "bath, books, bed from 6.30"."""
    times = sketches[-1].phrases if len(sketches) > 1 else ()
    if len(times) != 1 or any(one.heard for one in sketches[:-1]):
        return list(sketches)
    from_then = times[0].said.preposition == "from"
    if not from_then or not all(are_steps(*both, text, apart) for both in pairwise(sketches)):
        return list(sketches)
    first, *others, last = sketches
    return [first.under(times), *others, last.without_times()]


def steps_in_turn(sketches: Sequence[Sketch], text: str, apart: str) -> list[Sketch]:
    """Let steps without a time come behind those before them: "maths at nine, reading for an hour, break".

    In the text with its stops they are ``apart``, and one of them has a time or comes next.
    """
    if not any(one.times or one.part.segment.connective == "then" for one in sketches):
        return list(sketches)
    found = list(sketches[:1])
    for sketch in sketches[1:]:
        joined = are_steps(found[-1], sketch, text, apart)
        waits = not (sketch.times or sketch.clauses or sketch.part.segment.connective)
        led = bool(found[-1].phrases) or found[-1].part.segment.connective == "then"
        # "The meeting starts at seven, opening ceremony ten minutes"
        within = (
            found[-1].operation is not None and found[-1].operation.lemma in sketch.lexicon.doing.beginning
        )
        said = "meanwhile" if within else "then"
        found.append(_behind(sketch, text, said) if joined and waits and led else sketch)
    return found


def _is_on(before: Sketch, sketch: Sketch) -> bool:
    """Whether what one does is what goes on then: "we're on at nine and play for an hour"."""
    first, second = before.operation, sketch.operation
    begins = first is not None and first.lemma in before.lexicon.doing.beginning_or_being
    lasts = bool(sketch.phrases) and not sketch.times
    return begins and lasts and second is not None and second.object is None


def _done_by(operation: Operation, doer: str, *, asked: bool) -> Operation:
    """Give what somebody does who is named before: "feeds the cows" as "Steve feeds the cows"."""
    if asked:
        # "Robot 2 cleans the tank at nine and docks" asks it to dock.
        return replace(operation, verb=operation.lemma, addressee=doer)
    said = " ".join(filter(None, (operation.object, operation.complement)))
    return replace(operation, object=doer, complement=said or None, stated=True)


def _is_then(before: Sketch, sketch: Sketch, text: str) -> bool:
    """Whether what is told has no time, and stands beside what has one in the same sentence."""
    first, second = before.operation, sketch.operation
    if first is None or second is None or not (second.stated or (first.stated and _do_so(sketch, second))):
        return False
    if (second.complement or "").lower() in before.lexicon.closed.anaphors:
        # "Wash the car at ten, Tom dries it"
        return False
    if first.is_asked and second.attended:
        # "Set an alarm for six I have a flight" tells why.
        return False
    between = text_between(before, sketch, text)
    tree = sketch.part.tree
    # "Meeting at seven, opening ceremony ten minutes"
    chained = bool(sketch.phrases) and tree.nodes[tree.root].tag.startswith("NN")
    alone = not (sketch.clauses or sketch.times or chained or _lasts(sketch))
    return (
        alone
        and not ENDS & set(between)
        and not sketch.part.segment.connective
        and before.part.segment.span[1] <= sketch.part.segment.span[0]
    )


def _do_so(sketch: Sketch, operation: Operation) -> bool:
    """Whether several who are named do it, and are not said to have to: "…, Priya and Tom go"."""
    tree, root = sketch.part.tree, sketch.part.tree.root
    if operation.due is None or tree.children(root, "aux", "auxpass", "xcomp"):
        return False
    named = tree.children(root, *SUBJECTS)
    return bool(named) and tree.nodes[named[0]].tag == "NNP" and bool(tree.children(named[0], "conj"))


def _lasts(sketch: Sketch) -> bool:
    """Whether it is said how long something takes: "the show starts at eight and lasts two hours"."""
    operation = sketch.operation
    lasting = (
        operation is not None
        and operation.lemma in sketch.lexicon.doing.taking | sketch.lexicon.doing.running
    )
    return lasting and bool(sketch.phrases)


def due_before(sketches: Sequence[Sketch], text: str, mentions: Mentions, first: int) -> list[Sketch]:
    """Let what takes long, and was not asked for, be over when it has to be so, or what it is for has to be.

    "The lamb needs three hours and it has to be on the table at two", "makeup for Ines takes 90 minutes, she
    has to be on set by 8"; ``first`` instructions were given before.
    """
    found: list[Sketch] = []
    for due in sketches:
        operation = found[-1].operation if found else None
        if operation is None or operation.object is None or not _takes_until(found[-1], due, text):
            found.append(due)
            continue
        if mentions.about(content_words(operation.object), first) is not None:
            found.append(due)
            continue
        told = replace(found[-1], operation=replace(operation, lemma="be", complement=None))
        if _is_same(due):
            found[-1] = told.also(*due.times, about=Reference.FINISH).reaching(due)
        else:
            found[-1:] = [told, _behind(due, text)]
    return found


def _takes_until(why: Sketch, due: Sketch, text: str) -> bool:
    """Whether it is told how long something takes, and behind that by when something has to be so."""
    bounds = any(is_at_clock(p) or p.said.constraint is Constraint.BEFORE for p in due.phrases)
    joint = text_between(why, due, text).strip()
    joined = joint in BREAKS or (joint == "and" and _is_same(due))
    return bounds and joined and not due.part.segment.connective and _tells_length(why) and _has_to_be_so(due)


def _is_same(due: Sketch) -> bool:
    """Whether it is said of the same thing again: "it has to be ready by six", "… and has to be ready"."""
    tree = due.part.tree
    subjects = tree.said(tree.children(tree.root, *SUBJECTS))
    return due.part.segment.doer is not None or bool(subjects & due.lexicon.closed.anaphors)


def _tells_length(sketch: Sketch) -> bool:
    """Whether it is only told how long something takes."""
    operation = sketch.operation
    taking = operation is not None and operation.stated and operation.lemma in sketch.lexicon.doing.taking
    return taking and not sketch.clauses and bool(sketch.phrases) and not sketch.times


def _has_to_be_so(sketch: Sketch) -> bool:
    """Whether somebody or something has to be somewhere, or to be so: "she has to be on set by eight"."""
    tree, root = sketch.part.tree, sketch.part.tree.root
    if sketch.operation is None or sketch.operation.lemma not in {"be", "get"}:
        return False
    helping = tree.said((root, *tree.children(root, "aux")))
    called = sketch.part.segment.doer is not None or bool(tree.children(root, *SUBJECTS))
    return bool(helping & sketch.lexicon.closed.verbs_of_obligation) and called
