"""What tells how things are, beside what is to be done: "…, she's sleeping", "…, it is cheaper then"."""

from fuzzytime.language.instruction import overlap
from fuzzytime.language.meaning.expressions import Phrase, TimeWord
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.trees import tags
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.language.sentence.verbs.statements.beside_orders import subjects_before

PRESENT = frozenset({"now", "then", "beforehand"})
"""Time words of when things are so: now, when what is asked for is done, or until then."""

GOT = "got"

DESCRIBING = ("acomp", "prep", "advmod")
"""What says how somebody or something is: "he's hungry", "I'm in a meeting", "she's there"."""


def tells_how_things_are(sketch: Sketch) -> bool:
    """Whether a sentence says how things are, at no time of its own: perhaps why something is asked for."""
    tree, closed = sketch.part.tree, sketch.lexicon.closed
    # "Wash the kit by noon, sam has training"
    own = [phrase for phrase in sketch.phrases if overlap(phrase.span, sketch.part.segment.span)]
    if not tree.nodes or sketch.clauses or not all(map(_is_present, own)):
        return False
    root = tree.root
    # "There are tins in the cupboard"; but "there is milk to buy"
    there = "there" in tree.said(tree.children(root, "expl")) and sketch.operation is None
    if not (there or subjects_before(tree, root)):
        return False
    if tree.nodes[root].lower in closed.present_be:
        return there or any(place > root for place in tree.children(root, *DESCRIBING))
    helping = tree.said(tree.children(root, "aux"))
    # "I'm knackered": a tree may have that for what is done to somebody.
    helping |= tree.said(tree.children(root, "auxpass")) if tree.nodes[0].tag == "PRP" else set()
    going_on = tree.nodes[root].tag in {"VBG", "VBN"} and bool(helping) and helping <= closed.present_be
    # "They shut then"
    happens = bool(own) and sketch.operation is not None and sketch.operation.stated
    node = tree.nodes[root]
    happens = happens and (node.tag in tags.PRESENT or node.lower == node.lemma)
    return going_on or happens or holds_true(tree)


def holds_true(tree: Tree) -> bool:
    """Whether it tells what somebody has, wants or knows: "bob needs it"; "we need eggs" asks for some."""
    if not tree.nodes or not subjects_before(tree, tree.root):
        return False
    root, closed, doing = tree.root, tree.lexicon.closed, tree.lexicon.doing
    node, things = tree.nodes[root], tree.said(tree.children(root, "dobj"))
    helping = [tree.nodes[place] for place in tree.children(root, "aux")]
    # "We don't have any"
    finite = node.tag in tags.PRESENT or any(one.lemma == "do" for one in helping)
    # "I've got an interview"
    got = node.lower == GOT and any(one.lower in closed.have for one in helping)
    asked = node.lemma in doing.needing or node.lower in closed.have | {GOT}
    if tree.children(root, "ccomp") or (asked and tree.children(root, "xcomp")):
        # "Bob needs to be called"; but "he likes to chat"
        return False
    described = node.lemma in doing.being and bool(tree.children(root, "acomp"))
    asks = node.lemma in doing.requiring and things.isdisjoint(closed.object_pronouns)
    return got or (finite and (described or (node.lemma in doing.holding_true and not asks)))


def _is_present(phrase: Phrase) -> bool:
    """Whether a time is when things are so, and no other: "then", "until then", "now"."""
    time = phrase.said.time
    return isinstance(time, TimeWord) and time.word in PRESENT
