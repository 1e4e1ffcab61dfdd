"""The command `fuzzytime`.

From the shell to a command
    ``entry`` starts the ``app``, which has a module of ``commands`` for each: their ``options``,
    ``parameters`` and ``choices``, within ``bounds``; ``usage`` and ``narrow`` are for the help.
    ``faults`` end in ``exits``.
What is read
    ``inputs``, ``settings``, what is ``personal`` and its ``places``; with them the ``assembly`` of the
    library's values, and the ``requests`` that are planned; ``told_states`` are what somebody says to
    be so.
What is done
    ``repl`` with its ``session``, ``live`` runs, ``batch`` of files, ``study``; ``parsing``,
    ``explaining``, and the ``checks`` of the doctor.
What is written
    ``render`` makes text harmless and ``files`` whole; ``formats`` of plans with a ``clock``,
    ``showing`` a time alone, ``drawing``, ``problems``; ``patience`` meanwhile, and the ``release``.
"""
