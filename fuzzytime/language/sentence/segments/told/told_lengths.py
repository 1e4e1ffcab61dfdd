"""Lengths told in words of their own: "ten minutes should do", "allow an hour", "it's 20 minutes away".

They stand beside what they are about, or on a line of their own, and are read as asides are.
"""

from collections.abc import Sequence

from fuzzytime.english import singular
from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.language.grammar.surroundings.looked_up import TIMELY
from fuzzytime.language.grammar.words import is_minute
from fuzzytime.language.meaning.expressions import Duration, Phrase, Said
from fuzzytime.language.meaning.units import UNIT_SECONDS
from fuzzytime.language.sentence.segments.told.asides import Aside
from fuzzytime.requirement import Constraint, Unit

PARTS = frozenset({"part", "meal"})
"""Categories of parts of the day, some of which are places too."""


OWNING = frozenset({"'s", "'"})
"""What makes a length that of what is behind it: "an hour's drive", "40 minutes' drive"."""

BEHIND_THEN = 2
"""Words of "then,"."""

SUBJECT_AND_VERB = 2
"""Words that say what something does."""

RULE = "told"
"""The rule of a length that is told."""

ENDS = frozenset({".", "!", ";"})
"""Marks between sentences."""

MARKS = frozenset({",", "(", ")", "-", ".", ";", ":", "!", "–", "—"})
"""Marks around such words."""


def told_lengths(scanned: Scanned) -> tuple[Aside, ...]:
    """Give the lengths that a text tells in words of their own, in order."""
    found: list[Aside] = []
    telling = _Telling(scanned)
    pieces = sorted(scanned.pieces("duration"), key=lambda piece: (piece.start, -piece.end))
    for piece in pieces:
        aside = telling.aside(piece)
        if aside is not None and not any(aside.span[0] < other.span[1] for other in found):
            found.append(aside)
    return tuple(found)


class _Telling:
    def __init__(self, scanned: Scanned) -> None:
        self.scanned = scanned
        self.lexicon = scanned.lexicon
        self.told = scanned.lexicon.told
        self.texts = [word.text for word in scanned.words]

    def aside(self, piece: Piece) -> Aside | None:
        words, texts = self.scanned.words, self.texts
        if not isinstance(piece.value, Duration) or is_minute(words, piece.start):
            return None
        around = MARKS | self.told["joints"]
        start = piece.start
        while start > 0 and texts[start - 1] not in around:
            start -= 1
        end = piece.end
        while end < len(texts) and texts[end] not in around:
            end += 1
        before, after = texts[start : piece.start], texts[piece.end : end]
        way = self._is_way(before, after, alone=start == 0) or self._leads(before, piece.end, end)
        # "Main act at nine, plays for an hour"
        apart = before[-1:] == ["for"] and self.texts[start - 1] not in self.told["joints"]
        plays = apart and " ".join(before[:-1]) in self.told["going for"]
        goes_on = not after and self._is_begun(start) and (plays or self._goes_on(before))
        behind = not after and before == ["for"] and self._is_behind_then(start, end)
        if not (way or goes_on or behind or self._is_length(before, after)):
            return None
        if end < len(texts) and texts[end] == ")":
            end += 1
        first = words[start - 1 if start > 0 and texts[start - 1] in MARKS - {".", "!"} else start].start
        first = words[start - BEHIND_THEN].start if behind else first
        span = (words[piece.start].start, words[piece.end - 1].end)
        return Aside(
            (first, words[end - 1].end),
            Phrase(Said(piece.value, Constraint.FOR), piece.start, piece.end, span, RULE),
            way=way,
            left=goes_on or self._leaves(before, texts[start - 1] if start else "", piece.value),
        )

    def _leaves(self, before: Sequence[str], joint: str, length: Duration) -> bool:
        """Whether it says how long something is left alone: "paint it and give it an hour", "give it a week".

        "Copy it, give it half an hour" says how long that takes, which is no whole day.
        """
        if " ".join(self._said(before)) not in self.told["leaving"]:
            return False
        return joint == "and" or "then" in before or length.seconds >= UNIT_SECONDS[Unit.DAY]

    def _said(self, before: Sequence[str]) -> list[str]:
        """Give the words before a length that say what it is of."""
        return [word for word in before if word not in self.told["small"]]

    def _is_way(self, before: Sequence[str], after: Sequence[str], *, alone: bool) -> bool:
        """Whether words say how far it is: "it's 20 minutes away", "the drive takes half an hour"."""
        said, told = self._said(before), self.told
        rest = after[1:] if {*after[:1]} & OWNING else after
        goes = (
            rest[:1] == ["away"]
            or " ".join(rest) in told["each way"]
            or (rest[:1] and rest[0] in told["going"])
            or (rest[:1] and rest[0] in told["by"] and told["vehicles"] & set(rest))
        )
        if goes:
            called = not said and not alone
            led = bool(said) and said[0] in told["subjects"] | told["determiners"]
            # "Allow 40 minutes each way"
            allowed = " ".join(said) in told["allowing"]
            return called or allowed or (led and said[-1] in told["being"])
        if len(said) > 1 and said[-1] in told["taking"] and not after:
            # "The drive takes half an hour", "getting there takes ten minutes"
            named = [word for word in said[:-1] if word not in told["there"] | told["determiners"]]
            return len(named) == 1 and named[0] in told["going"]
        to_there = len(after) > 2 and after[0] == "to" and after[-1] in told["there"]
        # "It takes half an hour to get to the scrapyard"
        to_there = to_there or (len(after) > 3 and after[:3] == ["to", "get", "to"])
        # "It takes ten minutes to get there", "it's ten minutes to get there"
        led = bool(said) and said[0] in told["subjects"] and said[-1] in told["taking"] | told["being"]
        return to_there and led

    def _leads(self, before: Sequence[str], place: int, end: int) -> bool:
        """Whether a length is how far a place is: "it's 20 minutes to the shop"; but "… to the meeting"."""
        said, told = self._said(before), self.told
        subject = bool(said) and said[0] in told["subjects"] and said[-1] in told["being"]
        if not subject or place + 1 >= end or self.texts[place] not in told["between"]:
            return False
        named = self.scanned.words[place + 1 : end]
        known = [p for at in range(place + 1, end) for p in self.lexicon.pieces(self.scanned.words, at)]
        places = [piece for piece in known if piece.category in PARTS and piece.value.place]
        timed = any(piece.category in TIMELY and piece not in places for piece in known)
        # "To the market", which is a place as well.
        events = self.lexicon.happening | self.lexicon.taken | self.lexicon.events
        event = named[-1].text in events - self.lexicon.frames
        numbered = any(word.is_digits or word.text in self.lexicon.numbers for word in named)
        led = named[0].capital or named[0].text in told["determiners"] | told["there"]
        return bool(places) or (led and not timed and not numbered and not event)

    def _goes_on(self, before: Sequence[str]) -> bool:
        """Whether words say what a thing does for so long once it is begun: "it bakes for forty minutes"."""
        said = before[:-1] if before[-1:] == ["for"] else before
        if len(said) != SUBJECT_AND_VERB or said[0] not in self.told["subjects"]:
            return False
        lexicon, verb, stem = self.lexicon, said[1], singular(said[1])
        others = lexicon.impersonal.union(
            lexicon.function_words, lexicon.doing.several_timed, lexicon.doing.taking
        )
        cooked = verb in lexicon.timing | lexicon.timing_alone
        return cooked or (stem != verb and others.isdisjoint((stem, verb)))

    def _is_behind_then(self, start: int, end: int) -> bool:
        """Whether one ends in a length behind a "then" that leads nowhere: "at 2 then, for an hour"."""
        led = self.texts[max(0, start - BEHIND_THEN) : start] == ["then", ","] and start > BEHIND_THEN
        joined = led and self.texts[start - BEHIND_THEN - 1] in MARKS | self.told["joints"]
        return led and not joined and (end == len(self.texts) or self.texts[end] in ENDS)

    def _is_begun(self, place: int) -> bool:
        """Whether what stands before a place in its sentence begins with an order, or with a thing."""
        first = next((p + 1 for p in range(place - 2, -1, -1) if self.texts[p] in ENDS), 0)
        said, closed = self.texts[first : place - 1], self.lexicon.closed
        return bool(said) and said[0] not in self.lexicon.function_words - closed.noun_openers

    def _is_length(self, before: Sequence[str], after: Sequence[str]) -> bool:
        """Whether words say how long something takes: "ten minutes should do", "allow an hour for it"."""
        told = self.told
        if not before:
            return len(after) > 1 and after[-1] in told["enough"] and told["helping"].issuperset(after[:-1])
        said = " ".join(self._said(before))
        return said in told["allowing"] and told["for it"].issuperset(after)
