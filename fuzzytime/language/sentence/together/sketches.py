"""Instructions before they are grounded: operation, times and clauses of each part of a draft."""

from dataclasses import replace

from fuzzytime.language.instruction import Remark
from fuzzytime.language.meaning.expressions import Duration
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.told.asides import Aside
from fuzzytime.language.sentence.sketches.around_events.at_events import without_moments
from fuzzytime.language.sentence.sketches.around_events.clause_requirements import BECOMING
from fuzzytime.language.sentence.sketches.meaning.alternatives import not_used
from fuzzytime.language.sentence.sketches.meaning.times_of_cases import without_times_of_cases
from fuzzytime.language.sentence.sketches.sketch import Sketch, order_of, sketch_of
from fuzzytime.language.sentence.together.days.below_headings import under_first_line, under_heading
from fuzzytime.language.sentence.together.days.day_by_day import day_by_day, each_day_too
from fuzzytime.language.sentence.together.days.days_apart import on_owned_day, on_their_days
from fuzzytime.language.sentence.together.days.days_left_out import left_out_behind, without_days_left_out
from fuzzytime.language.sentence.together.days.days_on import days_on
from fuzzytime.language.sentence.together.days.each_week import each_week
from fuzzytime.language.sentence.together.days.listed_days import heads_list, things_alone
from fuzzytime.language.sentence.together.lent.lending import led, repeated, shared, within
from fuzzytime.language.sentence.together.none_of_it.after_all import after_all
from fuzzytime.language.sentence.together.none_of_it.named_whole import sketch_of_entry
from fuzzytime.language.sentence.together.times.again_between import again_between
from fuzzytime.language.sentence.together.times.at_once import at_once
from fuzzytime.language.sentence.together.times.choices_of_repetitions import first_of_choices
from fuzzytime.language.sentence.together.times.first_offered import first_offered
from fuzzytime.language.sentence.together.times.first_times import from_first_time
from fuzzytime.language.sentence.together.times.one_by_one import one_by_one
from fuzzytime.language.sentence.together.times.pairs import on_both_sides
from fuzzytime.language.sentence.together.times.said_again import done_again, each_of
from fuzzytime.language.sentence.together.times.several_times import (
    also_at_events,
    of_one_event,
    of_several_times,
)
from fuzzytime.language.sentence.together.times.turns import counted_apart
from fuzzytime.language.sentence.together.told.ends_told import done_by, prepared_for
from fuzzytime.language.sentence.together.told.opening_hours import within_opening_hours
from fuzzytime.language.sentence.together.told.reasons_told import due_before_told
from fuzzytime.language.sentence.together.told.told_beside import from_then_on, steps_in_turn, told_beside
from fuzzytime.requirement import MOMENTS, Constraint, Reference


def sketches_of(draft: Draft) -> tuple[list[Sketch], list[Remark]]:
    """Sketch the instructions of a draft; two times joined by "and" make two of one."""
    if draft.entry is not None:
        return [under_heading(sketch_of_entry(draft, draft.entry), draft.heading)], []
    found: list[Sketch] = []
    remarks: list[Remark] = []
    sketches, corrections = after_all([sketch_of(draft, part) for part in draft.parts], draft)
    remarks += corrections
    sketches = left_out_behind(sketches)
    # Where steps were told apart there is a stop.
    apart = draft.scanned.text
    sketches = done_by(told_beside(sketches, draft.text), draft.text)
    sketches = within_opening_hours(sketches, draft.text)
    sketches = due_before_told(sketches, draft.text)
    sketches = [without_times_of_cases(sketch, draft.text) for sketch in led(sketches, draft.text)]
    sketches = repeated(sketches, draft.text)
    told = shared(at_once(within(sketches, apart), draft.text), draft.text)
    words = draft.scanned.words
    told = [without_days_left_out(sketch) for sketch in under_first_line(told, draft.text)]
    told = [day_by_day(each_day_too(sketch, words), draft.text) for sketch in told]
    told = days_on(told, draft.text)
    split = (
        one_by_one(counted_apart(one, words), words)
        for sketch in told
        for each in each_of(sketch, draft.instances)
        for again in done_again(each, words)
        for one in on_both_sides(again, words)
    )
    for one in split:
        whole, remarked = first_offered(one, draft.text)
        whole, others = first_of_choices(whole, words)
        remarks += (*remarked, *(not_used(draft.text, span) for span in others))
        for again in also_at_events(whole, words):
            found += of_several_times(without_moments(again, words, draft.text), words)
    found = [on_owned_day(_ordered(sketch, draft)) for sketch in again_between(of_one_event(found))]
    headed = draft.heading is not None and draft.heading.day is not None
    found = from_then_on(each_week(found, draft.text), draft.text, apart)
    found = things_alone(found, draft, apart, headed=headed)
    found = [_ordered(sketch, draft) for sketch in found]
    # "Morning: gym, shower" has its steps in any order.
    if ": " not in draft.text and not (found and heads_list(found[0], draft.text)):
        found = steps_in_turn(found, draft.text, apart)
    placed = on_their_days(found, draft)
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
        if len(before) > 1 and found[len(before) - 1].repeats:
            # "Put the sausages on, turn them every 4 minutes, they take 15 minutes"
            before.pop()
        said = [_said_by(aside, one, draft) if before and one.part is before[-1] else [one] for one in found]
        found = [sketch for several in said for sketch in several]
    return found


def _said_by(aside: Aside, sketch: Sketch, draft: Draft) -> list[Sketch]:
    """Give what an aside says of a sketch, up to its end."""
    segment = sketch.part.segment
    span = (segment.span[0], max(segment.span[1], aside.span[1]))
    part = replace(sketch.part, segment=replace(segment, span=span))
    told = prepared_for(sketch, aside) or [_with_aside(sketch, aside, draft.scanned.text)]
    return [replace(one, part=part) for one in told]


def _with_aside(sketch: Sketch, aside: Aside, text: str) -> Sketch:
    if aside.bounds and aside.length.said.constraint in MOMENTS and sketch.times:
        # "Text Sam, who lands at ten, at noon"
        return replace(sketch, named=(*sketch.named, aside.length))
    if aside.bounds:
        return sketch.also(aside.length, about=Reference.FINISH if aside.done else None)
    if aside.way:
        return replace(
            sketch, way=aside.length.said.time if isinstance(aside.length.said.time, Duration) else None
        )
    clauses = list(sketch.clauses)
    for place, clause in enumerate(() if _is_of_what_is_begun(sketch, aside) else clauses):
        beside = clause.span[1] <= aside.span[0] and not text[clause.span[1] : aside.span[0]].strip()
        if (
            beside
            and clause.kind in BECOMING
            and clause.condition
            and not clause.is_through(sketch.lexicon)
            and isinstance(aside.length.said.time, Duration)
        ):
            clauses[place] = replace(clause, takes=aside.length.said.time)
            return replace(sketch, clauses=tuple(clauses))
    return sketch.also(replace(aside.length, said=replace(aside.length.said, constraint=Constraint.FOR)))


def _is_of_what_is_begun(sketch: Sketch, aside: Aside) -> bool:
    """Whether a length is that of what is begun, whenever that is: "start it once I'm up, it takes an hour".

    "…, which takes an hour" is what stands before it, and "paint it once that is dry, it takes an hour" also.
    """
    doing, operation = sketch.lexicon.doing, sketch.operation
    begun = operation is not None and operation.lemma in doing.beginning | doing.putting
    return aside.left or (begun and not aside.relative)
