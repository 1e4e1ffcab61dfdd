"""What an operation is called with: what somebody is told, which thing is meant, what it is marked as."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.instruction import Operation, Remark
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.told.messages import Message
from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.verbs.meant.actions import Action

RECIPIENT = "to "
MARKS = ":, "
"""What may stand in front of what is told."""


def _told_in(draft: Draft, part: Part) -> Message | None:
    """Give what somebody is told by a part of a draft."""
    first, end = part.segment.span
    return next((one for one in draft.messages if first <= one.verb < end), None)


def times_told(draft: Draft, part: Part) -> tuple[Phrase, ...]:
    """Give the times in what somebody is told by a part of a draft."""
    told = _told_in(draft, part)
    return () if told is None else told.times


def telling_alone(draft: Draft, part: Part) -> Operation | None:
    """Give an order that tells somebody something, where a tree has its verb for a thing: "text jo …"."""
    told, tree = _told_in(draft, part), part.tree
    if told is None or told.whom is None or not tree.nodes or tree.nodes[tree.root].is_verb:
        return None
    whom, said = draft.text[slice(*told.whom)], draft.text[slice(*told.span)].lstrip(MARKS)
    verb = draft.text[told.verb : told.whom[0]].strip().lower()
    span = (told.verb, told.verb + len(verb))
    return Operation(verb=verb, lemma=verb, span=span, object=whom, complement=said)


def with_told(draft: Draft, part: Part, operation: Operation) -> Operation:
    """Give an operation with what somebody is told by it: "text mike i'm on my way"."""
    told = _told_in(draft, part)
    if told is None:
        return operation
    said = (operation.complement, draft.text[slice(*told.span)].lstrip(MARKS))
    whom = operation.object if told.whom is None else draft.text[slice(*told.whom)]
    if whom is not None and whom.lower().startswith(RECIPIENT):
        # "Reply to Kate that i can't come"
        return replace(operation, place=None, complement=" ".join((whom, said[1])))
    # "Text kate": a name was taken for how it is done.
    manner = None if operation.manner == whom else operation.manner
    return replace(operation, object=whom, complement=" ".join(filter(None, said)), manner=manner)


def of_which(text: str, operation: Operation, times: Sequence[Phrase]) -> Operation:
    """Give an operation with the times that say which thing is meant: "cancel my alarm for six"."""
    said = [text[slice(*phrase.span)] for phrase in times]
    manner = " ".join(filter(None, (operation.manner, *said)))
    return replace(operation, manner=manner) if said else operation


def with_name(part: Part, operation: Operation, action: Action) -> Operation:
    """Give an operation with what a thing is called by it: "mark the rent as paid"."""
    nodes, lexicon = part.tree.nodes, part.lexicon
    if nodes[action.place].lemma not in lexicon.doing.marking or operation.complement is not None:
        return operation
    for place in range(action.place + 1, len(nodes) - 1):
        if nodes[place].lower == "as":
            end = place + 1
            while end < len(nodes) - 1 and nodes[end].lower in lexicon.closed.before_states:
                end += 1
            state = nodes[end].tag in {"VBN", "VBD", "JJ"}
            said = " ".join(node.text for node in nodes[place : end + 1])
            return replace(operation, complement=said) if state else operation
    return operation


def of_something_else(text: str, phrase: Phrase) -> Remark:
    """Give what to say of a time that is none of what is to be done."""
    return Remark.noted(text, phrase.span, "is of what is named, and not when to do it")
