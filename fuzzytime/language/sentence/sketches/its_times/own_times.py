"""Which times of a part say when something is to be done, and which are of something else in it."""

from dataclasses import dataclass

from fuzzytime.language.instruction import Remark, Span, overlap
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.sketches.its_times.elsewhere import aim_of, elsewhere, reason_of
from fuzzytime.language.sentence.sketches.its_times.of_things import of_things
from fuzzytime.language.sentence.sketches.its_times.said_of_time import SaidOfTime
from fuzzytime.language.sentence.sketches.telling import of_something_else, times_told
from fuzzytime.language.sentence.verbs.meant.actions import Action


@dataclass(frozen=True, slots=True)
class OwnTimes:
    """The times and clauses of what is to be done.

    ``of_things`` are the times that say which thing is meant, ``named`` all that are of something else;
    ``covered`` are the stretches that are no words of the operation, and ``remarks`` say what is left out.
    """

    phrases: tuple[Phrase, ...]
    clauses: tuple[Clause, ...]
    of_things: tuple[Phrase, ...]
    named: tuple[Phrase, ...]
    covered: tuple[Span, ...]
    remarks: tuple[Remark, ...]


def own_times(draft: Draft, part: Part, said: SaidOfTime, action: Action) -> OwnTimes:
    """Tell the times of an action from those of what it is about, what it is for and why it is done."""
    reasons = (
        (aim_of(part, said.phrases, action), "what it is for"),
        (reason_of(part, said.phrases, action), "why"),
    )
    aims = [(span, what) for span, what in reasons if span is not None]

    def is_of_aim(span: Span) -> bool:
        return any(overlap(span, aim) for aim, _ in aims)

    others = elsewhere(part, said.phrases, action, told=bool(said.clauses))
    things = [phrase for phrase in of_things(part, said.phrases, action) if phrase not in others]
    of_aims = [phrase for phrase in said.phrases if is_of_aim(phrase.span)]
    others, things = ([one for one in found if one not in of_aims] for found in (others, things))
    phrases = tuple(one for one in said.phrases if one not in (*others, *things, *of_aims))
    clauses = tuple(clause for clause in said.clauses if not is_of_aim(clause.span))
    heard = (*(phrase.span for phrase in phrases), *(clause.span for clause in clauses))
    aside = (*said.left_out, *draft.unfinished, *(aim for aim, _ in aims))
    named = (*others, *things, *of_aims, *times_told(draft, part))
    return OwnTimes(
        phrases=phrases,
        clauses=clauses,
        of_things=tuple(things),
        named=tuple(sorted(named, key=lambda phrase: phrase.span)),
        covered=(*heard, *aside, *(phrase.span for phrase in things)),
        remarks=(
            *said.remarks,
            *(Remark.noted(draft.text, aim, f"is {what}, and not when to do it") for aim, what in aims),
            *(of_something_else(draft.text, phrase) for phrase in (*others, *things)),
        ),
    )
