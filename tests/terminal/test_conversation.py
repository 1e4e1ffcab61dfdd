"""A conversation, turn by turn, with a clock that the test sets."""

import contextlib
import io
import json
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest

from fuzzytime.interpreter import Problem, ProblemKind
from fuzzytime_cli.formats.notes import note_lines
from fuzzytime_cli.render import Screen
from fuzzytime_cli.repl.scene import Reply
from fuzzytime_cli.repl.start import Dialogue, answer_each, piped
from fuzzytime_cli.repl.turn import Turns
from terminal.running import ran
from terminal.talking import NINE, Talk, talk_of


def test_an_instruction_is_kept_and_the_schedule_drawn() -> None:
    talk = Talk()
    answer = talk.say("Stir the soup in about ten minutes")
    assert "stir the soup" in answer
    assert talk.entries == ["Stir the soup in about ten minutes"]


def test_a_change_is_answered_with_the_table_and_the_list_draws_all() -> None:
    talk = Talk()
    first = talk.say("Stir the soup in about ten minutes")
    second = talk.say("Set the table in about twenty minutes")
    assert "durations assumed: s1 1 min" in first
    assert "durations assumed: s2 5 min" in second
    assert "s1 09:10" in second
    assert len(second.splitlines()) == 4
    drawn = talk.say(":list")
    assert "proved" in drawn
    assert "at work" in drawn


def test_of_a_long_table_a_change_shows_what_is_news_and_what_is_next() -> None:
    talk = Talk()
    for hour in range(20):
        talk.say(f"call Ann at {10 + hour % 12}:{hour:02} on 2026-03-{5 + hour // 12:02}")
    answer = talk.say("feed the cat at 23:00 on 2026-03-05")
    assert "feed the cat" in answer
    assert "… and 17 more (:list shows all)" in answer
    assert talk.say(":list").count("call Ann") > 20


@pytest.mark.parametrize(("said", "asked"), [("call mum at two", False), ("call mum at seven", True)])
def test_nobody_is_asked_whether_they_mean_the_middle_of_the_night(said: str, *, asked: bool) -> None:
    talk = Talk()
    answer = talk.say(said)
    assert ("Which time" in answer) is asked
    assert "say am or pm" not in answer
    assert "say am or pm" in talk.say(":list")
    # Nobody answers in a pipe: what may be is noted.
    talk = Talk()
    talk.turns.asks = False
    assert ("say am or pm" in talk.say(said)) is asked


def test_words_that_are_not_understood_are_pointed_at_and_not_kept() -> None:
    talk = Talk()
    answer = talk.say("call mum at 25:61 pm")
    assert "^" in answer
    assert talk.entries == []


def test_times_count_from_when_the_words_were_said() -> None:
    talk = talk_of("Stir the soup in exactly ten minutes")
    talk.now += timedelta(minutes=4)
    talk.say("Set the table in exactly ten minutes")
    assert abs(talk.start("s1") - NINE - timedelta(minutes=10)) < timedelta(minutes=4)
    assert abs(talk.start("s2") - NINE - timedelta(minutes=14)) < timedelta(minutes=4)


def test_a_start_that_comes_is_said_once_and_the_skill_stays() -> None:
    talk = talk_of("Stir the soup now")
    began = talk.start("s1")
    assert "start now: stir the soup" in talk.wait(seconds=1)
    assert talk.wait(seconds=1) == ""
    answer = talk.say("Set the table now")
    assert "running: s1" in answer
    assert talk.start("s2") >= began + timedelta(seconds=30)
    with pytest.raises(KeyError):
        talk.start("s1")


def test_what_happens_by_itself_is_announced_but_not_as_a_start() -> None:
    talk = talk_of("The guests come in ten minutes")
    assert "  now: The guests come (s1)" in talk.wait(minutes=10)


def test_what_happened_while_the_conversation_was_closed_did_so_at_its_time() -> None:
    talk = talk_of("The guests come in exactly an hour", "light the fire an hour after the guests come")
    made = talk.turns.conversation.plan(NINE + timedelta(minutes=100))
    assert [one.identifier for one in made.skills] == ["s2"]
    start = made.instant(made.schedule.start_times[0])
    assert abs(start - (NINE + timedelta(hours=2))) < timedelta(minutes=5)


def test_what_waits_for_a_started_skill_waits_until_it_is_done() -> None:
    talk = talk_of("Boil the eggs now")
    talk.wait(seconds=5)
    talk.say("Peel the eggs after boiling the eggs")
    assert talk.start("s2") >= NINE + timedelta(minutes=5)


def test_moves_are_said() -> None:
    talk = talk_of("Stir the soup in exactly ten minutes", ":duration 1 10min")
    answer = talk.say("Set the table in exactly ten minutes")
    assert "moved: s1" in answer


def test_a_reading_moves_what_waits_for_it() -> None:
    talk = Talk()
    assert "not enough readings" in talk.say("Flip the pancakes when the pan is hot")
    answer = talk.say(":ctx pan_temp=200")
    assert "found a place: s1" in answer
    assert talk.start("s1") - talk.now < timedelta(minutes=1)
    assert "pan_temp" in talk.say(":ctx")


def test_an_ambiguous_time_is_asked_about_once_and_a_number_answers() -> None:
    talk = Talk()
    asked = talk.say("Call mum at six")
    assert "Type 1 for Wednesday 18:00 (taken), 2 for Thursday 06:00." in " ".join(asked.split())
    answered = talk.say("2")
    assert "Which time" not in answered
    assert talk.start("s1") == NINE.replace(hour=6) + timedelta(days=1)
    assert talk.entries == ["Call mum at 06:00 on 2026-03-05"]


def test_a_question_that_is_not_answered_leaves_the_choice_and_loses_no_line() -> None:
    talk = talk_of("Call mum at six", "Stir the soup soon")
    assert talk.entries == ["Call mum at six", "Stir the soup soon"]
    assert talk.start("s1").hour in {17, 18}
    assert "cannot" not in talk.say(":list")


def test_a_skill_without_readings_is_drawn_without_an_empty_axis() -> None:
    talk = talk_of("Flip the pancakes when the pan is hot")
    drawn = talk.say(":plot 1")
    assert "pan_temp in" not in drawn
    assert "no start satisfies: not enough readings of pan_temp" in drawn
    talk.say(":ctx pan_temp=150")
    assert "pan_temp in" in talk.say(":plot 1")


def test_another_terminal_is_noticed(tmp_path: Path) -> None:
    first, second = Talk(tmp_path / "s.sqlite"), Talk(tmp_path / "s.sqlite")
    first.say("Stir the soup soon")
    news = second.wait(seconds=1)
    assert news.startswith("Changed in another terminal:")
    assert "stir the soup" in news


def test_typed_control_characters_reach_no_answer_raw() -> None:
    talk = Talk()
    answer = (
        talk.say("Stir \x1b[31mthe soup\x07 soon")
        + talk.say(":why 1")
        + talk.say(":list")
        + talk.say(":\x1b[2J")
    )
    assert not set(answer) & {"\x1b", "\x07"}


def test_a_skill_has_one_name_in_a_plan_a_run_and_a_conversation(tmp_path: Path) -> None:
    lines = ("Boil the eggs in five minutes, then set the table", "Make coffee soon")
    now = ("--now", "2026-03-04T09:00", "--zone", "Europe/Berlin")
    given = tuple(word for line in lines for word in ("-i", line))
    planned = json.loads(ran("plan", *given, "--format", "json", *now, folder=tmp_path).out)
    happened = [
        json.loads(line) for line in ran("run", *given, "--simulate", *now, folder=tmp_path).out.splitlines()
    ]
    talk = talk_of(*lines)
    assert talk.turns.plan is not None
    assert [skill["id"] for skill in planned["skills"]] == ["s1", "s1.2", "s2"]
    assert sorted(event["id"] for event in happened if event["type"] == "start") == ["s1", "s1.2", "s2"]
    assert [one.identifier for one in talk.turns.plan.skills] == ["s1", "s1.2", "s2"]


def test_a_start_that_comes_while_one_types_is_announced_with_the_next_turn() -> None:
    talk = talk_of("Feed the cat now")
    talk.now += timedelta(seconds=5)
    assert "09:00:00  start now: feed the cat (s1)" in talk.say("Call mum in ten minutes")
    assert "start now" not in talk.say(":list")


def test_a_rejected_skill_has_no_time_and_its_reason_is_said_once() -> None:
    talk = talk_of(":ctx pan_temp=100")
    answer = talk.say("Hang up the laundry when the pan is above 300 degrees")
    assert answer.count("never: pan_temp settles at 230 °C") == 1
    (row,) = [line for line in answer.split("\n") if "hang up the laundry" in line and " 0.00 " in line]
    assert row.split()[:3] == ["s1", "–", "–"]
    assert [line for line in answer.split("\n") if line.startswith("s1") and "█" in line] == []


def test_notes_end_with_the_start_and_who_takes_the_time_is_named() -> None:
    talk = talk_of("Set the table before the guests arrive")
    talk.wait(seconds=1)
    answer = talk.say("Stir the soup now")
    assert "note: s1" not in answer
    assert "its best time is taken by set the table (" in answer


def test_the_schedule_follows_the_width_of_the_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    written = io.StringIO()
    screen = Screen(written, 80, colour=False, unicode=True, interactive=True)
    talk = Dialogue(Talk().turns, lambda: NINE, screen, bell=False)
    talk.take("Stir the soup in about ten minutes and then set the table in the garden")
    for columns in (100, 40):
        monkeypatch.setenv("COLUMNS", str(columns))
        written.truncate(written.seek(0))
        talk.take(":why 1")
        assert columns - 20 < max(map(len, written.getvalue().splitlines())) <= columns


def test_what_is_said_anew_may_refer_to_what_was_said_since() -> None:
    talk = talk_of("Make the gravy at 10 am")
    talk.wait(seconds=5)
    talk.say("Serve the roast at 10:30 am")
    talk.wait(seconds=5)
    answer = talk.say(":edit 1 Make the gravy ten minutes before you serve the roast")
    assert "^" not in answer
    assert timedelta(minutes=5) < talk.start("s2") - talk.start("s1") < timedelta(minutes=15)


def test_a_reference_is_resolved_when_what_it_refers_to_is_said() -> None:
    talk = Talk()
    assert "^" in talk.say("Serve the rice after the soup is done")
    answer = talk.say("Cook the soup in ten minutes")
    assert "^" not in answer
    assert "s1 serve the rice" in answer
    assert talk.start("s1") > talk.start("s2") + timedelta(minutes=10)


def test_a_note_is_said_once_and_listed_when_asked_for() -> None:
    talk = Talk()
    talk.turns.asks = False
    note = "is taken as"
    assert note in talk.say("Serve the roast at half past six")
    assert note not in talk.say("Set the table soon")
    assert note in talk.say(":list")


@pytest.mark.parametrize(("count", "shown"), [(13, 13), (14, 12), (20, 12)])
def test_of_many_notes_the_first_are_told_and_the_rest_counted(count: int, shown: int) -> None:
    talk = talk_of("Serve the roast")
    assert talk.turns.plan is not None
    notes = tuple(Problem(kind=ProblemKind.NOTE, message=f"a note: of kind {n}") for n in range(count))
    lines = [line.plain for line in note_lines(replace(talk.turns.plan, problems=notes), ["s1"])]
    assert lines[:shown] == [f"note: a note: of kind {n}" for n in range(shown)]
    assert (f"and {count - shown} more notes: --format json has all" in lines) == (shown < count)


def test_a_reference_to_nothing_is_pointed_at_once_and_again_where_it_is_said_again() -> None:
    talk, marks, said = Talk(), "^^^^", "Make the gravy ten minutes before you serve the roast"
    assert marks in talk.say(said)
    assert marks not in talk.say("Set the table soon")
    assert marks not in talk.say(":drop 1")
    assert marks in talk.say(said)


class Tty(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize(("stream", "most"), [(Tty(), 40), (io.StringIO(), 200)])
def test_a_terminal_s_lines_are_broken_between_words_and_a_pipe_s_are_whole(
    stream: io.StringIO, most: int
) -> None:
    talk = talk_of("Stir the soup at half past six", "Set the table in about twenty minutes")
    screen = Screen(stream, 40, colour=False, unicode=True, interactive=False)
    talk.turns.width = 40
    screen.write("moved: s1 put the roast in the oven from 17:14:06 to 17:01:06")
    screen.write(*talk.turns.take("Call mum before it 25:61 pm and then, after that, sing", NINE).lines)
    screen.write(*talk.turns.take(":help", NINE).lines, *talk.turns.take("at ten past ten", NINE).lines)
    widths = [len(line) for line in stream.getvalue().splitlines()]
    assert max(widths) <= most
    assert (len("moved: s1 put the roast in the oven from 17:14:06 to 17:01:06") in widths) == (most > 40)


@pytest.mark.parametrize(("stream", "taken"), [(Tty, 2), (io.StringIO, 1)])
def test_ctrl_c_in_a_turn_ends_the_turn_of_one_who_types_and_all_of_a_pipe(
    stream: type[io.StringIO], taken: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    turns, seen = Talk().turns, []

    def take(_: Turns, line: str, now: datetime) -> Reply:
        seen.append((line, now))
        if line.startswith("Stir"):
            raise KeyboardInterrupt
        return Reply()

    monkeypatch.setattr(Turns, "take", take)
    screen = Screen(io.StringIO(), 80, colour=False, unicode=True, interactive=False)
    talk = Dialogue(turns, lambda: NINE, screen, bell=False)
    typed = stream("Stir the soup now\nSet the table now\n")
    with contextlib.nullcontext() if taken > 1 else pytest.raises(KeyboardInterrupt):
        piped(talk, typed)
    assert len(seen) == taken


def test_on_a_plain_terminal_what_is_to_be_said_anew_is_shown() -> None:
    talk, out = Talk(), io.StringIO()
    talk.say("Stir the soup in about ten minutes")
    screen = Screen(out, 80, colour=False, unicode=True, interactive=False)
    piped(Dialogue(talk.turns, lambda: NINE, screen, bell=False), Tty(":edit 1\n"))
    assert ":edit 1 Stir the soup in about ten minutes\n" in out.getvalue()


def test_a_session_goes_on_with_a_zone_and_without(tmp_path: Path) -> None:
    talk = Talk(tmp_path / "s.sqlite")
    talk.say("Stir the soup in ten minutes")
    talk.now = talk.now.replace(tzinfo=UTC) if talk.now.tzinfo is None else talk.now.replace(tzinfo=None)
    assert "set the table" in talk.say("Set the table in twenty minutes")
    assert "s1" in talk.say(":list")


def test_many_assumed_durations_are_told_together(tmp_path: Path) -> None:
    file = tmp_path / "day.txt"
    lines = [f"Boil pot {number} in {number} minutes" for number in range(1, 20)]
    file.write_text("\n".join([*lines, "Call mum soon"]), "utf-8")
    talk = Talk()
    answer = " ".join(talk.say(f":load {file}").split())
    assert "durations assumed: s1 to s19 2 min, s20 10 min" in answer


def test_of_a_running_skill_it_is_said_that_it_runs() -> None:
    talk = talk_of("Paint the wall now")
    talk.wait(seconds=2)
    talk.say("Set the table soon")
    assert "s1 is running until" in talk.say(":why 1")


def test_a_planned_instant_is_rounded_and_does_not_waver() -> None:
    talk = Talk()
    for part in (1, 250_000, 600_000, 999_999):
        talk.now = talk.now.replace(microsecond=part)
        talk.say("Ring the bell at 10 am")
        assert "09:59:59" not in talk.say(":list")


def test_a_move_to_another_day_is_told_with_the_day() -> None:
    talk = talk_of("Call mum at 5 pm")
    assert "moved: s1 call mum from 17:00 to Thu 17:00" in talk.say(":edit 1 call mum at 5 pm tomorrow")


def test_lines_that_are_pasted_are_planned_together() -> None:
    talk = Talk()
    first, listed, last = talk.paste(
        "call mum at noon",
        "",
        "stir the soup at 25:61 pm",
        "set the table ten minutes after calling mum",
        ":list",
        "no, make it one pm",
    )
    assert first.count("satisfied") == 1
    assert "'25:61 pm' looks like a time" in first
    assert "call mum at noon" in listed
    assert ":edit" in last
    assert len(talk.entries) == 2
    talk.say(":undo")
    talk.say(":undo")
    assert talk.entries == []


def test_of_pasted_lines_one_that_is_too_long_is_said_and_the_others_kept() -> None:
    talk = Talk()
    answers = talk.paste("call mum at noon", "stir " * 1000, "set the table at one pm")
    assert any("characters" in answer for answer in answers)
    assert talk.entries == ["call mum at noon", "set the table at one pm"]


def test_a_time_is_not_asked_about_where_the_other_is_in_the_dead_of_night() -> None:
    talk = Talk()
    told = talk.say("Call mum at 4:30")
    assert "Which time" not in told
    assert talk.start("s1").hour == 16
    assert "taken as 2 (Thursday 04:30)" in talk.say("am")


@pytest.mark.model
def test_each_answer_to_pasted_lines_stands_below_its_line() -> None:
    written = io.StringIO()
    talk = Dialogue(Talk().turns, lambda: NINE, Screen.of(written, {}), bell=False)
    answer_each(talk, "gym at 18:00\nwhen is the gym?\ncall mum at noon")
    shown = [line for line in written.getvalue().splitlines() if line.startswith(("› ", "s"))]
    assert [line[:5] for line in shown] == ["› gym", "s1   ", "› whe", "s1 gy", "› cal", "s2   ", "s1   "]
