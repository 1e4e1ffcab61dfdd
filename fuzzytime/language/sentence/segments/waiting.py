"""Segments that wait for their trees, and the parts that they become."""

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import is_quoted
from fuzzytime.language.instruction import Span
from fuzzytime.language.meaning.expressions import Duration, Phrase
from fuzzytime.language.sentence.clauses.levels import level_end, levels_behind_joints
from fuzzytime.language.sentence.segments.leading_markers import (
    Marker,
    goes_on_behind,
    is_dated_behind,
    marker_at,
    second_marker,
)
from fuzzytime.language.sentence.segments.segment import Segment
from fuzzytime.language.sentence.segments.source import Source
from fuzzytime.language.sentence.trees.tree import Node, Tree

JOINT = re.compile(r"[\s,;&]*(\b(?:and|so|but|or|nor)\b)?[\s,;&]*(\bplease\b)?[\s,;&]*$", re.IGNORECASE)
"""What stands between two instructions."""


STATED = frozenset({"when", "if", "while"})
"""Kinds of clauses that say what must be so."""


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

    @property
    def lexicon(self) -> Lexicon:
        """The words of its language."""
        return self.tree.lexicon

    def local(self, span: Span) -> Span:
        """Give a stretch of the text as one of the tree's."""
        return span[0] - self.offset, span[1] - self.offset

    def at(self, span: Span) -> Iterator[int]:
        """Give the words of the tree that lie in a stretch of the text."""
        return self.tree.at(*self.local(span))

    def span(self, first: Node, last: Node | None = None) -> Span:
        """Give the stretch of the text from one word of the tree to another, or that of one."""
        return first.start + self.offset, (last or first).end + self.offset


@dataclass(frozen=True, slots=True)
class Waiting:
    """A segment of a text that waits for its tree; its main words begin at ``main``."""

    position: int
    source: Source
    segment: Segment
    main: int

    @classmethod
    def of(cls, position: int, source: Source, segment: Segment) -> "Waiting":
        """Give a segment of the source at a position."""
        return cls(position, source, segment, _main(source, segment))

    @property
    def lexicon(self) -> Lexicon:
        """The words of its language."""
        return self.source.scanned.lexicon

    @property
    def text(self) -> str:
        """The main words, or nothing where they are all time: such a fragment needs no tree."""
        covered = self.source.covered
        words = self.source.scanned.words
        places = self.source.places(self.main, self.segment.span[1])
        said = [words[place] for place in places if place not in covered]
        named = (word for word in said if word.is_letters or word.is_digits or is_quoted(word.text))
        wanted = any(word.text != "please" for word in named)
        return self.source.sound[self.main : self.segment.span[1]] if wanted else ""

    @property
    def front(self) -> str:
        """The clause in front, nothing where there is none; one without its "if" as if it had one."""
        text = self.source.sound[self.segment.span[0] : self.main]
        first = text.partition(" ")[0]
        inverted = first.lower() in self.lexicon.closed.conditional_inversion
        return "if".ljust(len(first)) + text[len(first) :] if inverted else text

    def markers(self) -> Iterator[Marker]:
        """Give the markers of clauses in front: at its start without a comma, or behind a joint."""
        words = self.source.scanned.words
        for position, place in enumerate(self.source.places(*self.segment.span)):
            before = words[place - 1].text if place else ""
            leads = (
                self.main == self.segment.span[0]
                if position == 0
                # "Melt the butter, as soon as that's done mix them"
                else before in self.lexicon.closed.joints_of_conditions | {","}
            )
            leads = leads and (position == 0 or words[place].start >= self.main)
            end = self.segment.span[1]
            marker = marker_at(words, self.source.phrases, place, end, self.lexicon) if leads else None
            if marker is not None:
                yield marker

    def leading_marker(self) -> Marker | None:
        """Give the marker of the clause in front that a comma ends; None where there is none."""
        places = self.source.places(*self.segment.span)
        if self.main == self.segment.span[0] or not places:
            return None
        source, end = self.source, self.segment.span[1]
        return marker_at(source.scanned.words, source.phrases, places[0], end, self.lexicon)

    def end_before(self, start: int, first: int | None = None) -> int:
        """Give where what stands before a place ends, without what joins both."""
        first = self.segment.span[0] if first is None else first
        return first + len(JOINT.sub("", self.source.scanned.text[first:start]))

    def cut_at(self, start: int, main: int) -> Iterator["Waiting"]:
        """Give what stands before a clause in front, and what it leads from ``main`` on."""
        led, kept = self.segment, (self.segment.span[0], self.end_before(start))
        if kept[1] > kept[0]:
            yield Waiting.of(self.position, self.source, replace(led, span=kept))
            led = Segment((start, led.span[1]), addressee=led.addressee)
        yield Waiting(self.position, self.source, led, main)

    def cut_before(self, start: int) -> Iterator["Waiting"]:
        """Give what stands before an order that nothing joins, and that order.

        One that the source tells ``apart`` is an entry by itself.
        """
        first, end = self.segment.span
        before = replace(self.segment, span=(first, self.end_before(start)))
        behind = Segment((start, end), addressee=self.segment.addressee, entry=start in self.source.apart)
        if start in self.source.meanwhile:
            joint = before.span[1], before.span[1] + 1
            behind = replace(behind, connective="meanwhile", connective_span=joint)
        for segment in (before, behind):
            yield Waiting.of(self.position, self.source, segment)

    @property
    def phrases(self) -> list[Phrase]:
        """Its times."""
        first, end = self.segment.span
        return [phrase for phrase in self.source.phrases if first <= phrase.span[0] < end]

    @property
    def behind_time(self) -> int:
        """Where the main words begin behind a time in front of them, from ``main``."""
        words = self.source.scanned.words
        # "Not today but tomorrow at two polish the silver"
        back = [*(remark.span for remark in self.source.remarks), *self.source.openings]
        places = self.source.places(self.main, self.segment.span[1])
        places = [p for p in places if not any(a <= words[p].start < b for a, b in back)]
        firsts = {phrase.first for phrase in self.source.phrases}
        ends = {phrase.end for phrase in self.source.phrases}
        while places:
            leading = next((p for p in self.source.phrases if p.first == places[0]), None)
            # "On the 6th and 8th feed the hens"
            joint = words[places[0]].text if places[0] in ends else ""
            # "No rush but descale the kettle"
            joins = joint == "but" or (joint in {"and", "&", "or"} and places[0] + 1 in firsts)
            if leading is None and not joins and words[places[0]].text not in {",", ":", "-"}:
                return words[places[0]].start - self.main
            end = leading.end if leading is not None else places[0] + 1
            places = [place for place in places if place >= end]
        return 0

    @property
    def heard_from(self) -> int:
        """The same, where several words behind it are parsed alone: "7.30 fire walk"."""
        scanned, start = self.source.scanned, self.main + self.behind_time
        places = self.source.places(self.main, self.segment.span[1])
        leading = next((phrase for phrase in self.source.phrases if phrase.first in places[:1]), None)
        if leading is None or isinstance(leading.said.time, Duration) or self.segment.borrowed:
            return 0
        behind = [scanned.words[place] for place in places if scanned.words[place].start >= start]
        joint = scanned.lexicon.function_words - scanned.lexicon.closed.noun_openers
        return self.behind_time if behind[1:] and behind[0].text not in joint else 0

    def timed(self, tree: Tree) -> frozenset[int]:
        """Give the words of its tree that are about time, or the level at which a further order is due."""
        levels = levels_behind_joints(self.source.scanned.words, self.lexicon)
        spans = (*(phrase.span for phrase in self.source.phrases), *levels)
        return frozenset(place for a, b in spans for place in tree.at(a - self.main, b - self.main))


def _main(source: Source, segment: Segment) -> int:
    """Give where the words behind a clause in front begin; the segment's start where there is none.

    The clause ends at a comma, or a colon: "after the meeting: go home, call Ann".
    """
    words, lexicon = source.scanned.words, source.scanned.lexicon
    places = source.places(*segment.span)
    marker = marker_at(words, source.phrases, places[0], segment.span[1], lexicon) if places else None
    level = level_end(words, places[0], lexicon) if places else None
    if level in places and words[level].text == "," and level + 1 in places:
        # "At 60 degrees, add the yeast"
        return words[level + 1].start
    inverted = bool(places) and words[places[0]].text in lexicon.closed.conditional_inversion
    if marker is None and not inverted:
        return segment.span[0]
    behind = places[0] + 1 if marker is None else marker.end
    apart = [p for p in places if p >= behind and p + 1 in places and words[p].text in {",", ":"}]
    commas = [p for p in apart if words[p].text == "," or not (p in source.covered or words[p + 1].glued)]
    comma = next(iter(commas), None)
    for following in commas[1:]:
        # "After the museum, but before it gets dark, find a place to eat"
        leads = None if comma is None else second_marker(words, source.phrases, comma + 1, following, lexicon)
        stated = comma is not None and (inverted or (marker is not None and marker.kind in STATED))
        goes_on = stated and comma is not None and goes_on_behind(words, comma, following, lexicon)
        dated = comma is not None and is_dated_behind(words, source.phrases, comma, following, lexicon)
        if leads is None and not goes_on and not dated:
            break
        comma = following
    return words[comma + 1].start if comma is not None and comma + 1 in places else segment.span[0]
