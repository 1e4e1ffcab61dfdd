"""What the clauses of an instruction require: that something is so, or is done, before it or after it."""

from collections.abc import Iterator
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation, Remark, RemarkKind
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.clauses.comparisons import comparisons_in
from fuzzytime.language.sentence.references.anchors import Anchors
from fuzzytime.language.sentence.references.left_inside import edge_inside, left_inside
from fuzzytime.language.sentence.references.meals import meal_of
from fuzzytime.language.sentence.references.several import every_one, names_each
from fuzzytime.language.sentence.references.stays import stay_of
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.sketches.around_events.at_events import untold
from fuzzytime.language.sentence.sketches.meaning.pronouns import resolved_object
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.language.sentence.trees.named import is_several
from fuzzytime.requirement import Condition, Constraint, Edge, Reference, TimeRequirement

RESULTING = frozenset({"when", "if", "after"})
"""Clauses about what another instruction does: "when it is done"; "until it is done" is about its own."""

STATING = frozenset({"when", "if", "until", "while"})
"""Clauses that may say what must be so."""

BECOMING = frozenset({"when", "after"})
"""Clauses that wait for what becomes so: how long that takes is no length of what is to be done."""

LASTING = frozenset({"until", "through"})


def of_clause(
    clause: Clause, anchors: Anchors, sketch: Sketch, draft: Draft
) -> tuple[TimeRequirement, list[Remark]]:
    """Give what a clause requires: a condition, or where another instruction lies; and remarks on it."""
    text = draft.text[slice(*clause.span)]
    remarks: list[Remark] = []
    numbers = comparisons_in(draft.scanned, clause.content, bare=clause.kind == "until")
    what = draft.text[slice(*clause.content)]
    target = anchors.target_of(clause)
    if target is None and (target := anchors.called(what)) is not None:
        clause = replace(clause, verb=None, object=what, condition=None, is_event=True)
    said = clause.condition
    if said is not None and said.contrary:
        # "If the pan is hot fry it, otherwise wait": the words that say so are others.
        required = _of_condition(clause, replace(said, comparisons=numbers), anchors, sketch)
        return replace(required, text=text), []
    if target is None and said and said.word in anchors.lexicon.results and clause.kind in RESULTING:
        # "Boil the pasta. Drain it when it is done": when it is boiled.
        named = _named(said, _meant_by_pronoun(clause, anchors, sketch), anchors.lexicon)
        target = anchors.target_of(replace(clause, condition=named))
    each = every_one(clause, anchors) if names_each(clause, anchors) else ()
    # "After each one", of what was said last
    target = next(iter(each), None) if target is None else target
    target = meal_of(clause, anchors) if target is None else target
    target = _begun(clause, anchors, sketch) if target is None else target
    if target is None and (target := left_inside(clause, anchors)) is not None:
        clause = replace(clause, edge=edge_inside(clause, anchors))
    if target is None and (stay := stay_of(clause, anchors)) is not None:
        target, edge = stay
        clause = replace(clause, edge=edge)
    if target is None and said is not None and clause.kind in STATING:
        condition = replace(said, text=text, comparisons=numbers)
        required = _of_condition(clause, condition, anchors, sketch)
        return required, list(_once_or_at_start(clause, required, sketch.operation, anchors.lexicon))
    if target is None:
        subject = None if said is None else said.subject
        speaks = subject in anchors.lexicon.closed.first_and_second_person
        if clause.is_event or (subject is not None and not speaks):
            remarks.append(untold(text, clause.span))
        else:
            message = f"{text!r} refers to {what!r}, and no instruction so far is about that"
            remarks.append(Remark(RemarkKind.UNRESOLVED, clause.span, message))
    counted = clause if target is None else clause.since_begun()
    requirement = anchors.of_clause(counted, text, what, target)
    if clause.reference is Reference.FINISH and target is not None:
        requirement = _ending(requirement, clause, anchors)
    if target is not None and requirement.anchor is not None and each:
        requirement = replace(requirement, anchor=replace(requirement.anchor, each=each))
    if target is None and requirement.anchor is not None:
        requirement = replace(requirement, anchor=replace(requirement.anchor, comparisons=numbers))
    return referred(requirement, sketch.reference), remarks


def _once_or_at_start(
    clause: Clause, required: TimeRequirement, operation: Operation | None, lexicon: Lexicon
) -> Iterator[Remark]:
    """Say of what may be so again, or for long, that only its first time, or its start, is planned."""
    begun = required.condition is not None and required.condition.about is not None
    goes_on = operation is not None and lexicon.indicators.get(operation.lemma) == Reference.THROUGHOUT
    stays = clause.kind == "while" and goes_on and not begun
    if clause.marker in lexicon.beside.each_time:
        message = f"{required.text!r} is planned once: how often that is so is not known"
        yield Remark(RemarkKind.POLICY, clause.span, message)
    elif stays or clause.marker in lexicon.beside.as_long_as_it_is:
        message = f"{required.text!r} says when to start: until when that is so is not known"
        yield Remark(RemarkKind.POLICY, clause.span, message)


def _begun(clause: Clause, anchors: Anchors, sketch: Sketch) -> int | None:
    """Give what set going what has gone on for so long: "start it, and stop it when it has run for an hour".

    What has been in a state for so long waits for that state: "when the pan has been hot for two minutes".
    """
    doing = anchors.lexicon.doing
    if (
        clause.gone_on is None
        or clause.condition is None
        or clause.verb in doing.being - doing.being_or_doing
    ):
        return None
    named = _named(clause.condition, _meant_by_pronoun(clause, anchors, sketch), anchors.lexicon)
    return anchors.done_with(named.subject)


def _ending(requirement: TimeRequirement, clause: Clause, anchors: Anchors) -> TimeRequirement:
    """Let what is to be done be over when another begins, or is done: "have it ready when they come"."""
    anchor = requirement.anchor
    if anchor is None:
        return requirement
    if clause.kind in RESULTING and clause.distance is None and anchor.target is not None:
        word = None if clause.condition is None else clause.condition.word
        ends = anchor.edge is Edge.END and (
            word in anchors.lexicon.results or not anchors.is_asked(anchor.target)
        )
        anchor = replace(anchor, edge=Edge.END if ends else Edge.START, exact=True)
        requirement = replace(requirement, constraint=Constraint.BEFORE, anchor=anchor)
    return (
        replace(requirement, reference=Reference.FINISH, reference_said=True) if anchor.exact else requirement
    )


def _of_condition(clause: Clause, said: Condition, anchors: Anchors, sketch: Sketch) -> TimeRequirement:
    """Give the requirement that something is so, which another instruction may bring about."""
    condition = _named(said, _meant_by_pronoun(clause, anchors, sketch), anchors.lexicon)
    if clause.kind in RESULTING and not condition.negated:
        # "Warm up the printer. Once it is warm, print"
        made = replace(clause, verb=condition.word, object=condition.subject, condition=None)
        condition = replace(condition, target=anchors.target_of(made))
        if clause.kind in BECOMING and clause.verb not in anchors.lexicon.doing.arriving:
            # "Paint the door. Once the paint is dry, which takes two hours, sand it"
            takes = None if clause.takes is None else clause.takes.seconds
            about = anchors.done_with(condition.subject)
            if about is None and condition.subject in anchors.lexicon.closed.anaphors:
                about = anchors.done_with_it(condition.subject)
            of_weather = said.word in anchors.lexicon.impersonal
            if about is None and said.subject in anchors.lexicon.closed.anaphors and not of_weather:
                # "Sand the shelf. First coat of paint once it's dust free": nothing was done with the paint.
                earlier = _said_before(said.subject, anchors, sketch)
                about = anchors.done_with(earlier)
                condition = condition if about is None else _named(said, earlier, anchors.lexicon)
            if clause.verb is None and said.comparisons and not _is_brought_to_level(about, anchors):
                # "Order the cake. At 60 degrees add the yeast": no cake gets there.
                about = None
            condition = replace(condition, about=about, takes=takes)
    elif clause.kind == "while" and not condition.negated:
        condition = replace(condition, about=_under_way(said, condition, anchors), goes_on=True)
    return TimeRequirement(
        text=said.text,
        span=clause.span,
        constraint=Constraint.WHEN,
        preposition=clause.marker,
        condition=condition,
        reference=Reference.FINISH if clause.kind == "until" else Reference.START,
    )


def _is_brought_to_level(target: int | None, anchors: Anchors) -> bool:
    """Whether an instruction changes what is measured of a thing: "heat the milk"."""
    operation = None if target is None else anchors.operation_at(target)
    lexicon = anchors.lexicon
    brings = lexicon.measure_verbs | lexicon.timing | lexicon.doing.to_levels
    return operation is not None and operation.lemma in brings


def _under_way(said: Condition, condition: Condition, anchors: Anchors) -> int | None:
    """Give the instruction that sets going what a clause says: "put it in the oven, … while it bakes"."""
    about = anchors.done_with(condition.subject)
    if about is not None or said.subject not in anchors.lexicon.closed.singular_anaphors:
        return about
    putting = anchors.lexicon.doing.putting
    left = (place for place, one in anchors.just_before() if one.lemma in putting and one.is_asked)
    return next(left, None)


def referred(requirement: TimeRequirement, reference: Reference | None) -> TimeRequirement:
    """Give a requirement the moment of the execution that its verb is about."""
    if reference is None or requirement.constraint in {Constraint.FOR, Constraint.EVERY, Constraint.WHEN}:
        return requirement
    lasting = requirement.preposition in LASTING or requirement.constraint is Constraint.BETWEEN
    if reference is Reference.THROUGHOUT and not lasting:
        return requirement
    anchor = requirement.anchor
    together = requirement.constraint is Constraint.AT and anchor is not None and anchor.edge is Edge.START
    if anchor is not None and together and reference is Reference.FINISH:
        # "Start the rice so it's done at the same time": as the other is.
        requirement = replace(requirement, anchor=replace(anchor, edge=Edge.END, exact=True))
    return replace(requirement, reference=reference, reference_said=True)


def _meant_by_pronoun(clause: Clause, anchors: Anchors, sketch: Sketch) -> str | None:
    """Give what a pronoun in a clause stands for: in front of the verb, it is something said before.

    "Warm the milk and, once it is warm, add the yeast": the milk.
    """
    operation = sketch.operation
    if operation is not None and clause.span[0] < operation.span[0] and clause.condition is not None:
        earlier = _said_before(clause.condition.subject, anchors, sketch)
        before = anchors.operation_at(anchors.position - 1) if anchors.position else None
        if earlier is not None and (
            earlier.lower() not in anchors.lexicon.closed.anaphors or earlier == (before and before.object)
        ):
            # "Let it run; as soon as it stops, check the oil": nothing names it, but it is the same.
            return earlier
    if operation is None:
        return None
    if _are_others(clause, operation.object, anchors.lexicon):
        # "Feed the cows, then mop the barn while they are outside"
        earlier = _said_before("them", anchors, sketch)
        known = earlier is not None and earlier.lower() not in anchors.lexicon.closed.anaphors
        return earlier if known and is_several(earlier or "", anchors.lexicon) else None
    person = not anchors.lexicon.persons.isdisjoint((operation.object or "").lower().split())
    # "Move mum to the other room once it is clean"
    return operation.place if person and operation.place else operation.object


def _said_before(pronoun: str | None, anchors: Anchors, sketch: Sketch) -> str | None:
    """Give what a pronoun stands for among what was said before; itself where nothing fits."""
    if sketch.operation is None:
        return None
    own = anchors.own[: anchors.position - anchors.first]
    named = replace(sketch.operation, object=pronoun)
    return resolved_object(named, own, anchors.mentions, anchors.first)


def _are_others(clause: Clause, thing: str | None, lexicon: Lexicon) -> bool:
    """Whether "they" in a clause are not what is done something with, which is one thing."""
    subject = None if clause.condition is None else clause.condition.subject
    several = subject in lexicon.closed.plural_anaphors
    return several and thing is not None and not is_several(thing, lexicon)


def _named(condition: Condition, thing: str | None, lexicon: Lexicon) -> Condition:
    """Put a name for a pronoun: "stir the sauce until it thickens"."""
    if condition.subject not in lexicon.closed.anaphors or thing is None:
        return condition
    if condition.subject == "it" and condition.word in lexicon.impersonal:
        return condition
    words = [word for word in thing.lower().split() if content_words(word)]
    return replace(condition, subject=" ".join(words) or condition.subject)
