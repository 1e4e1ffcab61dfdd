"""What the study's page says: the words of ``rules/study/page.yaml``, under those of a design."""

from collections.abc import Mapping
from types import MappingProxyType

from fuzzytime.documents.nodes import Node, Reader
from fuzzytime.resources import rules_directory
from fuzzytime.study.asking.placeholders import check_places, places_in

PageTexts = Mapping[str, str | tuple[str, ...]]
"""Texts by their keys; ``tutorial_steps`` is a list of them."""


def read_texts(reader: Reader, node: Node | None) -> PageTexts:
    """Read a design's own texts over the shipped ones; unknown keys are mistakes."""
    shipped = Reader.of_file(rules_directory() / "study" / "page.yaml")
    texts = _texts(shipped, shipped.root(), None)
    shipped.finish()
    return MappingProxyType(texts if node is None else {**texts, **_texts(reader, node, texts)})


def _texts(reader: Reader, node: Node, known: PageTexts | None) -> dict[str, str | tuple[str, ...]]:
    found: dict[str, str | tuple[str, ...]] = {}
    for key, entry in reader.mapping(node, "texts", known).items():
        is_list = key == "tutorial_steps"
        said = reader.strings(entry, f"texts.{key}") if is_list else reader.string(entry, f"texts.{key}")
        if known is not None:
            places = places_in(_whole(known[key])) | {"actor"}
            check_places(reader, entry, f"texts.{key}", _whole(said), places)
        found[key] = said
    return found


def _whole(text: str | tuple[str, ...]) -> str:
    return text if isinstance(text, str) else "\n".join(text)
