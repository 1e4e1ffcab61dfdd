"""A batch from its files to its lines."""

import json
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass, field
from pathlib import Path

from fuzzytime_cli.batch.answers import Job, Recipe
from fuzzytime_cli.batch.backends import Workers
from fuzzytime_cli.batch.journal import Journal
from fuzzytime_cli.exits import Exit
from fuzzytime_cli.faults import report
from fuzzytime_cli.patience import after_a_while, can_show
from fuzzytime_cli.render import plain

MOST_NAMED = 4
"""Files that could not be planned and are named."""


@dataclass(slots=True)
class Tally:
    """How many files were answered, kept from before, and not planned; the first error's code.

    ``named`` are the first files that could not be planned.
    """

    answered: int = 0
    kept: int = 0
    failed: int = 0
    code: Exit = Exit.FINE
    named: list[str] = field(default_factory=list)

    def count(self, line: str) -> None:
        """Count an answer."""
        self.answered += 1
        answer = json.loads(line)
        error = answer.get("error")
        if error is not None:
            self.failed += 1
            if len(self.named) < MOST_NAMED:
                self.named.append(str(answer["file"]))
            self.code = self.code or Exit(error["code"])

    def exit(self, *, strict: bool) -> Exit:
        """Give the first error's code where nothing could be planned or, under ``strict``, not all."""
        nothing = self.failed == self.answered and not self.kept
        return self.code if nothing or strict else Exit.FINE


def run(
    files: Sequence[Path],
    recipe: Recipe,
    workers: Workers,
    output: Path | None,
    *,
    resume: bool,
    strict: bool,
) -> Exit:
    """Answer every file in order, on standard output or into a file that can be resumed."""
    tally = Tally()
    with Journal(output, resume) if output is not None else nullcontext() as journal:

        def waiting() -> Iterator[Job]:
            for path in files:
                job = Job.of(path)
                if journal is not None and journal.holds(job, recipe):
                    tally.kept += 1
                else:
                    yield job

        with progress(len(files)) as show:
            for line in workers.answers(waiting(), recipe):
                tally.count(line)
                if journal is not None:
                    journal.add(line)
                else:
                    sys.stdout.write(line)
                    sys.stdout.flush()
                show(tally)
        if journal is not None:
            journal.put_in_order([str(path) for path in files])
    _report(tally, len(files))
    return tally.exit(strict=strict)


def _report(tally: Tally, total: int) -> None:
    """Say what is not as one would think: files that could not be planned, or that were answered before."""
    parts = [f"{tally.kept} of {total} files were answered before"] if tally.kept else []
    if tally.failed:
        more = f" and {tally.failed - len(tally.named)} more" if tally.failed > len(tally.named) else ""
        named = f"{', '.join(map(plain, tally.named))}{more}"
        parts.append(f"{tally.failed} of {total} files could not be planned ({named}): see their 'error'")
    if parts:
        report(f"fuzzytime: {'; '.join(parts)}")


@contextmanager
def progress(total: int) -> Iterator[Callable[[Tally], None]]:
    """Show on a terminal's standard error how far the batch is, once that takes a while.

    Where the answers go to a terminal they show it themselves.
    """
    if not can_show() or sys.stdout.isatty():
        yield lambda _: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (BarColumn(), MofNCompleteColumn(), TextColumn("{task.fields[failed]}"), TimeRemainingColumn())
    shown = Progress(
        *columns,
        console=Console(stderr=True),
        transient=True,
        redirect_stdout=False,
        redirect_stderr=False,
    )
    task = shown.add_task("", total=total, failed="")

    def show(tally: Tally) -> None:
        failed = f"{tally.failed} failed" if tally.failed else ""
        shown.update(task, completed=tally.answered + tally.kept, failed=failed)

    with after_a_while(shown.start, shown.stop):
        yield show
