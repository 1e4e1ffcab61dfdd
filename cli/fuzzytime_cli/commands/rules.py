"""`fuzzytime rules`: check rule tables, and show what applies to a text."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from fuzzytime_cli.exits import Exit
from fuzzytime_cli.options import Moment, Solving, Understanding, flattened
from fuzzytime_cli.parameters import Command, Group

app = typer.Typer(
    cls=Group, help="Check rule tables and customs, and show what applies.", no_args_is_help=True
)


@app.command(cls=Command, short_help="Check rule tables and customs: every mistake at once, with its place.")
def check(
    files: Annotated[
        list[Path] | None,
        typer.Argument(help="Tables and customs; none checks the shipped ones and those of the settings."),
    ] = None,
) -> None:
    """Check rule tables and customs: every mistake at once, with file, line and column."""
    from fuzzytime_cli.assembly import Assembly, require_file
    from fuzzytime_cli.checks import table_mistakes
    from fuzzytime_cli.faults import NoInputError, report
    from fuzzytime_cli.render import plain

    assembly = Assembly.of(Moment(), Understanding(), Solving())
    chosen, missing = [], False
    for path in files or assembly.table_files():
        try:
            require_file(path, "table")
        except NoInputError as error:
            # The others are looked at all the same.
            report(f"fuzzytime: {error}")
            missing = True
        else:
            chosen.append(path)
    mistakes = table_mistakes(chosen)
    if mistakes:
        report("\n".join(map(str, mistakes)))
        report(f"{len(mistakes)} mistake{'s' * (len(mistakes) > 1)}")
        raise typer.Exit(Exit.BAD_CONFIG)
    if missing:
        raise typer.Exit(Exit.NO_INPUT)
    names = ", ".join(plain(str(path)) for path in chosen)
    sys.stdout.write(f"the shipped tables{' and ' * bool(names)}{names} hold no mistake\n")


@app.command(cls=Command, short_help="Show what applies to words about time.")
@flattened
def show(
    text: Annotated[str, typer.Argument(help='Words about time, such as "in about ten minutes".')],
    *,
    moment: Moment,
    understanding: Understanding,
) -> None:
    """Show which rows and rules apply to words about time, and the satisfaction they give."""
    import os

    from fuzzytime.interpreter import IN_THE_PLAN
    from fuzzytime_cli.assembly import Assembly
    from fuzzytime_cli.explaining import rules_lines
    from fuzzytime_cli.faults import UsageError
    from fuzzytime_cli.problems import report_problem
    from fuzzytime_cli.render import Screen
    from fuzzytime_cli.showing import shown_plan

    if not text.strip():
        raise UsageError("the words must not be empty")
    assembly = Assembly.of(moment, understanding, Solving())
    made = shown_plan(text, assembly, understanding)
    for problem in made.problems:
        # Of what has no time the lines below give the reason.
        if problem.kind not in IN_THE_PLAN:
            report_problem(problem, "fuzzytime")
    screen = Screen.of(sys.stdout, dict(os.environ))
    screen.write(*rules_lines(made, screen.width, unicode=screen.unicode))
    if not made.everything:
        raise typer.Exit(Exit.BAD_DATA)
