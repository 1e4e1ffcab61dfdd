"""Lookup: the row of the tables that a requirement's words lead to (the paper's section III-B1)."""

from dataclasses import dataclass, replace

from fuzzytime.requirement import Constraint, TimeRequirement, Unit
from fuzzytime.rulebook.tables.contents import Model, Row, Tables
from fuzzytime.rulebook.tables.matching import described
from fuzzytime.times import DAY, HOUR, MINUTE

UNIT_LENGTHS = {
    Unit.SECOND: 1.0,
    Unit.MINUTE: MINUTE,
    Unit.HOUR: HOUR,
    Unit.DAY: DAY,
    Unit.WEEK: 7 * DAY,
    Unit.MONTH: 30 * DAY,
    Unit.QUARTER: 91 * DAY,
    Unit.YEAR: 365 * DAY,
}


@dataclass(frozen=True, slots=True)
class Found:
    """The row for a requirement with its time, the model it names, and the hedges still to be applied."""

    row: Row
    model: Model
    hedges: tuple[str, ...]
    interval: tuple[float, float] | None = None
    notes: tuple[str, ...] = ()


def find(requirement: TimeRequirement, tables: Tables, verb: str | None = None) -> Found:
    """Find the row for a requirement: an exact entry, the word's, the preposition's, the constraint's.

    There is always one, as every constraint has a row of its own.
    """
    texts = described(requirement, verb)
    due = (
        described(replace(requirement, constraint=Constraint.BEFORE), verb)
        if _is_dated(requirement, tables)
        else None
    )
    for entry in tables.entries:
        if entry.match(texts) or (due is not None and entry.row.dated is not None and entry.match(due)):
            hedges = () if "hedge" in entry.match.keys else requirement.fuzziness
            return _found(entry.row, requirement, tables, hedges)
    worded = _word_row(requirement, tables)
    if worded is not None:
        return _found(worded[0], requirement, tables, worded[1])
    calendar = tables.grains.get(requirement.grain) if requirement.grain is not None else None
    if calendar is not None and _interval(requirement) is not None and requirement.preposition != "between":
        return _found(calendar, requirement, tables, requirement.fuzziness)
    constraint = _expressible(requirement)
    row = tables.prepositions.get(requirement.preposition or "")
    if row is None or _model(row, tables).constraint not in (None, constraint):
        row = tables.constraints[constraint]
    found = _found(row, requirement, tables, requirement.fuzziness)
    if requirement.constraint is Constraint.VAGUE:
        words = requirement.word or requirement.text
        return replace(found, notes=(f"no row for {words!r}: taken as at any time",))
    return found


def _is_dated(requirement: TimeRequirement, tables: Tables) -> bool:
    """Whether it is a deadline on a day that is said, where that begins: "on sunday by six"."""
    row = tables.prepositions.get(requirement.preposition or "")
    due = row is not None and _model(row, tables).constraint is Constraint.BEFORE
    return due and requirement.constraint is Constraint.BETWEEN and _interval(requirement) is not None


def _word_row(requirement: TimeRequirement, tables: Tables) -> tuple[Row, tuple[str, ...]] | None:
    """Find the row of a time word: with hedges, as it was said, or as the language calls it.

    The longest run of hedges before the word counts that has a row with it ("very soon"); then the row of
    the very words ("whenever you can"), and then that of what they are called ("when you can").
    """
    if requirement.word is None:
        return None
    hedges = requirement.fuzziness
    for start in range(len(hedges)):
        row = tables.words.get(" ".join((*hedges[start:], requirement.word)))
        if row is not None:
            return row, hedges[:start]
    said = " ".join(requirement.text.lower().split())
    row = tables.words.get(said) or tables.words.get(requirement.word)
    return None if row is None else (row, hedges)


def _expressible(requirement: TimeRequirement) -> Constraint:
    """Give the constraint that the times at hand can express: "between" with one end is before or after."""
    constraint = requirement.constraint
    times = (requirement.t_spec, requirement.earliest, requirement.latest)
    if constraint is Constraint.BETWEEN:
        if requirement.earliest is None and requirement.latest is None:
            return Constraint.VAGUE
        if requirement.earliest is None or requirement.latest is None:
            return Constraint.BEFORE if requirement.earliest is None else Constraint.AFTER
    if constraint in (Constraint.AT, Constraint.BEFORE, Constraint.AFTER) and times == (None, None, None):
        return Constraint.VAGUE
    return constraint


def _interval(requirement: TimeRequirement) -> tuple[float, float] | None:
    """Give the interval that is meant: between two times, or a whole day, week, … that is named."""
    low, high = requirement.earliest, requirement.latest
    if requirement.constraint is Constraint.BETWEEN and low is not None and high is not None:
        return low, high
    grain, start = requirement.grain, _time(requirement)
    if requirement.constraint is Constraint.AT and start is not None and grain in _CALENDAR:
        return start, start + UNIT_LENGTHS[grain]
    return None


_CALENDAR = (Unit.DAY, Unit.WEEK, Unit.MONTH, Unit.QUARTER, Unit.YEAR)


def _time(requirement: TimeRequirement) -> float | None:
    """Give the time that is named, by whichever field names it."""
    first = {Constraint.BEFORE: requirement.latest, Constraint.AFTER: requirement.earliest}
    times = (requirement.t_spec, first.get(requirement.constraint), requirement.earliest, requirement.latest)
    return next((time for time in times if time is not None), None)


def _model(row: Row, tables: Tables) -> Model:
    return row.own if row.own is not None else tables.models[row.model]


def _found(row: Row, requirement: TimeRequirement, tables: Tables, hedges: tuple[str, ...]) -> Found:
    interval = _interval(requirement)
    model = _model(row, tables)
    if row.dated is not None and requirement.constraint is Constraint.BETWEEN:
        model = tables.models[row.dated]
    elif interval is not None and interval[0] <= 0 < interval[1] and row.begun is not None:
        model = tables.models[row.begun]
        interval = (0.0, interval[1])
    elif requirement.constraint is Constraint.AT:
        named = [tables.time_hedges[hedge].model for hedge in hedges if hedge in tables.time_hedges]
        model = next((tables.models[name] for name in named if name is not None), model)
    t = row.t if row.t is not None else _time(requirement)
    return Found(replace(row, t=t), model, (*row.hedges, *hedges), interval)
