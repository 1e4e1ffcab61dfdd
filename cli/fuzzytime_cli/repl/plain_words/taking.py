"""Commands that plain words are taken as, run with a head that says which."""

from collections.abc import Sequence
from dataclasses import replace

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language.about_wishes import About, AboutKind
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.commands.by_name import TRIED, command_of
from fuzzytime_cli.repl.scene import Reply, Scene
from fuzzytime_cli.repl.typed import whole_number


def run(scene: Scene, about: About, line: str) -> Reply:
    """Run a command, and say which."""
    command, rest = command_of(line)
    if scene.tried is not None and command not in TRIED:
        raise FuzzytimeError(f"what {line!r} would do is not shown: say it, and then undo")
    named = rest.partition(" ")[0]
    dropped, focus = "", None
    if line.startswith(":drop"):
        dropped = "; ".join(_text_of(scene, number) for number in named.split(","))
    else:
        focus = whole_number(named.partition(".")[0].lstrip("s"))
    reply = command.run(scene, rest)
    if not (reply.changed or scene.tried is not None):
        return replace(reply, focus=focus)
    if line in {":undo", ":redo"}:
        return reply
    head = Text(plain(f"taken as {line}{f' ({dropped})' if dropped else ''}; :undo takes it back"))
    return replace(reply, lines=(head, *reply.lines), focus=focus, taken=about)


def run_each(scene: Scene, lines: Sequence[str]) -> Reply:
    """Run several commands, and say which."""
    replies = [run(scene, About(kind=AboutKind.MOVE), line) for line in lines]
    said = tuple(line for reply in replies for line in reply.lines)
    return replace(replies[-1], lines=said, changed=any(reply.changed for reply in replies))


def _text_of(scene: Scene, number: str) -> str:
    return next((one.text for one in scene.conversation.state.entries if str(one.number) == number), "")
