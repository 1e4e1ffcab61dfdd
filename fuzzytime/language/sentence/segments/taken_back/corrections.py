"""Taken back: in "at five, no, six" and "in ten minutes, I mean twenty" the later words count."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.grammar.lexicon import longest_match
from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.language.grammar.understood.lent import is_timed_entry
from fuzzytime.language.instruction import Remark, RemarkKind
from fuzzytime.language.meaning.calendar import is_weekday
from fuzzytime.language.meaning.expressions import (
    Duration,
    HourMark,
    Offset,
    Phrase,
    Quantity,
    Range,
    Repeat,
    Said,
    Time,
    Wall,
)
from fuzzytime.language.meaning.joined.beside import in_hour_of
from fuzzytime.language.meaning.joined.weekdays_left_out import weekdays_in
from fuzzytime.language.meaning.times_of_day import Clock, Half
from fuzzytime.requirement import MOMENTS, Constraint, Unit

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
        if between == ["instead"] and scanned.words[new.first].text == "of":
            between = ["instead", "of"]
        if "not" in between and _lies_in(new.said.time, old.said.time):
            # "Tomorrow, not at noon"
            continue
        if "not" in between and _is_length(old.said) is not _is_length(new.said):
            # "For an hour, not at noon": how long, and when not.
            continue
        if _takes_back(between):
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


def _takes_back(between: Sequence[str]) -> bool:
    """Whether words between two times deny the second: "at six instead of at seven"."""
    joint = [text for text in between if text not in {",", "and"}]
    return joint in (["not"], ["instead", "of"], ["rather", "than"])


def _numbers_denied(scanned: Scanned, phrases: Sequence[Phrase]) -> Iterator[Remark]:
    """Give what to say of a number alone that is denied behind a time: "at four, not three"."""
    texts, starts = [word.text for word in scanned.words], {phrase.first for phrase in phrases}
    for phrase in phrases:
        place = phrase.end + 2
        clock = phrase.said.wall.clock
        denied = texts[phrase.end : place] in ([",", "not"], ["instead", "of"], ["rather", "than"])
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
    led = texts[: phrase.first] in (["not"], ["rather", "than"], ["instead", "of"])
    led = led or texts[: phrase.first + 1] == ["instead", "of"]
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
    if waits and ("duration" in scanned.cells[start] or _is_timed(scanned, start)):
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
            said = _replaced(phrase.said, piece.value)
            if said is not None:
                said = _near_old(phrase.said, said, scanned)
                span = (scanned.words[piece.start].start, scanned.words[piece.end - 1].end)
                return Phrase(said, piece.start, piece.end, span, "correction")
    return None


def _is_timed(scanned: Scanned, place: int) -> bool:
    """Whether a number is how many minutes are waited in a list: "stir 3, wait 10, stir 3"."""
    texts = [word.text for word in scanned.words]
    return is_timed_entry(texts, place, place + 1, scanned.lexicon)


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


def _replaced(old: Said, new: object) -> Said | None:
    """Give what was said with a new time in it: bound as before, where the new words do not bind anew."""
    if isinstance(new, Said) and isinstance(new.time, HourMark) and isinstance(old.time, Wall):
        # "At five, or rather half past"
        whole = in_hour_of(new.time, old.time)
        new = (
            new if whole is None else replace(new, time=whole, preposition=new.preposition or old.preposition)
        )
    if isinstance(new, Said):
        bare = isinstance(new.time, Duration) or (isinstance(new.time, Wall) and new.time.bare)
        counted = isinstance(old.time, (Duration, Offset)) and isinstance(new.time, Wall) and new.time.clock
        if bare and counted:
            # "Within ten minutes, no, within twenty"
            return _counted(old, Quantity(counted.hour))
        if new.preposition is None and bare:
            return _replaced(old, new.time)
        if isinstance(new.time, Wall) and new.time == Wall(clock=new.time.clock):
            # "On monday at nine, no, at six"
            placed = _replaced(old, new.time)
            new = new if placed is None else replace(new, time=placed.time)
        alike = type(old.time) is type(new.time) and new.constraint in MOMENTS
        # "After lunch, actually next week" is no bound.
        alike = alike and (old.wall.clock is None) == (new.wall.clock is None)
        alike = alike and (old.wall.days is None) == (new.wall.days is None)
        # "By five pm, no, six pm"
        return replace(old, time=new.time, hedges=new.hedges) if alike and not new.preposition else new
    if isinstance(new, Wall) and isinstance(old.time, Wall):
        clock = new.clock
        if clock is not None and old.time.clock is not None:
            return replace(
                old,
                time=replace(old.time, clock=_in_half(clock, old.time.clock), part=new.part or old.time.part),
            )
        return replace(old, time=new)
    if isinstance(new, Duration):
        if isinstance(old.time, Repeat) and isinstance(old.time.every, Duration):
            return replace(old, time=replace(old.time, every=new))
        return replace(old, time=new) if isinstance(old.time, Duration) else None
    if isinstance(new, Clock):
        return _replaced(old, Wall(clock=new)) if old.wall.clock is not None else None
    if isinstance(new, Quantity) and not new.indefinite:
        return _counted(old, new)
    return None


def _near_old(old: Said, new: Said, scanned: Scanned) -> Said:
    """Give a new hour of a named day in the half nearer to the old one: "tomorrow at five, no, six".

    What is done at usual hours is so then: "wake me tomorrow at five, no, six".
    """
    lexicon, words = scanned.lexicon, scanned.words
    first, second = old.wall.clock, new.wall.clock
    if old.wall.days is None or first is None or second is None or not isinstance(new.time, Wall):
        return new
    if old.wall.part is not None or new.time.part is not None:
        return new
    usual = any(longest_match(words, place, lexicon.usual_hours) for place in range(len(words)))
    if usual or not first.is_open or not second.is_open:
        return new
    hour = first.first_from(lexicon.policy.ahead_from)
    halves = (replace(second, half=half) for half in (Half.AM, Half.PM))
    nearest = min(halves, key=lambda clock: abs(clock.candidates()[0] - hour))
    return replace(new, time=replace(new.time, clock=nearest))


def _counted(old: Said, new: Quantity) -> Said | None:
    """Give another number of the same unit."""
    time = old.time.every if isinstance(old.time, Repeat) else old.time
    time = time.duration if isinstance(time, Offset) else time
    if not isinstance(time, Duration) or len(time.terms) != 1:
        return None
    duration = replace(time, terms=((new.value, time.terms[0][1]),), until=None)
    return _replaced(old, duration)


def _in_half(clock: Clock, old: Clock) -> Clock:
    return (
        replace(clock, half=old.half, bare=False)
        if clock.is_open and old.half is not None
        else replace(clock, bare=False)
    )
