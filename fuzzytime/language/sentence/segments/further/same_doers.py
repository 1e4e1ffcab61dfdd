"""What somebody does next, who is not named again: "Kestrel takes off at 1030, surveys a field, lands"."""

from collections.abc import Iterator, Mapping
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.language.sentence.segments.source import Source
from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.trees.tags import SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.language.sentence.verbs.statements.called import worker_doing


def done_next(source: Source, parts: Mapping[int, Part]) -> Iterator[Part]:
    """Give the parts, by where they begin, that say what the one of the part before does next.

    Each has in its segment who that is, and its verb has the ending for one.
    """
    before: Part | None = None
    for start in sorted(parts):
        part = parts[start]
        if before is not None and part.segment.doer is None and _goes_on(source, before, part):
            doer, asked = _doer(before)
            if doer is not None:
                called = doer if asked else part.segment.addressee
                segment = replace(part.segment, doer=doer, addressee=called, verbless=False)
                part = replace(part, segment=segment)
                yield part
        before = part


def are_joints(between: str, lexicon: Lexicon) -> bool:
    """Whether nothing else stands between what one does first and next: "", ",", ", and"."""
    return lexicon.closed.joints_of_things.issuperset(between.lower().split())


def tells_more(part: Part) -> bool:
    """Whether it says what one does next who was named before: "…, then lands"."""
    tree = part.tree
    return part.segment.doer is not None and bool(tree.nodes) and tree.nodes[tree.root].tag == "VBZ"


def _doer(part: Part) -> tuple[str | None, bool]:
    """Give who does what a part tells, and whether that one is asked: "robot 2 cleans the tank"."""
    segment, tree, root = part.segment, part.tree, part.tree.root
    if segment.doer is not None:
        return segment.doer, segment.doer == segment.addressee
    if not tree.nodes or tree.nodes[root].tag != "VBZ":
        return None, False
    worker = worker_doing(tree, root)
    if worker is not None:
        return worker, True
    subjects = [p for p in tree.children(root, *SUBJECTS) if p < root]
    if not subjects or tree.nodes[subjects[0]].tag in {"WDT", "WP", "EX"}:
        return None, False
    first, end = tree.reach(subjects[0])
    named = tree.text[tree.nodes[first].start : tree.nodes[end - 1].end] if end <= root else ""
    return named or None, False


def _goes_on(source: Source, before: Part, part: Part) -> bool:
    """Whether a part begins with a verb that only one can do, in the sentence of the part before."""
    text, first = source.scanned.text, part.segment.span[0]
    between = text[before.segment.span[1] : first].lower()
    then = part.segment.connective == "then" and not ENDS & set(between)
    if part.offset != first or not (then or are_joints(between, part.lexicon)):
        return False
    surely = then or not part.lexicon.closed.additive_conjunctions.isdisjoint(between.split())
    return _begins_doing(part.tree, surely=surely and not part.segment.verbless)


def _begins_doing(tree: Tree, *, surely: bool) -> bool:
    """Whether the first word is what one does; a plural may be a thing: "…, drinks at seven"."""
    if not tree.nodes:
        return False
    node, doing = tree.nodes[0], tree.lexicon.doing
    if not node.may_act or not node.lower.endswith("s") or node.lower == node.lemma:
        return False
    if any(p < tree.root for p in tree.children(tree.root, *SUBJECTS)):
        return False
    # "The drone takes off at nine, lands at ten"
    moves = node.lower in doing.timed or node.lemma in doing.arriving | doing.leaving
    return node.tag in {"VBZ", "VB"} or (node.tag == "NNS" and (surely or moves))
