"""Lines of a recipe that only say what is needed: "2 eggs", "300 ml milk", or how long it takes in all."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.meaning.expressions import Duration
from fuzzytime.language.meaning.phrases import places_in
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.lists.things_needed import is_number, names_needed
from fuzzytime.language.sentence.sketches.sketch import sketch_of


def with_needed(drafts: Sequence[Draft]) -> list[Draft]:
    """Give drafts of lines, marked where they ask for nothing: what is counted does beside what is measured.

    The first may be what all is for: "Pancakes".
    """
    found = [
        _tells_total(draft) if draft.phrases else names_needed(draft.scanned.words, draft.lexicon)
        for draft in drafts
    ]
    for places in (range(len(drafts)), range(len(drafts) - 1, -1, -1)):
        for place in places:
            beside = place - places.step
            near = 0 <= beside < len(drafts) and found[beside] and drafts[beside].now == drafts[place].now
            found[place] = found[place] or (near and _may_be_needed(drafts[place], first=not place))
    return [
        replace(draft, needed=True) if needed else draft for draft, needed in zip(drafts, found, strict=True)
    ]


def _tells_total(draft: Draft) -> bool:
    """Whether a line only says how long it takes in all: "serves 6, takes 3 hours", "prep 20 min"."""
    totals, words = draft.lexicon.no_times.totals, draft.scanned.words
    if any(not isinstance(phrase.said.time, Duration) for phrase in draft.phrases):
        return False
    inside = places_in(draft.phrases)
    left = [word.text for place, word in enumerate(words) if place not in inside and word.is_letters]
    beside = draft.lexicon.function_words | draft.lexicon.closed.verbs_of_obligation
    # "It should take an hour" is of what stands before it.
    beside -= draft.lexicon.closed.anaphors
    return not totals.isdisjoint(left) and all(word in totals | beside for word in left)


def _may_be_needed(draft: Draft, *, first: bool) -> bool:
    """Whether a line names something, and asks for nothing that is understood."""
    words = [word for word in draft.scanned.words if word.text[0].isalnum()]
    if draft.phrases or not words or draft.step is not None:
        return False
    if is_number(words[0], draft.lexicon):
        return True
    return not first and all(sketch_of(draft, part).operation is None for part in draft.parts)
