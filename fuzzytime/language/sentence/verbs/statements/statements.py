"""What happens and is not to be done, while others count from it: "the train leaves at 8:40, be early"."""

from collections.abc import Set as AbstractSet

from fuzzytime.language.sentence.trees.named import calls_somebody
from fuzzytime.language.sentence.trees.tags import DETERMINERS, GRAMMATICAL_SUBJECTS, NOUNS, PRESENT, SINGULAR
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.language.sentence.verbs.statements.beside_orders import (
    BEFORE_ORDER,
    does_beside,
    is_so_now,
    subjects_before,
)

FINITE = frozenset({"VBZ", "VBP", "VBD", "VBG"})


def behind_particles(tree: Tree, verb: int) -> int:
    """Give the place behind a verb and the small words that belong to it: "check out", "get back"."""
    behind = verb + 1
    while behind < len(tree.nodes) and tree.nodes[behind].tag in {"RP", "RB"}:
        behind += 1
    return behind


def goes_on(tree: Tree, place: int, root: int, timed: AbstractSet[int]) -> bool:
    """Whether it is what the same ones do next: "we open at nine and close at five".

    Either verb has a time of its own right behind it, and neither has an object.
    """
    node = tree.nodes[place]
    joined = place > root + 1 and tree.nodes[place - 1].lower in {"and", "but"} and place - 2 in timed
    named = [tree.nodes[p] for p in tree.children(root, "nsubj") if p < root]
    several = bool(named) and (
        named[0].tag == "NNS" or named[0].lower in tree.lexicon.closed.plural_agreement
    )
    bare = node.may_act and node.lower == node.lemma
    both = all(behind_particles(tree, verb) in timed for verb in (root, place))
    return joined and several and bare and both and tree.nodes[root].tag in {"VBP", "VB"}


def plural_subject(tree: Tree, verb: int) -> int | None:
    """Give the noun that a tree took for a part of a plural that is the verb: "laundry finishes".

    No part of a day does anything: "morning pills at eight".
    """
    for place in tree.children(verb, "compound", "amod"):
        if tree.lexicon.means(tree.nodes[place].lower, "part"):
            continue
        if place == verb - 1 and (
            tree.nodes[place].tag in SINGULAR or tree.nodes[verb].lower in tree.lexicon.doing.timed
        ):
            return place
    return None


def order_behind_statement(tree: Tree, root: int, timed: AbstractSet[int]) -> int | None:
    """Give where an order begins behind a statement with a time: "we land at nine, call me"."""
    if tree.nodes[root].tag not in {"VB", "VBP"} or tree.children(root, "mark"):
        return None
    for place in tree.children(root, *BEFORE_ORDER):
        said = [p for p in tree.below(place) if tree.nodes[p].relation != "punct"]
        end = max(said) + (tree.nodes[max(said)].lower != "so")
        joined = end < root and tree.nodes[end].lower in tree.lexicon.closed.joints_of_consequence
        marked = [p for p in tree.children(place, "mark", "advmod") if p < place]
        if joined and not marked and not timed.isdisjoint(said) and _is_statement(tree, place):
            # "The bus leaves at nine, so be there"
            return end + 1 + (tree.nodes[end].lower != "so" and tree.nodes[end + 1].lower == "so")
    return None


def second_statement(tree: Tree, place: int, timed: AbstractSet[int]) -> int | None:
    """Give where begins what is told beside something with a time: "doors open at nine, they come at ten".

    ``place`` is that of its verb, behind which a time of its own stands, or which is what somebody else does.
    """
    closed = tree.lexicon.closed
    start = _start_of_statement(tree, place)
    if start is None or tree.nodes[start].lower in closed.second_person_or_relative:
        return None
    does = does_beside(tree, place, start)
    if not (does or any(p > place for p in timed) or is_so_now(tree, place)):
        return None
    if _is_purpose(tree, place, start):
        return None
    joint = start - 1
    if joint > 0 and tree.nodes[joint].lower == "and" and tree.nodes[joint - 1].text == ",":
        joint -= 1
    joined = (
        joint > 0
        and tree.nodes[start - 1].lower in closed.joints_of_consequence | closed.conjunctions_of_clauses
    )
    # "Light the fire before we get back, we'll be home by six"
    speaks = (
        tree.nodes[start].lower in closed.plural_agreement
        and tree.nodes[joint].lower in closed.joints_of_consequence
    )
    apart = tree.nodes[joint].text == "," and joint < start - 1 and _is_apart(tree, place)
    # "Visit gran, visiting hours are two to four"
    is_then = tree.nodes[place].lower in closed.present_be and place + 1 in timed and joint == start - 1
    told = joint - 1 in timed or speaks or apart or does or is_then or _is_told_so(tree, joint)
    return start if joined and told else None


def _is_apart(tree: Tree, place: int) -> bool:
    """Whether a verb with an article or owner's word before who does it is joined to the first of all."""
    node = tree.nodes[place]
    first = min((min(tree.below(p)) for p in tree.children(place, *GRAMMATICAL_SUBJECTS)), default=place)
    joined = node.relation == "conj" and node.head == tree.root and not tree.children(place, "mark")
    return joined and tree.nodes[first].tag in DETERMINERS


def _is_purpose(tree: Tree, place: int, start: int) -> bool:
    """Whether it says what an order before it is for: "put the roast in at noon so it's ready by two"."""
    root = tree.root
    if (
        tree.nodes[start - 1].lower not in tree.lexicon.closed.subordinators_of_purpose
        or tree.nodes[place].lemma not in tree.lexicon.doing.becoming
    ):
        return False
    # "Light the fire at five so the room is warm by six" has the order below what it is for.
    orders = (p for p in tree.children(root, "advcl", "ccomp") if root == place and p < start)
    order = next(orders, root) if root >= start - 1 else root
    bare = order < start - 1 and tree.nodes[order].tag in {"VB", "VBP"}
    return bare and not tree.children(order, *GRAMMATICAL_SUBJECTS, "mark")


def _is_told_so(tree: Tree, joint: int) -> bool:
    """Whether what stands before a joint says how something is: "the train is cancelled and …"."""
    closed = tree.lexicon.closed
    root = tree.root
    if root >= joint or not tree.children(root, *GRAMMATICAL_SUBJECTS):
        return False
    helping = tree.said(tree.children(root, "aux", "auxpass"))
    return helping <= closed.present_be and (
        tree.nodes[root].lower in closed.present_be or (bool(helping) and tree.nodes[root].tag == "VBN")
    )


def _start_of_statement(tree: Tree, place: int) -> int | None:
    """Give where a statement begins, by the place of its verb, which a tree may take for a plural."""
    closed = tree.lexicon.closed
    doing = tree.lexicon.doing
    node = tree.nodes[place]
    subjects = subjects_before(tree, place)
    helping = tree.said(tree.children(place, "aux"))
    # "Dad does breakfast": a tree may have that for a verb.
    coming = node.tag == "VB" and bool(helping) and helping <= closed.future | {"does"}
    if (node.tag in FINITE - {"VBG"} or coming or is_so_now(tree, place)) and subjects:
        return min(tree.below(subjects[-1]))
    if place > 0 and (node.lower in doing.timed or f"{node.lower}s" in doing.timed):
        # "The last bus leaves", "doors open"
        # "The next leaves at eleven"
        known = (
            tree.nodes[place - 1].tag in SINGULAR or tree.nodes[place - 1].lower in closed.general_ordinals
        )
        singular = node.tag == "NNS" and known
        plural = not node.lower.endswith("s") and tree.nodes[place - 1].tag == "NNS"
        if singular or plural:
            first = place - 1
            while first > 0 and tree.nodes[first - 1].tag in {*DETERMINERS, *SINGULAR, "JJ", "NNS"}:
                first -= 1
            return first
    return None


def result_behind_statement(tree: Tree, place: int, root: int, timed: AbstractSet[int]) -> int | None:
    """Give where begins what should be so by then: "the boss arrives at ten, coffee should be ready"."""
    closed = tree.lexicon.closed
    helping = tree.said(tree.children(place, "aux"))
    if (
        place <= root
        or not (helping & closed.obligation or _is_brought_about(tree, place))
        or not _is_statement(tree, root)
        or timed.isdisjoint(range(place))
    ):
        return None
    start = min(p for p in tree.below(place) if tree.nodes[p].relation != "punct")
    return (
        start
        if start > root and tree.nodes[start - 1].lower in {*closed.joints_of_consequence, "and"}
        else None
    )


def due_too(tree: Tree, place: int, root: int) -> int | None:
    """Give where begins what else must be so: "the floor must be mopped and the bins need emptying"."""
    node, closed = tree.nodes[place], tree.lexicon.closed
    subjects = [p for p in tree.children(place, *GRAMMATICAL_SUBJECTS) if root < p < place]
    if node.relation != "conj" or node.head != root or not subjects or not tree.nodes[root].is_verb:
        return None
    helping = tree.said(tree.children(place, "aux"))
    # "Ann has to go", but "Ann has a cold"
    must = bool(tree.children(place, "xcomp")) and node.lower in closed.verbs_of_obligation
    first = min(tree.below(subjects[0]))
    joined = tree.nodes[first - 1].lower in {*closed.conjunctions_of_clauses, ","}
    return first if joined and (must or helping & closed.obligation) else None


def _is_brought_about(tree: Tree, place: int) -> bool:
    """Whether it is what is done so that all is prepared: "they come at six so the table is set by five"."""
    helping = tree.said(tree.children(place, "aux", "auxpass"))
    told = tree.nodes[place].tag == "VBN" and bool(helping) and helping <= tree.lexicon.closed.present_be
    if not told:
        return False
    first = min(tree.below(place))
    # A tree has "so" with what stands before it, or with what it leads to.
    return "so" in {tree.nodes[p].lower for p in (first, first - 1) if p >= 0}


def _is_statement(tree: Tree, place: int) -> bool:
    """Whether a verb before an order says what happens; a tree may take it for who does what is ordered."""
    node = tree.nodes[place]
    if node.relation in GRAMMATICAL_SUBJECTS:
        return node.tag in {"VBZ", "NNS"} and plural_subject(tree, place) is not None
    taken = node.tag == "VBZ" and plural_subject(tree, place) is not None
    return node.tag in FINITE and (taken or bool(tree.children(place, *GRAMMATICAL_SUBJECTS)))


def _has_thing(tree: Tree, verb: int) -> bool:
    """Whether somebody has something, and not to do it: "Tom has his break at ten"."""
    return bool(tree.children(verb, "dobj")) and not tree.children(verb, "xcomp", "ccomp")


def others_do(tree: Tree, verb: int, helping: AbstractSet[str]) -> bool:
    """Whether somebody who is named does it, and is not asked to: "the kids finish school at three".

    ``helping`` are the verbs that help it.
    """
    lexicon = tree.lexicon
    closed, beside = lexicon.closed, lexicon.beside
    node = tree.nodes[verb]
    subjects = [tree.nodes[p] for p in tree.children(verb, "nsubj") if p < verb]
    if not subjects or (node.lemma == "have" and not _has_thing(tree, verb)):
        return False
    if node.lemma in lexicon.wanting and not closed.it_or_them & tree.said(tree.children(verb, "dobj")):
        # "Mum wants the car washed"; but "wash the car, mum wants it at six", "the rabbit gets hay at nine"
        # "He'll want a shower"
        asked = node.lemma in lexicon.doing.requiring and not helping
        asked = asked or bool(tree.children(verb, "xcomp", "ccomp"))
        if asked or not tree.children(verb, "dobj"):
            return False
    called = {subjects[0].lower, *(tree.nodes[p].lower for p in tree.below(verb) if p < verb)}
    persons = lexicon.persons | (closed.third_person - {"it"})
    named = bool((persons - closed.persons_addressed) & called)
    # "Kai will collect the cake at three"
    named = named or (bool(helping) and calls_somebody(subjects[0], lexicon))
    # "Don't water it at noon, it burns the leaves"; but "it takes an hour"
    it = subjects[0].lower == "it" and tree.children(verb, "dobj") and node.lemma not in lexicon.doing.taking
    if not helping and node.tag == "VBZ" and (subjects[0].tag in {"NN", "NNP"} or it):
        # No order ends in -s: "the caretaker cuts the grass"; but a machine may be asked by its name.
        named = named or subjects[0].lower not in lexicon.machines
    if not helping and node.tag == "VBP" and node.lemma == "have":
        # "June and August have football at five", "the hens have corn at six"
        whose = [p for p in tree.children(verb, "nsubj") if p < verb]
        several = subjects[0].tag == "NNS" or subjects[0].lower == "they"
        named = named or several or bool(tree.children(whose[0], "conj"))
    if node.tag == "VBG" and helping <= closed.present_be and (subjects[0].tag in NOUNS or named):
        # "Tom is washing the car at five", "Tom washing the car", "rep coming"; but "bins emptying" is to do.
        acts = bool(helping or tree.children(verb, "dobj")) or node.lemma in lexicon.intransitive
        return acts and (named or subjects[0].lower not in lexicon.machines - beside.awaited_in_a_stretch)
    finite = node.tag in PRESENT if not helping else helping <= closed.future | {"can"}
    if helping == {"can"} and subjects[0].tag in NOUNS:
        # "The surveyor can only come before noon": nobody else can help that.
        only = "only" in tree.said(tree.children(verb, "advmod"))
        named = named or (only and subjects[0].lower not in lexicon.machines)
    return named and finite
