"""What is told of wishes: ``reports`` of how it goes, what is ``told_done``.

``news`` of what happens, and what was ``awaited``.
"""
