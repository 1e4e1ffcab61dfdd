"""What all tests share: settings of Hypothesis, signals as a terminal gives them, and a browser."""

import gc
import os
import shutil
import signal
import tempfile
from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest
from hypothesis import settings

from chromium import ARGUMENTS, chromium
from console import CACHE
from fuzzytime_cli.entry import SELDOM

if TYPE_CHECKING:
    from playwright.sync_api import Browser

# Machines differ in speed, and a slow example is no failure; runs repeat exactly in CI.
settings.register_profile("fuzzytime", deadline=None, derandomize=True, max_examples=100)
settings.load_profile("fuzzytime")

# A shell without job control starts what runs in the background deaf to Ctrl-C, and so would be every
# program that a test starts, to interrupt it.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

# As the command does: what a test makes is mostly gone with it, without anybody looking for circles.
gc.set_threshold(SELDOM)


def pytest_configure(config: pytest.Config) -> None:
    """Keep the tables and parses of all commands in one place: a process that a test starts begins sooner."""
    if CACHE not in os.environ:
        # The processes that share the tests find it there.
        folder = os.environ[CACHE] = tempfile.mkdtemp(prefix="fuzzytime-tests-")
        config.add_cleanup(lambda: shutil.rmtree(folder, ignore_errors=True))


def pytest_collection_finish() -> None:
    """Spare what stays until the end of the session, which is most, from being looked through again."""
    gc.collect()
    gc.freeze()


@pytest.fixture(scope="module")
def browser() -> Iterator["Browser"]:
    """Start Chromium; where it or what drives it is not installed, pages are not tried, and that is said."""
    sync_api = pytest.importorskip(
        "playwright.sync_api", reason="Playwright is not installed: pages are not tried"
    )
    path = chromium()
    if path is None:
        pytest.skip("no Chromium is installed: pages are not tried")
    with sync_api.sync_playwright() as playwright:
        found = playwright.chromium.launch(executable_path=path, args=ARGUMENTS)
        yield found
        found.close()
