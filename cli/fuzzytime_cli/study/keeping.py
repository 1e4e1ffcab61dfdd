"""Keeping answers: list them, set participants aside, bring them in and out."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fuzzytime_cli.faults import NoInputError, UsageError, report
from fuzzytime_cli.study.shared import Database, DesignFile, NewDatabase, now, opened, read_design

if TYPE_CHECKING:
    from fuzzytime.study import Design


def list_(
    database: Database,
    *,
    json: Annotated[bool, typer.Option("--json", help="One JSON object a line.")] = False,
) -> None:
    """List a study's participants, and who does not count and why."""
    import json as encoding
    import os

    from fuzzytime_cli.render import Screen
    from fuzzytime_cli.study.summary import participants

    with opened(database) as store:
        answers = store.answers()
    if not json:
        Screen.of(sys.stdout, dict(os.environ)).write(*participants(answers))
        return
    reasons = {entry.name: entry.reason for entry in answers.set_aside}
    for person in answers.participants:
        entry = {
            "participant": person.name,
            "actor": person.group,
            "origin": person.origin.value,
            "finished": person.finished,
            "curves": len(person.curves),
            "set_aside": reasons.get(person.name),
        }
        sys.stdout.write(encoding.dumps(entry, ensure_ascii=True) + "\n")


def exclude(
    database: Database,
    participant: Annotated[str, typer.Argument(help="The participant's name, as `list` shows it.")],
    *,
    reason: Annotated[str | None, typer.Option(help="Why, for the report.")] = None,
    undo: Annotated[bool, typer.Option("--undo", help="Let the participant count again.")] = False,
) -> None:
    """Exclude a participant for a reason, or take that back; the answers stay."""
    if undo == (reason is not None):
        raise UsageError("give either --reason TEXT or --undo")
    with opened(database) as store:
        store.exclude(participant, reason)
    report(f"{participant} {'counts again' if undo else 'is excluded'}")


def import_(
    file: Annotated[Path, typer.Argument(help="Answers as CSV or JSON; - reads JSON or CSV from a pipe.")],
    database: NewDatabase,
    *,
    design: DesignFile = None,
) -> None:
    """Add answers from CSV (one row per sample) or JSON to a study."""
    import io

    from fuzzytime.study import AnswerStore
    from fuzzytime.study.exchange import read_csv, read_json

    if str(file) != "-" and not file.is_file():
        raise NoInputError(f"{file}: there is no such file")
    raw = sys.stdin.buffer.read() if str(file) == "-" else file.read_bytes()
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw.count(b"\n", 0, error.start) + 1
        raise NoInputError(f"{file}:{line}: answers must be UTF-8") from error
    if text.lstrip()[:1] in ("{", "["):
        answers = read_json(text, str(file))
    else:
        answers = read_csv(io.StringIO(text, newline=""), _import_design(database, design), str(file))
    with AnswerStore.create(database, answers.design) as store:
        count = store.add(answers.participants, now())
    report(f"{count} participants added to {database}")


def _import_design(database: Path, design: Path | None) -> "Design":
    """Take the design that the study has, if it is there, else the one that is given."""
    if design is None and database.is_file() and database.stat().st_size:
        with opened(database) as store:
            return store.design
    return read_design(design)


def export(
    database: Database,
    *,
    csv: Annotated[bool, typer.Option("--csv", help="One row per sample (the default).")] = False,
    json: Annotated[bool, typer.Option("--json", help="One document, with the design.")] = False,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", help="A file; else standard output.")
    ] = None,
) -> None:
    """Write a study's answers as CSV or JSON."""
    import io

    from fuzzytime.study.exchange import write_csv, write_json
    from fuzzytime_cli.files import replace_file

    if csv and json:
        raise UsageError("give one of --csv and --json")
    with opened(database) as store:
        answers = store.answers()
    write = write_json if json else write_csv
    if output is None:
        write(answers, sys.stdout)
        return
    stream = io.StringIO()
    write(answers, stream)
    replace_file(output, stream.getvalue())
