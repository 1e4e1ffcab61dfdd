"""`fuzzytime explain`: one instruction, from its words to its start."""

import os
import shlex
import sys
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fuzzytime_cli.exits import Exit
from fuzzytime_cli.faults import UsageError
from fuzzytime_cli.options import Moment, Solving, Understanding, flattened

if TYPE_CHECKING:
    from fuzzytime.interpreter import Plan


@flattened
def explain(
    text: Annotated[str, typer.Argument(help="An instruction.")],
    beside: Annotated[
        str | None,
        typer.Option("--beside", metavar="FILE", help="Plan it beside the instructions of a file."),
    ] = None,
    svg: Annotated[
        Path | None, typer.Option("--svg", metavar="FILE", help="Draw readings, forecast, μ and ψ to a file.")
    ] = None,
    *,
    moment: Moment,
    understanding: Understanding,
    solving: Solving,
) -> None:
    """Explain an instruction: tree, time requirement, rows and rules, satisfaction, and why then."""
    if os.path.isfile(text):  # noqa: PTH113 - a path raises on a long sentence
        raise UsageError(
            f"explain takes an instruction, got the file {text!r}: "
            f"fuzzytime explain 'one of its lines' --beside {shlex.quote(text)}"
        )
    from fuzzytime.interpreter import ProblemKind
    from fuzzytime_cli.assembly import Assembly
    from fuzzytime_cli.drawing.svg import chart_svg
    from fuzzytime_cli.explaining import chart_of, explanation_lines, reading_lines
    from fuzzytime_cli.files import replace_file
    from fuzzytime_cli.problems import is_fault, report_problem
    from fuzzytime_cli.render import Screen
    from fuzzytime_cli.requests import request_of

    assembly = Assembly.of(moment, understanding, solving)
    interpreter = assembly.interpreter()
    request = request_of(beside, [text], assembly, understanding, interpreter.rulebook.signals).named()
    made = assembly.plan(request, interpreter)
    asked = request.wishes[-1].identifier
    own = [place for place, interpreted in enumerate(made.everything) if interpreted.wish.identifier == asked]
    firsts = list(first_of_each(made, own))
    explained = {made.everything[position].identifier for position, _ in firsts}
    for problem in made.problems:
        # Why what is explained is rejected is told there.
        told = problem.kind is ProblemKind.REJECTED and problem.identifier in explained
        if problem.text == text.strip() and is_fault(problem) and not told:
            report_problem(problem, "fuzzytime")
    screen = Screen.of(sys.stdout, dict(os.environ))
    if not own:
        screen.write(*reading_lines(interpreter.language.read(text, now=request.now), screen.width))
        raise typer.Exit(Exit.BAD_DATA)
    for position, others in firsts:
        again = position != own[0]
        if again:
            screen.write("")
        screen.write(
            *explanation_lines(made, position, screen.width, unicode=screen.unicode, text_shown=again)
        )
        if others:
            screen.write("", f"and {others} more occurrences like it")
    if svg is not None:
        replace_file(svg, chart_svg(chart_of(made.everything[own[0]], made, own[0]), text))


def first_of_each(made: "Plan", positions: list[int]) -> Iterator[tuple[int, int]]:
    """Give the first skill of each instruction, with how many more occurrences there are of it."""
    for _, group in groupby(positions, lambda position: made.everything[position].instruction):
        first, *others = group
        yield first, len(others)
