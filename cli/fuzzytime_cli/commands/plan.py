"""`fuzzytime plan`: from instructions to the schedule that satisfies most."""

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fuzzytime_cli.choices import PlanFormat
from fuzzytime_cli.exits import Exit
from fuzzytime_cli.options import (
    Instructions,
    Moment,
    OutputFile,
    Solving,
    Understanding,
    flattened,
)

if TYPE_CHECKING:
    from collections.abc import Mapping

    from fuzzytime.context import Signal
    from fuzzytime.interpreter import Plan, Problem, Request
    from fuzzytime.scheduling import Limits
    from fuzzytime_cli.assembly import Assembly
    from fuzzytime_cli.inputs.source import Source

MOST_REJECTED = 20
"""Of what is rejected, so many are said one by one on standard error."""


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
    from fuzzytime_cli.inputs.source import STDIN, is_piped
    from fuzzytime_cli.patience import told

    if file is None and not instruction and is_piped():
        file = STDIN
    chosen = output_format or PlanFormat.written_to(output)
    assembly = Assembly.of(moment, understanding, solving)
    interpreter = assembly.interpreter()
    request = request_of(file, instruction or [], assembly, understanding, interpreter.rulebook.signals)
    count = len(request.wishes)
    with told(f"planning {count:,} instruction{'' if count == 1 else 's'}"):
        made = assembly.plan(request, interpreter)
    report_problems(made, file or "-i")
    write_plan(made, chosen, output, assembly.limits())
    code = exit_of_plan(made, strict=strict)
    if code != Exit.FINE:
        raise typer.Exit(code)


def request_of(
    file: str | None,
    instructions: list[str],
    assembly: "Assembly",
    understanding: Understanding,
    signals: "Mapping[str, Signal]",
) -> "Request":
    """Read a file and ``-i`` instructions into a request; flags win over the file."""
    from fuzzytime_cli.faults import UsageError
    from fuzzytime_cli.inputs.source import read_source

    if file is None and not instructions:
        raise UsageError("say what to plan: a file, - for standard input, or -i TEXT")
    if not all(map(str.strip, instructions)):
        raise UsageError("an instruction must not be empty")
    source = read_source(file) if file is not None else None
    return request_from(source, instructions, assembly, understanding, signals)


def request_from(
    source: "Source | None",
    instructions: list[str],
    assembly: "Assembly",
    understanding: Understanding,
    signals: "Mapping[str, Signal]",
) -> "Request":
    """Make a request of a source, read before, and of instructions; flags win over what it says."""
    from dataclasses import replace

    from fuzzytime.interpreter import Request, SpokenWish
    from fuzzytime_cli.inputs.lines import wishes_of
    from fuzzytime_cli.inputs.task_file import Surroundings, is_task_file, read_task_file

    now = assembly.moment()
    request = Request(
        now=now,
        wishes=(),
        agents=int(assembly.settings.number("agents")),
        horizon=assembly.horizon(),
        in_order=assembly.settings.flag("in_order"),
    )
    if source is not None:
        if is_task_file(source):
            from fuzzytime_cli.inputs.calendar import read_calendar

            folder = source.path.parent if source.path is not None else Path()
            surroundings = Surroundings(
                assembly.now,
                assembly.given(asked=True),
                assembly.given(asked=False),
                now,
                lambda name, moment, ahead: read_calendar(folder / name, moment, ahead),
                signals,
            )
            request = read_task_file(source, surroundings)
        else:
            request = replace(request, wishes=wishes_of(source, now))
    spoken = tuple(SpokenWish(text=text.strip(), given=request.now) for text in instructions)
    context = assembly.context(understanding, request.now, signals)
    return replace(request, wishes=(*request.wishes, *spoken), context=request.context.merged(context))


def report_problems(made: "Plan", source: str) -> None:
    """Say on standard error which lines were not understood, with their words underlined.

    Of many that are rejected the first are said one by one: whatever is written tells the others.
    """
    from fuzzytime.interpreter import ProblemKind
    from fuzzytime_cli.faults import report

    name = "<stdin>" if source == "-" else source
    faults = [problem for problem in made.problems if is_fault(problem)]
    rejected = [problem for problem in faults if problem.kind is ProblemKind.REJECTED]
    untold = frozenset(rejected[MOST_REJECTED:] if len(rejected) > MOST_REJECTED + 1 else ())
    for problem in faults:
        if problem not in untold:
            report_problem(problem, name)
    if untold:
        report(f"{'fuzzytime' if source == '-i' else name}: {len(untold)} more are rejected")


def report_problem(problem: "Problem", source: str) -> None:
    """Say one problem on standard error."""
    from fuzzytime_cli.faults import report, underlined

    place = f"{source}:{problem.line}" if problem.line is not None else "fuzzytime"
    if problem.span is not None and problem.text:
        report(f"{place}: {problem.message}")
        sys.stderr.write(underlined(problem.text, problem.span) + "\n")
    else:
        report(f"{place}: {problem.message}")


def is_fault(problem: "Problem") -> bool:
    """Say whether a problem means that something asked for cannot be in the schedule as asked."""
    from fuzzytime.interpreter import ProblemKind

    return problem.kind not in {ProblemKind.NOTE, ProblemKind.WAITS}


def exit_of_plan(made: "Plan", *, strict: bool) -> Exit:
    """Give the exit code of a plan: bad data where nothing, or under ``--strict`` not all, could be read."""
    from fuzzytime.interpreter import IN_THE_PLAN
    from fuzzytime.scheduling import Status

    unread = [problem for problem in made.problems if problem.kind not in IN_THE_PLAN]
    if unread and (strict or not made.everything):
        return Exit.BAD_DATA
    return Exit.INFEASIBLE if made.schedule.certificate.status is Status.INFEASIBLE else Exit.FINE


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
