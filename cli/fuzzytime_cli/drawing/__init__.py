"""Curves over time, in the terminal by braille and as SVG.

A ``chart`` with its ``ticks`` is drawn by ``terminal`` on a ``canvas``, or by ``svg`` in ``markup``.
"""
