"""Segments parsed: a tree each, again in other words where the first is doubtful."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import longest_match
from fuzzytime.language.instruction import Span, blanked
from fuzzytime.language.sentence.segments.borrowed import in_place, with_borrowed
from fuzzytime.language.sentence.segments.mended.aims import with_aim, with_purpose
from fuzzytime.language.sentence.segments.mended.joined_things import with_joined
from fuzzytime.language.sentence.segments.mended.mended_things import (
    with_bare_thing,
    with_event_names,
    with_her,
    with_object_of_aim,
    with_thing_before_time,
    with_whole_things,
)
from fuzzytime.language.sentence.segments.mended.mended_trees import (
    as_acting,
    as_done,
    as_order,
    as_somewhere,
    as_thing,
    with_reminded,
)
from fuzzytime.language.sentence.segments.mended.needed_deeds import with_needed_deed, with_owner
from fuzzytime.language.sentence.segments.mended.places_in_front import with_places_in_front
from fuzzytime.language.sentence.segments.mended.said_to_be import (
    with_doer_in_front,
    with_what_is_said,
)
from fuzzytime.language.sentence.segments.mended.topics import with_topic
from fuzzytime.language.sentence.segments.orders_beside_times import begins_order, is_done_alone, is_numbered
from fuzzytime.language.sentence.segments.waiting import Waiting
from fuzzytime.language.sentence.trees.named import is_none, names_one
from fuzzytime.language.sentence.trees.tags import DETERMINERS, SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree, Trees
from fuzzytime.language.sentence.verbs.meant.actions import action_of, gone_to_do, is_doubtful
from fuzzytime.language.sentence.verbs.statements.called import (
    with_called,
    with_clause,
    with_doer,
    with_event,
)
from fuzzytime.language.sentence.verbs.statements.statement_trees import as_statement, leaves
from fuzzytime.language.sentence.verbs.without_verbs.due_by_then import is_thing_so
from fuzzytime.language.sentence.verbs.without_verbs.happenings import happens, may_be_ordered
from fuzzytime.language.sentence.verbs.without_verbs.named_deeds import with_named_deed

CARRIERS = ("please ", "you should ")
"""Words that make a parser see the verb behind them, tried in this order."""


def trees_of(waiting: Sequence[Waiting], trees: Trees) -> list[Tree]:
    """Parse segments without a time in front; one whose tree is doubtful again behind other words."""
    texts = [_heard(one) for one in waiting]
    found = uncapitalised(texts, trees, [one.heard_from for one in waiting])
    astray = [p for p, one in enumerate(waiting) if one.segment.borrowed and is_doubtful(found[p])]
    carried = trees([CARRIERS[0] + texts[place] for place in astray])
    for place, tree in zip(astray, carried, strict=True):
        # "Text Leo at five and | text Jen at six"
        found[place] = tree.without_carrier(CARRIERS[0], texts[place], 0)
    found = [as_done(_in_place(one, tree)) for one, tree in zip(waiting, found, strict=True)]
    own = {place for place, one in enumerate(waiting) if not one.segment.borrowed}
    led_astray = [p for p, tree in enumerate(found) if p in own and tree.root in waiting[p].timed(tree)]
    blanked = trees([_without_root(found[place]) for place in led_astray])
    for place, tree in zip(led_astray, blanked, strict=True):
        # "The ferry leaves at 10:45 sharp": a word about time is never what is to be done.
        if tree.root not in waiting[place].timed(tree):
            found[place] = replace(tree, text=texts[place])
    for carrier in CARRIERS:
        again = [
            (place, _behind_asking(waiting[place]))
            for place, tree in enumerate(found)
            if place in own and _is_astray(waiting[place], tree)
        ]
        carried = trees([carrier + _lowered(texts[place][skipped:]) for place, skipped in again])
        for (place, skipped), tree in zip(again, carried, strict=True):
            bare = as_order(tree.without_carrier(carrier, texts[place], skipped))
            if bare.nodes and _may_be_done(bare) and not _is_astray(waiting[place], bare):
                found[place] = bare
    found = with_places_in_front(waiting, found, trees)
    told = [place for place, one in enumerate(waiting) if one.segment.doer is not None]
    led = trees([f"{waiting[place].segment.doer} {texts[place]}" for place in told])
    for place, tree in zip(told, led, strict=True):
        # "The plumber comes at four, fixes the tap": it is a verb behind who does it.
        alone = tree.without_carrier(f"{waiting[place].segment.doer} ", texts[place], 0)
        found[place] = as_acting(alone)
    return [_mended(one, tree) for one, tree in zip(waiting, found, strict=True)]


def _mended(one: Waiting, tree: Tree) -> Tree:
    """Give a tree with what its model overlooks; where all words are of its time, it is empty."""
    if not tree.nodes:
        return tree
    timed = one.timed(tree)
    tree = as_somewhere(tree, timed)
    tree = with_topic(with_what_is_said(with_doer_in_front(tree)), timed)
    tree = with_joined(as_thing(tree, timed), timed)
    tree = with_thing_before_time(with_her(with_bare_thing(with_whole_things(tree), timed), timed), timed)
    tree = with_purpose(with_aim(tree, timed))
    tree = with_event_names(with_object_of_aim(tree, timed), timed)
    tree = with_event(with_clause(with_reminded(tree)))
    tree = with_called(with_doer(with_needed_deed(with_owner(tree, timed), timed)), timed)
    tree = with_named_deed(tree, timed) if timed or one.heard_from else tree
    return as_statement(tree, timed, one.lexicon.travelling)


def _behind_asking(one: Waiting) -> int:
    """Give where an order begins behind what only asks for it: "go and | ring dad"."""
    closed, start = one.lexicon.closed, one.behind_time
    behind = [*one.source.places(one.main + start, one.segment.span[1])]
    words = [one.source.scanned.words[place] for place in behind]
    first, second = ([word.text for word in words] + ["", ""])[:2]
    asks = first in closed.requesting_modals and second in closed.second_person
    asks = asks or (first in one.lexicon.doing.trying and second == "and")
    asked = 2 if asks else int(first in closed.proposing_together)
    return words[asked].start - one.main if asked < len(words) else start


def _is_astray(one: Waiting, tree: Tree) -> bool:
    """Whether a tree is hardly right: it has no order at its root, or has one of a clause for it."""
    if not tree.nodes:
        return False
    timed = one.timed(tree)
    end = min(timed, default=0)
    named = tree.root == end - 1 and not tree.children(tree.root, "dobj")
    if (named and names_one(tree.nodes[:end], one.lexicon)) or is_none(tree, tree.root):
        return False
    if one.phrases and happens(tree, one.phrases):
        return may_be_ordered(tree) or begins_order(tree)
    if leaves(tree, tree.root, one.lexicon.travelling) or is_thing_so(tree, timed):
        return False
    if is_doubtful(tree) or is_numbered(tree) or _only_asks(tree):
        return True
    if _overlooks_order(one, tree) or begins_order(tree) or tree.root in one.timed(tree):
        return True
    words, root = one.source.scanned.words, one.main + tree.nodes[tree.root].start
    before = [p for p in one.source.places(one.main, root) if p not in one.source.covered]
    led = [longest_match(words, place, one.lexicon.clauses) is not None for place in before]
    return any(led) and not led[0]


def _only_asks(tree: Tree) -> bool:
    """Whether a tree shows nothing to do behind what asks for it: "go and | ring dad"."""
    action = action_of(tree)
    place = tree.root if action is None else action.place
    leads = tree.nodes[place].lemma in tree.lexicon.doing.trying and gone_to_do(tree, place) is None
    behind = tree.nodes[place + 1].lower if place + 1 < len(tree.nodes) else ""
    return (leads and behind == "and") or (tree.nodes[place].lemma == "let" and behind in {"'s", "’s"})


def _overlooks_order(one: Waiting, tree: Tree) -> bool:
    """Whether a bare verb right behind a time in front is not its root: "from now on keep it shut"."""
    first = next(iter(tree.at(one.behind_time, one.behind_time + 1)), None)
    if first is None or first == tree.root:
        return False
    node = tree.nodes[first]
    if not node.may_act or node.lower != node.lemma:
        return False
    if is_done_alone(tree, first):
        return True
    if first == 0 and len(tree.nodes) > 1 and tree.nodes[1].lower in one.lexicon.closed.it_or_them:
        # "Pat it dry"
        return True
    if first == 0 and node.lower in one.lexicon.particles.get(tree.nodes[1].lower, ()):
        # "Top up the water troughs"
        return True
    if first == 0 and node.tag.startswith("NN") and tree.nodes[1].tag in {"DT", "PRP$"}:
        # "Print the boarding passes tonight"
        return True
    # "Fetch crate 4, bring it here": the first order is taken for who does the second.
    subjects = tree.children(tree.root, *SUBJECTS, *(() if tree.nodes[tree.root].may_act else ("advcl",)))
    taken = any(first in tree.below(place) for place in subjects)
    return (
        taken
        and tree.root > 0
        and tree.nodes[tree.root - 1].lower in {*tree.lexicon.closed.joints_of_things, ";"}
    )


def _may_be_done(tree: Tree) -> bool:
    """Whether the root of a tree is a known verb, or has an object: "pipette the buffer", but "session 2".

    Behind "please", a parser takes any noun for a verb.
    """
    lexicon = tree.lexicon
    node = tree.nodes[tree.root]
    # "Mic up the leads"
    behind = tree.root + 1 + len(tree.children(tree.root, "prt"))
    if any(one.lower in lexicon.doing.surely_timed for one in tree.nodes[tree.root + 1 : tree.root + 2]):
        # "Bank shuts at four"
        return False
    led = any(one.tag in DETERMINERS | {"PRP"} for one in tree.nodes[behind : behind + 1])
    return node.may_act or node.lower in lexicon.timing_alone or led


def _heard(one: Waiting) -> str:
    """Give the main words of a segment, or all of it with those that it borrows."""
    borrowed = one.segment.borrowed
    return with_borrowed(one.source.sound, _stretch(one), borrowed) if borrowed else one.text


def _in_place(one: Waiting, tree: Tree) -> Tree:
    """Give the tree of what was heard of a segment with the places of its words, also of those it borrows."""
    return in_place(tree, one.source.sound, one.segment.span, _stretch(one), one.segment.borrowed)


def _stretch(one: Waiting) -> Span:
    """Give the stretch of a segment from where it borrows words on, behind a time in front."""
    first, end = one.segment.span
    begin = min((borrowed.at for borrowed in one.segment.borrowed), default=first)
    return (begin if one.source.covered.issuperset(one.source.places(first, begin)) else first, end)


def _without_root(tree: Tree) -> str:
    """Give the text of a tree with spaces for its root."""
    node = tree.nodes[tree.root]
    return blanked(tree.text, [(node.start, node.end)])


def uncapitalised(texts: Sequence[str], trees: Trees, skipped: Sequence[int] = ()) -> list[Tree]:
    """Parse texts as if they began with a small letter: a capital makes a verb look like a name ("Chop").

    So many characters may be ``skipped`` in front of each.
    """
    places = skipped or [0] * len(texts)
    heard = [text[place:] for text, place in zip(texts, places, strict=True)]
    asked = [_lowered(text) if text[1:2].islower() else text for text in heard]
    return [
        tree.without_carrier("", text, place) if text != said else tree
        for text, place, said, tree in zip(texts, places, asked, trees(asked), strict=True)
    ]


def _lowered(text: str) -> str:
    """Give a text whose first letter is no capital, as behind other words."""
    return text[:1].lower() + text[1:] if len(text[:1].lower()) == 1 else text
