"""`fuzzytime doctor`: what is installed, and whether it is what it should be."""

import os
import sys

import typer

from fuzzytime_cli.exits import Exit


def doctor() -> None:
    """Check the installation: versions, the language model's files, rule tables, settings, folders."""
    import textwrap

    from fuzzytime_cli.checks import all_checks
    from fuzzytime_cli.render import Screen, plain

    screen = Screen.of(sys.stdout, dict(os.environ))
    failed = False
    for check in all_checks(os.environ):
        failed |= not check.good
        head = f"{'ok' if check.good else 'FAIL':<4} {check.name:<10} "
        screen.write(
            *textwrap.wrap(
                plain(check.finding),
                screen.width,
                initial_indent=head,
                subsequent_indent=" " * len(head),
                break_on_hyphens=False,
            )
        )
    if failed:
        raise typer.Exit(Exit.FAILURE)
