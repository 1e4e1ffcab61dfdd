"""Where instructions begin and end: the first pass, which ends in ``drafts``.

Lines and sentences
    A ``segment`` ends at a sentence, at "then" (``connectives``, but ``next_ones``), before a verb or
    ``behind_happenings``; ``list_marks``, ``leading_tags``, ``dividers`` between ``entries``, ``heads`` and
    ``runs`` of them, ``switches``, ``order_words``, ``corrections``, ``corrected_things``,
    ``retractions``, ``asides``, ``asides_of_hours``.
What is none
    ``messages``: what somebody is told, which begins in ``told_clauses``.
Further orders of one sentence
    Segments ``waiting`` for their trees (``parsing``, ``mended_trees``, ``mended_verbs``,
    ``mended_things``, ``places_in_front``, ``reminded_of``, ``leading_markers``), and ``cuts`` once they
    have one: ``calls``, ``reasons``, ``further_orders``, ``orders_in_front``, ``overlooked_orders``,
    ``orders_beside_times``, ``orders_behind_names``, ``same_doers``, ``verbs_left_out``,
    ``further_steps``, ``fronts``, ``run_on_orders``. What a further
    wish shares with the first is ``borrowed``: where (``borrowing``), and by what is said of both
    (``further_wishes``, ``frames``, ``other_things``).
Times that belong to something
    ``named_events``, ``event_edges``, ``in_between``, ``instances``, ``gaps``, ``told_lengths``.
"""
