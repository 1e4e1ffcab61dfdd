"""Words of time that rule tables bring."""

from datetime import datetime

import pytest

from fuzzytime.interpreter import Interpreter
from fuzzytime.language import Language, find_times, with_words
from fuzzytime.requirement import Constraint

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - the wall's own time


@pytest.mark.parametrize(
    ("text", "word", "name"),
    [
        ("Feed the ducks in a blink", "in a blink", "feed the ducks"),
        ("In a blink, feed the ducks", "in a blink", "feed the ducks"),
        ("Skim the pool anon and call mum", "anon", "skim the pool"),
    ],
)
def test_a_word_of_ones_own_is_a_time(text: str, word: str, name: str) -> None:
    language = with_words(Language.shipped(), ["anon", "in a blink"])
    instruction = language.read(text, now=NOW).instructions[0]
    assert instruction.operation is not None
    assert instruction.operation.name == name
    (requirement,) = instruction.requirements
    assert (requirement.word, requirement.constraint) == (word, Constraint.VAGUE)


def test_words_that_are_known_stay_as_they_are() -> None:
    language = Language.shipped()
    assert with_words(language, ["soon", "asap", "whenever you can"]) is language


def test_every_word_of_the_shipped_tables_is_one_that_the_language_understands() -> None:
    interpreter = Interpreter.shipped()
    lengths = {"until further notice"}  # says for how long, not when
    for word in interpreter.rulebook.tables.words.keys() - lengths:
        (requirement,) = find_times(word, NOW, interpreter.language.lexicon).requirements
        assert requirement.word is not None, word


def test_hedges_and_prepositions_of_ones_own_are_understood() -> None:
    table = (
        "fuzzytime: 1\n"
        "prepositions: {nigh: {model: in}, anent: {model: before}}\n"
        "hedges: {time: {kinda: {widen: 2}}}\n"
    )
    shipped = Interpreter.shipped()
    own = Interpreter.joining(shipped.language, shipped.rulebook.with_rules(table, "own.yaml"))
    nigh, anent, behind = (
        own.language.read(f"Call mum {time}", now=NOW).instructions[0].requirements[0]
        for time in ("nigh kinda six pm", "anent noon", "at noon kinda")
    )
    assert (nigh.preposition, nigh.fuzziness, nigh.constraint) == ("nigh", ("kinda",), Constraint.AT)
    assert (anent.preposition, anent.constraint) == ("anent", Constraint.BEFORE)
    assert behind.fuzziness == ("kinda",)
    wide = own.rulebook.resolve(nigh)
    assert wide.satisfaction.support.length > shipped.rulebook.resolve(nigh).satisfaction.support.length


def test_a_preposition_of_ones_own_counts_lengths_of_time_from_now() -> None:
    prepositions = {"nigh": Constraint.AT, "anent": Constraint.BEFORE}
    language = with_words(Language.shipped(), [], prepositions=prepositions)
    readings = [language.read(f"Call mum {name} ten minutes", now=NOW) for name in prepositions]
    (nigh,), (anent,) = (reading.instructions[0].requirements for reading in readings)
    assert (nigh.preposition, nigh.constraint, nigh.t_spec) == ("nigh", Constraint.AT, 600)
    assert (anent.preposition, anent.constraint, anent.latest) == ("anent", Constraint.BEFORE, 600)


def test_tables_without_words_of_their_own_leave_the_language_as_it_is() -> None:
    shipped = Interpreter.shipped()
    assert Interpreter.joining(shipped.language, shipped.rulebook).language is shipped.language


@pytest.mark.model
def test_what_begins_a_clause_may_be_ones_own() -> None:
    language = with_words(Language.shipped(), [], clauses={"by such time as": "when", "when": "until"})
    boil, serve = language.read_all(
        [("boil the rice", NOW), ("serve it by such time as the rice is done", NOW)]
    )
    assert boil.remarks == ()
    (requirement,) = serve.instructions[0].requirements
    assert requirement.preposition == "by such time as"
    assert requirement.anchor is not None
    assert requirement.anchor.target == 0
