"""Lines of a recipe that only name what is needed, one below the other: "2 eggs", "300 ml milk", "salt"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.lists.things_needed import is_number, names_needed
from fuzzytime.language.sentence.sketches.sketch import sketch_of


def with_needed(drafts: Sequence[Draft]) -> list[Draft]:
    """Give drafts of lines, marked where they ask for nothing: what is counted does beside what is measured.

    The first may be what all is for: "Pancakes".
    """
    found = [not draft.phrases and names_needed(draft.scanned.words, draft.lexicon) for draft in drafts]
    for places in (range(len(drafts)), range(len(drafts) - 1, -1, -1)):
        for place in places:
            beside = place - places.step
            near = 0 <= beside < len(drafts) and found[beside] and drafts[beside].now == drafts[place].now
            found[place] = found[place] or (near and _may_be_needed(drafts[place], first=not place))
    return [
        replace(draft, needed=True) if needed else draft for draft, needed in zip(drafts, found, strict=True)
    ]


def _may_be_needed(draft: Draft, *, first: bool) -> bool:
    """Whether a line names something, and asks for nothing that is understood."""
    words = [word for word in draft.scanned.words if word.text[0].isalnum()]
    if draft.phrases or not words or draft.step is not None:
        return False
    if is_number(words[0], draft.lexicon):
        return True
    return not first and all(sketch_of(draft, part).operation is None for part in draft.parts)
