"""What verbs say: what is to be done, and what happens by itself.

What is to be done
    The verb that is meant (``actions``), also in ``small_clauses``; which of its ``moments`` is; its
    object and the rest (``operations``, ``particles``, ``verb_words``), ``places``, ``amounts``; what is
    to be ``remembered``, ``put_there``, or ``due_by_then``; ``orders_before`` the root of a tree.
What is only told
    ``statements``, with their ``statement_trees`` and ``plural_statements``; who is ``called`` and acts;
    who is ``stated`` to do it; ``happenings`` and ``named_moments`` without a verb, and ``named_deeds``;
    what else is ``named_alone``.
"""
