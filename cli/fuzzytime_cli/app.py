"""The command `fuzzytime`: its commands, and the one place where errors become exit codes."""

import gc
import io
import os
import signal
import sys
from contextlib import suppress
from functools import partial
from typing import Annotated

import typer
from typer.exceptions import TyperException

from fuzzytime_cli import study
from fuzzytime_cli.commands import batch, config, doctor, explain, parse, plan, repl, rules
from fuzzytime_cli.commands import run as live
from fuzzytime_cli.exits import Exit
from fuzzytime_cli.faults import exit_of, report
from fuzzytime_cli.narrow import help_that_fits
from fuzzytime_cli.parameters import Command, Group

app = typer.Typer(
    name="fuzzytime",
    cls=Group,
    help=(
        "Turns what people say about time into the schedule that satisfies them most, and says why.\n\n"
        "Without a command it holds a conversation on a terminal, and plans what a pipe brings."
    ),
    epilog='To begin: fuzzytime plan -i "Boil the eggs in about five minutes"',
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"]},
)
command = partial(app.command, cls=Command)
command("plan", short_help="Print the best schedule, and how well each wish is satisfied.")(plan.plan)
command("explain", short_help="Show what was understood, which rules apply, and why then.")(explain.explain)
command("repl", short_help="Hold a conversation: the schedule follows as you type.")(repl.repl)
command("run", cls=live.CommandWithProgram, short_help="Carry a plan out, and replan as things happen.")(
    live.run
)
command("batch", short_help="Plan many task files: one JSON line each, in order.")(batch.batch)
command("parse", short_help="Show the operations and times of each text.")(parse.parse)
app.add_typer(rules.app, name="rules", short_help="Check rule tables; show what applies.")
app.add_typer(study.app, name="study", short_help="Ask people what they mean; plan with what they answer.")
app.add_typer(config.app, name="config", short_help="Show the settings, and where each comes from.")
command("doctor", short_help="Check the installation.")(doctor.doctor)


def _show_version(wanted: bool) -> None:  # noqa: FBT001 - Typer calls it with the flag's value
    if wanted:
        from fuzzytime_cli.release import installed_version

        print(f"fuzzytime {installed_version()}")  # noqa: T201
        raise typer.Exit


@app.callback()
def start(
    context: typer.Context,
    *,
    version: Annotated[
        bool, typer.Option("--version", callback=_show_version, is_eager=True, help="Show the version.")
    ] = False,
) -> None:
    """Open the conversation on a terminal, plan what a pipe brings elsewhere, unless a command is given."""
    del version
    if context.invoked_subcommand is not None:
        return
    if sys.stdin is not None and sys.stdin.isatty():
        from fuzzytime_cli.repl import converse

        converse()
    else:
        plan.plan(file="-")


def run(arguments: list[str]) -> int:
    """Run the command and give its exit code."""
    try:
        code = _called(arguments)
        if sys.stdout is not None:
            sys.stdout.flush()
    except BaseException as error:  # noqa: BLE001 - every error ends here, as a message and a code
        return exit_of(error)
    return code


def _called(arguments: list[str]) -> int:
    if arguments == ["--version"]:
        # What Typer reads options with takes longer to import than everything else that this needs.
        with suppress(typer.Exit):
            _show_version(wanted=True)
        return Exit.FINE
    try:
        with help_that_fits() as width:
            code = app(arguments, prog_name="fuzzytime", terminal_width=width, standalone_mode=False)
    except SystemExit as stop:
        # Typer ends so where the reader of a pipe has gone, and where a shell asks for completions.
        if isinstance(stop.__context__, BrokenPipeError):
            return Exit.CLOSED_PIPE
        return stop.code if isinstance(stop.code, int) else Exit.FINE
    except TyperException as error:
        from fuzzytime_cli.usage import usage_line

        report(usage_line(error, arguments))
        return error.exit_code
    return code or Exit.FINE


def main() -> None:
    """Run the command as the shell does."""
    _hold_closed_streams()
    _write_whatever_is_typed()
    code = run(sys.argv[1:])
    if code in {Exit.CLOSED_PIPE, Exit.IO_ERROR} and sys.stdout is not None:
        # What could not be written Python must not try to write again, and complain, on the way out.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    if code == Exit.INTERRUPT:
        signal.signal(signal.SIGINT, signal.SIG_IGN)
    gc.freeze()
    sys.exit(code)


def _hold_closed_streams() -> None:
    """Let what was closed by the shell (``>&-``) lead nowhere: no file that is opened may take its place."""
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # the lowest number that is free: this one
    if sys.stdout is None:
        sys.stdout = open(os.devnull, "w", encoding="utf-8")  # noqa: PTH123, SIM115 - as long as the process


def _write_whatever_is_typed() -> None:
    """Let a terminal that lacks a character show its number instead, and not end the command."""
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="backslashreplace")
