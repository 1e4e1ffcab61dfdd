"""The docstrings of packages are maps, which lead to each of their modules."""

import re
from importlib import import_module
from pathlib import Path

import pytest

import fuzzytime
import fuzzytime_cli

ROOTS = [Path(module.__file__ or "").parent for module in (fuzzytime, fuzzytime_cli)]
FEW = 2
"""Modules that need no map."""


def modules_of(package: Path) -> set[str]:
    """Give what stands in a package: modules, and packages in it."""
    return {
        path.stem for path in package.iterdir() if path.suffix == ".py" or (path / "__init__.py").exists()
    } - {"__init__", "__main__"}


PACKAGES = {
    ".".join(path.parent.relative_to(root.parent).parts): path.parent
    for root in ROOTS
    for path in sorted(root.rglob("__init__.py"))
}


@pytest.mark.parametrize("name", [name for name, path in PACKAGES.items() if len(modules_of(path)) > FEW])
def test_the_map_of_a_package_names_each_module_and_nothing_else(name: str) -> None:
    named = re.findall(r"``(\w+)``", import_module(name).__doc__ or "")
    assert sorted(named) == sorted(modules_of(PACKAGES[name]))
