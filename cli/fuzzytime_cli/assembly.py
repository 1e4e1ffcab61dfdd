"""From options and settings to the library's values: interpreter, context, solver, limits, request."""

import os
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from datetime import datetime, tzinfo
from pathlib import Path
from typing import TYPE_CHECKING

from fuzzytime_cli.choices import SolverChoice
from fuzzytime_cli.faults import ConfigError, NoInputError, UsageError, as_config, as_usage
from fuzzytime_cli.options import Moment, Solving, Understanding
from fuzzytime_cli.places import cache_folder, data_folder, standing_customs, standing_rules
from fuzzytime_cli.settings import Settings, Value, load_settings

if TYPE_CHECKING:
    from collections.abc import Mapping

    from fuzzytime.context import Context, Signal
    from fuzzytime.interpreter import Interpreter, Plan, Request
    from fuzzytime.language import Language
    from fuzzytime.rulebook import Rulebook
    from fuzzytime.scheduling import Limits, Solver
    from fuzzytime_cli.inputs.task_file import Given


@dataclass(frozen=True, slots=True)
class Assembly:
    """Everything that commands which plan need, put together once; ``now`` is as it was said."""

    settings: Settings
    now: datetime | None
    zone: tzinfo | None
    begun: datetime | None = None

    @classmethod
    def of(cls, moment: Moment, understanding: Understanding, solving: Solving) -> "Assembly":
        """Read settings and flags.

        Raises
        ------
        ConfigError, UsageError
            If one of them breaks a rule.
        """
        from fuzzytime.times import parse_instant, parse_zone

        flags: dict[str, Value] = {
            name: tuple(map(str, value)) if isinstance(value, list) else value
            for name, value in {**asdict(understanding), **asdict(solving), "zone": moment.zone}.items()
            if name not in {"ctx", "context"}
        }
        settings = load_settings(flags, os.environ)
        with as_usage("--zone"):
            zone = parse_zone(settings.text("zone")) if settings.text("zone") else None
        with as_usage("--now"):
            now = parse_instant(moment.now) if moment.now is not None else None
        return cls(settings, now, zone)

    def beginning(self, moment: datetime) -> "Assembly":
        """Give the same where the clock stands: what says no now of its own has this one."""
        return replace(self, begun=moment)

    def moment(self) -> datetime:
        """Give the plan's now: what was said, in the zone, or the clock's, to the second.

        Raises
        ------
        UsageError
            If what was said lies outside the years 1 to 9999 there.
        """
        from fuzzytime.times import in_zone

        if self.now is not None:
            with as_usage("--now"):
                return in_zone(self.now, self.zone)
        return self.begun or datetime.now(self.zone or local_zone()).replace(microsecond=0)

    def given(self, *, asked: bool) -> "Given":
        """Give what flags and the environment say of a plan, or what files of settings do."""
        from fuzzytime_cli.inputs.task_file import Given

        def said(name: str) -> bool:
            return self.settings.is_asked(name) == asked

        return Given(
            zone=self.zone if said("zone") else None,
            agents=int(self.settings.number("agents")) if said("agents") else None,
            horizon=self.horizon() if said("horizon") else None,
            in_order=self.settings.flag("in_order") if said("in_order") else None,
        )

    def rule_files(self) -> tuple[Path, ...]:
        """Give the rule tables that go before the shipped ones: the user's, the project's, ``--rules``."""
        return (*standing_rules(os.environ), *self.settings.paths("rules"))

    def customs_files(self) -> tuple[Path, ...]:
        """Give what goes over the shipped calendar: the user's customs, the project's, ``--customs``."""
        return (*standing_customs(os.environ), *self.settings.paths("customs"))

    def table_files(self) -> tuple[Path, ...]:
        """Give all tables that go before or over the shipped ones: `rule_files` and `customs_files`."""
        return (*self.rule_files(), *self.customs_files())

    def rulebook(self) -> "Rulebook":
        """Load the rule tables: shipped, the user's, the project's, those of ``--rules``.

        Raises
        ------
        ConfigError
            If a table breaks a rule, with every mistake.
        """
        from fuzzytime.errors import FuzzytimeError
        from fuzzytime.rulebook import Actor, Profile, Rulebook

        files = self.rule_files()
        for path in files:
            require_file(path, "rule table")
        actor = self.settings.text("actor")
        profile = Profile(self.settings.text("profile"))
        try:
            return Rulebook.shipped(profile, Actor(actor) if actor else None, files, cache_folder(os.environ))
        except FuzzytimeError as error:
            from fuzzytime.language.grammar.word_tables.layers import is_word_table

            customs = next((path for path in files if path.is_file() and is_word_table(path)), None)
            mistake = f"{customs}: this holds customs and no rules: --customs takes it" if customs else error
            raise ConfigError(str(mistake)) from error

    def language(self) -> "Language":
        """Load the language, with the cache of parses and tables.

        Raises
        ------
        ConfigError
            If a word table or a file of customs breaks a rule, or the model is not installed.
        NoInputError
            If a file of customs is not there.
        """
        from fuzzytime.errors import FuzzytimeError
        from fuzzytime.language import Language

        with as_config():
            customs = self.customs_files()
            for path in customs:
                require_file(path, "file of customs")
            try:
                return Language.shipped(cache=cache_folder(os.environ), customs=customs)
            except FuzzytimeError as error:
                from fuzzytime.language.grammar.word_tables.layers import is_word_table
                from fuzzytime.rulebook import check

                others = (path for path in customs if path.is_file() and not is_word_table(path))
                rules = next((path for path in others if not check((path,))), None)
                mistake = f"{rules}: this holds rules and no customs: --rules takes it" if rules else error
                raise ConfigError(str(mistake)) from error

    def interpreter(self, *, personal: bool = True) -> "Interpreter":
        """Put language and rulebook together, with the person's own table on top if they rated starts.

        Raises
        ------
        ConfigError
            If a table breaks a rule.
        """
        from fuzzytime.interpreter import Interpreter

        rulebook = self.rulebook()
        if personal and self.settings.flag("personal"):
            from fuzzytime_cli.personal import kept_ratings, personal_rulebook

            rulebook = personal_rulebook(rulebook, kept_ratings(data_folder()))
        return Interpreter.joining(self.language(), rulebook)

    def context(
        self, understanding: Understanding, now: datetime, signals: "Mapping[str, Signal]"
    ) -> "Context":
        """Read ``--context`` and ``--ctx``.

        Raises
        ------
        UsageError, DocumentError
            If one of them breaks a rule.
        """
        from fuzzytime.context import Context, parse_assignment, read_context_file

        context = Context()
        if understanding.context is not None:
            require_file(understanding.context, "context file")
            context = read_context_file(understanding.context, now, signals)
        for assignment in understanding.ctx or ():
            with as_usage("--ctx"):
                context = context.with_reading(parse_assignment(assignment, signals))
        return context

    def solver(self, choice: SolverChoice | None = None) -> "Solver":
        """Give a solver: the one asked for, or that of the settings, with their seed."""
        from fuzzytime import scheduling

        seed = int(self.settings.number("seed"))
        solvers: dict[SolverChoice, Callable[[], Solver]] = {
            SolverChoice.AUTO: scheduling.Auto,
            SolverChoice.EXACT: scheduling.Auto,
            SolverChoice.EXHAUSTIVE: scheduling.ExhaustiveSampling,
            SolverChoice.HILL_CLIMBING: lambda: scheduling.HillClimbing(seed=seed),
            SolverChoice.ANNEALING: lambda: scheduling.SimulatedAnnealing(seed=seed),
            SolverChoice.GENETIC: lambda: scheduling.Genetic(seed=seed),
        }
        return solvers[choice or SolverChoice(self.settings.text("solver"))]()

    def limits(self) -> "Limits":
        """Give the limits of time."""
        from fuzzytime.scheduling import Limits

        return Limits(seconds=self.settings.number("time_limit"))

    def horizon(self) -> float | None:
        """Give the horizon in seconds, None where none is set.

        Raises
        ------
        UsageError
            If it is not a duration above 0.
        """
        from fuzzytime.times import parse_duration

        text = self.settings.text("horizon")
        if not text:
            return None
        with as_usage("--horizon"):
            horizon = parse_duration(text)
        if horizon <= 0:
            raise UsageError(f"--horizon: must be above 0, got {text!r}")
        return horizon

    def plan(self, request: "Request", interpreter: "Interpreter") -> "Plan":
        """Interpret and schedule a request by the settings."""
        from fuzzytime.interpreter import plan

        return plan(
            request,
            interpreter,
            solver=self.solver(),
            threshold=self.settings.number("threshold"),
            limits=self.limits(),
        )


def local_zone() -> tzinfo | None:
    """Give the machine's zone by name where it is known, so that later hours know of clock changes."""
    from fuzzytime.errors import FuzzytimeError
    from fuzzytime.times import parse_zone

    names = [os.environ.get("TZ", "").lstrip(":")]
    try:
        target = str(Path("/etc/localtime").resolve())
        names.append(target.partition("zoneinfo/")[2])
    except OSError:
        pass
    for name in filter(None, names):
        try:
            return parse_zone(name)
        except FuzzytimeError:
            continue
    return datetime.now().astimezone().tzinfo


def require_file(path: Path, what: str) -> None:
    """Make sure that a file is there, be it a pipe.

    Raises
    ------
    NoInputError
        If it is not, or is a folder.
    """
    if path.is_dir():
        raise NoInputError(f"{path}: a {what} must be a file, and it is a folder")
    if not path.exists():
        raise NoInputError(f"{path}: there is no such {what}")
