"""The first pass over texts: times by the grammar, instructions apart, a tree for each; all trees in a few batches."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from datetime import datetime

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.spans import Chart, phrases_of
from fuzzytime.language.instruction import Remark
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.sentence.corrections import corrected
from fuzzytime.language.sentence.operations import is_doubtful
from fuzzytime.language.sentence.segments import Segment, further_verbs, segments_of
from fuzzytime.language.sentence.tree import Tree

CARRIERS = ("please ", "you should ")
"""Words that make a parser see the verb behind them."""

ROUNDS = 12
"""How often a segment may be cut again: instructions joined by "and" in one sentence."""

Trees = Callable[[Sequence[str]], list[Tree]]


@dataclass(frozen=True, slots=True)
class Part:
    """One instruction's stretch, its tree with places in the whole text, and whether it was parsed at all."""

    segment: Segment
    tree: Tree


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
    parts = _parted(charts, [phrases for phrases, _ in corrections], segments, trees)
    return [
        Draft(text, now, chart, tuple(phrases), tuple(own), tuple(remarks))
        for (text, now), chart, (phrases, remarks), own in zip(texts, charts, corrections, parts, strict=True)
    ]


def _parted(
    charts: Sequence[Chart],
    phrases: Sequence[Sequence[Phrase]],
    segments: Sequence[Sequence[Segment]],
    trees: Trees,
) -> list[list[Part]]:
    """Parse every segment, and cut it again where its tree shows a further instruction."""
    done: list[dict[int, Part]] = [{} for _ in charts]
    open_segments = [(i, segment) for i, own in enumerate(segments) for segment in own]
    for _ in range(ROUNDS):
        if not open_segments:
            break
        wanted = [_words_of(charts[i], phrases[i], segment) for i, segment in open_segments]
        found = _trees(wanted, trees)
        following: list[tuple[int, Segment]] = []
        for (i, segment), tree in zip(open_segments, found, strict=True):
            cut = _cut(charts[i], phrases[i], segment, tree)
            if cut is None:
                done[i][segment.span[0]] = Part(segment, tree)
            else:
                following += [(i, part) for part in cut]
        open_segments = following
    for i, segment in open_segments:
        done[i][segment.span[0]] = Part(segment, Tree(charts[i].text[slice(*segment.span)], ()))
    return [[own[start] for start in sorted(own)] for own in done]


def _words_of(chart: Chart, phrases: Sequence[Phrase], segment: Segment) -> str:
    """Give a segment's text, or nothing where it is all time: such a fragment needs no tree."""
    first, end = segment.span
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


def _cut(chart: Chart, phrases: Sequence[Phrase], segment: Segment, tree: Tree) -> list[Segment] | None:
    """Cut a segment before its first further verb; None where there is none."""
    root = tree.root
    if root is None:
        return None
    offset = segment.span[0]
    for place in sorted(further_verbs(tree, root)):
        start = tree.nodes[place].start + offset
        if any(first < start < end for first, end in (phrase.span for phrase in phrases)):
            continue
        end = start
        while end > offset and (chart.text[end - 1].isspace() or chart.text[end - 1] in ",;&"):
            end -= 1
        end -= 4 if chart.text[max(0, end - 4) : end].lower() in {" and"} else 0
        while end > offset and (chart.text[end - 1].isspace() or chart.text[end - 1] in ",;&"):
            end -= 1
        if end > offset:
            return [replace(segment, span=(offset, end)), Segment((start, segment.span[1]))]
    return None
