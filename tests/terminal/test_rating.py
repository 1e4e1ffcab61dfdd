"""Ratings of starts: they move the person's own plans, and can be shown, undone and exported."""

import json
from datetime import timedelta
from pathlib import Path

import pytest

from fuzzytime.rulebook import check
from fuzzytime_cli.exits import Exit
from terminal.running import ran
from terminal.talking import NINE, Talk, talk_of

STEAK = "Fry the steak in ten minutes"


def window(talk: Talk, identifier: str) -> tuple[float, float]:
    """The support of a planned skill's ψ, in seconds from now."""
    assert talk.turns.plan is not None
    for interpreted in talk.turns.plan.skills:
        if interpreted.identifier == identifier:
            return interpreted.skill.satisfaction.support.low, interpreted.skill.satisfaction.support.high
    raise KeyError(identifier)


def test_a_start_that_was_too_late_moves_the_next_plans_earlier() -> None:
    talk = talk_of(STEAK)
    before = sum(window(talk, "s1"))
    answer = talk.say(":rate 1 2 too late")
    assert "rated as planned, it has not started: s1 fry the steak at 09:10:00" in answer
    assert ": 2 of 5, too late" in answer
    assert sum(window(talk, "s1")) < before - 10
    talk.say("Wash the apples in ten minutes")
    assert window(talk, "s2") == pytest.approx(window(talk, "s1"))


def test_a_rating_is_undone_and_done_again() -> None:
    talk = talk_of(STEAK)
    before = window(talk, "s1")
    talk.say(":rate 1 too early")
    after = window(talk, "s1")
    assert after != before
    assert "undone: :rate 1 too early" in talk.say(":undo")
    assert window(talk, "s1") == before
    talk.say(":redo")
    assert window(talk, "s1") == after


def test_ratings_are_shown_with_what_they_amount_to() -> None:
    talk = Talk()
    assert "no ratings yet" in talk.say(":rate")
    talk.say(STEAK)
    talk.say("Set the table soon")
    talk.say(":rate 1 5")
    talk.say(":rate s2 4/5")
    lines = talk.say(":rate").split("\n")
    assert [line.partition(" at ")[0] for line in lines[:2]] == ["s1 fry the steak", "s2 set the table"]
    assert lines[2].startswith("your wishes are ")
    assert [line.partition(":")[0] for line in lines[3:]] == ["'in'", "'soon'"]


def test_a_start_that_has_passed_is_rated_as_it_was() -> None:
    talk = talk_of("Stir the soup now")
    talk.wait(seconds=1)
    talk.now = NINE + timedelta(minutes=30)
    assert "rated: s1 stir the soup at 09:00:00: 3 of 5" in talk.say(":rate 1 3")
    # Rated again, the same start counts once.
    talk.say(":rate 1 5")
    assert [line for line in talk.say(":rate").split("\n") if line.startswith("s1")] == [
        "s1 stir the soup at 09:00:00: 5 of 5"
    ]


def test_a_rating_says_the_same_when_its_times_have_passed() -> None:
    talk = talk_of(STEAK)
    kept = []
    for minutes in (0, 10, 60):
        talk.wait(minutes=minutes)
        talk.say(":rate 1 4")
        kept.append(talk.turns.conversation.ratings[-1])
    assert kept[0] == kept[1] == kept[2]
    assert json.loads(kept[0].rating)["start_s"] == 600


def test_ratings_refer_to_the_population_and_do_not_feed_on_themselves() -> None:
    talk = talk_of(STEAK)
    start = talk.start("s1")
    for _ in range(3):
        talk.say(":rate 1 too late")
        kept = talk.turns.conversation.ratings[-1]
        assert (
            json.loads(kept.rating)["parameters"]
            == json.loads(talk.turns.conversation.ratings[0].rating)["parameters"]
        )
    assert talk.start("s1") < start


@pytest.mark.parametrize(
    ("instruction", "words", "said"),
    [
        (STEAK, "1 6", "1 to 5"),
        (STEAK, "1", "1 to 5"),
        (STEAK, "1 lovely", "1 to 5"),
        (STEAK, "7 4", "one of the list (1)"),
        ("Fry the steak", "1 4", "by one time"),
        ("Fry the steak this evening", "1 4", "'this evening' of s1 has none"),
    ],
)
def test_what_is_no_rating_is_said_and_nothing_changes(instruction: str, words: str, said: str) -> None:
    talk = talk_of(instruction)
    assert said in talk.say(f":rate {words}")
    assert talk.turns.conversation.ratings == ()


def test_a_person_who_wants_the_populations_plans_gets_them(tmp_path: Path) -> None:
    lines = f"{STEAK}\n:rate 1 1 too late\n:rate 1 1 too late\n"
    moment = ("--now", "2026-03-04T09:00")
    assert ran("repl", *moment, folder=tmp_path, stdin=lines.encode()).code == Exit.FINE

    def corners(personal: str = "true") -> dict[str, float]:
        words = ("plan", "-i", STEAK, *moment, "--format", "json")
        done = ran(*words, folder=tmp_path, FUZZYTIME_PERSONAL=personal)
        found = json.loads(done.out)["skills"][0]["satisfaction_function"]["parameters"]
        assert isinstance(found, dict)
        return found

    assert corners()["full_end"] < corners("false")["full_end"] - 5


def test_ratings_are_exported_as_lines_and_as_a_rule_file(tmp_path: Path) -> None:
    assert ran("study", "ratings", folder=tmp_path).code == Exit.NO_INPUT
    lines = f"{STEAK}\n:rate 1 2 too late\nStir the soup soon\n:rate 2 5\n"
    ran("repl", "--now", "2026-03-04T09:00", folder=tmp_path, stdin=lines.encode())
    shown = ran("study", "ratings", folder=tmp_path).out.splitlines()
    assert len(shown) == 5
    rows = [json.loads(line) for line in ran("study", "ratings", "--json", folder=tmp_path).out.splitlines()]
    assert [(row["skill"], row["score"], row["direction"]) for row in rows] == [
        ("fry the steak", 2, "too late"),
        ("stir the soup", 5, None),
    ]
    table = tmp_path / "mine.yaml"
    assert ran("study", "ratings", "--rules", "-o", str(table), folder=tmp_path).code == Exit.FINE
    assert check([table]) == ()
    assert ran("study", "ratings", "--rules", "--json", folder=tmp_path).code == Exit.USAGE


def test_a_saved_session_keeps_no_ratings_and_a_loaded_one_takes_none_away(tmp_path: Path) -> None:
    talk = talk_of(STEAK, ":rate 1 4", f":save {tmp_path / 'session.json'}")
    assert '"ratings": []' in (tmp_path / "session.json").read_text()
    talk.say(f":load {tmp_path / 'session.json'}")
    assert len(talk.turns.conversation.ratings) == 1
