"""Reading ``lexicon.yaml``: prepositions, hedges, time words, comparisons, amounts."""

from collections.abc import Iterable
from typing import Any

from fuzzytime.language.grammar.lexicon import Entry, Form, Forms, Preposition, form_of
from fuzzytime.language.grammar.word_tables.tables import Row, Tables
from fuzzytime.language.meaning.expressions import Edge, Quantity, TimeWord
from fuzzytime.requirement import Constraint, Side


def read_prepositions(tables: Tables) -> None:
    """Add prepositions."""
    sides = (Constraint.AT, Constraint.BEFORE, Constraint.AFTER)

    def make(name: str, row: Row) -> Iterable[tuple[str, Any]]:
        constraint = row.choice("constraint", Constraint.AT, *sides)
        counts = row.chosen("counts", ("forward", "back"))
        value = Preposition(name, constraint, row.choice("edge", Edge.START))
        if counts and constraint is Constraint.BEFORE:
            return [("within", value)]
        return [(counts or f"preposition_{constraint}", value)]

    tables.table("prepositions", {"constraint": True, "edge": False, "counts": False}, make)


def read_hedges(tables: Tables) -> None:
    """Add hedges, and quantities that are hedges in themselves."""

    def make(name: str, row: Row) -> Iterable[tuple[str, Any]]:
        if row.has("number"):
            return [("quantity", Quantity(row.number("number", 0, 1000), (name,)))]
        sides = {
            "before": ("hedge",),
            "after": ("hedge_after",),
            "either": ("hedge", "hedge_after"),
            "anchor": ("beside",),
        }
        if row.has("front"):
            tables.add(*row.at("front"), "hedge", name, row.forms("front"))
        return [(category, name) for category in sides.get(row.chosen("side", sides), ())]

    tables.table("hedges", {"side": False, "number": False, "front": False}, make)


def read_words(tables: Tables) -> None:
    """Add time words and corrections."""
    kinds = (Constraint.AT, Constraint.VAGUE, Constraint.EVERY, Constraint.FOR)

    def make(name: str, row: Row) -> Iterable[tuple[str, Any]]:
        return [("word", TimeWord(name, row.choice("constraint", Constraint.VAGUE, *kinds)))]

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
        row = Row(tables, key, tables.reader.mapping(node, key, ("quantity", "also")))
        quantity = None
        if row.has("quantity"):
            items = tables.reader.sequence(*row.at("quantity"), 4)
            corners = [tables.reader.number(item, f"{key}.quantity[{i}]", 0) for i, item in enumerate(items)]
            if len(corners) == 4:
                if corners != sorted(corners):
                    tables.reader.mistake(node, key, f"corners must not decrease, got {corners}")
                quantity = (corners[0], corners[1], corners[2], corners[3])
        for form in (form_of(name.text), *row.forms("also")):
            yield form, (name.text, quantity)
