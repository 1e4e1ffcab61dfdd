"""The files of the installed model, compared with the official ones."""

import hashlib
import importlib
import importlib.util
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

from fuzzytime.language.sentence.trees.model import ModelError, ModelPackage


class FileState(StrEnum):
    """How a file of the model compares with the official one."""

    OFFICIAL = "official"
    DIFFERENT = "different"
    MISSING = "missing"


@dataclass(frozen=True, slots=True)
class ModelFile:
    """One file of the model, by its path below the model's data, and how it compares."""

    path: str
    state: FileState


def official_hashes() -> dict[str, str]:
    """Give the sha256 of the official files of en_core_web_sm 3.8.0, by path."""
    table = Path(__file__).with_name("model_sha256.txt").read_text("utf-8")
    rows = (line.split(maxsplit=1) for line in table.splitlines() if line and not line.startswith("#"))
    return {path: digest for digest, path in rows}


def model_files(package: ModelPackage) -> tuple[ModelFile, ...]:
    """Compare the installed model's files with the official ones.

    Raises
    ------
    ModelError
        If the model's folder is not there.
    """
    found = importlib.util.find_spec(package.name)
    if found is None or found.origin is None:
        raise ModelError(f"the model {package.name} must be installed: its folder is not there")
    folder = Path(found.origin).parent
    data = next((path.parent for path in sorted(folder.glob("*/config.cfg"))), folder)
    return tuple(
        ModelFile(path, _state(data / path, digest)) for path, digest in sorted(official_hashes().items())
    )


def _state(path: Path, digest: str) -> FileState:
    try:
        with path.open("rb") as stream:
            found = hashlib.file_digest(stream, "sha256").hexdigest()
    except OSError:
        return FileState.MISSING
    return FileState.OFFICIAL if found == digest else FileState.DIFFERENT
