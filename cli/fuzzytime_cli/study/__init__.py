"""`fuzzytime study`: collect what people draw, analyse it, and make a rule table of it.

The ``commands`` are for ``collecting``, ``keeping`` and ``using`` answers, with much ``shared``.
``summary`` shows a study; ``truth`` is what synthetic participants mean.
"""

from typing import Any

import typer
from typer.core import TyperGroup


class _Commands(TyperGroup):
    """The study's commands, imported when one is asked for: no other command waits for them."""

    def list_commands(self, ctx: Any) -> list[str]:  # noqa: ANN401 - as the base class
        """Give the commands' names, in the order of a study."""
        return self._group().list_commands(ctx)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:  # noqa: ANN401 - as the base class
        """Give a command by its name."""
        return self._group().get_command(ctx, cmd_name)

    @staticmethod
    def _group() -> TyperGroup:
        from typer.main import get_group

        from fuzzytime_cli.study.commands import app as commands

        return get_group(commands)


app = typer.Typer(
    cls=_Commands,
    help="Collect what people draw, analyse it, and make a rule table of it.",
    no_args_is_help=True,
)


@app.callback()
def study() -> None:
    """Collect what people draw, analyse it, and make a rule table of it."""
