"""Find conditions of the language that no text shows: switched off, each text reads as before.

    python tests/trust/idle_conditions.py fuzzytime/language/sentence/together

Every text of the corpora, the examples and the tests is read once, and every condition below the folder
notes the texts in which it decides something: an operand of "or" and the test of an "if" where they hold, an
operand of "and" and a filter where they do not. Then it is switched off, and those texts are read again.

What is printed changes none of them. Mostly a row is missing: people say what no corpus holds, and a
condition may decide it. So look for a sentence first that reads otherwise without it, and add that; only
what none is found for is a rule for nobody. Guards against nothing found are printed, too, and so is what
holds between lines, as each text is read alone. It takes some ten minutes, on systems with alarms.
"""

import argparse
import ast
import importlib
import json
import pkgutil
import signal
import sys
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from functools import _lru_cache_wrapper
from gc import get_objects
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec, PathFinder, SourceFileLoader
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any

import yaml

ROOT = Path(__file__).parents[2]
NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - a wall clock, as the corpora have
MOST = 50
"""A condition that decides something in more texts than this is not idle."""

LONGEST = 220
"""Characters of a text that is read; longer strings of the tests are no instructions."""

LIMIT = 10.0
"""Seconds for a text; without a condition the reading may go on for ever, which is another reading."""

KEPT = frozenset({"_pipeline", "_listed", "grammar", "shipped_lexicon", "shipped_grammar"})
"""What is made once, and is the same for every text."""


@dataclass(slots=True)
class Site:
    """A condition in the source, and the texts in which it decides something."""

    path: Path
    line: int
    said: str
    texts: set[int] = field(default_factory=set)


@dataclass(slots=True)
class Watch:
    """What conditions report to: which are there, which text is read, which condition is switched off."""

    sites: list[Site] = field(default_factory=list)
    text: int | None = None
    off: int | None = None

    def holds(self, number: int, value: object) -> object:
        """Pass the value of what decides where it holds; nothing where that is switched off."""
        if number == self.off:
            return None
        if value and self.text is not None:
            self.sites[number].texts.add(self.text)
        return value

    def fails(self, number: int, value: object) -> object:
        """Pass the value of what decides where it does not hold; true where that is switched off."""
        if number == self.off:
            return True
        if not value and self.text is not None:
            self.sites[number].texts.add(self.text)
        return value


WATCH = Watch()


class Watched(ast.NodeTransformer):
    """Have the conditions of a module report what they are."""

    def __init__(self, path: Path, source: str, watch: Watch = WATCH) -> None:
        """Take a module's path and text, and what is reported to."""
        self.path, self.source, self.watch = path, source, watch

    def _reporting(self, way: str, condition: ast.expr) -> ast.expr:
        said = " ".join((ast.get_source_segment(self.source, condition) or "").split())
        inner = self.visit(condition)
        if any(isinstance(part, ast.NamedExpr) for part in ast.walk(condition)):
            # A name is bound inside, and is used behind it.
            return inner  # type: ignore[no-any-return]
        self.watch.sites.append(Site(self.path, condition.lineno, said))
        number = ast.Constant(len(self.watch.sites) - 1)
        call = ast.Call(ast.Attribute(ast.Name("watch_", ast.Load()), way, ast.Load()), [number, inner], [])
        return ast.copy_location(call, condition)

    def visit_BoolOp(self, node: ast.BoolOp) -> ast.expr:
        """Watch operands."""
        way = "holds" if isinstance(node.op, ast.Or) else "fails"
        node.values = [self._reporting(way, operand) for operand in node.values]
        return node

    def visit_If(self, node: ast.If) -> ast.stmt:
        """Watch what a branch is taken for."""
        node.test = self._reporting("holds", node.test)
        node.body = [self.visit(one) for one in node.body]
        node.orelse = [self.visit(one) for one in node.orelse]
        return node

    def visit_IfExp(self, node: ast.IfExp) -> ast.expr:
        """Watch what a value is chosen for."""
        node.test = self._reporting("holds", node.test)
        node.body, node.orelse = self.visit(node.body), self.visit(node.orelse)
        return node

    def visit_comprehension(self, node: ast.comprehension) -> ast.comprehension:
        """Watch filters."""
        node.iter = self.visit(node.iter)
        node.ifs = [self._reporting("fails", one) for one in node.ifs]
        return node


class Loader(SourceFileLoader):
    """Load a module with its conditions watched."""

    def path_stats(self, path: str) -> Mapping[str, Any]:
        """Refuse, so that the compiled module is neither taken from a cache nor kept in it."""
        raise OSError(path)

    def source_to_code(self, data: bytes, path: str, *, _optimize: int = -1) -> CodeType:  # type: ignore[override]
        """Compile the source, watched."""
        source = data.decode()
        tree = Watched(Path(path), source).visit(ast.parse(source))
        return compile(ast.fix_missing_locations(tree), path, "exec", dont_inherit=True)

    def exec_module(self, module: ModuleType) -> None:
        """Run the module, with what its conditions report to."""
        module.__dict__["watch_"] = WATCH
        super().exec_module(module)


class Finder(MetaPathFinder):
    """Find the modules below a folder, to be watched."""

    def __init__(self, folder: Path) -> None:
        """Take the folder."""
        self.folder = folder

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Find a module, as usual."""
        found = PathFinder.find_spec(fullname, path, target) if fullname.startswith("fuzzytime.") else None
        if found is None or found.origin is None or self.folder not in Path(found.origin).parents:
            return None
        found.loader = Loader(fullname, found.origin)
        return found


def texts() -> list[str]:
    """Give every text of the corpora, the examples and the tests, once each."""
    found: list[str] = []
    for path in sorted(ROOT.glob("examples/**/*.txt")):
        found += path.read_text("utf-8").splitlines()
    for path in sorted(ROOT.glob("tests/language/corpus/**/*.yaml")):
        found += _strings(yaml.safe_load(path.read_text("utf-8")))
    for path in sorted(ROOT.glob("tests/**/*.py")):
        nodes = ast.walk(ast.parse(path.read_text("utf-8")))
        said = (
            node.value for node in nodes if isinstance(node, ast.Constant) and isinstance(node.value, str)
        )
        found += (text for text in said if " " in text)
    return [text for text in dict.fromkeys(found) if len(text) <= LONGEST]


def _strings(tree: object) -> Iterator[str]:
    if isinstance(tree, str):
        yield tree
    elif isinstance(tree, dict):
        for key, value in tree.items():
            yield from (*_strings(key), *_strings(value))
    elif isinstance(tree, list):
        for value in tree:
            yield from _strings(value)


def _too_long(_number: int, _frame: object) -> None:
    raise TimeoutError


def main() -> None:
    """Print the conditions that no text shows."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path, help="a package of fuzzytime/language")
    folder = parser.parse_args().folder.resolve()
    if not folder.is_dir():
        parser.error(f"{folder}: there is no such folder")
    sys.meta_path.insert(0, Finder(folder))
    signal.signal(signal.SIGALRM, _too_long)
    language = importlib.import_module("fuzzytime.language")
    for module in pkgutil.walk_packages(language.__path__, "fuzzytime.language."):
        importlib.import_module(module.name)
    reader, read = language.Language.shipped(), texts()
    caches = [one for one in get_objects() if isinstance(one, _lru_cache_wrapper)]
    caches = [one for one in caches if one.__module__.startswith("fuzzytime") and one.__name__ not in KEPT]

    def reading(number: int) -> str:
        for cache in caches:
            cache.cache_clear()
        signal.setitimer(signal.ITIMER_REAL, LIMIT)
        try:
            return repr(reader.read(read[number], now=NOW))
        except Exception as error:  # noqa: BLE001 - without a guard anything may be raised, which is another reading
            return type(error).__name__
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0.0)

    before = []
    for number in range(len(read)):
        WATCH.text = number
        before.append(reading(number))
    WATCH.text = None
    for place, site in enumerate(WATCH.sites):
        WATCH.off = place
        if len(site.texts) <= MOST and all(reading(number) == before[number] for number in site.texts):
            where = f"{site.path.relative_to(ROOT)}:{site.line}"
            print(json.dumps({"where": where, "condition": site.said, "texts": len(site.texts)}))


if __name__ == "__main__":
    main()
