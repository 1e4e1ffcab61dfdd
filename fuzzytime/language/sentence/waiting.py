"""Segments that wait for their trees, and the parts that they become."""

from dataclasses import dataclass
from datetime import datetime

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.language.instruction import Remark
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.sentence.actions import is_doubtful
from fuzzytime.language.sentence.segments import Segment
from fuzzytime.language.sentence.tree import Tree


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
class Source:
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
class Waiting:
    """A segment of a text that waits for its tree; its main words begin at ``main``."""

    position: int
    source: Source
    segment: Segment
    main: int

    @classmethod
    def of(cls, position: int, source: Source, segment: Segment, lexicon: Lexicon) -> "Waiting":
        """Give a segment of the source at a position."""
        return cls(position, source, segment, _main(source, segment, lexicon))

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


def _main(source: Source, segment: Segment, lexicon: Lexicon) -> int:
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
