"""Marks between a thing, its hour, and what more is said of it: "Tea: 10.30", "Evensong 6.00, Psalm 121"."""

import re
from collections.abc import Set as AbstractSet

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.timetables import timetable_of
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import blanked

COLON = re.compile(r":(?P<pause>[ \t]+)(?=\d)")
"""A colon that may stand in front of an hour."""

CALLED = re.compile(
    r"(?P<front>^[ \t]*(?:2[0-3]|[01]?\d)[.:]?[0-5]\d(?:[ap]m)?(?:[ \t]?[-–][ \t]?\d[\d.:]*)?"
    r"(?:[ \t]+[^\W\d][\w'’&/.-]*){1,3})(?P<colon>:)(?=[ \t]+[^\W\d])",
    re.MULTILINE,
)
"""An hour, and what is then in a word or more, up to the colon before the rest: "9.30 Hall: chairs"."""

IN_LISTS = re.compile(
    r"(?<=[^\W\d])(?::|[ \t]+[-–—=])(?=[ \t]+\d{1,2}(?:[.:]\d\d)?(?:[ \t]?[ap]m)?[ \t]*(?:[,;]|$))",
    re.MULTILINE,
)
"""A mark between a thing and the hour that ends an entry: "gym - 6, dinner - 8"."""

MORE = re.compile(
    r"""
    ^[\s*+•-]* (?P<first>[^\W\d][\w'’]*) [^\n;,\d]* (?P<gap>[ \t])
    (?P<hour>\d[\d.:]*(?:[ \t]?[-–][ \t]?\d[\d.:]*)?) (?P<mark>,|[ \t]+[-–—])
    (?= [ \t]+ (?P<begins>[^\W\d][\w'’]*) (?![^\n;]*\d[.:h]) )
    """,
    re.MULTILINE | re.VERBOSE,
)
"""A thing with its hour, and a mark before more words without an hour."""

LED = re.compile(
    r"^[\s*+•-]*\d[\d.:apmh–-]*[ \t]+[^\n;,\d]*?(?P<named>[^\W\d]+)(?P<mark>,)"
    r"(?=[ \t]+(?P<begins>[^\W\d][\w'’]*)[^\n;,\d]*$)",
    re.MULTILINE,
)
"""An hour, who is met then, and a mark before more words without an hour: "12:15 dentist, Sam"."""


def without_joints(text: str, hours: AbstractSet[int], lexicon: Lexicon, *, listed: bool) -> str:
    """Give a text without the colons in front of its hours, and behind what they are in front of.

    In a list of times, more is said of a thing behind its hour, unless that is another thing to do.

    >>> from fuzzytime.language import shipped_lexicon
    >>> without_joints("Tea: 10.30", {4}, shipped_lexicon(), listed=False)
    'Tea  10.30'
    >>> without_joints("9.30 Hall: chairs", {1}, shipped_lexicon(), listed=True)
    '9.30 Hall  chairs'
    >>> without_joints("Tea 10.30, Hall 2", {3}, shipped_lexicon(), listed=True)
    'Tea 10.30  Hall 2'
    """
    marks = [found.span() for found in IN_LISTS.finditer(text)]
    alone = blanked(text, marks)
    if len(marks) > 1 and timetable_of(words_of(alone), lexicon):
        text = alone
    called = (found for found in CALLED.finditer(text) if listed or ":" in found["front"])
    text = blanked(text, (found.span("colon") for found in called))
    text = COLON.sub(lambda found: (" " if found.end() - 1 in hours else ":") + found["pause"], text)
    behind = [found for found in MORE.finditer(text) if listed and _says_more(found, hours, lexicon)]
    behind += [found for found in LED.finditer(text) if listed and _names_more(found, lexicon)]
    return blanked(text, (found.span("mark") for found in behind))


def _says_more(found: re.Match[str], hours: AbstractSet[int], lexicon: Lexicon) -> bool:
    """Whether a mark behind an hour stands before more of what is then: "Evensong 6.00, Psalm 121"."""
    timed = ":" in found["hour"] or ("." in found["hour"] and found.start("gap") in hours)
    return timed and not _asks(found["begins"], lexicon) and found["first"].lower() not in lexicon.orders


def _names_more(found: re.Match[str], lexicon: Lexicon) -> bool:
    """Whether a mark behind who is met at an hour stands before no order to them."""
    return found["named"].lower() in lexicon.persons and not _asks(found["begins"], lexicon)


def _asks(word: str, lexicon: Lexicon) -> bool:
    """Whether a word begins another thing to do, or goes on with a sentence: "don't", "bring", "with"."""
    said = word.lower().replace("’", "'")
    joined = tuple(negator for negator in lexicon.closed.negators if not negator.isalpha())
    return said in lexicon.orders | lexicon.addressing | lexicon.function_words or said.endswith(joined)
