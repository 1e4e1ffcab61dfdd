"""How well times satisfy, for the eye: a bar, a colour, and a line about the whole plan."""

from rich.text import Text

from fuzzytime.interpreter import Plan
from fuzzytime.scheduling import Status
from fuzzytime_cli.formats.reasons import clash_sentence
from fuzzytime_cli.formats.whole import how_near, whole
from fuzzytime_cli.render import fitted

_EIGHTHS = " ▏▎▍▌▋▊▉"


BAR = 10
"""Columns of a bar."""


def bar(satisfaction: float, width: int = BAR, *, unicode: bool = True) -> str:
    """Draw a satisfaction as a bar of ``width`` columns.

    >>> bar(0.5, 4), bar(1.0, 2), bar(0.5, 4, unicode=False)
    ('██  ', '██', '##  ')
    """
    if not unicode:
        return fitted("#" * round(satisfaction * width), width)
    full, part = divmod(round(satisfaction * width * 8), 8)
    return fitted("█" * full + (_EIGHTHS[part] if part else ""), width)


def style_of(satisfaction: float, *, rejected: bool = False) -> str:
    """Give the colour that goes with a satisfaction, for those who see colour."""
    if rejected:
        return "red"
    return "green" if satisfaction >= 0.8 else "yellow" if satisfaction >= 0.4 else "red"


def summary(plan: Plan) -> Text:
    """Say how well a whole plan satisfies, and what is proved of that."""
    schedule, certificate = plan.schedule, plan.schedule.certificate
    if not plan.skills:
        return Text("Nothing has a time yet.", style="bold")
    line = Text("Satisfaction ", style="bold")
    shown = whole(schedule.satisfaction, fails=schedule.geometric_mean == 0)
    line.append(shown, style_of(schedule.geometric_mean))
    if len(plan.skills) > 1:
        line.append(f" in all, {schedule.geometric_mean:.2f} on average", "not bold")
    line.append(f" ({_proof(plan)}; {certificate.method}, {certificate.seconds:.2f} s)", "dim")
    return line


def _proof(plan: Plan) -> str:
    match plan.schedule.certificate.status:
        case Status.OPTIMAL:
            return "no schedule satisfies better: proved"
        case Status.BOUNDED:
            return f"{how_near(plan.schedule)}: proved"
        case Status.HEURISTIC:
            return "a good schedule, without proof"
        case Status.INFEASIBLE:
            return clash_sentence(plan)
