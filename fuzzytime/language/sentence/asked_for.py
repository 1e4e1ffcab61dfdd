"""What each part of a text asks for: its pronouns resolved, and nothing where it is no instruction."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.instruction import Operation, Remark
from fuzzytime.language.sentence.references.anchors import Anchors
from fuzzytime.language.sentence.references.mentions import Mentions
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.sketches.meaning.pronouns import (
    resolved_object,
    thing_of_clause_in_front,
    undone_alone,
)
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.together.none_of_it.again_before import times_again
from fuzzytime.language.sentence.together.none_of_it.doubts import doubts_of, unasked
from fuzzytime.language.sentence.together.none_of_it.how_much import counted
from fuzzytime.language.sentence.together.none_of_it.unused import (
    nothing_to_do,
    things_or_orders,
    unused_orders,
)
from fuzzytime.language.sentence.together.none_of_it.what_was import is_over, tells_what_was


def asked_of(
    sketches: Sequence[Sketch], draft: Draft, mentions: Mentions, first: int
) -> tuple[list[Sketch], list[Remark]]:
    """Give the sketches of a text with what is really asked for, and what is said of those that ask nothing.

    ``first`` of the operations that are mentioned were given before the text.
    """
    found: list[Sketch] = []
    remarks: list[Remark] = []
    operations: list[Operation | None] = []
    spoken_of: list[Operation | None] = []
    for sketch in sketches:
        operation = sketch.operation
        asked = any(one is not None and one.is_asked for one in (*mentions.operations[:first], *operations))
        again = times_again(sketch, draft) if asked else None
        if again is not None:
            # "Repeat twice"
            found.append(replace(sketch, again=again))
            operations.append(None)
            spoken_of.append(None)
            continue
        # What an entry is called says nothing of whether it happens.
        doubts = _doubts(sketch, draft) if draft.entry is None else []
        remarks += doubts
        was = bool(doubts) and tells_what_was(sketch)
        if doubts:
            clauses = unasked(sketch.clauses, draft.text, draft.lexicon)
            past = was and is_over(sketch)
            found.append(replace(sketch, operation=None, clauses=clauses, doubted=True, past=past))
        elif operation is None:
            heard = [*sketch.heard, *sketch.joints]
            nothing = list(nothing_to_do(draft.text, sketch.part, draft.scanned.words, heard))
            remarks += nothing
            found.append(replace(sketch, doubted=bool(nothing)))
        else:
            remarks += unused_orders(draft.text, sketch.part, operation, [*sketch.heard, *sketch.joints])
            remarks += things_or_orders(draft.text, sketch.part)
            remarks += counted(draft, sketch)
            anchors = Anchors(first + len(found), first, operations, mentions)
            thing = thing_of_clause_in_front(sketch, operation, anchors)
            thing = thing or _behind_denials(sketch, operation, operations, mentions, first)
            thing = thing or resolved_object(operation, spoken_of, mentions, first)
            before = (*reversed(operations), *reversed(mentions.operations[:first]))
            thing = thing or undone_alone(operation, before, draft.lexicon)
            again = operation.again or thing != operation.object
            found.append(replace(sketch, operation=replace(operation, object=thing, again=again)))
        operations.append(found[-1].operation)
        # "I fed the cat at seven, feed her again"
        spoken_of.append(found[-1].operation or (operation if was else None))
    return found, remarks


def _behind_denials(
    sketch: Sketch, operation: Operation, own: Sequence[Operation | None], mentions: Mentions, first: int
) -> str | None:
    """Give what "it" is in what goes on behind a denial: "boil the rice; don't open the lid; then serve it".

    None where that is not said, or what it goes on from names nothing.
    """
    denied = [one is not None and one.negated for one in own]
    if sketch.part.segment.connective != "then" or denied[-1:] != [True]:
        return None
    asked = [None if no else one for one, no in zip(own, denied, strict=True)]
    thing = resolved_object(operation, asked, mentions, first)
    return thing if thing != operation.object else None


def _doubts(sketch: Sketch, draft: Draft) -> list[Remark]:
    part = sketch.part
    first, end = part.segment.span
    front = draft.text[first : part.offset].partition(" ")[0].lower()
    # "Should the bell ring, open the door" asks nothing.
    span = (part.offset if front in draft.lexicon.closed.conditional_inversion else first, end)
    return list(doubts_of(draft.text, span, draft.scanned.words, sketch))
