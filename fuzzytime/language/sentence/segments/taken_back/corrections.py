"""Taken back: in "at five, no, six" and "in ten minutes, I mean twenty" the later words count."""

from collections.abc import Collection, Iterator, Sequence
from itertools import pairwise

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.language.instruction import Remark, RemarkKind
from fuzzytime.language.meaning.calendar import is_weekday
from fuzzytime.language.meaning.expressions import (
    Duration,
    Phrase,
    Range,
    Repeat,
    Said,
    Time,
    Wall,
)
from fuzzytime.language.meaning.joined.weekdays_left_out import weekdays_in
from fuzzytime.language.sentence.segments.taken_back.new_times import near_old, replaced
from fuzzytime.requirement import Constraint, Unit

PAUSES = frozenset({",", "-", ".", "…", ";", ":"})


def corrected(scanned: Scanned, phrases: Sequence[Phrase]) -> tuple[list[Phrase], list[Remark]]:
    """Replace times that are taken back, and say so."""
    kept: list[Phrase] = []
    remarks: list[Remark] = []
    phrases = _contrasted(scanned, phrases, remarks)
    starts = {phrase.first for phrase in phrases}
    waiting = list(phrases)
    while waiting:
        phrase = waiting.pop(0)
        while (found := _correction(scanned, phrase, starts)) is not None:
            old, new = scanned.text[slice(*phrase.span)], scanned.text[slice(*found.span)]
            taken_back = (phrase.span[0], found.span[0])
            remarks.append(Remark(RemarkKind.CORRECTED, taken_back, f"{old!r} is corrected by {new!r}"))
            waiting = [other for other in waiting if other.first >= found.end]
            phrase = found
        kept.append(phrase)
    return kept, remarks


def _contrasted(scanned: Scanned, phrases: Sequence[Phrase], remarks: list[Remark]) -> list[Phrase]:
    """Leave out times that are denied beside others: "not today but tomorrow"."""
    kept = list(phrases)
    remarks += _numbers_denied(scanned, phrases)
    for old, new in pairwise(phrases):
        if old not in kept:
            # "At noon on saturday and not today but tomorrow": it is taken back already.
            continue
        denied = _denied(scanned, old)
        if denied is not None:
            kept.remove(old)
            remarks.append(denied)
            continue
        before = scanned.words[old.first - 1].text if old.first else ""
        between = [word.text for word in scanned.words[old.end : new.first]]
        if between == ["than"] and any(word.text == "rather" for word in scanned.words[: old.first]):
            # "I'd rather go on thursday than friday"
            between = ["rather", "than"]
        if between == ["instead"] and scanned.words[new.first].text == "of":
            between = ["instead", "of"]
        if "not" in between and _lies_in(new.said.time, old.said.time):
            # "Tomorrow, not at noon"
            continue
        if "not" in between and _is_length(old.said) is not _is_length(new.said):
            # "For an hour, not at noon": how long, and when not.
            continue
        if _takes_back(between, scanned.lexicon):
            # "On monday, not tuesday"; but "tomorrow, not before ten" is one time.
            kept.remove(new)
            span = (old.span[1], new.span[1])
            message = (
                f"{scanned.text[slice(*new.span)]!r} is taken back beside {scanned.text[slice(*old.span)]!r}"
            )
            remarks.append(Remark(RemarkKind.CORRECTED, span, message))
        elif before == "not" and between in (["but"], [",", "but"], [","], ["-"]):
            kept.remove(old)
            span = (scanned.words[old.first - 1].start, new.span[0])
            said = scanned.text[slice(*new.span)]
            message = f"{scanned.text[slice(*old.span)]!r} is corrected by {said!r}"
            remarks.append(Remark(RemarkKind.CORRECTED, span, message))
    return kept


def _lies_in(inner: Time | Duration | Repeat, outer: Time | Duration | Repeat) -> bool:
    """Whether a time is in another, so that it is left out of that: noon in tomorrow, friday in next week."""
    if not isinstance(inner, Wall) or not isinstance(outer, Wall) or outer.clock is not None:
        return False
    if inner.days is None:
        return inner.clock is not None or outer.part is None
    longer = outer.days is not None and outer.days.grain is not Unit.DAY
    return longer and is_weekday(inner.days)


def _is_length(said: Said) -> bool:
    """Whether it says how long, and not when."""
    return said.constraint is Constraint.FOR or isinstance(said.time, Duration)


def _takes_back(between: Sequence[str], lexicon: Lexicon) -> bool:
    """Whether words between two times deny the second: "at six instead of at seven"."""
    joint = (text for text in between if text not in lexicon.closed.joints_of_things)
    return " ".join(joint) in lexicon.beside.in_place_of


def _numbers_denied(scanned: Scanned, phrases: Sequence[Phrase]) -> Iterator[Remark]:
    """Give what to say of a number alone that is denied behind a time: "at four, not three"."""
    texts, starts = [word.text for word in scanned.words], {phrase.first for phrase in phrases}
    for phrase in phrases:
        place = phrase.end + 2
        clock = phrase.said.wall.clock
        denied = " ".join(texts[phrase.end : place]).removeprefix(", ") in scanned.lexicon.beside.in_place_of
        if not denied or place in starts:
            continue
        alone = place < len(texts) and texts[place + 1 : place + 2] in ([], [","], ["."], ["!"], ["?"])
        # "At seven, not before"
        side = place < len(texts) and texts[place] in scanned.lexicon.closed.adverbs_of_order
        if alone and (side or (clock is not None and "integer" in scanned.cells[place])):
            span = (scanned.words[phrase.end].start, scanned.words[place].end)
            message = f"{texts[place]!r} is taken back beside {scanned.text[slice(*phrase.span)]!r}"
            yield Remark(RemarkKind.CORRECTED, span, message)


def _denied(scanned: Scanned, phrase: Phrase) -> Remark | None:
    """Give what to say of a time that is denied alone in front: "not now, …", "rather than at six, …"."""
    texts = [word.text for word in scanned.words]
    # "Instead of today" may have its "of" in the time.
    fronts = {" ".join(texts[: phrase.first + inside]) for inside in (0, 1) if phrase.first}
    led = not fronts.isdisjoint(scanned.lexicon.beside.in_place_of)
    alone = led and texts[phrase.end : phrase.end + 1] in ([","], ["."], [";"])
    if not alone or phrase.end + 1 >= len(texts) or texts[phrase.end + 1] == "but":
        return None
    said = scanned.text[slice(*phrase.span)]
    span = (scanned.words[0].start, scanned.words[phrase.end].end)
    return Remark(RemarkKind.CORRECTED, span, f"{said!r} is not meant: another time follows")


def _correction(scanned: Scanned, phrase: Phrase, starts: Collection[int]) -> Phrase | None:
    """Give the time that replaces a phrase, if words right behind it take it back."""
    lexicon = scanned.lexicon
    place = _behind_pauses(scanned, phrase.end)
    marker = longest_match(scanned.words, place, lexicon.corrections) if place < len(scanned.words) else None
    # "By six, no later than seven": the marker begins a time itself.
    if marker is None or place in starts:
        return None
    start = _behind_pauses(scanned, place + len(marker))
    if start >= len(scanned.words):
        return None
    waits = marker[-1] in lexicon.doing.waiting and start == place + len(marker)
    if waits and "duration" in scanned.cells[start]:
        # "Heat it at eight, wait three minutes"; but "at eight, wait, nine"
        return None
    left_out = {word.text for word in scanned.words[place:start]} <= lexicon.beside.denying_weekdays
    if left_out and isinstance(phrase.said.time, Repeat) and _are_weekdays(scanned, start):
        # "Every day, no sundays"; but "every monday, no, every tuesday"
        return None
    further = longest_match(scanned.words, start, lexicon.corrections)
    if further is not None and "said" not in scanned.cells[start]:
        # "Actually, make it twenty"; but "make that no later than six"
        start = min(_behind_pauses(scanned, start + len(further)), len(scanned.words) - 1)
    start = _behind_who_says(scanned, start)
    lets_be = marker in lexicon.conversation["retracting"]
    cell = scanned.cells[start]
    # "From two to four, no, three to five"
    stretches = ("hours open",) if isinstance(phrase.said.time, Range) else ()
    for category in (*stretches, "said", "wall", "duration", "clock", "quantity"):
        pieces = sorted(cell.get(category, {}).values(), key=lambda piece: -piece.end)
        for piece in pieces:
            if lets_be and not _is_bare(scanned, piece.end):
                # "Call Ann at five. Scratch that. At six call Bob"
                continue
            said = replaced(phrase.said, piece.value)
            if said is not None:
                said = near_old(phrase.said, said, scanned)
                span = (scanned.words[piece.start].start, scanned.words[piece.end - 1].end)
                return Phrase(said, piece.start, piece.end, span, "correction")
    return None


def _are_weekdays(scanned: Scanned, place: int) -> bool:
    """Whether weekdays stand at a place that are repeated: "sundays"."""
    pieces = scanned.cells[place].get("repeat", {}).values()
    return any(weekdays_in(piece.value) for piece in pieces)


def _behind_who_says(scanned: Scanned, place: int) -> int:
    """Give the place behind who says the new time: "at five, no, Jonas said 5:30"."""
    words = scanned.words
    behind = place + 2
    named = (
        words[place].capital
        or words[place].text in scanned.lexicon.closed.personal_pronouns | scanned.lexicon.persons
    )
    says = behind < len(words) and words[place + 1].text in scanned.lexicon.doing.saying
    return behind if named and says else place


def _is_bare(scanned: Scanned, end: int) -> bool:
    """Whether nothing more is said behind a time: "scratch that, tomorrow morning"."""
    return end == len(scanned.words) or scanned.words[end].text in {*PAUSES, "!", "\n"}


def _behind_pauses(scanned: Scanned, place: int) -> int:
    while place < len(scanned.words) and scanned.words[place].text in PAUSES:
        place += 1
    return place
