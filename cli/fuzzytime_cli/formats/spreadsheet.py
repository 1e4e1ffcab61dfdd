"""A plan as CSV (RFC 4180) for spreadsheets, with nothing in it that they would run as a formula."""

import csv
import io

from fuzzytime.interpreter import Plan
from fuzzytime.requirement import asked_words
from fuzzytime_cli.formats.document import skills_of
from fuzzytime_cli.render import plain

COLUMNS = (
    *("id", "start", "end", "done", "agent", "name"),
    *("satisfaction", "alone", "rejected", "asked", "instruction", "waits"),
)
_FORMULA = ("=", "+", "-", "@", "\t", "\r", "|", "%")


def cell(text: str) -> str:
    """Make typed text safe in a cell: harmless characters, and no start that makes it a formula.

    >>> cell("=1+1"), cell("call mum")
    ("'=1+1", 'call mum')
    """
    shown = plain(text)
    return f"'{shown}" if shown.lstrip().startswith(_FORMULA) else shown


def csv_text(plan: Plan) -> str:
    """Write one row a skill, in the order of the start times; what waits is last, and has no time."""
    skills = skills_of(plan)
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\r\n")
    writer.writerow(COLUMNS)
    for position in plan.schedule.order:
        skill = skills[position]
        end, done = (plan.instant(skill[name]).isoformat() for name in ("end_s", "done_s"))
        asked = asked_words(plan.skills[position].requirements, "; ")
        writer.writerow(
            (
                cell(skill["id"]),
                skill["start"],
                end,
                done,
                skill["agent"],
                cell(skill["name"]),
                skill["satisfaction"],
                skill["alone"],
                str(skill["rejected"]).lower(),
                cell(asked),
                cell(skill["instruction"] or ""),
                "false",
            )
        )
    for one in plan.waiting:
        asked, name = cell(asked_words(one.requirements, "; ")), cell(one.skill.name)
        times, figures = [""] * 4, ["", "", "false"]
        writer.writerow((cell(one.identifier), *times, name, *figures, asked, cell(one.words or ""), "true"))
    return stream.getvalue()
