"""Words of time that rule tables bring."""

from datetime import datetime

import pytest

from fuzzytime.interpreter import Interpreter
from fuzzytime.language import Language, find_times, with_words
from fuzzytime.requirement import Constraint
from fuzzytime.satisfaction import Interval

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


@pytest.mark.parametrize(
    "words", ["tonight", "before bed", "first thing", "next week", "pronto", "every so often"]
)
def test_a_word_of_ones_own_wins_over_what_the_language_makes_of_it(words: str) -> None:
    table = f"fuzzytime: 1\nwords: {{{words}: {{breakpoints: [3 h, 3 h, 4 h, 4 h]}}}}\n"
    shipped = Interpreter.shipped()
    own = Interpreter.joining(shipped.language, shipped.rulebook.with_rules(table, "own.yaml"))
    (requirement,) = own.language.read(f"Feed the ducks {words}", now=NOW).instructions[0].requirements
    assert requirement.word == words
    assert own.rulebook.resolve(requirement).satisfaction.support == Interval(3 * 3600, 4 * 3600)
    (longer,) = own.language.read("Feed the ducks tonight at eight", now=NOW).instructions[0].requirements
    assert longer.word is None


@pytest.mark.parametrize("hedge", ["pretty much", "dead on", "say", "just gone", "definitely"])
def test_a_hedge_of_ones_own_wins_over_the_one_that_it_stands_for(hedge: str) -> None:
    table = f"fuzzytime: 1\nhedges: {{time: {{{hedge}: {{widen: 7}}}}}}\n"
    shipped = Interpreter.shipped()
    own = Interpreter.joining(shipped.language, shipped.rulebook.with_rules(table, "own.yaml"))
    (requirement,) = own.language.read(f"Call mum at {hedge} noon", now=NOW).instructions[0].requirements
    assert requirement.fuzziness == (hedge,)


@pytest.mark.parametrize("name", ["pre", "prior to", "circa", "gone"])
def test_a_preposition_of_ones_own_wins_over_the_one_that_it_stands_for(name: str) -> None:
    language = with_words(Language.shipped(), [], prepositions={name: Constraint.AT})
    (requirement,) = language.read(f"Call mum {name} noon", now=NOW).instructions[0].requirements
    assert (requirement.preposition, requirement.constraint) == (name, Constraint.AT)


def test_every_word_of_the_shipped_tables_is_one_that_the_language_understands() -> None:
    interpreter = Interpreter.shipped()
    lengths = {"until further notice", "for a while"}  # say for how long, not when
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
