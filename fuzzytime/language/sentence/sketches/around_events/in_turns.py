"""What is done once for each of several: "muck out between milkings", "unload every truck" where trucks come.

"Between" may say where something is put as well. It says when, where the noun behind it names what is asked
for, or told, several times; of what nothing is told, a note says that it is no time here.
"""

from collections.abc import Iterator

from fuzzytime.english import singular
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Operation, Remark, RemarkKind, Span, overlap
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.references.anchors import Anchors
from fuzzytime.language.sentence.references.several import every_one
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import Anchor, Constraint, TimeRequirement

SEVERAL = 2
LONGEST = 4
"""Words of the name of what is between which something is done, at most: "the second shift's breaks"."""


def in_turns(sketch: Sketch, anchors: Anchors, draft: Draft) -> tuple[list[TimeRequirement], list[Remark]]:
    """Give what an instruction requires that is done between several, or with each of what comes."""
    operation = sketch.operation
    if operation is None or not operation.is_asked:
        return [], []
    required: list[TimeRequirement] = []
    remarks: list[Remark] = []
    for span, name in _between(sketch, operation, anchors, draft):
        said = draft.text[slice(*span)]
        targets = _turns(name, anchors)
        if targets and operation.lemma not in anchors.lexicon.doing.putting:
            required.append(_counted(said, span, name, targets, Constraint.BETWEEN))
        elif not targets and singular(name.split()[-1].lower()) in anchors.lexicon.persons:
            message = f"{said!r} is planned once: when they come and go is not told"
            remarks.append(Remark(RemarkKind.POLICY, span, message))
    if not required and not sketch.times and not sketch.clauses:
        required += _with_each_that_comes(operation, anchors)
    return required, remarks


def _between(
    sketch: Sketch, operation: Operation, anchors: Anchors, draft: Draft
) -> Iterator[tuple[Span, str]]:
    """Give the stretches of "between" and one noun for several, and that noun: "between the dives"."""
    first, end = sketch.part.segment.span
    words = [word for word in draft.scanned.words if first <= word.start < end]
    for place, word in enumerate(words):
        if word.text == "between" and not any(overlap((word.start, word.end), span) for span in sketch.heard):
            # "Between patients wash your hands"
            behind = [one for one in words[place + 1 :] if not word.start < operation.span[0] <= one.start]
            name = _several(behind, anchors)
            if name:
                yield (word.start, name[-1].end), draft.text[name[0].start : name[-1].end]


def _several(words: list[Word], anchors: Anchors) -> list[Word]:
    """Give the words of a noun for several, up to where it is over; nothing where words name two."""
    closed = anchors.lexicon.closed
    over = next((p for p, word in enumerate(words) if not word.is_letters), len(words))
    name = words[: min(over, LONGEST)]
    ends = (p for p, word in enumerate(name) if p and word.text in anchors.lexicon.function_words)
    end = next((p for p in ends if name[p].text not in closed.each_of_several), len(name))
    if any(word.text in closed.additions for word in words[end : end + 1]) or not end:
        return []
    each = name[0].text in closed.distributives
    return name[:end] if each or singular(name[end - 1].text) != name[end - 1].text else []


def _turns(name: str, anchors: Anchors) -> tuple[int, ...]:
    """Give the instructions that a noun means, where they are several or one is repeated."""
    targets = every_one(Clause("between", "between", (0, 0), (0, 0), object=name, is_event=True), anchors)
    asked = {
        one.lemma for place in targets if (one := anchors.operation_at(place)) is not None and one.is_asked
    }
    if len(asked) > 1:
        # The plates are filled, sealed and read: between which of that is not said.
        return ()
    again = any(anchors.told.is_repeated(target) for target in targets if target < anchors.position)
    return targets if len(targets) >= SEVERAL or again else ()


def _with_each_that_comes(operation: Operation, anchors: Anchors) -> Iterator[TimeRequirement]:
    """Let what is done with every one of what comes be done once each is there: "unload every truck"."""
    first = (operation.object or "").lower().split()[:1]
    if anchors.lexicon.closed.distributives.isdisjoint(first) or operation.object is None:
        return
    named = _turns(operation.object, anchors)
    come = (place for place in named if (one := anchors.operation_at(place)) is not None and one.stated)
    if named and tuple(come) == named:
        yield _counted(operation.object, operation.span, operation.object, named, Constraint.AFTER)


def _counted(
    said: str, span: Span, name: str, targets: tuple[int, ...], constraint: Constraint
) -> TimeRequirement:
    anchor = Anchor(text=name, object=name, target=targets[0], each=targets)
    word = "between" if constraint is Constraint.BETWEEN else None
    return TimeRequirement(text=said, span=span, constraint=constraint, preposition=word, anchor=anchor)
