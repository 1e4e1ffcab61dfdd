"""The verb that is meant, below "I want to" and "don't forget to"."""

from dataclasses import dataclass

from fuzzytime.language.sentence.trees.tags import PRESENT, SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.language.sentence.verbs.meant.complements import (
    assured,
    brings_about,
    complement,
    has_to,
    is_numbered_place,
    lets_do,
    lets_forget,
)
from fuzzytime.language.sentence.verbs.meant.orders_before import is_order, is_purpose, order_before
from fuzzytime.language.sentence.verbs.meant.small_clauses import gets_to_do, reference_of
from fuzzytime.requirement import Reference

FINITE = PRESENT | {"VBD"}

DEEPEST = 4
"""How many verbs stand at most above the one that is meant: "I'd like to try to remember to call"."""


@dataclass(frozen=True, slots=True)
class Action:
    """The verb of an instruction in its tree, and what the words around it say."""

    place: int
    reference: Reference | None
    negated: bool


def is_doubtful(tree: Tree) -> bool:
    """Whether a tree has no verb at its root, or an infinitive that nothing governs: "alter it to repeat"."""
    root = tree.root
    if not tree.nodes or not tree.nodes[root].is_verb or _is_title(tree, root):
        return True
    if is_purpose(tree, root) and order_before(tree, root) == root and tree.nodes[0].may_act:
        # "Ring Bob so I can file the report": the order was taken for a thing.
        return True
    if tree.nodes[root].tag == "VBG" and tree.children(root, "det"):
        # "Do the ironing"
        return True
    return "to" in tree.said(tree.children(root, "aux"))


def _is_title(tree: Tree, root: int) -> bool:
    """Whether one word alone is no order: "Pancakes", "Agenda"."""
    node = tree.nodes[root]
    alone = all(other is node or other.tag == "UH" for other in tree.nodes if other.text[0].isalnum())
    return alone and (node.tag == "VBZ" or not node.may_act)


def action_of(tree: Tree, *, told: bool = False) -> Action | None:
    """Find the verb that is meant: below "I want to", "can you", "don't forget to", "start".

    One word alone is no order, but may be what is ``told``: "the drone takes off, then lands".
    """
    if not tree.nodes:
        return None
    root = tree.root if told else _governing(tree)
    if root is None:
        return None
    needless = _needless(tree, root)
    negated = needless is not None or _is_negated(tree, root) or _can_wait(tree, root)
    root = root if needless is None else needless
    root = gone_to_do(tree, root) or root
    reference: Reference | None = None
    for _ in range(DEEPEST):
        sure = assured(tree, root)
        below = _meant_below(tree, root) if sure is None else sure
        if below is None:
            break
        # "Make sure not to call"; but "don't forget to call"
        kept = negated and tree.nodes[root].lemma not in tree.lexicon.forgetting
        negated = kept or _is_negated(tree, below)
        if sure is None:
            reference = _reference_of_verb(tree, root, below) or reference
        root = gone_to_do(tree, below) or below
    if reference is None:
        reference = reference_of(tree, root)
    return Action(root, reference, negated)


def _meant_below(tree: Tree, root: int) -> int | None:
    """Give the verb that is meant below another, which says that it is wanted or begun; None for none."""
    lexicon = tree.lexicon
    lemma = tree.nodes[root].lemma
    below = complement(tree, root, lemma)
    if below is None or is_numbered_place(tree, below) or _names_kind(tree, root, below):
        # "Get to gate 22", "get wrapping paper"
        return None
    if gets_to_do(tree, root, below):
        return None
    if lemma not in lexicon.wanting and brings_about(tree, root):
        return None
    if lemma in lexicon.doing.watching and below - has_to(tree, below) > root + 1:
        # "Help gran wash, dress her"
        return None
    leads = (
        lemma in lexicon.forgetting
        or lemma in lexicon.wanting
        or (lemma in lexicon.doing.remembering and has_to(tree, below) and _is_said_of(tree, root))
        or (lemma in lexicon.indicators and not _is_left(tree, root, below))
        or (lemma == "let" and (lets_do(tree, root) or lets_forget(tree, root)))
        or (lemma == "have" and has_to(tree, below))
        or passes_on(tree, root)
    )
    return below if leads else None


def passes_on(tree: Tree, place: int) -> bool:
    """Whether somebody wants something of who speaks: "mum said to ring her", "dad told me to lock up"."""
    closed, below = tree.lexicon.closed, tree.children(place, "xcomp")
    said = tree.nodes[place].lower in tree.lexicon.doing.passing_on and not tree.children(place, "aux")
    whom = tree.said(tree.children(place, "dobj", "dative"))
    whose = tree.said(tree.children(place, *SUBJECTS))
    asked = (
        bool(whose)
        and whom <= closed.first_person_objects
        and whose.isdisjoint(closed.first_and_second_person)
    )
    return said and asked and any(has_to(tree, verb) for verb in below)


def _is_said_of(tree: Tree, place: int) -> bool:
    """Whether somebody does, or is to do, what a verb says: "I must remember to call"; but "remember to"."""
    return place != tree.root or bool(tree.children(place, *SUBJECTS))


def _names_kind(tree: Tree, root: int, below: int) -> bool:
    """Whether a gerund says of which kind a thing is that is got: "get wrapping paper"; not "get going".

    So it is of what is needed: "we need cleaning products".
    """
    thing = below + 1
    if (
        tree.nodes[root].lemma not in tree.lexicon.doing.needing | {"get"}
        or tree.nodes[below].tag != "VBG"
        or below != root + 1
    ):
        return False
    objects = tree.children(below, "dobj")
    bare = [p for p in objects if tree.nodes[p].tag in {"NN", "NNS"} and not tree.children(p, "det", "poss")]
    return any(tree.reach(p)[0] == thing for p in bare)


def _is_left(tree: Tree, root: int, below: int) -> bool:
    """Whether a verb has an aim: "leave at eight to be there for nine"; but "continue to stir"."""
    lemma = tree.nodes[root].lemma
    goes_on = (
        Reference(tree.lexicon.indicators[lemma]) is Reference.START or lemma in tree.lexicon.doing.continuing
    )
    return has_to(tree, below) and not goes_on


def _reference_of_verb(tree: Tree, root: int, below: int) -> Reference | None:
    """Give which moment of what is below a verb is meant, where that verb says it."""
    lemma = tree.nodes[root].lemma
    if lemma in tree.lexicon.forgetting:
        return None
    if lemma in tree.lexicon.wanting:
        # "I want the floor cleaned by noon": the result is what is wanted then.
        return Reference.FINISH if tree.nodes[below].tag == "VBN" else None
    named = tree.lexicon.indicators.get(lemma)
    return None if named is None else Reference(named)


def _needless(tree: Tree, root: int) -> int | None:
    """Give what there is no need to do: "no need to call", "there's no need to call mum"."""
    for need in (root, *tree.children(root, "xcomp", "attr", "dobj", "nsubj")):
        denied = "no" in tree.said(tree.children(need, "det", "advmod", "neg"))
        if tree.nodes[need].lemma == "need" and denied:
            verbs = tree.children(need, "xcomp", "acl", "relcl", "advcl")
            return next((p for p in verbs if p > need and has_to(tree, p)), None)
    return None


def gone_to_do(tree: Tree, place: int) -> int | None:
    """Give the verb behind "go and", "come and", "try and", which say nothing more: "go and check it"."""
    verb = place + 2
    if tree.nodes[place].lemma not in tree.lexicon.doing.trying or verb >= len(tree.nodes):
        return None
    joined = tree.nodes[place + 1].lower == "and" and tree.nodes[verb].head == place
    return verb if joined and tree.nodes[verb].tag == "VB" else None


def _governing(tree: Tree) -> int | None:
    """Find the verb of the sentence; None where it has none, or says only that something is so."""
    if _is_title(tree, tree.root):
        return None
    is_verb = tree.nodes[tree.root].is_verb
    verb = tree.root if is_verb else next((p for p in tree.children(tree.root) if is_order(tree, p)), None)
    if verb is None:
        return None
    root = order_before(tree, verb)
    return None if _only_is(tree, root) or _keeps_on(tree, root) else root


def _keeps_on(tree: Tree, root: int) -> bool:
    """Whether it tells what happens again, or others like: "I keep losing it"; but "I will keep it on"."""
    closed, node = tree.lexicon.closed, tree.nodes[root]
    helping = tree.children(root, "aux")
    # "She loves talking": a tree may have the first for one that helps
    helped = node.tag == "VBG" and bool(helping)
    likes, below = (tree.nodes[helping[0]], [root]) if helped else (node, [*tree.children(root, "xcomp")])
    subjects = tree.said(p for verb in (root, *helping) for p in tree.children(verb, *SUBJECTS))
    others = closed.third_person_singular | {"they"} | tree.lexicon.people
    doing = tree.lexicon.doing
    liking = (tree.lexicon.wanting & doing.holding_true) - doing.needing
    liked = not liking.isdisjoint({likes.lemma, likes.lower.removesuffix("s")})
    if below and liked and not others.isdisjoint(subjects):
        return {tree.nodes[p].lemma for p in helping} <= {"do", likes.lemma}
    again = any(tree.nodes[p].tag == "VBG" for p in below)
    told = not closed.first_and_third_person.isdisjoint(subjects)
    return told and again and node.lemma in doing.keeping and not helping


def _only_is(tree: Tree, root: int) -> bool:
    """Whether something is so and nothing is to be done: "it's hot in here"; but "it's time to eat"."""
    told = "it" in tree.said(tree.children(root, *SUBJECTS))
    # "Buy stamps, it's open until four" tells when that can be done.
    opens = tree.lexicon.doing.opening_up & tree.said(tree.children(root, "acomp"))
    return (
        told
        and not opens
        and tree.nodes[root].lemma in tree.lexicon.closed.lemmas_of_be
        and not any(tree.nodes[p].tag == "VB" for p in tree.below(root))
        and not tree.children(root, "aux")
    )


def says_how_things_are(tree: Tree, verb: int) -> bool:
    """Whether somebody or something is said to be so, or to do so now: "I'm running late"."""
    closed = tree.lexicon.closed
    node = tree.nodes[verb]
    subjects = [p for p in tree.children(verb, *SUBJECTS) if p < verb]
    helping = tree.said(tree.children(verb, "aux", "auxpass"))
    if "there" in tree.said(tree.children(verb, "expl")) and node.tag in PRESENT and not helping:
        # "There is cake in the tin"; but "there is milk to buy"
        return not any(tree.nodes[p].tag == "VB" for p in tree.below(verb))
    if subjects and tree.nodes[subjects[0]].lower == "it" and tree.children(verb, "dobj") and not helping:
        # "It burns the leaves"
        return node.tag == "VBZ" and node.lemma not in tree.lexicon.doing.taking | tree.lexicon.doing.needing
    if not subjects or tree.children(verb, "dobj") or tree.nodes[subjects[0]].lower in closed.second_person:
        return False
    is_so = node.lemma in closed.lemmas_of_be and node.tag in PRESENT and not helping
    if node.lemma == "be" and tree.nodes[subjects[0]].lower == "it" and helping <= closed.future:
        # "It will be lovely"
        return True
    goes_on = node.tag == "VBG" and bool(helping) and helping <= closed.present_be
    became = node.tag == "VBN" and bool(tree.children(verb, "auxpass")) and helping <= closed.present_be
    return is_so or became or (goes_on and complement(tree, verb, node.lemma) is None)


def _can_wait(tree: Tree, place: int) -> bool:
    """Whether nothing is done with something up to then: "the ironing can wait until tomorrow"."""
    subjects = tree.said(tree.children(place, *SUBJECTS))
    closed, node = tree.lexicon.closed, tree.nodes[place]
    waits = node.lemma in tree.lexicon.doing.waiting and "can" in tree.said(tree.children(place, "aux"))
    waits = waits and not tree.said(tree.children(place, "prep")).isdisjoint(closed.prepositions_of_length)
    return waits and bool(subjects) and subjects.isdisjoint(closed.personal_pronouns)


def _is_negated(tree: Tree, place: int) -> bool:
    """Whether what denies a verb stands in front of it or right behind: not "after lunch, not before"."""
    denying = (
        p
        for p in tree.children(place, "neg", "advmod")
        if tree.nodes[p].lower in tree.lexicon.closed.negators
    )
    return any(p <= place + 1 for p in denying)
