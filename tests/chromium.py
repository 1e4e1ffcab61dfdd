"""The browser of tests and pictures: Debian's Chromium, or whichever is named, without a window."""

import os
import shutil

ARGUMENTS = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]


def chromium() -> str | None:
    """Find Chromium: where FUZZYTIME_CHROMIUM says, or on the path."""
    return (
        os.environ.get("FUZZYTIME_CHROMIUM") or shutil.which("chromium") or shutil.which("chromium-browser")
    )
