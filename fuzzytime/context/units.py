"""Units of readings, and values with their units: ``180 degC``, ``356 degF``, ``20 min``.

A unit that is not in the table is a name ("tasks"): it converts to nothing but itself.
"""

import math
import re
from dataclasses import dataclass

from fuzzytime.errors import FuzzytimeError
from fuzzytime.spelling import nearest
from fuzzytime.times import UNITS as TIME_UNITS
from fuzzytime.times import parse_duration

_QUANTITY = re.compile(r"([-+\u2212]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?)\s*(\S(?:.{0,28}\S)?)?")


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit by its dimension and its size there: base value = ``size`` · value + ``zero``."""

    dimension: str
    size: float
    zero: float = 0.0


def _table(dimension: str, sizes: dict[str, float]) -> dict[str, Unit]:
    return {name: Unit(dimension, size) for spellings, size in sizes.items() for name in spellings.split()}


_FAHRENHEIT = Unit("temperature", 5 / 9, -32 * 5 / 9)
UNITS: dict[str, Unit] = {
    **dict.fromkeys(("degC", "°C", "℃", "C", "celsius"), Unit("temperature", 1.0)),
    **dict.fromkeys(("degF", "°F", "℉", "F", "fahrenheit"), _FAHRENHEIT),
    **dict.fromkeys(("K", "kelvin"), Unit("temperature", 1.0, -273.15)),
    **{name: Unit("time", size) for name, size in TIME_UNITS.items()},
    **_table("share", {"1": 1.0, "% percent": 0.01, "ppm": 1e-6}),
    **_table(
        "mass", {"mg": 1e-6, "g gram grams": 1e-3, "kg": 1.0, "lb lbs": 0.45359237, "oz": 0.028349523125}
    ),
    **_table(
        "length",
        {
            "mm": 1e-3,
            "cm": 1e-2,
            "metre metres meter meters": 1.0,
            "km": 1e3,
            "in inch": 0.0254,
            "ft": 0.3048,
        },
    ),
    **_table("volume", {"ml mL": 1e-3, "cl": 1e-2, "l L litre litres liter liters": 1.0, "gal": 3.785411784}),
    **_table("power", {"mW": 1e-3, "W watt watts": 1.0, "kW": 1e3}),
    **_table("energy", {"J": 1.0, "kJ": 1e3, "Wh": 3600.0, "kWh": 3.6e6}),
    **_table("voltage", {"mV": 1e-3, "V volt volts": 1.0, "kV": 1e3}),
    **_table("current", {"mA": 1e-3, "A": 1.0}),
    **_table("pressure", {"Pa": 1.0, "hPa mbar": 100.0, "kPa": 1e3, "bar": 1e5, "psi": 6894.757293168}),
    **_table("frequency", {"Hz": 1.0, "kHz": 1e3, "rpm": 1 / 60}),
    **_table("speed", {"mm/s": 1e-3, "m/s": 1.0, "km/h": 1 / 3.6, "mph": 0.44704}),
    **_table("force", {"N": 1.0, "kN": 1e3}),
    **_table("torque", {"Nm": 1.0}),
    **_table("illuminance", {"lx lux": 1.0}),
}
"""Every known unit by every name that files and flags may use."""

_SIGNS = ("\u00b0C", "\u00b0F", "%")
"""Units that people write as a sign, whatever they are called in files."""

_EACH_DIMENSION = tuple({unit.dimension: name for name, unit in UNITS.items()}.values())


def misspelt(name: str) -> str | None:
    """Give the known unit that was probably meant by one that is not in the table; None for a plain name.

    >>> misspelt("degc"), misspelt("minuets"), misspelt("tasks"), misspelt("m/s2")
    ('degC', 'minutes', None, None)
    """
    if name in UNITS:
        return None
    # In short names every letter counts: "pH" is not "mph".
    return nearest(name, UNITS, 0.74 if len(name) > 3 and name.isalpha() else 1.0)


def symbol(unit: str | None) -> str:
    """Give a unit as people write it."""
    known = UNITS.get(unit or "")
    return next((sign for sign in _SIGNS if known is not None and UNITS[sign] == known), unit or "")


_DEGREE = frozenset(("degree", "degrees", "deg", "\u00b0", "\u00ba"))
_SPOKEN: dict[str, str] = {
    **dict.fromkeys(("c", "celsius", "centigrade"), "degC"),
    **dict.fromkeys(("f", "fahrenheit"), "degF"),
    **dict.fromkeys(("k", "kelvin", "kelvins"), "K"),
    **dict.fromkeys(("per cent", "pct"), "%"),
    **dict.fromkeys(("kilowatt", "kilowatts"), "kW"),
    **dict.fromkeys(("amp", "amps", "ampere", "amperes"), "A"),
    **dict.fromkeys(("kilo", "kilos", "kilogram", "kilograms"), "kg"),
    **dict.fromkeys(("pound", "pounds"), "lb"),
    **dict.fromkeys(("ounce", "ounces"), "oz"),
    **dict.fromkeys(("millimetre", "millimetres", "millimeter", "millimeters"), "mm"),
    **dict.fromkeys(("centimetre", "centimetres", "centimeter", "centimeters"), "cm"),
    **dict.fromkeys(("kilometre", "kilometres", "kilometer", "kilometers"), "km"),
    **dict.fromkeys(("inches", '"'), "inch"),
    **dict.fromkeys(("foot", "feet"), "ft"),
    **dict.fromkeys(("bars",), "bar"),
    **dict.fromkeys(("hertz",), "Hz"),
    **dict.fromkeys(("newton", "newtons"), "N"),
    **dict.fromkeys(("revolutions per minute", "turns per minute"), "rpm"),
    **dict.fromkeys(("kilometres per hour", "kilometers per hour", "kph"), "km/h"),
    **dict.fromkeys(("miles per hour",), "mph"),
}
"""Units as people say them, beside the names that files and flags use."""

_NOT_SPOKEN = frozenset(("1", "in"))
"""Units that are another word in a sentence: "20 in the queue"."""

_MOST_WORDS = 3


def measured_in(behind: str, unit: str | None) -> str | None:
    """Give the unit that the words behind a number begin with, if what is in ``unit`` can be said in it.

    Degrees of no scale are those of ``unit``, where that is a temperature.

    >>> measured_in("degrees of heat", "degC"), measured_in("\u00b0F", "degC"), measured_in("percent", "degC")
    ('degC', 'degF', None)
    >>> measured_in("parts are left", "parts"), measured_in("", "parts")
    ('parts', None)
    """
    words = behind.strip().replace("\u00b0", " \u00b0 ").replace("\u00ba", " \u00b0 ").split()
    degrees = bool(words) and words[0].lower().rstrip(".,;") in _DEGREE
    rest = words[1:] if degrees else words
    said = None
    for length in range(min(_MOST_WORDS, len(rest)), 0, -1):
        said = _said_unit(" ".join(rest[:length]).rstrip(".,;:!?"), unit)
        if said is not None:
            break
    scale = UNITS.get(unit or "")
    if degrees and (said is None or UNITS[said].dimension != "temperature"):
        return unit if scale is not None and scale.dimension == "temperature" else None
    if said is None or said == unit:
        return said
    alike = scale is not None and said in UNITS and UNITS[said].dimension == scale.dimension
    return said if alike else None


def _said_unit(text: str, unit: str | None) -> str | None:
    if unit is not None and unit not in UNITS and text.lower() in (unit.lower(), unit.lower().rstrip("s")):
        return unit
    named = text if text in UNITS and text not in _NOT_SPOKEN else None
    return _SPOKEN.get(text.lower(), named)


def fits(behind: str, unit: str | None) -> bool:
    """Tell whether a number with words behind it may be a value in a unit: in it, or a bare number.

    >>> fits("degrees", "degC"), fits("parts are left", "degC"), fits("percent", "degC")
    (True, True, False)
    """
    if measured_in(behind, unit) is not None:
        return True
    return not any(measured_in(behind, known) for known in _EACH_DIMENSION)


def convert(value: float, source: str, target: str) -> float:
    """Convert a value between two units.

    Raises
    ------
    FuzzytimeError
        If the two do not measure the same.

    >>> round(convert(356, "degF", "degC"), 9), convert(20, "min", "s"), convert(3, "tasks", "tasks")
    (180.0, 1200.0, 3)
    """
    if source == target:
        return value
    start, end = UNITS.get(source), UNITS.get(target)
    if start is None or end is None or start.dimension != end.dimension:
        meant = misspelt(source)
        hint = f" (did you mean {meant!r}?)" if meant is not None else ""
        raise FuzzytimeError(f"a value in {source!r} cannot be converted to {target!r}{hint}")
    return (start.size * value + start.zero - end.zero) / end.size


def parse_quantity(text: str) -> tuple[float, str | None]:
    """Read a number with its unit, if there is one; a duration such as ``1h30`` comes in seconds.

    Raises
    ------
    FuzzytimeError
        If the text is no finite number followed by at most a unit.

    >>> parse_quantity("180 degC"), parse_quantity("21.5"), parse_quantity("1h30")
    ((180.0, 'degC'), (21.5, None), (5400.0, 's'))
    """
    match = _QUANTITY.fullmatch(text.strip())
    if match is None:
        raise FuzzytimeError(f"a value must be a number and perhaps a unit, such as '180 degC', got {text!r}")
    unit = match[2]
    if unit is not None and unit[0].isalpha() and unit not in UNITS and any(map(str.isdigit, unit)):
        try:
            return parse_duration(text), "s"
        except FuzzytimeError:
            pass
    value = float(match[1].replace("\u2212", "-"))
    if not math.isfinite(value):
        raise FuzzytimeError(f"a value must be finite, got {text!r}")
    return value, unit
