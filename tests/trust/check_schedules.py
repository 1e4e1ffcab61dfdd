"""Solve random tasks by every method, and compare with independent optimisers.

    PYTHONPATH=.:tests python tests/trust/check_schedules.py 300

solves 300 tasks of each family and prints what was wrong. Exit code 1 if anything was.
"""

import sys
import time

from scheduling.checks import FAMILIES, wrong, wrong_if_strict
from scheduling.random_tasks import LAST, random_bound_task


def main(count: int, first: int) -> int:
    """Check all families."""
    total = 0
    for name, family in FAMILIES.items():
        begun, bad = time.perf_counter(), 0
        for seed in range(first, first + count):
            for fault in wrong(family, seed):
                print(f"{name}: {fault}", flush=True)
                bad += 1
        print(f"{name}: {count} tasks, {bad} wrong, {time.perf_counter() - begun:.0f} s", flush=True)
        total += bad
    for seed in range(first, first + count):
        for fault in wrong_if_strict(random_bound_task(seed), LAST):
            print(f"strict: seed {seed}: {fault}", flush=True)
            total += 1
    return 1 if total else 0


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 0))
