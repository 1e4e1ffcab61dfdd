"""The docstrings of packages with many modules are maps, which lead to each of them."""

import re
from importlib import import_module
from pathlib import Path

import pytest

import fuzzytime

ROOT = Path(fuzzytime.__file__).parent
HOUSES = (
    "interpreter",
    "language.english",
    "language.meaning",
    "language.sentence",
    "rulebook",
    "scheduling",
    "study",
)
"""Packages whose modules stand in rooms."""

ROOMS = [
    f"{house}.{path.parent.name}"
    for house in HOUSES
    for path in ROOT.joinpath(*house.split(".")).glob("*/__init__.py")
]
SMALLER_ROOMS = [
    f"language.sentence.{room}.{path.parent.name}"
    for room in ("segments", "together")
    for path in ROOT.joinpath("language", "sentence", room).glob("*/__init__.py")
]
MAPS = [
    "interpreter",
    "language.english",
    "language.grammar",
    "language.grammar.judging",
    "language.meaning",
    "language.sentence",
    *sorted(ROOMS),
    *sorted(SMALLER_ROOMS),
]


@pytest.mark.parametrize("name", MAPS)
def test_the_map_of_a_package_names_each_module_and_nothing_else(name: str) -> None:
    package = import_module(f"fuzzytime.{name}")
    here = Path(package.__file__ or "").parent
    modules = {
        path.stem for path in here.iterdir() if path.suffix == ".py" or (path / "__init__.py").exists()
    }
    named = re.findall(r"``(\w+)``", package.__doc__ or "")
    assert sorted(named) == sorted(modules - {"__init__"})
