"""Ψ_I and what follows from it: characteristic values, fits, and the paper's three questions.

To ``analyse`` is to take all of it. One instruction: ``characteristics``, ``density``, ``subgroups``,
``fitting`` of ``models``, all in ``described``. The questions: ``prepositions`` (F1), to ``compare`` groups
and their ``scale`` (F2), ``start_times`` (F3).
"""
