"""What is told of wishes: ``reports`` of how it goes and, of one thing, ``told_of``.

``news`` of what happens, what was ``awaited``, and what a clause tells ``of_planned`` things in any words, or
of the ``open_hours`` of where they are done.
"""
