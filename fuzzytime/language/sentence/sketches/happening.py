"""What happens, or is so by then, where no verb of an instruction says what is to be done."""

from collections.abc import Sequence

from fuzzytime.language.instruction import Operation
from fuzzytime.language.meaning.expressions import Duration, Phrase
from fuzzytime.language.meaning.phrases import is_at_clock, is_window
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.verbs.operations.operations import Reader
from fuzzytime.language.sentence.verbs.without_verbs.due_by_then import due_by_then, so_alone
from fuzzytime.language.sentence.verbs.without_verbs.happenings import (
    frame_on_day,
    given_new_time,
    happening_at,
    happens,
    meal_alone,
    person_there,
)
from fuzzytime.language.sentence.verbs.without_verbs.named_alone import put_there
from fuzzytime.language.sentence.verbs.without_verbs.named_deeds import chores_at, deed_at, named_moment
from fuzzytime.requirement import Constraint


def moved_to_new_time(part: Part, phrases: Sequence[Phrase]) -> Operation | None:
    """Give what was moved, which happens at its new time: "the dentist has been moved to four"."""
    if not part.tree.nodes:
        return None
    heard = [part.local(phrase.span) for phrase in phrases]
    found = given_new_time(part.tree, phrases, Reader(part.tree, heard))
    return None if found is None else found.moved(part.offset)


def happening(
    draft: Draft, part: Part, phrases: Sequence[Phrase], clauses: Sequence[Clause]
) -> Operation | None:
    """Give what happens at a time, or after something else, where no verb says what is to be done."""
    root = part.tree.root
    if not part.tree.nodes:
        first, end = part.segment.span
        meal = meal_alone(draft.text[first:end], phrases, part.lexicon, listed=draft.beside)
        return None if meal is None else meal.moved(first)
    timed = phrases or clauses
    places = [place for phrase in phrases for place in part.at(phrase.span)]
    lasts = any(isinstance(phrase.said.time, Duration) for phrase in phrases)
    put = put_there(part.tree, places, lasts=lasts)
    if put is not None and not part.segment.verbless:
        return put.moved(part.offset)
    due = {place for p in phrases for place in part.at(p.span) if p.said.constraint is Constraint.BEFORE}
    at_once = [p for p in phrases if p.said.preposition == "at" or is_at_clock(p)]
    moments = {place for p in at_once for place in part.at(p.span)}
    heard = [*places, *(place for clause in clauses for place in part.at(clause.span))]
    # "Mum in hospital until friday" is told, "kids in bed by eight" is due.
    until = all(p.said.preposition == "until" for p in phrases if p.said.constraint is Constraint.BEFORE)
    clocked = bool(moments) or any(map(is_window, phrases))
    there = person_there(part.tree, heard, clocked=clocked) if timed and until else None
    told = frame_on_day(part.tree, places, phrases) or there
    if told is not None and not part.segment.verbless:
        return told.moved(part.offset)
    # "Dog walked this morning" may be news.
    news = {place for p in phrases for place in part.at(p.span) if p.said.is_day} - due - moments
    heard_now = [place for place in heard if place not in news]
    so = due_by_then(part.tree, due, moments, heard_now, listed=draft.listed)
    if so is not None and not part.segment.verbless:
        return so.moved(part.offset)
    if not (timed or part.segment.verbless) and (draft.beside or part.segment.span[0] > 0):
        so = so_alone(part.tree)
        return None if so is None else so.moved(part.offset)
    if part.segment.verbless or not timed:
        return None
    named = None if clauses else named_moment(part.tree, phrases, part.offset)
    if named is not None:
        return named.moved(part.offset)
    if not happens(part.tree, phrases):
        deed = deed_at(part.tree, places, phrases)
        deed = deed or chores_at(part.tree, heard, phrases, led=bool(clauses))
        return None if deed is None else deed.moved(part.offset)
    said = (*(p.span for p in phrases), *(clause.span for clause in clauses), *draft.unfinished)
    names = Reader(part.tree, [part.local(span) for span in said])
    found = happening_at(root, part.tree, phrases, names)
    return found.moved(part.offset)
