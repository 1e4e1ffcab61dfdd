"""`fuzzytime plan`: from instructions to the schedule that satisfies most."""

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fuzzytime_cli.choices import PlanFormat
from fuzzytime_cli.exits import Exit
from fuzzytime_cli.options import Instructions, Moment, OutputFile, Solving, Understanding, flattened

if TYPE_CHECKING:
    from fuzzytime.interpreter import Plan
    from fuzzytime.scheduling import Limits


@flattened
def plan(
    file: Annotated[
        str | None,
        typer.Argument(
            help="Instructions, one a line; a YAML task file; or - for standard input, as without both."
        ),
    ] = None,
    instruction: Instructions = None,
    output_format: Annotated[
        PlanFormat | None,
        typer.Option(
            "--format", help="What to write; if not given, what the name after -o ends in, or a table."
        ),
    ] = None,
    output: OutputFile = None,
    *,
    strict: Annotated[
        bool,
        typer.Option("--strict", help="Exit with 65 if a line cannot be read; the rest is planned anyway."),
    ] = False,
    moment: Moment,
    understanding: Understanding,
    solving: Solving,
) -> None:
    """Plan instructions: print the best schedule and how well each wish is satisfied."""
    from fuzzytime_cli.assembly import Assembly
    from fuzzytime_cli.faults import report
    from fuzzytime_cli.inputs.source import STDIN, is_piped
    from fuzzytime_cli.patience import told
    from fuzzytime_cli.problems import exit_of_plan, report_problems
    from fuzzytime_cli.requests import request_of

    if file is None and not instruction and is_piped():
        file = STDIN
    chosen = output_format or PlanFormat.written_to(output)
    if output_format is None and PlanFormat.is_guessed(output):
        report(f"fuzzytime: {output}: no format has this ending, so that a table is written (see: --format)")
    assembly = Assembly.of(moment, understanding, solving)
    interpreter = assembly.interpreter()
    request = request_of(file, instruction or [], assembly, understanding, interpreter.rulebook.signals)
    count = len(request.wishes)
    with told(f"planning {count:,} instruction{'' if count == 1 else 's'}"):
        made = assembly.plan(request, interpreter)
    shown = output is None and chosen is PlanFormat.TABLE
    report_problems(made, file or "-i", shown=shown)
    write_plan(made, chosen, output, assembly.limits())
    code = exit_of_plan(made, strict=strict)
    if code != Exit.FINE:
        raise typer.Exit(code)


def write_plan(made: "Plan", output_format: PlanFormat, output: Path | None, limits: "Limits") -> None:
    """Write a plan, made under some limits, to a file, whole or not at all, or to standard output."""
    from fuzzytime_cli.formats import written
    from fuzzytime_cli.formats.reasons import explaining
    from fuzzytime_cli.render import Screen

    seconds = explaining(limits)
    if output is None and output_format is PlanFormat.TABLE:
        from fuzzytime_cli.formats.table import PlanView

        screen = Screen.of(sys.stdout, dict(os.environ))
        screen.write(*PlanView(made, screen.width, unicode=screen.unicode, seconds=seconds).lines())
        return
    from fuzzytime_cli.files import write_out

    write_out(output, written(made, output_format, seconds=seconds))
