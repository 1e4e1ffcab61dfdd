"""Why an instruction asks for nothing, as one that is about others does: "swap the two calls"."""

from collections.abc import Sequence

from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.language import Instruction, Lexicon, Reading, content_words, nouns_of
from fuzzytime.language.grammar.words import words_of

AND = "and"
TWO = 2


def why_nothing(
    instruction: Instruction, reading: Reading, before: Sequence[Interpreted], lexicon: Lexicon
) -> str | None:
    """Say why an instruction asks for nothing; None where it asks for something.

    ``before`` is what was asked for before it.
    """
    if instruction.operation is None:
        return "says a time but nothing to do"
    if _is_about_others(instruction, before, lexicon):
        words = reading.text[slice(*instruction.span)].strip(" .!")
        return f"{words!r} is about what was asked for before: say anew what is meant"
    if _only_tells(instruction, lexicon):
        return "tells what is, and says nothing to do"
    return "asks for something not to be done" if instruction.operation.negated else None


def _only_tells(instruction: Instruction, lexicon: Lexicon) -> bool:
    """Whether it is told what somebody or something has, and not when: "Gareth's got a cold"."""
    operation = instruction.operation
    if operation is None or not operation.stated or operation.attended:
        return False
    has = operation.lemma in lexicon.doing.holding_true | lexicon.doing.getting
    return has and not instruction.requirements and instruction.duration is None


def _is_about_others(instruction: Instruction, before: Sequence[Interpreted], lexicon: Lexicon) -> bool:
    """Whether something is only said of what was asked for before."""
    operation = instruction.operation
    if operation is None or not operation.is_asked or operation.object is None:
        return False
    form = tuple(operation.phrase.split())
    swaps = form in lexicon.conversation["swapping"]
    if not swaps and form not in lexicon.conversation["dropping"]:
        return False
    asked = [_named_by(one) for one in before if one.operation is not None]
    sides = [content_words(side) for side in operation.object.split(f" {AND} ")]
    if swaps and len(sides) == TWO and all(sides):
        return all(any(side <= known for known in asked) for side in sides)
    words = {word.text for word in words_of(operation.object)}
    counted = {word for word in words if word in lexicon.closed.both or lexicon.numbers.get(word) == TWO}
    names = content_words(operation.object) - counted
    return bool(counted) and sum(names <= known for known in asked) == TWO


def _named_by(one: Interpreted) -> frozenset[str]:
    """Give the words that name a skill: those of its name, and the nouns of its verb."""
    verbs = () if one.operation is None else nouns_of(one.operation.lemma)
    return content_words(one.skill.name) | frozenset(verbs)
