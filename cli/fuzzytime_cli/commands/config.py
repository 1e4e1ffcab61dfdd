"""`fuzzytime config`: which settings hold, and where each came from."""

import json
import os
import sys
from typing import Annotated

import typer

from fuzzytime_cli.parameters import Command, Group

app = typer.Typer(cls=Group, help="Show the settings.", no_args_is_help=True)


@app.command(cls=Command, short_help="Show every setting's value.")
def show(
    origin: Annotated[bool, typer.Option("--origin", help="Say where each value came from.")] = False,  # noqa: FBT002
    as_json: Annotated[bool, typer.Option("--json", help="Write JSON.")] = False,  # noqa: FBT002
) -> None:
    """Show every setting's value: flags and environment before project file, user file and defaults."""
    from fuzzytime_cli.render import Screen, plain
    from fuzzytime_cli.settings import KINDS, load_settings, user_file

    settings = load_settings({}, os.environ)
    if as_json:
        rows = {s.name: {"value": s.value, "origin": s.origin} for s in settings.values.values()}
        sys.stdout.write(json.dumps(rows, indent=2) + "\n")
        return
    screen = Screen.of(sys.stdout, dict(os.environ))
    for setting in settings.values.values():
        shown = os.pathsep.join(setting.value) if isinstance(setting.value, tuple) else str(setting.value)
        tail = plain(setting.origin) if origin else KINDS[setting.name].help
        screen.write(f"{setting.name:<11} {plain(shown) or '-':<14} {tail}")
    if origin:
        screen.write(f"the user's file is {plain(str(user_file(os.environ)))}")
