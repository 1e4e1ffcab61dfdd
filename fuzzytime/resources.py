"""Where the shipped YAML tables are: inside an installed wheel, or in the checkout's ``rules`` folder."""

from importlib.resources import files
from pathlib import Path


def rules_directory() -> Path:
    """Give the folder of the shipped tables."""
    package = Path(str(files("fuzzytime")))
    inside = package / "rules"
    return inside if inside.is_dir() else package.parent / "rules"
