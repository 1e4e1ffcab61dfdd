"""Where a segment is cut again, once its tree is known: at further verbs, names, and verbs left out."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.instruction import Span
from fuzzytime.language.meaning.expressions import Repeat, TimeWord, Wall
from fuzzytime.language.sentence.segments.borrowed import Borrowed
from fuzzytime.language.sentence.segments.borrowed_words.borrowing import wishes_beside
from fuzzytime.language.sentence.segments.further.further_orders import further_verbs
from fuzzytime.language.sentence.segments.further.other_doers import other_doers
from fuzzytime.language.sentence.segments.further.verbs_left_out import verbs_left_out
from fuzzytime.language.sentence.segments.segment import Segment
from fuzzytime.language.sentence.segments.waiting import Part, Waiting
from fuzzytime.language.sentence.trees.named import may_have_it_done, takes_verb
from fuzzytime.language.sentence.verbs.meant.actions import action_of
from fuzzytime.language.sentence.verbs.meant.complements import complement
from fuzzytime.language.sentence.verbs.statements.called import person_due
from fuzzytime.language.sentence.verbs.statements.statements import second_statement

CHAIN = re.compile(r",?w(?:,w)*,?&")
"""Words (w), commas and "and" (&) before the last of some verbs that share an object."""


def reminded(one: Waiting, part: Part) -> list[Segment]:
    """Give what is not to be forgotten, where that happens: "don't forget the plumber comes at four".

    So is what somebody is not let forget: "don't let me forget the bins go out".
    """
    root, nodes = part.tree.root, part.tree.nodes
    let = complement(part.tree, root, "let")
    if let is not None and nodes[let].lemma in part.lexicon.forgetting:
        root = let
    elif part.tree.children(root, "nsubj", "nsubjpass"):
        return []
    if nodes[root].lemma not in part.lexicon.forgetting | part.lexicon.doing.remembering:
        return []
    for told in part.tree.children(root, "ccomp"):
        subjects = [p for p in part.tree.children(told, "nsubj", "nsubjpass", "expl") if root < p < told]
        if not subjects or nodes[told].tag == "VB" or nodes[subjects[0]].lower == "you":
            continue
        first = min(part.tree.below(subjects[0]))
        if first == root + 1 or (first == root + 2 and nodes[root + 1].lower == "that"):
            start = nodes[first].start + part.offset
            return [replace(one.segment, span=(start, one.segment.span[1]))]
    return []


def pieces_of(one: Waiting, part: Part) -> list[Segment]:
    """Give the pieces of a segment around its first further verb; none where there is none."""
    onward = _onward(one, part)
    if onward is not None:
        return [replace(one.segment, span=(one.segment.span[0], onward[0])), onward[1]]
    for place in other_doers(part.tree):
        pieces = _around(one, part, part.tree.nodes[place].start + part.offset)
        if pieces:
            return pieces
    starts = _further(one, part)
    for start in starts:
        chain = _chain(one, part, start)
        if chain:
            return chain
    denied = _denied_list(one, starts)
    if denied:
        return denied
    wishes = wishes_beside(one, part)
    gaps = _gaps(one, part)
    for start in (*sorted(wishes), *(start for start in starts if start not in gaps)):
        pieces = _around(one, part, start)
        if pieces and start in wishes:
            return [pieces[0], *_each(one, part, pieces[1], wishes, starts)]
        if pieces:
            return pieces
    return []


def _each(
    one: Waiting,
    part: Part,
    behind: Segment,
    wishes: Mapping[int, tuple[Borrowed, ...]],
    starts: Sequence[int],
) -> list[Segment]:
    """Give the wishes in a stretch, up to a further order, each with the words that it borrows."""
    start, end = behind.span
    until = min((further for further in starts if start < further), default=end)
    further = min((place for place in wishes if start < place < until), default=None)
    first = replace(behind, borrowed=wishes[start])
    if further is None:
        return [first]
    before, rest = _around(replace(one, segment=first), part, further)
    return [before, *_each(one, part, rest, wishes, starts)]


def other_things(one: Waiting, part: Part) -> list[Segment]:
    """Give the pieces of a segment around the first place where a verb is left out: "… and the dog at 9"."""
    for start in sorted(_gaps(one, part)) if part.tree.nodes else ():
        pieces = _around(one, part, start)
        if pieces:
            return [pieces[0], replace(pieces[1], verbless=_takes_verb(one, part, start))]
    return []


def _around(one: Waiting, part: Part, start: int) -> list[Segment]:
    """Give what stands before a place, without its joint, and what begins there."""
    first, last = one.segment.span
    end = one.end_before(start)
    addressee = one.segment.addressee or _due_too(part, start)
    behind = Segment((start, last), addressee=addressee)
    return [replace(one.segment, span=(first, end)), behind] if end > part.offset else []


def _further(one: Waiting, part: Part) -> list[int]:
    """Give where further verbs are in the text, but for those within a time."""
    times = _times(one, part)
    told = part.segment.doer is not None
    found = further_verbs(part.tree, part.tree.root, times, told=told)
    starts = (part.tree.nodes[place].start for place in sorted(found))
    return [start + part.offset for start in starts if not any(a < start < b for a, b in times)]


def _times(one: Waiting, part: Part) -> list[Span]:
    return [part.local(phrase.span) for phrase in one.source.phrases]


def _gaps(one: Waiting, part: Part) -> set[int]:
    """Give where verbs are left out in the text, and nothing else is told or to be done."""
    nodes, timed = part.tree.nodes, {place for span in _times(one, part) for place in part.tree.at(*span)}
    others = [second_statement(part.tree, place, timed) for place in range(len(nodes))]
    starts = {nodes[place].start + part.offset for place in others if place is not None}
    return set(verbs_left_out(one, part)) - starts


def _due_too(part: Part, start: int) -> str | None:
    """Give who must do this, too: "Tim has to wash the car and feed the dog"; None for nobody."""
    action = action_of(part.tree)
    place = next(part.at((start, start + 1)), None)
    if (
        action is None
        or place is None
        or part.tree.nodes[place - 1].lower not in part.lexicon.closed.additive_conjunctions
    ):
        return None
    node = part.tree.nodes[place]
    joined = node.relation == "conj" and node.head == action.place and node.tag == "VB"
    return person_due(part.tree, action.place) if joined else None


def _takes_verb(one: Waiting, part: Part, start: int) -> bool:
    """Whether the same is done with what is named there: not so of "ring bob at six, lunch at one"."""
    text, verb = one.source.scanned.text, part.tree.nodes[part.tree.root]
    other = next(part.tree.at(start - part.offset, start - part.offset + 1), part.tree.root)
    if not may_have_it_done(verb.lemma, part.tree.nodes[other], part.lexicon):
        return False
    times = [phrase.span[0] for phrase in one.source.phrases]
    named = part.offset + verb.end, start
    first, second = (text[at : min((t for t in times if t > at), default=None)] for at in named)
    return takes_verb(verb.lemma, first, second, part.lexicon)


def _denied_list(one: Waiting, starts: Sequence[int]) -> list[Segment]:
    """Give the segments of what is denied together: "never open the lid, lift the pan or leave the room".

    Its further orders begin at ``starts``.
    """
    first, last = one.segment.span
    words = {word.start: place for place, word in enumerate(one.source.scanned.words)}
    texts = ["", *(word.text for word in one.source.scanned.words)]
    closing = [s for s in starts if s in words and texts[words[s]] in one.lexicon.closed.denied_alternatives]
    begins = [first, *(start for start in starts if closing and start <= closing[-1])]
    if len(begins) == 1:
        return []
    ends = [one.end_before(b, a) for a, b in pairwise(begins)]
    spans = zip(begins, (*ends, last), strict=True)
    return [
        replace(one.segment, span=span)
        if span[0] == first
        else Segment(span, addressee=one.segment.addressee)
        for span in spans
    ]


def _onward(one: Waiting, part: Part) -> tuple[int, Segment] | None:
    """Give where a time ends, and the repetition behind it: "tomorrow and every two days after that"."""
    words, last = one.source.scanned.words, one.segment.span[1]
    own = [p for p in one.source.phrases if part.offset <= p.span[0] and p.span[1] <= last]
    for old, new in pairwise(own):
        begun = isinstance(old.said.time, (Repeat, Wall, TimeWord))
        if not begun or not isinstance(new.said.time, Repeat):
            continue
        between = {word.text for word in words[old.end : new.first]}
        said = [word.text for word in words[new.first : new.end]]
        forms = (form.split() for form in part.lexicon.beside.thereafter)
        behind = next((form for form in forms if said[-len(form) :] == form), None)
        if behind is not None and between and between <= {*part.lexicon.closed.conjunctions_of_clauses, ","}:
            joint = (words[new.end - len(behind)].start, new.span[1])
            return old.span[1], Segment((new.span[0], last), "then", joint, one.segment.addressee)
    return None


def _chain(one: Waiting, part: Part, start: int) -> list[Segment]:
    """Give the segments of verbs alone before one with an object: "wash, peel and slice the apples".

    The tree often has the further ones for nouns; what counts is that the first is its root.
    """
    words, covered = one.source.scanned.words, one.source.covered
    places = [place for place in one.source.places(part.offset, start) if place not in covered]
    shape = "".join({",": ",", "and": "&"}.get(words[place].text, "w") for place in places)
    verbs = [place for place, mark in zip(places, shape, strict=True) if mark == "w"]
    if not CHAIN.fullmatch(shape) or not all(words[place].is_letters for place in verbs):
        return []
    if places[-1] - verbs[0] >= len(places):
        # "Wait two minutes, and paint it": the first has a time of its own.
        return []
    before, last = words[verbs[0] - 1 : verbs[0]], words[verbs[-1]]
    apart = last.text in part.lexicon.needing_nothing and words[places[-1] + 1].text != "be"
    if apart and before and before[0].text in part.lexicon.closed.joints_of_things:
        # "Clean the bath, hoover and get the bins in by six"; but "…, shower, and be downstairs by six"
        return []
    ends = [words[place].end for place in verbs]
    begins = [*(words[place].start for place in verbs[1:]), start]
    joints = [(words[place - 1].start, words[place - 1].end) for place in (*verbs[1:], places[-1] + 1)]
    spans = zip(begins, (*ends[1:], one.segment.span[1]), strict=True)
    return [
        replace(one.segment, span=(one.segment.span[0], ends[0])),
        *(
            Segment(span, "then", joint, one.segment.addressee)
            for span, joint in zip(spans, joints, strict=True)
        ),
    ]
