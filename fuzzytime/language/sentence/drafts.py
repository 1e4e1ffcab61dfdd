"""The first pass over texts: times by the grammar, instructions apart, a tree for each; all trees in a few batches."""

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from datetime import datetime

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.spans import Chart, phrases_of
from fuzzytime.language.instruction import Remark, Span
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.sentence.corrections import corrected
from fuzzytime.language.sentence.operations import is_doubtful
from fuzzytime.language.sentence.segments import Segment, further_verbs, segments_of
from fuzzytime.language.sentence.tree import Tree

CARRIERS = ("please ", "you should ")
"""Words that make a parser see the verb behind them."""

JOINT = re.compile(r"[\s,;&]*(\band\b)?[\s,;&]*$", re.IGNORECASE)
"""What stands between two instructions."""

ROUNDS = 12
"""How often a segment may be cut again: instructions joined by "and" in one sentence."""

Trees = Callable[[Sequence[str]], list[Tree]]


@dataclass(frozen=True, slots=True)
class Part:
    """One instruction: its stretch, and the tree of its words from ``offset`` on.

    A clause in front ("before you serve the soup, …") has a tree of its own: in one tree with the rest, it is often
    taken for the main clause.
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
    chart: Chart
    phrases: tuple[Phrase, ...]
    parts: tuple[Part, ...]
    remarks: tuple[Remark, ...]


def drafted(
    texts: Sequence[tuple[str, datetime | None]], grammar: Grammar, lexicon: Lexicon, trees: Trees
) -> list[Draft]:
    """Draft texts."""
    charts = [Chart.of(text, grammar, lexicon) for text, _ in texts]
    corrections = [corrected(chart, phrases_of(chart, lexicon), lexicon) for chart in charts]
    segments = [
        segments_of(chart.text, chart.words, phrases, lexicon)
        for chart, (phrases, _) in zip(charts, corrections, strict=True)
    ]
    sound = [
        replace(chart, text=_without(chart.text, [remark.span for remark in remarks]))
        for chart, (_, remarks) in zip(charts, corrections, strict=True)
    ]
    parts = _parted(sound, [phrases for phrases, _ in corrections], segments, lexicon, trees)
    return [
        Draft(text, now, chart, tuple(phrases), tuple(own), tuple(remarks))
        for (text, now), chart, (phrases, remarks), own in zip(texts, charts, corrections, parts, strict=True)
    ]


def _without(text: str, spans: Sequence[Span]) -> str:
    """Give a text with spaces where words were taken back: "at five, I mean six"."""
    for first, end in spans:
        text = text[:first] + " " * (end - first) + text[end:]
    return text


def _parted(
    charts: Sequence[Chart],
    phrases: Sequence[Sequence[Phrase]],
    segments: Sequence[Sequence[Segment]],
    lexicon: Lexicon,
    trees: Trees,
) -> list[list[Part]]:
    """Parse every segment, and cut it again where its tree shows a further instruction."""
    done: list[dict[int, Part]] = [{} for _ in charts]
    open_segments = [(i, segment) for i, own in enumerate(segments) for segment in own]
    for _ in range(ROUNDS):
        if not open_segments:
            break
        fronts = [front_of(charts[i], phrases[i], segment, lexicon) for i, segment in open_segments]
        mains = [front or segment.span[0] for front, (_, segment) in zip(fronts, open_segments, strict=True)]
        wanted = [
            _words_of(charts[i], phrases[i], (main, segment.span[1]))
            for main, (i, segment) in zip(mains, open_segments, strict=True)
        ]
        clauses = [
            charts[i].text[segment.span[0] : front] if front else ""
            for front, (i, segment) in zip(fronts, open_segments, strict=True)
        ]
        found, before = _trees(wanted, trees), trees(clauses)
        following: list[tuple[int, Segment]] = []
        for (i, segment), tree, main, front in zip(open_segments, found, mains, before, strict=True):
            part = Part(segment, tree, main, front if front.nodes else None)
            cut = _cut(charts[i], phrases[i], part)
            if cut is None:
                done[i][segment.span[0]] = part
            else:
                following += [(i, piece) for piece in cut]
        open_segments = following
    for i, segment in open_segments:
        done[i][segment.span[0]] = Part(
            segment, Tree(charts[i].text[slice(*segment.span)], ()), segment.span[0]
        )
    return [[own[start] for start in sorted(own)] for own in done]


def front_of(chart: Chart, phrases: Sequence[Phrase], segment: Segment, lexicon: Lexicon) -> int:
    """Give where the words behind a clause in front begin, 0 where there is none.

    A clause in front begins with a marker, or with a length of time and a marker, and ends at a comma.
    """
    places = [p for p, word in enumerate(chart.words) if segment.span[0] <= word.start < segment.span[1]]
    if not places:
        return 0
    first = next((p.end for p in phrases if p.first == places[0]), places[0])
    if first not in places or longest_match(chart.words, first, lexicon.clauses) is None:
        return 0
    if any(p.first <= first < p.end for p in phrases):
        return 0
    comma = next((p for p in places if p > first and chart.words[p].text == ","), None)
    return chart.words[comma + 1].start if comma is not None and comma + 1 in places else 0


def _words_of(chart: Chart, phrases: Sequence[Phrase], span: Span) -> str:
    """Give a stretch of text, or nothing where it is all time: such a fragment needs no tree."""
    first, end = span
    covered = {place for phrase in phrases for place in range(phrase.first, phrase.end)}
    rest = [
        word
        for place, word in enumerate(chart.words)
        if first <= word.start < end and place not in covered and (word.is_letters or word.is_digits)
    ]
    return chart.text[first:end] if any(word.text != "please" for word in rest) else ""


def _trees(texts: Sequence[str], trees: Trees) -> list[Tree]:
    """Parse texts; one whose tree is doubtful once more behind words that call for a verb."""
    found = trees(texts)
    for carrier in CARRIERS:
        again = [place for place, tree in enumerate(found) if tree.nodes and is_doubtful(tree)]
        for place, tree in zip(
            again, trees([_carried(carrier, texts[place]) for place in again]), strict=True
        ):
            bare = tree.without_first(carrier, texts[place])
            if bare.nodes and not is_doubtful(bare):
                found[place] = bare
    return found


def _carried(carrier: str, text: str) -> str:
    """Put words before a text: its first letter is no capital there."""
    return carrier + text[0].lower() + text[1:] if len(text[0].lower()) == 1 else carrier + text


def _cut(chart: Chart, phrases: Sequence[Phrase], part: Part) -> list[Segment] | None:
    """Cut a segment before its first further verb; None where there is none."""
    root = part.tree.root
    if root is None:
        return None
    first, last = part.segment.span
    for place in sorted(further_verbs(part.tree, root)):
        start = part.tree.nodes[place].start + part.offset
        if any(a < start < b for a, b in (phrase.span for phrase in phrases)):
            continue
        end = first + len(JOINT.sub("", chart.text[first:start]))
        if end > part.offset:
            return [replace(part.segment, span=(first, end)), Segment((start, last))]
    return None
