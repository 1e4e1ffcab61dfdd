"""Events that are named beside their time, without a verb: "Dinner at eight, set the table at seven"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.surroundings import OWNING
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Operation
from fuzzytime.language.meaning.expressions import Duration, Phrase, Repeat, TimeWord
from fuzzytime.language.sentence.segments import Segment
from fuzzytime.language.sentence.waiting import Part, Waiting
from fuzzytime.requirement import Constraint

LONGEST_NAME = 4
"""Words of what is named, at most, and of whom it is with."""

BEHIND = frozenset({",", "-", ";", ":", "so", "and"})
"""Words between an event with its time and what is to be done."""

BE = "be"


def announced(one: Waiting, lexicon: Lexicon) -> list[Segment]:
    """Give the segment of an event with its time, and that of what stands behind it, if any."""
    source = one.source
    places = source.places(*one.segment.span)
    first = next((phrase for phrase in source.phrases if phrase.first in places), None)
    if one.segment.announces or first is None or not _says_when(first):
        return []
    words = source.scanned.words
    if not _names_event(words[places[0] : first.first], lexicon):
        return []
    end = first.end
    while (
        further := next((p for p in source.phrases if p.first == end and _says_when(p)), None)
    ) is not None:
        end = further.end
    behind = [place for place in places if place >= end]
    if behind and words[behind[0]].text not in BEHIND:
        return []
    begin, last = one.segment.span
    event = replace(one.segment, span=(begin, words[end - 1].end), announces=True)
    while behind and words[behind[0]].text in BEHIND:
        behind.pop(0)
    if not behind:
        return [event]
    return [event, Segment((words[behind[0]].start, last), addressee=one.segment.addressee)]


def announcement(part: Part, phrases: Sequence[Phrase], text: str) -> Operation:
    """Give what happens, named in front of its times."""
    begin, end = part.segment.span[0], min(phrase.span[0] for phrase in phrases)
    return Operation(
        verb="is",
        lemma=BE,
        span=(begin, begin + len(text[begin:end].rstrip())),
        object=text[begin:end].strip(" ,:-") or None,
        stated=True,
    )


def _says_when(phrase: Phrase) -> bool:
    """Whether it says when something happens; not how long, how often or how soon."""
    said = phrase.said
    moment = said.constraint in {None, Constraint.AT, Constraint.BETWEEN}
    return moment and not isinstance(said.time, (Duration, Repeat, TimeWord))


def _names_event(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words name something that has a time: "dinner", "my dentist appointment", "lunch with Ann"."""
    texts = [word.text for word in words]
    if "with" in texts:
        together = texts.index("with")
        texts, company = texts[:together], texts[together + 1 :]
        if not 0 < len(company) < LONGEST_NAME or lexicon.function_words & set(company) - OWNING:
            return False
    if not 0 < len(texts) <= LONGEST_NAME:
        return False
    meals = {entry.words[-1] for entry in lexicon.entries.get(texts[-1], ()) if entry.category == "meal"}
    # "Alarm at seven" asks for one.
    events = lexicon.taken | meals | (lexicon.events - lexicon.appointing)
    if texts[0] in OWNING:
        return len(texts) > 1 and texts[-1] in events
    # "Call at three" asks for a call.
    return all(text in events - lexicon.addressing for text in texts)
