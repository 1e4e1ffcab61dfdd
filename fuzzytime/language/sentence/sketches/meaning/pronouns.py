"""What pronouns stand for: things, "it" and "them", or who was named, "him", "her" and "them"."""

from collections.abc import Iterable, Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.references.anchors import Anchors
from fuzzytime.language.sentence.references.mentions import Mentions, undoes
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.language.sentence.trees.named import is_several, may_be_it


def resolved_object(
    operation: Operation, own: Sequence[Operation | None], mentions: Mentions, first: int
) -> str | None:
    """Give what "it" or "them" stands for: the object of the latest instruction that fits in number.

    ``own`` are the operations before it in its text, which begins at ``first`` of all.

    Neither stands for a person: in "call mum, then wash it", it is something else.
    """
    lexicon, pronouns = mentions.lexicon, mentions.lexicon.closed
    pronoun, _, rest = (operation.object or "").partition(" ")
    several = pronoun.lower() in pronouns.plural_anaphors
    given_to = [_what_is_given_to(one, lexicon, several=several) for one in own]
    person = _resolved_person(operation, given_to if several else own, mentions, first)
    if person is not None:
        return person
    given = rest and rest.split()[0] in pronouns.prepositions_of_recipients
    if given and pronoun.lower() in pronouns.anaphors:
        # "Print the plans and send them to her"
        alone = replace(operation, object=pronoun)
        return f"{resolved_object(alone, own, mentions, first)} {rest}"
    if operation.object is None or operation.object.lower() not in pronouns.anaphors:
        return operation.object
    if operation.lemma in lexicon.addressing and operation.object.lower() in pronouns.plural_person:
        # "Tell them when to stop"
        return operation.object
    before = (*reversed(given_to), *reversed(mentions.operations[:first]))
    undone = _undone(operation, before, several=several, lexicon=lexicon)
    thing = _fitting(operation, given_to, mentions, first, several=several) if undone is None else undone
    return operation.object if thing is None else _inside(thing, lexicon)


def _inside(thing: str, lexicon: Lexicon) -> str:
    """Give a thing as it is named inside a sentence: "The wash finishes", "hang out the wash"."""
    article, space, name = thing.partition(" ")
    return f"{article.lower()}{space}{name}" if article.lower() in lexicon.closed.noun_openers else thing


def _fitting(
    operation: Operation, own: Sequence[Operation | None], mentions: Mentions, first: int, *, several: bool
) -> str | None:
    """Give the last thing that was named and fits in number; else the last, here or in what is before it."""
    lexicon, near = mentions.lexicon, Mentions(mentions.lexicon)
    for earlier in own:
        passed = _is_setting(earlier, lexicon) and not _is_changing(operation, lexicon)
        # "The line's down today, do it tomorrow": nothing is done that is only told of.
        passed = passed or (
            operation.lemma == "do" and earlier is not None and earlier.stated and earlier.lemma == "be"
        )
        near.add(None if passed else earlier)
    # "Handover at noon", "print it before that" is of what was written for it.
    said = ((near, len(own)), (mentions, first))
    goods = operation.lemma not in lexicon.doing.of_events
    goods = goods and any(one.thing(end, several=several, goods=True) for one, end in said)
    found = (one.thing(end, several=several, goods=goods) for one, end in said)
    here, there = (None if _is_moment(thing, operation, lexicon) else thing for thing in found)
    fitting = (
        thing for thing in (here, there) if thing is not None and is_several(thing, lexicon) is several
    )
    return next(fitting, here or there)


def _what_is_given_to(operation: Operation | None, lexicon: Lexicon, *, several: bool) -> Operation | None:
    """Give what gets something, and not that with it: "give the fence a coat", then "leave it".

    A person is no "it": "give mum the keys", then "get them back". Of "give it another coat" none is named.
    """
    if operation is None or operation.object is None or operation.lemma not in lexicon.doing.giving:
        return operation
    closed, words = lexicon.closed, operation.object.split()
    openers = closed.noun_openers | closed.indefinite_determiners
    opens = (p for p, word in enumerate(words) if p and word.lower() in openers)
    place = next(opens, 0)
    if not place or words[place - 1].lower() in lexicon.function_words - closed.it_or_them:
        return operation
    parts = (" ".join(words[:place]), " ".join(words[place:]))
    if parts[0].lower() in closed.it_or_them:
        return None
    named = (part for part in parts if is_several(part, lexicon) is several)
    fitting = (replace(operation, object=part) for part in named)
    return next((one for one in fitting if may_be_it(one, lexicon)), operation)


def _is_moment(thing: str | None, operation: Operation, lexicon: Lexicon) -> bool:
    """Whether what was named is a moment, to which nothing is done but give it another time."""
    named = tuple(word.text for word in words_of(thing or ""))[-1:]
    return named in lexicon.moments and operation.lemma not in lexicon.rescheduling


def _undone(
    operation: Operation, before: Iterable[Operation | None], *, several: bool, lexicon: Lexicon
) -> str | None:
    """Give what was begun, and is now undone: "start the pump, log the pressure, stop it"."""
    for earlier in before:
        if earlier is None or earlier.object is None or not undoes(operation, earlier, lexicon):
            continue
        if may_be_it(earlier, lexicon) and is_several(earlier.object, lexicon) is several:
            return earlier.object
    return None


def undone_alone(operation: Operation, before: Iterable[Operation | None], lexicon: Lexicon) -> str | None:
    """Give what an order without a thing undoes: "load the van" and, on another line, "unload"."""
    if operation.object is not None or operation.place is not None or not operation.is_asked:
        return None
    done = (one for one in before if one is not None and undoes(operation, one, lexicon))
    return next((one.object for one in done if may_be_it(one, lexicon)), None)


def _is_changing(operation: Operation, lexicon: Lexicon) -> bool:
    return any(operation.lemma == form[0] for form in lexicon.changing)


def _is_setting(operation: Operation | None, lexicon: Lexicon) -> bool:
    """Whether an order changes how much there is of something, beside what is worked on: "lower the heat"."""
    if operation is None or operation.object is None or not _is_changing(operation, lexicon):
        return False
    return operation.object.lower().split()[-1] in lexicon.amount_nouns


def thing_of_clause_in_front(sketch: Sketch, operation: Operation, anchors: Anchors) -> str | None:
    """Give what "them" is behind a clause about it: "when the rolls are done, put them in the window"."""
    pronouns = anchors.lexicon.closed
    if (operation.object or "").lower() not in pronouns.anaphors:
        return None
    before = (*reversed(anchors.own), *reversed(anchors.mentions.operations[: anchors.first]))
    several = (operation.object or "").lower() in pronouns.plural_anaphors
    if _undone(operation, before, several=several, lexicon=anchors.lexicon) is not None:
        # "Pour in the developer, start the timer. When that goes, pour it out"
        return None
    for clause in sketch.clauses:
        if clause.span[0] < operation.span[0]:
            condition = clause.condition
            named = condition is not None and condition.subject not in pronouns.anaphors
            thing = _changed(sketch, clause, operation, anchors) if named else None
            if thing is not None:
                return thing
    return None


def _changed(sketch: Sketch, clause: Clause, operation: Operation, anchors: Anchors) -> str | None:
    """Give what has become what it is, and was worked on: "when the dough has risen, shape it"."""
    front, condition, lexicon = sketch.part.front, clause.condition, anchors.lexicon
    if front is None or condition is None or condition.subject is None:
        return None
    several = (operation.object or "").lower() in lexicon.closed.plural_anaphors
    perfect = any(
        node.tag == "VBN" and any(front.nodes[p].lemma == "have" for p in front.children(place, "aux"))
        for place, node in enumerate(front.nodes)
    )
    position = anchors.mentions.about(content_words(condition.subject), anchors.first)
    named = None if position is None else anchors.mentions.operations[position]
    thing = None if named is None else named.object
    return thing if perfect and thing is not None and is_several(thing, lexicon) is several else None


def _resolved_person(
    operation: Operation, own: Sequence[Operation | None], mentions: Mentions, first: int
) -> str | None:
    """Give an object with who is meant by "him", "her" or "them" in it; None where nobody was named.

    "Them" are rather things that were named.
    """
    closed = mentions.lexicon.closed
    pronoun, _, rest = (operation.object or "").partition(" ")
    if pronoun.lower() not in closed.third_person_objects or operation.stated:
        return None
    if rest and pronoun.lower() == "her" and rest.split()[0].lower() not in closed.of_what_is_given:
        return None
    several = pronoun.lower() in closed.plural_anaphors
    near = Mentions(mentions.lexicon)
    for earlier in own:
        near.add(earlier)
    if several and near.thing(len(own), several=True, strictly=True):
        return None
    called = pronoun.lower()
    person = near.person(len(own), called, several=several) or mentions.person(first, called, several=several)
    if person is None or (several and mentions.thing(first, several=True, strictly=True)):
        return None
    # "The kids finish school at three. Give them a snack"
    person = _inside(person, mentions.lexicon)
    return f"{person} {rest}" if rest else person
