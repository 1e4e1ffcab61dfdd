"""What the times, the clauses and the events of a sketch require of an instruction."""

from collections.abc import Iterator
from dataclasses import replace

from fuzzytime.language.finding import Times
from fuzzytime.language.instruction import Remark
from fuzzytime.language.meaning.joined.first_times import opening_of
from fuzzytime.language.sentence.clauses.before_markers import OF
from fuzzytime.language.sentence.references.anchors import Anchors
from fuzzytime.language.sentence.references.each_time import each_time
from fuzzytime.language.sentence.references.phrase_anchors import (
    ORDERING,
    counts_from_nothing,
    of_nothing,
    of_phrase,
    of_the_beginning,
)
from fuzzytime.language.sentence.references.several import of_several, one_is_enough, only_one
from fuzzytime.language.sentence.segments.connectives import agreeing, follows_nothing, within_after
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.heading import HEADED
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.language.sentence.sketches.around_events.at_events import at_events
from fuzzytime.language.sentence.sketches.around_events.clause_requirements import of_clause, referred
from fuzzytime.language.sentence.sketches.around_events.in_turns import in_turns
from fuzzytime.language.sentence.sketches.meaning.both_sides import BOTH_SIDES
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import Anchor, TimeRequirement


def required_of(
    sketch: Sketch, times: Times, anchors: Anchors, connected: TimeRequirement | None, draft: Draft
) -> tuple[list[TimeRequirement], list[Remark]]:
    """Give what is required of an instruction, in the order of the words, and what is pointed at.

    ``connected`` is what the word requires that joins it to another: "then".
    """
    requirements, remarks = _of_phrases(sketch, times, anchors, draft)
    for clause in sketch.clauses:
        several = of_several(clause, anchors, draft.text)
        if several:
            requirements += [referred(one, sketch.reference) for one in several]
            continue
        required, told = of_clause(clause, anchors, sketch, draft)
        repeated = any(requirement.recurrence is not None for requirement in requirements)
        if clause.marker == OF and not repeated and _ends_then(required.anchor, anchors):
            # "In the last half hour of the shift", of which it is told when it ends.
            continue
        requirements.append(replace(required, alternative=clause.alternative))
        remarks += told
        if one_is_enough(clause, anchors, draft.text) and (required.anchor is not None or not clause.further):
            # Of what must be so, readings tell either: "when the pan is hot or the oven is hot"
            remarks.append(only_one(clause, draft.text))
    for events, told in (
        at_events(sketch, draft.scanned.words, draft.text, anchors),
        in_turns(sketch, anchors, draft),
    ):
        requirements += events
        remarks += told
    for required, told in _headed(sketch, anchors, draft):
        requirements.append(required)
        remarks += told
    connected = agreeing(connected, requirements)
    if connected is not None:
        requirements.append(connected)
    joined = not ENDS & set(draft.text[draft.parts[0].segment.span[0] : sketch.part.segment.span[0]])
    requirements = each_time(within_after(requirements), anchors, joined=joined)
    requirements.sort(key=lambda requirement: requirement.span)
    return requirements, remarks


def _ends_then(anchor: Anchor | None, anchors: Anchors) -> bool:
    """Whether all that is told of what words name is when it is over: "the shift ends at seven"."""
    told = None if anchor is None or anchor.target is None else anchors.operation_at(anchor.target)
    return told is not None and told.stated and told.lemma in anchors.lexicon.doing.ending


def _of_phrases(
    sketch: Sketch, times: Times, anchors: Anchors, draft: Draft
) -> tuple[list[TimeRequirement], list[Remark]]:
    """Give what a sketch's times require, each about the end of it that its verb or its words name."""
    said = {
        phrase.span: (phrase, reference)
        for phrase, reference in zip(sketch.phrases, sketch.references, strict=True)
    }
    requirements: list[TimeRequirement] = []
    remarks: list[Remark] = []
    lasts = any(grounded.duration is not None for grounded in times.found)
    waits = any(clause.marker == OF for clause in sketch.clauses)
    for grounded in times.found:
        requirement = grounded.requirement
        phrase, reference = said[requirement.span]
        if lasts and opening_of(phrase.said) is not None:
            remarks.append(of_the_beginning(requirement))
            continue
        if phrase.rule == HEADED and draft.heading is not None:
            requirement = replace(requirement, text=draft.heading.name)
        requirement = replace(requirement, denied=requirement.denied or phrase.rule == BOTH_SIDES)
        if phrase.said.alternative and sketch.clauses:
            # "When the tank is full, or at noon"
            requirement = replace(requirement, alternative=True)
        requirement = of_phrase(anchors, phrase, requirement, sketch.clauses)
        requirements.append(referred(requirement, reference))
        if not waits and counts_from_nothing(requirement, phrase.said, sketch.operation, anchors.position):
            remarks.append(of_nothing(requirement, phrase.said))
        if requirement.word in ORDERING:
            remarks.append(follows_nothing(requirement.text, requirement.span))
    return requirements, remarks


def _headed(sketch: Sketch, anchors: Anchors, draft: Draft) -> Iterator[tuple[TimeRequirement, list[Remark]]]:
    """Give what the clauses of a line above require of an instruction."""
    heading = draft.heading
    if heading is None:
        return
    above = replace(draft, text=heading.text, scanned=heading.scanned)
    for clause in sketch.headed:
        required, remarks = of_clause(clause, anchors, sketch, above)
        span = sketch.part.segment.span
        yield replace(required, span=(0, 0)), [replace(remark, span=span) for remark in remarks]
