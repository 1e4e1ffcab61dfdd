"""From files and instructions to the request that is planned."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from fuzzytime.context import Signal
from fuzzytime.interpreter import Request, SpokenWish
from fuzzytime_cli.assembly import Assembly
from fuzzytime_cli.faults import UsageError
from fuzzytime_cli.inputs.calendar import read_calendar
from fuzzytime_cli.inputs.lines import wishes_of
from fuzzytime_cli.inputs.source import Source, read_source
from fuzzytime_cli.inputs.task_file import Surroundings, is_task_file, read_task_file
from fuzzytime_cli.options import Understanding


def request_of(
    file: str | None,
    instructions: list[str],
    assembly: Assembly,
    understanding: Understanding,
    signals: Mapping[str, Signal],
) -> Request:
    """Read a file and ``-i`` instructions into a request; flags win over the file."""
    if file is None and not instructions:
        raise UsageError("say what to plan: a file, - for standard input, or -i TEXT")
    if not all(map(str.strip, instructions)):
        raise UsageError("an instruction must not be empty")
    source = read_source(file) if file is not None else None
    return request_from(source, instructions, assembly, understanding, signals)


def request_from(
    source: Source | None,
    instructions: list[str],
    assembly: Assembly,
    understanding: Understanding,
    signals: Mapping[str, Signal],
) -> Request:
    """Make a request of a source, read before, and of instructions; flags win over what it says."""
    now = assembly.moment()
    request = Request(
        now=now,
        wishes=(),
        agents=int(assembly.settings.number("agents")),
        horizon=assembly.horizon(),
        in_order=assembly.settings.flag("in_order"),
    )
    if source is not None:
        if is_task_file(source):
            folder = source.path.parent if source.path is not None else Path()
            surroundings = Surroundings(
                assembly.now,
                assembly.given(asked=True),
                assembly.given(asked=False),
                now,
                lambda name, moment, ahead: read_calendar(folder / name, moment, ahead),
                signals,
            )
            request = read_task_file(source, surroundings)
        else:
            request = replace(request, wishes=wishes_of(source, now))
    spoken = tuple(SpokenWish(text=text.strip(), given=request.now) for text in instructions)
    context = assembly.context(understanding, request.now, signals)
    return replace(request, wishes=(*request.wishes, *spoken), context=request.context.merged(context))
