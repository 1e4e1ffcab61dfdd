"""Days of which nobody knows when they are: "on orthodox easter", "on his birthday", "at the usual time"."""

from collections.abc import Iterator

from fuzzytime.language.grammar.spans import Scanned

LONGEST_WEEKEND = 6
"""Words from such a preposition to the weekend at most: "over the early may bank holiday weekend"."""

SHORTEST_MOMENT, LONGEST_MOMENT = 3, 4
"""Words from a preposition to the time that is described, at least and at most: "at the same old time"."""

DAY = "day"
"""What words of days end in: "holidays", "match days", "birthday"."""

DAYS = frozenset({"weekday", "day"})
"""What names a day."""


def unknown_days(scanned: Scanned, known: frozenset[int]) -> Iterator[int]:
    """Give the places of words of such days that were not understood."""
    for kind in (_weekends, _other_feasts, _dates, _moments, _untold, _left_out, _owning):
        yield from kind(scanned, known)


def _weekends(scanned: Scanned, known: frozenset[int]) -> Iterator[int]:
    """Give the places of weekends that are not known: "over the bank holiday weekend"."""
    around = scanned.around
    binding, openers = around.beside.before_weekends, around.closed.noun_openers
    for place, word in enumerate(scanned.words):
        if word.text != "weekend" or place in known:
            continue
        near = range(place - 2, max(-1, place - LONGEST_WEEKEND), -1)
        led = next((p for p in near if around.texts[p] in binding and around.texts[p + 1] in openers), None)
        if led is not None:
            yield from range(led + 2, place + 1)


def _other_feasts(scanned: Scanned, known: frozenset[int]) -> Iterator[int]:
    """Give the places of feasts of calendars that are not known: "on orthodox easter"."""
    around = scanned.around
    for piece in scanned.pieces("feast"):
        other = around.before(piece) in around.lexicon.other_calendars
        if other and around.may_end(piece) and piece.start not in known:
            yield from range(piece.start - 1, piece.end)


def _dates(scanned: Scanned, known: frozenset[int]) -> Iterator[int]:
    """Give the places of dates of what a thing is then: "a flight for the ninth returning the sixteenth"."""
    around = scanned.around
    for place in range(1, len(scanned.words) - 1):
        word = scanned.words[place + 1]
        ends = around.texts[place + 2 : place + 3]
        typed = word.is_digits and not around.beside.ordinal_endings.isdisjoint(ends)
        led = around.texts[place] == "the" and around.texts[place - 1] in around.beside.dated
        behind = around.texts[place + 2 + typed : place + 3 + typed]
        named = any(text.isalpha() and text not in around.lexicon.function_words for text in behind)
        if led and place + 1 not in known and not named and (typed or word.text in around.lexicon.ordinals):
            yield from range(place, place + 2 + typed)


def _moments(scanned: Scanned, known: frozenset[int]) -> Iterator[int]:
    """Give the places of a time of which it is not known when that is: "at the usual time", "in between"."""
    around = scanned.around
    closed = around.closed
    for place, word in enumerate(scanned.words):
        if around.texts[max(0, place - 1) : place + 1] == ["in", "between"] and place not in known:
            # But "put the notes in between the pages"
            alone = not any(map(str.isalnum, around.texts[place + 1 : place + 2]))
            yield from (place - 1, place) if alone else ()
        if word.text not in closed.named_moments or place in known:
            continue
        for led in range(place - SHORTEST_MOMENT, max(-1, place - LONGEST_MOMENT - 1), -1):
            described = around.texts[led + 1] in closed.noun_openers
            binds = around.texts[led] in closed.prepositions_of_points | closed.prepositions_of_time
            if binds and described and all(text.isalpha() for text in around.texts[led:place]):
                yield from range(led, place + 1)
                break


def _untold(scanned: Scanned, known: frozenset[int]) -> Iterator[int]:
    """Give the places of days of which nobody said when they are: "on his birthday", "over half term"."""
    around = scanned.around
    beside, texts = around.beside, around.texts
    binding = beside.before_weekends - around.closed.prepositions_of_recipients | {"in"}
    for place, word in enumerate(scanned.words):
        first = place - (" ".join(texts[max(0, place - 1) : place + 1]) in beside.untold_days)
        untold = " ".join(texts[first : place + 1]) in beside.untold_days
        untold = untold or (word.text.endswith(DAY) and not any(around.pieces(place)))
        if not untold or place in known:
            continue
        if first and word.text.endswith("s") and "quantity" in scanned.cells[first - 1]:
            # "Call mum within 8 weekends"
            yield from range(first - 1, place + 1)
        near = range(first - 1, max(-1, first - LONGEST_MOMENT), -1)
        led = next((p for p in near if texts[p] in binding), -1)
        behind = "".join(texts[place + 1 : place + 2])
        more = behind.isalpha() and behind not in around.lexicon.function_words
        if led < 0 or (more and not around.opens(led)) or (led == first - 1 and word.text == "holiday"):
            # "Write it on my birthday card"; "book a week on holiday"
            continue
        if led == first - 1 or texts[led + 1] in around.closed.noun_openers:
            yield from range(led, place + 1)


def _left_out(scanned: Scanned, known: frozenset[int]) -> Iterator[int]:
    """Give the places of days that are left out of others, and not known: "every weekday except holidays"."""
    around = scanned.around
    texts, beside, joints = around.texts, around.beside, around.closed.coordinators
    for place in range(1, len(texts)):
        denied = texts[place - 1] in beside.denying_times and texts[place] == "on"
        if place in known or not (denied or texts[place] in beside.leaving_out):
            continue
        led = place - 1 - denied
        while led > 0 and texts[led] in beside.around_denials | {","}:
            led -= 1
        first = last = place + 1 + (texts[place + 1 : place + 2] == ["for"])
        while last < len(texts) and texts[last][:1].isalpha() and texts[last] not in joints:
            last += 1
        timed = led in known and known.isdisjoint(range(first, last))
        if first < last and timed and texts[last - 1].removesuffix("s").endswith(DAY):
            yield from range(first, last)


def _owning(scanned: Scanned, known: frozenset[int]) -> Iterator[int]:
    """Give the places of days that own what is meant: "at sunday's match", "by friday's post"."""
    around = scanned.around
    closed, lexicon, texts = around.closed, around.lexicon, around.texts
    for place in range(1, len(texts) - 1):
        day = texts[place].removesuffix("'s")
        if day == texts[place] or place in known:
            continue
        binds = texts[place - 1] in closed.prepositions_of_points | closed.prepositions_of_times_taken
        named = any(
            entry.words == (day,) and entry.category in DAYS for entry in lexicon.entries.get(day, ())
        )
        # "Before tuesday's class" is a clause, and so is "by saturday's game".
        happens = texts[place + 1] in lexicon.happening
        clause = (texts[place - 1] == "by" and happens) or (texts[place - 1],) in lexicon.clauses
        # "Wrap it in today's paper"
        binds = binds and (happens or texts[place - 1] not in {"in", "with"})
        if binds and named and not clause:
            yield from range(place - 1, place + 2)
