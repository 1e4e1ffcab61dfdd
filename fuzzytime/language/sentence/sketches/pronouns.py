"""What pronouns stand for: things, "it" and "them", or who was named, "him", "her" and "them"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.surroundings import OWNING
from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.references.anchors import Anchors
from fuzzytime.language.sentence.references.mentions import Mentions
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.trees.named import PRONOUNS, SOMEBODY, is_several

PEOPLE = frozenset({"them"})
SEVERAL = frozenset({"them", "those", "these", "ones", "they"})
TOWARDS = frozenset({"to", "for"})
"""Words behind a pronoun that say whom it is for."""

GIVEN = frozenset({"a", "an", "the", "some", "his", "her", "their", "its", "one", "two", "half", "another"})
"""Words behind "her" that show that it is no owner: "give her a bath", but "visit her aunt"."""


def resolved_object(
    operation: Operation, own: Sequence[Operation | None], mentions: Mentions, first: int
) -> str | None:
    """Give what "it" or "them" stands for: the object of the latest instruction that fits in number.

    ``own`` are the operations before it in its text, which begins at ``first`` of all.

    Neither stands for a person: in "call mum, then wash it", it is something else.
    """
    person = _resolved_person(operation, own, mentions, first)
    if person is not None:
        return person
    pronoun, _, rest = (operation.object or "").partition(" ")
    if rest and pronoun.lower() in PRONOUNS and rest.split()[0] in TOWARDS:
        # "Print the plans and send them to her"
        alone = replace(operation, object=pronoun)
        return f"{resolved_object(alone, own, mentions, first)} {rest}"
    if operation.object is None or operation.object.lower() not in PRONOUNS:
        return operation.object
    if operation.lemma in mentions.lexicon.addressing and operation.object.lower() in PEOPLE:
        # "Tell them when to stop"
        return operation.object
    several = operation.object.lower() in SEVERAL
    near = Mentions(mentions.lexicon)
    for earlier in own:
        near.add(earlier)
    here, there = near.thing(len(own), several=several), mentions.thing(first, several=several)
    fitting = (thing for thing in (here, there) if thing is not None and is_several(thing) is several)
    return next(fitting, here or there or operation.object)


def thing_of_clause_in_front(sketch: Sketch, operation: Operation, anchors: Anchors) -> str | None:
    """Give what "them" is behind a clause about it: "when the rolls are done, put them in the window"."""
    if (operation.object or "").lower() not in PRONOUNS:
        return None
    for clause in sketch.clauses:
        if clause.span[0] < operation.span[0]:
            condition = clause.condition
            named = condition is not None and condition.subject not in PRONOUNS
            thing = anchors.about(clause)
            if thing is not None and (named or is_several(thing) == (operation.object in SEVERAL)):
                return thing
    return None


def _resolved_person(
    operation: Operation, own: Sequence[Operation | None], mentions: Mentions, first: int
) -> str | None:
    """Give an object with who is meant by "him", "her" or "them" in it; None where nobody was named.

    "Them" are rather things that were named.
    """
    pronoun, _, rest = (operation.object or "").partition(" ")
    if pronoun.lower() not in SOMEBODY or operation.stated:
        return None
    if rest and pronoun.lower() == "her" and rest.split()[0].lower() not in GIVEN:
        return None
    several = pronoun.lower() in SEVERAL
    near = Mentions(mentions.lexicon)
    for earlier in own:
        near.add(earlier)
    if several and near.thing(len(own), several=True, strictly=True):
        return None
    person = near.person(len(own), several=several) or mentions.person(first, several=several)
    if person is None or (several and mentions.thing(first, several=True, strictly=True)):
        return None
    article, _, name = person.partition(" ")
    # "The kids finish school at three. Give them a snack"
    person = f"{article.lower()} {name}" if name and article.lower() in OWNING else person
    return f"{person} {rest}" if rest else person
