"""Commands that convert the values of their parameters only where there is something to convert.

Typer makes a converter for every parameter of a command, given or not, and imports pydantic for it, which
takes a sixth of the time that a plan of ten instructions takes. But what nobody gave is already what the
command takes, and text stays text.
"""

from typing import TYPE_CHECKING, Any

from typer.core import TyperArgument, TyperCommand, TyperGroup, TyperOption

if TYPE_CHECKING:
    import typer._click as click


class _Option(TyperOption):
    """An option that is converted where it has to be."""

    def process_value(self, ctx: "click.Context", value: Any) -> Any:  # noqa: ANN401 - whatever was given
        """Give the value that the command takes."""
        return _as_it_is(self, ctx, value) if _fits(self, value) else super().process_value(ctx, value)


class _Argument(TyperArgument):
    """An argument that is converted where it has to be."""

    def process_value(self, ctx: "click.Context", value: Any) -> Any:  # noqa: ANN401 - whatever was given
        """Give the value that the command takes."""
        return _as_it_is(self, ctx, value) if _fits(self, value) else super().process_value(ctx, value)


def _fits(parameter: TyperOption | TyperArgument, value: object) -> bool:
    """Say whether a value needs no conversion; one that is missing is a matter of Typer's."""
    if value is None or value is parameter.default:
        return not parameter.required
    kind = parameter.type_descriptor.annotation
    return (kind is str and isinstance(value, str)) or (kind == list[str] and isinstance(value, tuple | list))


def _as_it_is(parameter: TyperOption | TyperArgument, ctx: "click.Context", value: Any) -> Any:  # noqa: ANN401
    return value if parameter.callback is None else parameter.callback(ctx, parameter, value)


def _convert_where_needed(parameters: list["click.Parameter"]) -> list["click.Parameter"]:
    """Let parameters that Typer has made convert only what needs it."""
    for parameter in parameters:
        if type(parameter) is TyperOption:
            parameter.__class__ = _Option
        elif type(parameter) is TyperArgument:
            parameter.__class__ = _Argument
    return parameters


class Command(TyperCommand):
    """A command that converts only what needs it."""

    def get_params(self, ctx: "click.Context") -> list["click.Parameter"]:
        """Give the parameters, that of ``--help`` too."""
        return _convert_where_needed(super().get_params(ctx))


class Group(TyperGroup):
    """A command of commands that converts only what needs it."""

    def get_params(self, ctx: "click.Context") -> list["click.Parameter"]:
        """Give the parameters, those of ``--help`` and of completion too."""
        return _convert_where_needed(super().get_params(ctx))
