"""Settings that all tests share."""

from hypothesis import settings

# Machines differ in speed, and a slow example is no failure; runs repeat exactly in CI.
settings.register_profile("fuzzytime", deadline=None, derandomize=True, max_examples=100)
settings.load_profile("fuzzytime")
