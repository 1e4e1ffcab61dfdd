"""Reading ``lexicon.yaml``: prepositions, hedges, time words, comparisons, amounts, and groups of words."""

from collections.abc import Iterable
from typing import Any, TypeVar

from fuzzytime.documents.nodes import Node
from fuzzytime.language.grammar.lexicon import Entry, Form, Forms, Preposition, form_of
from fuzzytime.language.grammar.lexicon.groups_beside_times import BesideTimes
from fuzzytime.language.grammar.lexicon.no_time_groups import NoTimes
from fuzzytime.language.grammar.lexicon.verb_groups import Doing
from fuzzytime.language.grammar.lexicon.word_groups import ClosedClasses, Words
from fuzzytime.language.grammar.word_tables.tables import CHOICE, Row, Tables
from fuzzytime.language.meaning.expressions import Edge, TimeWord
from fuzzytime.language.meaning.units import Quantity
from fuzzytime.requirement import Constraint, Side
from fuzzytime.spelling import suggestion

_Groups = TypeVar("_Groups", ClosedClasses, BesideTimes, Doing, NoTimes)


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


def read_groups(tables: Tables, section: str, kind: type[_Groups]) -> _Groups:
    """Read a section whose rows are the fields of a class: lists of words, and of ``<groups>`` above."""
    names: dict[str, str] = {field.replace("_", " "): field for field in kind._fields}
    found: dict[str, Words] = {}
    for name, row in tables.rows(section, names):
        found[name.text] = _group(tables, row, f"{section}.{name.text}", found)
    return kind(**{field: found.get(name, frozenset()) for name, field in names.items()})


def _group(tables: Tables, node: Node, key: str, above: dict[str, Words]) -> Words:
    """Read one group: a word may stand in it once, but groups that it holds may share some."""
    said: set[str] = set()
    held: set[str] = set()
    for item in tables.reader.sequence(node, key):
        text = tables.reader.phrase(item, key)
        if text.startswith("<") and text.endswith(">"):
            name = text[1:-1]
            if name not in above:
                message = f"a group in another must stand above it, got {text!r}{suggestion(name, above)}"
                tables.reader.mistake(item, key, message)
            held |= above.get(name, frozenset())
        else:
            if text in said or text in held:
                tables.reader.mistake(item, key, f"words of a group must differ, got {text!r} twice")
            said.add(text)
    return frozenset(said | held)


def read_ways(tables: Tables) -> tuple[tuple[str, tuple[frozenset[str], ...]], ...]:
    """Give other ways to say what is said of wishes: of each, what may stand in each of its places.

    What a choice with nothing in it says may be missing: "|just".
    """
    return tuple(
        (name.text, tuple(frozenset(place.lower().split(CHOICE)) for place in text.split()))
        for name, node in tables.rows("ways")
        for text in tables.reader.strings(node, f"ways.{name.text}")
    )
