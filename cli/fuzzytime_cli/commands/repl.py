"""`fuzzytime repl`: the conversation, with a session's name."""

from typing import Annotated

import typer

from fuzzytime_cli.options import Moment, Solving, Understanding, flattened


@flattened
def repl(
    session: Annotated[
        str, typer.Argument(help="The session's name; sessions are saved and continued.")
    ] = "default",
    forget: Annotated[bool, typer.Option("--forget", help="Keep nothing.")] = False,  # noqa: FBT002 - a flag
    *,
    moment: Moment,
    understanding: Understanding,
    solving: Solving,
) -> None:
    """Hold a conversation: instructions as you type, the schedule after each, news of each start."""
    from fuzzytime_cli.render import plain
    from fuzzytime_cli.repl import converse

    converse(plain(session), moment=moment, understanding=understanding, solving=solving, kept=not forget)
