"""A plan's JSON is what its schema says, and true: nobody is in two places, figures follow from functions."""

import itertools
import json
import math
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest

from console import ROOT
from terminal.running import ran

SCHEMA = json.loads((ROOT / "cli" / "fuzzytime_cli" / "schema" / "plan-1.json").read_text())
EXAMPLES = sorted(path.name for path in (ROOT / "examples").iterdir() if path.suffix in {".txt", ".yaml"})
NOW = ("--now", "2026-03-04T09:00", "--zone", "Europe/Berlin")

Json = dict[str, Any]


def planned(tmp_path: Path, *arguments: str) -> Json:
    done = ran("plan", *arguments, "--format", "json", folder=tmp_path)
    plan: Json = json.loads(done.out)
    jsonschema.validate(plan, SCHEMA)
    return plan


def psi(function: Json, times: Any) -> Any:  # noqa: ANN401 - a float or an array
    """ψ recomputed from what is printed, by its definition and nothing of ours."""
    at, given = np.asarray(times, float), function["parameters"]
    if function["model"] == "trapezoid":
        rise, full, end, fall = (given[n] for n in ("rise_start", "full_start", "full_end", "fall_end"))
        up = np.where(at >= full, 1.0, (at - rise) / (full - rise) if full > rise else 0.0)
        down = np.where(at <= end, 1.0, (fall - at) / (fall - end) if fall > end else 0.0)
        return np.clip(np.minimum(up, down), 0, 1)
    if function["model"] == "bell":
        distance = np.abs((at - given["centre"]) / given["width"])
        return 1 / (1 + distance ** (2 * given["slope"]))
    return np.interp(at, given["times"], given["values"], left=0, right=0)


@pytest.mark.parametrize("name", EXAMPLES)
def test_no_agent_does_two_things_at_once(name: str, tmp_path: Path) -> None:
    plan = planned(tmp_path, f"examples/{name}", *NOW)
    taken = [(s["agent"], s["start_s"], s["end_s"]) for s in plan["skills"]]
    taken += [
        (agent, busy["start_s"], busy["end_s"])
        for busy in plan["busy"]
        for agent in ([busy["agent"]] if busy["agent"] else range(1, plan["agents"] + 1))
    ]
    taken.sort()
    for first, second in itertools.pairwise(taken):
        assert first[0] != second[0] or first[2] <= second[1] + 1e-9


@pytest.mark.parametrize("name", EXAMPLES)
def test_figures_follow_from_the_printed_functions(name: str, tmp_path: Path) -> None:
    plan = planned(tmp_path, f"examples/{name}", *NOW)
    product = weighted = 1.0
    for skill in plan["skills"]:
        again = float(psi(skill["satisfaction_function"], skill["start_s"]))
        assert skill["satisfaction"] == pytest.approx(again, abs=1e-9)
        assert skill["alone"] >= skill["satisfaction"] - 1e-9
        product *= max(skill["satisfaction"], plan["threshold"])
        weighted *= max(skill["satisfaction"], plan["threshold"]) ** skill["priority"]
    assert plan["satisfaction"]["product"] == pytest.approx(product)
    assert plan["satisfaction"]["weighted_cost"] == pytest.approx(-math.log(weighted), abs=1e-9)
    assert plan["certificate"]["upper_bound"] >= weighted - 1e-9


def best_product(skills: list[Json], threshold: float, step: float) -> float:
    """The optimum on a grid by trying every order: each skill as a whole vector over its end times."""
    last = max(s["satisfaction_function"]["parameters"]["fall_end"] for s in skills)
    # Behind the last wish there is room for what is rejected.
    grid = np.arange(0, last + sum(s["duration_s"] for s in skills) + step, step)
    costs = [-np.log(np.maximum(psi(s["satisfaction_function"], grid), threshold)) for s in skills]
    lengths = [round(s["duration_s"] / step) for s in skills]
    best = np.inf
    for order in itertools.permutations(range(len(skills))):
        done = np.zeros(grid.size)
        for index in order:
            after = np.full(grid.size, np.inf)
            reach = grid.size - lengths[index]
            after[lengths[index] :] = (done + costs[index])[:reach]
            done = np.minimum.accumulate(after)
        best = min(best, done[-1])
    return float(np.exp(-best))


@pytest.mark.parametrize(
    "wishes",
    [
        (
            "Fry the bacon in exactly two minutes",
            "Toast the bread in exactly two minutes",
            "Set the table now",
        ),
        ("Wash the pan in two minutes", "Peel the potatoes now", "Stir the soup in exactly one minute"),
        (
            "Paint the door in exactly 4 minutes",
            "Sand the door now",
            "Sweep the floor in exactly five minutes",
        ),
    ],
)
def test_the_product_is_the_optimum(wishes: tuple[str, ...], tmp_path: Path) -> None:
    plan = planned(tmp_path, *itertools.chain.from_iterable(("-i", wish) for wish in wishes), *NOW)
    assert plan["certificate"]["status"] == "optimal"
    grid_best = best_product(plan["skills"], plan["threshold"], 5.0)
    # Continuous time can only be better than a grid, and by no more than the grid's steps allow.
    assert grid_best - 1e-9 <= plan["satisfaction"]["product"] <= grid_best * 1.05
    assert plan["satisfaction"]["product"] < 1


def test_two_jobs_for_the_same_moment_get_a_plan_that_a_person_accepts(tmp_path: Path) -> None:
    task = tmp_path / "two.yaml"
    task.write_text(
        "instructions:\n"
        "  - {say: Iron the shirt in about ten minutes, duration: 5 min}\n"
        "  - {say: Feed the cat in about ten minutes, duration: 5 min}\n"
    )
    plan = planned(tmp_path, str(task), *NOW)
    assert plan["satisfaction"]["least"] > 0.9
    assert all(240 <= skill["start_s"] <= 900 for skill in plan["skills"])


def test_a_skill_is_printed_as_the_terminal_note_has_it(tmp_path: Path) -> None:
    plan = planned(tmp_path, "-i", "Flip the pancakes in the pan in about two minutes", *NOW)
    (skill,) = plan["skills"]
    assert skill["operation"] == {"verb": "flip", "object": "the pancakes", "place": "in the pan"}
    assert skill["requirement"] | {"text": ""} == {
        "text": "", "reference": "start", "constraint": "at", "preposition": "in", "word": None,
        "fuzziness": "about", "number": 2, "unit": "minute",
        "t_spec_s": 120, "earliest_s": 120, "latest_s": 120,
    }  # fmt: skip
    assert skill["rules"][0]["source"].startswith("rules/lookup.yaml:")
    assert skill["done_s"] >= skill["end_s"] == skill["start_s"] + skill["duration_s"]
    low, high = skill["acceptable"]
    assert psi(skill["satisfaction_function"], high) == pytest.approx(0.5)
    assert 0 <= low < 120 < high
