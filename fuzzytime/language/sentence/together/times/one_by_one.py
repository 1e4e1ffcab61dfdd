"""What is done with one thing after the other, so long each: "place 20 parts, 90 s each" lasts half an hour.

Done from when to when, it lasts so long, whatever is said of each: "consults 2-4, 15 mins each".
"Grill two steaks for three minutes each" goes on with both at once: "for" says how long it does with each.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Remark, RemarkKind
from fuzzytime.language.meaning.expressions import Duration, Phrase
from fuzzytime.language.meaning.phrases import is_window
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import Constraint

SEVERAL, MOST = 2, 1000

NUMBERED = re.compile(r"(\d+) ?(?:-|–|to) ?(\d+)\b")
"""The first and the last of what has numbers: "rooms 201-206", "pages 2 to 5"."""


OF_NUMBER = re.compile(r"\bof (\w+)(?= ,|$)")
OF_THEM = re.compile(r"\b(\w+) of (?:them|these|those)\b")
"""How many of a kind there are: "a batch of 12", "hooks, ten of them"."""


def one_by_one(sketch: Sketch, words: Sequence[Word]) -> Sketch:
    """Let what is done with each of several last for all of them, and say so."""
    operation = sketch.operation
    if operation is None or operation.negated:
        return sketch
    if sketch.repeats:
        # "Three sets, two minutes each, with a minute between sets" are turns.
        return sketch
    for place, phrase in enumerate(sketch.phrases):
        length = phrase.said.time
        said_for = "for" in {word.text for word in words[phrase.first : phrase.end]}
        bare = phrase.said.constraint in {None, Constraint.FOR} and not said_for
        first, end = sketch.part.segment.span
        said = " ".join(word.text for word in words if first <= word.start < end)
        named = f"{operation.object or ''} , {operation.place or ''}"
        times = next(_counts(named, said, sketch.lexicon), None)
        if not isinstance(length, Duration) or not bare or not _is_each(phrase, words):
            continue
        if any(is_window(other) for other in sketch.phrases):
            what = f"{_text(phrase, words)!r} is how long each of them takes, not all"
            remark = Remark(RemarkKind.POLICY, phrase.span, what)
            phrases = [other for other in sketch.phrases if other is not phrase]
            return replace(sketch, phrases=tuple(phrases), remarks=(*sketch.remarks, remark))
        if times is None or operation.stated:
            continue
        whole = replace(length, terms=tuple((amount * times, unit) for amount, unit in length.terms))
        phrases = list(sketch.phrases)
        phrases[place] = phrase.at(whole)
        what = f"{_text(phrase, words)!r} is taken for {times} of them, one after the other"
        remark = Remark(RemarkKind.POLICY, phrase.span, what)
        return replace(sketch, phrases=tuple(phrases), remarks=(*sketch.remarks, remark))
    return sketch


def _is_each(phrase: Phrase, words: Sequence[Word]) -> bool:
    return any(word.text == "each" for word in words[phrase.first : phrase.end])


def _counts(named: str, said: str, lexicon: Lexicon) -> Iterator[int]:
    """Give how many things words name: from one number to another, or a number in front of them.

    It may also be ``said`` behind them: "ten of them".
    """
    for first, last in NUMBERED.findall(named):
        if 0 < int(last) - int(first) < MOST:
            yield int(last) - int(first) + 1
    words = named.lower().split()
    if not lexicon.closed.both.isdisjoint(words):
        yield SEVERAL
    numbers = [word for word, behind in pairwise(words) if behind.isalpha() and behind.endswith("s")]
    numbers += [*OF_NUMBER.findall(named.lower()), *OF_THEM.findall(said)]
    for word in numbers:
        number = int(word) if word.isdecimal() else lexicon.numbers.get(word, 0)
        if SEVERAL <= number <= MOST:
            yield number


def _text(phrase: Phrase, words: Sequence[Word]) -> str:
    return " ".join(word.text for word in words[phrase.first : phrase.end])
