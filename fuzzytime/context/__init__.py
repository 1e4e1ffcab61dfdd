"""Readings of the world over time, and forecasts of them."""
