"""Which files a batch is of."""

from collections.abc import Iterator, Sequence
from pathlib import Path

from fuzzytime_cli.faults import NoInputError
from fuzzytime_cli.settings import PROJECT_CUSTOMS, PROJECT_FILE, PROJECT_RULES

ENDINGS = frozenset({".txt", ".yaml", ".yml"})
_OURS = frozenset({PROJECT_CUSTOMS, PROJECT_FILE, PROJECT_RULES})


def task_files(named: Sequence[Path]) -> list[Path]:
    """Give files as they are named, and of a folder the task files below it, by name, each once.

    What is hidden in a folder is left out, and so are this program's own settings, rule tables and customs.

    Raises
    ------
    NoInputError
        If there is none.
    """
    found = dict.fromkeys(file for path in named for file in _files_of(path))
    if not found:
        raise NoInputError(
            f"{', '.join(map(str, named))}: there is no task file ({', '.join(sorted(ENDINGS))})"
        )
    return list(found)


def _files_of(path: Path) -> Iterator[Path]:
    if not path.is_dir():
        yield path  # one that is not there has its error beside the others' answers
        return
    for file in sorted(path.rglob("*")):
        hidden = any(part.startswith(".") for part in file.relative_to(path).parts)
        # A link that leads nowhere has its error beside the others' answers.
        found = file.is_file() or (file.is_symlink() and not file.exists())
        if file.suffix.lower() in ENDINGS and file.name not in _OURS and not hidden and found:
            yield file
