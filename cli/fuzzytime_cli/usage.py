"""A command line that breaks a rule, told in a line as every other mistake is, with where to look."""

import re
import shlex
from collections.abc import Sequence
from itertools import chain, pairwise
from pathlib import Path
from typing import Any

import typer
from typer.core import TyperGroup
from typer.exceptions import TyperException

PLAINER = (
    (r"Value error, |, unable to parse string as an? \w+", ""),
    (r"^Input should be ", "must be "),
    (r"^must be a valid ", "must be a "),
    (r"^must be an? integer", "must be a whole number"),
    (r"^must be greater than or equal to", "must be at least"),
    (r"^must be less than or equal to", "must be at most"),
    (r"^('.*') is not one of (.*)\.$", r"must be one of \2, got \1"),
    (r"^Missing \w+ '(.*)'\.$", r"\1 must be given"),
    (r"^Option '(.*)' requires an argument\.$", r"\1: a value must follow"),
    (r"^Option '(.*)' does not take a value\.$", r"\1 takes no value"),
    (r"^Got unexpected extra argument\(s\) \((.*)\)$", r"got more than it takes: \1"),
    (r"^No such option: (.*)$", r"there is no option \1"),
    (
        r"^No such command (.* .*?)\.$",
        r"there is no command \1; if these are the words themselves, say: fuzzytime plan -i \1",
    ),
    (r"^No such command (.*?)\.$", r"there is no command \1"),
    (r"^No such command (.*?)\. Did you mean (.*)\?$", r"there is no command \1 (did you mean \2?)"),
)
"""Words of the libraries that read the command line, and what people would say."""

EXTRA = re.compile(r"^Got unexpected extra argument")
UNKNOWN = re.compile(r"^No such command (?!.*Did you mean)", re.DOTALL)
"""What the libraries say of more than a command takes, and of none."""


def usage_line(error: TyperException, arguments: Sequence[str]) -> str:
    """Say what is wrong with a command line, and which help tells more; what is no mistake gets that help."""
    if error.message.startswith("Usage:"):
        return error.message
    context: Any = getattr(error, "ctx", None)
    where = "" if context is None else f" (see: {context.command_path} -h)"
    parameter = error.param if isinstance(error, typer.BadParameter) else None
    if parameter is not None and error.message:
        hint = " / ".join(parameter.opts) if parameter.opts[0].startswith("-") else parameter.name
        message = _plainer(error.message)
        value = _given(parameter.opts, arguments)
        # "--agents two": the rule, and then the value.
        given = f", got {value!r}" if value is not None and ", got " not in message else ""
        return f"fuzzytime: {hint}: {message}{given}{where}"
    option = getattr(error, "option_name", "")
    if context is not None and option and isinstance(context.command, TyperGroup):
        owner = _owner(context, option)
        if owner:
            return f"fuzzytime: {option} belongs behind a command, such as: {context.command_path} {owner}"
    close = getattr(error, "possibilities", None)
    message = _plainer(error.message or error.format_message())
    if close:
        message += f" (did you mean {' or '.join(map(repr, close))}?)"
    message += _advice(error.message or "", context, arguments)
    advised = " (did you mean " in message or "; " in message
    return f"fuzzytime: {message}{'' if advised else where}"


def _given(options: Sequence[str], arguments: Sequence[str]) -> str | None:
    """Give the value that stands behind an option, or with it: "--agents=two"."""
    behind = (after for option, after in pairwise(arguments) if option in options)
    within = (one.partition("=")[2] for one in arguments if one.partition("=")[0] in options and "=" in one)
    return next(chain(behind, within), None)


def _advice(message: str, context: Any, arguments: Sequence[str]) -> str:  # noqa: ANN401 - as below
    """Say what helps who types words without quotes, or several files; nothing where that is not so."""
    if context is None:
        return ""
    bare = len(arguments) > 1 and not any(one.startswith("-") for one in arguments)
    if UNKNOWN.search(message) and bare:
        # "fuzzytime boil the eggs"
        words = shlex.quote(" ".join(arguments))
        return f"; if these are the words themselves, say: fuzzytime plan -i {words}"
    if not EXTRA.search(message):
        return ""
    if "text" in context.params:
        return f"; words stand in quotes: {context.command_path} '…'"
    if context.params.get("instruction"):
        return "; words stand in quotes: -i '…'"
    file = context.params.get("file")
    if file and (Path(file).suffix or Path(file).exists()):
        return "; of several files, see: fuzzytime batch"
    return "; if these are the words themselves, say: -i '…'" if file else ""


def _plainer(message: str) -> str:
    for words, plain in PLAINER:
        message = re.sub(words, plain, message, flags=re.DOTALL)
    return message


def _owner(context: Any, option: str) -> str:  # noqa: ANN401 - Typer's context is of no public type
    """Give the first command that has an option, as one would type the two; nothing where none has."""
    group = context.command
    for name in group.list_commands(context):
        command = group.get_command(context, name)
        if any(option in parameter.opts for parameter in command.params):
            return f"{name} {option} …"
    return ""
