"""The words of a text's trees with their labels, and the paper's own reading of the first."""

from dataclasses import replace

from fuzzytime.language.instruction import StrictReading, Token
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.trees.labels import strict_reading


def tokens_of(draft: Draft) -> tuple[tuple[Token, ...], StrictReading]:
    """Give the words of all trees with places in the whole text, and the paper's reading of the first."""
    tokens: list[Token] = []
    strict: StrictReading | None = None
    for part in draft.parts:
        trees = [(part.front, part.segment.span[0])] if part.front is not None else []
        for tree, offset in (*trees, (part.tree, part.offset)):
            own, reading = strict_reading(tree)
            base = len(tokens)
            tokens += [
                replace(t, span=(t.span[0] + offset, t.span[1] + offset), head=t.head + base) for t in own
            ]
            if strict is None and own and tree is part.tree:
                strict = reading.moved(base)
    return tuple(tokens), strict or StrictReading()
