"""`fuzzytime doctor`: what is installed, and whether it is what it should be."""

import os
import sys

import typer

from fuzzytime_cli.exits import Exit


def doctor() -> None:
    """Check the installation: versions, the language model's files, rule tables, settings, folders."""
    from fuzzytime_cli.checks import all_checks
    from fuzzytime_cli.render import plain

    failed = False
    for check in all_checks(os.environ):
        failed |= not check.good
        mark = "ok  " if check.good else "FAIL"
        sys.stdout.write(f"{mark} {check.name:<10} {plain(check.finding)}\n")
    if failed:
        raise typer.Exit(Exit.FAILURE)
