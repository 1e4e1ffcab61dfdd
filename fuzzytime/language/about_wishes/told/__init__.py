"""What is told of wishes: ``reports`` of how it goes and, of one thing, ``told_of``.

``news`` of what happens, and what was ``awaited``.
"""
