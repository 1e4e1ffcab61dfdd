"""How hours are typed in the lines of a list: "Panel 11.30", "0730 breakfast", "Lunch 12 to 1"."""

import re
from functools import cache

DECIMAL = re.compile(r"(?<![\d.])\d+\.(\d\d)(?![\d.])")
"""A number with two digits behind its point."""

POINT = re.compile(r"(?<=\d)\.(?=[0-5]\d)")
"""What stands for a colon in an hour."""

ALONE = re.compile(
    r"\s*(?P<hour>1[0-2]|[1-9])(?P<until>\s?[-–—]\s?(?:1[0-2]|[1-9]))?\s+(?P<dash>[-–—]\s+)?(?=[^\W\d])"
)
"""A number alone in front of a line, or two from when to when."""

ENDS = r"\s*(?:$|[,;()!]|\.(?!\d)|[-–—]\s)"
"""What ends what is said of when something is."""

DIGITS = r"(?:2[0-3]|[01]\d)[0-5]\d(?!\d|-\d\d-)"
"""An hour and its minutes without a mark: "0730"; where one has a zero in front, so are the others hours.

"2026-03-05" is a day.
"""


LEADING = re.compile(
    rf"""
    \s*~?(?:
      (?P<digits>{DIGITS})(?:\s?[-–]\s?{DIGITS})?(?=[ \t]?:?\s+(?:[-–—]\s+)?[^\W\d])
    | (?:2[0-3]|[01]?\d)(?P<point>\.)[0-5]\d(?![\d.:%°])(?=[:;,?!]*\s*[^\w\s]{{0,2}}\s*\w)
    )""",
    re.VERBOSE,
)
"""An hour and its minutes in front of a line, or two without marks from when to when."""

THREE = re.compile(r"\s*(?P<digits>[1-9][0-5]\d)(?=[ \t]?:?\s+(?:[-–—]\s+)?[^\W\d])")
"""An hour and its minutes in front of a line in three digits, where those of all lines go up: "430 run"."""


FURTHER = re.compile(r"(?:(?:,\s|\s?/\s?|\s(?:and|&|\+)\s)(?:2[0-3]|[01]?\d)\.[0-5]\d(?![\d.]))+")
"""Further such hours behind it: "2.15 & 3.15 tours"."""


@cache
def hours_behind(halves: frozenset[str]) -> re.Pattern[str]:
    """Give what finds a number behind a word, or two from when to when."""
    half = rf"(?:\s?(?:{'|'.join(map(re.escape, sorted(halves, key=len, reverse=True)))})(?!\w))?"
    hour, minutes = r"(?:2[0-3]|[01]?\d)", r"[.:][0-5]\d"
    return re.compile(
        rf"""
        (?<=[\w)]) (?P<gap>: | , | … | \s[-–—=](?=\s))? \s* (?P<mark>[ \t])
        (?: (?P<digits>{DIGITS}) | {hour} (?P<minutes>{minutes}) | (?:1[0-2]|0?[1-9])(?![\d.:]) )
        (?P<until> {half} (?:(?P<dash>\s[-–]\s)|\s?[-–]\s?|\s(?:to|'?till?|until)\s)
                   (?:{DIGITS} | {hour} (?P<last>{minutes})?) )?
        (?P<more> (?:,\s{hour}(?:{minutes})?)* \s(?:and|&|\+)\s{hour}(?:{minutes})?
                | (?:,\s{hour}{minutes})+ )?
        {half} (?P<ends>(?={ENDS}))? (?!\d|[\w.:/%°]\S|[/%°])
        """,
        re.VERBOSE | re.IGNORECASE,
    )
