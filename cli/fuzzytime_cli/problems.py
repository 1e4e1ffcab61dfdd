"""What cannot be in a plan as it was asked: said on standard error, and as exit code."""

import sys

from fuzzytime.interpreter import IN_THE_PLAN, Plan, Problem, ProblemKind
from fuzzytime.scheduling import Status
from fuzzytime_cli.exits import Exit
from fuzzytime_cli.faults import report, underlined

MOST_REJECTED = 20
"""Of what is rejected, so many are said one by one on standard error."""


def report_problems(made: Plan, source: str, *, shown: bool = False) -> None:
    """Say on standard error which lines were not understood, with their words underlined.

    Of many that are rejected the first are said one by one: whatever is written tells the others. Where the
    plan is ``shown``, it says of all of them why, and to whom they lost.
    """
    name = "<stdin>" if source == "-" else source
    known = {ProblemKind.REJECTED} if shown else set()
    faults = [problem for problem in made.problems if is_fault(problem) and problem.kind not in known]
    rejected = [problem for problem in faults if problem.kind is ProblemKind.REJECTED]
    untold = frozenset(rejected[MOST_REJECTED:] if len(rejected) > MOST_REJECTED + 1 else ())
    for problem in faults:
        if problem not in untold:
            report_problem(problem, name)
    if untold:
        report(f"{'fuzzytime' if source == '-i' else name}: {len(untold)} more are rejected")


def report_problem(problem: Problem, source: str) -> None:
    """Say one problem on standard error."""
    place = f"{source}:{problem.line}" if problem.line is not None else "fuzzytime"
    if problem.span is not None and problem.text:
        report(f"{place}: {problem.message}")
        sys.stderr.write(underlined(problem.text, problem.span) + "\n")
    else:
        report(f"{place}: {problem.message}")


def is_fault(problem: Problem) -> bool:
    """Say whether a problem means that something asked for cannot be in the schedule as asked."""
    return problem.kind not in {ProblemKind.NOTE, ProblemKind.WAITS}


def exit_of_plan(made: Plan, *, strict: bool) -> Exit:
    """Give the exit code of a plan: bad data where nothing, or under ``--strict`` not all, could be read."""
    unread = [problem for problem in made.problems if problem.kind not in IN_THE_PLAN]
    if unread and (strict or not made.everything):
        return Exit.BAD_DATA
    return Exit.INFEASIBLE if made.schedule.certificate.status is Status.INFEASIBLE else Exit.FINE
