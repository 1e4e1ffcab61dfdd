"""Our solvers and others on the same random tasks, in one run: a table, and with ``--plot`` a picture.

    PYTHONPATH=.:benchmarks python benchmarks/scheduling.py --skills 10 20 --solvers auto cp-sat time-indexed

Costs are −log of the product of satisfactions. "gap" is how much better the geometric mean of satisfactions
could be by the proven bound: in continuous time for the library's solvers, on a grid of 5 s for the others.
CPU seconds are of all cores together, and do not depend on what else the machine does.
"""

import argparse
import math
import statistics
from collections import defaultdict
from pathlib import Path

from scheduling_peers import SOLVERS, Answer
from scheduling_tasks import Kind, random_task


def gap(answer: Answer, count: int) -> float:
    """Give exp((cost − bound) / n) − 1."""
    return math.expm1(max(0.0, answer.cost - answer.lower) / count)


def run(chosen: argparse.Namespace) -> dict[tuple[str, Kind, int], list[Answer]]:
    """Solve everything by everyone, and print a line for each."""
    answers: dict[tuple[str, Kind, int], list[Answer]] = defaultdict(list)
    for count in chosen.skills:
        for kind in chosen.kinds:
            for load in chosen.loads:
                for seed in chosen.seeds:
                    task = random_task(count, load, kind, seed, chosen.agents)
                    for name in chosen.solvers:
                        answer = SOLVERS[name](task, chosen.seconds)
                        answers[name, kind, count].append(answer)
                        print(
                            f"{kind:6} n {count:4} load {load:3} seed {seed} {name:12} "
                            f"cost {answer.cost:10.5f} bound {answer.lower:10.5f} "
                            f"gap {gap(answer, count):7.1e} {'proved' if answer.proved else 'open':6} "
                            f"{answer.seconds:7.2f} s, CPU {answer.cpu:7.2f} s",
                            flush=True,
                        )
    return answers


def table(answers: dict[tuple[str, Kind, int], list[Answer]]) -> None:
    """Print one row for each solver, kind and size."""
    print()
    print("| solver | wishes | n | proved | median CPU s | most CPU s | median gap | largest gap |")
    print("|---|---|---|---|---|---|---|---|")
    for (name, kind, count), found in answers.items():
        gaps = [gap(answer, count) for answer in found]
        used = [answer.cpu for answer in found]
        print(
            f"| {name} | {kind} | {count} | {sum(answer.proved for answer in found)}/{len(found)} "
            f"| {statistics.median(used):.2f} | {max(used):.2f} "
            f"| {statistics.median(gaps):.1e} | {max(gaps):.1e} |"
        )


def plot(answers: dict[tuple[str, Kind, int], list[Answer]], path: Path) -> None:
    """Draw CPU time by size: a dot for each task, hollow where nothing was proved."""
    import matplotlib as mpl

    mpl.use("Agg")
    import matplotlib.pyplot as plt

    kinds = list(dict.fromkeys(kind for _, kind, _ in answers))
    names = list(dict.fromkeys(name for name, _, _ in answers))
    sizes = list(dict.fromkeys(count for _, _, count in answers))
    figure, axes = plt.subplots(1, len(kinds), sharey=True, figsize=(5 * len(kinds), 4), squeeze=False)
    for axis, kind in zip(axes[0], kinds, strict=True):
        for place, name in enumerate(names):
            dots = [
                (count * (1 + 0.06 * (place - len(names) / 2)), answer)
                for (solver, which, count), found in answers.items()
                if solver == name and which == kind
                for answer in found
            ]
            for proved in (True, False):
                mine = [(x, answer.cpu) for x, answer in dots if answer.proved == proved]
                axis.scatter(
                    [x for x, _ in mine],
                    [y for _, y in mine],
                    label=name if proved else None,
                    color=f"C{place}",
                    facecolors=f"C{place}" if proved else "none",
                    s=20,
                )
        axis.set(xscale="log", yscale="log", xlabel="skills", title=f"{kind} wishes")
        axis.set_xticks(sizes, labels=[str(count) for count in sizes])
        axis.minorticks_off()
        axis.yaxis.set_major_formatter("{x:g}")
    axes[0][0].set_ylabel("CPU seconds; hollow: not proved")
    axes[0][-1].legend(loc="lower right")
    figure.tight_layout()
    figure.savefig(path, dpi=120)


def main() -> None:
    """Run, print, draw."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--skills", type=int, nargs="+", default=[10, 20, 50])
    parser.add_argument("--kinds", type=Kind, nargs="+", default=list(Kind))
    parser.add_argument("--loads", type=float, nargs="+", default=[0.6, 0.9, 1.3])
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3])
    parser.add_argument("--agents", type=int, default=1)
    parser.add_argument("--solvers", nargs="+", choices=list(SOLVERS), default=["auto"])
    parser.add_argument("--seconds", type=float, default=20.0, help="time limit for each task")
    parser.add_argument("--plot", type=Path)
    chosen = parser.parse_args()
    answers = run(chosen)
    table(answers)
    if chosen.plot:
        plot(answers, chosen.plot)


if __name__ == "__main__":
    main()
