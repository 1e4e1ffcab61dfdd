"""Asides that say how long something takes: "once the paint is dry, which takes two hours, sand it".

They are no instructions, and what stands around them is read as if they were not there. Their length is that
of what stands before them: of what a clause says, or else of what is to be done.
"""

from collections.abc import Collection, Sequence
from dataclasses import dataclass

from fuzzytime.english import looks_plural, singular
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Span, overlap
from fuzzytime.language.meaning.expressions import Duration, Phrase

OPENING = frozenset({",", "(", "-"})
PURPOSE = 3
"""Words at most of what a length is for: "to cool down"."""


@dataclass(frozen=True, slots=True)
class Aside:
    """An aside: its stretch, and the length that it says.

    ``way`` says that this is how long one goes there, ``left`` that what was done is left alone so long,
    ``bounds`` that it is no length, but a time before or after which something can be done, or has to be
    ``done``, ``relative`` that it is of just what stands before it: "once that is dry, which takes an hour".
    ``prepares`` is what is done so long before what has a time: "dinner at seven, takes an hour to cook".
    """

    span: Span
    length: Phrase
    way: bool = False
    left: bool = False
    bounds: bool = False
    done: bool = False
    relative: bool = False
    prepares: str = ""


def asides_of(scanned: Scanned) -> tuple[Aside, ...]:
    """Give the asides of a text in order."""
    texts = [word.text for word in scanned.words]
    runs = any(_runs(text, scanned.lexicon) for text in texts)
    if scanned.lexicon.asides["taking"].isdisjoint(texts) and not runs:
        return ()
    phrases = phrases_of(scanned)
    lengths = (p for p in phrases if isinstance(p.said.time, Duration))
    ends = frozenset(p.end for p in phrases if p.first and not isinstance(p.said.time, Duration))
    found = (_aside(scanned, phrase, ends) for phrase in lengths)
    return tuple(aside for aside in found if aside is not None)


def beside_each_other(some: Sequence[Aside], others: Sequence[Aside]) -> tuple[Aside, ...]:
    """Give asides and others that stand elsewhere, in order."""
    apart = (one for one in others if not any(overlap(one.span, other.span) for other in some))
    return tuple(sorted((*some, *apart), key=lambda aside: aside.span))


def _aside(scanned: Scanned, phrase: Phrase, ends: Collection[int]) -> Aside | None:
    """Give the aside of a length; without a mark, it stands at one of the ``ends`` of times behind words."""
    words, told = scanned.words, scanned.lexicon.asides
    place = phrase.first - 1
    while place > 0 and words[place].text in told["whom"] | told["helping"]:
        place -= 1
    # "The webinar at four will run for 45 minutes"
    goes_on = phrase.said.preposition == "for" and _runs(words[place].text, scanned.lexicon)
    if place < 1 or not (goes_on or words[place].text in told["taking"]):
        return None
    if (
        words[place].text in scanned.lexicon.closed.lemmas_of_be
        and words[place - 1].text not in told["helping"]
    ):
        return None
    needed = words[place].text in told["needing"]
    place -= 1
    while place > 0 and words[place].text in told["helping"]:
        place -= 1
    bracketed = words[place].text == "(" or words[place - 1].text in {"(", "-"}
    behind = phrase.end == len(words) or words[phrase.end].text in {".", "!"}
    purpose = _purpose(words, phrase, scanned.lexicon)
    behind = behind or bool(purpose)
    if words[place].text in told["naming"] or (words[place].text in told["back"] and (bracketed or behind)):
        place -= 1
    # "Standup at nine should take ten minutes"
    runs_on = place + 1 in ends and not needed
    if place < 1 or not (runs_on or (words[place].text in OPENING and not goes_on)):
        return None
    known = told["naming"] | told["helping"] | told["back"]
    # "Handover at 7, takes a quarter of an hour"
    known |= {word for word in told["taking"] if word.endswith("s")}
    runs = goes_on and looks_plural(words[place + 1].text)
    if words[place].text != "(" and words[place + 1].text not in known and not runs:
        # "Wash up, need 20 minutes"
        return None
    end = _end(scanned, phrase)
    relative = words[place + 1].text in scanned.lexicon.closed.nonrestrictive_relatives
    start = words[place + runs_on].start
    done = " ".join(purpose)
    prepares = done if done in told["preparing"] else ""
    left = not prepares and done in scanned.lexicon.doing.by_itself
    aside = Aside((start, end or start), phrase, left=left, relative=relative, prepares=prepares)
    return None if end is None else aside


def _runs(text: str, lexicon: Lexicon) -> bool:
    """Whether a word says that something goes on: "runs"."""
    return not lexicon.doing.running.isdisjoint((text, singular(text)))


def _purpose(words: Sequence[Word], phrase: Phrase, lexicon: Lexicon) -> list[str]:
    """Give what it takes so long for, behind a length: "to get hot", "to cook", but not "to get there"."""
    said = [word.text for word in words[phrase.end : phrase.end + PURPOSE + 1]]
    ends = (p for p, text in enumerate(said) if text in lexicon.closed.end_of_an_aside)
    purpose = said[1 : next(ends, len(said))] if said[:1] == ["to"] else []
    there = lexicon.told["there"] | lexicon.told["between"]
    return purpose if len(purpose) < PURPOSE and there.isdisjoint(purpose) else []


def _end(scanned: Scanned, phrase: Phrase) -> int | None:
    """Give where an aside ends that has a length: behind what that is for, and behind a closing bracket."""
    words = scanned.words
    behind = phrase.end
    if behind < len(words) and words[behind].text == "to":
        marks = (
            p for p in range(behind, len(words)) if words[p].text in scanned.lexicon.closed.end_of_an_aside
        )
        closing = next(marks, len(words))
        behind = closing if closing - behind <= PURPOSE else behind
    if behind < len(words) and words[behind].text not in scanned.lexicon.closed.end_of_an_aside:
        return None
    closes = behind < len(words) and words[behind].text == ")"
    return words[behind if closes else behind - 1].end
