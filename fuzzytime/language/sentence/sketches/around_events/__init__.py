"""Times that events give: ``at_events``, on ``days_of_events``, ``in_turns`` with what is repeated.

What is ``prepared`` for what happens; what the clauses require (``clause_requirements``).
"""
