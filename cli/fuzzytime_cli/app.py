"""The command `fuzzytime`: its commands, and the one place where errors become exit codes."""

import gc
import io
import os
import signal
import sys
from collections.abc import Iterator, Mapping
from contextlib import suppress
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer.exceptions import TyperException
from typer.main import get_group

from fuzzytime_cli.exits import Exit
from fuzzytime_cli.faults import exit_of, report
from fuzzytime_cli.narrow import help_that_fits
from fuzzytime_cli.parameters import Command, Group

if TYPE_CHECKING:
    import typer._click as click

COMMANDS = {
    "plan": ("fuzzytime_cli.commands.plan", "Print the best schedule, and how well each wish is satisfied."),
    "explain": (
        "fuzzytime_cli.commands.explain",
        "Show what was understood, which rules apply, and why then.",
    ),
    "repl": ("fuzzytime_cli.commands.repl", "Hold a conversation: the schedule follows as you type."),
    "run": ("fuzzytime_cli.commands.run", "Carry a plan out, and replan as things happen."),
    "batch": ("fuzzytime_cli.commands.batch", "Plan many task files: one JSON line each, in order."),
    "parse": ("fuzzytime_cli.commands.parse", "Show the operations and times of each text."),
    "doctor": ("fuzzytime_cli.commands.doctor", "Check the installation."),
    "rules": ("fuzzytime_cli.commands.rules", "Check rule tables; show what applies."),
    "study": ("fuzzytime_cli.study", "Ask people what they mean; plan with what they answer."),
    "config": ("fuzzytime_cli.commands.config", "Show the settings, and where each comes from."),
}
"""Where each command is, and what it does in a line."""


class Commands(Mapping[str, "click.Command"]):
    """The commands by name, each imported when it is asked for: none waits for the others."""

    def __getitem__(self, name: str) -> "click.Command":
        return _made(name, *COMMANDS[name])

    def __iter__(self) -> Iterator[str]:
        return iter(COMMANDS)

    def __len__(self) -> int:
        return len(COMMANDS)


@cache
def _made(name: str, module: str, summary: str) -> "click.Command":
    """Give the command that a module's function of its name is, or that its app of several is."""
    home = import_module(module)
    alone = typer.Typer(rich_markup_mode=None)
    if hasattr(home, "app"):
        alone.add_typer(home.app, name=name, short_help=summary)
    else:
        kind = getattr(home, "CommandWithProgram", Command)
        alone.command(name, cls=kind, short_help=summary)(getattr(home, name))
    return get_group(alone).commands[name]


class Program(Group):
    """The command `fuzzytime`."""

    def __init__(self, **given: Any) -> None:  # noqa: ANN401 - what a group of Typer's takes
        super().__init__(**{**given, "commands": Commands()})


app = typer.Typer(
    name="fuzzytime",
    cls=Program,
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
        from fuzzytime_cli.commands.plan import plan

        plan(file="-")


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
