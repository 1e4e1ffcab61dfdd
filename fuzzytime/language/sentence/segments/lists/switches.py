"""What is switched on and off at two times, said without a mark: "lights on 6pm off 8pm"."""

import re
from functools import cache

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.sentence.segments.lists.dividers import LINE, STOP


@cache
def _switched(states: frozenset[str], binding: frozenset[str], halves: frozenset[str]) -> re.Pattern[str]:
    """Give what finds the pause between two states of a thing, each with its time."""
    state, bound, half = (
        "|".join(map(re.escape, sorted(words, key=len, reverse=True))) for words in (states, binding, halves)
    )
    when = rf"(?:(?:{bound})\s+|@\s?)?\d{{1,2}}(?:[:.]\d\d)?(?:\s?(?:{half}))?"
    return re.compile(
        rf"(?<=\w\s)({state})\s+{when}(\s)(?!\1)(?:{state})\s+{when}(?=\s*(?:[,.]|$))", re.IGNORECASE
    )


def switched_apart(text: str, lexicon: Lexicon) -> str:
    """Give a text of the same length with a mark between such times."""
    beside = lexicon.beside
    pattern = _switched(beside.switched, lexicon.closed.prepositions_of_points, beside.of_hours)
    for line in LINE.finditer(text):
        found = pattern.search(text, *line.span())
        if found is not None:
            text = text[: found.start(2)] + STOP + text[found.end(2) :]
    return text
