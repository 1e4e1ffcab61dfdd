"""The study's commands: serve, simulate, import, export, list, exclude, analyse, calibrate."""

import sys
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fuzzytime_cli.choices import ProfileChoice
from fuzzytime_cli.faults import NoInputError, UsageError, report

if TYPE_CHECKING:
    from fuzzytime.study import AnswerStore, Design
    from fuzzytime.study.analysis import Analysis

app = typer.Typer(
    help="Collect what people draw, analyse it, and make a rule table of it.", no_args_is_help=True
)

Database = Annotated[
    Path, typer.Argument(metavar="ANSWERS", help="The study's file, such as answers.sqlite.")
]
NewDatabase = Annotated[
    Path, typer.Option("--db", help="The study's file; it is begun where it is not there.")
]
DesignFile = Annotated[
    Path | None, typer.Option("--design", help="The study's design (YAML); the paper's if none is given.")
]


def _design(path: Path | None) -> "Design":
    """Read a design file, or the shipped one."""
    from fuzzytime.study import Design

    if path is None:
        return Design.shipped()
    if not path.is_file():
        raise NoInputError(f"{path}: there is no such design")
    return Design.of_file(path)


def _opened(path: Path) -> "AnswerStore":
    """Open a study's file that must be there."""
    from fuzzytime.study import AnswerStore

    if not path.is_file():
        raise NoInputError(f"{path}: there is no such study")
    return AnswerStore.open(path)


def _now() -> str:
    return datetime.now(UTC).isoformat(timespec="seconds")


@app.command()
def serve(
    design: Annotated[
        Path | None, typer.Argument(help="The study's design (YAML); the paper's if none is given.")
    ] = None,
    *,
    database: NewDatabase,
    host: Annotated[
        str, typer.Option(help="Where to listen. Anything but loopback lets others reach the page.")
    ] = "127.0.0.1",
    port: Annotated[int, typer.Option(min=0, max=65535, help="0 takes a free one.")] = 8765,
    name: Annotated[
        list[str] | None, typer.Option("--name", help="Another host name by which people reach the page.")
    ] = None,
    browse: Annotated[bool, typer.Option("--open", help="Open the page in this computer's browser.")] = False,
) -> None:
    """Serve the page on which people draw, until Ctrl-C; every acknowledged answer is on the disk."""
    import secrets
    import signal

    from fuzzytime.study import AnswerStore
    from fuzzytime.study.server import StudyServer
    from fuzzytime.study.service import StudyService

    with AnswerStore.create(database, _design(design)) as store:
        service = StudyService(store, _now, lambda: secrets.token_urlsafe(12))
        token = store.token(secrets.token_urlsafe(16))
        with StudyServer((host, port), service, token, names=tuple(name or ()), tell=report) as server:
            if host not in ("127.0.0.1", "localhost", "::1"):
                report("the page can be reached from other computers; its traffic is not encrypted")
            signal.signal(signal.SIGTERM, _stop)
            try:
                report(f"{store.design.title}: give participants the address below; Ctrl-C ends")
                sys.stdout.write(f"{server.url}\n")
                sys.stdout.flush()
                if browse:
                    typer.launch(server.url)
                server.serve_forever()
            except KeyboardInterrupt:
                report(f"stopped, with {len(store.answers().participants)} participants in {database}")


def _stop(_number: int, _frame: object) -> None:
    """Stop as Ctrl-C does, where the system asks to."""
    raise KeyboardInterrupt


@app.command()
def simulate(
    database: NewDatabase,
    *,
    participants: Annotated[int, typer.Option(min=1, max=10_000, help="How many people to invent.")] = 32,
    seed: Annotated[int, typer.Option(min=0, help="The same seed gives the same answers.")] = 0,
    truth: Annotated[
        Path | None,
        typer.Option(help="What people mean: a rule table, or a function for each instruction (YAML)."),
    ] = None,
    profile: Annotated[
        ProfileChoice, typer.Option(help="The shipped table that the truth starts from.")
    ] = ProfileChoice.STUDY,
    by_actor: Annotated[
        bool, typer.Option("--by-actor", help="Let groups mean what the table's actors give them.")
    ] = False,
    individual: Annotated[
        float, typer.Option(min=0.0, help="Spread (standard deviation of the logarithm) of people's widths.")
    ] = 0.2,
    group_effect: Annotated[
        float,
        typer.Option(min=0.05, max=20.0, help="How many times as wide the last group draws as the first."),
    ] = 1.0,
    hand_time: Annotated[float, typer.Option(min=0.0, help="The hand's error in time, in seconds.")] = 2.0,
    hand_satisfaction: Annotated[
        float, typer.Option(min=0.0, max=1.0, help="The hand's error in satisfaction.")
    ] = 0.01,
    inattentive: Annotated[int, typer.Option(min=0, help="How many people do not attend.")] = 0,
    design: DesignFile = None,
) -> None:
    """Invent participants with a known truth, and add their answers to a study."""
    from fuzzytime.rulebook import Profile
    from fuzzytime.study import AnswerStore, Hand, Population
    from fuzzytime.study import simulate as invented
    from fuzzytime_cli.study.truth import read_truth

    if truth is not None and not truth.is_file():
        raise NoInputError(f"{truth}: there is no such truth")
    chosen = _design(design)
    groups = list(chosen.groups)
    widths = {groups[0]: group_effect**-0.5, groups[-1]: group_effect**0.5} if len(groups) > 1 else None
    answers = invented(
        chosen,
        read_truth(chosen, truth, Profile(profile.value), by_actor=by_actor),
        participants,
        seed=seed,
        population=Population(
            individual=individual,
            group_widths=widths,
            inattentive=inattentive,
            hand=Hand(time=hand_time, satisfaction=hand_satisfaction),
        ),
    )
    with AnswerStore.create(database, chosen) as store:
        count = store.add(answers.participants, _now())
    report(f"{count} simulated participants added to {database}")


@app.command("import")
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
        count = store.add(answers.participants, _now())
    report(f"{count} participants added to {database}")


def _import_design(database: Path, design: Path | None) -> "Design":
    """Take the design that the study has, if it is there, else the one that is given."""
    if design is None and database.is_file() and database.stat().st_size:
        with _opened(database) as store:
            return store.design
    return _design(design)


@app.command()
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
    with _opened(database) as store:
        answers = store.answers()
    write = write_json if json else write_csv
    if output is None:
        write(answers, sys.stdout)
        return
    stream = io.StringIO()
    write(answers, stream)
    replace_file(output, stream.getvalue())


@app.command("list")
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

    with _opened(database) as store:
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


@app.command()
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
    with _opened(database) as store:
        store.exclude(participant, reason)
    report(f"{participant} {'counts again' if undo else 'is excluded'}")


@app.command()
def analyse(
    database: Database,
    *,
    out: Annotated[Path | None, typer.Option("--out", help="A folder for report, plots and numbers.")] = None,
    json: Annotated[bool, typer.Option("--json", help="Write the numbers as JSON, not the summary.")] = False,
    plots: Annotated[
        bool, typer.Option(help="Draw the figures (needs matplotlib) where --out is given.")
    ] = True,
    permutations: Annotated[
        int, typer.Option(min=1, max=1_000_000, help="Permutations of the test between groups.")
    ] = 999,
    resamples: Annotated[
        int, typer.Option(min=0, max=100_000, help="Bootstrap samples for intervals of corners; 0 for none.")
    ] = 0,
    seed: Annotated[int, typer.Option(min=0, help="Of permutations and resamples.")] = 0,
) -> None:
    """Analyse a study: a summary here, and with --out a report in HTML, plots, and numbers as JSON."""
    import json as encoding
    import os

    from fuzzytime.study.analysis import analyse as analysed
    from fuzzytime.study.numbers import numbers
    from fuzzytime_cli.render import Screen
    from fuzzytime_cli.study.summary import analysis as summary

    with _opened(database) as store:
        answers = store.answers()
    found = analysed(answers, permutations=permutations, resamples=resamples, seed=seed)
    if json:
        sys.stdout.write(encoding.dumps(numbers(found), ensure_ascii=True, allow_nan=False) + "\n")
    else:
        Screen.of(sys.stdout, dict(os.environ)).write(*summary(found))
    sys.stdout.flush()
    if out is not None:
        _write_report(out, found, plots=plots)


def _write_report(folder: Path, found: "Analysis", *, plots: bool) -> None:
    import json as encoding

    from fuzzytime.study.numbers import numbers
    from fuzzytime.study.plots import figures, rendered
    from fuzzytime.study.report import report as page
    from fuzzytime_cli.files import replace_file

    folder.mkdir(parents=True, exist_ok=True)
    pictures: dict[str, bytes] = {}
    for name, draw in figures(found) if plots else ():
        pictures[name], bitmap = rendered(draw, "svg", "png")
        (folder / f"{name}.svg").write_bytes(pictures[name])
        (folder / f"{name}.png").write_bytes(bitmap)
    replace_file(folder / "numbers.json", encoding.dumps(numbers(found), allow_nan=False, indent=1) + "\n")
    replace_file(folder / "report.html", page(found, pictures))
    report(f"report in {folder / 'report.html'}")


@app.command()
def calibrate(
    database: Database,
    *,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", help="A file; else standard output.")
    ] = None,
    seed: Annotated[int, typer.Option(min=0, help="Of the test between groups.")] = 0,
) -> None:
    """Write the rule table that a study amounts to; `plan --rules` uses it."""
    import tempfile

    from fuzzytime.errors import DocumentError
    from fuzzytime.rulebook import check
    from fuzzytime.study import calibrate as calibrated
    from fuzzytime.study import rule_table
    from fuzzytime_cli.files import replace_file

    with _opened(database) as store:
        answers = store.answers()
    text = rule_table(calibrated(answers, seed=seed))
    with tempfile.TemporaryDirectory() as folder:
        draft = Path(folder) / "table.yaml"
        draft.write_text(text, encoding="utf-8")
        mistakes = check([draft])
    if mistakes:
        raise DocumentError(mistakes)
    if output is None:
        sys.stdout.write(text)
        return
    replace_file(output, text)
    report(f"{output} holds no mistake; use it by: plan --rules {output}")
