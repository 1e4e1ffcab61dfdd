"""What stands around the times of a text, by the dependency tree: operations, clauses, references.

Two passes read a text. The first cuts it into parts and gives each a tree, and each part is sketched; the
second grounds the sketches and resolves what they say of each other. A construction is a module, named
after what it reads.

The first pass (``drafts``)
    Lines and sentences: ``headings``, ``list_marks``, ``segments``, ``corrections``, ``asides``.
    Trees: ``model``, ``parse_cache``, ``tree``, ``tags``, ``tokens``, ``labels``.
    Trees mended: ``statement_trees``, ``called``.
    Further orders and statements of one sentence: ``waiting``, ``cuts``, ``further_orders``,
    ``orders_in_front``, ``overlooked_orders``, ``orders_beside_times``, ``statements``,
    ``named_events``, ``fronts``.

Sketches (``sketches``; that of one part is a ``sketch``)
    Times and clauses of a part: ``said_of_time``.
    What is to be done: ``actions``, ``operations``, ``places``, ``small_clauses``, ``amounts``,
    ``order_words``, ``wording``.
    What is only told: ``stated``, ``happenings``, ``elsewhere``.
    Where clauses stand: ``clauses``, ``before_markers``, ``event_edges``.
    What clauses say: ``clause``, ``clause_contents``, ``clause_sides``, ``conditions``,
    ``comparisons``, ``deadlines_of_clauses``, ``times_of_events``, ``in_between``.
    What parts lend each other: ``lending``, ``pairs``, ``said_again``, ``instances``, ``both_sides``,
    ``turns``, ``gaps``, ``at_once``, ``days_apart``, ``waited``.

The second pass (``compose``)
    What is asked for, and what is none: ``asked_for``, ``doubts``, ``negations``, ``contradictions``.
    What words name: ``pronouns``, ``named``, ``content_words``, ``references``.
    Times that count from something else: ``anchors``, ``phrase_anchors``, ``clause_requirements``,
    ``connectives``, ``at_events``, ``days_of_events``, ``prepared``, ``clock_times``, ``usual_hours``.
    Lengths: ``lengths``, ``told_lengths``.
"""
