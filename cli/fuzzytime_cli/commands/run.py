"""`fuzzytime run`: a plan carried out in time."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fuzzytime_cli.choices import RunFormat
from fuzzytime_cli.exits import Exit
from fuzzytime_cli.options import Instructions, Moment, Solving, TaskFile, Understanding, flattened
from fuzzytime_cli.parameters import Command

if TYPE_CHECKING:
    import typer._click as click


class CommandWithProgram(Command):
    """A command whose option ``--exec`` takes everything that follows, as that of ``find`` does."""

    def parse_args(self, ctx: "click.Context", args: list[str]) -> list[str]:
        """Give each word after ``--exec`` as a value of it."""
        if "--exec" in args:
            at = args.index("--exec")
            words = args[at + 1 :]
            args = [*args[:at], *([f"--exec={word}" for word in words] or ["--exec"])]
        return super().parse_args(ctx, args)


@flattened
def run(
    file: TaskFile = None,
    instruction: Instructions = None,
    follow: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Read lines from a file that may grow, instead of standard input."),
    ] = None,
    speed: Annotated[
        float, typer.Option(min=0.01, max=10_000, help="How many seconds of the run pass in one real second.")
    ] = 1.0,
    limit: Annotated[
        str | None,
        typer.Option(
            metavar="DURATION",
            help="Kill a command after this time; by default, three times its planned time, at least 1 min.",
        ),
    ] = None,
    output_format: Annotated[
        RunFormat | None,
        typer.Option("--format", help="If not given, text on a terminal and JSON lines elsewhere."),
    ] = None,
    program: Annotated[
        list[str] | None,
        typer.Option(
            "--exec",
            metavar="PROGRAM ARG…",
            help="Last: a command to run for each skill, without a shell; {name}, {id} … are filled in.",
        ),
    ] = None,
    *,
    simulate: Annotated[
        bool, typer.Option("--simulate", help="Run at once, without waiting, and the same each time.")
    ] = False,
    wait_for_done: Annotated[
        bool, typer.Option("--wait-for-done", help='A skill goes on until a line {"done": ID} comes.')
    ] = False,
    stay: Annotated[
        bool, typer.Option("--stay", help="When all is done, wait for further instructions.")
    ] = False,
    moment: Moment,
    understanding: Understanding,
    solving: Solving,
) -> None:
    """Carry out a plan in time: tell each start, or run a command, and re-plan when something matters."""
    from fuzzytime_cli.assembly import Assembly
    from fuzzytime_cli.faults import UsageError
    from fuzzytime_cli.inputs.source import STDIN, is_piped
    from fuzzytime_cli.live import programs
    from fuzzytime_cli.live.start import Settings
    from fuzzytime_cli.live.start import run as carried_out
    from fuzzytime_cli.requests import request_from, request_of

    if wait_for_done and program:
        raise UsageError("--wait-for-done and --exec: a skill ends by word or with its command, not both")
    if simulate and speed != 1:
        raise UsageError("--simulate and --speed: a simulated run is as fast as can be")
    if limit is not None and not program:
        raise UsageError("--limit needs --exec PROGRAM: what it may end")
    listens = file != STDIN and is_piped()
    if wait_for_done and not listens and follow is None:
        raise UsageError("--wait-for-done needs somebody to say so: a pipe, or --follow FILE")
    settings = Settings(
        speed=None if simulate else speed,
        command=programs.Command.of(program) if program else None,
        limit=_limit(limit),
        by_word=wait_for_done,
        stay=stay,
        follow=follow,
        listen=listens,
    )
    assembly = Assembly.of(moment, understanding, solving)
    interpreter = assembly.interpreter()
    signals = interpreter.rulebook.signals
    if stay and file is None:
        request = request_from(None, instruction or [], assembly, understanding, signals)
    else:
        request = request_of(file, instruction or [], assembly, understanding, signals)
    code = carried_out(
        request,
        interpreter,
        assembly.solver(),
        assembly.settings.number("threshold"),
        assembly.limits(),
        settings,
        output_format,
    )
    if code is not Exit.FINE:
        raise typer.Exit(code)


def _limit(text: str | None) -> float | None:
    from fuzzytime.times import parse_duration
    from fuzzytime_cli.faults import UsageError, as_usage

    if text is None:
        return None
    with as_usage("--limit"):
        limit = parse_duration(text)
    if limit <= 0:
        raise UsageError(f"--limit: must be above 0, got {text!r}")
    return limit
