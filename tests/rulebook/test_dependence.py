"""Which signals may change what a requirement means: its own, and those of the rules about it."""

from fuzzytime.requirement import Anchor, Constraint, Unit
from fuzzytime.rulebook import Rulebook
from rulebook.requirements_of import ahead, said, when, word

RULEBOOK = Rulebook.shipped()


def test_a_clause_depends_on_its_subject() -> None:
    pan = when("when the pan is hot", "pan", "hot")
    assert RULEBOOK.signals_for(pan) >= {"pan_temp"}


def test_a_word_depends_on_what_rules_about_it_look_at() -> None:
    assert {"time_to_meal", "pan_temp"} <= RULEBOOK.signals_for(word("soon"))


def test_a_time_depends_on_no_condition_of_others() -> None:
    assert "pan_temp" not in RULEBOOK.signals_for(ahead("in", 10, Unit.MINUTE))


def test_a_time_beside_an_event_depends_on_the_event() -> None:
    beside = said(
        Constraint.AFTER, "five minutes after the timer rings", anchor=Anchor(text="the timer rings")
    )
    assert "timer" in RULEBOOK.signals_for(beside)


def test_a_time_beside_another_instruction_does_not_depend_on_its_words() -> None:
    beside = said(Constraint.AFTER, "after heating the pan", anchor=Anchor(text="the pan is hot", target=0))
    assert "pan_temp" not in RULEBOOK.signals_for(beside)
