"""Write the reference of the plan's JSON from its schema: ``python docs/reference.py``."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parent.parent
SCHEMA = ROOT / "cli" / "fuzzytime_cli" / "schema" / "plan-1.json"
PAGE = ROOT / "docs" / "json.md"
HEAD = """# The plan as JSON

`fuzzytime plan --format json` writes one object of the schema `fuzzytime-plan/1`. The schema ships as a
[JSON Schema](https://json-schema.org) file, `fuzzytime_cli/schema/plan-1.json`; this page is made from it by
`docs/reference.py`.

Times named `…_s` are seconds from `now`; instants are ISO 8601, with an offset where a zone is known. Numbers
are not rounded. What people typed is kept exactly. `--format jsonl` writes one skill a line, with
`"type": "skill"`, and then the rest as one line with `"type": "plan"`.

```console
$ fuzzytime plan -i "Flip the pancakes in two minutes" --now 2026-03-04T09:00 --format json
```
"""


def page(schema: dict[str, Any]) -> Iterator[str]:
    """Give the page's lines: one table for the plan, and one for each part that has fields."""
    yield "## The plan"
    yield from table(schema, schema)
    for name, part in schema["properties"].items():
        inner = resolved(part.get("items", part), schema)
        if "properties" in inner and "$ref" not in part.get("items", {}):
            yield f"## `{name}`"
            yield from table(inner, schema)
    for name, part in schema["$defs"].items():
        if "properties" in part:
            yield f"## {name.replace('_', ' ').capitalize()}"
            yield from table(part, schema)


def table(part: dict[str, Any], schema: dict[str, Any]) -> Iterator[str]:
    """Give one object's fields as a table."""
    yield ""
    yield "| field | is | meaning |"
    yield "|---|---|---|"
    for name, field in part["properties"].items():
        whole = resolved(field, schema)
        meaning = field.get("description", whole.get("description", ""))
        yield f"| `{name}` | {kind(field, schema)} | {meaning.replace('|', chr(92) + '|')} |"
    yield ""


def resolved(part: dict[str, Any], schema: dict[str, Any]) -> dict[str, Any]:
    """Follow a reference into the schema's definitions."""
    if "$ref" in part:
        return dict(schema["$defs"][part["$ref"].rpartition("/")[2]])
    return part


def kind(part: dict[str, Any], schema: dict[str, Any]) -> str:
    """Say in a few words which values a field takes."""
    if "$ref" in part:
        shared = resolved(part, schema)
        if "oneOf" in shared or shared.get("type") == "array":
            return kind(shared, schema)
        return str(part["$ref"].rpartition("/")[2]).replace("_", " ")
    if "const" in part:
        return f"`{part['const']}`"
    if "enum" in part:
        return ", ".join("null" if value is None else f"`{value}`" for value in part["enum"])
    for choice in ("oneOf", "anyOf"):
        if choice in part:
            return " or ".join(dict.fromkeys(kind(option, schema) for option in part[choice]))
    types = part.get("type", "object")
    if types == "array":
        return f"list of {kind(part['items'], schema)}" if isinstance(part.get("items"), dict) else "list"
    return " or ".join([types] if isinstance(types, str) else types)


def written() -> str:
    """Give the page; the console block that stands in it is left to ``refresh.py``."""
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    return f"{HEAD}\n" + "\n".join(page(schema)).rstrip() + "\n"


def example_of(text: str) -> tuple[int, int]:
    """Give where the console block's output stands."""
    start = text.index("--format json\n") + len("--format json\n")
    return start, text.index("```", start)


def main() -> None:
    """Write the page, with the output that it shows kept."""
    fresh = written()
    if PAGE.exists():
        old = PAGE.read_text(encoding="utf-8")
        here, there = example_of(fresh), example_of(old)
        fresh = fresh[: here[0]] + old[there[0] : there[1]] + fresh[here[1] :]
    PAGE.write_text(fresh, encoding="utf-8")


if __name__ == "__main__":
    main()
