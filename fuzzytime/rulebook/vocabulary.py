"""The names that a set of rule files declare, gathered before any of them is read in full.

So a file may speak of what another declares, and every unknown name is a mistake with its place.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from fuzzytime.yaml_nodes import Mapping as MappingNode
from fuzzytime.yaml_nodes import Node, Scalar

CLAUSE_MODELS = ("when", "while", "until")
"""Models of clauses, which need no breakpoints: they follow a condition's trace."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Vocabulary:
    """Declared names: ``units`` by signal (None for a bare number), ``terms`` by variable."""

    models: frozenset[str]
    time_hedges: frozenset[str]
    term_hedges: frozenset[str]
    units: Mapping[str, str | None]
    events: frozenset[str]
    terms: Mapping[str, frozenset[str]]

    @classmethod
    def of(cls, roots: Iterable[Node]) -> "Vocabulary":
        """Gather the names of documents; what is malformed is passed over here and reported later."""
        models, time_hedges, term_hedges, events = set[str](), set[str](), set[str](), set[str]()
        units: dict[str, str | None] = {}
        terms: dict[str, frozenset[str]] = {}
        for root in roots:
            for part in (root, *_children(_child(root, "profiles"))):
                models.update(_names(_child(part, "models")))
                hedges = _child(part, "hedges")
                time_hedges.update(_names(_child(hedges, "time")))
                term_hedges.update(_names(_child(hedges, "term")))
            signals = _child(root, "signals")
            for name in _names(signals):
                unit = _child(_child(signals, name), "unit")
                event = _child(_child(signals, name), "event")
                units[name] = unit.text if isinstance(unit, Scalar) else None
                if isinstance(event, Scalar) and event.text == "true":
                    events.add(name)
            variables = _child(root, "variables")
            for name in _names(variables):
                terms[name] = frozenset(_names(_child(_child(variables, name), "terms")))
        return cls(
            models=frozenset(models),
            time_hedges=frozenset(time_hedges),
            term_hedges=frozenset(term_hedges),
            units=units,
            events=frozenset(events),
            terms=terms,
        )

    def joined(self, other: "Vocabulary") -> "Vocabulary":
        """Give the names of both; what the other says of a name stands."""
        return Vocabulary(
            models=self.models | other.models,
            time_hedges=self.time_hedges | other.time_hedges,
            term_hedges=self.term_hedges | other.term_hedges,
            units={**self.units, **other.units},
            events=(self.events - other.units.keys()) | other.events,
            terms={**self.terms, **other.terms},
        )


def _child(node: Node | None, name: str) -> Node | None:
    if not isinstance(node, MappingNode):
        return None
    return next((value for key, value in node.entries if key.text == name), None)


def _children(node: Node | None) -> list[Node]:
    return [value for _, value in node.entries] if isinstance(node, MappingNode) else []


def _names(node: Node | None) -> list[str]:
    return [key.text for key, _ in node.entries] if isinstance(node, MappingNode) else []
