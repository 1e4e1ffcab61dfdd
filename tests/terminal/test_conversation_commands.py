"""The conversation's commands."""

import io
from datetime import timedelta
from pathlib import Path

import pytest

from fuzzytime_cli.render import Screen
from fuzzytime_cli.repl import start
from terminal.running import ran
from terminal.talking import NINE, Talk, talk_of


def test_steps_are_undone_and_done_again() -> None:
    talk = talk_of("Stir the soup soon", "Set the table soon")
    assert "undone" in talk.say(":undo")
    assert talk.entries == ["Stir the soup soon"]
    assert "done again" in talk.say(":redo")
    assert len(talk.entries) == 2
    talk.say(":drop 1")
    assert talk.entries == ["Set the table soon"]
    assert "nothing to redo" in talk.say(":redo")


def test_what_if_changes_nothing() -> None:
    talk = talk_of("Stir the soup soon")
    answer = talk.say(":what-if set the table now")
    assert "set the table" in answer
    assert "nothing is changed" in answer
    assert talk.entries == ["Stir the soup soon"]


def test_why_explains_from_the_words_to_the_start() -> None:
    talk = talk_of("Place the pan on the stove in about four minutes")
    answer = " ".join(talk.say(":why 1").split())
    assert "place ← minutes (oblique temporal) ← four (number), about (hedge), in (preposition)" in answer
    assert "rules/lookup.yaml" in answer


def test_a_command_takes_words_for_what_is_planned() -> None:
    talk = talk_of("Stir the soup in ten minutes", "Set the table in five minutes")
    assert talk.say(":why the soup") == talk.say(":why 1")
    talk.say(":drop table")
    assert talk.entries == ["Stir the soup in ten minutes"]
    assert "done: stir the soup" in talk.say(":done the soup")
    assert talk.left == []


@pytest.mark.parametrize(
    ("line", "rule"),
    [
        (":nonsense", "there is no command 'nonsense'"),
        (":why 9", "a skill of the plan must follow"),
        (":drop nine", "nothing that is planned is about nine"),
        (":drop", "a number from the list must follow"),
        (":why bread", "nothing that is planned is about bread"),
        (":drop 9", "a number must be one of the list"),
        (":drop", "a number from the list must follow, such as 2, or words"),
        (":why", "a number from the list must follow, such as 2, or words"),
        (":more", "a number and a length of time"),
        (":undo 7", "nothing may follow :undo, got '7'"),
        (":help :nonsense", "there is no command 'nonsense'"),
        (":duration 1", "a number and a duration"),
        (":duration 1 soon", "a duration must be a number and a unit"),
        (":ctx pan_tmp=3", "did you mean 'pan_temp'?"),
        (":agents many", "agents must be a number"),
        (":solver magic", "a solver must be one of"),
        (":busy 12:00", "two times must follow"),
        (":load no_such_file", "there is no such file"),
        (":save", "a file must follow"),
        (":save no/such/folder/x.ics", "No such file"),
        (":priority 1 much", "a priority must be a number"),
        (":drop ²", "a number from the list must follow"),
        (":drop -1", "such as 2, got '-1'"),
        (":agents ²", "agents must be a number"),
        (f":agents {'9' * 5000}", "agents must be a number"),
        (f":drop {'9' * 5000}", "a number from the list must follow"),
        (":load examples/workshop.yaml", "is a task file, which fuzzytime plan and run read"),
        (":plot 1 soup.png", "a picture's file must end in .svg"),
    ],
)
def test_a_wrong_command_is_answered_by_its_rule(line: str, rule: str) -> None:
    talk = talk_of("Stir the soup soon")
    assert rule in talk.say(line)
    assert talk.entries == ["Stir the soup soon"]


def test_of_a_file_only_the_lines_that_are_understood_are_kept(tmp_path: Path) -> None:
    talk = Talk()
    file = tmp_path / "day.txt"
    file.write_text("Stir the soup in ten minutes\nthe end of the world\ncall mum at 25:61 pm\n", "utf-8")
    answer = talk.say(f":load {file}")
    assert "2 of 3 lines are not understood, and not kept" in answer
    assert talk.entries == ["Stir the soup in ten minutes"]
    file.write_text("the end of the world\n", "utf-8")
    assert "1 of 1 lines" in talk.say(f":load {file}")
    assert len(talk.entries) == 1


@pytest.mark.parametrize(
    "line", [":agents", ":drop", ":edit", ":in-order maybe", ":plot", ":rate 1", ":save", ":solver"]
)
def test_what_was_not_said_is_not_repeated(line: str) -> None:
    answer = Talk().say(line)
    assert "must" in answer
    assert "''" not in answer


def test_a_session_is_saved_and_loaded(tmp_path: Path) -> None:
    talk = talk_of("Stir the soup in exactly an hour", ":busy 12:00 13:00 lunch")
    talk.say(f":save {tmp_path / 'dinner.json'}")
    talk.say(f":save {tmp_path / 'dinner.ics'}")
    other = Talk()
    other.say(f":load {tmp_path / 'dinner.json'}")
    assert other.entries == ["Stir the soup in exactly an hour"]
    assert other.turns.conversation.state.busy[0].what == "lunch"
    third = Talk()
    assert "1 busy times read, until Wednesday 3 June 2026" in third.say(f":load {tmp_path / 'dinner.ics'}")


def test_the_beginning_of_a_command_will_do() -> None:
    assert ":list" in Talk().say(":he")


def test_an_instruction_is_said_anew() -> None:
    talk = talk_of("Stir the soup soon", ":edit 1")
    assert talk.edit == ":edit 1 Stir the soup soon"
    talk.say(":edit 1 Stir the soup in ten minutes")
    assert talk.entries == ["Stir the soup in ten minutes"]


def test_what_is_said_anew_while_it_is_running_is_planned_again() -> None:
    talk = talk_of("Paint the wall now")
    talk.wait(seconds=2)
    answer = talk.say(":edit 1 Paint the wall in two hours")
    assert "no longer running: paint the wall" in answer
    assert "s2" in answer
    assert talk.entries == ["Paint the wall in two hours"]


def test_what_is_done_no_longer_holds_its_agent() -> None:
    talk = talk_of("Paint the wall now")
    talk.wait(seconds=2)
    talk.say("Set the table now")
    before = talk.start("s2")
    talk.now += timedelta(seconds=30)
    assert "done: paint the wall" in talk.say(":done 1")
    assert talk.start("s2") < before


def test_what_is_done_before_its_time_leaves_the_rest_of_its_instruction() -> None:
    talk = talk_of("Boil the eggs in about five minutes, then call mum")
    before = talk.start("s1.2")
    assert "done: boil the eggs" in talk.say(":done 1")
    assert NINE <= talk.start("s1.2") < before
    assert "boil the eggs" not in talk.say(":list").split("\n\n")[0]


def test_of_a_repetition_one_occurrence_is_done() -> None:
    talk = talk_of("Water the plants every two hours until 6 pm", ":done s1")
    assert talk.start("s1.2") > NINE


def test_help_of_one_command_is_its_line() -> None:
    assert Talk().say(":help drop").strip().splitlines() == [
        ":drop N|N,M|all             forget instruction N, several, or all"
    ]


def test_times_of_other_days_name_the_day() -> None:
    talk = talk_of("Watch the fire now for 20 hours")
    assert "until Thu 05:00:00" in talk.wait(seconds=1) + talk.say("what's next?")
    talk.wait(days=2)
    assert "  1  04 Mar 09:00  Watch the fire now" in talk.say(":list")


def test_a_night_is_busy_until_the_morning() -> None:
    talk = Talk()
    assert "taken from 23:00 to Thu 07:00: sleep\n" in talk.say(":busy 23:00 07:00 sleep")
    (busy,) = talk.turns.conversation.state.busy
    assert busy.end - busy.start == timedelta(hours=8)


@pytest.mark.parametrize("line", ["help", "HELP", "?", ":h", "/help", "help?", "What can you do?"])
def test_help_comes_however_it_is_asked_for(line: str) -> None:
    answer = Talk().say(line)
    assert ":what-if" in answer
    assert max(map(len, answer.split("\n"))) <= 80


def test_exit_leaves_and_is_no_task() -> None:
    talk = Talk()
    assert talk.turns.take("exit", NINE).over
    assert talk.entries == []


@pytest.mark.parametrize("name", ["", "dinner", "dinner.pdf", "dinner.txt"])
def test_a_plan_is_saved_only_as_what_can_be_told(name: str, tmp_path: Path) -> None:
    talk = Talk()
    assert "must follow that ends in .json (the session) or .csv" in talk.say(f":save {tmp_path / name}")
    assert list(tmp_path.iterdir()) == []


def test_a_command_can_be_tried_and_changes_nothing() -> None:
    talk = talk_of("Flip the pancakes when the pan is hot", "Boil the eggs in ten minutes")
    answer = talk.say(":what-if :ctx pan_temp=200")
    assert "found a place: s1 flip the pancakes" in answer
    assert "nothing is changed" in answer
    assert "there is no" not in talk.say(":what-if :drop 2")
    assert talk.entries == ["Flip the pancakes when the pan is hot", "Boil the eggs in ten minutes"]
    assert talk.say(":ctx").startswith("no readings yet")


@pytest.mark.parametrize(
    ("words", "answer"),
    [
        (":what-if :undo", "what can be tried"),
        (":what-if :ctx", "would change nothing"),
        (":what-if :drop 7", "7"),
    ],
)
def test_what_cannot_be_tried_is_said(words: str, answer: str) -> None:
    talk = talk_of("Boil the eggs in ten minutes")
    assert answer in talk.say(words)


def test_a_long_instruction_is_undone_in_a_line() -> None:
    talk = talk_of("Stir the soup soon and " + 30 * "very " + "slowly")
    assert max(map(len, talk.say(":undo").splitlines())) <= 80
    assert max(map(len, talk.say(":redo").splitlines()[:1])) <= 80


def test_a_calendar_is_loaded_for_some_months_and_only_once(tmp_path: Path) -> None:
    file = tmp_path / "work.ics"
    daily = "BEGIN:VEVENT\nDTSTART:20260301T080000Z\nDURATION:PT20M\nRRULE:FREQ=DAILY\nEND:VEVENT\n"
    file.write_text(
        f"BEGIN:VCALENDAR\nVERSION:2.0\n{daily}BEGIN:VEVENT\nSUMMARY:Fair\nEND:VEVENT\nEND:VCALENDAR\n"
    )
    talk = Talk()
    answer = talk.say(f":load {file}")
    assert "91 busy times read, until Wednesday 3 June 2026" in answer
    assert "event 'Fair' takes no time" in answer
    assert "91 of them known" in talk.say(f":load {file}")
    assert len(talk.turns.conversation.state.busy) == 91


@pytest.mark.parametrize(
    ("options", "said", "planned"),
    [
        (("--ctx", "pan_temp=180"), "flip the pancakes when the pan is hot", "09:01"),
        (("--horizon", "2 d"), "call mum on April 22 at noon", "beyond the horizon"),
        (("--agents", "2"), "stir the soup right now", "by what"),
    ],
)
def test_options_count_in_a_conversation(
    options: tuple[str, str], said: str, planned: str, tmp_path: Path
) -> None:
    command = ("repl", "--forget", "--now", "2026-03-04T09:00")
    lines = f"{said}\n".encode()
    assert planned in ran(*command, *options, folder=tmp_path, stdin=lines).out
    assert planned not in ran(*command, folder=tmp_path, stdin=lines).out


def test_a_conversation_counts_more_than_the_agents_of_an_option(tmp_path: Path) -> None:
    given = ("repl", "--forget", "--agents", "2", "--now", "2026-03-04T09:00")
    done = ran(*given, folder=tmp_path, stdin=b":agents 1\nstir the soup soon\n")
    assert "by what" not in done.out


def test_readings_from_outside_are_listed_and_not_kept(tmp_path: Path) -> None:
    given = ("repl", "--ctx", "pan_temp=180", "--now", "2026-03-04T09:00")
    assert "pan_temp" in ran(*given, folder=tmp_path, stdin=b":ctx\n").out
    assert "no readings yet" in ran("repl", folder=tmp_path, stdin=b":ctx\n").out


def test_a_defect_costs_who_types_one_turn_only(monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(*_: object) -> None:
        raise ZeroDivisionError("by design")

    monkeypatch.setattr("fuzzytime_cli.repl.commands.looking.date_of", broken)
    out = io.StringIO()
    turns = Talk().turns
    talk = start.Dialogue(turns, lambda: NINE, Screen.of(out, {}), bell=False)
    assert talk.take(":now") == (True, "")
    assert "this should not happen (ZeroDivisionError: by design)" in out.getvalue()
    turns.asks = False
    with pytest.raises(ZeroDivisionError):
        talk.take(":now")


def following(talk: Talk) -> list[tuple[str, ...]]:
    """Give what each skill of the plan follows, in the order of the instructions."""
    plan = talk.turns.plan
    assert plan is not None
    skills = sorted(plan.skills, key=lambda one: one.identifier)
    return [one.follows for one in skills]


@pytest.mark.parametrize(
    ("anew", "follows"),
    [
        # What was said behind it refers to it as before.
        (":edit 1 feed the dog at half six", [(), ("s1",), ()]),
        ("actually, do the dog at half six", [(), ("s1",), ()]),
        # Its own words may refer to what was given later, by what is done there.
        (":edit 1 feed the dog after washing the car", [("s3",), ("s1",), ()]),
        # A reference that it had stays where it was.
        (":edit 2 then walk it for an hour", [(), ("s1",), ()]),
        # It is not understood rather than that another loses its own.
        (":edit 1 feed the dog after that", [(), ("s1",), ()]),
    ],
)
def test_what_is_said_anew_keeps_its_place_among_the_others(
    anew: str, follows: list[tuple[str, ...]]
) -> None:
    talk = Talk()
    for line in ("feed the dog at six", "then walk it for half an hour", "wash the car tomorrow at ten"):
        talk.say(line)
    assert following(talk) == [(), ("s1",), ()]
    talk.wait(minutes=1)
    talk.say(anew)
    assert following(talk) == follows


def test_an_instruction_that_refers_to_one_given_since_stands_behind_it() -> None:
    talk = talk_of("stir the soup in an hour", "set the table in ten minutes")
    talk.wait(seconds=5)
    talk.say(":edit 1 stir the soup after that")
    assert following(talk) == [("s2",), ()]


def test_a_step_that_is_said_anew_is_the_same_step() -> None:
    talk = talk_of(":in-order on")
    for line in ("fry the onions in ten minutes", "boil the rice", "serve the rice"):
        talk.say(line)
    talk.wait(seconds=5)
    talk.say(":edit 2 boil the brown rice")
    starts = [talk.start(name) for name in ("s1", "s2", "s3")]
    assert starts == sorted(starts)


@pytest.mark.parametrize("quote", ["", '"', "'"])
def test_a_file_whose_name_has_spaces_may_be_quoted(quote: str, tmp_path: Path) -> None:
    talk = talk_of("stir the soup soon")
    assert "written" in talk.say(f":save {quote}{tmp_path / 'my dinner.csv'}{quote}")
    assert (tmp_path / "my dinner.csv").is_file()
