"""What somebody is reminded of behind a clause: "remind me when i get home to put the wash on"."""

from fuzzytime.language.sentence.trees.tree import Tree

LEAST = 2
"""Words of "remind me", before a clause."""

WITHIN = ("advcl", "xcomp", "relcl", "acl", "ccomp")
"""How a tree hangs such a verb on the clause before it."""


def with_reminded(tree: Tree) -> Tree:
    """Give "remind me once it is over to lock up" what is to be done, which a tree hangs on the clause.

    What says more of a word of the clause stays there: "remind me when it is time to leave".
    """
    root = tree.root
    if root != 0 or tree.nodes[0].lemma not in tree.lexicon.addressing or tree.children(root, "xcomp"):
        return tree
    reminded = tree.children(root, "dobj", "dative")
    for verb in range(LEAST + 1, len(tree.nodes)):
        to = verb - 1
        node = tree.nodes[verb]
        led = tree.nodes[to].lower == "to" and tree.nodes[to].head == verb and node.tag == "VB"
        if not reminded or not led or node.relation not in WITHIN or node.head == root:
            continue
        if not _ends_clause(tree, to - 1):
            continue
        return tree.changed(verb, head=root, relation="xcomp")
    return tree


def _ends_clause(tree: Tree, place: int) -> bool:
    """Whether no verb and no word that "to" says more of stands at a place."""
    node = tree.nodes[place]
    site = node.lower in tree.lexicon.beside.sites
    return site or not (node.tag.startswith(("VB", "MD")) or node.lower in tree.lexicon.doing.more_said_of)
