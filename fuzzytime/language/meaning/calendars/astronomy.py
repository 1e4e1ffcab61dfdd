"""Where the sun and the moon stand, to about a minute of their time: what lunar calendars are reckoned by.

Moments are days of universal time from the ordinals of dates on: the noon of a day is half a day behind
its ordinal. Angles are in degrees. The sun's longitude is by Bretagnon and Simon, Planetary Programs and
Tables from -4000 to +2800 (1986); the moon's by the largest terms of Meeus, Astronomical Algorithms,
chapter 47, as are the times of rising and setting, chapters 12, 13, 15 and 28.
"""

from bisect import bisect
from collections.abc import Callable
from dataclasses import dataclass
from datetime import date
from functools import cache
from math import acos, asin, atan2, cos, degrees, radians, sin

from fuzzytime.language.meaning.calendars.series import LATITUDE, LONGITUDE, SUN

J2000 = 730_120.5
"""The noon of the first of January 2000."""

CENTURY = 36_525.0
SYNODIC_MONTH = 29.530588861
"""Days from new moon to new moon, on average."""

TROPICAL_YEAR = 365.24219
SUN_AT_NEW_YEAR = 280
"""Longitude of the sun on the first of January, about."""

FIRST_NEW_MOON = 730_125.59766
"""The mean new moon of January 2000, from which new moons are counted."""

CLOCKS_AHEAD = {
    1900: -3.0, 1920: 21.0, 1940: 24.0, 1960: 33.0, 1980: 51.0, 2000: 64.0, 2020: 69.0, 2050: 93.0,
    2100: 203.0, 2150: 328.0, 2200: 442.0,
}  # fmt: skip
"""Seconds by which even time is ahead of the turning earth: measured, then as Espenak and Meeus expect."""

SUN_ON_HORIZON = -0.8333
"""Altitude of the sun's middle where its upper edge sets."""

MOON_ON_HORIZON = 0.125
"""The same of the moon, whose parallax is large."""


@dataclass(frozen=True, slots=True)
class Place:
    """Where the sky is seen: degrees north and east, and hours by which its clocks are ahead."""

    latitude: float
    longitude: float
    hours: float


def centuries(moment: float) -> float:
    """Give the centuries of even time from the year 2000 to a moment."""
    year = 2000 + (moment - J2000) / TROPICAL_YEAR
    years = list(CLOCKS_AHEAD)
    place = min(max(bisect(years, year), 1), len(years) - 1)
    first, last = years[place - 1], years[place]
    share = (year - first) / (last - first)
    seconds = CLOCKS_AHEAD[first] + share * (CLOCKS_AHEAD[last] - CLOCKS_AHEAD[first])
    return (moment + seconds / 86_400 - J2000) / CENTURY


def _nutation(t: float) -> float:
    node, sun = radians(124.90 - 1934.134 * t), radians(201.11 + 72001.5377 * t)
    return -0.004778 * sin(node) - 0.0003667 * sin(sun)


def sun(moment: float) -> float:
    """Give the apparent longitude of the sun."""
    t = centuries(moment)
    terms = sum(size * sin(radians(phase + rate * t)) for size, phase, rate in SUN)
    mean = 282.7771834 + 36000.76953744 * t + 0.000005729577951308232 * terms
    aberration = 0.0000974 * cos(radians(177.63 + 35999.01848 * t)) - 0.005575
    return (mean + aberration + _nutation(t)) % 360


def _moon_arguments(t: float) -> tuple[float, float, float, float]:
    elongation = 297.8501921 + 445267.1114034 * t - 0.0018819 * t * t
    of_sun = 357.5291092 + 35999.0502909 * t - 0.0001536 * t * t
    of_moon = 134.9633964 + 477198.8675055 * t + 0.0087414 * t * t
    latitude = 93.2720950 + 483202.0175233 * t - 0.0036539 * t * t
    return radians(elongation), radians(of_sun), radians(of_moon), radians(latitude)


def _sum(terms: tuple[tuple[int, int, int, int, int], ...], t: float) -> float:
    """Give the sum of periodic terms, in degrees; those of the sun's anomaly shrink as its orbit rounds."""
    d, m, n, f = _moon_arguments(t)
    rounding = 1 - 0.002516 * t - 0.0000074 * t * t
    return (
        sum(
            size * rounding ** abs(by_sun) * sin(by_d * d + by_sun * m + by_moon * n + by_f * f)
            for by_d, by_sun, by_moon, by_f, size in terms
        )
        / 1_000_000
    )


def moon(moment: float) -> float:
    """Give the apparent longitude of the moon."""
    t = centuries(moment)
    mean = 218.3164477 + 481267.88123421 * t - 0.0015786 * t * t
    flat = radians(mean - 93.2720950 - 483202.0175233 * t)
    venus, jupiter = radians(119.75 + 131.849 * t), radians(53.09 + 479264.290 * t)
    planets = 0.003958 * sin(venus) + 0.001962 * sin(flat) + 0.000318 * sin(jupiter)
    return (mean + _sum(LONGITUDE, t) + planets + _nutation(t)) % 360


def elongation(moment: float) -> float:
    """Give how far the moon is ahead of the sun: 0 at new moon, 180 at full moon."""
    return (moon(moment) - sun(moment)) % 360


def moment_of(angle: Callable[[float], float], wanted: float, near: float, period: float) -> float:
    """Give the moment near another at which an angle, that grows round in a period, is as wanted."""
    moment = near
    for _ in range(8):
        miss = (angle(moment) - wanted + 180) % 360 - 180
        moment -= miss * period / 360
        if abs(miss) < 1e-5:
            break
    return moment


def moment_in_year(angle: Callable[[float], float], wanted: float, begins: float, year: int) -> float:
    """Give the moment of a year at which an angle of the sun is as wanted, that ``begins`` it about there."""
    days = (wanted - begins) % 360 / 360 * TROPICAL_YEAR
    return moment_of(angle, wanted, date(year, 1, 1).toordinal() + days, TROPICAL_YEAR)


@cache
def sun_reaches(longitude: int, year: int) -> float:
    """Give the moment of a year at which the sun reaches a longitude."""
    return moment_in_year(sun, longitude, SUN_AT_NEW_YEAR, year)


@cache
def new_moon(number: int) -> float:
    """Give the moment of a new moon, counted from the first of the year 2000."""
    return moment_of(elongation, 0, FIRST_NEW_MOON + SYNODIC_MONTH * number, SYNODIC_MONTH)


def new_moon_near(moment: float) -> int:
    """Give the number of the mean new moon that is nearest to a moment."""
    return round((moment - FIRST_NEW_MOON) / SYNODIC_MONTH)


def new_moon_before(moment: float) -> int:
    """Give the number of the last new moon that is not after a moment."""
    number = new_moon_near(moment) + 1
    while new_moon(number) > moment:
        number -= 1
    return number


# -- rising and setting ---------------------------------------------------------------------------------


def _equatorial(longitude: float, latitude: float, t: float) -> tuple[float, float]:
    """Give right ascension and declination, in radians."""
    tilt, lon, lat = radians(23.4392911 - 0.0130042 * t), radians(longitude), radians(latitude)
    ascension = atan2(sin(lon) * cos(tilt) - sin(lat) / cos(lat) * sin(tilt), cos(lon))
    return ascension, asin(sin(lat) * cos(tilt) + cos(lat) * sin(tilt) * sin(lon))


def _hour_angle(moment: float, ascension: float, place: Place) -> float:
    """Give how far a body is past its highest point, in degrees from -180 to 180."""
    turned = 280.46061837 + 360.98564736629 * (moment - J2000) + place.longitude
    return (turned - degrees(ascension) + 180) % 360 - 180


def moon_is_up(moment: float, place: Place) -> bool:
    """Whether the moon is above the horizon."""
    t = centuries(moment)
    ascension, declination = _equatorial(moon(moment), _sum(LATITUDE, t), t)
    hour, north = radians(_hour_angle(moment, ascension, place)), radians(place.latitude)
    altitude = asin(sin(north) * sin(declination) + cos(north) * cos(declination) * cos(hour))
    return degrees(altitude) > MOON_ON_HORIZON


@cache
def daylight(day: int, place: Place) -> tuple[float, float]:
    """Give the moments of sunrise and of sunset of a day, given by its ordinal."""
    noon = day + 0.5 - place.longitude / 360
    t = centuries(noon)
    ascension, declination = _equatorial(sun(noon), 0, t)
    noon -= _hour_angle(noon, ascension, place) / 360
    north = radians(place.latitude)
    height = sin(radians(SUN_ON_HORIZON)) - sin(north) * sin(declination)
    half = degrees(acos(height / (cos(north) * cos(declination)))) / 360
    return noon - half, noon + half
