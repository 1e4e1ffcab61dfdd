"""Where the command begins: whatever takes time to import is imported where Ctrl-C is no error."""

INTERRUPTED = 130
"""`Exit.INTERRUPT`, before anything is imported."""


def main() -> None:
    """Run the command as the shell does; end quietly if somebody stops it before it has begun."""
    try:
        from fuzzytime_cli.app import main as command

        command()
    except KeyboardInterrupt:
        raise SystemExit(INTERRUPTED) from None
