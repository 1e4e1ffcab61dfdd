"""Two times of one thing that a sentence joins: "unlock it at 7:45 and lock it at 18:10" are of one day."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Operation, Span
from fuzzytime.language.meaning.expressions import Edge, Phrase
from fuzzytime.language.meaning.instants import halved
from fuzzytime.language.meaning.times_of_day import Clock, Half
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.references.mentions import undoes
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.language.sentence.sketches.around_events.prepared import is_on_the_way
from fuzzytime.language.sentence.sketches.sketch import Sketch, text_between
from fuzzytime.requirement import Constraint

MOMENTS = frozenset({None, Constraint.AT, Constraint.BEFORE})
"""How times bind that are clock times of what is done."""


def leads_to(sketches: Sequence[Sketch], place: int, text: str) -> Clock | None:
    """Give the clock time of what follows an instruction in its sentence, with the same thing."""
    if place + 1 >= len(sketches):
        return None
    if sketches[place + 1].part is sketches[place].part:
        # "Tomorrow feed them at six and again at five in the afternoon"
        return _settled_clock(sketches[place + 1]) if _names_day(sketches[place]) else None
    if _clock_of(sketches[place]) is None or is_on_the_way(sketches[place], sketches[place + 1]):
        return None
    if [p.span for p in sketches[place].phrases] == [p.span for p in sketches[place + 1].phrases]:
        # "Close the garage and lock it by seven": one time of both
        return None
    following = _following(sketches, place, text)
    return None if following is None else _clock_of(sketches[following])


def side_of_night(sketches: Sequence[Sketch], place: int, text: str) -> Half | None:
    """Give which side of a night it is, where it is so overnight: "lock it at ten and unlock it at six".

    The hour at which it ends is none after that at which it begins, and of a morning.
    """
    for first in range(place + 1):
        second = _following(sketches, first, text)
        if (
            second is not None
            and place in {first, second}
            and _spans_night(sketches[first], sketches[second])
        ):
            return Half.EVENING if place == first else Half.AM
    return None


def _following(sketches: Sequence[Sketch], place: int, text: str) -> int | None:
    """Give where the same sentence goes on with a thing, or undoes what is done with it."""
    return place + 1 if follows_on(sketches, place + 1, text) else _undone_at(sketches, place, text)


def _spans_night(first: Sketch, second: Sketch) -> bool:
    """Whether what is shut, or lit, is undone at an hour that is no later than its own."""
    begins, ends = _clock_of(first), _clock_of(second)
    beginning, ending = first.operation, second.operation
    if begins is None or ends is None or beginning is None or ending is None:
        return False
    lexicon = first.lexicon
    if not begins.is_open or not ends.is_open or not undoes(ending, beginning, lexicon):
        return False
    noun = (beginning.object or "").lower().rpartition(" ")[2]
    night = beginning.phrase in lexicon.doing.shutting or noun in lexicon.doing.lit
    up = lexicon.policy.ahead_from
    early = up.hour * 3600 + up.minute * 60
    return night and early <= min(ends.candidates()) <= min(begins.candidates())


def _undone_at(sketches: Sequence[Sketch], place: int, text: str) -> int | None:
    """Give where the same sentence undoes it: "unlock it at eight, hand out the keys and lock it at five"."""
    opening = sketches[place].operation
    for later in range(place + 1, len(sketches)):
        closing = sketches[later].operation
        if ENDS & set(text_between(sketches[later - 1], sketches[later], text)):
            break
        if opening is None or closing is None or closing.object != opening.object:
            continue
        if undoes(closing, opening, sketches[place].lexicon):
            return later
    return None


def follows_on(sketches: Sequence[Sketch], place: int, text: str) -> bool:
    """Whether an instruction goes on, in the same sentence, with the thing of the one before it."""
    if not 0 < place < len(sketches):
        return False
    first, second = sketches[place - 1], sketches[place]
    between = text_between(first, second, text)
    joined = first.part is not second.part and not ENDS & set(between)
    if not joined or first.operation is None or second.operation is None:
        return False
    if first.operation.stated and not first.times:
        # "Guests at seven and the roast needs two hours, so put it in at half four"
        return False
    asked, tree = second.operation, second.part.tree
    named = asked.verb != asked.lemma or (bool(tree.nodes) and tree.nodes[tree.root].tag.startswith("NN"))
    if not asked.stated and asked.name == asked.verb and named:
        # "Washing at eight, bins by ten": what is only named is a thing of its own.
        return False
    return _goes_on(first.operation, second.operation, first.lexicon)


def _goes_on(first: Operation, second: Operation, lexicon: Lexicon) -> bool:
    """Whether two operations are about the same thing, or two things that the same ones do."""
    if (first.lemma, first.particle) == (second.lemma, second.particle):
        # "One at eight and one at noon"
        return False
    if second.object is None:
        # "We open at noon and close at ten", "open the shop at noon and close at ten"; but "call mum at six
        # and swim at two"
        alone = first.object is not None and second.lemma in lexicon.needing_nothing
        return first.stated == second.stated and (not alone or undoes(second, first, lexicon))
    return second.object in lexicon.closed.all_anaphors or second.again or second.object == first.object


def _names_day(sketch: Sketch) -> bool:
    """Whether the day of a clock time is said."""
    walls = (phrase.said.wall for phrase in sketch.phrases)
    return any(wall.clock is not None and wall.days is not None for wall in walls)


def _settled_clock(sketch: Sketch) -> Clock | None:
    """Give the clock time of an instruction, where its half of the day is said."""
    for said in (phrase.said for phrase in sketch.phrases):
        if said.wall.clock is not None and said.constraint in MOMENTS:
            part = said.wall.part
            clock = said.wall.clock if part is None else halved(said.wall.clock, part.half)
            return None if clock.is_open else clock
    return None


def _clock_of(sketch: Sketch) -> Clock | None:
    """Give the clock time of an instruction that has no other time, and no day."""
    if len(sketch.phrases) != 1 or sketch.clauses:
        return None
    said = sketch.phrases[0].said
    alone = said.wall.days is None and said.wall.part is None and said.constraint in MOMENTS
    return said.wall.clock if alone else None


def on_both_sides(sketch: Sketch, words: Sequence[Word]) -> list[Sketch]:
    """Give one sketch for either side of what an instruction is to be done before and after."""
    span = _both(sketch, words)
    if span is None or sketch.operation is None:
        return [sketch]
    joint, behind = span
    phrases = tuple(_before(p, joint) if p.span[0] == behind else p for p in sketch.phrases)
    clauses = tuple(_clause_before(c, joint) if c.span[0] == behind else c for c in sketch.clauses)
    first = replace(sketch, phrases=phrases, clauses=clauses, joints=(*sketch.joints, joint))
    return [first, replace(sketch, joints=(*sketch.joints, joint))]


def _both(sketch: Sketch, words: Sequence[Word]) -> tuple[Span, int] | None:
    """Give the stretch of "before and", and where the time or clause behind begins; None for none."""
    starts = {span[0] for span in sketch.heard}
    for one, other, third in zip(words, words[1:], words[2:], strict=False):
        if [one.text, other.text, third.text] == ["before", "and", "after"] and third.start in starts:
            return (one.start, other.end), third.start
    return None


def _before(phrase: Phrase, joint: Span) -> Phrase:
    said = replace(phrase.said, constraint=Constraint.BEFORE, preposition="before", edge=Edge.START)
    return replace(phrase, said=said, span=(joint[0], phrase.span[1]))


def _clause_before(clause: Clause, joint: Span) -> Clause:
    return replace(clause, kind="before", marker="before", span=(joint[0], clause.span[1]))
