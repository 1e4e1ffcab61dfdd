"""Trees mended where a part of what is named hangs elsewhere: "light the deck oven", "year 9 trip money"."""

import re
from collections.abc import Set as AbstractSet
from dataclasses import replace

from fuzzytime.language.grammar.timetables import has_time
from fuzzytime.language.sentence.segments.mended.last_nouns import NAMES, with_last_noun, with_things_around
from fuzzytime.language.sentence.segments.mended.mended_verbs import with_deed_named
from fuzzytime.language.sentence.trees.tags import DETERMINERS, SINGULAR, SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree

BELOW_ZERO = re.compile(r"[-−]\d+(\.\d+)?$")
"""A number below zero, which a tree takes for a mark."""

PERSONS = frozenset({"NNP", "PRP"})
"""Tags of who is named."""

PARTS = ("det", "poss", "amod", "nummod", "compound", "nmod")
"""Relations of the words before a thing that are said of it."""

BESIDE = frozenset({"advcl", "npadvmod"})
"""Relations of what a tree has beside what is done."""

DESCRIBING = frozenset({"RB", "JJ"})
"""Tags of words that name nobody."""


def with_whole_things(tree: Tree) -> Tree:
    """Give a tree whose things have all their words."""
    tree = with_things_around(with_deed_named(_with_subject(_with_thing_done(tree))))
    return _with_level(
        _with_next_one(
            _with_numbered_subject(
                with_last_noun(
                    _with_second(
                        _with_somebody(_with_people(_with_apposed(_with_surname(_with_title(tree)))))
                    )
                )
            )
        )
    )


def _with_thing_done(tree: Tree) -> Tree:
    """Give "dad does breakfast", "mum does the school run" its thing, which a tree takes for the verb."""
    thing = tree.root
    for does in (place for place in tree.children(thing, "aux") if place < thing):
        told = tree.nodes[does].lower == "does" and any(p < does for p in tree.children(thing, *SUBJECTS))
        led = thing == does + 1 or tree.nodes[does + 1].tag in DETERMINERS
        if told and led and not tree.children(thing, "neg", "dobj", "xcomp", "ccomp"):
            apart = [p for p in tree.children(thing) if not does < p < thing]
            for part in tree.children(thing, "nsubj"):
                tree = tree if part < does else tree.changed(part, relation="compound")
            tree = tree.hung(apart, does).changed(does, tag="VBZ", relation="ROOT", head=does)
            return tree.changed(thing, tag="NN", relation="dobj", head=does)
    return tree


def _with_people(tree: Tree) -> Tree:
    """Give "wake oliver at seven" who is woken, whose small letter makes a tree take a name for an adverb."""
    nodes = list(tree.nodes)
    for place, node in enumerate(nodes):
        if _is_called_like_modal(tree, place):
            # "Call ella and will at six"
            nodes[place] = replace(node, tag="NNP", relation="conj", head=place - 2)
            nodes[place - 1] = replace(nodes[place - 1], head=place - 2)
            nodes[node.head] = replace(nodes[node.head], relation="prep", head=nodes[place - 2].head)
        if node.tag == "JJR" and node.lower in tree.lexicon.persons and _is_led(tree, place):
            # "Cleaner at ten"
            nodes[place] = replace(node, tag="NN", lemma=node.lower)
        if node.lower in tree.lexicon.people and (node.tag in DESCRIBING or node.relation in BESIDE):
            # "Pick up bob at the station"
            verb = place - 1 - (nodes[place - 1].tag == "RP")
            behind_verb = node.head == verb and nodes[verb].is_verb
            # "Wake oliver at seven am", where a tree has the last word for what is woken
            relation = "dative" if tree.children(verb, "dobj") else "dobj"
            nodes[place] = replace(node, tag="NNP", relation=relation if behind_verb else node.relation)
            if nodes[place - 1].relation == "dobj" and nodes[place - 1].head == node.head:
                # "Wake uncle joe"
                nodes[place] = replace(node, tag="NNP", relation="dobj")
                nodes[place - 1] = replace(nodes[place - 1], relation="compound", head=place)
    return tree if nodes == list(tree.nodes) else tree.with_nodes(nodes)


def _is_led(tree: Tree, place: int) -> bool:
    """Whether a word is the first, or stands behind an article, and no other is named by it."""
    behind = tree.nodes[place + 1 : place + 2]
    named = any(node.tag.startswith(("NN", "JJ")) for node in behind)
    return not named and (place == 0 or tree.nodes[place - 1].tag in DETERMINERS)


def _with_title(tree: Tree) -> Tree:
    """Give "miss finch at ten" her name: nobody is asked to miss what has no time of its own."""
    if tree.root or 1 not in tree.children(0, "dobj"):
        return tree
    titles = tree.lexicon.beside.titles_of_persons
    if tree.nodes[0].lower not in titles or has_time(tree.nodes[1].lower, tree.lexicon):
        return tree
    named = tree.hung((place for place in tree.children(0) if place > 1), 1)
    named = named.changed(1, tag="NNP", relation="ROOT", head=1)
    return named.changed(0, tag="NNP", relation="compound", head=1)


def _with_surname(tree: Tree) -> Tree:
    """Give "bring mrs tran some soup" her name, which a tree that does not know it takes for a verb."""
    titles = tree.lexicon.beside.titles_of_persons
    for place in range(1, len(tree.nodes)):
        title, node = tree.nodes[place - 1 : place + 1]
        if title.lower not in titles or place == tree.root or title.head in {place, place - 1}:
            continue
        if node.may_act or not node.text.isalpha() or node.lower in tree.lexicon.function_words:
            continue
        verb = title.head
        relation = "dative" if tree.children(place, "dobj") else title.relation
        named = tree.hung(tree.children(place), verb).changed(place, tag="NNP", relation=relation, head=verb)
        return named.changed(place - 1, relation="compound", head=place)
    return tree


def _with_apposed(tree: Tree) -> Tree:
    """Give "ring uncle joe" his whole name, and "text leo the address" both, which a tree has for one."""
    for second in tree.children(tree.root, "appos"):
        first = tree.reach(second)[0] - 1
        if first not in tree.children(tree.root, "dobj"):
            continue
        named = tree.changed(second, relation="dobj")
        if tree.children(second, "det", "poss"):
            return named.changed(first, relation="dative")
        return named.changed(first, relation="compound", head=second)
    return tree


def _is_called_like_modal(tree: Tree, place: int) -> bool:
    """Whether what a tree has for a helping verb, and helps none, is somebody beside another."""
    node = tree.nodes[place]
    beside = (
        node.tag == "MD"
        and place > 1
        and tree.nodes[place - 1].tag == "CC"
        and tree.nodes[place - 2].tag.startswith("NN")
    )
    return beside and tree.nodes[node.head].tag == "IN" and node.head == place + 1


def _with_second(tree: Tree) -> Tree:
    """Give "chop the onions and the May turnips" both things, where a tree hangs the second on the verb."""
    root = tree.root
    if not tree.nodes[root].is_verb:
        return tree
    for thing in tree.children(root, "dobj"):
        joints = tree.children(thing, "cc")
        for second in tree.children(root, "conj"):
            named = tree.nodes[second].tag in NAMES and bool(tree.children(second, "det"))
            # "Remind me and Jo at six"
            both = second == thing + 2 and {tree.nodes[thing].tag, tree.nodes[second].tag} <= PERSONS
            joint = tree.reach(second)[0] - 1
            if both or (named and joint in joints):
                return tree.hung((joint, second), thing)
    return tree


def _with_somebody(tree: Tree) -> Tree:
    """Give "help grandpa after lunch" who is helped, whom a tree has for what is done."""
    root = tree.root
    for person in tree.children(root, "xcomp", "ccomp"):
        node = tree.nodes[person]
        if person != root + 1 or node.may_act or node.tag not in {"VB", "VBP"}:
            continue
        helped = tree.hung(tree.children(person), root)
        return helped.changed(person, tag="NN", relation="dobj", lemma=node.lower, head=root)
    return tree


def _with_numbered_subject(tree: Tree) -> Tree:
    """Give "year 9 trip money has to be in" the word before its number, which hangs on the verb."""
    root = tree.root
    for subject in tree.children(root, *SUBJECTS):
        first = tree.reach(subject)[0]
        if first != 1 or tree.nodes[first].tag != "CD":
            continue
        node = tree.nodes[0]
        if node.relation == "npadvmod" and node.tag in SINGULAR:
            return tree.changed(0, relation="compound", head=subject)
    return tree


def _with_subject(tree: Tree) -> Tree:
    """Give "call time for crew is ten" what it is about: what asks for something is never so."""
    root = tree.root
    led = tree.nodes[root].lemma in tree.lexicon.closed.lemmas_of_be and 0 in tree.children(root, "csubj")
    if not led or 1 not in tree.children(0, "dobj") or tree.nodes[0].tag != "VB":
        return tree
    named = tree.hung((place for place in tree.children(0) if place > 1), 1)
    return named.changed(1, relation="nsubj", head=root).changed(0, tag="NN", relation="compound", head=1)


def _with_next_one(tree: Tree) -> Tree:
    """Give "next on-call takes over" who does it, whose first word a tree hangs on the verb."""
    root = tree.root
    if not root or tree.nodes[root].tag != "VBZ" or tree.children(root, *SUBJECTS):
        return tree
    first = tree.nodes[0]
    if first.relation != "advmod" or first.tag != "JJ" or first.head != root or tree.reach(0) != (0, root):
        return tree
    return tree.changed(0, relation="nsubj", tag="NN")


def _with_level(tree: Tree) -> Tree:
    """Give "keep it below -60" its number, which was taken for a bracket."""
    for place in range(1, len(tree.nodes)):
        before, node = tree.nodes[place - 1 : place + 1]
        bare = not any(p > place - 1 for p in tree.children(place - 1))
        if BELOW_ZERO.match(node.text) and node.relation == "punct" and before.tag == "IN" and bare:
            tree = tree.changed(place, tag="CD", relation="pobj", head=place - 1)
    return tree


def with_event_names(tree: Tree, timed: AbstractSet[int]) -> Tree:
    """Give "have a quiz night" its thing, whose last word a tree has for when that is."""
    for place in range(1, len(tree.nodes)):
        before, node = tree.nodes[place - 1 : place + 1]
        known = node.lower in tree.lexicon.beside.ending_names and node.relation == "npadvmod"
        if not known or place in timed or place - 1 in timed or not tree.nodes[node.head].is_verb:
            continue
        beside = before.head == node.head and before.relation in {"dobj", "pobj"}
        if beside and before.tag.startswith("NN"):
            tree = tree.hung((p for p in tree.children(place - 1) if p < place), place)
            tree = tree.changed(place - 1, relation="compound", head=place)
        elif before.head != place:
            continue
        tree = tree.changed(place, relation="dobj")
    return tree


def with_bare_thing(tree: Tree, timed: AbstractSet[int]) -> Tree:
    """Give "swab counter", "clean oven at six" its thing, which a tree takes for where or how."""
    root, place = tree.root, tree.root + 1
    if not tree.nodes[root].is_bare or tree.children(root, "dobj", *SUBJECTS) or place in timed:
        return tree
    lexicon = tree.lexicon
    where = lexicon.places | lexicon.particles.keys() | lexicon.function_words
    for thing in tree.children(root, *BESIDE, "advmod"):
        node = tree.nodes[thing]
        # "Text jo this evening", "preheat oven at six"
        named = node.tag.startswith("NN") or node.lower in lexicon.measure_nouns
        named = named or tree.nodes[root].lemma in lexicon.addressing
        if thing == place and named and node.lower not in where:
            return tree.changed(thing, relation="dobj", tag=node.tag if node.tag in NAMES else "NN")
    return tree


def with_her(tree: Tree, timed: AbstractSet[int]) -> Tree:
    """Give "turn her two-hourly" who is turned, whom a tree takes for an owner: nobody owns a time."""
    for place in range(1, len(tree.nodes) - 1):
        before, node = tree.nodes[place - 1 : place + 1]
        if node.tag == "PRP$" and node.relation == "poss" and place + 1 in timed and before.is_verb:
            tree = tree.changed(place, tag="PRP", relation="dobj", head=place - 1)
    return tree


def with_thing_before_time(tree: Tree, timed: AbstractSet[int]) -> Tree:
    """Give "give the cat her pill morning and night" its thing, which a tree takes for a part of the time."""
    for place in sorted(timed):
        node = tree.nodes[place]
        parts = [p for p in tree.children(place, *PARTS) if p < place and p not in timed]
        thing = parts[-1] if parts else 0
        # "Feed starter 11.45", "her antibiotic three times a day"
        named = tree.nodes[thing].tag.startswith(("NN", "JJ")) and timed >= {*range(thing + 1, place)}
        if not named or not parts or parts[0] == 0:
            continue
        verb = parts[0] - 1 if tree.nodes[parts[0] - 1].is_verb else node.head
        if not tree.nodes[verb].is_verb or verb in timed or node.head == place:
            continue
        tag = "NN" if tree.nodes[thing].tag == "JJ" else tree.nodes[thing].tag
        given = tree.hung(parts, thing).changed(thing, relation="dobj", head=verb, tag=tag)
        given = given.changed(place, relation="npadvmod", head=verb)
        if given.nodes[verb].head == place:
            given = given.changed(verb, relation=node.relation, head=node.head)
        return given
    return tree


def with_object_of_aim(tree: Tree, timed: AbstractSet[int]) -> Tree:
    """Give "remind me later to call tim" who is called, whom a tree has for a measure of the reminding."""
    root = tree.root
    for aim in tree.children(root, "xcomp", "ccomp"):
        behind = (p for p in tree.children(root, "npadvmod") if tree.reach(p)[0] == aim + 1)
        thing = next((p for p in behind if timed.isdisjoint(range(aim + 1, p + 1))), None)
        if thing is not None and tree.nodes[thing].tag in NAMES and not tree.children(aim, "dobj"):
            return tree.changed(thing, relation="dobj", head=aim)
    return tree
