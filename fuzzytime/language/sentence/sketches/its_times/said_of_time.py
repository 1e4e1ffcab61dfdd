"""What a part of a text says about time: its times told from those of its clauses."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from fuzzytime.language.grammar.leftovers.leftovers import not_understood
from fuzzytime.language.instruction import Remark, RemarkKind, Span, overlap
from fuzzytime.language.meaning.days.relations import days_away
from fuzzytime.language.meaning.expressions import Edge, Offset, Phrase, Range, Said, Wall, wall_of
from fuzzytime.language.meaning.joined.beside import joined
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.sketches.its_clauses.clauses import clauses_of
from fuzzytime.language.sentence.sketches.its_clauses.deadlines import with_deadlines
from fuzzytime.language.sentence.sketches.its_clauses.ends import OR_ELAPSED
from fuzzytime.language.sentence.sketches.its_clauses.how_far import with_distances
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.requirement import Constraint
from fuzzytime.requirement import Edge as EventEdge

BOUNDS = {
    "when": (None, "at"),
    "while": (None, "at"),
    "before": (Constraint.BEFORE, "before"),
    "by the time": (Constraint.BEFORE, "by"),
    "until": (Constraint.BEFORE, "until"),
    "after": (Constraint.AFTER, "after"),
}
"""How the time of an event binds what is said to be at, before or after it."""

DATED = "clause"
"""The rule of a phrase that is a clause with a time of its own."""


@dataclass(frozen=True, slots=True)
class SaidOfTime:
    """The times and clauses of a part, the stretches that are left out of them, and what is said of those."""

    phrases: list[Phrase]
    clauses: list[Clause]
    left_out: list[Span]
    remarks: list[Remark]


def said_of_time(draft: Draft, part: Part, phrases: Sequence[Phrase]) -> SaidOfTime:
    """Tell the times of a part, ``phrases``, from those of its clauses."""
    first, end = part.segment.span
    clauses: list[Clause] = []
    if part.front is not None:
        clauses += _clauses(draft, part.front, (first, part.offset), phrases)
    if part.tree.nodes:
        clauses += _clauses(draft, part.tree, (part.offset, end), phrases)
    follows = bool(draft.text[:first].strip())
    clauses, passed = with_deadlines(
        clauses, phrases, draft.text, part.offset, draft.lexicon, follows=follows
    )
    clauses = [_without_clock(clause, draft.text) for clause in clauses]
    clauses = [clause for clause in clauses if not any(overlap(clause.content, u) for u in draft.unfinished)]
    coarse = [u for u in draft.unfinished if any(u[0] < clause.span[0] < u[1] for clause in clauses)]
    left_out = [_left_out(draft, clause, phrases) for clause in clauses if clause.excepted]
    excepted = [_not_planned(draft.text, span) for span in left_out]
    # "The night before we fly"
    excepted += [Remark(RemarkKind.NOT_UNDERSTOOD, span, not_understood(draft.text, span)) for span in coarse]
    kept = [
        phrase
        for phrase in phrases
        if not any(overlap(phrase.span, span) for span in (*(c.span for c in clauses), *left_out))
    ]
    clauses = [clause for clause in clauses if not clause.excepted]
    kept += [_dated(draft, clause, clause.time) for clause in clauses if clause.time is not None]
    kept += passed
    clauses = [clause for clause in clauses if clause.time is None]
    kept.sort(key=lambda phrase: phrase.span)
    clauses, kept = _with_lengths_told(draft, clauses, kept)
    kept = [_bounding(phrase, clauses) for phrase in kept]
    clauses, kept = with_distances(clauses, kept, draft.text)
    return SaidOfTime(kept, clauses, left_out, excepted)


def _with_lengths_told(
    draft: Draft, clauses: Sequence[Clause], phrases: Sequence[Phrase]
) -> tuple[list[Clause], list[Phrase]]:
    """Give what goes on from when to when as that time: "while Ann naps from one to three".

    So of an event, "during the window, 1 to 3 am".
    """
    waited: list[Clause] = []
    kept = list(phrases)
    for clause in clauses:
        marks = " ,(" if clause.is_event else " "
        behind = (
            place
            for place, phrase in enumerate(kept)
            if clause.span[1] <= phrase.span[0]
            and not draft.text[clause.span[1] : phrase.span[0]].strip(marks)
        )
        place = next(behind, None)
        told = clause.verb is not None or clause.is_event
        goes_on = clause.kind == "while" and told and clause.distance is None
        if place is None or not goes_on or not isinstance(kept[place].said.time, Range):
            waited.append(clause)
            continue
        span = (clause.span[0], kept[place].span[1])
        first = next(p for p, word in enumerate(draft.scanned.words) if word.start >= span[0])
        kept[place] = replace(kept[place], first=first, span=span, rule=DATED)
    return waited, kept


def _bounding(phrase: Phrase, clauses: Sequence[Clause]) -> Phrase:
    """Give a length that is over, behind "or", as when it is done: "when it rings or an hour is up"."""
    before = [clause for clause in clauses if clause.span[1] <= phrase.span[0]]
    if phrase.rule != OR_ELAPSED or not before or before[-1].kind == "until":
        return phrase
    said = replace(phrase.said, constraint=Constraint.AT, preposition="in", alternative=True)
    return replace(phrase, said=said)


def _without_clock(clause: Clause, text: str) -> Clause:
    """Give a day of an event without the clock time behind it: "on the morning of the party, at nine"."""
    said = None if clause.time is None else clause.time.said.time
    clock = isinstance(said, Wall) and said.clock is not None and said.days is None
    if clause.time is None or clause.day_part is None or clause.distance is not None or not clock:
        return clause
    first, end = clause.span
    # The time ends where the clause does.
    end -= clause.time.span[1] - clause.time.span[0]
    return replace(clause, time=None, span=(first, first + len(text[first:end].rstrip(" ,"))))


def _left_out(draft: Draft, clause: Clause, phrases: Sequence[Phrase]) -> Span:
    """Give the stretch that says when not to do something, with the time behind it."""
    first, end = clause.span
    for phrase in phrases:
        if phrase.span[0] >= end and not draft.text[end : phrase.span[0]].strip():
            end = phrase.span[1]
    return first, end


def _not_planned(text: str, span: Span) -> Remark:
    """Say why a stretch is not used that says when something is not done, or done even so."""
    if text[: span[0]].rstrip().lower().endswith("even"):
        return Remark.noted(text, span, "is not used: it is done all the same")
    message = f"{text[slice(*span)]!r} is not used: when not to do something is not planned"
    return Remark(RemarkKind.NOT_UNDERSTOOD, span, message)


def _dated(draft: Draft, clause: Clause, time: Phrase) -> Phrase:
    """Give the time of an event that has one: "before the guests arrive at seven" is before seven."""
    constraint, preposition = BOUNDS[clause.kind]
    # "By close of school on Tuesday"
    edge = Edge.DUE if clause.edge is EventEdge.END or clause.marker.startswith("by") else Edge.START
    said = replace(time.said, constraint=constraint, preposition=preposition, edge=edge)
    if clause.day_part is not None and clause.distance is None:
        # "On the morning of the party on friday"
        day, half = time.said.time, clause.day_part.said.time
        both = joined(day, half) if isinstance(day, Wall) and isinstance(half, Wall) else None
        said = said if both is None else replace(said, time=both)
    if clause.distance is not None and isinstance(time.said.time, Wall):
        direction = 1 if constraint is Constraint.AFTER else -1
        distance = Offset(replace(clause.distance, hedges=()), direction, time.said.time)
        # "No later than two hours before the fight, which is at eight"
        said = Said(distance, clause.side, None, clause.distance.hedges)
        days = time.said.time.days if time.said.time.clock is None and time.said.time.part is None else None
        away = None if days is None else days_away(distance.duration, days, direction)
        if away is not None:
            # "The day before the wedding on saturday"
            part = None if clause.day_part is None else clause.day_part.said.time
            said = replace(said, time=Wall(away, part=wall_of(part).part))
    places = [
        place
        for place, word in enumerate(draft.scanned.words)
        if clause.span[0] <= word.start < clause.span[1]
    ]
    return Phrase(said, places[0], places[-1] + 1, clause.span, DATED)


def _clauses(draft: Draft, tree: Tree, span: Span, phrases: Sequence[Phrase]) -> list[Clause]:
    """Give the clauses in a tree's stretch of text, with places in the whole text."""
    offset, end = span
    places = [place for place, word in enumerate(draft.scanned.words) if offset <= word.start < end]
    start = places[0] if places else 0
    words = [draft.scanned.words[place] for place in places]
    local_words = [replace(word, start=word.start - offset, end=word.end - offset) for word in words]
    local, named = (
        [
            replace(
                p, first=p.first - start, end=p.end - start, span=(p.span[0] - offset, p.span[1] - offset)
            )
            for p in found
            if offset <= p.span[0] < end
        ]
        for found in (phrases, draft.naming)
    )
    return [clause.moved(offset) for clause in clauses_of(tree, local_words, local, named)]
