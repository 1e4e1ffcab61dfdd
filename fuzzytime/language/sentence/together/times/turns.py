"""What is counted and done one by one: "two tablets, six hours apart", "three sets, two minutes each"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.english import singular
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Duration, Phrase, Repeat
from fuzzytime.language.meaning.joined.first_times import ending_with
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.together.times.said_again import ONE_OF, SEVERAL
from fuzzytime.requirement import Constraint

MOST = 100
"""Times at most that something counted is done."""


def counted_apart(sketch: Sketch, words: Sequence[Word]) -> Sketch:
    """Do what is counted one by one, where it is said to be so long apart, or that each turn is so long."""
    phrases = list(sketch.phrases)
    each = next((p for p in phrases if _is_each(p, words)), None)
    length = each.said.time if each is not None else None
    for at, phrase in enumerate(phrases):
        time = phrase.said.time
        if isinstance(time, Repeat) and time.apart:
            counted = _counted(sketch)
            if counted is not None:
                sketch, times = counted
                again = replace(time, times=times, apart=False)
                if again.starting is None and again.until is not None:
                    again = ending_with(again, again.until)
                phrases[at] = phrase.at(again)
            return replace(sketch, phrases=tuple(phrases))
    counted = _counted(sketch, turns=True) if isinstance(length, Duration) else None
    if counted is None or each is None or not isinstance(length, Duration):
        return sketch
    sketch, times = counted
    phrases[phrases.index(each)] = replace(
        each,
        said=replace(
            each.said,
            time=Repeat(length, times=times),
            constraint=Constraint.EVERY,
            preposition=None,
            hedges=(),
            lasting=length,
        ),
    )
    return replace(sketch, phrases=tuple(phrases))


def _is_each(phrase: Phrase, words: Sequence[Word]) -> bool:
    """Whether a length is that of each of several: "two minutes each"."""
    lasts = isinstance(phrase.said.time, Duration) and phrase.said.constraint in {None, Constraint.FOR}
    return lasts and any(word.text == "each" for word in words[phrase.first : phrase.end])


def _counted(sketch: Sketch, *, turns: bool = False) -> tuple[Sketch, int] | None:
    """Give a sketch of one of several, and how many they are; where only ``turns`` count, of those."""
    operation = sketch.operation
    if operation is None or operation.object is None or operation.stated:
        return None
    named = operation.object.split()
    numbers = [_number(word, sketch.lexicon) for word in named]
    place = next((place for place, number in enumerate(numbers[:-1]) if number), None)
    times = None if place is None else numbers[place]
    if place is None or times is None:
        return None
    if turns and singular(named[place + 1].lower()) not in sketch.lexicon.spacing["turns"]:
        # "Grill two steaks for three minutes each": both at once.
        return None
    one = " ".join((*named[:place], ONE_OF.strip(), *named[place:]))
    return replace(sketch, operation=replace(operation, object=one)), times


def _number(word: str, lexicon: Lexicon) -> int | None:
    """Give the number that a word is, of more than one."""
    number = int(word) if word.isdecimal() else lexicon.numbers.get(word.lower())
    return number if number is not None and SEVERAL <= number <= MOST else None
