"""Keeping answers: list them, set participants aside, bring them in and out."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from fuzzytime_cli.faults import NoInputError, UsageError, report
from fuzzytime_cli.options import OutputFile
from fuzzytime_cli.study.shared import Database, DesignFile, NewDatabase, design_of, now, opened

MAX_BYTES = 1 << 30
"""Bytes of answers that are read: a thousand participants take about 750 MB as CSV."""


def list_(
    database: Database,
    *,
    json: Annotated[bool, typer.Option("--json", help="One JSON object a line.")] = False,
) -> None:
    """List a study's participants, with who does not count and why."""
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
    from fuzzytime.study.answers.as_csv import read_csv
    from fuzzytime.study.answers.as_json import read_json
    from fuzzytime_cli.inputs.source import read_exactly

    source = read_exactly(str(file), MAX_BYTES)
    if not source.text.strip():
        raise NoInputError(f"{source.name}: must hold answers, and it is empty")
    if source.text.lstrip()[:1] in ("{", "["):
        answers = read_json(source.text, source.name)
    else:
        rows = io.StringIO(source.text, newline="")
        answers = read_csv(rows, design_of(database, design), source.name)
    with AnswerStore.create(database, answers.design) as store:
        count = store.add(answers.participants, now())
    report(f"{count} participant{'s' * (count != 1)} added to {database}")


def ratings(
    *,
    rules: Annotated[
        bool, typer.Option("--rules", help="The table that follows from them, as a rule file.")
    ] = False,
    json: Annotated[bool, typer.Option("--json", help="One rating a line.")] = False,
    output: OutputFile = None,
) -> None:
    """Show or export your own ratings of starts (`:rate` in a conversation), and what follows from them."""
    import json as encoding

    from fuzzytime_cli.files import write_out
    from fuzzytime_cli.personal import kept_ratings, personal_table, rating_line
    from fuzzytime_cli.places import data_folder
    from fuzzytime_cli.render import plain

    if rules and json:
        raise UsageError("give one of --rules and --json")
    kept = kept_ratings(data_folder())
    if not kept:
        raise NoInputError("there are no ratings yet: rate a start in a conversation by :rate")
    if json:
        lines = [
            encoding.dumps({"skill": one.name, "start": one.start.isoformat(), **encoding.loads(one.rating)})
            for one in kept
        ]
        write_out(output, "".join(f"{line}\n" for line in lines))
    elif rules:
        write_out(output, personal_table(kept).yaml)
    else:
        lines = [*map(rating_line, kept), *personal_table(kept).lines]
        write_out(output, "".join(f"{plain(line)}\n" for line in lines))


def export(
    database: Database,
    *,
    csv: Annotated[bool, typer.Option("--csv", help="One row per sample (the default).")] = False,
    json: Annotated[bool, typer.Option("--json", help="One document, with the design.")] = False,
    output: OutputFile = None,
) -> None:
    """Write a study's answers as CSV or JSON."""
    import io

    from fuzzytime.study.answers.as_csv import write_csv
    from fuzzytime.study.answers.as_json import write_json
    from fuzzytime_cli.files import write_out

    if csv and json:
        raise UsageError("give one of --csv and --json")
    with opened(database) as store:
        answers = store.answers()
    write = write_json if json else write_csv
    stream = io.StringIO()
    write(answers, stream)
    write_out(output, stream.getvalue())
