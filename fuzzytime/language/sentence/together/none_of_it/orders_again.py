"""What is said of orders given before: "call mum at five. Do it at six", "don't stir it or lift the lid"."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Operation, Remark, RemarkKind
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.sketches.sketch import Sketch, text_between
from fuzzytime.requirement import Constraint


def told_again(before: Sketch, sketch: Sketch, draft: Draft) -> tuple[Sketch, Remark | None] | None:
    """Give an order with the time that is said of it anew, and what to say of its old one; None elsewhere.

    "Do it" names what is asked for right before it, and so does the same verb behind "no" or "actually".
    """
    if not _is_again(before, sketch, draft) or not (sketch.phrases or sketch.clauses):
        return None
    pairs = list(zip(before.phrases, before.references, strict=True))
    lengths = [(one, about) for one, about in pairs if one.said.constraint is Constraint.FOR]
    times = [one for one, _ in pairs if one.said.constraint is not Constraint.FOR]
    pairs = [*lengths, *zip(sketch.phrases, sketch.references, strict=True)]
    mended = replace(
        before.reaching(sketch),
        phrases=tuple(phrase for phrase, _ in pairs),
        references=tuple(reference for _, reference in pairs),
        clauses=sketch.clauses,
    )
    said = [*(phrase.span for phrase in times), *(clause.span for clause in before.clauses)]
    if not said:
        return mended, None
    text, first = draft.text, min(said)
    new = min([*(phrase.span for phrase in sketch.phrases), *(clause.span for clause in sketch.clauses)])
    message = f"{text[slice(*first)]!r} is corrected by {text[slice(*new)]!r}"
    return mended, Remark(RemarkKind.CORRECTED, (first[0], new[0]), message)


def _is_again(before: Sketch, sketch: Sketch, draft: Draft) -> bool:
    """Whether an order is the one before it, and names nothing else."""
    old, new = before.operation, sketch.operation
    if old is None or new is None or not (old.is_asked and new.is_asked) or sketch.part.segment.connective:
        return False
    if any((new.particle, new.place, new.complement, new.manner, new.order, new.addressee)):
        return False
    if any(word.text == "again" for word in words_of(draft.text[slice(*sketch.part.segment.span)])):
        # "Feed the cat at eight and do it again at nine" asks for both.
        return False
    thing = (new.object or "").lower()
    if new.lemma == "do" and old.lemma != "do":
        return thing in draft.lexicon.closed.singular_anaphors
    same = new.lemma == old.lemma and old.object is not None and thing in draft.lexicon.closed.all_anaphors
    return same and _is_correction(before, sketch, draft)


def _is_correction(before: Sketch, sketch: Sketch, draft: Draft) -> bool:
    """Whether words between two orders take back the first: "no wait, …"."""
    end = before.part.segment.span[1]
    verb = end if sketch.operation is None else sketch.operation.span[0]
    places = [p for p, word in enumerate(draft.scanned.words) if end <= word.start < verb]
    return any(longest_match(draft.scanned.words, place, draft.lexicon.corrections) for place in places)


def is_about_orders(operation: Operation | None, lexicon: Lexicon) -> bool:
    """Whether what is to be done is only said of orders by their number: "cancel the last two"."""
    if operation is None or operation.stated or operation.object is None:
        return False
    drops = (operation.lemma,) in lexicon.conversation["dropping"]
    if not drops and not (operation.lemma == "do" and operation.order is not None):
        return False
    closed = lexicon.closed
    words = {word.text for word in words_of(operation.object)}
    counting = lexicon.ordinals.keys() | lexicon.numbers.keys() | closed.general_ordinals | closed.both
    named = words - counting - closed.noun_openers - closed.anaphors - {"of"}
    return not words.isdisjoint(counting) and not named


def denied_together(sketches: Sequence[Sketch], text: str) -> tuple[list[Sketch], list[Remark]]:
    """Deny what is joined to what is denied, and say so where it may have been meant otherwise."""
    found = list(sketches)
    remarks: list[Remark] = []
    joints = _joints(sketches, text)
    for place, joint in enumerate(joints, start=1):
        before, sketch = found[place - 1], found[place]
        if sketch.operation is None or not _goes_on(before, sketch, joint):
            continue
        said = f"{before.denial} {text[slice(*before.part.segment.span)]}"
        denied = replace(sketch, operation=replace(sketch.operation, negated=True), denial=said)
        found[place] = denied if denied.heard else denied.under(before.phrases, before.clauses)
        for earlier in range(place - 1, -1, -1):
            if not denied.heard or found[earlier].heard:
                break
            found[earlier] = found[earlier].under(denied.phrases, denied.clauses)
            if not found[earlier].denial:
                break
        if joint in sketch.lexicon.closed.additive_conjunctions:
            # A note says that it is not asked for.
            span = sketch.part.segment.span
            remarks.append(
                Remark.noted(text, span, "is taken as denied, too: what is to be done stands behind 'but'")
            )
    return found, remarks


def _joints(sketches: Sequence[Sketch], text: str) -> list[str]:
    """Give what joins each instruction to the one before it; a comma as what ends its list."""
    found = [text_between(before, sketch, text).strip(" \t").lower() for before, sketch in pairwise(sketches)]
    for place in range(len(found) - 2, -1, -1):
        if (
            found[place] == ","
            and found[place + 1].strip(" ,") in sketches[place].lexicon.closed.denied_alternatives
        ):
            # "Never open the lid, lift the pan or leave the room"
            found[place] = found[place + 1]
    return [joint.strip(" ,") for joint in found]


def _goes_on(before: Sketch, sketch: Sketch, joint: str) -> bool:
    """Whether an order goes on with what is denied before it, and does not turn to another thing."""
    lexicon = before.lexicon
    one, other, segment = before.operation, sketch.operation, sketch.part.segment
    if one is None or not one.negated or other is None or not sketch.asks or sketch.part is before.part:
        return False
    alternative = joint in lexicon.closed.denied_alternatives
    if not (alternative or joint in lexicon.closed.additive_conjunctions) or segment.connective:
        return False
    if sketch.heard and (before.heard or min(sketch.heard)[0] < other.span[0]):
        # "Don't water it today and water it tomorrow", "don't stir it, and at six serve it"
        return False
    said = {node.lower for node in sketch.part.tree.nodes}
    left = other.lemma in lexicon.letting and bool(sketch.phrases) and not sketch.times
    turned = not said.isdisjoint(lexicon.beside.turning) or one.lemma in lexicon.doing.hesitating or left
    # "Don't open the lid and let it rest for an hour": it is left alone so.
    return alternative or not turned
