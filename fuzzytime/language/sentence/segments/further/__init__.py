"""Where further orders of one sentence begin.

By its tree: ``further_orders``, ``orders_in_front``, ``overlooked_orders``, ``orders_behind_names``,
``orders_behind_joints``. Without a joint: ``run_on_orders``; ``verbs_left_out``, unless they have
``own_verbs``. Each by itself: ``entries_in_a_row``. What is ``told_beside`` one. Who does them: ``calls``,
``same_doers``, ``other_doers``.
"""
