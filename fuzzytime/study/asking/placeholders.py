"""What stands in braces in a text for participants, and is filled in when they read it."""

import re
from collections.abc import Collection

from fuzzytime.documents.nodes import Node, Reader
from fuzzytime.spelling import suggestion

_PLACEHOLDER = re.compile(r"\{(\w+)\}")


def places_in(text: str) -> frozenset[str]:
    """Give what stands in braces.

    >>> sorted(places_in("Instruction {done} of {all}"))
    ['all', 'done']
    """
    return frozenset(_PLACEHOLDER.findall(text))


def check_places(reader: Reader, node: Node, key: str, text: str, known: Collection[str]) -> None:
    """Note as mistakes what stands in braces and is not filled in there."""
    for name in sorted(places_in(text) - set(known)):
        reader.mistake(node, key, f"nothing is filled in for {{{name}}}{suggestion(name, known)}")
