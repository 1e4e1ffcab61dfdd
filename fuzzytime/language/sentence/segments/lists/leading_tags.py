"""Marks in front of a line of a list that say how urgent it is, or what: "!high", "(A)", "reminder:"."""

import re
from collections.abc import Iterator, Sequence
from functools import cache

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import NOT_USED, Remark, Span, blanked
from fuzzytime.language.sentence.trees.tree import Trees

TAGS = re.compile(r"(?:\s+[#^][^\W\d][\w/-]*)+[ \t]*$", re.MULTILINE)
"""Marks behind it that sort it among others: "call Ann at nine #work #urgent"."""

ONE_TAG = re.compile(r"\S+")
"""One of them."""

BOX = r"(?:[-*+•]\s+)?(?:\[\s?\]\s+)?"
TAG = re.compile(
    rf"^\s*{BOX}(?P<tag>\([A-F]\)|!+[^\W\d]*\d?|[pP][1-4]|\#[^\W\d]\w*)(?=:?\s+\w):?", re.MULTILINE
)
"""A mark in front of what is asked for, with the box before it."""

HOUR = r"(?:2[0-3]|[01]?\d)(?:[.:h]|(?<=[01]\d))[0-5]\d(?:\s?[ap]m)?"
FRONT = r"^[ \t]*(?:[-+*•–][ \t]+)?(?:\[[ \t]?\][ \t]+)?(?:\d{1,2}[.)][ \t]+)?"
HALF = r"[ \t]?[ap]\.?m\b"
OF_HALF = rf"(?:2[0-3]|[01]?\d)(?:[.:][0-5]\d)?{HALF}"
ANY = r"(?:2[0-3]|[01]?\d)(?:[.:][0-5]\d)?"
GLUED = rf"(?:[^\W\d]+[ ])?(?:{ANY}[ ]?[-–][ ]?)?(?:{HOUR}|{ANY}[ap]m?)"
THING = r"(?!(?:noon|midnight)\b)[^\W\d]"
EMPHASIS = r"(?P<open>\*{1,2}|__)(?=[\w([])[^*_\n]*(?<=\S)(?P<close>(?P=open))(?!\w)"
_UNSAID = (
    rf"{FRONT}(?:\d[\d.:–-]*[ \t]+)?{EMPHASIS}",
    rf"{FRONT}(?P<open>\|)|(?P<close>\|)[ \t]*$",
    r"^[ \t]*(?P<open>[-+*•–]|>+)(?=[ \t]+[\w([])(?P<close>[ \t]+\[[ \t]?\](?=[ \t]+\S))?",
    rf"{FRONT}{HOUR}(?P<open>[?!,;:]|[ \t]+[=:])(?P<close>)(?=[ \t]|[^\W\d])",
    rf"{FRONT}{OF_HALF}(?<!\.m)(?P<open>\.)(?P<close>)(?=[ \t]+[^\W\d])",
    rf"{FRONT}(?:{HOUR}|{OF_HALF}\.?)(?P<open>—|--|[-–](?=[ \t]))(?P<close>)(?=[ \t]*{THING})",
    rf"{FRONT}{GLUED}(?P<open>[-–])(?P<close>)(?={THING})",
    rf"{FRONT}[^\W\d][^\n,\d]*(?P<open>,)(?P<close>)(?=[ \t]+{HOUR}(?:$|,|[ \t]+[(\[]))",
    rf"{FRONT}[^\d\n]*(?P<open>[(\[]){HOUR}(?:\s?[-–]\s?{HOUR})?(?P<close>[)\]])",
    r"(?<=[^\W\d][ \t])(?P<open>\()[ap]\.?m\.?(?P<close>\))",
    r"(?<=[^\W\d])[ \t]?(?P<open>\.{2,})(?P<close>)(?=[ \t]?\d)",
    r"(?P<open>!?\[)[^\]\[\n]+(?P<close>\]\([^()\s]*\))",
    r"(?P<open>\[\[(?:[^\]\[|\n]+\|)?)[^\]\[|\n]+(?P<close>\]\])",
    r"(?P<open><)(?:https?://|mailto:)[^<>\s]+(?P<close>>)",
    r"(?P<open>~~(?=\S)[^~\n]+~~)(?P<close>)",
    r"(?P<open><!--.*?-->)(?P<close>)",
    r"(?<=[^\W\d]\s)re(?P<open>:)(?P<close>)(?=\s)",
)
UNSAID = tuple(re.compile(marks, re.MULTILINE | re.IGNORECASE) for marks in _UNSAID)
"""Marks that are no words: of emphasis, cells, lists and fields, around an hour, and in front of it.

Then those of links, of which the words are read and not where they lead, and what is struck out.
"""

BEHIND_STRETCH = re.compile(
    rf"{FRONT}(?:{HOUR}|(?:2[0-3]|[01]?\d)(?:\s?[ap]m)?)\s?[-–—]+\s?(?:{HOUR}|(?:2[0-3]|[01]?\d)\s?[ap]m)"
    r"(?P<mark>[?!.]|[ \t]*[-–—]+|[ \t]+(?:/{1,2}|:))(?=[ \t]+[^\W\d])",
    re.MULTILINE | re.IGNORECASE,
)
"""From when to when it is, in front of a line, and a mark before what that is: "9:30 - 10:05 // Hall"."""

MARK = r"(?:[-,:…]|\.{2,})"
SEVERAL = 2
"""Steps with titles, at least."""

LABEL = re.compile(rf"^\s*{BOX}(?P<label>[^\W\d][\w.]*(?:[ -]\w+)?)(?:[ \t]+-|:)[ \t]+(?=\w)", re.MULTILINE)
"""A word with a colon or a dash behind it, or two, before more on the same line."""


TITLE = re.compile(
    rf"^\s*{BOX}(?:\d{{1,2}}[.)]\s+)?"
    r"(?P<title>[A-Z][\w'’-]*(?: (?:[A-Z][\w'’-]*|[a-z]{1,3}|&))+:)\s+(?=[A-Z][^:\n]*\s[^:\n]*\s\w)"
)
"""Words with capitals and a colon, before a sentence on the same line."""


def step_titles(texts: Sequence[str], trees: Trees, lexicon: Lexicon) -> list[tuple[Span, ...]]:
    """Give what at least half of some steps begin with that names what they say: "Heat the Sauce: Put …".

    One line alone may ask for two things, and a name calls who is asked.
    """
    found = [TITLE.match(text) for text in texts]
    titles = [match["title"] for match in found if match is not None]
    parsed = trees(titles) if len(titles) >= SEVERAL and len(texts) <= SEVERAL * len(titles) else []
    acting = (tree.nodes[0] for tree in parsed)
    named = bool(parsed) and all(one.may_act and one.lower not in lexicon.persons for one in acting)
    return [(match.span("title"),) if named and match is not None else () for match in found]


def leading_tags(text: str) -> list[Span]:
    """Give the stretches of such marks that may say something, and of those behind it.

    >>> leading_tags("!high call the bank at nine #money")
    [(0, 5), (28, 34)]
    """
    front = [found.span("tag") for found in TAG.finditer(text)]
    behind = (ONE_TAG.finditer(text, *tags.span()) for tags in TAGS.finditer(text))
    return front + [found.span() for tags in behind for found in tags]


TYPED = re.compile(r"(?P<before>\w+) (?P<joint>[^\W\d]|\+)(?= (?P<behind>\w+))")
"""A letter alone, or a plus, between two words."""


PLUS = re.compile(r"(?P<unit>[^\W\d]+) (?P<plus>plus)(?= \w)", re.IGNORECASE)
"""What is added to something."""


def without_bullets(text: str) -> str:
    """Give a text of the same length without the bullets of its lines, and other marks that say nothing.

    >>> without_bullets("- tea 5.30"), without_bullets("**Tea** (5.30)")
    ('  tea 5.30', '  Tea    5.30 ')
    """
    for marks in UNSAID:
        spans = [found.span(one) for found in marks.finditer(text) for one in ("open", "close") if found[one]]
        text = blanked(text, spans)
    for found in BEHIND_STRETCH.finditer(text):
        first, end = found.span("mark")
        text = text[:first] + ":".ljust(end - first) + text[end:]
    return text


def with_joints(text: str, lexicon: Lexicon) -> str:
    """Give a text of the same length with "&" for what is typed for "and": "at noon n six", "tue + fri".

    "Print page n", "set n to five" have a name there. So for what is added to a length: "half an hour plus 20
    minutes each way".
    """

    def joined(found: re.Match[str]) -> str:
        named = found["before"].lower() in lexicon.called_by_number or found["behind"].lower() in bound
        joint = found["joint"] in lexicon.beside.typed_joints and not named
        if found["joint"] == "+":
            joint = all(lexicon.means(found[side].lower(), "weekday") for side in ("before", "behind"))
        return f"{found['before']} &" if joint else found[0]

    bound = lexicon.closed.prepositions_of_points | lexicon.closed.present_be | {"to", "of"}

    def added(found: re.Match[str]) -> str:
        timed = lexicon.means(found["unit"].lower(), "unit")
        return f"{found['unit']} and " if timed else found[0]

    return PLUS.sub(added, TYPED.sub(joined, text))


def leading_labels(text: str, lexicon: Lexicon) -> list[Span]:
    """Give the stretches of labels, which say nothing: "reminder: call the bank at nine", "NB it's shut"."""
    labels = [label for label in LABEL.finditer(text) if label["label"].lower() in lexicon.doing.labels]
    labels += _unmarked(lexicon.doing.bare_labels, lexicon.doing.musing).finditer(text)
    return [(label.start("label"), label.end()) for label in labels]


@cache
def _unmarked(labels: frozenset[str], musing: frozenset[str]) -> re.Pattern[str]:
    """Give the pattern of labels with any mark behind them, or none, and of what needs one: "let's see …"."""
    label, thought = (
        "|".join(re.escape(one) for one in sorted(some, key=len, reverse=True)) for some in (labels, musing)
    )
    front = rf"^\s*{BOX}(?:[^\W\d]+,?[ \t]+(?=(?:{thought})\b))?"
    said = rf"(?P<label>(?:{label})(?:\s*{MARK})?|(?:{thought})\s*{MARK})[ \t]+(?=[^\W\d])"
    return re.compile(front + said, re.MULTILINE | re.IGNORECASE)


def remarks_of_tags(text: str, tags: Sequence[Span]) -> Iterator[Remark]:
    """Say that they are not used."""
    for span in tags:
        yield Remark.noted(text, span, NOT_USED)
