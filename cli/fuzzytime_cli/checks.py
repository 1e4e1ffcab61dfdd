"""What `fuzzytime doctor` looks at."""

import platform
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from fuzzytime.errors import FuzzytimeError, Mistake

LIBRARIES = ("numpy", "scipy", "spacy", "typer", "rich", "pyyaml", "prompt_toolkit", "icalendar")


@dataclass(frozen=True, slots=True)
class Check:
    """One finding, and whether it is as it should be."""

    name: str
    good: bool
    finding: str


def all_checks(environment: Mapping[str, str]) -> Iterator[Check]:
    """Look at everything."""
    yield Check("python", sys.version_info >= (3, 11), f"{platform.python_version()} on {platform.system()}")
    yield _versions()
    yield _model()
    yield _tables()
    yield _settings(environment)
    yield from _folders(environment)


def _versions() -> Check:
    found, missing = [], []
    for name in ("fuzzytime-planner", *LIBRARIES):
        try:
            found.append(f"{name} {version(name)}")
        except PackageNotFoundError:
            missing.append(name)
    # From a checkout that is not installed, fuzzytime itself has no version.
    lacking = [name for name in missing if name != "fuzzytime-planner"]
    return Check(
        "libraries", not lacking, ", ".join(found) + (f"; missing: {', '.join(lacking)}" if lacking else "")
    )


def _model() -> Check:
    from fuzzytime.language import installed_model, model_files
    from fuzzytime.language.sentence.trees.model_files import FileState

    try:
        package = installed_model()
        files = model_files(package)
    except FuzzytimeError as error:
        return Check("model", good=False, finding=str(error))
    wrong = [file.path for file in files if file.state is not FileState.OFFICIAL]
    finding = f"{package.name} {package.version}, {len(files)} files as published"
    if wrong:
        finding = f"{package.name} {package.version}, not as published: {', '.join(wrong)}"
    return Check("model", not wrong, finding)


def table_mistakes(files: Sequence[Path]) -> tuple[Mistake, ...]:
    """Give every mistake of rule tables and customs, over the shipped ones.

    Raises
    ------
    OSError
        If a file cannot be read.
    """
    from fuzzytime.language import check_customs
    from fuzzytime.language.grammar.word_tables.layers import is_word_table
    from fuzzytime.rulebook import check

    # A pipe can be read but once: it is taken for rules.
    customs = [path for path in files if path.is_file() and is_word_table(path)]
    rules = [path for path in files if path not in customs]
    return (*check(rules), *check_customs(customs))


def _tables() -> Check:
    from fuzzytime_cli.assembly import Assembly
    from fuzzytime_cli.options import Moment, Solving, Understanding

    files: tuple[Path, ...] = ()
    # Settings that cannot be read are another finding.
    with suppress(FuzzytimeError):
        files = Assembly.of(Moment(), Understanding(), Solving()).table_files()
    try:
        mistakes = table_mistakes(files)
    except (FuzzytimeError, OSError) as error:
        return Check("tables", good=False, finding=str(error).partition("\n")[0])
    names = "".join(f" and {path}" for path in files)
    if not mistakes:
        return Check("tables", good=True, finding=f"the shipped tables{names} hold no mistake")
    first, many = str(mistakes[0]).partition("\n")[0], len(mistakes)
    more = f" (the first of {many}: fuzzytime rules check tells all)" if many > 1 else ""
    return Check("tables", good=False, finding=first + more)


def _settings(environment: Mapping[str, str]) -> Check:
    from fuzzytime_cli.settings import load_settings

    try:
        settings = load_settings({}, environment)
    except FuzzytimeError as error:
        return Check("settings", good=False, finding=str(error).partition("\n")[0])
    changed = [name for name, setting in settings.values.items() if setting.origin != "default"]
    return Check("settings", good=True, finding=f"set: {', '.join(changed)}" if changed else "all as shipped")


def _folders(environment: Mapping[str, str]) -> Iterator[Check]:
    from fuzzytime_cli.places import cache_folder, data_folder

    sessions = data_folder()
    damage = _damage(sessions)
    yield Check("sessions", good=not damage, finding=damage or _folder(sessions))
    yield Check("cache", good=True, finding=_folder(cache_folder(environment)))


def _damage(folder: Path | None) -> str:
    from fuzzytime_cli.session import damage_of

    path = folder / "sessions.sqlite" if folder is not None else None
    damage = damage_of(path) if path is not None and path.is_file() else ""
    return damage and f"{path}: {damage}: nothing is kept until it is moved away"


def _folder(folder: Path | None) -> str:
    if folder is None:
        return "nowhere: nothing is kept"
    return f"{folder}{'' if folder.is_dir() else ' (made when it is needed)'}"
