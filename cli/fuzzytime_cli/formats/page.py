"""A plan as one self-contained HTML page: picture, table, what is proved, what was not understood."""

from fuzzytime.interpreter import IN_THE_PLAN, Plan, Problem
from fuzzytime_cli.clock import date_of
from fuzzytime_cli.drawing.markup import element, words
from fuzzytime_cli.formats.picture import plan_svg
from fuzzytime_cli.formats.series import waiting
from fuzzytime_cli.formats.table import PlanView

POLICY = "default-src 'none'; style-src 'unsafe-inline'"
STYLE = (
    ":root{color-scheme:light dark}body{font:16px/1.45 system-ui,sans-serif;max-width:54rem;margin:2rem auto;"
    "padding:0 1rem}table{border-collapse:collapse;width:100%}th,td{text-align:left;padding:.3rem .6rem;"
    "border-bottom:1px solid #8884}.number{text-align:right;white-space:nowrap;"
    "font-variant-numeric:tabular-nums}"
    "svg{max-width:100%;height:auto}meter{width:6rem}.problem{color:#b3361e}"
    "@media(max-width:40rem){body{font-size:13px;padding:0 .5rem}th,td{padding:.3rem .15rem}"
    "meter{display:none}}"
)


def page_text(plan: Plan, seconds: float) -> str:
    """Write the page; it loads nothing, and runs nothing. Whom skills lost to is looked for for so long."""
    view = PlanView(plan, 100, seconds=seconds)
    title = words(f"Plan from {date_of(plan.request.now)}, {plan.request.now:%H:%M}")
    head = (
        '<meta charset="utf-8"><meta name="viewport" content="width=device-width,initial-scale=1">'
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">'
        f"<title>{title}</title><style>{STYLE}</style>"
    )
    columns = ("", "start", "end", *(["by"] if plan.request.agents > 1 else []), "what", "asked")
    heading = "".join(element("th", name) for name in columns) + element("th", "satisfied", class_="number")
    rows = "".join(_row(plan, position, view) for position in (*plan.schedule.order, *waiting(plan)))
    table = element("table", element("thead", element("tr", heading)) + element("tbody", rows))
    sentences = "".join(element("p", words(sentence)) for sentence in view.sentences())
    problems = "".join(
        element("li", words(_sentence(problem)), class_="problem")
        for problem in plan.problems
        if problem.kind not in IN_THE_PLAN  # the sentences say these
    )
    body = element("h1", title) + plan_svg(plan) + table + sentences + element("ul", problems)
    return f'<!doctype html><html lang="en"><head>{head}</head><body>{body}</body></html>\n'


def _row(plan: Plan, position: int, view: PlanView) -> str:
    doer = [view.doer(position)] if plan.request.agents > 1 else []
    name = plan.everything[position].skill.name
    texts = (view.labels[position], *view.times(position), *doer, name, view.asked(position))
    cells = "".join(element("td", words(text)) for text in texts)
    if position >= len(plan.skills):
        return element("tr", cells + element("td", "waits", class_="number"))
    satisfaction = plan.schedule.satisfactions[position]
    figure = "rejected" if plan.schedule.rejected[position] else f"{satisfaction:.2f}"
    meter = element("meter", "", value=f"{satisfaction:.4f}")
    return element("tr", cells + element("td", f"{meter} {figure}", class_="number"))


def _sentence(problem: Problem) -> str:
    where = f"line {problem.line}: " if problem.line is not None else ""
    return f"{where}{problem.message}" + (f" — {problem.text}" if problem.text else "")
