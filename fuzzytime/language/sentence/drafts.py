"""The first pass over texts: times by the grammar, instructions apart, a tree for each, in a few batches."""

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from itertools import pairwise

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.instruction import Remark, Span
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.sentence.actions import is_doubtful
from fuzzytime.language.sentence.corrections import corrected
from fuzzytime.language.sentence.segments import ARTICLES, Segment, further_verbs, segments_of
from fuzzytime.language.sentence.tree import Tree

CARRIERS = ("", "please ", "you should ")
"""Words that make a parser see the verb behind them, tried in this order."""

JOINT = re.compile(r"[\s,;&]*(\band\b)?[\s,;&]*$", re.IGNORECASE)
"""What stands between two instructions."""

CHAIN = re.compile(r",?w(?:,w)*,?&")
"""Words (w), commas and "and" (&) before the last of some verbs that share an object."""

SHORTEST_CALL = 3
"""Words of an instruction at least that names who is asked: a name, a comma, what is to be done."""

SHORTEST_GAP = 3
"""Words at least between two times of which the second is another thing's: "and the dog"."""

ROUNDS = 12
"""How often a segment may be cut again: instructions joined by "and" in one sentence."""

Trees = Callable[[Sequence[str]], list[Tree]]


@dataclass(frozen=True, slots=True)
class Part:
    """One instruction: its stretch, and the tree of its words from ``offset`` on.

    A clause in front ("before you serve the soup, …") has a tree of its own: in one tree with the rest, it is
    often taken for the main clause.
    """

    segment: Segment
    tree: Tree
    offset: int
    front: Tree | None = None


@dataclass(frozen=True, slots=True)
class Draft:
    """A text with its times and its parts, before anything is grounded."""

    text: str
    now: datetime | None
    scanned: Scanned
    phrases: tuple[Phrase, ...]
    parts: tuple[Part, ...]
    remarks: tuple[Remark, ...]

    @property
    def unfinished(self) -> tuple[Span, ...]:
        """The stretches that begin a time and do not end it: "at half past"."""
        words = self.scanned.words
        found = self.scanned.pieces("unfinished")
        return tuple((words[piece.start].start, words[piece.end - 1].end) for piece in found)


def drafted(
    texts: Sequence[tuple[str, datetime | None]], grammar: Grammar, lexicon: Lexicon, trees: Trees
) -> list[Draft]:
    """Draft texts; ``trees`` parses."""
    sources = []
    for text, now in texts:
        scanned = Scanned.of(text, grammar, lexicon)
        phrases, remarks = corrected(scanned, phrases_of(scanned, lexicon), lexicon)
        sources.append(_Source(now, scanned, tuple(phrases), tuple(remarks)))
    parts = _parted(sources, lexicon, trees)
    return [
        Draft(s.scanned.text, s.now, s.scanned, s.phrases, tuple(own), s.remarks)
        for s, own in zip(sources, parts, strict=True)
    ]


@dataclass(frozen=True, slots=True)
class _Source:
    """A text, scanned for times."""

    now: datetime | None
    scanned: Scanned
    phrases: tuple[Phrase, ...]
    remarks: tuple[Remark, ...]

    @property
    def sound(self) -> str:
        """The text with spaces where words were taken back: "at five, I mean six"."""
        text = self.scanned.text
        for first, end in (remark.span for remark in self.remarks):
            text = text[:first] + " " * (end - first) + text[end:]
        return text

    @property
    def covered(self) -> frozenset[int]:
        """The places of the words that are about time."""
        return frozenset(place for phrase in self.phrases for place in range(phrase.first, phrase.end))

    def places(self, first: int, end: int) -> list[int]:
        """Give the places of the words in a stretch of characters."""
        return [place for place, word in enumerate(self.scanned.words) if first <= word.start < end]


@dataclass(frozen=True, slots=True)
class _Waiting:
    """A segment of a text that waits for its tree; its main words begin at ``main``."""

    position: int
    source: _Source
    segment: Segment
    main: int

    @property
    def text(self) -> str:
        """The main words, or nothing where they are all time: such a fragment needs no tree."""
        covered = self.source.covered
        words = self.source.scanned.words
        places = self.source.places(self.main, self.segment.span[1])
        said = [words[place] for place in places if place not in covered]
        wanted = any((word.is_letters or word.is_digits) and word.text != "please" for word in said)
        return self.source.sound[self.main : self.segment.span[1]] if wanted else ""

    @property
    def front(self) -> str:
        """The clause in front, nothing where there is none."""
        return self.source.sound[self.segment.span[0] : self.main]

    @property
    def behind_time(self) -> int:
        """Where the main words begin behind a time in front of them, from ``main``."""
        places = self.source.places(self.main, self.segment.span[1])
        words = self.source.scanned.words
        while places:
            leading = next((p for p in self.source.phrases if p.first == places[0]), None)
            if leading is None and words[places[0]].text != ",":
                return words[places[0]].start - self.main
            end = leading.end if leading is not None else places[0] + 1
            places = [place for place in places if place >= end]
        return 0

    def doubts(self, tree: Tree, lexicon: Lexicon) -> bool:
        """Whether a tree is hardly right: it has no order at its root, or has one of a clause for it."""
        if not tree.nodes or is_doubtful(tree):
            return bool(tree.nodes)
        words, covered = self.source.scanned.words, self.source.covered
        root = self.main + tree.nodes[tree.root or 0].start
        before = [p for p in self.source.places(self.main, root) if p not in covered]
        if not before or longest_match(words, before[0], lexicon.clauses) is not None:
            return False
        return any(longest_match(words, place, lexicon.clauses) is not None for place in before[1:])


def _parted(sources: Sequence[_Source], lexicon: Lexicon, trees: Trees) -> list[list[Part]]:
    """Parse every segment, and cut it again where its tree shows a further instruction."""
    done: list[dict[int, Part]] = [{} for _ in sources]
    waiting = [
        _waiting(position, source, segment, lexicon)
        for position, source in enumerate(sources)
        for segment in segments_of(source.scanned.text, source.scanned.words, source.phrases, lexicon)
    ]
    for last_round in (False,) * ROUNDS + (True,):
        if not waiting:
            break
        found, fronts = _trees(waiting, trees, lexicon), _uncapitalised([one.front for one in waiting], trees)
        following: list[_Waiting] = []
        for one, tree, front in zip(waiting, found, fronts, strict=True):
            part = Part(one.segment, tree, one.main, front if front.nodes else None)
            cut = [] if last_round else _addressed(one, part, lexicon) or list(_cut(one, part, lexicon))
            following += [_waiting(one.position, one.source, segment, lexicon) for segment in cut]
            if not cut:
                done[one.position][one.segment.span[0]] = part
        waiting = following
    return [[own[start] for start in sorted(own)] for own in done]


def _waiting(position: int, source: _Source, segment: Segment, lexicon: Lexicon) -> _Waiting:
    return _Waiting(position, source, segment, _main(source, segment, lexicon))


def _main(source: _Source, segment: Segment, lexicon: Lexicon) -> int:
    """Give where the words behind a clause in front begin; the segment's start where there is none.

    A clause in front begins with a marker, or with a length of time and a marker, and ends at a comma.
    """
    words = source.scanned.words
    places = source.places(*segment.span)
    first = next(
        (p.end for p in source.phrases if places and p.first == places[0]), places[0] if places else -1
    )
    inside = any(phrase.first <= first < phrase.end for phrase in source.phrases)
    if first not in places or inside or longest_match(words, first, lexicon.clauses) is None:
        return segment.span[0]
    comma = next((place for place in places if place > first and words[place].text == ","), None)
    return words[comma + 1].start if comma is not None and comma + 1 in places else segment.span[0]


def _trees(waiting: Sequence[_Waiting], trees: Trees, lexicon: Lexicon) -> list[Tree]:
    """Parse segments; one whose tree is doubtful again without the time in front, and behind other words."""
    texts = [one.text for one in waiting]
    found = _uncapitalised(texts, trees)
    for carrier in CARRIERS:
        again = [
            (place, waiting[place].behind_time)
            for place, tree in enumerate(found)
            if waiting[place].doubts(tree, lexicon) and (carrier or waiting[place].behind_time)
        ]
        carried = trees([carrier + _lowered(texts[place][skipped:]) for place, skipped in again])
        for (place, skipped), tree in zip(again, carried, strict=True):
            bare = tree.without_carrier(carrier, texts[place], skipped)
            if bare.nodes and not waiting[place].doubts(bare, lexicon):
                found[place] = bare
    return found


def _uncapitalised(texts: Sequence[str], trees: Trees) -> list[Tree]:
    """Parse texts as if they began with a small letter: a capital makes a verb look like a name ("Chop")."""
    asked = [_lowered(text) if text[1:2].islower() else text for text in texts]
    return [
        tree.without_carrier("", text, 0) if text != said else tree
        for text, said, tree in zip(texts, asked, trees(asked), strict=True)
    ]


def _lowered(text: str) -> str:
    """Give a text whose first letter is no capital, as behind other words."""
    return text[:1].lower() + text[1:] if len(text[:1].lower()) == 1 else text


def _addressed(one: _Waiting, part: Part, lexicon: Lexicon) -> list[Segment]:
    """Give the segment without the name before its first comma, or behind its last, of who is asked.

    A name begins with a capital, and is no verb: "Wash, peel and slice the apples" asks nobody by name.
    """
    nodes = part.tree.nodes
    if one.segment.addressee is not None or len(nodes) < SHORTEST_CALL:
        return []
    first, last = one.segment.span
    for name, mark, rest in (
        (nodes[0], nodes[1], (nodes[2].start + part.offset, last)),
        (nodes[-1], nodes[-2], (first, nodes[-3].end + part.offset)),
    ):
        place = one.source.places(name.start + part.offset, name.end + part.offset)
        named = name.text[0].isupper() or name.lower in lexicon.persons
        timed = bool(one.source.covered & set(place))
        if mark.text in {",", ":"} and named and not timed and not name.may_act and name.text.isalpha():
            segment = replace(one.segment, span=rest, addressee=name.text)
            if rest[0] < rest[1] and _waiting(one.position, one.source, segment, lexicon).text:
                return [segment]
    return []


def _cut(one: _Waiting, part: Part, lexicon: Lexicon) -> Iterator[Segment]:
    """Give the pieces of a segment around its first further verb; none where there is none."""
    root = part.tree.root
    if root is None:
        return
    first, last = one.segment.span
    times = [(a - part.offset, b - part.offset) for a, b in (phrase.span for phrase in one.source.phrases)]
    starts = [
        part.tree.nodes[place].start for place in sorted(further_verbs(part.tree, root, lexicon, times))
    ]
    starts = [start + part.offset for start in starts if not any(a < start < b for a, b in times)]
    for start in starts:
        chain = _chain(one, part, start)
        if chain:
            yield from chain
            return
    starts += _gaps(one, part)
    for start in starts:
        end = first + len(JOINT.sub("", one.source.scanned.text[first:start]))
        if end > part.offset:
            yield replace(one.segment, span=(first, end))
            yield Segment((start, last), addressee=one.segment.addressee)
            return


def _gaps(one: _Waiting, part: Part) -> list[int]:
    """Give where the verb is left out before another thing and its time: "the cat at 8 and the dog at 9"."""
    words, phrases = one.source.scanned.words, one.source.phrases
    own = [p for p in phrases if part.offset <= p.span[0] and p.span[1] <= one.segment.span[1]]
    found = []
    for old, new in pairwise(own):
        between = words[old.end : new.first]
        if len(between) < SHORTEST_GAP or between[0].text not in {"and", ","}:
            continue
        nodes = part.tree.at(between[1].start - part.offset, between[-1].end - part.offset)
        nouns = all(part.tree.nodes[p].tag in {"DT", "PRP$", "JJ", "NN", "NNS", "NNP", "IN"} for p in nodes)
        if nouns and between[1].text in ARTICLES and old.said.constraint is new.said.constraint:
            found.append(between[1].start)
    return found


def _chain(one: _Waiting, part: Part, start: int) -> list[Segment]:
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
    if part.tree.nodes[part.tree.root or 0].start + part.offset != words[verbs[0]].start:
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
