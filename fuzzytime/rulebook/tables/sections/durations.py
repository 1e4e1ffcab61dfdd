"""Reading how long operations take: the section ``durations`` of a rule file."""

from dataclasses import replace
from types import MappingProxyType

from fuzzytime.documents.nodes import Node, Reader
from fuzzytime.rulebook.tables.durations import Begun, Durations, Key, OperationDuration
from fuzzytime.rulebook.tables.sections.scope import Scope
from fuzzytime.times import DAY

_TIMES = ("hands_on", "elapsed")


def read_durations(scope: Scope, node: Node, key: str) -> Durations:
    """Read a default, operations by verb with rows for single objects, what is begun or done in passing."""
    reader = scope.reader
    found = reader.mapping(node, key, ("default", "operations", "begun", "in_passing"))
    default = None
    if "default" in found:
        times = scope.row(found["default"], f"{key}.default", _TIMES)
        default = _times(reader, found["default"], f"{key}.default", times, known=False)
    rows: dict[Key, OperationDuration] = {}
    if "operations" in found:
        path = f"{key}.operations"
        for verb, value in reader.mapping(found["operations"], path).items():
            rows |= _operation(scope, value, f"{path}.{verb}", verb.lower())
    begun = None
    if "begun" in found:
        path = f"{key}.begun"
        bounds = scope.row(found["begun"], path, ("hands_on", "times", "verbs"))
        if {*bounds} >= {"hands_on", "times"}:
            hands_on = reader.duration(bounds["hands_on"], f"{path}.hands_on", 0.0, DAY)
            length = reader.number(bounds["times"], f"{path}.times", 1.0, 1000.0)
            verbs = reader.strings(bounds["verbs"], f"{path}.verbs") if "verbs" in bounds else ()
            begun = Begun(hands_on, length, frozenset(map(str.lower, verbs)))
        else:
            reader.missing(found["begun"], path, ("hands_on", "times"))
    passing = None
    if "in_passing" in found:
        path = f"{key}.in_passing"
        bounds = scope.row(found["in_passing"], path, ("times",))
        if "times" in bounds:
            passing = reader.number(bounds["times"], f"{path}.times", 1.0, 1000.0)
        else:
            reader.missing(found["in_passing"], path, ("times",))
    return Durations(MappingProxyType(rows), default, begun, passing)


def _operation(scope: Scope, node: Node, key: str, verb: str) -> dict[Key, OperationDuration]:
    reader = scope.reader
    found = scope.row(node, key, (*_TIMES, "needed_for", "worked", "objects"))
    rows: dict[Key, OperationDuration] = {}
    needed = reader.strings(found["needed_for"], f"{key}.needed_for") if "needed_for" in found else ()
    worked = "worked" in found and reader.boolean(found["worked"], f"{key}.worked")
    if "hands_on" in found or "elapsed" in found or "objects" not in found:
        whole = _times(reader, node, key, found)
        if whole is not None:
            rows[verb, None] = replace(whole, needed_for=needed, worked=worked)
    if "objects" in found:
        path = f"{key}.objects"
        for thing, value in reader.mapping(found["objects"], path).items():
            times = scope.row(value, f"{path}.{thing}", (*_TIMES, "needed_for"))
            row = _times(reader, value, f"{path}.{thing}", times)
            own = "needed_for" in times
            needs = reader.strings(times["needed_for"], f"{path}.{thing}.needed_for") if own else needed
            if row is not None:
                rows[verb, thing.lower()] = replace(row, needed_for=needs, worked=worked)
    return rows


def _times(
    reader: Reader, node: Node, key: str, found: dict[str, Node], *, known: bool = True
) -> OperationDuration | None:
    """Read ``hands_on`` and ``elapsed``; one alone stands for both."""
    if "hands_on" not in found and "elapsed" not in found:
        reader.missing(node, key, ("hands_on", "elapsed"))
        return None
    given = {
        name: reader.duration(found[name], f"{key}.{name}", 0.0, 365 * DAY)
        for name in ("hands_on", "elapsed")
        if name in found
    }
    elapsed = given.get("elapsed", given.get("hands_on", 0.0))
    hands_on = given.get("hands_on", elapsed)
    if hands_on > elapsed:
        message = "the elapsed time must not be shorter than the hands-on time"
        reader.mistake(found["elapsed"], f"{key}.elapsed", message)
        return None
    return OperationDuration(hands_on=hands_on, elapsed=elapsed, source=reader.place(node), known=known)
