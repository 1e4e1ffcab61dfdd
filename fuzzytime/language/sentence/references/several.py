"""Clauses about several instructions ("when both are done"), or all of a name: "after each dive"."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import chain

from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Remark, RemarkKind
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.clauses.clause_sides import BEHIND
from fuzzytime.language.sentence.references.anchors import Anchors
from fuzzytime.language.sentence.references.likeness import all_alike
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.requirement import TimeRequirement

BOTH = 2


def of_several(clause: Clause, anchors: Anchors, text: str) -> list[TimeRequirement]:
    """Give what a clause requires that waits for several instructions; nothing where it is about one."""
    condition = clause.condition
    if clause.kind not in BEHIND or clause.is_event or (condition is not None and condition.negated):
        return []
    targets = _all_meant(clause, anchors, text) or _named(clause, anchors)
    said, what = text[slice(*clause.span)], text[slice(*clause.content)]
    required = [anchors.of_clause(clause.since_begun(), said, what, target) for target in targets]
    # So long after several is so long after the last of them, and longer after the others.
    return [
        one if one.anchor is None else replace(one, anchor=replace(one.anchor, exact=False))
        for one in required
    ]


def one_is_enough(clause: Clause, anchors: Anchors, text: str) -> bool:
    """Whether a clause waits for one of several: "when the rice or the beans are done", "once either is"."""
    condition = clause.condition
    over = condition is not None and condition.word in anchors.lexicon.results
    words = {word.text for word in words_of(text[slice(*clause.content)])}
    offered = not words.isdisjoint(anchors.lexicon.closed.denied_alternatives)
    return clause.kind in BEHIND and ("either" in words or (offered and (over or bool(clause.further))))


def only_one(clause: Clause, text: str) -> Remark:
    """Say that of several things one alone is waited for."""
    message = f"{text[slice(*clause.span)]!r} is about either of several: only one is waited for"
    return Remark(RemarkKind.NOT_UNDERSTOOD, clause.span, message)


def _all_meant(clause: Clause, anchors: Anchors, text: str) -> list[int]:
    """Give the instructions before it that are all meant: "both", "all three", "everything"."""
    closed, lexicon = anchors.lexicon.closed, anchors.lexicon
    if clause.condition is None:
        return []
    # "Once both are done", "when both are ok"; but "once both are calibrated"
    said = clause.condition.word is not None and clause.verb in {None, "be"}
    over = said or clause.condition.word in lexicon.results
    words = [word.text for word in words_of(text[slice(*clause.content)])]
    named = content_words(clause.object) - closed.universal_pronouns - closed.anaphors
    named -= lexicon.numbers.keys() | lexicon.beside.wishes
    whole = next((word for word in words if word in closed.wholes | closed.both), None)
    if whole is None or named:
        return []
    counted = (lexicon.numbers[word] for word in words if word in lexicon.numbers)
    many = BOTH if whole in closed.both else next(counted, None)
    # "Once both are calibrated"
    done = ((place, one) for place, one in anchors.just_before() if over or one.lemma == clause.verb)
    asked = [place for place, one in done if one.is_asked][:many]
    return sorted(asked) if len(asked) >= (many or BOTH) else []


def _named(clause: Clause, anchors: Anchors) -> list[int]:
    """Give the instructions that are named one by one, where each is another."""
    singles = [*_one_by_one(clause, anchors), *clause.further]
    if len(singles) < BOTH:
        return []
    targets = [anchors.target_of(single) for single in singles]
    found = [target for target in targets if target is not None]
    return found if len({*found}) == len(targets) else []


def _one_by_one(clause: Clause, anchors: Anchors) -> Iterator[Clause]:
    """Give a clause of several things as clauses of one thing each: "the rice and the beans"."""
    words = (clause.object or "").split()
    ends = [p for p, word in enumerate(words) if word.lower() in anchors.lexicon.closed.additions]
    for first, end in zip([-1, *ends], [*ends, len(words)], strict=True):
        thing = " ".join(words[first + 1 : end]).rstrip(",")
        if not thing or not ends:
            yield from () if ends else (clause,)
            continue
        condition = clause.condition
        if condition is not None:
            condition = replace(condition, subject=thing.lower())
        yield replace(clause, object=thing, condition=condition, further=())


def names_each(clause: Clause, anchors: Anchors) -> bool:
    """Whether a clause names an event each time that it is: "before every take"."""
    first = (clause.object or "").lower().split()[:1]
    return clause.is_event and not anchors.lexicon.closed.distributives.isdisjoint(first)


def every_one(clause: Clause, anchors: Anchors) -> tuple[int, ...]:
    """Give the positions of all instructions that the name of an event means, as far as they are known."""
    named_only = content_words(clause.object) - anchors.lexicon.closed.distributives
    if named_only <= anchors.lexicon.closed.anaphors:
        return _said_last(anchors)
    here = ((anchors.first + place, operation) for place, operation in enumerate(anchors.own))
    beside = ((place, operation) for place, operation in here if place != anchors.position)
    behind = anchors.first + len(anchors.own)
    last = len(anchors.mentions.operations) if anchors.awaits else behind
    stretches = range(anchors.first), range(behind, last)
    named = anchors.mentions.named_by
    places = chain(*(named(clause, stretch, backwards=False, every=True) for stretch in stretches))
    others = ((place, anchors.mentions.operations[place]) for place in places)
    alike = all_alike(clause, chain(beside, others), anchors.lexicon)
    return tuple([place for place in alike if not _is_in_turns(place, anchors)] or alike)


def _said_last(anchors: Anchors) -> tuple[int, ...]:
    """Give what "each one" means: the instructions said last that share a word, as two interviews do."""
    found: list[int] = []
    shared = frozenset[str]()
    for place, operation in anchors.just_before():
        words = content_words(operation.name)
        if found and not shared & words:
            break
        shared = shared & words if found else words
        found.append(place)
    return tuple(sorted(found)) if len(found) >= BOTH else ()


def _is_in_turns(place: int, anchors: Anchors) -> bool:
    """Whether an instruction is itself done with each of several, or between them."""
    operation, closed = anchors.operation_at(place), anchors.lexicon.closed
    said = "" if operation is None else f"{operation.object or ''} {operation.place or ''}"
    return not closed.marking_turns.isdisjoint(said.lower().split())
