"""Where it is said what is done if something is not so: "if it rains take the bus, otherwise walk"."""

from collections.abc import Sequence

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.sentence.clauses.conditions import EXCEPTING
from fuzzytime.requirement import Constraint

OTHER_CASE = "otherwise"
"""The connective of what is done where the condition before it is not so."""

ENDS = frozenset(".!?;\n")
CONDITIONS = frozenset({"if", "when"})
"""Kinds of clauses that another case can follow."""


def begins_other_case(
    words: Sequence[Word], place: int, end: int, phrases: Sequence[Phrase], lexicon: Lexicon
) -> bool:
    """Whether words up to ``end`` turn to what is done where the condition in front of them is not so.

    "Today if you can, otherwise tomorrow" has none. Without a comma, "if not" leads right to an order: "if
    not ring the bell", but "if it isn't clean by six".
    """
    begun = [before for before in range(place) if _begins_condition(words, before, lexicon)]
    courteous, said = lexicon.beside.courteous | {","}, words[end - 1].text
    clause = [word.text for word in words[begun[-1] : place]] if begun else []
    if courteous.issuperset(clause) or (said == "," and clause[-1] not in ENDS and "," not in clause):
        # "Unless told otherwise, lock up"
        return False
    if place and words[place - 1].text in lexicon.doing.saying | {EXCEPTING}:
        # "Unless Ann says otherwise start at nine", "unless otherwise agreed"
        return False
    if said == "," or said in lexicon.beside.second_choice:
        return True
    last = words[end + 1 :][:1]
    if any(phrase.first == end and phrase.said.constraint in {None, Constraint.AT} for phrase in phrases):
        return True
    timed = (p for p in phrases if p.first == end + 1 and p.said.constraint is not Constraint.FOR)
    # "If not leave it in"
    acts = words[end].is_letters and words[end].text not in lexicon.function_words
    acts = acts and any(word.text in lexicon.closed.behind_verbs for word in last)
    return (
        (words[end].text in lexicon.orders or acts)
        and not any(timed)
        and all(word.text != "," for word in last)
    )


def _begins_condition(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a condition begins at a place: "if it rains", "should it rain"."""
    form = longest_match(words, place, lexicon.clauses)
    inverted = place == 0 and words[place].text in lexicon.closed.conditional_inversion
    return inverted or (form is not None and lexicon.clauses[form] in CONDITIONS)
