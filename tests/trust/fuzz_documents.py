"""Mutate rule, customs, context, task and calendar files: each is valid, or refused with a place.

    PYTHONPATH=.:cli:tests python tests/trust/fuzz_documents.py --files 100000 --seed 1

Prints how many files were mutated, how many were refused, and every failure. A file that is still valid is
used as well: a few requirements are resolved by a rule table, and every ψ must lie in [0, 1].
"""

import argparse
import math
import random
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

import numpy as np

from fuzzytime.context import Context, read_context_lines
from fuzzytime.documents.nodes import Reader
from fuzzytime.errors import DocumentError, FuzzytimeError
from fuzzytime.interpreter import DirectWish
from fuzzytime.language import Language, find_times
from fuzzytime.requirement import Condition, Constraint, TimeRequirement, Unit
from fuzzytime.rulebook import Profile, Rulebook
from fuzzytime.rulebook.tables.documents import read_over
from fuzzytime.satisfaction import SatisfactionFunction
from fuzzytime.times import parse_zone
from fuzzytime_cli.faults import NoInputError
from fuzzytime_cli.inputs.calendar import read_calendar
from fuzzytime_cli.inputs.source import source_of
from fuzzytime_cli.inputs.surroundings import Taken
from fuzzytime_cli.inputs.task_file import Given, Surroundings, read_task_file
from trust.mutating import mutated

HERE = Path(__file__).parent
NOW = datetime(2026, 3, 28, 22, 50, tzinfo=parse_zone("Europe/Berlin"))
"""A few hours before the clocks go forward."""

REQUIREMENTS = (
    TimeRequirement(text="soon", span=(0, 4), constraint=Constraint.VAGUE, word="soon"),
    TimeRequirement(
        text="in about ten minutes",
        span=(0, 20),
        constraint=Constraint.AT,
        preposition="in",
        fuzziness=("about",),
        number=10,
        unit=Unit.MINUTE,
        t_spec=600.0,
    ),
    TimeRequirement(text="by noon", span=(0, 7), constraint=Constraint.BEFORE, preposition="by", t_spec=1e4),
    TimeRequirement(
        text="when the pan is hot",
        span=(0, 19),
        constraint=Constraint.WHEN,
        preposition="when",
        condition=Condition(text="when the pan is hot", subject="pan", word="hot"),
    ),
)
TEXTS = (
    "tomorrow evening",
    "before supper on 4/5",
    "during the quiet hours",
    "at half past five",
    "on mother's day",
    "this weekend",
    "every monday at 5:30",
)
CONTEXTS = (
    Context.empty,
    Context.of({"heat": [(-60.0, 80.0), (0.0, 120.0)], "load": 3.0, "bell": None}),
)
TIMES = np.linspace(0.0, 7200.0, 50)


@dataclass(frozen=True)
class Kind:
    """A kind of file: the one that is mutated, what reads and uses it, and how many of ten it is."""

    name: str
    file: str
    use: Callable[[bytes, Rulebook, random.Random], None]
    of_ten: int
    placed: bool = True

    @property
    def text(self) -> str:
        return (HERE / self.file).read_text(encoding="utf-8")


def _must_be_satisfactions(function: SatisfactionFunction) -> None:
    values = function(TIMES)
    if not ((values >= 0) & (values <= 1)).all():
        message = f"ψ must lie in [0, 1], got {values.min()} to {values.max()}"
        raise AssertionError(message)


def use_rules(raw: bytes, shipped: Rulebook, chance: random.Random) -> None:
    """Read a rule file, and resolve requirements by it."""
    tables, mistakes = read_over(shipped.tables, [Reader("fuzzed.yaml", raw)], Profile.EVERYDAY)
    if mistakes:
        raise DocumentError(mistakes)
    rulebook = Rulebook(tables)
    rulebook.duration_of("boil", "the eggs")
    for requirement in chance.sample(REQUIREMENTS, 2):
        context = chance.choice(CONTEXTS)
        try:
            context.admitted(rulebook.signals)
        except FuzzytimeError:
            context = Context.empty  # the table declared these signals away, or other limits
        _must_be_satisfactions(
            rulebook.resolve(requirement, context, verb="flip", elapsed=300.0).satisfaction
        )


def use_customs(raw: bytes, shipped: Rulebook, chance: random.Random) -> None:
    """Lay customs over the calendar, and read a few times by them."""
    del shipped
    with tempfile.NamedTemporaryFile(suffix=".yaml") as file:
        file.write(raw)
        file.flush()
        language = Language.shipped(customs=[Path(file.name)])
    for text in chance.sample(TEXTS, 2):
        for requirement in find_times(text, NOW, language.lexicon).requirements:
            bounds = (requirement.earliest, requirement.latest)
            if not all(bound is None or math.isfinite(bound) for bound in bounds):
                message = f"a time must be finite, got {bounds} of {text!r}"
                raise AssertionError(message)


def use_readings(raw: bytes, shipped: Rulebook, chance: random.Random) -> None:
    """Read a context file, and resolve a condition by it."""
    del chance
    context = read_context_lines(raw, "fuzzed.jsonl", None, shipped.signals)
    shipped.resolve(REQUIREMENTS[3], context)


def use_task(raw: bytes, shipped: Rulebook, chance: random.Random) -> None:
    """Read a task file, and look at the functions in it."""
    given = chance.choice((None, NOW))
    surroundings = Surroundings(given, Given(), Given(), NOW, _no_calendar, shipped.signals)
    request = read_task_file(source_of(raw, Path("fuzzed.yaml")), surroundings)
    for wish in request.wishes:
        if isinstance(wish, DirectWish):
            _must_be_satisfactions(wish.satisfaction)


def _no_calendar(name: str, now: datetime, ahead: float) -> Taken:
    raise FuzzytimeError(f"a calendar file must be readable, got {name!r} for {now} and {ahead:g} s")


def use_calendar(raw: bytes, shipped: Rulebook, chance: random.Random) -> None:
    """Read a calendar; its library says no lines."""
    del shipped, chance
    with tempfile.NamedTemporaryFile(suffix=".ics") as file:
        file.write(raw)
        file.flush()
        for busy in read_calendar(Path(file.name), NOW).busy:
            if not busy.start <= busy.end:
                message = f"a busy time must not end before it starts, got {busy}"
                raise AssertionError(message)


KINDS = (
    Kind("rule", "fuzzed_rules.yaml", use_rules, 5),
    Kind("customs", "fuzzed_customs.yaml", use_customs, 1),
    Kind("context", "fuzzed_readings.jsonl", use_readings, 1),
    Kind("task", "fuzzed_task.yaml", use_task, 2),
    Kind("calendar", "fuzzed_calendar.ics", use_calendar, 1, placed=False),
)
OF_TEN = tuple(kind for kind in KINDS for _ in range(kind.of_ten))


def run(files: int, seed: int, report: Callable[[str], None]) -> Counter[str]:
    """Mutate so many files; count what came of them, and report failures."""
    shipped = Rulebook.shipped()
    texts = {kind.name: kind.text for kind in KINDS}
    counts: Counter[str] = Counter()
    for number in range(files):
        chance = random.Random(f"{seed}-{number}")
        kind = OF_TEN[number % len(OF_TEN)]
        raw = mutated(chance, texts[kind.name])
        try:
            kind.use(raw, shipped, chance)
            counts[f"{kind.name} files still valid, and used"] += 1
        except DocumentError as error:
            placed = all(mistake.line >= 1 and mistake.column >= 1 for mistake in error.mistakes)
            counts[f"{kind.name} files refused with places" if placed and str(error) else "failures"] += 1
        except NoInputError:
            counts[f"{kind.name} files refused as empty"] += 1
        except Exception as error:  # noqa: BLE001 - whatever it is, it is what is looked for
            if isinstance(error, FuzzytimeError) and str(error) and not kind.placed:
                counts[f"{kind.name} files refused"] += 1
                continue
            counts["failures"] += 1
            report(f"failure at seed {seed}, file {number}: {type(error).__name__}: {error}\n{raw!r}")
    return counts


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    options.add_argument("--files", type=int, default=100_000)
    options.add_argument("--seed", type=int, default=1)
    chosen = options.parse_args()
    started = time.perf_counter()
    counts = run(chosen.files, chosen.seed, print)
    print(f"{chosen.files:,} mutated files in {time.perf_counter() - started:.0f} s, seed {chosen.seed}")
    for kind, count in sorted(counts.items()):
        print(f"{count:9,}  {kind}")
    raise SystemExit(1 if counts["failures"] else 0)


if __name__ == "__main__":
    main()
