"""What the help says of options is so."""

import json
import re
from pathlib import Path
from typing import get_type_hints

import pytest

from console import ROOT
from fuzzytime_cli.exits import Exit
from fuzzytime_cli.options import Solving
from fuzzytime_cli.settings import KINDS
from terminal.running import ran

HELPS = {
    name: hint.__metadata__[0].help
    for name, hint in get_type_hints(Solving, include_extras=True).items()
    if "default" in hint.__metadata__[0].help
}


@pytest.mark.parametrize("name", HELPS)
def test_the_help_tells_the_default_that_counts(name: str) -> None:
    (said,) = re.findall(r"\(default ([\d.]+)\)|(\w+) \(the default\)", HELPS[name])
    assert "".join(said) == str(KINDS[name].default).removesuffix(".0")


SOUP = ("plan", "-i", "Stir the soup soon", "--now", "2026-03-04T09:00")


@pytest.mark.parametrize(
    ("name", "begins"),
    [
        ("soup.ics", "BEGIN:VCALENDAR"),
        ("soup.CSV", "id,start"),
        ("soup.json", "{"),
        ("soup.svg", "<svg"),
        ("soup.html", "<!doctype html>"),
        ("soup.txt", "   start"),
    ],
)
def test_the_name_of_the_file_says_its_format(name: str, begins: str, tmp_path: Path) -> None:
    file = tmp_path / name
    assert ran(*SOUP, "-o", str(file), folder=tmp_path).code == 0
    assert file.read_text(encoding="utf-8").startswith(begins)


def test_an_ending_that_says_no_format_gets_a_table_and_a_word_about_it(tmp_path: Path) -> None:
    file = tmp_path / "soup.foo"
    said = ran(*SOUP, "-o", str(file), folder=tmp_path).err
    assert (
        said == f"fuzzytime: {file}: no format has this ending, so that a table is written (see: --format)\n"
    )
    assert file.read_text(encoding="utf-8").startswith("   start")
    assert ran(*SOUP, "-o", str(tmp_path / "soup"), folder=tmp_path).err == ""


def test_a_format_that_is_given_counts_more_than_the_name(tmp_path: Path) -> None:
    file = tmp_path / "soup.ics"
    assert ran(*SOUP, "-o", str(file), "--format", "csv", folder=tmp_path).code == 0
    assert file.read_text(encoding="utf-8").startswith("id,start")


@pytest.mark.parametrize(
    "command",
    [
        (*SOUP, "--format", "csv"),
        ("batch", "SOUP", "--jobs", "1"),
    ],
)
def test_a_dash_is_standard_output(command: tuple[str, ...], tmp_path: Path) -> None:
    (tmp_path / "soup.txt").write_text("Stir the soup soon\n", encoding="utf-8")
    given = [part.replace("SOUP", str(tmp_path / "soup.txt")) for part in command]
    done = ran(*given, "-o", "-", folder=tmp_path)
    assert (done.code, "Stir the soup soon" in done.out or "fuzzytime-batch" in done.out) == (0, True)
    assert not (ROOT / "-").exists()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["plan", "-i", " "], "an instruction must not be empty"),
        (["explain", ""], "an instruction must not be empty"),
        (["rules", "show", ""], "the words must not be empty"),
        (["plan", "-i", "Stir", "--seed", "-1"], "--seed: must be at least 0, got '-1' "),
        (["plan", "-i", "Stir", "--agents", "two"], "--agents: must be a whole number, got 'two' "),
        (["plan", "-i", "Stir", "--agents=200"], "--agents: must be at most 100, got '200' "),
        (["plan", "-i", "Stir", "--threshold", "low"], "--threshold: must be a number, got 'low' "),
    ],
)
def test_what_is_wrong_with_a_value_is_said_in_plain_words(
    arguments: list[str], said: str, tmp_path: Path
) -> None:
    done = ran(*arguments, folder=tmp_path)
    assert done.code == 2
    assert said in done.err


@pytest.mark.parametrize("command", [["rules", "check"], ["plan", "-i", "Stir", "--rules"]])
def test_a_folder_is_no_table(command: list[str], tmp_path: Path) -> None:
    done = ran(*command, str(tmp_path), folder=tmp_path)
    assert done.code == 66
    assert "table must be a file, and it is a folder" in done.err


def test_rules_show_says_that_words_are_not_about_time(tmp_path: Path) -> None:
    assert ran("rules", "show", "banana", folder=tmp_path).out.startswith("no words about time")


def test_parse_answers_a_file_and_then_what_was_typed(tmp_path: Path) -> None:
    file = tmp_path / "one.txt"
    file.write_text("Stir the soup soon\n", encoding="utf-8")
    done = ran("parse", str(file), "-i", "Feed the cat", "--now", "2026-03-04T09:00", folder=tmp_path)
    assert done.out.startswith("Stir the soup soon\n")
    assert "\nFeed the cat\n" in done.out


@pytest.mark.parametrize(
    ("lines", "code", "strict"),
    [
        (b"Stir the soup soon\n", 0, 0),
        (b"Stir the soup for a while\n", 0, 65),
        (b"Stir the soup soon\n\xff\n", 0, 65),
        (b"\xff\n\xfe\n", 65, 65),
        (b"", 0, 0),
    ],
)
def test_parse_fails_where_nothing_can_be_read_or_strictly_anything(
    lines: bytes, code: int, strict: int, tmp_path: Path
) -> None:
    assert ran("parse", "--jsonl", "-", stdin=lines, folder=tmp_path).code == code
    done = ran("parse", "--jsonl", "--strict", "-", stdin=lines, folder=tmp_path)
    assert (done.code, len(done.out.splitlines())) == (strict, lines.count(b"\n"))


def test_parse_leaves_out_comments_but_answers_every_line_of_json(tmp_path: Path) -> None:
    file = tmp_path / "one.txt"
    file.write_text("# At noon\nStir the soup soon\n", encoding="utf-8")
    assert ran("parse", str(file), folder=tmp_path).out.startswith("Stir the soup soon\n")
    assert len(ran("parse", "--jsonl", str(file), folder=tmp_path).out.splitlines()) == 2


@pytest.mark.parametrize(
    ("line", "error"),
    [
        ('{"text": "Stir soon", "nwo": "2026-03-04T09:00"}', "unknown key 'nwo' (did you mean 'now'?)"),
        ('{"txt": "Stir soon"}', "unknown key 'txt' (did you mean 'text'?)"),
        ('{"text": "Stir soon", "text": "Call"}', "keys must differ, got 'text' twice"),
        ('{"text": "Stir soon", "weight": NaN}', "numbers must be finite, got NaN"),
    ],
)
def test_parse_says_on_its_line_what_is_wrong_with_a_key(line: str, error: str, tmp_path: Path) -> None:
    done = ran("parse", "--jsonl", "-", stdin=f"{line}\nStir soon\n".encode(), folder=tmp_path)
    first, second = map(json.loads, done.out.splitlines())
    assert (first["error"], second["error"], done.code) == (error, None, 0)


def test_parse_lists_the_keys_that_it_does_not_read(tmp_path: Path) -> None:
    lines = b'{"text": "Stir soon", "id": 7}\n{"text": "Stir soon"}\n'
    done = ran("parse", "--jsonl", "-", stdin=lines, folder=tmp_path)
    first, second = map(json.loads, done.out.splitlines())
    assert (first["ignored"], "ignored" in second) == (["id"], False)


def test_a_folder_is_not_followed(tmp_path: Path) -> None:
    done = ran("run", "-i", "Wave now", "--follow", str(tmp_path), folder=tmp_path)
    assert (done.code, "must be a file" in done.err) == (66, True)


def test_a_task_file_may_be_a_list_alone(tmp_path: Path) -> None:
    file = tmp_path / "task.yaml"
    file.write_text("- call Ann at six\n- {say: feed the cat, duration: 4 min}\n", encoding="utf-8")
    done = ran("plan", str(file), "--now", "2026-03-04T09:00", folder=tmp_path)
    assert "18:00 18:10 call Ann" in done.out
    assert "09:00 09:04 feed the cat" in done.out


def test_a_now_of_a_file_that_a_flag_overrules_must_be_one_all_the_same(tmp_path: Path) -> None:
    file = tmp_path / "task.yaml"
    file.write_text("now: tomorrow\ninstructions: [Stir the soup soon]\n", encoding="utf-8")
    done = ran("plan", str(file), "--now", "2026-03-04T09:00", folder=tmp_path)
    assert done.code == 65
    assert f"{file}:1:6: now: a date and time must look like 2026-03-04T09:00, got 'tomorrow'" in done.err


TASK = """
zone: Europe/Berlin
agents: 1
in_order: true
instructions: [Feed the cat in exactly 14 hours, Call mum in exactly 14 hours]
"""
SETTINGS = "zone: Asia/Tokyo\nagents: 2\nin_order: false\n"


@pytest.mark.parametrize(
    ("flags", "variables", "zone", "agents"),
    [
        ((), {}, "+02:00", 1),
        (("--zone", "Asia/Tokyo"), {}, "+09:00", 1),
        (("--agents", "2"), {}, "+02:00", 2),
        ((), {"FUZZYTIME_ZONE": "Asia/Tokyo"}, "+09:00", 1),
        ((), {"FUZZYTIME_CONFIG": "settings.yaml"}, "+02:00", 1),
    ],
)
def test_a_task_file_gives_way_to_flags_and_the_environment_only(
    flags: tuple[str, ...], variables: dict[str, str], zone: str, agents: int, tmp_path: Path
) -> None:
    task, settings = tmp_path / "task.yaml", tmp_path / "settings.yaml"
    task.write_text(TASK, encoding="utf-8")
    settings.write_text(SETTINGS, encoding="utf-8")
    variables = {name: text.replace("settings.yaml", str(settings)) for name, text in variables.items()}
    given = ("plan", str(task), "--now", "2026-03-28T20:00", "--format", "json", *flags)
    plan = json.loads(ran(*given, folder=tmp_path, stdin=b"", **variables).out)
    assert plan["agents"] == agents
    assert {skill["start"][-6:] for skill in plan["skills"]} == {zone}
    # Clocks change in Berlin that night, and fourteen hours stay fourteen hours.
    assert plan["skills"][0]["start_s"] == pytest.approx(14 * 3600, abs=900)


def test_settings_count_where_a_task_file_says_nothing(tmp_path: Path) -> None:
    task, settings = tmp_path / "task.yaml", tmp_path / "settings.yaml"
    task.write_text("instructions: [Feed the cat soon]", encoding="utf-8")
    settings.write_text(SETTINGS, encoding="utf-8")
    given = ("plan", str(task), "--now", "2026-03-28T20:00", "--format", "json")
    plan = json.loads(ran(*given, folder=tmp_path, FUZZYTIME_CONFIG=str(settings)).out)
    assert (plan["now"], plan["agents"]) == ("2026-03-28T20:00:00+09:00", 2)


def test_a_misspelt_variable_of_the_environment_is_refused(tmp_path: Path) -> None:
    done = ran(*SOUP, folder=tmp_path, FUZZYTIME_AGNTS="3")
    said = "environment FUZZYTIME_AGNTS: unknown setting (did you mean FUZZYTIME_AGENTS?)"
    assert (done.code, said in done.err) == (78, True)
    assert ran(*SOUP, folder=tmp_path, FUZZYTIME_SKILL_AGENT="3", FUZZYTIME_COLOUR="red").code == 0


def test_a_folder_is_no_settings_file(tmp_path: Path) -> None:
    done = ran(*SOUP, folder=tmp_path, FUZZYTIME_CONFIG=str(tmp_path))
    assert (done.code, "must be a file, and it is a folder" in done.err) == (78, True)


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("boil", "the", "eggs"), "fuzzytime plan -i 'boil the eggs'"),
        (("plann", "x"), "did you mean 'plan'"),
        (("explain", "boil", "the", "eggs"), "words stand in quotes: fuzzytime explain"),
        (("plan", "boil", "the", "eggs"), "say: -i"),
        (("plan", "-i", "boil", "the", "eggs"), "words stand in quotes: -i"),
        (("plan", "one.txt", "two.txt"), "fuzzytime batch"),
        (("plan", "-i", "boil the eggs", "-o", "plan.pdf"), "not written as .pdf"),
    ],
)
def test_who_types_words_as_they_come_is_told_how(
    arguments: tuple[str, ...], told: str, tmp_path: Path
) -> None:
    done = ran(*arguments, folder=tmp_path)
    assert done.code == Exit.USAGE
    assert told in done.err
    assert not list(tmp_path.iterdir())
