"""Numbers that are taken for how many or how much, and for no hour: "dinner for seven", "raise it by two"."""

import re
from collections.abc import Iterator, Sequence
from itertools import dropwhile

from fuzzytime.english import looks_plural
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.surroundings.measuring import AMOUNTED
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Operation, Remark, RemarkKind, Span, overlap
from fuzzytime.language.meaning.expressions import Duration
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.sketches.sketch import Sketch

HOURS = 12
"""The last hour of a clock: a larger number is none."""

BINDING = frozenset({"at", "by", "before", "after"})
"""Prepositions before an hour."""

AT_END = re.compile(
    r"\b(?P<noun>[^\W\d]+) (?P<number>(?:1[0-2]|[1-9])(?:\.[0-5]\d)?|(?:[01]\d|2[0-3])[0-5]\d)\W*$"
)
"""A number that may be an hour behind the thing that ends what is said."""

TYPED = re.compile(r"(?<=[\s(])(?:0?[1-9]|1\d|2[0-3])\.[0-5][05](?=\s|$|[,;)])")
"""A number that may be an hour with its minutes, by which people plan."""


def counted(draft: Draft, sketch: Sketch) -> Iterator[Remark]:
    """Say how the last numbers of an order without a time are taken: they may be meant as its hours."""
    text, (first, end) = draft.text, sketch.part.segment.span
    said = [word for word in draft.scanned.words if first <= word.start < end and word.text.isalnum()]
    # "Hoover, dust and mop from nine": that is when the first of them begins.
    said = [word for word in said if not any(overlap((word.start, word.end), one) for one in sketch.joints)]
    lengths = all(isinstance(phrase.said.time, Duration) for phrase in sketch.phrases)
    if sketch.clauses or not lengths:
        return
    joint = _joint(said, sketch.lexicon)
    at_end = None if joint or sketch.phrases else _number_at_end(text, sketch, said)
    if (span := at_end or _typed_inside(text, sketch, said)) is not None:
        number = text[slice(*span)]
        yield Remark(
            RemarkKind.POLICY, span, f"{number!r} is not taken as a time: say 'at {number}' if it is"
        )
    if not joint and (bound := _bound_inside(draft, said)) is not None:
        hour = f"{text[slice(*bound)]} o'clock"
        yield Remark.noted(text, bound, f"is not taken as a time: say {hour!r} if it is")
    if not joint or sketch.phrases or (joint == 1 and said[joint].text == "for"):
        # "Table for seven"
        return
    number = said[-1].text
    people = "how many it is for", f"at {number}"
    how, meant = people if said[joint].text == "for" else ("how much", f"{number} o'clock")
    span = (said[joint].start, said[-1].end)
    yield Remark.noted(text, span, f"is taken for {how}: say {meant!r} for a time")


def _joint(said: Sequence[Word], lexicon: Lexicon) -> int:
    """Give the place of the preposition before the hours that end what is said; 0 where there is none."""
    if not said or not _is_hour(said[-1], lexicon):
        return 0
    place = len(said) - 1
    while place and (
        _is_hour(said[place], lexicon) or said[place].text in lexicon.closed.range_joints_or_and
    ):
        place -= 1
    return place if said[place].text in AMOUNTED | {"for"} else 0


def _number_at_end(text: str, sketch: Sketch, said: Sequence[Word]) -> Span | None:
    """Give where an hour ends what is said that no thing is called by: "milk 10", but "read chapter 4"."""
    lexicon = sketch.lexicon
    kinds, polite = lexicon.no_times, lexicon.beside.polite_ends
    asked = [*dropwhile(lambda word: word.text in polite, reversed(said))]
    found = AT_END.search(text[: asked[0].end], asked[-1].start) if asked else None
    verb = "" if sketch.operation is None else sketch.operation.verb
    if found is None or found["noun"] == verb or verb in kinds.versioning:
        return None
    noun = found["noun"].lower()
    # "Do it 1830"
    plain = lexicon.function_words - lexicon.closed.it_or_them
    called = noun in lexicon.called_by_number | plain | kinds.codes
    # "Update Windows 11"; but "Water The Plants 7.30"
    named = found["noun"] != noun and found.start() > asked[-1].start
    named = named and not any(word.capital and word.text in lexicon.function_words for word in asked[:-1])
    return None if called or named else found.span("number")


def _typed_inside(text: str, sketch: Sketch, said: Sequence[Word]) -> Span | None:
    """Give where a number like an hour stands that nothing is called, or set to: "heating on 6.30"."""
    lexicon, kinds = sketch.lexicon, sketch.lexicon.no_times
    called = lexicon.called_by_number | kinds.set_to | kinds.costing | kinds.versioning
    called |= lexicon.function_words - lexicon.beside.states
    for found in TYPED.finditer(text, *sketch.part.segment.span):
        before = [word.text for word in said if word.end <= found.start()][-1:]
        behind = [word.text for word in said if word.start >= found.end()][:1]
        covered = any(overlap(span, found.span()) for span in (*sketch.heard, *sketch.joints))
        counts = any(looks_plural(one) or lexicon.means(one, "unit") for one in behind)
        counts = counts or not kinds.measured_in.isdisjoint(behind)
        if before and called.isdisjoint(before) and not covered and not counts:
            return found.span()
    return None


def _bound_inside(draft: Draft, said: Sequence[Word]) -> Span | None:
    """Give where an hour is bound in front of a word that it does not count: "call mum at six dressed"."""
    lexicon, measured = draft.lexicon, draft.lexicon.no_times.measured_in
    ones = lexicon.closed.singular_determiners
    for place in range(1, len(said) - 2):
        before, bound, number, *behind = said[place - 1 : place + 4]
        span = (bound.start, number.end)
        hour = bound.text in BINDING and _is_hour(number, lexicon) and number.text not in ones
        # "A 10 by 12 frame", "at six meeting points", "by ten percent"
        counts = _is_hour(before, lexicon) or any(looks_plural(word.text) for word in behind)
        counts = counts or behind[0].text in measured or lexicon.means(behind[0].text, "unit")
        # What is done again may be another part, with times of its own.
        covered = any(overlap(phrase.span, span) for phrase in draft.phrases)
        if hour and not counts and not covered and behind[0].is_letters and not behind[0].capital:
            return span
    return None


def _is_hour(word: Word, lexicon: Lexicon) -> bool:
    """Whether a word is a number that may be an hour."""
    number = int(word.text) if word.is_digits else lexicon.numbers.get(word.text)
    return number is not None and 0 < number <= HOURS


def uncounted(text: str, part: Part, operation: Operation) -> Iterator[Remark]:
    """Point at a number of which nothing says what it counts: "plank 10"; but "play 7" names one."""
    lexicon = part.lexicon
    lasting = lexicon.timing | lexicon.timing_alone | lexicon.intransitive | lexicon.lasting
    # "Call 911"
    lasting -= lexicon.addressing
    acts = any(node.lower == operation.verb and node.may_act for node in part.tree.nodes)
    number = (operation.object or "").lower()
    if (number.isdigit() or number in lexicon.numbers) and (operation.lemma in lasting or not acts):
        place = text.lower().find(number, part.segment.span[0])
        span = (place, place + len(number))
        message = f"{text[slice(*span)]!r}: what it counts is not said, as in 'for {number} minutes'"
        yield Remark(RemarkKind.NOT_UNDERSTOOD, span, message)
