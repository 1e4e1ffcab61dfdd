"""Where the command begins: whatever takes time to import is imported where Ctrl-C is no error."""

import gc

INTERRUPTED = 130
"""`Exit.INTERRUPT`, before anything is imported."""

SELDOM = 200_000
"""New objects after which Python looks for circles that nobody refers to any more."""


def main() -> None:
    """Run the command as the shell does; end quietly if somebody stops it before it has begun."""
    try:
        # Most of what a short command makes stays until its end: looking through it every 700 objects, and
        # once more on the way out, takes a fifth of its time.
        gc.set_threshold(SELDOM)
        from fuzzytime_cli.app import main as command

        command()
    except KeyboardInterrupt:
        raise SystemExit(INTERRUPTED) from None
