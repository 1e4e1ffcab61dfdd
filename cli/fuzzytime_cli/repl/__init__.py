"""The conversation in the terminal: instructions as one types, and commands that start with a colon.

On the terminal
    ``start`` reads lines, some of them ``together``, with ``completion`` and ``history``; ``turn`` answers
    each, with the question that is ``pending``.
What a line may be, beside an instruction
    One of the ``commands``, or ``plain_words`` that mean one, or one of the ``questions``.
What is known
    The ``conversation``, its plans ``compared``, and for commands the ``scene``, with what is ``typed``;
    ``which`` wishes are meant, by their ``naming``, or which ``parts`` of one, ``without`` which it may be;
    ``bounds`` of their times.
"""

from fuzzytime_cli.repl.start import converse

__all__ = ["converse"]
