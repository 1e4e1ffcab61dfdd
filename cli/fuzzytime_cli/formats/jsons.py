"""A plan as JSON, whole or a skill a line."""

import json

from fuzzytime.interpreter import Plan
from fuzzytime_cli.formats.document import document_of


def json_text(plan: Plan) -> str:
    """Write the plan's document; every character outside ASCII as an escape, so that it passes anywhere."""
    return json.dumps(document_of(plan), indent=2, allow_nan=False) + "\n"


def json_lines(plan: Plan) -> str:
    """Write one skill a line, then the rest as one line; each says its ``type``."""
    document = document_of(plan)
    skills = document.pop("skills")
    lines = [{"type": "skill", **skill} for skill in skills] + [{"type": "plan", **document}]
    return "".join(json.dumps(line, allow_nan=False) + "\n" for line in lines)
