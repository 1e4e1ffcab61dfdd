"""Where instructions begin and end: the first pass, which ends in ``drafts``.

A ``segment`` of a ``source`` has ``openings``, and ends at a sentence, at "then" (``connectives``), at
"otherwise" (``other_cases``), or before a verb; short steps behind commas are ``steps_apart``. It waits for
its tree (``waiting``), with its ``leading_markers`` and ``fronts`` (``whole_clauses``), and is cut again in
``rounds`` once it has one (``cuts``, ``orders_beside_times``). What is ``borrowed`` holds for both. A line
alone may be a ``heading``.

``lists``
    Lines, their marks, and the entries on them.
``taken_back``
    What is said better, or let be.
``told``
    What is said beside an order: how long it takes, why, and to whom.
``events``
    What goes on, and the times that belong to it.
``mended``
    A tree for each segment, and what trees get wrong.
``further``
    Further orders of one sentence, and who they are given to.
``borrowed_words``
    Which words of the first order hold in a further one.
"""
