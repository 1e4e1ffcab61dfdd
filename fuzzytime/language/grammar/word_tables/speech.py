"""Reading ``lexicon.yaml``: prepositions, hedges, time words, comparisons, amounts."""

from collections.abc import Iterable
from typing import Any

from fuzzytime.documents.nodes import Node
from fuzzytime.language.grammar.lexicon import Entry, Form, Forms, Preposition, form_of
from fuzzytime.language.grammar.word_tables.tables import CHOICE, Tables
from fuzzytime.language.meaning.expressions import Edge, Quantity, TimeWord
from fuzzytime.requirement import Constraint, Side


def read_prepositions(tables: Tables) -> None:
    """Add prepositions."""
    reader = tables.reader

    def make(name: str, fields: dict[str, Node]) -> Iterable[tuple[str, Any]]:
        key = f"prepositions.{name}"
        sides = (Constraint.AT, Constraint.BEFORE, Constraint.AFTER)
        constraint = reader.choice(fields["constraint"], f"{key}.constraint", sides) or Constraint.AT
        edge = reader.choice(fields["edge"], f"{key}.edge", tuple(Edge)) if "edge" in fields else ""
        counts = (
            reader.choice(fields["counts"], f"{key}.counts", ("forward", "back"))
            if "counts" in fields
            else ""
        )
        value = Preposition(name, Constraint(constraint), Edge(edge or Edge.START))
        if counts and constraint == Constraint.BEFORE:
            return [("within", value)]
        return [(counts or f"preposition_{constraint}", value)]

    tables.table("prepositions", {"constraint": True, "edge": False, "counts": False}, make)


def read_hedges(tables: Tables) -> None:
    """Add hedges, and quantities that are hedges in themselves."""
    reader = tables.reader

    def make(name: str, fields: dict[str, Node]) -> Iterable[tuple[str, Any]]:
        if "number" in fields:
            number = reader.number(fields["number"], f"hedges.{name}.number", 0, 1000)
            return [("quantity", Quantity(number, (name,)))]
        sides = {
            "before": ("hedge",),
            "after": ("hedge_after",),
            "either": ("hedge", "hedge_after"),
            "anchor": ("beside",),
        }
        if "front" in fields:
            key = f"hedges.{name}.front"
            tables.add(fields["front"], key, "hedge", name, tables.forms(fields["front"], key))
        if "side" not in fields:
            return []
        side = reader.choice(fields["side"], f"hedges.{name}.side", sides)
        return [(category, name) for category in sides.get(side, ())]

    tables.table("hedges", {"side": False, "number": False, "front": False}, make)


def read_words(tables: Tables) -> None:
    """Add time words and corrections."""

    def make(name: str, fields: dict[str, Node]) -> Iterable[tuple[str, Any]]:
        kinds = (Constraint.AT, Constraint.VAGUE, Constraint.EVERY, Constraint.FOR)
        constraint = tables.reader.choice(fields["constraint"], f"words.{name}.constraint", kinds)
        return [("word", TimeWord(name, Constraint(constraint or Constraint.VAGUE)))]

    tables.table("words", {"constraint": True}, make)
    for form in tables.words("corrections"):
        tables.entries.append(Entry(form, "correction", " ".join(form)))


def read_comparisons(tables: Tables) -> Forms[Side]:
    """Give the side of a number by the words that put it into a clause."""
    found: dict[Form, Side] = {}
    for name, node in tables.rows("comparisons"):
        key = f"comparisons.{name.text}"
        side = tables.reader.choice(name, key, tuple(Side))
        for form in tables.forms(node, key):
            if form in found:
                message = f"words must have one meaning in a table, got {' '.join(form)!r} twice"
                tables.reader.mistake(node, key, message)
            found[form] = Side(side or Side.AT)
    return Forms(found)


def read_amounts(
    tables: Tables,
) -> Iterable[tuple[Form, tuple[str, tuple[float, float, float, float] | None]]]:
    """Give vague amounts by their forms: canonical form, and corners of a trapezoid where they are known."""
    for name, node in tables.rows("amounts"):
        key = f"amounts.{name.text}"
        fields = tables.reader.mapping(node, key, ("quantity", "also"))
        quantity = None
        if "quantity" in fields:
            items = tables.reader.sequence(fields["quantity"], f"{key}.quantity", 4)
            corners = [tables.reader.number(item, f"{key}.quantity[{i}]", 0) for i, item in enumerate(items)]
            if len(corners) == 4:
                if corners != sorted(corners):
                    tables.reader.mistake(node, key, f"corners must not decrease, got {corners}")
                quantity = (corners[0], corners[1], corners[2], corners[3])
        said = [
            form_of(name.text),
            *(tables.forms(fields["also"], f"{key}.also") if "also" in fields else []),
        ]
        for form in said:
            yield form, (name.text, quantity)


def read_ways(tables: Tables) -> tuple[tuple[str, tuple[frozenset[str], ...]], ...]:
    """Give other ways to say what is said of wishes: of each, what may stand in each of its places.

    What a choice with nothing in it says may be missing: "|just".
    """
    return tuple(
        (name.text, tuple(frozenset(place.lower().split(CHOICE)) for place in text.split()))
        for name, node in tables.rows("ways")
        for text in tables.reader.strings(node, f"ways.{name.text}")
    )
