"""The docstrings of packages with many modules are maps, which lead to each of them."""

import re
from pathlib import Path
from types import ModuleType

import pytest

from fuzzytime import interpreter
from fuzzytime.language import grammar, meaning, sentence
from fuzzytime.language.sentence import clauses, references, segments, sketches, together, trees, verbs

ROOMS = (clauses, references, segments, sketches, together, trees, verbs)


@pytest.mark.parametrize(
    "package", [grammar, interpreter, meaning, sentence, *ROOMS], ids=lambda one: one.__name__
)
def test_the_map_of_a_package_names_each_module_and_nothing_else(package: ModuleType) -> None:
    here = Path(package.__file__ or "").parent
    modules = {
        path.stem for path in here.iterdir() if path.suffix == ".py" or (path / "__init__.py").exists()
    }
    named = re.findall(r"``(\w+)``", package.__doc__ or "")
    assert sorted(named) == sorted(modules - {"__init__"})
