"""Mutated rule and context files are valid, or refused with a place."""

import random

from fuzzytime.rulebook import Rulebook
from trust.fuzz_documents import READINGS, RULES, run, try_readings, try_rules


def test_the_files_that_are_mutated_are_valid_to_begin_with() -> None:
    shipped = Rulebook.shipped()
    try_rules(RULES.encode(), shipped, random.Random(1))
    try_readings(READINGS.encode(), shipped)


def test_mutated_files_are_valid_or_refused_with_places() -> None:
    failures: list[str] = []
    counts = run(600, 7, failures.append)
    assert failures == []
    assert counts["rule files refused with places"] > 200
    assert counts["rule files still valid, and used"] > 50
    assert counts["context files refused with places"] > 10
    assert sum(counts.values()) == 600
