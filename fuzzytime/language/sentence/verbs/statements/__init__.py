"""What is only told: ``statements``, with their ``statement_trees``, and what is told ``beside_orders``.

Who is ``called`` and acts, and who is ``stated`` to do it.
"""
