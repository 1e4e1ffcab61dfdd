"""The names that a set of rule files declare, gathered before any of them is read in full.

So a file may speak of what another declares, and every unknown name is a mistake with its place.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property

from fuzzytime.documents.nodes import Mapping as MappingNode
from fuzzytime.documents.nodes import Node, Scalar
from fuzzytime.requirement import Constraint
from fuzzytime.rulebook.tables.variables import Source

CLAUSE_MODELS = ("when", "while", "until")
"""Models of clauses, which need no breakpoints: they follow a condition's trace."""


@dataclass(frozen=True, kw_only=True)
class Vocabulary:
    """Declared names.

    ``units`` are by signal (None for a bare number), ``terms`` and ``sources`` (the signal) by variable.
    """

    prepositions: frozenset[str]
    words: frozenset[str]
    models: frozenset[str]
    time_hedges: frozenset[str]
    term_hedges: frozenset[str]
    units: Mapping[str, str | None]
    events: frozenset[str]
    terms: Mapping[str, frozenset[str]]
    sources: Mapping[str, str]

    @cached_property
    def cues(self) -> frozenset[str]:
        """What a requirement may be called by: its word, its preposition, or its constraint."""
        return self.words | self.prepositions | frozenset(Constraint)

    @cached_property
    def variables(self) -> Mapping[str, frozenset[str]]:
        """The variables of each signal."""
        found: dict[str, set[str]] = {name: set() for name in self.units}
        for variable, signal in self.sources.items():
            found.setdefault(signal, set()).add(variable)
        return {name: frozenset(variables) for name, variables in found.items()}

    @classmethod
    def of(cls, roots: Iterable[Node]) -> "Vocabulary":
        """Gather the names of documents; what is malformed is passed over here and reported later."""
        prepositions, words = set[str](), set[str]()
        models, time_hedges, term_hedges, events = set[str](), set[str](), set[str](), set[str]()
        units: dict[str, str | None] = {}
        terms: dict[str, frozenset[str]] = {}
        sources: dict[str, str] = {}
        for root in roots:
            for part in (root, *_children(child(root, "profiles"))):
                words.update(_names(child(part, "words")))
                prepositions.update(_names(child(part, "prepositions")), _names(child(part, "clauses")))
                models.update(_names(child(part, "models")))
                hedges = child(part, "hedges")
                time_hedges.update(_names(child(hedges, "time")))
                term_hedges.update(_names(child(hedges, "term")))
            signals = child(root, "signals")
            for name in _names(signals):
                unit = child(child(signals, name), "unit")
                event = child(child(signals, name), "event")
                units[name] = unit.text if isinstance(unit, Scalar) else None
                if isinstance(event, Scalar) and event.text == "true":
                    events.add(name)
            variables = child(root, "variables")
            for name in _names(variables):
                terms[name] = frozenset(_names(child(child(variables, name), "terms")))
                for kind in Source:
                    source = child(child(variables, name), kind.value)
                    if isinstance(source, Scalar):
                        sources[name] = source.text
        return cls(
            prepositions=frozenset(text.lower() for text in prepositions),
            words=frozenset(text.lower() for text in words),
            models=frozenset(models),
            time_hedges=frozenset(text.lower() for text in time_hedges),
            term_hedges=frozenset(text.lower() for text in term_hedges),
            units=units,
            events=frozenset(events),
            terms=terms,
            sources=sources,
        )

    def joined(self, other: "Vocabulary") -> "Vocabulary":
        """Give the names of both; what the other says of a name stands."""
        return Vocabulary(
            prepositions=self.prepositions | other.prepositions,
            words=self.words | other.words,
            models=self.models | other.models,
            time_hedges=self.time_hedges | other.time_hedges,
            term_hedges=self.term_hedges | other.term_hedges,
            units={**self.units, **other.units},
            events=(self.events - other.units.keys()) | other.events,
            terms={**self.terms, **other.terms},
            sources={**self.sources, **other.sources},
        )


def child(node: Node | None, name: str) -> Node | None:
    """Give the value of a key; None where there is no such key, or no mapping."""
    if not isinstance(node, MappingNode):
        return None
    return next((value for key, value in node.entries if key.text == name), None)


def _children(node: Node | None) -> list[Node]:
    return [value for _, value in node.entries] if isinstance(node, MappingNode) else []


def _names(node: Node | None) -> list[str]:
    return [key.text for key, _ in node.entries] if isinstance(node, MappingNode) else []
