"""Ψ_I and what follows from it: characteristic values, fits, and the paper's three questions."""
