"""What somebody is told, or what is written: "text mike i'm late", "send jim a text saying i'm late".

It asks for nothing, and no time in it is when to do anything. What stands around it is read as if it were not
there: in one tree with the order, it is often taken for what is to be done.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.grammar.words import Word, is_quoted
from fuzzytime.language.instruction import Remark, Span, overlap
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.meaning.phrases import places_in
from fuzzytime.language.sentence.segments.other_cases import OTHER_CASE
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.language.sentence.segments.told.told_clauses import is_said, told_from
from fuzzytime.language.sentence.segments.waiting import JOINT

SAYING = (("saying",), ("that", "says"), ("which", "says"), ("to", "say"))

FARTHEST = 5
"""Words at most between "let" and "know"."""

CONDITIONS = frozenset({"when", "if"})
"""Kinds of clauses behind what is told that say when to tell it: "text mike i'm home when i get in"."""


@dataclass(frozen=True, slots=True)
class Message:
    """What is told: the character where the verb begins that tells it, its stretch, and the times in it.

    ``whom`` is who is named right behind the verb, ``onward`` where another order begins behind a joint.
    """

    verb: int
    span: Span
    times: tuple[Phrase, ...]
    whom: Span | None = None
    onward: int | None = None


@dataclass(frozen=True, slots=True)
class _Source:
    """The words of a text, with its times."""

    words: tuple[Word, ...]
    phrases: tuple[Phrase, ...]
    lexicon: Lexicon

    @property
    def ends(self) -> dict[int, int]:
        """The ends of times by their first words."""
        return {phrase.first: phrase.end for phrase in self.phrases}

    @property
    def covered(self) -> frozenset[int]:
        """The places of the words that are about time."""
        return places_in(self.phrases)


def messages_of(scanned: Scanned) -> tuple[Message, ...]:
    """Give what is told in a text, in order."""
    doing = scanned.lexicon.doing
    verbs = (
        doing.messaging
        | scanned.lexicon.letting
        | doing.letters
        | doing.replying
        | {form.split()[0] for form in doing.noting}
    )
    if verbs.isdisjoint(word.text for word in scanned.words):
        return ()
    source = _Source(scanned.words, phrases_of(scanned), scanned.lexicon)
    found: list[Message] = []
    for verb, start in _starts(source):
        end = _end(source, start)
        span = (source.words[start].start, source.words[end - 1].end)
        whole = end > start + 1 and not any(is_quoted(word.text) for word in source.words[start:end])
        if whole and not any(overlap(span, other.span) for other in found):
            times = tuple(phrase for phrase in source.phrases if overlap(phrase.span, span))
            begin, whom = source.words[verb].start, _whom(source, verb, start)
            found.append(Message(begin, span, times, whom, _onward(source, end)))
    return tuple(found)


def orders_beside(text: str, messages: Sequence[Message]) -> Iterator[int]:
    """Give where orders begin beside what is told: "call Ann and text Bob i'm late, feed the cat"."""
    for message in messages:
        joint = JOINT.search(text[: message.verb])
        if joint is not None and joint[1]:
            yield message.verb
        if message.onward is not None:
            yield message.onward


def remarks_of(text: str, messages: Sequence[Message]) -> Iterator[Remark]:
    """Give what to say of the times in what is told."""
    for message in messages:
        for phrase in message.times:
            yield Remark.noted(text, phrase.span, "is of what is told, and not when to do it")


def _starts(source: _Source) -> Iterator[tuple[int, int]]:
    """Give the verbs that tell something, each with where that begins."""
    words, doing = source.words, source.lexicon.doing
    for place, word in enumerate(words):
        if not _is_order(source, place):
            continue
        start = None
        if word.text in doing.messaging:
            start = told_from(words, place + 1, source.ends, source.covered, source.lexicon)
        elif word.text in source.lexicon.letting:
            start = _known_from(source, place)
        elif word.text in doing.replying:
            start = _replied_from(source, place)
        else:
            start = _noted_from(source, place)
        start = _written_from(source, place) if start is None else start
        if start is not None:
            yield place, start


def _whom(source: _Source, verb: int, start: int) -> Span | None:
    """Give who is told, who is named between the verb and what is told or a time."""
    words = source.words
    end = next((place for place in range(verb + 1, start) if place in source.ends), start)
    doing = source.lexicon.doing
    named = words[verb].text in doing.messaging | doing.replying and end > verb + 1
    written = any(longest_match(words, start, (form,)) is not None for form in SAYING)
    return (words[verb + 1].start, words[end - 1].end) if named and not written else None


def _is_order(source: _Source, place: int) -> bool:
    """Whether an order may begin at a place; none of what somebody is reminded of, which says when."""
    words, doing = source.words, source.lexicon.doing
    before = words[place - 1].text if place else ","
    begins = before in doing.before_messages | ENDS | source.lexicon.addresses
    begins = begins or any(phrase.end == place for phrase in source.phrases)
    reminded = before == "to" and any(word.text in doing.recalling for word in words[:place])
    return begins and not reminded


def _known_from(source: _Source, place: int) -> int | None:
    """Give where that begins which somebody is let know: "let grandma know we'll be there by noon"."""
    words = source.words
    known = next(
        (p for p in range(place + 2, min(place + FARTHEST, len(words) - 1)) if words[p].text == "know"), None
    )
    if known is None:
        return None
    # Who is to know stands before it, so that what follows is as if it stood behind a name.
    return (
        told_from(words, known, source.ends, source.covered, source.lexicon) if _told(source, place) else None
    )


def _told(source: _Source, place: int) -> bool:
    """Whether somebody else than who speaks is told."""
    return source.words[place + 1].text not in source.lexicon.closed.speakers


def _noted_from(source: _Source, place: int) -> int | None:
    """Give where that begins which was, and is noted: "note that i took my pill at eight"."""
    words, closed = source.words, source.lexicon.closed
    form = longest_match(words, place, (tuple(form.split()) for form in source.lexicon.doing.noting))
    that = place + len(form or ())
    if form is None or that + 2 >= len(words) or words[that].text != "that":
        return None
    told = words[that + 1].text in closed.first_person
    obliged = words[that + 2].text in closed.verbs_of_obligation | closed.told_auxiliaries | closed.future
    return that if told and not obliged else None


def _written_from(source: _Source, place: int) -> int | None:
    """Give where that begins which is written: "send jim a text saying i'll be late tonight"."""
    words, letters = source.words, source.lexicon.doing.letters
    for here in range(place + 1, len(words) - 1):
        if words[here].text in ENDS:
            return None
        said = next((form for form in SAYING if longest_match(words, here, (form,)) is not None), None)
        if _says_in_letter(source, here):
            return here
        if said is not None:
            # "Send a card to say happy birthday on friday" says when to send it.
            told = said[0] != "to" or is_said(words, here + len(said), source.lexicon)
            return here if told and any(word.text in letters for word in words[place:here]) else None
    return None


def _says_in_letter(source: _Source, place: int) -> bool:
    """Whether a sentence stands right behind a letter to be written: "a message that i'll be late"."""
    words, closed = source.words, source.lexicon.closed
    article, letter = (words[p].text if p >= 0 else "" for p in (place - 2, place - 1))
    if letter not in source.lexicon.doing.letters or article not in closed.singular_determiners:
        return False
    first = place + (words[place].text == "that")
    told = words[first].text.partition("'")[0] in closed.first_person
    return told and ("'" in words[first].text or (first > place and is_said(words, first, source.lexicon)))


def _replied_from(source: _Source, place: int) -> int | None:
    """Give where that begins which is said to somebody: "reply to kate that i can't come on friday"."""
    words = source.words
    whom = place + 1 + (words[place + 1 : place + 2] != () and words[place + 1].text == "to")
    if whom < len(words) and words[whom].text == "that":
        return whom if is_said(words, whom + 1, source.lexicon) else None
    return told_from(words, whom, source.ends, source.covered, source.lexicon)


def _end(source: _Source, start: int) -> int:
    """Give where what is told ends: at the end of its sentence, at "then", a condition or an order."""
    words, lexicon = source.words, source.lexicon
    asked = words[start].text in lexicon.closed.inverted_auxiliaries
    for here in range(start + 1, len(words)):
        if here in source.covered:
            continue
        if words[here].text in ENDS or _leads_on(source, here):
            return here
        form = longest_match(words, here, lexicon.clauses) if not asked and here > start + 1 else None
        if form is not None and lexicon.clauses[form] in CONDITIONS:
            return here
    return len(words)


def _onward(source: _Source, end: int) -> int | None:
    """Give where an order begins behind what is told and a joint: ", feed the cat"."""
    words, closed = source.words, source.lexicon.closed
    if end >= len(words) or words[end].text not in closed.additions:
        return None
    while end < len(words) - 1 and words[end].text in closed.additions | closed.further_clause:
        end += 1
    return words[end].start


def _leads_on(source: _Source, place: int) -> bool:
    """Whether another order stands behind a joint: "and set the table"; not "and should be there"."""
    words, lexicon = source.words, source.lexicon
    closed = lexicon.closed
    form = longest_match(words, place, lexicon.connectives)
    if form is not None and lexicon.connectives[form] != OTHER_CASE and form[0] not in {"at", "next"}:
        return True
    verb = place + 1
    while verb < len(words) and words[verb].text in closed.further_clause | {","}:
        verb += 1
    if words[place].text not in closed.additions or verb + 1 >= len(words) or verb in source.covered:
        return False
    text, behind = words[verb].text, words[verb + 1].text
    if text in lexicon.doing.messaging:
        # "Text mike i'm late and text jo i'm early"
        return told_from(words, verb + 1, source.ends, source.covered, lexicon) is not None
    taken = lexicon.function_words | lexicon.wanting | closed.told_auxiliaries | closed.inverted_auxiliaries
    governs = behind in closed.noun_openers | closed.object_pronouns or text in lexicon.particles.get(
        behind, ()
    )
    return words[verb].is_letters and text not in taken and "'" not in text and governs
