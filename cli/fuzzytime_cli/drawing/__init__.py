"""Curves over time, in the terminal by braille and as SVG."""
