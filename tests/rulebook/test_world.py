"""What a context tells over time."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import product
from typing import cast

import numpy as np
import pytest

from fuzzytime.context.series import Series
from fuzzytime.rulebook.over_time.world import MOST_COMBINATIONS, World
from fuzzytime.rulebook.tables.contents import Tables


@dataclass(frozen=True)
class Weighted:
    """A series of which only its forecast's weights are known."""

    components: tuple[float, ...]


def world_of(weights: Mapping[str, tuple[float, ...]]) -> World:
    series = {name: cast("Series", Weighted(parts)) for name, parts in weights.items()}
    return World(cast("Tables", None), series, {})


@pytest.mark.parametrize("seed", range(5))
def test_the_likeliest_combinations_of_forecasts_are_followed(seed: int) -> None:
    generator = np.random.default_rng(seed)
    weights = {name: tuple(generator.dirichlet(np.ones(3)).tolist()) for name in "abcd"}
    all_of_them = sorted((math.prod(picked) for picked in product(*weights.values())), reverse=True)
    expected = np.array(all_of_them[:MOST_COMBINATIONS])
    found = world_of(weights).combinations(weights)
    assert [part.weight for part in found] == pytest.approx(expected / expected.sum())
    for part in found:
        likelihood = math.prod(weights[name][index] for name, index in part.components.items())
        assert likelihood / expected.sum() == pytest.approx(part.weight)


def test_forty_signals_have_no_more_combinations_than_two() -> None:
    weights = {f"signal {number}": (0.5, 0.3, 0.2) for number in range(40)}
    assert len(world_of(weights).combinations(weights)) == MOST_COMBINATIONS
