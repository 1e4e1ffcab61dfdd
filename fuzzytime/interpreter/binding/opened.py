"""Errands on the lines below where somewhere opens are not before that: "shop opens at 8", "buy bread"."""

from collections.abc import Iterator, Sequence

from fuzzytime.interpreter.binding.steps import Step, is_asked
from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.language import Lexicon
from fuzzytime.skills import Precedence


def of_opened(skills: Sequence[Interpreted], lexicon: Lexicon) -> Iterator[Precedence]:
    """Give the order of such an opening and the errands without a time right below it."""
    doing, opening = lexicon.doing, -1
    for place, one in enumerate(skills):
        operation, step = one.operation, Step(place, one)
        if operation is None or one.wish.line is None:
            opening = -1
        elif one.stated and operation.lemma in doing.opening_up and step.at_moment:
            opening = place
        elif not (is_asked(one) and operation.lemma in doing.over_the_counter) or step.timed:
            opening = -1
        elif opening >= 0:
            yield Precedence(opening, place)
