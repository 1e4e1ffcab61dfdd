"""Where a person's own files are: tables and customs that always count, parses, sessions."""

import os
from collections.abc import Mapping
from pathlib import Path

from fuzzytime_cli.settings import PROJECT_CUSTOMS, PROJECT_RULES, user_file


def standing_rules(environment: Mapping[str, str]) -> tuple[Path, ...]:
    """Give the user's and the project's own rule tables, where they are."""
    return _standing(environment, "rules.yaml", PROJECT_RULES)


def standing_customs(environment: Mapping[str, str]) -> tuple[Path, ...]:
    """Give the user's and the project's own customs, where they are."""
    return _standing(environment, "customs.yaml", PROJECT_CUSTOMS)


def _standing(environment: Mapping[str, str], users: str, projects: str) -> tuple[Path, ...]:
    """Give those files that are there: the user's, beside the settings, and the project's."""
    candidates = (user_file(environment).parent / users, Path(projects))
    return tuple(path for path in candidates if path.is_file())


def cache_folder(environment: Mapping[str, str]) -> Path | None:
    """Give the folder of parses, and of tables as they were read; None where FUZZYTIME_CACHE is empty."""
    where = environment.get("FUZZYTIME_CACHE")
    if where is not None:
        return Path(where) if where else None
    from platformdirs import user_cache_path

    return user_cache_path("fuzzytime")


def data_folder() -> Path | None:
    """Give the folder of sessions and history, by FUZZYTIME_DATA or custom; None for nowhere."""
    where = os.environ.get("FUZZYTIME_DATA")
    if where is not None:
        return Path(where) if where else None
    from platformdirs import user_data_path

    try:
        return user_data_path("fuzzytime")
    except (OSError, RuntimeError):
        return None  # no home
