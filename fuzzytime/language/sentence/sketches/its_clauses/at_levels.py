"""Levels that say when, without a marker: "at 60 degrees add the yeast", "stop charging at 90%"."""

from collections.abc import Sequence

from fuzzytime.language.grammar.words import Word
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.clauses.conditions import at_level
from fuzzytime.language.sentence.clauses.levels import level_end
from fuzzytime.language.sentence.trees.tree import Tree

AT = "at"


def clause_of_level(tree: Tree, words: Sequence[Word], place: int) -> Clause | None:
    """Read a level in front of what is to be done, or behind what one does then; None where it says how.

    "Bake it at 180 degrees" says how.
    """
    end = level_end(words, place, tree.lexicon)
    doing = tree.lexicon.doing
    switching = doing.at_levels if end and words[place].text == AT else doing.beyond_levels
    if end is None or (place and switching.isdisjoint(_done(tree))):
        return None
    span = (words[place].start, words[end - 1].end)
    text = tree.text[slice(*span)]
    return Clause("when", words[place].text, span, span, condition=at_level(text, text, tree.lexicon))


def _done(tree: Tree) -> set[str]:
    """Give what is done, without and with its particle: "turn", "turn off"."""
    verb = tree.nodes[tree.root].lemma if tree.nodes else ""
    behind = (node.lower for node in tree.nodes[tree.root + 1 :] if node.lower in tree.lexicon.particles)
    return {verb, *(f"{verb} {particle}" for particle in behind)}
