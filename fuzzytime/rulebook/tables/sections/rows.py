"""Reading rows of the lookup: by word, preposition, clause, grain and constraint, and direct entries."""

from collections.abc import Collection, Mapping
from enum import StrEnum
from types import MappingProxyType

from fuzzytime.documents.nodes import Node, Sequence
from fuzzytime.requirement import Constraint, Reference, Unit
from fuzzytime.rulebook.tables.contents import Entry, Hedge, Model, Row
from fuzzytime.rulebook.tables.matching import KEYS, Match
from fuzzytime.rulebook.tables.sections.models import FORMS, read_form
from fuzzytime.rulebook.tables.sections.scope import Scope
from fuzzytime.rulebook.tables.sections.widths import LONGEST, MAX_FACTOR, read_factor
from fuzzytime.rulebook.tables.vocabulary import CLAUSE_MODELS

_ROW = ("model", *FORMS, "begun", "dated", "t", "w", "reference", "hedge", "core", "fade")
_TIMES = (("t", -LONGEST), ("w", 1e-3), ("core", 0.0), ("fade", 0.0))
"""Times that a row may fix, with the least value of each."""

_HEDGE = ("widen", "shift", "spread", "model")

_CLOSED: Mapping[str, type[StrEnum]] = {
    "constraint": Constraint,
    "reference": Reference,
    "grain": Unit,
    "unit": Unit,
}
"""Keys of ``on:`` whose texts form a closed set."""


def read_rows(scope: Scope, node: Node, key: str) -> Mapping[str, Row]:
    """Read rows by their words, in lower case."""
    return MappingProxyType(_rows(scope, node, key))


def read_grains(scope: Scope, node: Node, key: str) -> Mapping[Unit, Row]:
    """Read rows by the grain of a calendar time."""
    rows = _rows(scope, node, key, tuple(Unit))
    return MappingProxyType({Unit(text): row for text, row in rows.items()})


def read_constraints(scope: Scope, node: Node, key: str) -> Mapping[Constraint, Row]:
    """Read rows by constraint."""
    rows = _rows(scope, node, key, tuple(Constraint))
    return MappingProxyType({Constraint(text): row for text, row in rows.items()})


def _rows(scope: Scope, node: Node, key: str, allowed: Collection[str] | None = None) -> dict[str, Row]:
    keys = scope.reader.keys(node)
    rows: dict[str, Row] = {}
    for text, value in scope.reader.mapping(node, key, allowed).items():
        path = f"{key}.{text}"
        found = scope.row(value, path, _ROW)
        row = _row(scope, found, value, path, (text, scope.reader.place(keys[text])))
        if row is not None:
            rows[text.lower()] = row
    return rows


def _row(
    scope: Scope, found: Mapping[str, Node], node: Node, key: str, called: tuple[str, str]
) -> Row | None:
    """Make a row of the keys found in a mapping; ``called`` is its name and place in explanations."""
    name, source = called
    own: Model | None = None
    model = name
    rule = "must give either 'model', or 'breakpoints' or 'bell' of its own"
    given = scope.reader.one_of(node, key, ("model", *FORMS), rule)
    if given == "model":
        models = (*scope.names.models, *CLAUSE_MODELS)
        model = scope.reader.choice(found["model"], f"{key}.model", models)
    elif given is not None:
        form = read_form(scope, found[given], key, given)
        own = Model(name, form, source) if form is not None else None
    others = {
        part: scope.reader.choice(found[part], f"{key}.{part}", scope.names.models)
        for part in ("begun", "dated")
        if part in found
    }
    times = {
        part: scope.reader.duration(found[part], f"{key}.{part}", low, LONGEST)
        for part, low in _TIMES
        if part in found
    }
    hedges: tuple[str, ...] = ()
    if "hedge" in found:
        hedges = scope.reader.choices(found["hedge"], f"{key}.hedge", scope.names.time_hedges, lower=True)
    moment = ""
    if "reference" in found:
        moment = scope.reader.choice(found["reference"], f"{key}.reference", tuple(Reference))
    if not model or (own is None and given != "model"):
        return None
    return Row(
        name=name,
        source=source,
        model=model,
        own=own,
        begun=others.get("begun") or None,
        dated=others.get("dated") or None,
        reference=Reference(moment) if moment else None,
        hedges=hedges,
        **times,
    )


def read_entries(scope: Scope, node: Node, key: str) -> tuple[Entry, ...]:
    """Read direct entries: ``on`` and a row."""
    read: list[Entry] = []
    for i, item in enumerate(scope.reader.sequence(node, key)):
        path = f"{key}[{i}]"
        found = scope.row(item, path, ("name", "on", *_ROW), ("on",))
        name = scope.reader.phrase(found["name"], f"{path}.name") if "name" in found else f"entry {i + 1}"
        row = _row(scope, found, item, path, (name, scope.reader.place(item)))
        before = len(scope.reader.mistakes)
        match = read_match(scope, found["on"], f"{path}.on") if "on" in found else Match()
        if row is None or "on" not in found or len(scope.reader.mistakes) > before:
            continue
        place = match.first_covering(entry.match for entry in read)
        if place is not None:
            above = read[place].row
            message = f"never comes into play: {above.name!r} ({above.source}) speaks about all of it before"
            scope.reader.mistake(item, path, message)
        read.append(Entry(match, row))
    return tuple(read)


def read_match(scope: Scope, node: Node, key: str) -> Match:
    """Read what requirements an entry or a rule speaks about."""
    names = scope.names
    known: Mapping[str, Collection[str]] = {
        **{name: tuple(members) for name, members in _CLOSED.items()},
        "cue": names.cues,
        "preposition": names.prepositions,
        "hedge": names.time_hedges,
    }
    accepted: list[tuple[str, frozenset[str]]] = []
    for name, value in scope.reader.mapping(node, key, KEYS).items():
        path = f"{key}.{name}"
        if name == "number":
            numbers = scope.reader.one_or_more(value, path)
            texts = tuple(f"{scope.reader.number(item, place):g}" for item, place in numbers)
        elif name in known:
            texts = scope.reader.choices(value, path, known[name], lower=True)
        else:
            texts = scope.reader.strings(value, path)
        if isinstance(value, Sequence) and not value.items:
            scope.reader.mistake(value, path, "must not be an empty list, which nothing matches")
        accepted.append((name, frozenset(text.lower() for text in texts)))
    return Match(tuple(accepted))


def read_time_hedges(scope: Scope, node: Node, key: str) -> Mapping[str, Hedge]:
    """Read what hedges do to models."""
    keys = scope.reader.keys(node)
    read: dict[str, Hedge] = {}
    for text, value in scope.reader.mapping(node, key).items():
        path = f"{key}.{text}"
        found = scope.row(value, path, _HEDGE)
        if not found:
            scope.reader.missing(value, path, _HEDGE)
        model = ""
        if "model" in found:
            model = scope.reader.choice(found["model"], f"{path}.model", scope.names.models)
        read[text.lower()] = Hedge(
            name=text,
            source=scope.reader.place(keys[text]),
            widen=read_factor(scope, found["widen"], f"{path}.widen") if "widen" in found else 1.0,
            shift=scope.reader.number(found["shift"], f"{path}.shift", -10, 10) if "shift" in found else 0.0,
            spread=_spread(scope, found["spread"], f"{path}.spread") if "spread" in found else (1.0, 1.0),
            model=model or None,
        )
    return MappingProxyType(read)


def _spread(scope: Scope, node: Node, key: str) -> tuple[float, float]:
    items = scope.reader.sequence(node, key, 2)
    factors = [scope.reader.number(item, f"{key}[{i}]", 0.0, MAX_FACTOR) for i, item in enumerate(items)]
    if len(factors) != 2:
        return 1.0, 1.0
    if factors[0] > factors[1]:
        scope.reader.mistake(items[1], f"{key}[1]", "factors of a spread must not decrease")
    return factors[0], factors[1]
