"""Instructions before they are grounded: operation, times and clauses of each part of a draft."""

from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Remark, RemarkKind
from fuzzytime.language.meaning.expressions import (
    Duration,
    Phrase,
    Repeat,
    TimeWord,
)
from fuzzytime.language.sentence.days_apart import on_their_days
from fuzzytime.language.sentence.drafts import Draft
from fuzzytime.language.sentence.lending import led, repeated, shared, within
from fuzzytime.language.sentence.sketch import Sketch, sketch_of
from fuzzytime.requirement import Constraint

ADDED = frozenset({"and", "&", ",", "again", "once", "more", "also"})
OFFERED = frozenset({"or"})


def sketches_of(draft: Draft, lexicon: Lexicon) -> tuple[list[Sketch], list[Remark]]:
    """Sketch the instructions of a draft; two times joined by "and" make two of one."""
    found: list[Sketch] = []
    remarks: list[Remark] = []
    sketches = repeated(led([sketch_of(draft, part, lexicon) for part in draft.parts]), draft.text, lexicon)
    for whole in shared(within(sketches, draft.text), draft.text, lexicon):
        for phrases, dropped in _alternatives(draft, whole.phrases):
            kept = [whole.phrases.index(phrase) for phrase in phrases]
            found.append(replace(whole, phrases=phrases, references=tuple(whole.references[k] for k in kept)))
            for phrase in dropped:
                text = draft.text[slice(*phrase.span)]
                message = f"{text!r} is not used: of times joined by 'or', the first is taken"
                remarks.append(Remark(RemarkKind.POLICY, phrase.span, message))
    return on_their_days(found, draft.text), remarks


def _alternatives(
    draft: Draft, phrases: tuple[Phrase, ...]
) -> list[tuple[tuple[Phrase, ...], tuple[Phrase, ...]]]:
    """Give the times of each instruction that is meant, with those that are left out.

    "At seven and at six" asks for two, "at seven or at eight" for one; "tomorrow, by noon" is one time.
    """
    for place in range(len(phrases) - 1):
        group = [phrases[place]]
        joints: set[str] = set()
        for following in phrases[place + 1 :]:
            between = {word.text for word in draft.scanned.words[group[-1].end : following.first]}
            if not between or between - ADDED - OFFERED or not (_is_when(group[-1]) and _is_when(following)):
                break
            group.append(following)
            joints |= between
        if len(group) > 1 and joints & (ADDED | OFFERED) - {","}:
            rest = tuple(phrase for phrase in phrases if phrase not in group)
            if joints & OFFERED:
                return [((*rest, group[0]), tuple(group[1:]))]
            return [(tuple(sorted((*rest, one), key=lambda phrase: phrase.span)), ()) for one in group]
    return [(phrases, ())]


def _is_when(phrase: Phrase) -> bool:
    """Whether it is a time at which something may be done, and not a bound, a length or a repetition."""
    said = phrase.said
    if isinstance(said.time, (Duration, TimeWord)):
        return (said.constraint or getattr(said.time, "constraint", None)) is Constraint.AT
    return said.constraint in {None, Constraint.AT, Constraint.BETWEEN} and not isinstance(said.time, Repeat)
