"""`fuzzytime parse`: what is understood of texts, one JSON line each."""

import sys
from typing import Annotated

import typer

from fuzzytime_cli.options import Moment, flattened


@flattened
def parse(
    file: Annotated[str, typer.Argument(help="Texts a line, or - for standard input.")] = "-",
    jsonl: Annotated[  # noqa: FBT002 - a flag
        bool,
        typer.Option("--jsonl", help='Lines may be {"text": …, "now": …} objects; answers are JSON lines.'),
    ] = False,
    instruction: Annotated[
        list[str] | None, typer.Option("--instruction", "-i", metavar="TEXT", help="A text; repeatable.")
    ] = None,
    *,
    moment: Moment,
) -> None:
    """Show what is understood of each text: operation, time requirements, durations, as a JSON line.

    A line that cannot be read gets an "error", and the rest go on. The answers stand in the order of the lines.
    """
    from fuzzytime_cli.assembly import Assembly
    from fuzzytime_cli.inputs.source import open_lines
    from fuzzytime_cli.options import Solving, Understanding
    from fuzzytime_cli.parsing import answers

    assembly = Assembly.of(moment, Understanding(), Solving())
    language = assembly.language()
    now = assembly.moment()
    lines = iter(instruction) if instruction else open_lines(file)
    for answer in answers(lines, language, now, objects=jsonl and not instruction):
        sys.stdout.write(answer + "\n")
