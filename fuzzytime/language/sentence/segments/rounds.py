"""Segments get their trees, and are cut again, round by round, until each is one instruction.

A segment is cut where its tree shows several; where that shows none, where an order stands behind a joint;
and where there is none, either, where a verb is left out.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from fuzzytime.language.sentence.segments.borrowed_words.borrowing import wishes_behind
from fuzzytime.language.sentence.segments.connectives import next_one
from fuzzytime.language.sentence.segments.cuts import other_things, pieces_of, reminded
from fuzzytime.language.sentence.segments.fronts import Front, fronts_of
from fuzzytime.language.sentence.segments.further.calls import addressed, called_first, called_next
from fuzzytime.language.sentence.segments.further.entries_in_a_row import entries_of
from fuzzytime.language.sentence.segments.further.orders_behind_joints import orders_behind_joints
from fuzzytime.language.sentence.segments.further.own_verbs import with_own_verbs
from fuzzytime.language.sentence.segments.further.run_on_orders import run_on_orders
from fuzzytime.language.sentence.segments.further.same_doers import done_next
from fuzzytime.language.sentence.segments.further.told_beside import told_beside
from fuzzytime.language.sentence.segments.mended.parsing import trees_of, uncapitalised
from fuzzytime.language.sentence.segments.segment import Segment, segments_of
from fuzzytime.language.sentence.segments.source import Source
from fuzzytime.language.sentence.segments.told.reasons import reason_in_front
from fuzzytime.language.sentence.segments.waiting import Part, Waiting
from fuzzytime.language.sentence.trees.tree import Trees
from fuzzytime.language.sentence.verbs.statements.called import with_clause

ROUNDS = 12
"""How often a segment may be cut again: instructions joined by "and" in one sentence."""


def parted(sources: Sequence[Source], trees: Trees) -> list[list[Part]]:
    """Parse every segment, and cut it again where its tree shows a further instruction."""
    done: list[dict[int, Part]] = [{} for _ in sources]
    waiting = [
        Waiting.of(position, source, segment)
        for position, source in enumerate(sources)
        for segment in segments_of(
            source.scanned.text,
            source.scanned.words,
            source.phrases,
            source.scanned.lexicon,
            [remark.span for remark in source.remarks],
        )
    ]
    for last_round in (False,) * ROUNDS + (True,):
        if not waiting:
            waiting = [] if last_round else _done_next(sources, done)
        if not waiting:
            break
        found = trees_of(waiting, trees)
        fronts = [with_clause(tree) for tree in uncapitalised([one.front for one in waiting], trees)]
        parsed = [
            Part(one.segment, tree, one.main, front if front.nodes else None)
            for one, tree, front in zip(waiting, found, fronts, strict=True)
        ]
        cuts: list[list[Waiting]] = [[] for _ in waiting]
        if not last_round:
            led = fronts_of(waiting, found, fronts, trees)
            cuts = _cut_again(waiting, parsed, led, trees)
        for one, part, cut in zip(waiting, parsed, cuts, strict=True):
            if not cut:
                done[one.position][one.segment.span[0]] = part
        waiting = [one for cut in cuts for one in cut]
    return [with_own_verbs([own[start] for start in sorted(own)]) for own in done]


def _cut_again(
    waiting: Sequence[Waiting], parsed: Sequence[Part], led: Mapping[int, Front], trees: Trees
) -> list[list[Waiting]]:
    """Give for each segment what waits anew in its place; nothing where it is one instruction."""
    alone = [place for place in range(len(waiting)) if place not in led]
    unled = [waiting[place] for place in alone], [parsed[place].tree for place in alone]
    second = told_beside(*unled, trees) | run_on_orders(*unled, trees)
    runs_on = {alone[at]: start for at, start in second.items()}
    cuts = [
        list(one.cut_at(led[place].start, led[place].main))
        if place in led
        else _cut(one, part, runs_on.get(place))
        for place, (one, part) in enumerate(zip(waiting, parsed, strict=True))
    ]
    whole = [place for place, cut in enumerate(cuts) if not cut]
    uncut = [waiting[place] for place in whole], [parsed[place].tree for place in whole]
    joined = orders_behind_joints(*uncut, trees)
    for at, place in enumerate(whole):
        if at in joined:
            cuts[place] = list(waiting[place].cut_before(joined[at]))
        else:
            things = other_things(waiting[place], parsed[place])
            cuts[place] = _waiting(waiting[place], things)
    return cuts


def _cut(one: Waiting, part: Part, runs_on: int | None) -> list[Waiting]:
    """Cut a segment where its tree shows several; before the order that ``runs_on``, if nothing leads it."""
    apart = _order_apart(one)
    if apart is not None:
        return list(one.cut_before(apart))
    if not part.tree.nodes:
        return []
    listed = entries_of(one, part)
    if listed:
        return _waiting(one, listed)
    cut = reason_in_front(one, part) or called_next(one, part)
    if runs_on is not None and not cut:
        return list(one.cut_before(runs_on))
    cut = (
        cut
        or _behind_front(one, called_first(one, part) or addressed(one, part))
        or next_one(one, part)
        or reminded(one, part)
        or pieces_of(one, part)
    )
    return _waiting(one, cut)


def _behind_front(one: Waiting, called: list[Segment]) -> list[Segment]:
    """Give what stands before whom a segment calls a segment of its own: "after lunch, anna, lock up"."""
    first = one.segment.span[0]
    end = one.end_before(one.main + one.behind_time)
    kept = called and end > first and called[0].span[0] > end
    return [replace(one.segment, span=(first, end)), *called] if kept else called


def _waiting(one: Waiting, pieces: Sequence[Segment]) -> list[Waiting]:
    """Give the pieces of a segment, which wait anew; none where what it borrows is cut."""
    if any(piece.span[0] < one.segment.span[0] for piece in pieces if one.segment.borrowed):
        return []
    return [Waiting.of(one.position, one.source, piece) for piece in pieces]


def _order_apart(one: Waiting) -> int | None:
    """Give where an order begins beside what is told; None where none does."""
    first, end = one.segment.span
    return next((start for start in one.source.apart if first < start < end), None)


def _done_next(sources: Sequence[Source], done: Sequence[dict[int, Part]]) -> list[Waiting]:
    """Give what waits anew for its tree, behind who does it, or what is done: "…, then lands"."""
    return [
        Waiting.of(position, source, part.segment)
        for position, (source, own) in enumerate(zip(sources, done, strict=True))
        for part in (*done_next(source, own), *wishes_behind(source, own))
    ]
