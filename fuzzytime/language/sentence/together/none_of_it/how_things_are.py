"""What tells how things are, beside what is to be done: "…, she's sleeping", "…, it is cheaper then"."""

from fuzzytime.language.meaning.expressions import Phrase, TimeWord
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.verbs.statements.beside_orders import subjects_before

PRESENT = frozenset({"now", "then", "beforehand"})
"""Time words of when things are so: now, when what is asked for is done, or until then."""

DESCRIBING = ("acomp", "prep", "advmod")
"""What says how somebody or something is: "he's hungry", "I'm in a meeting", "she's there"."""


def tells_how_things_are(sketch: Sketch) -> bool:
    """Whether a sentence says how things are, at no time of its own: perhaps why something is asked for."""
    tree, closed = sketch.part.tree, sketch.lexicon.closed
    if not tree.nodes or sketch.clauses or not all(map(_is_present, sketch.phrases)):
        return False
    root = tree.root
    if not subjects_before(tree, root):
        return False
    if tree.nodes[root].lower in closed.present_be:
        return any(place > root for place in tree.children(root, *DESCRIBING))
    helping = tree.said(tree.children(root, "aux"))
    return tree.nodes[root].tag == "VBG" and bool(helping) and helping <= closed.present_be


def _is_present(phrase: Phrase) -> bool:
    """Whether a time is when things are so, and no other: "then", "until then", "now"."""
    time = phrase.said.time
    return isinstance(time, TimeWord) and time.word in PRESENT
