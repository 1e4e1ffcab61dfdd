"""What is only told: ``statements``, with their ``statement_trees``.

Who is ``called`` and acts, and who is ``stated`` to do it.
"""
