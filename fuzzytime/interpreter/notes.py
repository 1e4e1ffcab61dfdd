"""What is said about wishes while they are gathered: what is not understood of them, or how it is taken."""

from collections.abc import Collection, Iterator

from fuzzytime.interpreter.interpretation import Interpreted, Problem, ProblemKind
from fuzzytime.interpreter.remarks import problem_of
from fuzzytime.interpreter.request import SpokenWish
from fuzzytime.interpreter.turns.inside import GoingOn
from fuzzytime.interpreter.turns.of_each import OfEach
from fuzzytime.language import Instruction, Reading, content_words
from fuzzytime.language.about_wishes import News, clauses_of
from fuzzytime.language.instruction import Span, overlap
from fuzzytime.requirement import Unit
from fuzzytime.times import instant_after


def beside_news(wish: SpokenWish, reading: Reading, told: Collection[Span]) -> Iterator[Problem]:
    """Point at what stands beside news in one sentence, and is in no instruction of its own."""
    own = [one for one in reading.instructions if not any(overlap(one.span, span) for span in told)]
    for span in clauses_of(wish.text):
        words = wish.text[span[0] : span[1]]
        taken = any(overlap(span, other) for other in (*told, *(one.span for one in own)))
        if not taken and len(content_words(words)) > 1:
            message = f"{words!r} is not understood beside news: say it in a sentence of its own"
            yield problem_of(wish, ProblemKind.NOT_UNDERSTOOD, message, span)


def by_how_much(wish: SpokenWish, news: News, made: Interpreted) -> Problem:
    """Say that nobody knows when something happens that is late."""
    message = f"{made.skill.name}: by how much that is later, or when it is, is not said: its time is kept"
    return problem_of(wish, ProblemKind.NOT_UNDERSTOOD, message, news.span, made.identifier)


def ending_with(wish: SpokenWish, instruction: Instruction, inside: GoingOn) -> Problem:
    """Say that a repetition without an end is over with what goes on."""
    said = next(part for part in instruction.requirements if part.recurrence is not None)
    closing = said.recurrence is not None and said.recurrence.closing is not None
    what = "is the end of this" if closing else "is as long as this goes on"
    message = f"{said.text!r} {what}: {inside.name}"
    return problem_of(wish, ProblemKind.NOTE, message, said.span, wish.identifier)


def in_its_hours(wish: SpokenWish, instruction: Instruction, made: Interpreted) -> Iterator[Problem]:
    """Say in which hours of its day something is put, for which no time of day is said: "dinner friday"."""
    grains = {part.span: part.grain for part in instruction.requirements}
    for part in made.requirements:
        day = grains.get(part.span, Unit.DAY) is Unit.DAY and part.grain is Unit.HOUR
        if day and part.earliest is not None and part.latest is not None:
            first, last = (instant_after(wish.given, end) for end in (part.earliest, part.latest))
            hours = f"{first:%H:%M} to {last:%H:%M}"
            message = f"{made.skill.name}: {hours} is taken, as no time of day is said"
            yield problem_of(wish, ProblemKind.NOTE, message, part.span, made.identifier)


def too_few(beside: OfEach) -> str:
    """Say that what is done beside each of several has too few of them to be done at all."""
    return f"{beside.said.text!r}: too few of these are planned"
