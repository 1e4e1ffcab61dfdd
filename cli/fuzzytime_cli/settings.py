"""Settings in layers: flags, environment, project file, user file, defaults; each value knows its origin."""

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from fuzzytime.errors import FuzzytimeError
from fuzzytime.spelling import nearest
from fuzzytime.times import parse_duration, parse_zone
from fuzzytime_cli.choices import ActorChoice, ProfileChoice, SolverChoice
from fuzzytime_cli.faults import ConfigError, as_config

if TYPE_CHECKING:
    from fuzzytime.documents.nodes import Node, Reader

PROJECT_FILE = "fuzzytime.yaml"
PROJECT_RULES = "fuzzytime-rules.yaml"
PROJECT_CUSTOMS = "fuzzytime-customs.yaml"
PREFIX = "FUZZYTIME_"
OTHERS = ("config", "cache", "data", "debug", "skill_")
"""How variables begin that are no settings: places, and what a command of a run is told."""

Value = str | int | float | bool | tuple[str, ...] | None


@dataclass(frozen=True, slots=True)
class Kind:
    """What a setting may be: its default, its meaning, and how a text becomes its value."""

    default: Value
    help: str
    choices: tuple[str, ...] = ()
    low: float | None = None
    high: float | None = None

    def value_of(self, text: str) -> Value:
        """Read a text.

        Raises
        ------
        FuzzytimeError
            If it is not one of the choices, or out of bounds.
        """
        if isinstance(self.default, tuple):
            return tuple(part for part in text.split(os.pathsep) if part)
        if self.choices:
            if text not in self.choices:
                raise FuzzytimeError(f"must be one of {', '.join(self.choices)}, got {text!r}")
            return text
        if isinstance(self.default, bool):
            if text.lower() not in {"true", "false", "1", "0", "yes", "no"}:
                raise FuzzytimeError(f"must be true or false, got {text!r}")
            return text.lower() in {"true", "1", "yes"}
        if isinstance(self.default, (int, float)):
            return self._number(text)
        return text

    def _number(self, text: str) -> int | float:
        whole = isinstance(self.default, int)
        try:
            number = int(text) if whole else float(text)
        except ValueError as error:
            raise FuzzytimeError(f"must be a {'whole ' if whole else ''}number, got {text!r}") from error
        low, high = self.low, self.high
        if (low is not None and not number >= low) or (high is not None and not number <= high):
            raise FuzzytimeError(f"must be between {low:g} and {high:g}, got {text!r}")
        return number


KINDS: Mapping[str, Kind] = {
    "profile": Kind("everyday", "how wide wishes are", tuple(ProfileChoice)),
    "actor": Kind("", "who acts", ("", *ActorChoice)),
    "rules": Kind((), "rule tables that go before the shipped ones"),
    "customs": Kind((), "your parts of the day, feasts and policy, over the shipped ones"),
    "solver": Kind("auto", "the method that finds the schedule", tuple(SolverChoice)),
    "agents": Kind(1, "how many can work at once", low=1, high=100),
    "threshold": Kind(0.001, "satisfaction below which a skill is rejected", low=0.0, high=0.5),
    "time_limit": Kind(5.0, "seconds after which the best schedule so far is given", low=0.01, high=86400),
    "seed": Kind(0, "seed of the methods that draw at random", low=0, high=2**32),
    "horizon": Kind("", "how far to look ahead, such as 8h; empty: past the last wish"),
    "in_order": Kind(default=False, help="whether instructions are steps, each after the one before"),
    "zone": Kind("", "time zone; empty: the machine's"),
    "personal": Kind(default=True, help="whether your ratings of starts (:rate) move the tables"),
    "bell": Kind(default=False, help="ring the terminal's bell when a start time comes"),
}
"""Every setting."""

_CHECKS = {"zone": parse_zone, "horizon": parse_duration}


@dataclass(frozen=True, slots=True)
class Setting:
    """A value and where it came from."""

    name: str
    value: Value
    origin: str


@dataclass(frozen=True, slots=True)
class Settings:
    """Every setting by name."""

    values: Mapping[str, Setting]

    def is_asked(self, name: str) -> bool:
        """Whether a flag or the environment says a setting, for this call, and not a file for all of them."""
        return self.values[name].origin.startswith(("flag ", "environment "))

    def text(self, name: str) -> str:
        """Give a setting that is a text; empty where it is not set."""
        return str(self.values[name].value or "")

    def number(self, name: str) -> float:
        """Give a setting that is a number."""
        value = self.values[name].value
        return float(value) if isinstance(value, (int, float)) else 0.0

    def flag(self, name: str) -> bool:
        """Give a setting that is true or false."""
        return self.values[name].value is True

    def paths(self, name: str) -> tuple[Path, ...]:
        """Give a setting that is a list of files."""
        value = self.values[name].value
        return tuple(map(Path, value)) if isinstance(value, tuple) else ()


def user_file(environment: Mapping[str, str]) -> Path:
    """Give the user's settings file, by FUZZYTIME_CONFIG or the platform's custom."""
    if environment.get("FUZZYTIME_CONFIG"):
        return Path(environment["FUZZYTIME_CONFIG"])
    from platformdirs import user_config_path

    return user_config_path("fuzzytime") / "config.yaml"


def load_settings(flags: Mapping[str, Value], environment: Mapping[str, str]) -> Settings:
    """Put the layers together; a flag of None was not given.

    Raises
    ------
    ConfigError
        If an environment variable breaks a rule.
        Or if a settings file does, with every mistake in it.
    """
    values = {name: Setting(name, kind.default, "default") for name, kind in KINDS.items()}
    for path in (user_file(environment), Path.cwd() / PROJECT_FILE):
        with as_config():
            values |= _file_settings(path)
    _check_names(environment)
    for name, kind in KINDS.items():
        text = environment.get(PREFIX + name.upper())
        if text is not None:
            origin = f"environment {PREFIX}{name.upper()}"
            try:
                values[name] = Setting(name, _checked(name, kind, text), origin)
            except FuzzytimeError as error:
                raise ConfigError(f"{origin}: {error}") from error
    for name, value in flags.items():
        if value is not None and value != ():
            values[name] = Setting(name, value, f"flag --{name.replace('_', '-')}")
    return Settings(values)


def _check_names(environment: Mapping[str, str]) -> None:
    """Refuse a variable that nothing reads and that looks like a setting's.

    Raises
    ------
    ConfigError
        If there is one.
    """
    for variable in sorted(environment):
        name = variable.removeprefix(PREFIX).lower()
        if variable.startswith(PREFIX) and name not in KINDS and not name.startswith(OTHERS):
            meant = nearest(name, KINDS)
            if meant is not None:
                raise ConfigError(
                    f"environment {variable}: unknown setting (did you mean {PREFIX}{meant.upper()}?)"
                )


def _checked(name: str, kind: Kind, text: str) -> Value:
    if name in _CHECKS and text:
        _CHECKS[name](text)
    return kind.value_of(text)


def _file_settings(path: Path) -> dict[str, Setting]:
    try:
        if not path.exists():
            return {}
        from fuzzytime.documents.nodes import Reader

        reader = Reader.of_file(path)
    except IsADirectoryError as error:
        raise ConfigError(f"{path}: settings must be a file, and it is a folder") from error
    except OSError:
        return {}  # no such file, or not ours to read: the layer is empty
    if not reader.text.strip():
        return {}
    found = {}
    for name, node in reader.mapping(reader.root(), "", tuple(KINDS)).items():
        value = _value(reader, node, name)
        if value is not None:
            found[name] = Setting(name, value, reader.place(node))
    reader.finish()
    return found


def _value(reader: "Reader", node: "Node", name: str) -> Value:
    kind = KINDS[name]
    if isinstance(kind.default, tuple):
        folder = Path(reader.path).parent
        return tuple(str(folder / text) for text in reader.strings(node, name))
    text = reader.string(node, name)
    try:
        return _checked(name, kind, text)
    except FuzzytimeError as error:
        reader.mistake(node, name, str(error))
        return None
