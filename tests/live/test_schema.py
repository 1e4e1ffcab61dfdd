"""What a run tells is written down: every event is in the schema, and in the document, with its fields."""

import re

import pytest

from console import ROOT
from live.story import DOCUMENT, kinds_of_events

TYPES = kinds_of_events()
ROWS = dict(
    re.findall(r"^\| `(\w+)` \|[^|]*\|([^|]*)\|$", (ROOT / "docs" / "live.md").read_text(), re.MULTILINE)
)


def test_every_event_has_its_schema_and_no_schema_is_without_event() -> None:
    named = {reference["$ref"].rpartition("/")[2] for reference in DOCUMENT["oneOf"]}
    assert named == set(TYPES)


@pytest.mark.parametrize("name", sorted(TYPES))
def test_the_document_names_every_field_of_an_event(name: str) -> None:
    fields = set(DOCUMENT["$defs"][name]["properties"]) - {"type", "at", "at_s"}
    assert set(re.findall(r"`(\w+)`", ROWS[name])) == fields
