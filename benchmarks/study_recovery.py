"""How well a study recovers a known truth: corners, and whether groups that differ are told apart.

``PYTHONPATH=. python benchmarks/study_recovery.py [STUDIES]`` simulates that many studies, 20 by default, of
the paper's design with 32 participants, individual widths and a jittering hand, each by a seed of its own.
"""

import sys

import numpy as np
from study_truth import truth

from fuzzytime.satisfaction import SatisfactionFunction, Trapezoid
from fuzzytime.study import Design, Hand, Model, Population, StudyInstruction, compare, fit, simulate
from fuzzytime.study.answers.simulate import Truth

STUDIES = 20
PARTICIPANTS = 32
EFFECTS = (1.0, 1.25, 1.5, 2.0)
"""How many times as wide the second group draws as the first."""

PAPER = {
    "robot": {0.0: 1.035, 60.0: 1.387, 600.0: 1.073, 1800.0: 0.848},
    "person": {60.0: 0.504, 1800.0: 1.052},
}
"""Widths by the time said as the paper's groups have them, one way at one minute and the other at thirty."""


def as_in_the_paper(instruction: StudyInstruction, group: str) -> SatisfactionFunction:
    """Give what a group of the paper means."""
    factor = PAPER[group].get(instruction.t_spec, 1.0)
    return truth(instruction, group).widened(factor, instruction.t_spec)


def corner_errors(design: Design, individual: float, seed: int) -> list[float]:
    """Give how far each fitted corner on the timeline lies from the truth's, in seconds."""
    population = Population(individual=individual, hand=Hand())
    drawn = simulate(design, truth, PARTICIPANTS, seed=seed, population=population).subjective()
    errors = []
    for entry in design.instructions:
        found = fit(drawn[entry.key].times, drawn[entry.key].median, Model.TRAPEZOID).function
        meant = truth(entry, "")
        if isinstance(found, Trapezoid) and isinstance(meant, Trapezoid):
            pairs = zip(found.corners, meant.corners, strict=True)
            errors += [abs(one - other) for one, other in pairs if other > design.timeline.start]
    return errors


def alarm(design: Design, meant: Truth, effect: float, seed: int) -> bool:
    """Say whether the test finds the groups of one study to differ, at 5 %."""
    groups = list(design.groups)
    widths = {groups[0]: effect**-0.5, groups[-1]: effect**0.5}
    population = Population(individual=0.2, group_widths=widths, hand=Hand())
    answers = simulate(design, meant, PARTICIPANTS, seed=seed, population=population)
    first, second = (list(answers.subjective(group).values()) for group in groups)
    return compare(first, second, seed=seed).p_value <= 0.05


def main() -> None:
    """Print how far corners lie off, and how often groups are found to differ."""
    studies = int(sys.argv[1]) if len(sys.argv) > 1 else STUDIES
    design = Design.shipped()
    print(f"{studies} studies, {PARTICIPANTS} participants, {len(design.instructions)} instructions")
    print("corners, error in s                     median    95 %     worst   above 5 s")
    for individual in (0.0, 0.1, 0.2):
        errors = np.array(
            [error for seed in range(studies) for error in corner_errors(design, individual, seed)]
        )
        print(
            f"  spread of widths {individual:<4}  {errors.size:>5} corners {np.median(errors):>8.2f}"
            f" {np.quantile(errors, 0.95):>8.2f} {errors.max():>8.2f} {np.mean(errors > 5):>9.1%}"
        )
    for effect in EFFECTS:
        found = sum(alarm(design, truth, effect, seed) for seed in range(studies))
        print(
            f"groups found to differ where the second draws {effect:<4} times as wide: {found} of {studies}"
        )
    found = sum(alarm(design, as_in_the_paper, 1.0, seed) for seed in range(studies))
    print(f"groups found to differ, as in the paper: {found} of {studies}")


if __name__ == "__main__":
    main()
