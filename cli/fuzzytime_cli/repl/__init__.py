"""The conversation in the terminal: instructions as one types, and commands that start with a colon."""

from fuzzytime_cli.repl.start import converse

__all__ = ["converse"]
