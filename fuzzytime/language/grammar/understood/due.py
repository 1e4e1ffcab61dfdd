"""Times by which something must be there, ready or done: "be home for six", "a task due friday"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.english import looks_plural
from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Edge, Phrase
from fuzzytime.requirement import MOMENTS, Constraint

NAME = 4
"""Words of a place at most, behind its preposition: "at the new swimming pool"."""

DUE_BEHIND = "bounds.due_behind_thing"
"""The rule of what is due: "create a task due friday"."""

APART = frozenset({",", ":"})
"""Marks before what is due."""


def is_due(texts: Sequence[str], place: int, lexicon: Lexicon) -> bool:
    """Whether "for" at a place stands behind what must be there, or ready, then.

    "Take it off the heat for ten" and "bring it to the boil for ten" are minutes: nothing is anywhere then.
    """
    if not place or texts[place] != "for":
        return False
    beside, before = lexicon.beside, texts[place - 1]
    if before in beside.ready:
        return True
    stops = (at for at in range(place - 1, -1, -1) if texts[at] in beside.stops)
    clause = texts[next(stops, -1) + 1 : place]
    verb = next((at for at, text in enumerate(clause) if text in lexicon.doing.bringing), None)
    if verb is None:
        return False
    if before in beside.there:
        return True
    what = clause[verb + 1 : verb + 2]
    several = bool(what) and looks_plural(what[0])
    if clause[verb] == "get" and (several or not lexicon.closed.indefinite_determiners.isdisjoint(what)):
        # "Get tickets to the show for two", "get a room at the inn for two"
        return False
    behind = range(verb + 1, len(clause))
    led = (at for at in reversed(behind) if clause[at] in beside.whereabouts)
    where = next(led, len(clause))
    name = clause[where + 1 :]
    return bool(name) and len(name) <= NAME and name[-1].isalpha() and lexicon.timing.isdisjoint(name)


def tells_when_due(piece: Piece, texts: Sequence[str], lexicon: Lexicon) -> bool:
    """Whether it only tells when what is due comes: "the rent is due friday", "the truck due at two"."""
    if piece.rule != DUE_BEHIND:
        return False
    before = texts[piece.start - 1] if piece.start else ","
    thing = before.isalpha() and before not in lexicon.function_words | lexicon.closed.told_auxiliaries
    return before in lexicon.closed.coming or not (thing or before in APART)


def due_then(phrase: Phrase, words: Sequence[Word], lexicon: Lexicon) -> Phrase:
    """Read "for" before a clock time as "by", behind what must be there, or ready, then.

    So it is before a day for which something is made ready: "pack a bag for monday" is done before it begins.
    """
    said = phrase.said
    if said.constraint not in MOMENTS or said.preposition != "for":
        return phrase
    texts = [word.text for word in words]
    if said.wall.clock is not None and is_due(texts, phrase.first, lexicon):
        due = replace(said, preposition="by", constraint=Constraint.BEFORE, edge=Edge.DUE)
        return replace(phrase, said=due)
    if said.wall.clock is None and said.wall.days is not None and _is_made_ready(texts, phrase, lexicon):
        return replace(phrase, said=replace(said, constraint=Constraint.BEFORE, edge=Edge.START))
    return phrase


def _is_made_ready(texts: Sequence[str], phrase: Phrase, lexicon: Lexicon) -> bool:
    """Whether what stands in front makes a thing ready, that does not have a time itself.

    It is "set out the cups", and not "set the alarm"; "prepare the meeting for monday" is of when that is.
    """
    first = max((p + 1 for p in range(phrase.first) if texts[p] in lexicon.beside.stops), default=0)
    clause = [text for text in texts[first : phrase.first] if text not in lexicon.addresses]
    alone = clause[:1] and clause[0] in lexicon.doing.for_then
    out = alone and (clause[0] not in lexicon.doing.putting or "out" in clause)
    return len(clause) > 1 and bool(out) and lexicon.beside.timed_things.isdisjoint(clause)
