"""Orders in front of the root of a tree, taken for its subject or its helping verb: "have the vacuum go"."""

from fuzzytime.language.sentence.trees.tags import SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree


def order_before(tree: Tree, root: int) -> int:
    """Give the bare verb in front that a tree took for a subject or an auxiliary: "have the vacuum go"."""
    for place in tree.children(root, "csubj", "aux", "auxpass"):
        node = tree.nodes[place]
        if node.relation == "auxpass":
            # "Get dressed"
            if (
                node.lemma == "get"
                and node.tag in {"VB", "VBP"}
                and not tree.children(root, "aux", *SUBJECTS)
            ):
                return place
            continue
        bare = node.is_bare and not tree.children(place, "aux", *SUBJECTS)
        if bare and (node.relation == "csubj" or (node.lemma == "have" and _brings(tree, place, root))):
            return place
    subjects, so = tree.children(root, *SUBJECTS), is_purpose(tree, root)
    if subjects and (so or tree.nodes[root].tag in {"VBZ", "VBD"}):
        # "Serve the soup the second it boils": the clause was taken for the sentence.
        for place in tree.children(root, "advcl", "ccomp"):
            if place < min(tree.children(root, *SUBJECTS)) and tree.nodes[place].tag == "VB":
                led = [p for p in tree.children(place, "advmod") if p < place]
                # "Can you set an alarm so I don't miss it"
                bound = tree.children(place, "mark", *(() if so else ("aux", *SUBJECTS)))
                return root if bound or (led and not so) else place
    return root


def is_purpose(tree: Tree, root: int) -> bool:
    """Whether "so" leads to who does what a verb says: "brief the crew by noon so I can relax"."""
    begin = max((tree.reach(place)[0] for place in tree.children(root, *SUBJECTS)), default=0)
    return begin > 0 and tree.nodes[begin - 1].lower in tree.lexicon.closed.subordinators_of_purpose


def _brings(tree: Tree, have: int, root: int) -> bool:
    """Whether a "have" taken for an auxiliary brings something about: "have it washed", "have it running"."""
    between = any(have < place < root for place in tree.children(root, *SUBJECTS))
    return tree.nodes[root].tag == "VB" or (tree.nodes[root].tag in {"VBN", "VBG"} and between)


def is_order(tree: Tree, place: int) -> bool:
    """Whether a verb is an order, and nobody is said to do it."""
    node = tree.nodes[place]
    return (
        node.is_bare
        and node.relation not in {"relcl", "acl", "advcl"}
        and not tree.children(place, *SUBJECTS)
    )


def denied_from(tree: Tree, place: int) -> int | None:
    """Give where a verb begins that is denied: "fill it but don't switch it on"."""
    helping = tree.children(place, "aux")
    denied = bool(tree.children(place, "neg")) and [tree.nodes[p].lower for p in helping] == ["do"]
    return helping[0] if denied else None
