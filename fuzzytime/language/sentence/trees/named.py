"""What an object names: a thing or a person, one or several; what pronouns may stand for."""

from collections.abc import Sequence

from fuzzytime.english import singular
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.timetables import has_time
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.trees.tags import PAST
from fuzzytime.language.sentence.trees.tree import Node, Tree

TOPIC = "dislocated"
"""The relation of what is named in front to what is done with it."""

SAID_BY = "said by"
"""The relation of who says what will be to that."""


def topic_of(tree: Tree) -> str | None:
    """Give what is named in front of a time, and done with behind that; None where nothing is."""
    thing = next((place for place, node in enumerate(tree.nodes) if node.relation == TOPIC), None)
    return None if thing is None else tree.typed(sorted(tree.below(thing)))


def names_person(thing: str, lexicon: Lexicon) -> bool:
    """Whether an object names somebody: by a word for persons or animals, or a name without an article."""
    closed = lexicon.closed
    words = [word.text for word in words_of(thing)]
    if not words or words[0] in closed.anaphors | closed.third_person_objects:
        return False
    # "Gym at six" begins with a capital as it begins a sentence.
    capital = thing[:1].isupper() and (lexicon.happening | lexicon.taken).isdisjoint(words)
    # "Next dose is at ten"
    capital = capital and words[0] not in closed.general_ordinals
    return capital or not (lexicon.persons | lexicon.animals).isdisjoint(words)


def calls_somebody(node: Node, lexicon: Lexicon) -> bool:
    """Whether a word is for somebody, or a name: no known word, or none that is done, with its capital."""
    known = node.lower in lexicon.people and node.lower not in lexicon.closed.subject_pronouns
    capital = node.text[0].isupper() and not node.may_act
    return known or (capital and (node.tag == "NNP" or not node.may_name))


def may_be_it(operation: Operation, lexicon: Lexicon) -> bool:
    """Whether "it" or "them" may stand for its object: a thing that is named, and no person."""
    named = operation.object is not None and operation.object.lower() not in lexicon.closed.anaphors
    # "It takes an hour to warm up"
    named = named and not (operation.object or "").startswith("to ")
    return named and not _is_person(operation, lexicon)


def is_event(operation: Operation, lexicon: Lexicon) -> bool:
    """Whether it is told when something is that goes on, and at which no thing is: "handover at noon"."""
    words = [word.text for word in words_of(operation.object or "")]
    timed = lexicon.happening | lexicon.events | lexicon.taken
    return operation.stated and not timed.isdisjoint(words)


def takes_verb(verb: str, first: str, other: str, lexicon: Lexicon) -> bool:
    """Whether what is done with a thing, or somebody, is done with another: they are of one kind.

    What happens, or is done by itself, takes the verb of what is such a thing too, or a verb for that: "ring
    bob at six, lunch at one", but "cancel lunch today and dinner tomorrow", "make the beds, lunch at one".
    A chore alone is no thing, nor is what undoes the first: "open the shop at ten and close at six".
    """
    alone = other.strip().lower()
    if alone in lexicon.chores or verb in lexicon.undoing.get(alone, ()):
        return False
    if not is_of_its_own(other, lexicon) or is_of_its_own(first, lexicon):
        return True
    called = verb in lexicon.addressing and names_person(other, lexicon)
    for_events = verb in lexicon.doing.of_events | lexicon.appointing and not names_person(first, lexicon)
    return called or for_events


def may_have_it_done(verb: str, named: Node, lexicon: Lexicon) -> bool:
    """Whether what a word begins to name may be what a verb is done with: to walk is no "biscuit"."""
    alive = lexicon.people | lexicon.animals | lexicon.closed.noun_openers
    noun = named.may_name and named.tag.startswith("NN")
    return verb not in lexicon.doing.with_the_living or not noun or named.lower in alive


def is_of_its_own(thing: str, lexicon: Lexicon) -> bool:
    """Whether words name what happens, or is done, without a verb: "a nap", "the party"; but "the gym"."""
    words = _named_itself(thing, lexicon) or [""]
    first, last = words[0], words[-1]
    if first in lexicon.closed.noun_openers - lexicon.closed.indefinite_determiners:
        # "The school", "the bus", "the dinner" and "the doctor" are things and persons.
        surely = lexicon.events | ((lexicon.happening & lexicon.taken) - lexicon.travelling)
        return last in surely and not lexicon.means(last, "meal")
    # "For lunch", "in bed", "Bob home", "lights out"
    where = lexicon.places | lexicon.particles.keys()
    placed = first in lexicon.closed.prepositions_of_nouns or (first != last and last in where)
    known = lexicon.events | lexicon.happening | lexicon.taken
    return not placed and (last in known or (last,) in lexicon.conversation["by itself"])


def _is_person(operation: Operation, lexicon: Lexicon) -> bool:
    # "The meeting with Tom" is no person.
    named = _named_itself(operation.object or "", lexicon)
    return operation.lemma in lexicon.addressing or not lexicon.persons.isdisjoint(named)


def is_several(thing: str, lexicon: Lexicon) -> bool:
    """Say whether a noun looks like a plural: by what stands before "of" or another preposition."""
    named = _named_itself(thing, lexicon)
    return "and" in (word.text for word in words_of(thing)) or any(
        singular(word) != word for word in named[-1:]
    )


def _named_itself(thing: str, lexicon: Lexicon) -> list[str]:
    """Give the words of a noun before a preposition that tells more of it: "the meeting | with Tom"."""
    words = [word.text for word in words_of(thing)]
    inside = (place for place, word in enumerate(words) if word in lexicon.closed.prepositions_of_nouns)
    return words[: next((place for place in inside if place), len(words))]


def names_one(nodes: Sequence[Node], lexicon: Lexicon) -> bool:
    """Whether nouns name one thing, whatever the first may ask for: "weight check"; but "grease tin".

    That is so by the last: it happens, is done, is looked up, or comes. Who is often asked for something is
    only in front of what happens: "press conference". Nor is anybody asked to miss "miss finch".
    """
    further = nodes[1:]
    if not further or any(node.tag not in {"NN", "NNP"} for node in further):
        return False
    first, last, doing = nodes[0], further[-1].lower, lexicon.doing
    if first.lower in lexicon.beside.titles_of_persons and not has_time(last, lexicon):
        return True
    if not first.may_name or first.relation != "compound" or first.tag not in {"NN", "JJ"}:
        return False
    appoints = doing.of_events | lexicon.appointing | lexicon.rescheduling
    happens = last in lexicon.happening | lexicon.taken and not lexicon.means(last, "meal")
    asked = lexicon.orders | lexicon.addressing | doing.errands
    known = lexicon.orders.union(lexicon.amount_nouns, lexicon.workers, lexicon.reading)
    return first.lower not in appoints and (happens or (last in known and first.lower not in asked))


def is_none(tree: Tree, root: int) -> bool:
    """Whether nothing is to be: "no calls between twelve and one", "there is no school on friday"."""
    named = [root]
    if tree.children(root, "expl") and not any(tree.nodes[p].tag == "VB" for p in tree.below(root)):
        # "There is no need to call" is no more than that.
        named += tree.children(root, "attr")
    return any(tree.nodes[p].lower == "no" and p < noun for noun in named for p in tree.children(noun, "det"))


def is_shut(site: Node, state: Node, lexicon: Lexicon) -> bool:
    """Whether nobody can go somewhere, which nobody is asked to close: "school closed", not "gate closed"."""
    return (
        state.tag in PAST and state.lemma in lexicon.doing.closing_up and site.lower in lexicon.beside.sites
    )
