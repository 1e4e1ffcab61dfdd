"""What somebody tells to have done, or to be done: "I've fed the cat", "the boards are cut"."""

from itertools import takewhile

from fuzzytime.english import SHORT_FOR_IS
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation, Reading
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.language.sentence.trees.tags import PAST

SUBJECTS = frozenset({"nsubj", "nsubjpass", "nsubj:pass", "csubj", "expl"})
TO = "TO"
PARTICLES = frozenset({"RB", "RP", "IN"})
BEING = frozenset({"be", "have"})
"""What helps a verb to say how something is."""


def reported(reading: Reading, lexicon: Lexicon) -> Operation | None:
    """Give what somebody tells to have done: "I've fed the cat", "called mum"; None without one."""
    told = _told_of(reading, lexicon)
    return told[0] if told is not None and told[1] else None


def perhaps_reported(reading: Reading, lexicon: Lexicon) -> Operation | None:
    """Give what somebody may tell to have done, if that is known: "watered plants", but also "fried eggs"."""
    told = _told_of(reading, lexicon)
    return None if told is None else told[0]


def _told_of(reading: Reading, lexicon: Lexicon) -> tuple[Operation, bool] | None:
    """Give what words tell to have been done, and whether they surely do."""
    if len(reading.instructions) != 1:
        return None
    (instruction,) = reading.instructions
    operation = instruction.operation
    if operation is None or operation.stated or instruction.requirements:
        return None
    place = next((n for n, token in enumerate(reading.tokens) if token.span == operation.span), None)
    if place is None or reading.tokens[place].tag not in PAST:
        return None
    if any(token.tag == TO and token.head == place for token in reading.tokens):
        # "Gareth needs to be called"
        return None
    verb = operation.verb.lower()
    has_done = any(token.head == place and token.lemma == "have" for token in reading.tokens[:place])
    if not has_done and (verb == operation.lemma or verb in lexicon.doing.past_alike):
        # "I put the bins out" may be what who speaks does, or did; "I've put them out" is not
        return None
    parts = [token for token in reading.tokens if token.head == place and token.relation in SUBJECTS]
    if parts:
        speaks = any(part.text.lower() in lexicon.closed.first_person for part in parts)
        return (operation, True) if speaks else None
    # No order has a past verb; what has one in front may be named so: "fried eggs".
    thing = (operation.object or "").lower()
    first, closed = thing.partition(" ")[0], lexicon.closed
    named = first in closed.noun_openers | closed.anaphors | closed.personal_pronouns | lexicon.persons
    return operation, named or not thing


def told_result(reading: Reading, lexicon: Lexicon) -> frozenset[str]:
    """Give the words that name what is told to be done: "the boards are cut", "bins are out"; else none."""
    being = any(token.lemma in BEING or token.text.lower() in SHORT_FOR_IS for token in reading.tokens)
    small = lexicon.closed.noun_openers.union(form[0] for form in lexicon.conversation["anew"])
    said = [token for token in reading.tokens if token.lemma not in BEING and token.text[:1].isalnum()]
    said = [token for token in said if token.text.lower() not in small]
    things = list(takewhile(lambda token: token.tag.startswith("NN"), said))
    states = said[len(things) :]
    told = bool(things) and any(token.tag in PAST for token in states)
    told = told or (bool(things) and being and len(states) == 1 and states[0].tag in PARTICLES)
    calls = not being and any(token.lemma in lexicon.addressing for token in states)
    if not told or calls or any(token.tag not in PAST | PARTICLES for token in states):
        # "Mum called" tells what mum did.
        return frozenset()
    if reading.text.rstrip().endswith("?") or any(one.requirements for one in reading.instructions):
        return frozenset()
    return content_words(" ".join(token.text for token in things)).union(token.lemma for token in states)
