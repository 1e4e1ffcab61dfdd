"""One file's answer: its plan or its error, by the schema `fuzzytime-batch/1`."""

import hashlib
import json
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import Any

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import Interpreter
from fuzzytime_cli.assembly import Assembly
from fuzzytime_cli.exits import Exit
from fuzzytime_cli.faults import code_of, message_of
from fuzzytime_cli.formats.document import document_of
from fuzzytime_cli.inputs.source import bytes_of, source_of
from fuzzytime_cli.options import Understanding
from fuzzytime_cli.problems import exit_of_plan
from fuzzytime_cli.release import installed_version
from fuzzytime_cli.requests import request_from

SCHEMA = "fuzzytime-batch/1"

Json = dict[str, Any]
"""A JSON object; its shape is the schema's matter, not the type checker's."""


@dataclass(frozen=True, slots=True)
class Recipe:
    """How every file of a batch is planned; two with one fingerprint give one answer."""

    fingerprint: str
    assembly: Assembly = field(compare=False)
    understanding: Understanding = field(compare=False)


@dataclass(frozen=True, slots=True)
class Job:
    """A file to plan: its name, and its bytes, so that whoever plans it needs no access to it.

    ``refused`` says, by exit code and message, why there are no bytes.
    """

    name: str
    content: bytes = b""
    refused: tuple[int, str] | None = None

    @classmethod
    def of(cls, path: Path) -> "Job":
        """Read a file."""
        try:
            return cls(str(path), bytes_of(str(path)))
        except (FuzzytimeError, OSError) as error:
            return cls(str(path), refused=told_of(error))

    @property
    def sha256(self) -> str | None:
        """The hash of its bytes; None where there are none."""
        return None if self.refused else hashlib.sha256(self.content).hexdigest()


def recipe_of(assembly: Assembly, understanding: Understanding) -> Recipe:
    """Fix now for all files, and fingerprint everything that an answer depends on beside its file.

    A now that was not given is no part of the fingerprint: an answer of another moment stays an answer.
    """
    parts = [installed_version(), str(assembly.now), str(assembly.zone), *(understanding.ctx or ())]
    settings = assembly.settings
    parts += [f"{name}={s.value} {settings.is_asked(name)}" for name, s in sorted(settings.values.items())]
    tables = [
        *assembly.rule_files(),
        *assembly.customs_files(),
        *([understanding.context] if understanding.context else []),
    ]
    parts += [hashlib.sha256(path.read_bytes()).hexdigest() for path in tables if path.is_file()]
    fingerprint = hashlib.sha256("\0".join(parts).encode("utf-8", "surrogatepass")).hexdigest()[:16]
    return Recipe(fingerprint, assembly.beginning(assembly.moment()), understanding)


def answer(job: Job, recipe: Recipe) -> str:
    """Plan a file and give its answer as a line of JSON; every error of the file is an answer too."""
    if job.refused is not None:
        return failure(job, recipe, job.refused)
    try:
        return _line(job, recipe, {"plan": _plan(job, recipe)})
    except Exception as error:  # noqa: BLE001 - even a defect that one file shows must not end the others
        return failure(job, recipe, told_of(error))


def told_of(error: BaseException) -> tuple[int, str]:
    """Give an error as its exit code and message."""
    return int(code_of(error)), message_of(error)


def failure(job: Job, recipe: Recipe, told: tuple[int, str]) -> str:
    """Give the answer of a file that cannot be planned."""
    return _line(job, recipe, {"error": {"code": told[0], "message": told[1]}})


def _line(job: Job, recipe: Recipe, result: Json) -> str:
    head = {"schema": SCHEMA, "file": job.name, "sha256": job.sha256, "settings": recipe.fingerprint}
    return json.dumps({**head, **result}, allow_nan=False, separators=(",", ":")) + "\n"


def _plan(job: Job, recipe: Recipe) -> Json:
    assembly = recipe.assembly
    interpreter = _interpreter(recipe)
    source = source_of(job.content, Path(job.name))
    request = request_from(source, [], assembly, recipe.understanding, interpreter.rulebook.signals)
    made = assembly.plan(request, interpreter)
    if exit_of_plan(made, strict=False) is Exit.BAD_DATA:
        raise FuzzytimeError("; ".join(dict.fromkeys(problem.message for problem in made.problems)))
    return document_of(made)


@lru_cache(maxsize=2)
def _interpreter(recipe: Recipe) -> Interpreter:
    """Load language and rules once a process."""
    return recipe.assembly.interpreter()
