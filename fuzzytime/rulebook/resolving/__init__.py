"""From a requirement to ψ: lookup, rules, clauses, and adding what is fuzzy to what is fuzzy.

A ``question`` gets its ``answer``: by rules (``inference``), which ``adapt`` a model, or by ``clauses``, or
``beside`` what is fuzzy itself (``extension``). From a moment of an ``execution`` to its start. The
``resolution`` keeps why, with ``reasons`` and ``evidence``, what there is for ``drawing``, and its
``dependence`` on signals.
"""
