"""`fuzzytime batch`: many task files, an answer each."""

from pathlib import Path
from typing import Annotated

import typer

from fuzzytime_cli.choices import BatchBackend
from fuzzytime_cli.exits import Exit
from fuzzytime_cli.options import Moment, Solving, Understanding, flattened, unless_dash


@flattened
def batch(
    paths: Annotated[
        list[Path],
        typer.Argument(metavar="DIR|FILE…", help="Task files, and folders of them (.txt, .yaml, .yml)."),
    ],
    jobs: Annotated[
        int | None,
        typer.Option(
            metavar="N",
            min=1,
            max=10_000,
            help="How many at once; if not given, as many as there are processors.",
        ),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "--output",
            "-o",
            metavar="FILE",
            callback=unless_dash,
            help="Write the answers to a file, as they are found; - is standard output.",
        ),
    ] = None,
    backend: Annotated[
        BatchBackend, typer.Option(help="Where to work: processes (loky) or threads here, or a cluster.")
    ] = BatchBackend.LOKY,
    scheduler: Annotated[
        str | None, typer.Option(metavar="ADDRESS", help="Where the cluster is, such as tcp://host:8786.")
    ] = None,
    *,
    resume: Annotated[
        bool,
        typer.Option(
            "--resume", help="Go on with -o FILE: files that it answers already are not planned again."
        ),
    ] = False,
    strict: Annotated[
        bool,
        typer.Option("--strict", help="Exit with the first error's code where a file cannot be planned."),
    ] = False,
    moment: Moment,
    understanding: Understanding,
    solving: Solving,
) -> None:
    """Plan many task files: one JSON line each, in order, with its plan or its error."""
    from fuzzytime_cli.assembly import Assembly
    from fuzzytime_cli.batch.answers import recipe_of
    from fuzzytime_cli.batch.backends import Workers
    from fuzzytime_cli.batch.files import task_files
    from fuzzytime_cli.batch.start import run
    from fuzzytime_cli.faults import UsageError

    if resume and output is None:
        raise UsageError("--resume needs -o FILE: the answers so far")
    assembly = Assembly.of(moment, understanding, solving)
    files = task_files(paths)
    recipe = recipe_of(assembly, understanding)
    code = run(files, recipe, Workers(backend, jobs, scheduler), output, resume=resume, strict=strict)
    if code is not Exit.FINE:
        raise typer.Exit(code)
