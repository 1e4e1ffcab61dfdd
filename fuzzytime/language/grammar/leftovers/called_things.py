"""Words about time that what they are in is called by: a song, an evening, the 10 minute rice."""

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.surroundings.surroundings import Surroundings
from fuzzytime.language.meaning.expressions import UnitWord


def is_played(start: int, around: Surroundings) -> bool:
    """Whether a word is of the title of what is played: "play yesterday by the beatles", "Play Sunday Rain".

    That is the time words right behind the verb, or words with capitals.
    """
    verb = next((place for place in range(start) if around.plays(place)), start)
    title = range(verb + 1, start + 1)
    capital = all(around.words[p].capital or around.texts[p] in around.closed.articles for p in title)
    timely = all(around.timely(p) or around.is_counting(p) for p in title)
    return verb < start and (capital or timely)


def says_which(piece: Piece, around: Surroundings) -> bool:
    """Whether a length says which thing it is: "the 10 minute rice"; but "boil a ten minute egg" may last."""
    unit = isinstance(piece.value, UnitWord) and not around.texts[piece.start].endswith("s")
    thing = around.follower(piece)
    named = thing.isalpha() and thing not in around.lexicon.function_words and not around.timely(piece.end)
    counted = piece.start > 1 and around.is_counting(piece.start - 1)
    led = around.texts[piece.start - 2] if counted else ""
    known = led in around.closed.sure_noun_openers - around.closed.indefinite_determiners
    # "The cheddar, aged twelve months"
    return counted and ((unit and named and known) or led == "aged")


def is_event(piece: Piece, around: Surroundings) -> bool:
    """Whether it ends what happens, or a greeting, or gets a time: "parents evening", "set bedtime for 8"."""
    given = around.before(piece) in around.lexicon.moving | around.lexicon.appointing
    return around.ends_name(piece.start) or (given and piece.category == "part")


def says_of_thing(piece: Piece, around: Surroundings) -> bool:
    """Whether a unit says what a thing is like: "a 24 hour pharmacy", "the soup of the day"."""
    if piece.category != "unit" or piece.end - piece.start > 1:
        return False
    if around.belongs(piece.start - 1):
        return around.texts[piece.start - 1] == "the" and around.may_end(piece)
    before, unit, thing = around.before(piece), around.texts[piece.start], around.follower(piece)
    counted = before.isdigit() or before in around.lexicon.numbers
    single = isinstance(piece.value, UnitWord) and unit == piece.value.unit.value
    known = thing in around.lexicon.function_words or around.timely(piece.end)
    # "Boil a ten minute egg" may say how long.
    lasts = not around.lexicon.timing.isdisjoint(around.texts[: piece.start])
    # "In 2 ten minute blocks"
    several = piece.start > 1 and around.is_counting(piece.start - 2)
    return counted and single and thing.isalpha() and not (known or lasts or several)
