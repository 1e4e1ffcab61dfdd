"""Options that several commands share, each group a frozen dataclass that a command takes as one parameter.

>>> @dataclass(frozen=True)
... class Voice:
...     loud: Annotated[bool, typer.Option(help="Shout.")] = False
>>> @flattened
... def greet(name: str, voice: Voice) -> None: ...
>>> list(inspect.signature(greet).parameters)
['name', 'loud']
"""

import functools
import inspect
from collections.abc import Callable
from dataclasses import MISSING, dataclass, fields, is_dataclass
from pathlib import Path
from typing import Annotated, Any, get_type_hints

import typer

from fuzzytime_cli.bounds import MAX_AGENTS
from fuzzytime_cli.choices import ActorChoice, ProfileChoice, SolverChoice


def flattened(command: Callable[..., None]) -> Callable[..., None]:
    """Let Typer see the fields of a command's dataclass parameters as options of the command itself."""
    hints = get_type_hints(command, include_extras=True)
    parameters: list[inspect.Parameter] = []
    groups: dict[str, type] = {}
    for name, parameter in inspect.signature(command).parameters.items():
        kind = hints[name]
        if not (isinstance(kind, type) and is_dataclass(kind)):
            parameters.append(parameter.replace(annotation=hints[name], kind=inspect.Parameter.KEYWORD_ONLY))
            continue
        groups[name] = kind
        own = get_type_hints(kind, include_extras=True)
        for entry in fields(kind):
            default = inspect.Parameter.empty if entry.default is MISSING else entry.default
            parameters.append(
                inspect.Parameter(
                    entry.name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=own[entry.name]
                )
            )

    signature = inspect.Signature(parameters)

    @functools.wraps(command)
    def run(**given: Any) -> None:  # noqa: ANN401 - the values are those of the command's own signature
        bound = signature.bind(**given)
        bound.apply_defaults()
        values = bound.arguments
        collected = {
            name: kind(**{entry.name: values.pop(entry.name) for entry in fields(kind)})
            for name, kind in groups.items()
        }
        command(**values, **collected)

    run.__signature__ = signature  # type: ignore[attr-defined]
    run.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
    return run


TaskFile = Annotated[
    str | None, typer.Argument(help="Instructions, one a line; a YAML task file; or - for standard input.")
]
Instructions = Annotated[
    list[str] | None,
    typer.Option(
        "--instruction",
        "-i",
        metavar="TEXT",
        help="An instruction, typed here; repeatable.",
    ),
]


def unless_dash(path: Path | None) -> Path | None:
    """Take ``-`` for standard output, as everywhere: no file."""
    return None if path == Path("-") else path


OutputFile = Annotated[
    Path | None,
    typer.Option(
        "--output",
        "-o",
        metavar="FILE",
        callback=unless_dash,
        help="Write to a file, completely or not at all; - is standard output.",
    ),
]


@dataclass(frozen=True, slots=True)
class Moment:
    """When: what counts as now, and where."""

    now: Annotated[
        str | None,
        typer.Option(
            metavar="INSTANT",
            help="The moment to plan from, such as 2026-03-04T09:00; now if not given.",
        ),
    ] = None
    zone: Annotated[
        str | None,
        typer.Option(metavar="NAME", help="Time zone, such as Europe/Berlin; this machine's if not given."),
    ] = None


Customs = Annotated[
    list[Path] | None,
    typer.Option(
        "--customs",
        metavar="FILE",
        help="Your parts of the day, feasts and policy, over the shipped ones; repeatable.",
    ),
]


@dataclass(frozen=True, slots=True)
class Understanding:
    """How words and context become satisfaction."""

    profile: Annotated[
        ProfileChoice | None,
        typer.Option(help="How wide wishes are: as in everyday life (the default), or as in the study."),
    ] = None
    actor: Annotated[
        ActorChoice | None, typer.Option(help="Who acts: people allow a robot and a person different leeway.")
    ] = None
    rules: Annotated[
        list[Path] | None,
        typer.Option(
            "--rules", metavar="FILE", help="A rule table that overrides the shipped ones; repeatable."
        ),
    ] = None
    customs: Customs = None
    ctx: Annotated[
        list[str] | None,
        typer.Option("--ctx", metavar="NAME=VALUE", help="A reading now, such as pan_temp=180; repeatable."),
    ] = None
    context: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Readings over time: one JSON object a line, or CSV.")
    ] = None


@dataclass(frozen=True, slots=True)
class Solving:
    """How the schedule is found."""

    solver: Annotated[
        SolverChoice | None,
        typer.Option(
            help="How to search; auto (the default) finds the best, and proves it where time allows."
        ),
    ] = None
    agents: Annotated[
        int | None,
        typer.Option(metavar="N", min=1, max=MAX_AGENTS, help="How many can work at once (default 1)."),
    ] = None
    threshold: Annotated[
        float | None,
        typer.Option(
            metavar="SATISFACTION",
            min=0.0,
            max=0.5,
            help="Reject what is satisfied less than this (default 0.001); at 0 a clash is infeasible.",
        ),
    ] = None
    time_limit: Annotated[
        float | None,
        typer.Option(
            metavar="SECONDS", min=0.01, help="Take the best found so far after this time (default 5)."
        ),
    ] = None
    seed: Annotated[
        int | None, typer.Option(metavar="N", min=0, help="Makes random methods repeatable (default 0).")
    ] = None
    horizon: Annotated[
        str | None,
        typer.Option(
            metavar="DURATION",
            help="How far to look ahead, such as 8h; if not given, past the last wish.",
        ),
    ] = None
    in_order: Annotated[
        bool | None,
        typer.Option(
            "--in-order/--any-order",
            help="Take instructions as steps, each after the one before, unless words say another order.",
            show_default=False,
        ),
    ] = None
