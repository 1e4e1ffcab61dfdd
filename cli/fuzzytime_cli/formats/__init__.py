"""What a plan can be written as.

For people: ``table`` with a ``timeline``, ``degrees`` of satisfaction and ``notes``, ``page``, ``picture``;
in words, what was ``asked``, the ``reasons`` of each start, the ``series`` of what repeats, the ``whole``.
For programs: ``document`` in ``jsons``, ``spreadsheet``; ``calendar``, where what is ``repeating`` has a rule
of ``rules_of_series``.
"""

from fuzzytime.interpreter import Plan
from fuzzytime_cli.choices import PlanFormat


def written(plan: Plan, output_format: PlanFormat, width: int = 80, *, seconds: float = 1.0) -> str:
    """Write a plan as text in a format; each writer is imported when it is asked for.

    Whom skills lost to is looked for within ``seconds``, where the format says it.
    """
    match output_format:
        case PlanFormat.TABLE:
            from fuzzytime_cli.formats.table import PlanView

            return "".join(f"{line.plain}\n" for line in PlanView(plan, width, seconds=seconds).lines())
        case PlanFormat.JSON:
            from fuzzytime_cli.formats.jsons import json_text

            return json_text(plan)
        case PlanFormat.JSONL:
            from fuzzytime_cli.formats.jsons import json_lines

            return json_lines(plan)
        case PlanFormat.CSV:
            from fuzzytime_cli.formats.spreadsheet import csv_text

            return csv_text(plan)
        case PlanFormat.ICS:
            from fuzzytime_cli.formats.calendar import calendar_text

            return calendar_text(plan)
        case PlanFormat.SVG:
            from fuzzytime_cli.formats.picture import plan_svg

            return plan_svg(plan)
        case PlanFormat.HTML:
            from fuzzytime_cli.formats.page import page_text

            return page_text(plan, seconds)
