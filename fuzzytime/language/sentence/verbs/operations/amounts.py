"""Vague amounts of things: "some food", "a few screws", kept for whoever executes the instruction."""

from typing import TYPE_CHECKING

from fuzzytime.language.grammar.lexicon import longest_match
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.language.sentence.verbs.meant.actions import Action
from fuzzytime.language.sentence.verbs.operations.operations import Reader

if TYPE_CHECKING:
    from fuzzytime.skills import FuzzyParameter


def parameters_of(reader: Reader, action: Action) -> tuple["FuzzyParameter", ...]:
    """Give the vague amounts among what the verb governs."""
    tree, amounts = reader.tree, reader.lexicon.amounts
    verb = tree.nodes[action.place]
    words = words_of(tree.text)
    found: list[FuzzyParameter] = []
    behind = 0
    for at, word in enumerate(words):
        timed = any(a <= word.start < b for a, b in reader.times)
        if at < behind or word.start < verb.start or timed:
            continue
        form = longest_match(words, at, amounts)
        if form is None or at + len(form) >= len(words):
            continue
        behind = at + len(form)
        following = next(tree.at(words[behind].start, words[behind].end), None)
        noun = None if following is None else _noun(tree, following)
        if noun is not None and not reader.timed(noun):
            node = tree.nodes[noun]
            _, quantity = amounts[form]
            found.append(_parameter(tree.text[word.start : node.end], node.lower, quantity))
    return tuple(found)


def _noun(tree: Tree, place: int) -> int | None:
    """Give the noun that a word is, or stands before."""
    for here in (place, *tree.above(place)):
        if tree.nodes[here].tag.startswith("NN"):
            return here
        if tree.nodes[here].is_verb:
            return None
    return None


def _parameter(text: str, noun: str, quantity: tuple[float, float, float, float] | None) -> "FuzzyParameter":
    """Make a parameter; skills bring numpy along, so that they are imported only where there is an amount."""
    from fuzzytime.skills import FuzzyParameter

    return FuzzyParameter(text, noun, quantity)
