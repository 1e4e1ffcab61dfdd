"""What is done with one thing after the other, so long each: "place 20 parts, 90 s each" lasts half an hour.

"Grill two steaks for three minutes each" goes on with both at once: "for" says how long it does with each.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Remark, RemarkKind
from fuzzytime.language.meaning.expressions import Duration, Phrase, Repeat
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import Constraint

EACH, FOR = "each", "for"
SEVERAL, MOST = 2, 1000

NUMBERED = re.compile(r"(\d+) ?(?:-|–|to) ?(\d+)\b")
"""The first and the last of what has numbers: "rooms 201-206", "pages 2 to 5"."""


def one_by_one(sketch: Sketch, words: Sequence[Word], lexicon: Lexicon) -> Sketch:
    """Let what is done with each of several last for all of them, and say so."""
    operation = sketch.operation
    if operation is None or not operation.is_asked:
        return sketch
    if any(isinstance(phrase.said.time, Repeat) for phrase in sketch.phrases):
        # "Three sets, two minutes each, with a minute between sets" are turns.
        return sketch
    for place, phrase in enumerate(sketch.phrases):
        length = phrase.said.time
        said_for = FOR in {word.text for word in words[phrase.first : phrase.end]}
        bare = phrase.said.constraint in {None, Constraint.FOR} and not said_for
        named = f"{operation.object or ''} , {operation.place or ''}"
        times = next(_counts(named, lexicon), None)
        if not isinstance(length, Duration) or not bare or times is None or not _is_each(phrase, words):
            continue
        whole = replace(length, terms=tuple((amount * times, unit) for amount, unit in length.terms))
        phrases = list(sketch.phrases)
        phrases[place] = replace(phrase, said=replace(phrase.said, time=whole))
        what = f"{_text(phrase, words)!r} is taken for {times} of them, one after the other"
        remark = Remark(RemarkKind.POLICY, phrase.span, what)
        return replace(sketch, phrases=tuple(phrases), remarks=(*sketch.remarks, remark))
    return sketch


def _is_each(phrase: Phrase, words: Sequence[Word]) -> bool:
    return any(word.text == EACH for word in words[phrase.first : phrase.end])


def _counts(named: str, lexicon: Lexicon) -> Iterator[int]:
    """Give how many things words name: from one number to another, or a number in front of them."""
    for first, last in NUMBERED.findall(named):
        if 0 < int(last) - int(first) < MOST:
            yield int(last) - int(first) + 1
    said = named.lower().split()
    if not lexicon.closed.both.isdisjoint(said):
        yield SEVERAL
    for word, behind in pairwise(said):
        number = int(word) if word.isdecimal() else lexicon.numbers.get(word, 0)
        if SEVERAL <= number <= MOST and behind.isalpha() and behind.endswith("s"):
            yield number


def _text(phrase: Phrase, words: Sequence[Word]) -> str:
    return " ".join(word.text for word in words[phrase.first : phrase.end])
