"""Further wishes that borrow words of the first: "the dog must be walked by nine and the cat fed by ten".

What is said once, in front of who or what it is about or behind it, holds for both: the frame. Each stands
behind a joint and a time.
"""

from collections.abc import Callable, Iterator
from collections.abc import Set as AbstractSet
from dataclasses import dataclass

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.sentence.segments.borrowed import Borrowed
from fuzzytime.language.sentence.segments.waiting import Part, Waiting
from fuzzytime.language.sentence.trees.tags import DETERMINERS, SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.language.sentence.verbs.actions import action_of

JOINTS = frozenset({"and", "&", ",", ";", "but"})

NAMING = frozenset({"DT", "PRP$", "JJ", "NN", "NNS", "NNP", "NNPS", "CD", "POS"})
"""Tags of words that name who or what a wish is about."""

DONE = frozenset({"VBN", "VBD"})
"""Tags of what is done with something; trees mistake one for the other."""

WHERE = frozenset({"IN", "TO"})
"""Tags of words that begin what says where."""

Stretch = tuple[int, range]
"""A place in a tree, and the places of the words that are heard again before it."""


@dataclass(frozen=True, slots=True)
class Wish:
    """A further wish in a tree: where it begins, and where its time does."""

    tree: Tree
    start: int
    end: int
    timed: AbstractSet[int]
    lexicon: Lexicon

    def names(self, first: int, end: int) -> bool:
        """Whether words are there, and all name something."""
        return first < end and all(self._names(p) for p in range(first, end))

    def _names(self, place: int) -> bool:
        """Whether a word names something; behind whose it is, a plural may be taken for a verb: "her drops"."""
        node, before = self.tree.nodes[place], self.tree.nodes[place - 1 : place]
        owned = node.tag == "VBZ" and any(other.tag == "PRP$" for other in before)
        return node.tag in NAMING or owned

    def is_name(self, place: int) -> int:
        """Give how many words name somebody at a place, a person or a worker with a number; 0 for none."""
        node, behind = self.tree.nodes[place], self.tree.nodes[place + 1 : place + 2]
        if node.lower in self.lexicon.workers and behind and behind[0].tag == "CD":
            return 2
        return int(
            (node.text[0].isupper() and node.text.isalpha() and not node.text.isupper())
            or node.lower in self.lexicon.persons
        )


def wishes_beside(one: Waiting, part: Part, lexicon: Lexicon) -> dict[int, tuple[Borrowed, ...]]:
    """Give where further wishes begin that borrow words, with these."""
    tree, timed = part.tree, one.timed(part.tree)
    found: dict[int, tuple[Borrowed, ...]] = {}
    for start in _starts(tree, timed):
        behind = range(start, len(tree.nodes))
        ends = (p for p in behind if p in timed or (tree.nodes[p].lower,) in lexicon.clauses)
        end = next(ends, len(tree.nodes))
        wish = Wish(tree, start, end, timed, lexicon)
        stretches = next((said for kind in KINDS if (said := kind(wish)) is not None), None)
        if stretches is None or any(not timed.isdisjoint(words) for _, words in stretches):
            continue
        offset = part.offset
        found[tree.nodes[start].start + offset] = tuple(
            Borrowed(
                tree.nodes[at].start + offset,
                (tree.nodes[words[0]].start + offset, tree.nodes[words[-1]].end + offset),
            )
            for at, words in stretches
            if words
        )
    return found


def _starts(tree: Tree, timed: AbstractSet[int]) -> Iterator[int]:
    """Give the places behind a joint that stands behind a time."""
    for place in range(2, len(tree.nodes)):
        before = place - 1
        if place in timed or tree.nodes[before].lower not in JOINTS:
            continue
        while before and tree.nodes[before].lower in JOINTS:
            before -= 1
        if before in timed:
            yield place


def _front(wish: Wish, end: int) -> range:
    """Give the words in front of a place, behind a time in front of them all."""
    behind = (p + 1 for p in range(end - 1, -1, -1) if p in wish.timed or wish.tree.nodes[p].text == ",")
    return range(next(behind, 0), end)


def _is_done_too(wish: Wish) -> list[Stretch] | None:
    """Give what is said of what must be done: "must be" walked and the cat fed, "could" it "be" swept."""
    tree = wish.tree
    action = action_of(tree, wish.lexicon)
    if action is None or action.negated:
        return None
    # "I want the car washed": a tree may have that for what was.
    done = (p for p in tree.children(action.place, "ccomp") if tree.nodes[p].tag in DONE)
    verb = next(done, action.place)
    subject = _subject(tree, verb)
    if subject is None or verb >= wish.start:
        return None
    first, behind = subject
    being = tree.nodes[verb].lemma == "be"
    front, helping = _front(wish, first), range(behind, verb + being)
    said = {tree.nodes[p].lower for p in (*front, *helping)}
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
    if tag in DONE and wish.names(wish.start, wish.end):
        return wish.end
    fitting = DONE if tag in DONE else {tag} if tag == "VBG" else frozenset()
    found = next((p for p in range(wish.start + 1, wish.end) if nodes[p].tag in fitting), None)
    last = wish.end - 1
    if found is None and (tag in DONE or nodes[verb].lemma == "be"):
        # "The grill must be lit by five and the meat on by six"
        found = last if nodes[last].lower in wish.lexicon.particles else None
    if found is None or not wish.names(wish.start, found):
        return None
    # "… and the customer called me at ten" tells what was.
    acts = found + 1 < wish.end and nodes[found + 1].tag in {*NAMING, "PRP"}
    return None if acts else found


def _is_asked_too(wish: Wish) -> list[Stretch] | None:
    """Give what somebody is asked with: "remind me" to call and to feed, "get" Bob to mow and Ann to water."""
    tree, root = wish.tree, wish.tree.root
    if root is None or root >= wish.start or tree.nodes[root].lemma not in wish.lexicon.addressing | {"get"}:
        return None
    asked = [
        p for p in range(root + 1, wish.start) if tree.nodes[p].lower == "to" and tree.nodes[p].tag == "TO"
    ]
    if not asked or tree.nodes[root].tag not in {"VB", "VBP"} or wish.timed & {*range(root, asked[0])}:
        return None
    to, node = asked[0], tree.nodes[wish.start]
    behind = tree.nodes[wish.start + 1 : wish.start + 2]
    if node.lower == "to":
        return [(wish.start, _front(wish, to))] if behind and behind[0].may_act else None
    also = next((p for p in range(wish.start + 1, wish.end) if tree.nodes[p].lower == "to"), None)
    if also is not None and wish.names(wish.start, also) and wish.is_name(root + 1):
        return [(wish.start, _front(wish, root + 1))] if wish.is_name(wish.start) else None
    reminds = tree.nodes[root].lemma in wish.lexicon.doing.recalling
    governs = bool(behind) and (behind[0].tag in {*DETERMINERS, "PRP", "NNP"} or wish.start + 1 in wish.timed)
    bare = node.may_act and node.lower == node.lemma and governs
    return [(wish.start, _front(wish, to + 1))] if reminds and bare else None


def _lets_too(wish: Wish) -> list[Stretch] | None:
    """Give what lets others do something: "let" Ann feed the cat and Bob "feed" the dog.

    What a machine is had to do with a thing, it is had to do with "it" again.
    """
    tree, lexicon = wish.tree, wish.lexicon
    first = next((p for p, node in enumerate(tree.nodes) if p not in wish.timed and node.may_act), None)
    if first is None or tree.nodes[first].lemma not in lexicon.letting | lexicon.causing:
        return None
    verbs = (p for p in range(first + 2, wish.start) if tree.nodes[p].tag in {"VB", *DONE})
    verb = next(verbs, None)
    if verb is None or not wish.names(first + 1, verb) or wish.timed & {*range(first, verb)}:
        return None
    if tree.nodes[verb].tag in DONE:
        # "Have the hall swept by three and the bins emptied by four"
        return (
            [(wish.start, _front(wish, first + 1))]
            if _predicate(wish, verb) not in {None, wish.end}
            else None
        )
    node, behind = tree.nodes[wish.start], wish.start + 1
    named = wish.is_name(wish.start)
    if named and wish.is_name(first + 1) and wish.names(wish.start + named, wish.end):
        return [(wish.start, _front(wish, first + 1)), (wish.start + named, range(verb, _end(wish, verb)))]
    worker = tree.nodes[verb - 1].lower in lexicon.workers or wish.is_name(first + 1) == len("r2")
    bare = node.may_act and node.lower == node.lemma and behind < wish.end
    again = bare and tree.nodes[behind].lower in lexicon.closed.it_or_them
    return [(wish.start, _front(wish, verb))] if worker and again else None


def _end(wish: Wish, verb: int) -> int:
    """Give where a verb with its particle ends."""
    particle = verb + 1
    return particle + (wish.tree.nodes[particle].tag == "RP")


def _acts_too(wish: Wish) -> list[Stretch] | None:
    """Give what another does too: Ann "washes" the car and Bob the van, "washes up" tonight, Lisa tomorrow."""
    tree, root = wish.tree, wish.tree.root
    if root is None or root >= wish.start:
        return None
    subjects = tree.children(root, *SUBJECTS)
    first = min(tree.below(subjects[0])) if subjects else root
    named = wish.is_name(first)
    behind = first + named
    if not subjects or not named or not behind <= root or tree.nodes[first].lower in {"i", "we"}:
        return None
    whom = wish.is_name(wish.start)
    if not whom or tree.nodes[root].tag not in {"VBZ", "VBP", "VB"}:
        return None
    thing = wish.start + whom
    if thing == wish.end:
        end = next(p for p in range(root, wish.start) if p in wish.timed)
        return [(thing, range(behind, end))]
    opened = tree.nodes[thing].tag in DETERMINERS or tree.nodes[thing].lower in OWNERS
    return [(thing, range(behind, _end(wish, root)))] if opened else None


OWNERS = frozenset({"his", "hers", "theirs", "mine", "yours", "ours"})


def _is_sure_too(wish: Wish) -> list[Stretch] | None:
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
    return [(wish.start, _front(wish, sure + 1 + that))]


def _is_gone_for_too(wish: Wish) -> list[Stretch] | None:
    """Give what one goes for, or begins: "go" shopping at four and swimming at six."""
    tree, root = wish.tree, wish.tree.root
    if root is None or root + 1 >= wish.start:
        return None
    doing = root + 1
    gerunds = tree.nodes[doing].tag == tree.nodes[wish.start].tag == "VBG"
    return [(wish.start, _front(wish, doing))] if gerunds and tree.nodes[root].tag in {"VB", "VBP"} else None


def _ordered(wish: Wish) -> range | None:
    """Give the verb of an order that has an object, with its particle; None without one."""
    tree, action = wish.tree, action_of(wish.tree, wish.lexicon)
    if (
        action is None
        or action.negated
        or action.place >= wish.start
        or tree.children(action.place, *SUBJECTS)
    ):
        return None
    verb = action.place
    bare = tree.nodes[verb].lower == tree.nodes[verb].lemma and tree.nodes[verb].may_act
    return range(verb, _end(wish, verb)) if bare and tree.children(verb, "dobj", "xcomp") else None


def _opened(wish: Wish) -> bool:
    """Whether a wish begins with a thing: "the tables", "Bella", not with what may be a verb."""
    node, behind = wish.tree.nodes[wish.start], wish.tree.nodes[wish.start + 1 : wish.start + 2]
    numbered = (
        node.lower in wish.lexicon.machines | wish.lexicon.measure_nouns and behind and behind[0].tag == "CD"
    )
    named = node.tag == "NNP" and node.text[0].isupper()
    return node.tag in {*DETERMINERS, "CD", "NNS", "NNPS"} or named or bool(numbered)


def _goes_elsewhere(wish: Wish) -> list[Stretch] | None:
    """Give what is done with another thing elsewhere: "take" the chairs to room 2 and the tables to room 3."""
    verb, nodes = _ordered(wish), wish.tree.nodes
    if verb is None or not _opened(wish):
        return None
    where = next((p for p in range(wish.start + 1, wish.end) if nodes[p].tag in WHERE), None)
    if where is None or where + 1 >= wish.end or not wish.names(wish.start, where):
        return None
    before = (p for p in range(verb[-1] + 1, wish.start) if p not in wish.timed and nodes[p].tag in WHERE)
    first = next((p for p in before if wish.names(verb[-1] + 1, p)), None)
    alike = first is not None and nodes[first].lower == nodes[where].lower
    return [(wish.start, verb)] if alike else None


def _is_given_too(wish: Wish) -> list[Stretch] | None:
    """Give what another is given too: "give" Rex "a walk" at four and Bella at five, "give Rex" a bath."""
    verb, tree = _ordered(wish), wish.tree
    if verb is None or not wish.names(wish.start, wish.end):
        return None
    given, whom = tree.children(verb[0], "dobj"), tree.children(verb[0], "dative")
    if not given or not whom or not verb[0] < whom[0] < given[0]:
        return None
    thing = min(tree.below(given[0]))
    end = next((p for p in range(thing, wish.start) if p in wish.timed), wish.start)
    if any(tree.nodes[p].tag in DETERMINERS for p in range(wish.start + 1, wish.end)):
        # "… and the cat her drops at seven"
        return [(wish.start, verb)]
    kinds = [_kind(tree, place) for place in (wish.start, min(tree.below(whom[0])), thing)]
    if kinds[1] == kinds[2] or kinds[0] not in kinds[1:]:
        return None
    if kinds[0] == kinds[1]:
        return [(wish.start, verb), (wish.end, range(thing, end))] if wish.end < len(tree.nodes) else None
    return [(wish.start, range(verb[0], thing))]


def _kind(tree: Tree, place: int) -> str:
    """Give how a name begins: by itself, or with an article that means one, or any."""
    node = tree.nodes[place]
    if node.tag == "CD" or node.lower in {"a", "an", "some"}:
        return "any"
    return "this" if node.tag in DETERMINERS else "named"


def _is_put_too(wish: Wish) -> list[Stretch] | None:
    """Give what becomes of another thing too: "put" room 101 "in order" and room 102."""
    verb, nodes = _ordered(wish), wish.tree.nodes
    if verb is None or not _opened(wish) or not wish.names(wish.start, wish.end) or wish.end == len(nodes):
        return None
    time = next(p for p in range(verb[0], wish.start) if p in wish.timed)
    where, what = nodes[time - 2], nodes[time - 1]
    bare = where.tag in WHERE and where.lower in wish.lexicon.places | {"to"} and what.tag == "NN"
    whole = bare and wish.names(verb[-1] + 1, time - 2)
    return [(wish.start, verb), (wish.end, range(time - 2, time))] if whole else None


def _is_done_then(wish: Wish) -> list[Stretch] | None:
    """Give what is done with another thing when something is so: "start" it and the dryer when it's done."""
    verb, nodes = _ordered(wish), wish.tree.nodes
    clause = wish.end < len(nodes) and wish.end not in wish.timed
    opened = nodes[wish.start].tag in DETERMINERS and wish.names(wish.start, wish.end)
    return [(wish.start, verb)] if verb is not None and clause and opened else None


KINDS: tuple[Callable[[Wish], list[Stretch] | None], ...] = (
    _is_sure_too,
    _is_asked_too,
    _lets_too,
    _is_gone_for_too,
    _acts_too,
    _is_done_too,
    _goes_elsewhere,
    _is_given_too,
    _is_put_too,
    _is_done_then,
)
