"""Reading the word tables: YAML to a `Lexicon`, with every mistake at its line and column."""

from collections.abc import Callable, Iterable
from datetime import time
from pathlib import Path
from typing import Any

from fuzzytime.errors import DocumentError, FuzzytimeError
from fuzzytime.language.grammar.lexicon import Entry, Lexicon, Preposition, form_of
from fuzzytime.language.meaning.calendar import Feast, Reckoning, Season
from fuzzytime.language.meaning.expressions import Edge, Ending, Half, Part, Quantity, TimeWord, UnitWord
from fuzzytime.language.meaning.relations import Relative, Which
from fuzzytime.language.policy import DateOrder, Policy, SameWeekday
from fuzzytime.requirement import Constraint, Unit
from fuzzytime.times import parse_clock, parse_zone
from fuzzytime.yaml_nodes import Node, Reader, Scalar

FULL_STOP_BELOW = 6
"""Words shorter than this may be typed with a full stop, as abbreviations are."""

MORE_WORDS = 0.1
"""What each further word of a form weighs: "sometime around" is one preposition, not one and a hedge."""

Form = tuple[str, ...]


class Tables:
    """One file of word tables: its mappings, and the entries gathered from them."""

    def __init__(self, path: Path, sections: Iterable[str]) -> None:
        self.reader = Reader.of_file(path)
        names = ("fuzzytime", "language", *sections)
        self.sections = self.reader.mapping(self.reader.root(), "", names, names)
        self.entries: list[Entry] = []
        self.seen: dict[tuple[Form, str], int] = {}
        if "fuzzytime" in self.sections:
            self.reader.whole(self.sections["fuzzytime"], "fuzzytime", 1, 1)

    def rows(self, section: str) -> list[tuple[Scalar, Node]]:
        """Give the keys and values of a section."""
        node = self.sections.get(section)
        if node is None:
            return []
        values = self.reader.mapping(node, section)
        keys = self.reader.keys(node)
        return [(keys[name], value) for name, value in values.items()]

    def forms(self, node: Node, key: str) -> list[Form]:
        """Give ways to say something, cut into words."""
        found = []
        for text in self.reader.strings(node, key):
            if form_of(text):
                found.append(form_of(text))
            else:
                self.reader.mistake(node, key, "a way to say something must hold a word, got none")
        return found

    def table(
        self,
        section: str,
        allowed: dict[str, bool],
        make: Callable[[str, dict[str, Node]], Iterable[tuple[str, Any]]],
    ) -> None:
        """Add the entries of a section whose rows are mappings: ``make`` gives categories and meanings.

        ``allowed`` says which keys a row may have, and which it must.
        """
        for name, node in self.rows(section):
            key = f"{section}.{name.text}"
            required = [field for field, must in allowed.items() if must]
            fields = self.reader.mapping(node, key, (*allowed, "also"), required)
            if any(field not in fields for field in required):
                continue
            said = [form_of(name.text)]
            if "also" in fields:
                said += self.forms(fields["also"], f"{key}.also")
            for category, value in make(name.text, fields):
                self.add(name, key, category, value, said)

    def plain(
        self, section: str, make: Callable[[Scalar], Iterable[tuple[str, Any]]], *, named: bool
    ) -> None:
        """Add the entries of a section whose rows are lists of forms; ``named``: the key is a form too."""
        for name, node in self.rows(section):
            said = [form_of(name.text)] if named else []
            said += self.forms(node, f"{section}.{name.text}")
            for category, value in make(name):
                self.add(name, f"{section}.{name.text}", category, value, said)

    def add(self, node: Node, key: str, category: str, value: object, forms: Iterable[Form]) -> None:
        """Add entries; the same words must not have two meanings in one category."""
        for form in forms:
            self.entries.append(Entry(form, category, value, MORE_WORDS * (len(form) - 1)))
            if self.seen.setdefault((form, category), len(self.entries)) != len(self.entries):
                self.reader.mistake(
                    node, key, f"words must have one meaning in a table, got {' '.join(form)!r} twice"
                )

    def clock(self, node: Node, key: str) -> int:
        """Read a time of day as seconds since midnight."""
        found = self.reader.read(node, key, parse_clock) if isinstance(node, Scalar) else None
        if found is None:
            if not isinstance(node, Scalar):
                self.reader.string(node, key)
            return 0
        return found.hour * 3600 + found.minute * 60 + found.second

    def words(self, section: str, key: str | None = None) -> list[Form]:
        """Give a section that is one list of forms, or a list within it."""
        node = self.sections.get(section)
        if node is None:
            return []
        if key is None:
            return self.forms(node, section)
        fields = self.reader.mapping(node, section)
        return self.forms(fields[key], f"{section}.{key}") if key in fields else []


def read_lexicon(words: Path, calendar: Path) -> Lexicon:
    """Read both files.

    Raises
    ------
    OSError
        If a file cannot be read.
    DocumentError
        If a table breaks rules.
    """
    speech = Tables(words, _SPEECH)
    days = Tables(calendar, _CALENDAR)
    _read_prepositions(speech)
    _read_hedges(speech)
    _read_words(speech)
    _read_units(days)
    _read_days(days)
    _read_parts(days)
    _read_feasts(days)
    _read_clocks(days)
    amounts = dict(_amounts(speech))
    clauses = _by_form(speech, "clauses")
    connectives = _by_form(speech, "connectives")
    indicators = {" ".join(form): name for form, name in _by_form(speech, "indicators").items()}
    policy = _policy(days)
    mistakes = (*speech.reader.mistakes, *days.reader.mistakes)
    if mistakes:
        raise DocumentError(mistakes)
    entries: dict[str, list[Entry]] = {}
    for entry in (*speech.entries, *days.entries):
        entries.setdefault(entry.words[0], []).append(entry)
    return Lexicon(
        entries={first: tuple(found) for first, found in entries.items()},
        numbers=_numbers(days, "numbers"),
        magnitudes={
            form[0]: int(name.text) for name, node in days.rows("magnitudes") for form in days.forms(node, "")
        },
        ordinals=_numbers(days, "ordinals"),
        ambiguous=frozenset(form[0] for form in days.words("ambiguous")),
        indicators=indicators,
        connectives=connectives,
        clauses=clauses,
        corrections=frozenset(speech.words("corrections")),
        addresses=frozenset(form[0] for form in speech.words("addresses")),
        amounts=amounts,
        results=frozenset(" ".join(form) for form in speech.words("results")),
        wanting=frozenset(form[0] for form in speech.words("verbs", "wanting")),
        forgetting=frozenset(form[0] for form in speech.words("verbs", "forgetting")),
        causing=frozenset(form[0] for form in speech.words("verbs", "causing")),
        particles={
            form[0]: frozenset(" ".join(verb) for verb in speech.forms(node, f"particles.{name.text}"))
            for name, node in speech.rows("particles")
            for form in (form_of(name.text),)
        },
        places=frozenset(form[0] for form in speech.words("places")),
        persons=frozenset(form[0] for form in speech.words("persons")),
        addressing=frozenset(form[0] for form in speech.words("verbs", "addressing")),
        measure_verbs=frozenset(form[0] for form in speech.words("measures", "verbs")),
        measure_nouns=frozenset(form[0] for form in speech.words("measures", "nouns")),
        function_words=frozenset(form[0] for form in speech.words("function_words")),
        policy=policy,
    )


_SPEECH = (
    "prepositions", "hedges", "words", "indicators", "verbs", "results", "connectives", "addresses",
    "clauses", "corrections", "particles", "places", "persons",
    "amounts", "measures", "function_words",
)  # fmt: skip
_CALENDAR = (
    "numbers", "magnitudes", "ordinals", "fractions", "units", "weekdays", "months", "ambiguous",
    "days", "deictics", "parts", "day_halves", "day_parts", "shares", "edges", "abbreviated_edges", "seasons",
    "holidays",
    "meridiem", "zones", "policy",
)  # fmt: skip


def _read_prepositions(tables: Tables) -> None:
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


def _read_hedges(tables: Tables) -> None:
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
        if "side" not in fields:
            return []
        side = reader.choice(fields["side"], f"hedges.{name}.side", sides)
        return [(category, name) for category in sides.get(side, ())]

    tables.table("hedges", {"side": False, "number": False}, make)


def _read_words(tables: Tables) -> None:
    def make(name: str, fields: dict[str, Node]) -> Iterable[tuple[str, Any]]:
        kinds = (Constraint.AT, Constraint.VAGUE)
        constraint = tables.reader.choice(fields["constraint"], f"words.{name}.constraint", kinds)
        return [("word", TimeWord(name, Constraint(constraint or Constraint.VAGUE)))]

    tables.table("words", {"constraint": True}, make)
    for form in tables.words("corrections"):
        tables.entries.append(Entry(form, "correction", " ".join(form)))


def _read_units(tables: Tables) -> None:
    for name, node in tables.rows("units"):
        key = f"units.{name.text}"
        count, _, unit = name.text.rpartition(" ")
        if unit not in tuple(Unit) or not (count or "1").isdecimal():
            tables.reader.mistake(name, key, f"a unit must be a number of known units, got {name.text!r}")
            continue
        for form in tables.forms(node, key):
            tables.add(
                node,
                key,
                "unit",
                UnitWord(Unit(unit), int(count or 1), " ".join(form)),
                [form, *_stopped(form)],
            )

    def fraction(name: Scalar) -> Iterable[tuple[str, Any]]:
        return [("fraction", tables.reader.number(name, f"fractions.{name.text}", 0, 1))]

    tables.plain("fractions", fraction, named=False)


def _read_days(tables: Tables) -> None:
    reader = tables.reader
    for section, category, last in (("weekdays", "weekday", 6), ("months", "month", 12)):
        for name, node in tables.rows(section):
            key = f"{section}.{name.text}"
            number = reader.whole(name, key, 0, last)
            for form in tables.forms(node, key):
                tables.add(node, key, category, number, [form, *_stopped(form)])
                if category == "weekday" and len(form[0]) >= FULL_STOP_BELOW:
                    tables.add(node, key, "weekdays", number, [(form[0] + "s",)])
    tables.plain("days", lambda n: [("day", Relative(reader.whole(n, "days", -9, 9)))], named=False)
    tables.plain(
        "deictics",
        lambda n: [("deictic", Which(reader.choice(n, "deictics", tuple(Which)) or Which.THIS))],
        named=True,
    )


def _stopped(form: Form) -> list[Form]:
    """Give an abbreviation's form with its full stop."""
    return [(*form, ".")] if len(form) == 1 and len(form[0]) < FULL_STOP_BELOW else []


def _read_parts(tables: Tables) -> None:
    reader = tables.reader
    parts: dict[str, Part] = {}

    def part(name: str, fields: dict[str, Node]) -> Iterable[tuple[str, Any]]:
        key = f"parts.{name}"
        start, end = tables.clock(fields["from"], f"{key}.from"), tables.clock(fields["to"], f"{key}.to")
        half = reader.choice(fields["half"], f"{key}.half", tuple(Half)) or Half.DAY
        meal = "meal" in fields and reader.boolean(fields["meal"], f"{key}.meal")
        place = "place" in fields and reader.boolean(fields["place"], f"{key}.place")
        late = tables.clock(fields["late"], f"{key}.late") if "late" in fields else None
        if late is not None and not start <= late <= end:
            reader.mistake(fields["late"], f"{key}.late", "a part's late half must begin inside it")
        parts[name] = Part(name, start, end + (86400 if end < start else 0), Half(half), meal, late, place)
        if not meal and parts[name].start != parts[name].end:
            tables.add(
                fields["from"], key, "parts", parts[name], [(*form_of(name)[:-1], form_of(name)[-1] + "s")]
            )
        return [("meal" if meal else "part", parts[name])]

    tables.table(
        "parts", {"from": True, "to": True, "half": True, "meal": False, "late": False, "place": False}, part
    )

    for name, node in tables.rows("day_halves"):
        chosen = reader.choice(name, f"day_halves.{name.text}", tuple(parts))
        if chosen:
            tables.add(
                node, f"day_halves.{name.text}", "day_half", parts[chosen], tables.forms(node, "day_halves")
            )

    def day_part(name: str, fields: dict[str, Node]) -> Iterable[tuple[str, Any]]:
        day = reader.whole(fields["day"], f"day_parts.{name}.day", -9, 9)
        chosen = reader.choice(fields["part"], f"day_parts.{name}.part", tuple(parts))
        return [("day_part", (Relative(day), parts[chosen]))] if chosen else []

    tables.table("day_parts", {"day": True, "part": True}, day_part)

    def share(name: str, fields: dict[str, Node]) -> Iterable[tuple[str, Any]]:
        low = reader.number(fields["from"], f"shares.{name}.from", 0, 1)
        return [("share", (low, reader.number(fields["to"], f"shares.{name}.to", 0, 1)))]

    tables.table("shares", {"from": True, "to": True}, share)
    tables.plain(
        "edges", lambda n: [("edge", Edge(reader.choice(n, "edges", ("start", "end")) or "end"))], named=False
    )

    def edge(name: str, fields: dict[str, Node]) -> Iterable[tuple[str, Any]]:
        from fuzzytime.language.meaning.calendar import Cycle

        chosen = reader.choice(fields["edge"], f"abbreviated_edges.{name}.edge", ("start", "end")) or "end"
        unit = reader.choice(fields["unit"], f"abbreviated_edges.{name}.unit", tuple(Unit)) or Unit.DAY
        return [("ending", Ending(Edge(chosen), Cycle(Unit(unit))))]

    tables.table("abbreviated_edges", {"edge": True, "unit": True}, edge)


def _read_feasts(tables: Tables) -> None:
    reader = tables.reader
    weekdays = {f[0]: int(n.text) for n, node in tables.rows("weekdays") for f in tables.forms(node, "")}
    months = {f[0]: int(n.text) for n, node in tables.rows("months") for f in tables.forms(node, "")}

    def feast(name: str, fields: dict[str, Node]) -> Iterable[tuple[str, Any]]:
        key = f"holidays.{name}"
        days = reader.whole(fields["days"], f"{key}.days", -366, 366) if "days" in fields else 0
        if "date" in fields:
            month, day = _month_day(tables, fields["date"], f"{key}.date")
            return [("feast", Feast(name, Reckoning.DATE, month, day, days=days))]
        if "easter" in fields:
            days += reader.whole(fields["easter"], f"{key}.easter", -366, 366)
            return [("feast", Feast(name, Reckoning.EASTER, days=days))]
        if "nth" in fields:
            items = reader.sequence(fields["nth"], f"{key}.nth", 3)
            if not items:
                return []
            nth = reader.whole(items[0], f"{key}.nth[0]", -4, 4) or 1
            weekday = weekdays.get(reader.choice(items[1], f"{key}.nth[1]", weekdays), 0)
            month = months.get(reader.choice(items[2], f"{key}.nth[2]", months), 1)
            return [("feast", Feast(name, Reckoning.NTH, month, nth=nth, weekday=weekday, days=days))]
        reader.mistake(next(iter(fields.values())), key, "a holiday needs 'date', 'nth' or 'easter'")
        return []

    tables.table("holidays", {"date": False, "nth": False, "easter": False, "days": False}, feast)

    def season(name: str, fields: dict[str, Node]) -> Iterable[tuple[str, Any]]:
        begins = _month_day(tables, fields["from"], f"seasons.{name}.from")
        return [("season", Season(name, begins, _month_day(tables, fields["to"], f"seasons.{name}.to")))]

    tables.table("seasons", {"from": True, "to": True}, season)


def _month_day(tables: Tables, node: Node, key: str) -> tuple[int, int]:
    text = tables.reader.string(node, key)
    month, _, day = text.partition("-")
    if (
        month.isdecimal()
        and day.isdecimal()
        and 1 <= int(month) <= 12
        and 1 <= int(day) <= 28 + 3 * (month != "02")
    ):
        return int(month), int(day)
    tables.reader.mistake(node, key, f"a day of the year must look like 12-24, got {text!r}")
    return 1, 1


def _read_clocks(tables: Tables) -> None:
    reader = tables.reader
    halves = (Half.AM, Half.PM, Half.EITHER)
    tables.plain(
        "meridiem",
        lambda n: [("meridiem", Half(reader.choice(n, "meridiem", halves) or Half.EITHER))],
        named=False,
    )

    def zone(name: Scalar) -> Iterable[tuple[str, Any]]:
        if name.text[:1] not in "+-":
            reader.read(name, f"zones.{name.text}", parse_zone)
        elif _offset(name.text) is None:
            reader.mistake(name, f"zones.{name.text}", f"an offset must look like +05:30, got {name.text!r}")
        return [("zone", name.text)]

    tables.plain("zones", zone, named=False)


def _offset(text: str) -> time | None:
    try:
        return parse_clock(text[1:])
    except FuzzytimeError:
        return None


def _numbers(tables: Tables, section: str) -> dict[str, int]:
    found = {}
    for name, node in tables.rows(section):
        for form in tables.forms(node, f"{section}.{name.text}"):
            if len(form) == 1:
                found[form[0]] = tables.reader.whole(name, f"{section}.{name.text}", 0, 99)
    return found


def _by_form(tables: Tables, section: str) -> dict[Form, str]:
    return {
        form: name.text
        for name, node in tables.rows(section)
        for form in tables.forms(node, f"{section}.{name.text}")
    }


def _amounts(
    tables: Tables,
) -> Iterable[tuple[Form, tuple[str, tuple[float, float, float, float] | None]]]:
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


def _policy(tables: Tables) -> Policy:
    reader = tables.reader
    node = tables.sections.get("policy")
    if node is None:
        return Policy()
    names = ("plausible", "same_weekday", "week_starts", "weekend", "date_order", "bare_pair_from", "ask")
    fields = reader.mapping(node, "policy", names, names)
    if len(fields) < len(names):
        return Policy()
    weekdays = {f[0]: int(n.text) for n, rows in tables.rows("weekdays") for f in tables.forms(rows, "")}
    plausible = reader.mapping(fields["plausible"], "policy.plausible", ("from", "to"), ("from", "to"))
    weekend = reader.mapping(fields["weekend"], "policy.weekend", ("from", "days"), ("from", "days"))
    if len(plausible) < 2 or len(weekend) < 2:
        return Policy()

    def clock(seconds: int) -> time:
        return time(seconds // 3600, seconds // 60 % 60, seconds % 60)

    return Policy(
        plausible_from=clock(tables.clock(plausible["from"], "policy.plausible.from")),
        plausible_to=clock(tables.clock(plausible["to"], "policy.plausible.to")),
        same_weekday=SameWeekday(
            reader.choice(fields["same_weekday"], "policy.same_weekday", tuple(SameWeekday))
            or SameWeekday.NEXT
        ),
        week_starts=weekdays.get(reader.choice(fields["week_starts"], "policy.week_starts", weekdays), 0),
        weekend_from=weekdays.get(reader.choice(weekend["from"], "policy.weekend.from", weekdays), 5),
        weekend_days=reader.whole(weekend["days"], "policy.weekend.days", 1, 6),
        date_order=DateOrder(
            reader.choice(fields["date_order"], "policy.date_order", tuple(DateOrder)) or DateOrder.MONTH_DAY
        ),
        bare_pair_from=reader.whole(fields["bare_pair_from"], "policy.bare_pair_from", 0, 24),
        ask=reader.boolean(fields["ask"], "policy.ask"),
    )
