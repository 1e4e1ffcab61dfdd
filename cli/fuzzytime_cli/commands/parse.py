"""`fuzzytime parse`: what is understood of texts."""

import json
import os
import sys
from itertools import chain
from typing import Annotated

import typer

from fuzzytime_cli.exits import Exit
from fuzzytime_cli.options import Customs, Instructions, Moment, Solving, Understanding, flattened

COMMENT = b"#"


@flattened
def parse(
    file: Annotated[
        str | None,
        typer.Argument(
            help="Texts, one a line, and without --jsonl # comments; or - for standard input, as without "
            "file and -i."
        ),
    ] = None,
    jsonl: Annotated[  # noqa: FBT002 - a flag
        bool, typer.Option("--jsonl", help='Answer JSON lines; lines may be {"text": …, "now": …} objects.')
    ] = False,
    instruction: Instructions = None,
    customs: Customs = None,
    *,
    strict: Annotated[
        bool,
        typer.Option(
            "--strict",
            help="Exit with 65 if a line cannot be read or understood; the rest is answered anyway.",
        ),
    ] = False,
    moment: Moment,
) -> None:
    """Show what is understood of each text: operations, time requirements, durations.

    A line that cannot be read gets an error, and the rest go on; answers stand in the order of the lines. If
    no line can be read, it exits with 65.
    """
    from fuzzytime_cli.assembly import Assembly
    from fuzzytime_cli.inputs.source import open_stream
    from fuzzytime_cli.parsing import Tally, answers, asked_of, lines_of, readable
    from fuzzytime_cli.render import Screen, plain

    assembly = Assembly.of(moment, Understanding(customs=customs), Solving())
    language, now = assembly.language(), assembly.moment()
    texts = [text.encode("utf-8", "replace") for text in instruction or ()]
    screen, tally = Screen.of(sys.stdout, dict(os.environ)), Tally()
    with open_stream(file or ("-" if not texts else None)) as stream:
        # Who counts answers by lines wants one for each.
        lines = (line for line in lines_of(stream) if jsonl or not line.lstrip().startswith(COMMENT))
        asked = (asked_of(line, now, objects=jsonl, zone=assembly.zone) for line in chain(lines, texts))
        for reply in answers(asked, language):
            tally.count(reply)
            if jsonl:
                sys.stdout.write(json.dumps(reply.answer, allow_nan=False) + "\n")
            else:
                screen.write(*map(plain, readable(reply, screen.width if screen.interactive else None)))
    if tally.nothing_read or (strict and tally.doubtful):
        raise typer.Exit(Exit.BAD_DATA)
