"""A study with a known truth, shared by the station's tests."""

import pytest

from fuzzytime.study import Answers, Design, simulate
from study.truths import truth


@pytest.fixture(scope="session")
def design() -> Design:
    return Design.shipped()


@pytest.fixture(scope="session")
def answers(design: Design) -> Answers:
    return simulate(design, truth, 32, seed=1)
