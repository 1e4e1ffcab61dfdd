"""The commands, one a module; heavy imports wait inside them.

``plan``, ``repl``, ``run`` and ``batch``; ``parse`` and ``explain``; ``rules``, ``config`` and ``doctor``.
"""
