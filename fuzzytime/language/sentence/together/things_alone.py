"""Things that a list under a day names, and no more: they are to be seen to then: "today: bins, post"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.together.listed_days import heads_list

LONGEST = 3
"""Words of such a thing at most."""

NAMES = ("NN", "VB", "JJ")
"""How the tags of words begin that may name one."""


def things_alone(sketches: Sequence[Sketch], text: str, *, headed: bool) -> list[Sketch]:
    """Give what a list with a head names its place among what is to be done; ``headed`` by a line above."""
    if not headed and not (sketches and heads_list(sketches[0], text)):
        return list(sketches)
    return [_to_be_done(sketch, text) if sketch.operation is None else sketch for sketch in sketches]


def _to_be_done(sketch: Sketch, text: str) -> Sketch:
    """Give a thing that is named alone, beside its time or without, as what is to be done."""
    tree, offset = sketch.part.tree, sketch.part.offset
    heard = sketch.heard
    words = [
        node
        for node in tree.nodes
        if node.text[0].isalnum() and not any(a <= node.start + offset < b for a, b in heard)
    ]
    named = 0 < len(words) <= LONGEST and all(word.tag.startswith(NAMES) for word in words)
    if not named or sketch.clauses:
        return sketch
    first, end = words[0].start + offset, words[-1].end + offset
    said = text[first:end].lower()
    apart = len(words_of(said)) != len(words)
    inside = tree.lexicon.function_words.isdisjoint(word.lower for word in words)
    if apart or not inside:
        return sketch
    return replace(sketch, operation=Operation(verb=said, lemma=words[-1].lemma, span=(first, end)))
