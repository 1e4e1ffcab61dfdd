"""The verb that is meant (``actions``), also in ``small_clauses``, and which of its moments is.

``complements`` are the verbs below another; ``orders_before`` the root of a tree.
"""
