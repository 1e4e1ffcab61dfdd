"""Mutated rule, customs, context, task and calendar files are valid, or refused with a place."""

import random

import pytest

from fuzzytime.rulebook import Rulebook
from trust.fuzz_documents import KINDS, Kind, run


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_the_files_that_are_mutated_are_valid_to_begin_with(kind: Kind) -> None:
    kind.use(kind.text.encode(), Rulebook.shipped(), random.Random(1))


def test_mutated_files_are_valid_or_refused_with_places() -> None:
    failures: list[str] = []
    counts = run(600, 7, failures.append)
    assert failures == []
    assert counts["rule files refused with places"] > 200
    assert counts["rule files still valid, and used"] > 20
    assert counts["customs files refused with places"] > 10
    assert counts["customs files still valid, and used"] > 0
    assert counts["context files refused with places"] > 10
    assert counts["task files refused with places"] > 50
    assert counts["task files still valid, and used"] > 3
    assert counts["calendar files still valid, and used"] > 10
    assert sum(counts.values()) == 600
