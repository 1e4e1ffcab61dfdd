"""Words about time that belong to a thing: "the 24-hour shop", "next week's shifts", "10/min"."""

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.judging.look_alikes.proper_names import is_typed_name, is_whom
from fuzzytime.language.grammar.judging.look_alikes.spoken_of import is_converted, is_spoken_of
from fuzzytime.language.grammar.surroundings.surroundings import Surroundings
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.days.relations import CountedDay, Deictic, Relative, Stretch, Which
from fuzzytime.language.meaning.expressions import Offset, Wall
from fuzzytime.language.meaning.units import UnitWord
from fuzzytime.requirement import Unit

MINUTES = 60
"""So many minutes has no clock time: "1:72" is a scale."""

DEICTICS = frozenset(Which)
"""Words before a unit that say which: "next week"."""

ENDS = frozenset({".", ",", "!", "?", ";"})
"""Marks behind which a sentence, or a clause, is over."""

LED = 4
"""Words to the preposition before a day that is described: "on the first dry day"."""


def is_of_thing(piece: Piece, around: Surroundings) -> bool:
    """Whether what looks like a time names a thing, is a part of one, or says whose or which it is."""
    return (
        around.is_object(piece.start)
        or (around.before(piece) in around.closed.to and around.names_place(piece))
        or _is_noun(piece, around)
        or is_of_street(piece, around)
        or is_typed_name(piece, around)
        or is_spoken_of(piece, around)
        or is_whom(piece.start - 1, around)
        or _is_decade(piece, around)
        or _is_title(piece, around)
        or _is_share(piece, around)
        or _is_rate(piece, around)
        or _is_cited(piece, around)
        or _is_compound(piece, around)
        or _is_owner(piece, around)
        or around.has_title(piece.start)
        or around.is_somebody(piece.start)
        or _is_from_the_past(piece, around)
    )


def is_of_street(piece: Piece, around: Surroundings) -> bool:
    """Whether a street is called like it: "12 march road"; but "on 12 march road works begin"."""
    streets = around.lexicon.no_times.streets
    if not around.is_day(piece.end - 1) or around.follower(piece) not in streets:
        return False
    behind = {*around.texts[piece.end + 1 : piece.end + 2]}
    return behind <= around.lexicon.function_words | ENDS or around.timely(piece.end + 1)


def _is_decade(piece: Piece, around: Surroundings) -> bool:
    """Whether its seconds are years: "80s hits", "songs of the 90s", "the over 60s"."""
    number = piece.start - 1
    if around.texts[piece.start : piece.end] != ["s"] or number < 0 or not around.words[piece.start].glued:
        return False
    kinds = around.lexicon.no_times
    *_, before, last = ("", "", *around.texts[:number])
    tens = around.words[number].is_digits and around.texts[number].endswith("0")
    aged = last in kinds.around_ages and before in around.closed.noun_openers
    aged = aged or (tens and last in around.closed.possessives)
    bound = last in around.closed.the and before in kinds.binding_days | {"from"}
    return aged or (tens and (bound or around.follower(piece) in kinds.of_decades))


def _is_cited(piece: Piece, around: Surroundings) -> bool:
    """Whether a typed clock time is a verse, or which of some things is meant: "the 9:15"."""
    led = around.cites(piece.start) or around.before(piece) in around.closed.the
    mixed = not around.beside.mixing.isdisjoint(around.texts[: piece.start])
    # As in "build the model at 1:72".
    minutes = around.texts[piece.end - 1]
    scaled = around.texts[piece.start] == "1" and minutes.isdigit() and int(minutes) >= MINUTES
    return piece.category.startswith("hh") and (led or mixed or scaled)


def _is_rate(piece: Piece, around: Surroundings) -> bool:
    """Whether so much of something is in it: "10/min", "5 ml/min"."""
    stroke = around.texts[piece.start - 1] if piece.start else ""
    return stroke == "/" and around.words[piece.start].glued and around.words[piece.start - 1].glued


def _is_share(piece: Piece, around: Surroundings) -> bool:
    """Whether it is a part of a thing: "three quarters of the flour", "at the end of the film"."""
    unit = piece.value.unit if isinstance(piece.value, UnitWord) else None
    return around.follower(piece) in around.closed.of and (
        unit is Unit.QUARTER or piece.category == "unfinished"
    )


def _is_title(piece: Piece, around: Surroundings) -> bool:
    """Whether it is a part of the day that begins the name of a thing: "Evening tablets at nine".

    So it may behind a mark, where the thing has its own time: "lunch at one, afternoon tea at four".
    """
    named = around.follower(piece)
    bound = around.lexicon.closed.prepositions_of_points.intersection(
        around.texts[piece.end + 1 : piece.end + 2]
    )
    opens = not piece.start or (bool(bound) and around.before(piece) in around.beside.sentence_starts)
    known = named in around.lexicon.function_words or around.timely(piece.end)
    told = named in around.lexicon.beside.saying
    return piece.category == "part" and opens and (told or (named.isalpha() and not known))


def _is_from_the_past(piece: Piece, around: Surroundings) -> bool:
    """Whether it says of which time a thing is that was: "the report of last week", "mail from yesterday"."""
    place = piece.start - (around.before(piece) == "last")
    last = "last" in around.texts[place : piece.end]
    past = last or (isinstance(piece.value, Relative) and piece.value.days < 0)
    return past and around.belongs(place)


def _is_owner(piece: Piece, around: Surroundings) -> bool:
    """Whether a thing is of that time: "next week's shifts", but not "by next week's end"."""
    led = piece.start - (around.before(piece) in DEICTICS)
    leading = around.pieces(led - 1) if led else []
    bound = led > 0 and around.texts[led - 1] in around.closed.prepositions_of_time
    if bound or any(said.category.startswith("preposition") for said in leading):
        return False
    thing = around.texts[piece.end + 1 : piece.end + 2]
    timely = around.timely(piece.end + 1) or not around.lexicon.ordinals.keys().isdisjoint(thing)
    return around.follower(piece) == "'s" and bool(thing) and thing[0].isalpha() and not timely


def _is_compound(piece: Piece, around: Surroundings) -> bool:
    """Whether it is a unit that a hyphen makes an adjective: "the 24-hour shop"."""
    first, before = around.words[piece.start], around.words[piece.start - 1] if piece.start else None
    # Between number words, which "second" may be one of, the hyphen is left out.
    hyphenated = before is not None and first.glued and (before.text == "-" or before.end < first.start)
    joined = around.follower(piece) == "-" or not around.may_end(piece)
    return piece.category == "unit" and hyphenated and joined


def _is_noun(piece: Piece, around: Surroundings) -> bool:
    """Whether it is a unit that is a thing, or a manner: "mark the day", "sort the bills by month"."""
    unit = piece.value.unit if isinstance(piece.value, UnitWord) else None
    if unit and (around.before(piece) == "into" or (around.before(piece) == "in" and unit is Unit.QUARTER)):
        # "Cut it into quarters"
        return True
    if piece.category == "unit" and "by" in around.texts[max(0, piece.start - 3) : piece.start]:
        # "Push the meeting back by half an hour": how much later, and no time.
        return True
    if piece.category == "unit" and is_converted(piece.start, around):
        return True
    verb = around.texts[piece.start - 2] if piece.start > 1 else ""
    if piece.category == "unit" and verb in around.beside.amounts_of_time:
        # "Rewind two minutes"
        return True
    numbered = piece.end < len(around.words) and around.words[piece.end].is_digits
    # "Year 4", "a test for year two"
    called = numbered and around.words[piece.start].capital
    one = around.texts[piece.start] == Unit.YEAR
    called = called or (unit is Unit.YEAR and one and around.is_number(piece.end))
    if piece.category == "unit" and called:
        return True
    before = around.before(piece)
    led = around.texts[max(0, piece.start - LED) : piece.start - 1]
    apart = bool(led) and around.lexicon.no_times.binding_days.isdisjoint(led)
    if piece.category == "unit" and before.isalpha() and (around.texts[piece.start].endswith("s") or apart):
        # "Visiting hours", "it's trash day"; but "on boss day"
        known = before in around.lexicon.function_words or before in around.lexicon.entries
        if not known and before not in around.lexicon.numbers:
            return True
    named = around.before(piece) in around.closed.of_units
    behind = around.texts[piece.start - 2] if piece.start > 1 else ""
    bound = behind in around.lexicon.no_times.binding_days
    return piece.category == "unit" and named and not bound


def is_from_the_past(piece: Piece, around: Surroundings) -> bool:
    """Whether it says of which time a thing is that was: "the report of last week at nine"."""
    days = piece.value.wall.days
    stretch = isinstance(days, Stretch) and days.count < 0
    if stretch and around.follower(piece) in around.closed.of:
        # "Keep the last 3 days of logs"
        return True
    last = isinstance(days, Deictic) and days.which is Which.LAST
    past = last or stretch or (isinstance(days, Relative) and days.days < 0)
    first = piece.start + (around.texts[piece.start] in around.beside.belonging)
    # "Back up files from the | last week"
    first -= around.texts[first - 1 : first] == ["the"]
    *_, led, said = ("", "", *around.texts[: piece.start])
    if said in around.beside.past_deictics and led in around.beside.belonging:
        # "The episode from last | tuesday"
        return True
    return past and around.belongs(first)


def counts_from_thing(piece: Piece, around: Surroundings) -> bool:
    """Whether it counts from one of some things: "sow the second row ten days after the first"."""
    time = piece.value.time
    wall = time.anchor if isinstance(time, Offset) else time
    days = wall.days if isinstance(wall, Wall) and wall.clock is None else None
    days = days.anchor if isinstance(days, CountedDay) else days
    if not isinstance(days, Fields) or days != Fields(day=days.day):
        return False
    ordinal = around.texts[piece.end - 1] in around.lexicon.ordinals
    return ordinal and any(_counts_thing(place, around) for place in range(piece.start))


def _counts_thing(place: int, around: Surroundings) -> bool:
    """Whether an ordinal counts a thing: "the second row"."""
    behind = around.texts[place + 1 : place + 2]
    named = bool(behind) and behind[0].isalpha() and behind[0] not in around.lexicon.function_words
    return around.texts[place] in around.lexicon.ordinals and named and not around.timely(place + 1)
