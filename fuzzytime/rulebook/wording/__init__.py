"""Where words meet the tables: rows, things, terms, numbers and clauses that a text names.

Rows by ``lookup``; things and terms by ``phrases``; numbers that are ``measured``, and ``thresholds``;
clauses by ``sentences``, several of them ``joined``; what somebody tells to be so by ``told``.
"""
