"""Each way to end has its exit code, one clear message, and no traceback."""

from pathlib import Path

import pytest

from fuzzytime_cli.exits import Exit
from fuzzytime_cli.faults import underlined
from fuzzytime_cli.render import width_of
from terminal.running import ran

NOW = ("--now", "2026-03-04T09:00")


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (("plan", "-i", "stir the soup soon", *NOW), Exit.FINE),
        (("plan", "no_such_file.txt"), Exit.NO_INPUT),
        (("plan", "tests"), Exit.NO_INPUT),
        (("plan", "tests/data/empty.txt"), Exit.NO_INPUT),
        (("plan", "tests/data/comments.txt"), Exit.NO_INPUT),
        (("plan", "tests/data/binary.bin"), Exit.BAD_DATA),
        (("plan", "tests/data/latin1.txt"), Exit.BAD_DATA),
        (("plan", "tests/data/broken.yaml"), Exit.BAD_DATA),
        (("plan", "tests/data/mistakes.yaml"), Exit.BAD_DATA),
        (("plan",), Exit.NO_INPUT),
        (("plan", "--nonsense"), Exit.USAGE),
        (("plan", "-i", "x", "--now", "yesterday"), Exit.USAGE),
        (("plan", "-i", "x", "--ctx", "nothing=1"), Exit.USAGE),
        (("plan", "-i", "x", "--context", "no_such_file"), Exit.NO_INPUT),
        (("plan", "-i", "x", "--rules", "no_such_file"), Exit.NO_INPUT),
        (("plan", "-i", "x", "--rules", "tests/data/mistakes.yaml"), Exit.BAD_CONFIG),
        (("rules", "check", "tests/data/mistakes.yaml"), Exit.BAD_CONFIG),
        (("plan", "-i", "stir the soup soon", "-o", "no/such/folder/plan.json", *NOW), Exit.IO_ERROR),
        (("explain", "examples/breakfast.txt", *NOW), Exit.USAGE),
        (("nonsense",), Exit.USAGE),
    ],
)
def test_an_end_has_its_code(arguments: tuple[str, ...], code: Exit, tmp_path: Path) -> None:
    done = ran(*arguments, folder=tmp_path)
    assert done.code == code, done.err
    assert "Traceback" not in done.err
    assert bool(done.err) == (code != Exit.FINE)


def test_a_table_that_is_missing_keeps_no_other_from_being_checked(tmp_path: Path) -> None:
    done = ran("rules", "check", "no/such.yaml", "tests/data/mistakes.yaml", "nor/this.yaml", folder=tmp_path)
    assert done.code == Exit.BAD_CONFIG
    assert done.err.count("there is no such table") == 2
    assert "tests/data/mistakes.yaml:2:1: agents" in done.err
    alone = ran("rules", "check", "no/such.yaml", "rules/lookup.yaml", folder=tmp_path)
    assert (alone.code, alone.out) == (Exit.NO_INPUT, "")


@pytest.mark.parametrize("command", [("rules", "check"), ("plan", "-i", "x", "--rules"), ("plan",)])
def test_a_mistake_begins_with_its_place_for_who_jumps_there(
    command: tuple[str, ...], tmp_path: Path
) -> None:
    table = tmp_path / "wrong.yaml"
    table.write_text("fuzzytime: 1\nwodrs: {}\n", encoding="utf-8")
    err = ran(*command, str(table), folder=tmp_path).err
    assert err.startswith(f"{table}:{2 if 'plan' not in command or '--rules' in command else 1}:1: ")


def test_a_line_that_cannot_be_read_is_said_and_the_rest_is_planned(tmp_path: Path) -> None:
    text = b"stir the soup soon\n\nset the table at 25:61 pm\n"
    done = ran("plan", "-", *NOW, folder=tmp_path, stdin=text)
    assert done.code == Exit.FINE
    assert "stir the soup" in done.out
    assert done.err.startswith("<stdin>:3: ")
    assert "^" in done.err
    assert ran("plan", "-", "--strict", *NOW, folder=tmp_path, stdin=text).code == Exit.BAD_DATA


def test_a_loss_is_told_once_where_the_plan_is_shown(tmp_path: Path) -> None:
    wishes = ("-i", "Meet at 3pm sharp for an hour", "-i", "Call Bob at 3pm sharp for an hour")
    done = ran("plan", *wishes, *NOW, folder=tmp_path)
    assert (done.err, done.out.count("call Bob: rejected: alone it could have 1.00")) == ("", 1)
    assert "call Bob: no start time" in ran("plan", *wishes, "--format", "csv", *NOW, folder=tmp_path).err
    (tmp_path / "beside.txt").write_text("Meet at 3pm sharp for an hour\n")
    beside = ("--beside", str(tmp_path / "beside.txt"))
    why = ran("explain", "Call Bob at 3pm sharp for an hour", *beside, *NOW, folder=tmp_path)
    assert why.err == ""
    assert "It is rejected: it lost its time to meet, which wants the same minutes." in why.out


def test_of_many_that_are_rejected_the_first_are_said_and_the_rest_counted(tmp_path: Path) -> None:
    lines = b"Call mum on april 22 at noon\n" * 30
    done = ran(
        "plan",
        "-",
        "--format",
        "csv",
        "--horizon",
        "2d",
        *NOW,
        folder=tmp_path,
        stdin=lines + b"Stir for a while\n",
    )
    assert done.err.count("beyond the horizon") == 20
    assert "<stdin>: 10 more are rejected" in done.err
    assert "'for a while'" in done.err
    assert done.out.count(",true,") == 30


def test_a_circle_says_who_cannot_come_before_whom(tmp_path: Path) -> None:
    task = tmp_path / "task.yaml"
    task.write_text("instructions: [{say: Stir soon, id: a, after: b}, {say: Call mum, id: b, after: a}]\n")
    done = ran("plan", str(task), *NOW, folder=tmp_path)
    assert "'stir' (a) cannot come before 'call mum' (b), which must come before it" in done.err


def test_where_no_line_can_be_read_the_data_are_bad(tmp_path: Path) -> None:
    assert ran("plan", "-i", "in ten minutes", *NOW, folder=tmp_path).code == Exit.BAD_DATA


def test_the_strict_product_of_a_clash_is_infeasible_and_its_json_is_printed(tmp_path: Path) -> None:
    task = tmp_path / "task.yaml"
    task.write_text(
        "skills:\n"
        "  - {name: weld, duration: 5 min, satisfaction: {rectangle: [0 s, 60 s]}}\n"
        "  - {name: paint, duration: 5 min, satisfaction: {rectangle: [0 s, 60 s]}}\n"
    )
    done = ran("plan", str(task), "--threshold", "0", "--format", "json", folder=tmp_path)
    assert done.code == Exit.INFEASIBLE
    assert '"status": "infeasible"' in done.out


def test_a_defect_is_a_message_and_not_a_traceback(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from fuzzytime_cli.assembly import Assembly

    def broken(_: Assembly) -> None:
        raise ZeroDivisionError("on purpose")

    monkeypatch.setattr(Assembly, "interpreter", broken)
    done = ran("plan", "-i", "stir the soup", folder=tmp_path)
    assert done.code == Exit.FAILURE
    assert "this should not happen" in done.err


def test_a_pipe_into_the_bare_command_is_planned(tmp_path: Path) -> None:
    done = ran(folder=tmp_path, stdin=b"stir the soup soon\n")
    assert (done.code, done.err) == (Exit.FINE, "")
    assert "stir the soup" in done.out


def test_a_pipe_into_plan_needs_no_name(tmp_path: Path) -> None:
    done = ran("plan", folder=tmp_path, stdin=b"stir the soup soon\nand so on\n")
    assert done.code == Exit.FINE
    assert "stir the soup" in done.out
    assert "<stdin>:2: " in done.err


def test_instructions_given_as_options_leave_a_pipe_to_others(tmp_path: Path) -> None:
    done = ran("plan", "-i", "call mum soon", folder=tmp_path, stdin=b"stir the soup soon\n")
    assert "call mum" in done.out
    assert "stir" not in done.out


def test_at_a_terminal_plan_says_what_it_wants_instead_of_waiting(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("fuzzytime_cli.inputs.source.is_piped", lambda: False)
    done = ran("plan", folder=tmp_path)
    assert (done.code, done.out) == (Exit.USAGE, "")
    assert done.err == "fuzzytime: say what to plan: a file, - for standard input, or -i TEXT\n"


def test_a_line_without_end_is_refused_in_few_words_and_the_rest_is_planned(tmp_path: Path) -> None:
    endless = b"stir the soup " * 400_000
    done = ran("plan", "-", folder=tmp_path, stdin=endless + b"\nStir the soup soon\n" + endless)
    assert done.code == Exit.FINE
    assert done.err.count("must not be longer than") == 2
    assert len(done.err) < 1000
    assert "stir the soup" in done.out


@pytest.mark.parametrize("width", [24, 40, 80])
def test_marks_stay_under_their_words_where_there_is_little_room(width: int) -> None:
    text = "and then put the pan on the stove at half past and wait for the butter to melt in the pan"
    at = text.index("at half past")
    shown, marks = underlined(text, (at, at + 12), width).split("\n")
    assert width_of(shown) <= width
    assert shown[marks.index("^") : len(marks)] == "at half past"


def test_marks_stand_under_wide_words() -> None:
    first, second = underlined("寿司 at half past", (3, 17)).split("\n")
    assert width_of(first) == width_of(second)


@pytest.mark.parametrize(
    "command", [(), ("plan",), ("explain",), ("run",), ("batch",), ("study", "simulate")]
)
def test_help_fits_forty_columns_and_stands_in_two_where_there_is_room(
    command: tuple[str, ...], tmp_path: Path
) -> None:
    narrow = ran(*command, "--help", folder=tmp_path, COLUMNS="40").out
    assert max(map(width_of, narrow.splitlines())) <= 40
    wide = ran(*command, "--help", folder=tmp_path, COLUMNS="80").out
    assert len(wide.splitlines()) < len(narrow.splitlines())
    assert narrow.split()[-3:] == wide.split()[-3:]


@pytest.mark.parametrize("given", [("--format", "pdf"), ("--agents", "0"), ("--agents", "two")])
def test_a_bad_option_is_said_in_plain_words(given: tuple[str, str], tmp_path: Path) -> None:
    done = ran("plan", "-i", "stir the soup soon", *given, folder=tmp_path)
    assert done.code == Exit.USAGE
    assert given[0] in done.err
    assert "Value error" not in done.err
    assert "Input should" not in done.err


def test_commands_of_the_conversation_are_no_instructions(tmp_path: Path) -> None:
    done = ran("plan", "-", stdin=b"boil the eggs soon\n:rate 1 4\n :list\n", folder=tmp_path)
    assert done.code == Exit.BAD_DATA
    assert "<stdin>:2:1: ':rate' is a command of the conversation (see: fuzzytime repl)" in done.err
    assert "<stdin>:3:2: ':list'" in done.err
