"""The verb that is meant (``actions``), also in ``small_clauses``, and which of its moments is.

``orders_before`` the root of a tree.
"""
