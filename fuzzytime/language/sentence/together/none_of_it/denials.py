"""Orders that one "don't" denies together: "don't open the lid and stir it", "never open it or lift it".

"And", "or" and "nor" alone go on with what is denied; "but", "just", "instead", "then", a comma and a time of
its own turn to what is to be done. The times of the one are those of the other: "don't wash the pans and dry
them until six" is until six for both.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.instruction import Remark
from fuzzytime.language.sentence.sketches.sketch import Sketch, text_between

AND = frozenset({"and", "&"})
"""Words that join what is denied to what may be asked for, too: a note says that it is not."""


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
        if joint in AND:
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
    if not (alternative or joint in AND) or segment.connective:
        return False
    if sketch.heard and (before.heard or min(sketch.heard)[0] < other.span[0]):
        # "Don't water it today and water it tomorrow", "don't stir it, and at six serve it"
        return False
    said = {node.lower for node in sketch.part.tree.nodes}
    left = other.lemma in lexicon.letting and bool(sketch.phrases) and not sketch.times
    turned = not said.isdisjoint(lexicon.beside.turning) or one.lemma in lexicon.doing.hesitating or left
    # "Don't open the lid and let it rest for an hour": it is left alone so.
    return alternative or not turned
