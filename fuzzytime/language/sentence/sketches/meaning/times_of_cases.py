"""Times of a case, where what is to be done has another: "if it rains on saturday, mow on sunday"."""

from dataclasses import replace

from fuzzytime.language.meaning.expressions import Duration, Phrase
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.sketches.sketch import Sketch

CASE = "if"
"""The kind of clauses that say in which case something is done; "unless" denies one."""


def without_times_of_cases(sketch: Sketch, text: str) -> Sketch:
    """Give a sketch whose cases have their times to themselves, as far as others say when it is to be done.

    "If it rains on saturday, mow on sunday", "if it's still wet at noon, mow tomorrow"; but "if it's dry on
    saturday, mow at ten" is on that day, and "if it's raining at three, take the bus" at that hour.
    """
    for place, clause in enumerate(sketch.clauses):
        inner = next((phrase for phrase in sketch.phrases if _is_of_case(phrase, clause, text)), None)
        if inner is None or not any(_is_another(one, inner, clause) for one in sketch.phrases):
            continue
        clauses = list(sketch.clauses)
        clauses[place] = replace(clause, span=(clause.span[0], inner.span[1]))
        others = [one for one in sketch.phrases if one is not inner]
        sketch = replace(sketch.keeping(others.__contains__), clauses=tuple(clauses))
    return sketch


def _is_of_case(phrase: Phrase, clause: Clause, text: str) -> bool:
    """Whether a time stands right behind a case."""
    case = clause.kind == CASE and clause.condition is not None
    return (
        case
        and not text[clause.span[1] : max(clause.span[1], phrase.span[0])].strip()
        and (phrase.span[0] >= clause.span[1])
    )


def _is_another(phrase: Phrase, inner: Phrase, clause: Clause) -> bool:
    """Whether a time says of what is to be done when that is, and the time of its case cannot be meant."""
    if phrase is inner or isinstance(phrase.said.time, Duration):
        return False
    day, other = inner.said.wall.days is not None, phrase.said.wall.days is not None
    # "Mow tomorrow if it's dry at noon" may be at noon.
    return (day and other) or (not day and clause.span[0] < phrase.span[0])
