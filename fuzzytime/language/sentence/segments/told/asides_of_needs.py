"""Asides that say by when something is needed, or that somebody cannot do it before: "it's needed by six"."""

from collections.abc import Sequence
from collections.abc import Set as AbstractSet

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.sentence.segments.told.asides import OPENING, Aside
from fuzzytime.language.sentence.segments.told.asides_of_hours import (
    before_in_sentence,
    bounding,
    due_by,
    opening_before,
)
from fuzzytime.requirement import BOUNDS, MOMENTS, Constraint

MARKS = OPENING | {"\u2013", "\u2014", ";"}
"""What stands between an order and what is told of it."""

LONGEST = 8
"""Words of "the boys from next door need it", at most."""

APOSTROPHE = "'"


def asides_of_needs(scanned: Scanned) -> tuple[Aside, ...]:
    """Give the asides of a text that say by when something is needed, or can be done, in order."""
    told = scanned.lexicon.asides
    known = told["needing"] | told["needed"] | told["due"] | told["having to be"] | told["unable"]
    known |= told["being there"] | {"for"}
    if known.isdisjoint(word.text for word in scanned.words):
        return ()
    found = (_aside(scanned.words, phrase, scanned.lexicon) for phrase in phrases_of(scanned))
    return tuple(aside for aside in found if aside is not None)


def _aside(words: Sequence[Word], phrase: Phrase, lexicon: Lexicon) -> Aside | None:
    """Give the aside that ends with a time, as a bound of what it stands behind; None where it is none."""
    marks = MARKS | lexicon.beside.reasons
    opening = opening_before(words, phrase.first, marks, LONGEST)
    ends = words[phrase.end : phrase.end + 1]
    over = all(word.text in lexicon.closed.end_of_an_aside for word in ends)
    asks = any(word.is_letters for word in before_in_sentence(words, opening))
    if words[opening].text not in marks or not (over and asks):
        return None
    said = [word.text for word in words[opening + 1 : phrase.first]]
    constraint = phrase.said.constraint
    needed = _is_needed(said, lexicon) or _is_for_it(said, phrase, lexicon)
    later, due = _is_later(said, lexicon), not lexicon.asides["due"].isdisjoint(said)
    if needed and constraint in ({Constraint.BEFORE} if later else {Constraint.BEFORE, *MOMENTS}):
        # What is "due on friday", or "not needed until friday", may be done on it.
        told = due_by(phrase) if later or due else bounding(phrase, closing=True)
    elif constraint in {Constraint.AFTER, *MOMENTS} and _is_ready(said, words[:opening], lexicon):
        told = bounding(phrase, closing=False)
    elif constraint in BOUNDS and _is_unable(said, lexicon):
        told = bounding(phrase, closing=constraint is Constraint.AFTER)
    else:
        return None
    marked = opening > 0 and words[opening - 1].text in MARKS
    last = phrase.end + any(word.text == ")" for word in ends)
    span = (words[opening - marked].start, words[last - 1].end)
    return Aside(span, told, bounds=True, done=needed)


def _is_needed(said: Sequence[str], lexicon: Lexicon) -> bool:
    """Whether words say that "it" is needed, or has to be so: "it's needed", "it isn't due"."""
    told = lexicon.asides
    if not told["needing"].isdisjoint(said[-2:-1]) and said[-1] in lexicon.closed.anaphors:
        return True
    *helping, so = said_of(said, lexicon.closed.anaphors) or [""]
    if not helping:
        return False
    if so in told["needed"] | told["due"]:
        return (told["being needed"] | told["not needed"]).issuperset(helping)
    made = so in lexicon.results and helping[-1] == "be" and len(helping) > 1
    return made and told["having to be"].issuperset(helping)


def _is_for_it(said: Sequence[str], phrase: Phrase, lexicon: Lexicon) -> bool:
    """Whether words say when "it" is for: "buy a cake, it's for friday"."""
    helping = said_of(said, lexicon.closed.anaphors)
    is_so = bool(helping) and lexicon.asides["being needed"].issuperset(helping)
    return phrase.said.preposition == "for" and is_so


def _is_ready(said: Sequence[str], order: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words say from when on there is what is fetched: "pick up the cake, it's ready from three"."""
    *helping, so = said_of(said, lexicon.closed.anaphors) or [""]
    being = lexicon.asides["being needed"] | lexicon.asides["helping"]
    fetched = not lexicon.doing.meeting.isdisjoint(word.text for word in order)
    there = bool(helping) and so in lexicon.asides["being there"]
    return fetched and there and being.issuperset(helping)


def said_of(said: Sequence[str], things: AbstractSet[str]) -> list[str]:
    """Give what is said of one of ``things``, as an apostrophe cuts it: "it's due", "they aren't due"."""
    thing, *words = [part for word in said for part in word.split(APOSTROPHE)] or [""]
    return words if thing in things else []


def _is_later(said: Sequence[str], lexicon: Lexicon) -> bool:
    """Whether words deny that it is needed so soon: "it's not needed", "they don't need it"."""
    return any(not lexicon.asides["not needed"].isdisjoint(word.split(APOSTROPHE)) for word in said)


def _is_unable(said: Sequence[str], lexicon: Lexicon) -> bool:
    """Whether words say that somebody cannot do it: "I can't do it", "Ann won't be there"."""
    place = next((place for place, word in enumerate(said) if word in lexicon.asides["unable"]), 0)
    behind = said[place + 1 :]
    return place > 0 and bool(behind) and lexicon.asides["unable to"].issuperset(behind)
