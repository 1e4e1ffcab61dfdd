"""The conversation in the terminal: instructions as one types, and commands that start with a colon.

On the terminal: ``start`` reads lines, with ``completion`` and ``history``; ``turn`` answers each, with
the question that is ``pending``. What is known: ``conversation``, and for commands the ``scene``.

Commands
    ``commands`` by name: ``changing``, ``moving``, ``looking``, ``rating``, ``saving``.

Plain words, ``speaking`` of what was asked for
    The command that is ``meant``, and its ``taking``; ``which`` wishes that is of, by their ``naming`` or as
    ``parts`` of a line; ``retiming``, ``leaving_out``, ``progress``, and what is ``leaning`` on another.
    News: ``telling`` how things are, what ``happened``, what one ``has_done``.
    Questions: ``answering``, ``gaps``; ``stretches`` of time.
"""

from fuzzytime_cli.repl.start import converse

__all__ = ["converse"]
