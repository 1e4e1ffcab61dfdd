"""What tells what was, and whose times are over: "her last turn was at six"."""

from fuzzytime.language.meaning.days.relations import Deictic, Relative
from fuzzytime.language.meaning.expressions import Coming, Offset, Said, Wall
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.trees.tags import SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.language.sentence.verbs.meant.actions import passes_on
from fuzzytime.requirement import Constraint

DONE = ("dobj", "acomp", "attr")
"""What who speaks or is spoken to did, or was: "I fed the cat", "you were late"."""


def tells_what_was(sketch: Sketch) -> bool:
    """Whether a sentence tells what was: "her last turn was at six", "I fed the cat at seven"."""
    tree, closed = sketch.part.tree, sketch.lexicon.closed
    root = tree.root
    if tree.nodes and _has_been(tree, root):
        return True
    due = sketch.operation is not None and sketch.operation.due is not None
    due = due and closed.past_be.isdisjoint(tree.nodes[p].lower for p in tree.children(root, "auxpass"))
    if due and not _names_past(sketch) and (sketch.phrases or sketch.clauses):
        # The dog must be "walked by seven", actors "called for 14:00".
        return False
    if not tree.nodes or tree.nodes[root].lemma in sketch.lexicon.wanting - {"be"} or passes_on(tree, root):
        return False
    node = tree.nodes[root]
    moved_on = (node.lower,) in sketch.lexicon.conversation["rescheduled"]
    if moved_on and sketch.operation is not None and any(p.said.preposition == "to" for p in sketch.phrases):
        # "The dentist was moved to four": it is then; but "I moved the meeting to four".
        return not sketch.operation.stated
    subjects = [p for p in tree.children(root, *SUBJECTS) if p < root]
    helping = tree.said(tree.children(root, "aux", "auxpass"))
    # "The meeting has been moved"
    moved = node.tag == "VBN" and "been" in helping and helping - {"been"} <= closed.have
    # "Dad has dug the bed"; but "they have arrived at six"
    has = node.tag == "VBN" and bool(helping) and helping <= closed.have and not sketch.phrases
    # "Have the hall swept" asks for it.
    has = has and (not subjects or subjects[0] < min(tree.children(root, "aux", "auxpass")))
    # "School finished early yesterday": a tree takes it for what must be done.
    ended = node.tag == "VBN" and not helping and bool(subjects) and _names_past(sketch)
    # "In no time the tent was up"
    led = node.lower in closed.past_be and root > 0
    named = tree.nodes[subjects[0]].lower not in closed.first_and_second_person if subjects else led
    did = bool(subjects) and node.tag == "VBD" and not helping and bool(tree.children(root, *DONE))
    # "I fed the cat", with no time, is news of what was planned.
    did = did and bool(sketch.phrases)
    return (_is_past(tree, root) or moved or has or ended) and (named or did)


def has_done(sketch: Sketch) -> bool:
    """Whether who speaks tells what they have done: "I've put a loaf in"; but "I've got to go"."""
    tree, closed = sketch.part.tree, sketch.lexicon.closed
    if not tree.nodes or tree.children(tree.root, "xcomp") or sketch.phrases:
        return False
    helping = tree.said(tree.children(tree.root, "aux", "auxpass"))
    subjects = tree.said(p for p in tree.children(tree.root, *SUBJECTS) if p < tree.root)
    done = tree.nodes[tree.root].tag == "VBN" and bool(helping) and helping <= closed.have_before_got
    return done and tree.nodes[tree.root].lower != "got" and bool(subjects & closed.first_person)


def _has_been(tree: Tree, root: int) -> bool:
    """Whether it tells what was until now: "rex has been in all morning", "there has been a delay"."""
    node, helping = tree.nodes[root], tree.said(tree.children(root, "aux", "auxpass"))
    lasted = node.lower == "been" or ("been" in helping and node.tag == "VBG")
    known = bool(helping) and helping - {"been"} <= tree.lexicon.closed.have
    return lasted and known and any(p < root for p in tree.children(root, *SUBJECTS, "expl"))


def is_over(sketch: Sketch) -> bool:
    """Whether the times of what tells what was are over: no deadline, and none of what was said to come.

    "They said the parcel would come at noon" tells of a noon ahead.
    """
    tree = sketch.part.tree
    if not tree.nodes or not _is_past(tree, tree.root):
        return False
    subjects = tree.children(tree.root, *SUBJECTS)
    if any(tree.nodes[p].text.endswith("/") for p in subjects):
        # "Tea w/ rose @ 4"
        return False
    return all(
        phrase.said.constraint is not Constraint.BEFORE and _hangs_on_past(sketch, phrase.span[0], tree.root)
        for phrase in sketch.phrases
    )


def _is_past(tree: Tree, root: int) -> bool:
    """Whether a verb is in the past itself: "fed", "was fed"; but not "has been moved to four"."""
    node = tree.nodes[root]
    helping = tree.said(tree.children(root, "aux", "auxpass"))
    alone = node.tag == "VBD" and node.lower != node.lemma and not helping
    return alone or bool(helping & tree.lexicon.closed.past_be)


def _hangs_on_past(sketch: Sketch, start: int, root: int) -> bool:
    """Whether the verb nearest above a time is the root, or is in the past as that is."""
    tree, offset = sketch.part.tree, sketch.part.offset
    place = next((p for p, node in enumerate(tree.nodes) if node.start + offset >= start), root)
    for above in (place, *tree.above(place)):
        if above == root:
            return True
        if tree.nodes[above].tag in {"VB", "VBZ", "VBP", "VBD"}:
            return tree.nodes[above].tag == "VBD"
    return True


def _names_past(sketch: Sketch) -> bool:
    """Whether a time is said that is over: "yesterday", "last week", "an hour ago"."""
    return any(_lies_behind(phrase.said) for phrase in sketch.phrases)


def _lies_behind(said: Said) -> bool:
    """Whether a time is said as one before now."""
    time = said.time
    if isinstance(time, Wall):
        days = time.days
        return (isinstance(days, Relative) and days.days < 0) or (
            isinstance(days, Deictic) and days.which.offset < 0
        )
    counted = isinstance(time, Offset) and time.anchor is None and time.direction < 0
    return counted or (isinstance(time, Coming) and time.direction < 0)
