"""Where the shipped YAML tables are: inside an installed wheel, or in the checkout's ``rules`` folder."""

from pathlib import Path


def rules_directory() -> Path:
    """Give the folder of the shipped tables."""
    package = Path(__file__).parent
    inside = package / "rules"
    return inside if inside.is_dir() else package.parent / "rules"
