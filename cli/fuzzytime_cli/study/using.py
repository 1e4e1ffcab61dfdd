"""Using answers: analyse them, make a rule table of them."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fuzzytime_cli.faults import UsageError, report
from fuzzytime_cli.options import OutputFile
from fuzzytime_cli.study.shared import Database, opened

if TYPE_CHECKING:
    from fuzzytime.study.analysis.analyse import Analysis


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
    seed: Annotated[int, typer.Option(min=0, help="Repeats permutations and resamples.")] = 0,
) -> None:
    """Analyse a study: a summary here, and with --out a report in HTML, plots, and numbers as JSON."""
    import json as encoding
    import os

    from fuzzytime.study.analysis.analyse import FEWEST_RESAMPLES
    from fuzzytime.study.analysis.analyse import analyse as analysed
    from fuzzytime.study.reporting.numbers import numbers
    from fuzzytime_cli.render import Screen
    from fuzzytime_cli.study.summary import analysis as summary

    if 0 < resamples < FEWEST_RESAMPLES:
        raise UsageError(f"--resamples must be 0 or at least {FEWEST_RESAMPLES}, got {resamples}")
    with opened(database) as store:
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

    from fuzzytime.errors import FuzzytimeError
    from fuzzytime.study.reporting.numbers import numbers
    from fuzzytime.study.reporting.plots import figures, rendered
    from fuzzytime.study.reporting.report import report as page
    from fuzzytime_cli.files import replace_file

    folder.mkdir(parents=True, exist_ok=True)
    pictures: dict[str, bytes] = {}
    try:
        drawings = tuple(figures(found)) if plots else ()
    except FuzzytimeError as error:
        report(f"{error}; the report has no figures")
        drawings = ()
    for name, draw in drawings:
        pictures[name], bitmap = rendered(draw, "svg", "png")
        (folder / f"{name}.svg").write_bytes(pictures[name])
        (folder / f"{name}.png").write_bytes(bitmap)
    replace_file(folder / "numbers.json", encoding.dumps(numbers(found), allow_nan=False, indent=1) + "\n")
    replace_file(folder / "report.html", page(found, pictures))
    report(f"report in {folder / 'report.html'}")


def calibrate(
    database: Database,
    *,
    output: OutputFile = None,
    seed: Annotated[int, typer.Option(min=0, help="Repeats the test between groups.")] = 0,
) -> None:
    """Write the rule table that a study amounts to; `plan --rules` uses it."""
    import tempfile

    from fuzzytime.errors import DocumentError
    from fuzzytime.rulebook import check
    from fuzzytime.study import calibrate as calibrated
    from fuzzytime.study import rule_table
    from fuzzytime_cli.files import write_out

    with opened(database) as store:
        answers = store.answers()
    found = calibrated(answers, seed=seed)
    text = rule_table(found)
    with tempfile.TemporaryDirectory() as folder:
        draft = Path(folder) / "table.yaml"
        draft.write_text(text, encoding="utf-8")
        mistakes = check([draft])
    if mistakes:
        raise DocumentError(mistakes)
    write_out(output, text)
    for caution in found.cautions:
        report(f"caution: {caution}")
    if output is not None:
        report(f"{output} holds no mistake; use it by: plan --rules {output}")
