"""Where the work is done: processes or threads of this machine, or a cluster's, all through joblib."""

import itertools
import logging
import warnings
from collections.abc import Iterable, Iterator
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass

from fuzzytime.errors import FuzzytimeError
from fuzzytime_cli.batch.answers import Job, Recipe, answer, failure
from fuzzytime_cli.choices import BatchBackend
from fuzzytime_cli.exits import Exit
from fuzzytime_cli.faults import ConfigError, UsageError

WINDOW = 256
"""Files that are in memory at once."""

CONNECT = 20.0
"""Seconds to wait for a cluster."""


@dataclass(frozen=True, slots=True)
class Workers:
    """How many, of which kind, and where; without ``jobs`` all that there are."""

    backend: BatchBackend = BatchBackend.LOKY
    jobs: int | None = None
    scheduler: str | None = None

    @property
    def is_cluster(self) -> bool:
        """Whether the work is done elsewhere."""
        return self.backend in {BatchBackend.DASK, BatchBackend.RAY}

    def answers(self, jobs: Iterable[Job], recipe: Recipe) -> Iterator[str]:
        """Give the answers in the order of the files, holding few of both in memory.

        Raises
        ------
        UsageError, ConfigError
            If the cluster is not named, or what speaks to it is not installed.
        FuzzytimeError
            If the cluster cannot be reached, or fails.
        """
        if self.jobs == 1 and not self.is_cluster:
            yield from (answer(job, recipe) for job in jobs)
            return
        waiting = iter(jobs)
        with self._backend(), warnings.catch_warnings():
            # That workers stop with the batch, or for want of memory, is told where it costs an answer.
            warnings.filterwarnings("ignore", r"\d+ tasks |A worker stopped", UserWarning)
            while window := list(itertools.islice(waiting, WINDOW)):
                yield from self._window(window, recipe)

    def _window(self, window: list[Job], recipe: Recipe) -> Iterator[str]:
        """Plan some files; where a worker is lost, each that has no answer yet for itself."""
        import joblib
        from joblib.externals.loky.process_executor import TerminatedWorkerError

        call = joblib.delayed(answer)
        answered = 0
        try:
            together = joblib.Parallel(self.jobs or -1, return_as=self._return_as)
            for line in together(call(job, recipe) for job in window):
                yield line
                answered += 1
        except TerminatedWorkerError:
            for job in window[answered:]:
                try:
                    (line,) = joblib.Parallel(2)([call(job, recipe)])
                except TerminatedWorkerError:
                    reason = "whoever planned it was ended from outside, as for want of memory"
                    line = failure(job, recipe, (int(Exit.FAILURE), reason))
                yield line

    @property
    def _return_as(self) -> str:
        """How joblib gives answers: one by one in order; Ray's backend knows only a window as a whole."""
        return "list" if self.backend is BatchBackend.RAY else "generator"

    def _backend(self) -> AbstractContextManager[None]:
        match self.backend:
            case BatchBackend.DASK:
                return _dask(self.scheduler)
            case BatchBackend.RAY:
                return _ray(self.scheduler)
            case _:
                return _here(self.backend, self.scheduler)


@contextmanager
def _here(backend: BatchBackend, scheduler: str | None) -> Iterator[None]:
    import joblib

    if scheduler is not None:
        raise UsageError(f"--scheduler: {backend.value} works on this machine; a cluster needs dask or ray")
    with joblib.parallel_config(backend.value):
        yield


@contextmanager
def _dask(scheduler: str | None) -> Iterator[None]:
    import joblib

    try:
        from distributed import Client
    except ImportError as error:
        raise ConfigError(_lacking(BatchBackend.DASK)) from error
    if scheduler is None:
        raise UsageError("--backend dask: say where the cluster is, as --scheduler tcp://host:8786")
    try:
        client = Client(scheduler, timeout=CONNECT, set_as_default=False)
    except (OSError, ValueError, TimeoutError) as error:
        raise FuzzytimeError(f"--scheduler: {scheduler} cannot be reached: {error}") from error
    with client, joblib.parallel_config("dask", client=client):
        yield


@contextmanager
def _ray(scheduler: str | None) -> Iterator[None]:
    import joblib

    try:
        import ray
        from ray.util.joblib import register_ray
    except ImportError as error:
        raise ConfigError(_lacking(BatchBackend.RAY)) from error
    try:
        ray.init(scheduler or "auto", log_to_driver=False, logging_level=logging.ERROR)
    except (ConnectionError, ValueError) as error:
        raise FuzzytimeError(f"--scheduler: {scheduler or 'auto'} cannot be reached: {error}") from error
    register_ray()
    try:
        with joblib.parallel_config("ray"):
            yield
    finally:
        ray.shutdown()


def _lacking(backend: BatchBackend) -> str:
    return (
        f"--backend {backend.value}: what speaks to such a cluster is not installed "
        f"(pip install 'fuzzytime-planner[{backend.value}]')"
    )
