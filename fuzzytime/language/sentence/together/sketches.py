"""Instructions before they are grounded: operation, times and clauses of each part of a draft."""

from collections.abc import Collection
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Remark, RemarkKind, Span
from fuzzytime.language.meaning.expressions import (
    Duration,
    Phrase,
    Repeat,
    TimeWord,
)
from fuzzytime.language.sentence.segments.asides import Aside
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.sketches.clause_requirements import BECOMING
from fuzzytime.language.sentence.sketches.sketch import Sketch, order_of, sketch_of
from fuzzytime.language.sentence.together.again_between import again_between
from fuzzytime.language.sentence.together.at_once import at_once
from fuzzytime.language.sentence.together.both_sides import on_both_sides
from fuzzytime.language.sentence.together.days_apart import on_owned_day, on_their_days, under_first_line
from fuzzytime.language.sentence.together.first_times import from_first_time
from fuzzytime.language.sentence.together.lending import led, repeated, shared, within
from fuzzytime.language.sentence.together.said_again import (
    apart,
    done_again,
    each_of,
    is_weekday,
    with_shared_clock,
    with_shared_part,
)
from fuzzytime.language.sentence.together.turns import counted_apart
from fuzzytime.requirement import Constraint

BESIDE_MEALS = "meals.beside_meals"
"""The rule of bounds that are a list: "before breakfast, lunch and dinner"."""

LIST = 2
"""Weekdays side by side, without "and", that are hardly a list."""


def sketches_of(draft: Draft, lexicon: Lexicon) -> tuple[list[Sketch], list[Remark]]:
    """Sketch the instructions of a draft; two times joined by "and" make two of one."""
    found: list[Sketch] = []
    remarks: list[Remark] = []
    sketches = [sketch_of(draft, part, lexicon) for part in draft.parts]
    sketches = repeated(led(sketches, draft.text), draft.text, lexicon)
    told = shared(at_once(within(sketches, draft.text, lexicon), draft.text), draft.text, lexicon)
    told = under_first_line(told, draft.text)
    words = draft.scanned.words
    split = (
        counted_apart(one, words, lexicon)
        for sketch in told
        for each in each_of(sketch, draft.instances)
        for again in done_again(each, words)
        for one in on_both_sides(again, words)
    )
    for offered in split:
        whole, later = _first_offered(offered, draft.text)
        remarks += (_not_used(draft.text, span) for span in later)
        for phrases, dropped in _alternatives(draft, whole.phrases):
            spans = [phrase.span for phrase in whole.phrases]
            kept = [spans.index(phrase.span) for phrase in phrases]
            found.append(replace(whole, phrases=phrases, references=tuple(whole.references[k] for k in kept)))
            for phrase in dropped:
                remarks.append(_not_used(draft.text, phrase.span))
    found = [on_owned_day(_ordered(sketch, draft), lexicon) for sketch in again_between(found)]
    placed = on_their_days(found, draft.text, draft.heading)
    return _with_asides([from_first_time(sketch, words) for sketch in placed], draft), remarks


def _ordered(sketch: Sketch, draft: Draft) -> Sketch:
    """Give what is to be done its place among others; what happens has none."""
    operation, order = sketch.operation, order_of(draft, sketch.part)
    if operation is None or order is None or operation.stated:
        return sketch
    return replace(sketch, operation=replace(operation, order=order))


def _with_asides(sketches: list[Sketch], draft: Draft) -> list[Sketch]:
    """Give each length that an aside says to the clause before it, or else to what is to be done."""
    found = list(sketches)
    for aside in draft.asides:
        before = [sketch.part for sketch in found if sketch.part.segment.span[0] < aside.span[0]]
        if len(before) > 1 and _is_repeated(found[len(before) - 1]):
            # "Put the sausages on, turn them every 4 minutes, they take 15 minutes"
            before.pop()
        for place, sketch in enumerate(found):
            if before and sketch.part is before[-1]:
                segment = sketch.part.segment
                span = (segment.span[0], max(segment.span[1], aside.span[1]))
                part = replace(sketch.part, segment=replace(segment, span=span))
                found[place] = replace(_with_aside(sketch, aside, draft.scanned.text), part=part)
    return found


def _is_repeated(sketch: Sketch) -> bool:
    return any(isinstance(phrase.said.time, Repeat) for phrase in sketch.phrases)


def _with_aside(sketch: Sketch, aside: Aside, text: str) -> Sketch:
    if aside.way:
        return replace(
            sketch, way=aside.length.said.time if isinstance(aside.length.said.time, Duration) else None
        )
    clauses = list(sketch.clauses)
    for place, clause in enumerate(clauses):
        beside = clause.span[1] <= aside.span[0] and not text[clause.span[1] : aside.span[0]].strip()
        if (
            beside
            and clause.kind in BECOMING
            and clause.condition
            and isinstance(aside.length.said.time, Duration)
        ):
            clauses[place] = replace(clause, takes=aside.length.said.time)
            return replace(sketch, clauses=tuple(clauses))
    lasting = replace(aside.length, said=replace(aside.length.said, constraint=Constraint.FOR))
    return replace(sketch, phrases=(*sketch.phrases, lasting), references=(*sketch.references, None))


def _not_used(text: str, span: Span) -> Remark:
    message = f"{text[slice(*span)]!r} is not used: of times joined by 'or', the first is taken"
    return Remark(RemarkKind.POLICY, span, message)


def _first_offered(sketch: Sketch, text: str) -> tuple[Sketch, list[Span]]:
    """Leave out clauses, and times behind one, that "or" joins to what is said before; give those left out.

    "For ten minutes or until tender" says both: it is about as long as that.
    """
    lasting = {p.span for p in sketch.phrases if p.said.constraint is Constraint.FOR}
    clauses = {clause.span for clause in sketch.clauses}
    moments = {p.span for p in sketch.phrases if p.said.constraint in {None, Constraint.AT}}
    left = [
        second
        for first, second in pairwise(sorted(sketch.heard))
        if text[first[1] : second[0]].strip(" ,").lower() in sketch.part.tree.lexicon.closed.alternatives
        and ((first in lasting and second in moments) or _is_other(first, second, lasting, clauses))
    ]
    phrases = [place for place, phrase in enumerate(sketch.phrases) if phrase.span not in left]
    kept = replace(
        sketch,
        phrases=tuple(sketch.phrases[place] for place in phrases),
        references=tuple(sketch.references[place] for place in phrases),
        clauses=tuple(clause for clause in sketch.clauses if clause.span not in left),
    )
    return kept, left


def _is_other(first: Span, second: Span, lasting: Collection[Span], clauses: Collection[Span]) -> bool:
    """Whether a time or a clause stands for another: no length does that a clause ends."""
    return first not in lasting and (first in clauses or second in clauses)


def _alternatives(
    draft: Draft, phrases: tuple[Phrase, ...]
) -> list[tuple[tuple[Phrase, ...], tuple[Phrase, ...]]]:
    """Give the times of each instruction that is meant, with those that are left out.

    "At seven and at six" asks for two, "at seven or at eight" for one; "tomorrow, by noon" is one time.
    """
    lexicon = draft.scanned.lexicon
    closed = lexicon.closed
    joining = closed.additions | closed.alternatives
    for place in range(len(phrases) - 1):
        group = [phrases[place]]
        joints: set[str] = set()
        for following in phrases[place + 1 :]:
            between = {word.text for word in draft.scanned.words[group[-1].end : following.first]}
            if between & {"otherwise", "else"}:
                between -= lexicon.beside.courteous
            if "failing" in between:
                # "At noon or, failing that, at two"
                between -= closed.singular_anaphors
            if between <= {"/"} and is_weekday(group[-1]) and is_weekday(following):
                # "Monday wednesday and friday", as it is said; "mon/wed/fri"
                between = {","}
            if not between or between - joining or not (_is_when(group[-1]) and _is_when(following)):
                break
            group.append(following)
            joints |= between
        several = len(group) > LIST and all(map(is_weekday, group))
        if len(group) > 1 and (several or joints & joining - {","}):
            rest = tuple(phrase for phrase in phrases if phrase not in group)
            if joints & closed.alternatives:
                return [((*rest, group[0]), tuple(group[1:]))]
            times = with_shared_clock(with_shared_part(apart(group), draft.scanned.words))
            return [(tuple(sorted((*rest, one), key=lambda phrase: phrase.span)), ()) for one in times]
    return [(phrases, ())]


def _is_when(phrase: Phrase) -> bool:
    """Whether it is a time at which something may be done, and not a bound, a length or a repetition."""
    said = phrase.said
    if phrase.rule == BESIDE_MEALS:
        return True
    if isinstance(said.time, TimeWord):
        return (said.constraint or said.time.constraint) is Constraint.AT
    if isinstance(said.time, Duration):
        return said.constraint is Constraint.AT
    return said.constraint in {None, Constraint.AT, Constraint.BETWEEN} and not isinstance(said.time, Repeat)
