"""What something is set to, and what it is for, where trees take that for an aim of the setting.

"Set the fan to high at nine" says how it is set, and "set an alarm to wake me at seven" which alarm.
"""

from collections.abc import Set as AbstractSet

from fuzzytime.language.sentence.trees.tags import SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree


def with_aim(tree: Tree, timed: AbstractSet[int]) -> Tree:
    """Give a tree in which the aim right behind a thing is said of it, or is what that is set to."""
    lexicon = tree.lexicon
    root = tree.root
    for thing in tree.children(root, "dobj"):
        to = max((p for p in tree.below(thing)), default=thing) + 1
        aim = to + 1
        if aim >= len(tree.nodes) or tree.nodes[to].lower != "to" or tree.nodes[to].head != aim:
            continue
        if tree.nodes[aim].head != root or tree.nodes[aim].relation not in {"advcl", "xcomp"}:
            continue
        if tree.nodes[thing].lower in lexicon.doing.labels | lexicon.appointing:
            return tree.changed(aim, relation="acl", head=thing)
        if tree.nodes[root].lemma in lexicon.letting or tree.nodes[aim].lemma in lexicon.indicators:
            # "Leave it to soak", "set the dishwasher to finish at five"
            return tree.changed(aim, relation="xcomp")
        setting = lexicon.doing.setting | lexicon.measure_verbs | lexicon.beside.switched
        said = [p for p in tree.below(aim) if p not in {to, aim} and tree.nodes[p].text[0].isalnum()]
        if tree.nodes[root].lemma in setting and set(said) <= timed:
            return _set_to(tree, root, to)
    return tree


def with_purpose(tree: Tree) -> Tree:
    """Give "so" to the clause that it leads, where a tree takes it for a thing: "ring bob so I can sleep"."""
    for so in tree.children(tree.root, "dobj"):
        behind = tree.nodes[so + 1 : so + 2]
        leads = any(node.relation in SUBJECTS and node.head > so for node in behind)
        if leads and tree.nodes[so].lower in tree.lexicon.closed.subordinators_of_purpose:
            return tree.changed(so, relation="mark", head=behind[0].head).changed(
                behind[0].head, relation="advcl"
            )
    return tree


def _set_to(tree: Tree, root: int, to: int) -> Tree:
    """Make a word behind "to" what something is set to, and give the verb its times."""
    aim = to + 1
    led = tree.hung(tree.children(aim), root).changed(to, tag="IN", relation="prep", head=root)
    return led.changed(aim, tag="NN", relation="pobj", head=to)
