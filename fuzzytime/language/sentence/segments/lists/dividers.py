"""Marks between the entries of a line, each with its time: "10am vet - 12 lunch - 3pm pick up car".

A dash between two times is a stretch from the one to the other; one that has a thing and its time on either
side tells two entries apart. So do bars, arrows, slashes and wide gaps; a bullet does without times, too.
"""

import re
from collections.abc import Sequence
from itertools import pairwise

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.grammar.understood.lists import closed_lists
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Span
from fuzzytime.language.sentence.segments.lists.chains import chained
from fuzzytime.language.sentence.segments.lists.entries import Entry, is_when, names_day
from fuzzytime.language.sentence.segments.lists.heads import headed
from fuzzytime.language.sentence.segments.orders_beside_times import asks_for_deed

BULLET = re.compile(r"(?:(?<=\s)|^)[•●▪‣◦·]\s*(?=\w)")
"""A mark that stands in front of an entry, and nowhere else."""

MARKS = (
    re.compile(r"(?<=\s)(?:-+>|=+>|[→⇒➔➜])(?=\s)"),
    re.compile(r"(?<=\s)\|{1,2}(?=\s)"),
    re.compile(r"(?<=\s)/{1,2}(?=\s)"),
    re.compile(r"(?<=\s)>(?=\s)"),
    re.compile(r"(?<=\s)[+*](?=\s)"),
    re.compile(r"(?<=\s)[-–—]{1,2}(?=\s)"),
    re.compile(r"(?<=\S)(?:[ \t]{2,}|\t)(?=\S)"),
)
"""Marks that stand between entries, and elsewhere: of each kind those of a line are judged together."""

LINE = re.compile(r"[^\n;]+")
"""What such marks divide: a line, or what stands in it before a stop."""

COMMA = re.compile(r",(?=\s|[^\W\d])")

COLON = re.compile(r"(?:(?<!\d)(?<!\d\s):(?=\s+\d)|:(?=\s+[^\W\d]))")
"""A mark between a time in front of an entry and what is then: "mon: gym"."""

PAIR, LIST = 2, 3
"""Two entries, and those of a list at least in which a number alone may be when."""

DAY_AND_THING = 2
"""Words of an entry that says no more than what is when."""

LONGEST_TIME = 8
"""Words of a time that heads an entry at most."""

LOOKED_AT = 40
"""Characters behind a colon that may go on with the time before it."""

STOP = ";"
"""What stands between two entries in place of such a mark."""

BRACKETS = (("(", ")"), ("[", "]"))
"""Marks that open, and that close."""


def divided(text: str, grammar: Grammar, lexicon: Lexicon, *, listed: bool = False) -> str:
    """Give a text of the same length with a stop in place of each mark between entries.

    It may be one of the lines that together are ``listed`` with their times.
    """
    for line in LINE.finditer(text):
        bullets = _found(BULLET, text, line)
        if bullets and _is_bulleted(_between(text, line, bullets), grammar, lexicon):
            text = _with_stops(text, bullets)
        commas = _found(COMMA, text, line)
        items = _between(text, line, commas)
        told = bool(commas) and any(told(items, grammar, lexicon) for told in BY_COMMAS)
        if told and not _are_of_times(commas, line, grammar, lexicon):
            text = _with_stops(text, commas)
        elif commas and listed and any(map(str.isdigit, items[0])):
            starts = _timed_items(items, grammar, lexicon)
            text = _with_stops(text, [comma for place, comma in enumerate(commas, 1) if place in starts])
        joints = [(line.start() + a, line.start() + b) for a, b in chained(line[0], grammar, lexicon)]
        text = _with_stops(text, joints)
        for kind in MARKS:
            marks = _found(kind, text, line)
            items = _between(text, line, marks)
            if marks and (_divide(items, grammar, lexicon) or _adds_order(items, grammar, lexicon)):
                text = _with_stops(text, marks)
    for line in LINE.finditer(text):
        colon = COLON.search(text, *line.span())
        if colon is None or not _is_dated(text[line.start() : colon.start()], grammar, lexicon):
            continue
        without = text[: colon.start()] + " " + text[colon.end() :]
        read = without[line.start() : min(line.end(), colon.end() + LOOKED_AT)]
        if _ends_still(read, colon.start() - line.start(), grammar, lexicon):
            text = without
    return text


def _found(mark: re.Pattern[str], text: str, line: re.Match[str]) -> list[Span]:
    """Give where marks of a kind stand in a line."""
    return [found.span() for found in mark.finditer(text, *line.span())]


def _with_stops(text: str, marks: Sequence[Span]) -> str:
    """Give a text with stops in place of marks; what begins it needs none."""
    for first, end in marks:
        stop = STOP if text[:first].strip() else " "
        text = text[:first] + stop.ljust(end - first) + text[end:]
    return text


def _between(text: str, line: re.Match[str], marks: Sequence[Span]) -> list[str]:
    """Give the texts of a line around its marks."""
    begins = [line.start(), *(end for _, end in marks)]
    ends = [*(first for first, _ in marks), line.end()]
    return [text[begin:end] for begin, end in zip(begins, ends, strict=True)]


def _is_bulleted(items: Sequence[str], grammar: Grammar, lexicon: Lexicon) -> bool:
    """Whether each bullet of a line stands before something."""
    return all(Entry.of(item, grammar, lexicon).things for item in items if item.strip())


def _are_of_times(commas: Sequence[Span], line: re.Match[str], grammar: Grammar, lexicon: Lexicon) -> bool:
    """Whether one of some commas joins times of one thing: "let the dog out at one, three and at six"."""
    scanned = Scanned.of(line[0], grammar, lexicon)
    lists = closed_lists(phrases_of(scanned), scanned.words, lexicon)
    starts = {start - line.start() for start, _ in commas}
    return any(not starts.isdisjoint(range(*times.further)) for times in lists)


def _divide(items: Sequence[str], grammar: Grammar, lexicon: Lexicon) -> bool:
    """Whether marks of one kind stand between entries: each side names something, and when."""
    if not all(any(map(str.isalnum, item)) and _is_whole(item) for item in items):
        return False
    entries = [Entry.of(item, grammar, lexicon) for item in items]
    if not all(entry.things and entry.timed(listed=len(entries) >= LIST) for entry in entries):
        return False
    if any(before.ends and behind.begins for before, behind in pairwise(entries)):
        # "Gym tue 9 - 10 at the club"
        return False
    if any(entry.goes_on for entry in entries[1:]):
        return False
    alike = all(entry.begins for entry in entries) or all(entry.ends for entry in entries)
    return alike or len(entries) >= LIST


def _adds_order(items: Sequence[str], grammar: Grammar, lexicon: Lexicon) -> bool:
    """Whether one mark stands between what is at a time, and an order: "9.30 tea - bring mugs".

    The order may have its time: "2pm dentist - leave at 1:30".
    """
    if len(items) != PAIR or not asks_for_deed(words_of(items[1]), lexicon):
        return False
    first, second = (Entry.of(item, grammar, lexicon) for item in items)
    apart = not second.times or (second.clocked and second.opens)
    # "Gym at 6 - pack bag"; but "call mum at six - ask about sunday"
    named = first.begins or (first.ends and not asks_for_deed(first.words, lexicon))
    return bool(first.times and first.named) and named and apart


def _head_entries(items: Sequence[str], grammar: Grammar, lexicon: Lexicon) -> bool:
    """Whether commas stand between entries headed by days: "mon: gym, tue: swim", "mon gym, tue swim".

    So do parts of a day: "evening walk, lunchtime yoga". Without a colon, each names one thing: what is done
    with several, on a day each, may be said once.
    """
    entries = []
    for item in items:
        time, colon, said = item.partition(":")
        if colon and said[:1].isspace():
            heads = _is_time(time, grammar, lexicon) or time.strip().lower() in lexicon.beside.of_hours
            if not heads or not any(map(str.isalnum, said)):
                return False
            entries.append(True)
        else:
            words = words_of(item)
            alone = len(words) == DAY_AND_THING and all(word.is_letters for word in words)
            days = [lexicon.means(word.text, "weekday", "day", "part", "meal") for word in words]
            if not alone or days != [True, False]:
                return False
            entries.append(False)
    return all(entries) or not any(entries)


def _each_is_timed(items: Sequence[str], grammar: Grammar, lexicon: Lexicon) -> bool:
    """Whether commas stand between things that each have a clock time: "obs 8:00, meds 8:30".

    The first is one word, so that nothing is done with it that may be done with the others, too.
    """
    first = Entry.of(items[0], grammar, lexicon)
    # Most lines are no such list, and to read the others costs time.
    others = (Entry.of(item, grammar, lexicon) for item in items[1:])
    if first.times and first.begins_with_stretch:
        # So is what has its hour behind it: "9-12 sale, swap the helpers at 10:30".
        return all(one.begins_with_stretch or (one.named and one.ends_timed and one.opens) for one in others)
    # "Croissants out at 6, baguettes at 7"
    named = [p for p in first.named if not p or first.words[p].text not in lexicon.beside.states]
    # "Remind me thursday, july 9 to call mum" is no thing with its time.
    asked = not lexicon.closed.object_pronouns.isdisjoint(word.text for word in first.words)
    if len(named) != 1 or asked or not (first.clocked or first.bounded):
        return False
    if first.bounded:
        # "Bake by noon, party at three": what is due, and what happens.
        return all((entry.clocked or entry.bounded) and entry.has_time and entry.opens for entry in others)
    # Of starters at 16:15, mains come "40 minutes later"; of a desk at 8:00, coffee "from 8:15".
    return all(
        ((entry.clocked or entry.bounded) and entry.named and entry.opens) or entry.counted
        for entry in others
    )


def _timed_items(items: Sequence[str], grammar: Grammar, lexicon: Lexicon) -> set[int]:
    """Give which texts around commas are things that end in their time: "tenors from 2, altos 3.15, 20 min".

    The first has a time, too, may have a label, and is nothing to do that may be done with the others.
    """
    label, colon, said = items[0].partition(": ")
    first, *others = (Entry.of(one, grammar, lexicon) for one in (said if colon else label, *items[1:]))
    doing = lexicon.doing
    verbs = lexicon.orders.union(lexicon.addressing, lexicon.circling)
    verbs = verbs.union(doing.errands, doing.putting, doing.several_timed, doing.shutting)
    ordered = bool(first.words) and first.words[0].text in verbs and len(first.named) > 1
    # "Coach leaves at 8, arrives 9.30"
    goes_on = any(one.words and one.words[0].text in doing.timed for one in others)
    if ordered or goes_on or not first.ends_timed:
        return set()
    timed = {place for place, one in enumerate(others, 1) if one.ends_timed}
    # "Party of 14 at 7.30, canapes ten minutes after they sit down"
    named = others[0].named[:1] == (0,)
    apart = named and (others[0].words[0].text in verbs | lexicon.letting or others[0].bound)
    # "Dentist 9.20, don't be late"
    joined = tuple(negator for negator in lexicon.closed.negators if not negator.isalpha())
    denied = any(word.text.endswith(joined) for word in others[0].words[:1])
    return timed | {1} if apart or denied else timed


BY_COMMAS = (_head_entries, headed, _each_is_timed)
"""Lists whose entries commas tell apart."""


def _is_time(text: str, grammar: Grammar, lexicon: Lexicon) -> bool:
    """Whether a text is a day or a time of day and nothing else."""
    words = words_of(text)
    if len(words) == 1 and names_day(words[0], lexicon):
        return True
    if not words or len(words) > LONGEST_TIME:
        return False
    scanned = Scanned.of(text, grammar, lexicon)
    found = [phrase for phrase in phrases_of(scanned) if is_when(phrase)]
    return [(phrase.first, phrase.end) for phrase in found] == [(0, len(scanned.words))]


def _is_dated(text: str, grammar: Grammar, lexicon: Lexicon) -> bool:
    """Whether a time is more than a part of the day, which is a time by the colon: "morning: laundry"."""
    return _is_time(text, grammar, lexicon) and not lexicon.means(text.strip(" -*").lower(), "part")


def _ends_still(line: str, end: int, grammar: Grammar, lexicon: Lexicon) -> bool:
    """Whether a time ends where it did, without the colon: "mon gym", but "twice 10 minutes"."""
    if not line[end - 1].isalnum():
        return False
    scanned = Scanned.of(line, grammar, lexicon)
    length = sum(1 for word in scanned.words if word.start < end)
    found = phrases_of(scanned)
    numbered = line[end:].strip()[:1].isdigit()
    heads = any(
        phrase.first == 0 and (phrase.end == length or (numbered and phrase.end > length)) for phrase in found
    )
    return heads and (numbered or not any(phrase.first == length for phrase in found))


def _is_whole(item: str) -> bool:
    """Whether no bracket and no mark of a quotation is open in an entry."""
    return item.count('"') % 2 == 0 and all(item.count(a) == item.count(b) for a, b in BRACKETS)
