"""What holds for a further wish too: "the dog must be walked by nine and the cat fed by ten".

What is said once, in front of who or what it is about or behind it, is the frame of both.
"""

from fuzzytime.language.sentence.segments.borrowed_words.further_wishes import (
    Stretch,
    Wish,
    end_of,
    front_of,
)
from fuzzytime.language.sentence.trees.named import is_of_its_own, takes_verb
from fuzzytime.language.sentence.trees.tags import DETERMINERS, NAMING, PAST, SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.language.sentence.verbs.meant.actions import action_of

NUMBERED = 2
"""Words of "robot 2"."""


def is_done_too(wish: Wish) -> list[Stretch] | None:
    """Give what is said of what must be done: "must be" walked and the cat fed, "could" it "be" swept."""
    tree = wish.tree
    action = action_of(tree)
    if action is None or action.negated:
        return None
    # "I want the car washed": a tree may have that for what was.
    done = (p for p in tree.children(action.place, "ccomp") if tree.nodes[p].tag in PAST)
    verb = next(done, action.place)
    subject = _subject(tree, verb)
    if subject is None or verb >= wish.start:
        return None
    first, behind = subject
    being = tree.nodes[verb].lemma == "be"
    front, helping = front_of(wish, first), range(behind, verb + being)
    said = tree.said((*front, *helping))
    wanted = any(tree.nodes[p].tag in {"MD", "TO"} for p in (*front, *helping))
    wanted = wanted or any(tree.nodes[p].lemma in wish.lexicon.wanting - {"be"} for p in (*front, *helping))
    if not wanted or not said:
        return None
    predicate = _predicate(wish, verb)
    if predicate is None:
        return None
    if predicate == wish.end:
        # "I want the car washed at four and the van at five"
        return [(wish.start, front), (wish.end, range(behind, verb + 1))] if front else None
    return [(wish.start, front), (predicate, helping)]


def _subject(tree: Tree, verb: int) -> tuple[int, int] | None:
    """Give where what a verb is about begins, and where the words that help the verb do."""
    above = [verb, *tree.above(verb)]
    owner, subjects = next(
        ((v, s) for v in above if (s := tree.children(v, *SUBJECTS)) and s[0] < verb), (0, ())
    )
    if not subjects:
        return None
    helping = [p for v in above[: above.index(owner) + 1] for p in tree.children(v, "aux", "auxpass", "neg")]
    helping += above[: above.index(owner) + 1]
    return min(tree.below(subjects[0])), min(p for p in helping if p > subjects[0])


def _predicate(wish: Wish, verb: int) -> int | None:
    """Give where it is said what is to be done with it; where the time begins if that is said once."""
    nodes, tag = wish.tree.nodes, wish.tree.nodes[verb].tag
    if tag in PAST and wish.end < len(nodes) and wish.names(wish.start, wish.end):
        return wish.end
    fitting = PAST if tag in PAST else {tag} if tag == "VBG" else frozenset()
    found = next((p for p in range(wish.start + 1, wish.end) if nodes[p].tag in fitting), None)
    last = wish.end - 1
    if found is None and (tag in PAST or nodes[verb].lemma == "be"):
        # "The grill must be lit by five and the meat on by six"
        found = last if nodes[last].lower in wish.lexicon.particles else None
    if found is None or not wish.names(wish.start, found):
        return None
    # "… and the customer called me at ten" tells what was.
    acts = found + 1 < wish.end and nodes[found + 1].tag in {*NAMING, "PRP"}
    return None if acts else found


def is_asked_too(wish: Wish) -> list[Stretch] | None:
    """Give what somebody is asked with: "remind me" to call and feed, "get" Bob to mow and Ann to rake."""
    tree, root = wish.tree, wish.tree.root
    if root >= wish.start or tree.nodes[root].lemma not in wish.lexicon.addressing | {"get"}:
        return None
    asked = [
        p for p in range(root + 1, wish.start) if tree.nodes[p].lower == "to" and tree.nodes[p].tag == "TO"
    ]
    if not asked or tree.nodes[root].tag not in {"VB", "VBP"} or wish.timed & {*range(root, asked[0])}:
        return None
    to, node = asked[0], tree.nodes[wish.start]
    behind = tree.nodes[wish.start + 1 : wish.start + 2]
    if node.lower == "to":
        return [(wish.start, front_of(wish, to))] if behind and behind[0].may_act else None
    also = next((p for p in range(wish.start + 1, wish.end) if tree.nodes[p].tag == "TO"), None)
    if also is not None and wish.calls(root + 1, to) and wish.calls(wish.start, also):
        return [(wish.start, front_of(wish, root + 1))]
    reminds = tree.nodes[root].lemma in wish.lexicon.doing.recalling
    # "Remind me to water the plants at six and call mum at seven"
    somebody = bool(behind) and wish.is_called(wish.start + 1) > 0
    called = somebody and node.lower in wish.lexicon.addressing
    if reminds and not called and wish.names(wish.start, wish.end) and to + 2 < wish.start:
        first, other = wish.text(to + 2, wish.start - 1), wish.text(wish.start, wish.end)
        alike = takes_verb(tree.nodes[to + 1].lemma, first, other, wish.lexicon)
        return _reminded_with(wish, to) if alike else None
    governs = called or (node.tag == "VB" and bool(tree.children(wish.start, "dobj")))
    governs = governs or (bool(behind) and behind[0].tag in {*DETERMINERS, "PRP", "NNP"})
    bare = node.may_act and node.lower == node.lemma and (governs or wish.start + 1 in wish.timed)
    return [(wish.start, front_of(wish, to + 1))] if reminds and bare else None


def is_reminded_then(wish: Wish) -> list[Stretch] | None:
    """Give "remind me", which holds at another time, too: "… at six to call mum and at ten to lock up"."""
    tree, root = wish.tree, wish.tree.root
    reminds = tree.nodes[root].lemma in wish.lexicon.doing.recalling and root + 2 in wish.timed
    again = any(p not in wish.timed for p in range(wish.start, len(tree.nodes)))
    return [(wish.start, front_of(wish, root + 2))] if reminds and again and root + 2 < wish.start else None


def _reminded_with(wish: Wish, to: int) -> list[Stretch]:
    """Give what is to be done with another thing: "remind me to turn" the oven "on" at five and the grill."""
    said = (wish.start, range(front_of(wish, to).start, end_of(wish, to + 1)))
    time = next((p for p in range(to, wish.start) if p in wish.timed), to)
    carried = time > to + 2 and wish.tree.nodes[time - 1].lower in wish.lexicon.particles
    return (
        [said, (wish.end, range(time - 1, time))] if carried and wish.end < len(wish.tree.nodes) else [said]
    )


def lets_too(wish: Wish) -> list[Stretch] | None:
    """Give what lets others do something: "let" Ann feed the cat and Bob "feed" the dog.

    What a machine is had to do with a thing, it is had to do with "it" again.
    """
    tree, lexicon = wish.tree, wish.lexicon
    first = next((p for p, node in enumerate(tree.nodes) if p not in wish.timed and node.may_act), None)
    if first is None or tree.nodes[first].lemma not in lexicon.letting | lexicon.causing:
        return None
    verbs = (p for p in range(first + 2, wish.start) if tree.nodes[p].tag in {"VB", *PAST})
    verb = next(verbs, None)
    if verb is None or not wish.names(first + 1, verb) or wish.timed & {*range(first, verb)}:
        return None
    if tree.nodes[verb].tag in PAST:
        # "Have the hall swept by three and the bins emptied by four"
        return (
            [(wish.start, front_of(wish, first + 1))]
            if _predicate(wish, verb) not in {None, wish.end}
            else None
        )
    node, behind = tree.nodes[wish.start], wish.start + 1
    named = wish.is_name(wish.start)
    if named and wish.is_name(first + 1) and wish.names(wish.start + named, wish.end):
        return [
            (wish.start, front_of(wish, first + 1)),
            (wish.start + named, range(verb, end_of(wish, verb))),
        ]
    worker = tree.nodes[verb - 1].lower in lexicon.workers or wish.is_name(first + 1) == NUMBERED
    bare = node.may_act and node.lower == node.lemma and behind < wish.end
    again = bare and tree.nodes[behind].lower in lexicon.closed.it_or_them
    return [(wish.start, front_of(wish, verb))] if worker and again else None


def acts_too(wish: Wish) -> list[Stretch] | None:
    """Give what another does too: Ann "washes" the car and Bob the van, "cooks" tonight, Lisa tomorrow."""
    tree, root = wish.tree, wish.tree.root
    if root >= wish.start:
        return None
    pronouns = wish.lexicon.closed.first_and_second_person
    subjects = tree.children(root, *SUBJECTS)
    first = min(tree.below(subjects[0])) if subjects else root
    named = wish.is_name(first)
    behind = first + named
    if not subjects or not named or not behind <= root or tree.nodes[first].lower in pronouns:
        return None
    whom = wish.is_name(wish.start)
    if not whom or tree.nodes[root].tag not in {"VBZ", "VBP", "VB"}:
        return None
    thing = wish.start + whom
    if thing == wish.end:
        end = next(p for p in range(root, wish.start) if p in wish.timed)
        return [(thing, range(behind, end))]
    opened = (
        tree.nodes[thing].tag in DETERMINERS or tree.nodes[thing].lower in tree.lexicon.closed.owning_alone
    )
    return [(thing, range(behind, end_of(wish, root)))] if opened else None


def happens_too(wish: Wish) -> list[Stretch] | None:
    """Give what other things do as well: "bread" comes out "at ten, pies at noon"."""
    tree, root = wish.tree, wish.tree.root
    end = root + 1
    end += end < wish.start and tree.nodes[end].lower in wish.lexicon.particles
    said = 0 < root < wish.start and tree.nodes[root].tag in {"VBZ", "VBP"} and end in wish.timed
    alone = said and not tree.children(root, "dobj", "neg", "aux", "expl") and wish.names(0, root)
    bare = alone and not wish.is_name(0) and not wish.is_name(wish.start)
    named = bare and wish.end < len(tree.nodes) and wish.names(wish.start, wish.end)
    # "The taxi comes at eight, flight at ten", "the shop opens at nine and the bus leaves at ten"
    moving = wish.lexicon.doing.moments | wish.lexicon.doing.several_timed
    apart = named and (tree.nodes[wish.end - 1].lower in moving)
    apart = apart or (named and is_of_its_own(wish.text(wish.start, wish.end), wish.lexicon))
    if named and tree.nodes[wish.end - 1].lower == tree.nodes[root].lower:
        # "Morning meds at eight, evening meds at nine"
        return []
    return [(wish.end, range(root, end))] if named and not apart else None


def is_sure_too(wish: Wish) -> list[Stretch] | None:
    """Give "make sure", which holds for another thing that must be so: "… and the alarm is set"."""
    tree = wish.tree
    sure = next(
        (p for p, n in enumerate(tree.nodes[: wish.start]) if n.lower in wish.lexicon.doing.sure), None
    )
    if sure is None or tree.nodes[wish.start].tag not in NAMING:
        return None
    being = next(
        (p for p in range(wish.start + 1, len(tree.nodes)) if tree.nodes[p].tag in {"VBZ", "VBP", "VBD"}),
        None,
    )
    if being is None or not wish.names(wish.start, being) or wish.timed & {*range(wish.start, being)}:
        return None
    that = tree.nodes[sure + 1].lower == "that"
    return [(wish.start, front_of(wish, sure + 1 + that))]


def is_gone_for_too(wish: Wish) -> list[Stretch] | None:
    """Give what one goes for, or begins: "go" shopping at four and swimming at six."""
    tree, root = wish.tree, wish.tree.root
    if root + 1 >= wish.start:
        return None
    doing = root + 1
    gerunds = tree.nodes[doing].tag == tree.nodes[wish.start].tag == "VBG"
    return (
        [(wish.start, front_of(wish, doing))] if gerunds and tree.nodes[root].tag in {"VB", "VBP"} else None
    )
