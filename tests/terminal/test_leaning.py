"""Lines of a conversation that lean on those before them: other things and times, once more, not that one."""

from datetime import datetime

import pytest

from fuzzytime.language.about_wishes import AboutKind, about_things, about_wishes, continuing
from fuzzytime.language.finding import shipped_lexicon
from terminal.talking import Talk

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - the tests' moment is of no zone

pytestmark = pytest.mark.model


def _said(lines: str) -> Talk:
    talk = Talk()
    for line in lines.split(" | "):
        talk.say(line)
    return talk


@pytest.mark.parametrize(
    ("lines", "entries"),
    [
        ("call mum at six | and dad at seven", ["call mum at six", "call dad at seven"]),
        ("feed the cat at six | the dog at seven", ["feed the cat at six", "feed the dog at seven"]),
        ("water the roses at six | and the beans too", ["water the roses at six", "water the beans at six"]),
        ("call mum at six | then dad", ["call mum at six", "then call dad"]),
        ("put the rice on at six | oh and the peas", ["put the rice on at six", "put the peas on at six"]),
        ("read part one at four | and part two at five", ["read part one at four", "read part two at five"]),
        (
            "remind me at six to call mum | and dad",
            ["remind me at six to call mum", "remind me at six to call dad"],
        ),
        (
            "vet for Rex on monday at nine | same for Bo at ten",
            ["vet for Rex on monday at nine", "vet for Bo on monday at ten"],
        ),
        (
            "lesson with Mia at two | and with Tom at four",
            ["lesson with Mia at two", "lesson with Tom at four"],
        ),
        ("call mum at two | do that again at five", ["call mum at two", "call mum at five"]),
        ("call mum at two | same again tomorrow", ["call mum at two", "call mum tomorrow at two"]),
        ("buy milk at five | and bread", ["buy milk at five", "buy bread at five"]),
    ],
)
def test_a_line_goes_on_with_the_verb_said_last(lines: str, entries: list[str]) -> None:
    assert _said(lines).entries == entries


def test_the_same_again_is_repeated_on_another_day_from_the_hour_said() -> None:
    talk = _said("stir the soup every hour from ten am to two pm | same again tomorrow")
    again = "stir the soup tomorrow every hour from ten am to two pm"
    assert talk.entries == ["stir the soup every hour from ten am to two pm", again]


@pytest.mark.parametrize("line", ["stir it every hour until 2 pm", "stir it every ten minutes for an hour"])
def test_the_same_again_is_pointed_at_where_no_hour_was_said_to_begin(line: str) -> None:
    talk = _said(line)
    assert "say it in full" in talk.say("same again tomorrow")
    assert talk.entries == [line]


@pytest.mark.parametrize(
    "lines",
    [
        "call mum at six | and dinner at seven",
        "call mum at six | and gym at seven",
        "add the salt at ten | and stir",
        "water the plants at six | and the doctor at seven",
        "feed the cat at six | and the guests come at seven",
        "put the pasta on at ten | then stir it",
        "dentist at three | and choir at five",
    ],
)
def test_what_is_done_or_happens_by_itself_leans_on_nothing(lines: str) -> None:
    assert _said(lines).entries == lines.split(" | ")


def test_what_goes_on_outlives_what_it_leant_on() -> None:
    talk = _said("call mum at six pm | and dad at seven pm | cancel mum | no, half past seven")
    assert talk.entries == ["call dad at half past seven"]
    talk.say(":undo")
    talk.say(":undo")
    talk.say(":edit 2 and gran at eight pm")
    assert talk.start("s2").hour == 20
    talk.say(":delay 2 10min")
    assert talk.start("s2").minute == 10
    talk.say(":drop 2")
    assert talk.entries == ["call mum at six pm"]


@pytest.mark.parametrize(
    ("lines", "entries"),
    [
        ("call mum at six | make that dad", ["call dad at six"]),
        ("call mum at six | no, dad", ["call dad at six"]),
        ("meet Sam at two | sorry, Tim", ["meet Tim at two"]),
        ("buy milk at five | make it bread | not bread, butter", ["buy butter at five"]),
        ("feed the dog at six | I meant the cat", ["feed the cat at six"]),
        ("soup at six | fish at seven | not the soup, the stew", ["stew at six", "fish at seven"]),
        ("go for a run at seven | make that a walk", ["go for a walk at seven"]),
        ("meet Tim at two | at three, not two", ["meet Tim at three"]),
        # What was done to another is done to this one.
        ("serve soup at six | serve rice at seven | cancel the soup | no, the rice", ["serve soup at six"]),
        ("call mum at six | call dad at seven | cancel dad | the other one", ["call dad at seven"]),
        (
            "call mum at six | call dad at seven | cancel it | not that one, the other one",
            ["call dad at seven"],
        ),
        ("chop leeks at ten | chop beans at noon | not the beans", ["chop leeks at ten"]),
        ("order milk at ten | and bread | not milk", ["order bread at ten"]),
    ],
)
def test_another_thing_is_meant(lines: str, entries: list[str]) -> None:
    assert _said(lines).entries == entries


@pytest.mark.parametrize(
    "line", ["make it quick", "make it for four people", "no, six was fine", "not that one", "the other one"]
)
def test_what_stands_for_nothing_is_asked_about_and_planned_as_nothing(line: str) -> None:
    talk = _said("call mum at six pm | call dad at seven pm")
    talk.say(line)
    assert talk.entries == ["call mum at six pm", "call dad at seven pm"]


@pytest.mark.parametrize(
    ("lines", "entry"),
    [
        ("call mum tomorrow at ten | no, the day after", "call mum on 2026-03-06 at ten"),
        ("call mum at six | no, the next day", "call mum on 2026-03-05 at six"),
        ("call mum on friday | the week after", "call mum on 2026-03-13"),
        ("call mum at six | no, on friday", "call mum on friday at six"),
        ("call mum tonight at eight | let's say nine", "call mum tonight at nine"),
        ("give her the drops at eight in the evening | at ten", "give her the drops in the evening at ten"),
        ("stir it every five minutes | no, every ten", "stir it every ten minutes"),
        ("tea in 5 minutes | 10", "tea in 10 minutes"),
        ("take it out after 40 minutes | make that 45", "take it out after 45 minutes"),
        ("feed the dog at seven | make the dog eight", "feed the dog at eight"),
        ("he is here, call mum at six | he is tired, make it seven", "he is here, call mum at seven"),
    ],
)
def test_a_new_time_counts_from_the_old_one(lines: str, entry: str) -> None:
    assert _said(lines).entries == [entry]


@pytest.mark.parametrize(
    ("line", "start"),
    [
        ("a bit earlier", "17:50"),
        ("an hour later", "19:00"),
        ("make the reminder half an hour earlier", "17:30"),
        ("the reminder ten minutes later", "18:10"),
        ("hmm, an hour earlier would be better", "17:00"),
    ],
)
def test_something_is_later_by_some_time(line: str, start: str) -> None:
    assert f"{_said(f'remind me at 6 pm to call mum | {line}').start('s1'):%H:%M}" == start


def test_what_is_asked_back_is_answered_by_a_length() -> None:
    talk = _said("call mum at six pm")
    assert "by how much?" in talk.say("earlier")
    assert "taken as :delay 1 -30min" in talk.say("half an hour")
    assert "by how much?" in talk.say("the call takes longer")
    assert "taken as :duration 1 30min" in talk.say("twenty minutes")
    # Once something else is said, a length is one.
    talk.say("later")
    talk.say("what's next?")
    assert "for ten minutes" in talk.say("ten minutes")


@pytest.mark.parametrize(
    ("lines", "left"),
    [
        ("water it every monday at ten | not this monday", "2026-03-16 10:00"),
        ("water it every day at ten | skip today's", "2026-03-05 10:00"),
        ("water it every day at ten | not today | not tomorrow", "2026-03-06 10:00"),
        ("practise piano every day at ten | no piano today", "2026-03-05 10:00"),
        ("feed the hens every day at ten | not the hens today", "2026-03-05 10:00"),
    ],
)
def test_one_of_a_repetition_is_left_out(lines: str, left: str) -> None:
    talk = _said(lines)
    assert f"{talk.start('s1'):%Y-%m-%d %H:%M}" == left
    talk.say(":undo")
    assert f"{talk.start('s1'):%Y-%m-%d %H:%M}" < left


def test_what_is_left_out_is_done_on_another_day() -> None:
    talk = _said("inspect it every monday at eight am | not this monday | do it on tuesday instead")
    assert talk.entries[1:] == ["inspect it on tuesday at eight am"]
    talk = _said("inspect it every day at ten | not tomorrow | at eleven")
    assert len(talk.entries) == 1


def test_what_is_done_once_is_asked_about_or_dropped() -> None:
    talk = _said("swim at five pm")
    assert "when then?" in talk.say("not today")
    assert "nothing that is planned is tomorrow" in talk.say("not tomorrow")
    assert "nothing that is planned is tomorrow" in talk.say("no swimming tomorrow")
    talk.say("no swimming today")
    assert talk.entries == []


@pytest.mark.parametrize(
    ("lines", "entries"),
    [
        ("swap the two calls", ["call mum at seven", "call dad at six", "cook at noon"]),
        ("cancel both calls", ["cook at noon"]),
        ("drop the cooking | cancel both | undo", ["call mum at six", "call dad at seven"]),
        ("swap the two calls | other way round", ["call mum at six", "call dad at seven", "cook at noon"]),
        ("stop that", ["call mum at six", "call dad at seven"]),
        ("cancel the cooking", ["call mum at six", "call dad at seven"]),
        ("he is ill, cancel the cooking", ["call mum at six", "call dad at seven"]),
        ("cancel it | put it back", ["call mum at six", "call dad at seven", "cook at noon"]),
        ("drop the cooking | do the second one first", ["call mum at seven", "call dad at six"]),
    ],
)
def test_two_are_meant_by_what_they_have_in_common(lines: str, entries: list[str]) -> None:
    assert _said(f"call mum at six | call dad at seven | cook at noon | {lines}").entries == entries


def test_what_was_taken_for_done_is_not() -> None:
    talk = _said("paint the fence at eleven")
    assert "done: paint the fence" in talk.say("I already did")
    assert "undone" in talk.say("no, not yet")
    assert "s1 is still planned" in talk.say("no, not yet")
    assert talk.entries == ["paint the fence at eleven"]


@pytest.mark.parametrize(
    "line",
    [
        "and feed the cat at six",
        "skip rope at six",
        "make the bed at six",
        "stop the machine",
        "put the lid back",
    ],
)
def test_orders_lean_on_nothing(line: str) -> None:
    about = about_wishes(line, NOW, shipped_lexicon())
    assert about is None or not about.certain
    assert continuing("feed the cat at six", NOW, shipped_lexicon()) is None


def test_what_stands_in_the_place_of_what_is_heard() -> None:
    about = about_things("not the soup, the rice", NOW, shipped_lexicon())
    assert about is not None
    assert (about.kind, set(about.names), about.thing) == (AboutKind.INSTEAD, {"soup"}, "the rice")
    assert about_things("in ten minutes", NOW, shipped_lexicon()) is None


@pytest.mark.parametrize("line", ["every morning at 7:30 feed the cat", "feed the cat every morning at 7:30"])
def test_a_length_behind_what_was_left_out_is_of_all_that_are_left(line: str) -> None:
    talk = _said(f"{line} | not on sundays")
    assert "for 5 minutes; :undo" in talk.say("it takes 5 minutes")
    assert [entry.count("except on sundays") for entry in talk.entries] == [1]
