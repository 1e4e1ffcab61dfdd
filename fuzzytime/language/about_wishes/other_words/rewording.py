"""What was asked for in other words: another thing in it, or another time."""

from collections.abc import Iterator, Sequence
from datetime import datetime

from fuzzytime.english import EMPTY
from fuzzytime.language.about_wishes.other_words.merging import merged_time
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Reading, Span, overlap
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.requirement import Constraint, TimeRequirement

NOUNS = ("NN", "PRP")
"""How tags of words begin that may be a thing."""

ADJUNCTS = frozenset({"det", "amod", "compound", "nummod", "nmod:poss", "flat"})
"""What belongs to the name of a thing."""

OBJECTS = ("obj", "iobj", "root", "nmod", "obl")
"""What a thing is in a wish, what it is most likely about first."""


OF_NOUNS = ("DT", "PRP$")
QUALITIES = ("JJ", "RB", "VB", "IN")
"""How tags of words begin that say how something is, or what it does."""


def reworded(
    reading: Reading,
    lexicon: Lexicon,
    *,
    thing: str = "",
    replaced: frozenset[str] = frozenset(),
    joint: str = "",
    time: str | None = None,
    now: datetime | None = None,
) -> str | None:
    """Give the words of a wish with another thing in them, or another time; None where they have no such.

    Parameters
    ----------
    reading
        The wish, read.
    thing
        What stands in the place of what it is about; empty where that stays.
    replaced
        The words that name what is replaced; none for what the wish is about.
    joint
        The word in front of what is replaced: "for".
    time
        The new time, with what it leaves open of the old; "" for none, and None where the old one stays.
    now
        When that is said.
    """
    changes: list[tuple[Span, str]] = []
    if thing:
        place = _place_of(reading, thing, replaced, joint, lexicon)
        if place is None:
            return None
        span = _span_of(reading, place)
        bare = place == _root(reading) and reading.text[slice(*span)].split()[0].lower() not in EMPTY
        changes.append((span, without_article(thing, lexicon) if bare else thing))
    if time is not None:
        told = [part for part in _times(reading) if part.constraint is not Constraint.FOR]
        spans = list(dict.fromkeys(part.span for part in told))
        if len(spans) > 1 and time:
            return None
        changes += _with_time(reading, spans, time, now, lexicon)
    text = reading.text
    for (first, end), words in sorted(changes, reverse=True):
        text = f"{text[:first]}{words}{text[end:]}"
    return " ".join(text.split()).rstrip(" ,")


def _with_time(
    reading: Reading, spans: Sequence[Span], time: str, now: datetime | None, lexicon: Lexicon
) -> Iterator[tuple[Span, str]]:
    """Give what a new time changes, of the times that stand somewhere or where there is none."""
    if spans:
        moment = reading.now or now
        if time and moment is not None:
            time = merged_time(reading.text[slice(*spans[0])], moment, time, now or moment, lexicon)
        yield spans[0], time
        yield from ((span, "") for span in spans[1:])
    elif time:
        end = len(reading.text.rstrip(".!? "))
        yield (end, end), f" {time}"


def is_thing(text_reading: Reading) -> bool:
    """Whether words are read as a thing and no order: "dad at seven", "the tomatoes"."""
    root = _root(text_reading)
    if root is None:
        return False
    tag, first = text_reading.tokens[root].tag, text_reading.tokens[0].tag
    if tag == "VB" and first in OF_NOUNS:
        # "The lawn", which a tree takes for an order
        return True
    if not tag.startswith("NN"):
        return False
    operations = [one.operation for one in text_reading.instructions if one.operation is not None]
    return all(one.stated and content_words(one.verb) <= content_words(one.object) for one in operations)


def may_be_thing(reading: Reading, lexicon: Lexicon) -> bool:
    """Whether words may stand for a thing: not "quick", "for four people" or "six was fine"."""
    root = _root(reading)
    if root is None or reading.tokens[0].text.lower() in lexicon.closed.prepositions_of_nouns:
        return False
    tag = reading.tokens[root].tag
    # Trees take a word alone for an order: "bread", "a walk".
    alone = tag == "VB" and (len(reading.tokens) == 1 or reading.tokens[0].tag in OF_NOUNS)
    return alone or not tag.startswith(QUALITIES)


def _place_of(
    reading: Reading, thing: str, replaced: frozenset[str], joint: str, lexicon: Lexicon
) -> int | None:
    """Give the position of the word for what is replaced."""
    places = [place for place, _ in _things(reading)]
    if replaced:
        named = [place for place in places if content_words(reading.tokens[place].text) & replaced]
        # "Soup at six" may be read as a verb
        root = _root(reading)
        known = root is not None and bool(content_words(reading.tokens[root].text) & replaced)
        return named[-1] if named else root if known else None
    if joint:
        behind = [place for place in places if _case_of(reading, place) == joint]
        if behind:
            return behind[-1]
    if is_person(thing, lexicon):
        people = [
            place for place in places if is_person(reading.text[slice(*_span_of(reading, place))], lexicon)
        ]
        if people:
            return people[-1]
    for relation in OBJECTS:
        found = [place for place in places if reading.tokens[place].relation == relation]
        if found:
            return found[-1]
    return None


def is_person(thing: str, lexicon: Lexicon) -> bool:
    """Whether a thing is somebody: kin, or what is written with a capital."""
    words = thing.split()
    return bool(words) and (words[-1].lower() in lexicon.persons or words[-1][:1].isupper())


def _things(reading: Reading) -> Iterator[tuple[int, Span]]:
    """Give the words for things that are part of no time, with where they stand."""
    times = [part.span for part in _times(reading)]
    for place, token in enumerate(reading.tokens):
        timed = any(overlap(token.span, span) for span in times)
        if not timed and token.tag.startswith(NOUNS) and token.relation in OBJECTS:
            yield place, token.span


def _times(reading: Reading) -> Iterator[TimeRequirement]:
    for one in reading.instructions:
        yield from one.requirements


def _span_of(reading: Reading, place: int) -> Span:
    """Give where a thing stands with what belongs to its name."""
    times = [part.span for part in _times(reading)]
    own = [place]
    own += [
        other
        for other, token in enumerate(reading.tokens)
        if token.head == place
        and other != place
        and token.relation in ADJUNCTS
        and not any(overlap(token.span, span) for span in times)
    ]
    behind = reading.tokens[place + 1 : place + 2]
    if behind and behind[0].tag == "CD" and not any(overlap(behind[0].span, span) for span in times):
        # "Part one"
        own.append(place + 1)
    spans = [reading.tokens[one].span for one in own]
    return min(first for first, _ in spans), max(end for _, end in spans)


def _case_of(reading: Reading, place: int) -> str:
    """Give the preposition in front of a thing; empty for none."""
    cases = (t.text.lower() for t in reading.tokens if t.head == place and t.relation == "case")
    return next(cases, "")


def _root(reading: Reading) -> int | None:
    return next((place for place, token in enumerate(reading.tokens) if token.relation == "root"), None)


def without_article(thing: str, lexicon: Lexicon) -> str:
    """Give a thing as it is called in an entry of a diary: "stew" for "the stew"."""
    first, _, rest = thing.partition(" ")
    return rest if rest and first.lower() in lexicon.closed.noun_openers else thing
