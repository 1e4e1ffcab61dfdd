"""Words about time that are spoken of as words: "the word february", "what does noon mean"."""

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.surroundings.surroundings import Surroundings
from fuzzytime.language.meaning.expressions import Said, Wall

FAR = 4
"""Words of a question before the word that is asked about, at most."""

FARTHEST = 6
"""Words from a verb of speaking to what is spoken of, at most: "ring the vet at six about monday"."""

LONGEST_HAVING = 3
"""Words of what has units of time, with its preposition: "of the week"."""


def is_spoken_of(piece: Piece, around: Surroundings) -> bool:
    """Whether a word about time is one that is spoken of, or what has so many units of time."""
    return (
        _is_spelt(piece, around)
        or _is_topic(piece, around)
        or _is_called(piece, around)
        or _is_translated(piece, around)
        or _has_meaning(piece, around)
        or _is_said_how(piece, around)
        or _has_units(piece, around)
        or _is_reckoned(piece, around)
    )


def _is_spelt(piece: Piece, around: Surroundings) -> bool:
    """Whether it is spelt or defined: "spell Wednesday", "define the word noon"."""
    kinds, verb = around.lexicon.no_times, piece.start - 1
    if verb > 1 and around.texts[verb] in kinds.words:
        verb -= 2 if around.texts[verb - 1] in around.closed.articles else 1
    # "Write the word noon"; but "write tomorrow", "say the word tomorrow"
    written = verb < piece.start - 1 and not around.is_day_from_now(piece.start)
    verbs = kinds.spelling | (kinds.writing if written else frozenset())
    return verb >= 0 and around.texts[verb] in verbs and around.opens(verb)


def _is_topic(piece: Piece, around: Surroundings) -> bool:
    """Whether it is what is spoken of: "ask Ann about friday", "a story of midnight"."""
    kinds, texts = around.lexicon.no_times, around.texts
    joint = piece.start - (texts[piece.start] not in kinds.topical)
    if joint < 1 or texts[joint] not in kinds.topical:
        return False
    if texts[joint - 1] in kinds.works:
        return True
    wall = piece.value.wall if isinstance(piece.value, Said) else Wall()
    clocked, dated = wall.clock is not None, wall.days is not None
    verbs = kinds.speaking | (kinds.sending if dated and texts[joint] == "about" else frozenset())
    first = next((p for p in range(joint - 1, max(-1, joint - FARTHEST - 1), -1) if texts[p] in verbs), None)
    if first is None or clocked or not (around.opens(first) or texts[first - 1] in around.closed.to):
        return False
    # "Ring mum tonight about sunday", "talk to Ann about friday"; but "ask Ann to come about friday"
    parting = around.closed.coordinators | {"to"}
    between = texts[first + 1 + (texts[first + 1] in around.closed.to) : joint]
    return parting.isdisjoint(between) and all(text.isalpha() for text in between)


def _is_called(piece: Piece, around: Surroundings) -> bool:
    """Whether something is called so: "a boat named Friday", "a dog called Tuesday"; but "the vet called".

    Or it gets that name: "name the hamster Midnight".
    """
    *_, article, thing, named = ("", "", "", *around.texts[: piece.start])
    if named == "called":
        return article in around.closed.articles and thing not in around.lexicon.persons
    bound = around.texts[piece.start] in around.closed.prepositions_of_time
    if article in around.lexicon.no_times.christening and thing in around.closed.noun_openers:
        known = around.words[piece.start].capital or named in around.lexicon.animals
        verb = piece.start - len((article, thing, named))
        # "We named the cat Tuesday"
        told = verb > 0 and around.texts[verb - 1] in around.closed.personal_pronouns
        return known and not bound and (told or around.opens(verb))
    return named in around.lexicon.no_times.naming and not bound and thing.isalpha()


def _is_translated(piece: Piece, around: Surroundings) -> bool:
    """Whether another word is looked for: "the french word for evening", "a synonym of noon"."""
    joint = piece.end - len(("for", "noon"))
    if joint < 1 or piece.end - piece.start > len(("for", "noon")):
        return False
    known = around.texts[joint - 1] in around.lexicon.no_times.words_for
    # "Find the word for tomorrow" may be when.
    sure = around.texts[joint] in around.closed.of or not around.is_day_from_now(joint + 1)
    led = not around.closed.articles.isdisjoint(around.texts[max(0, joint - 3) : joint - 1])
    return around.texts[joint] in {"for", "of"} and known and led and (sure or "what" in around.texts)


def _has_meaning(piece: Piece, around: Surroundings) -> bool:
    """Whether its meaning is asked for: "what does noon mean", "explain what tomorrow means"."""
    asked = "what" in around.texts[max(0, piece.start - FAR) : piece.start]
    return asked and around.follower(piece) in around.lexicon.no_times.meaning


def _is_said_how(piece: Piece, around: Surroundings) -> bool:
    """Whether it is how something is said, or rhymes: "how do you say noon", "what rhymes with june"."""
    # "Say" may be a hedge, and "with" bind it.
    inner = around.texts[piece.start] in {"with", "say"}
    *_, before, last = ("", "", *around.texts[: piece.start + inner])
    how = last == "say" and before in {"you", "to", "i", "we", "they"}
    asked = "how" in around.texts[max(0, piece.start - FAR) : piece.start]
    return (how and asked) or before in around.lexicon.no_times.rhyming


def _has_units(piece: Piece, around: Surroundings) -> bool:
    """Whether it is what has units of time: "the days of the week", "how many minutes are in a day"."""
    texts, first, inside = around.texts, piece.start, around.lexicon.no_times.inside_units
    while first and texts[first] not in inside and piece.end - first < LONGEST_HAVING:
        first -= 1
    if texts[first] not in inside:
        return False
    if texts[first] in around.closed.of:
        units = first > 1 and texts[first - 1].endswith("s") and around.is_unit(first - 1)
        units = units or texts[first - 1] in around.lexicon.no_times.of_years
        return units and first > 1 and texts[first - 2] in around.closed.the
    counted = texts[:2] == ["how", "many"] and first > len(("how", "many")) and around.is_unit(2)
    return counted and texts[first - 1] in {"are", "there", texts[2]}


def _is_reckoned(piece: Piece, around: Surroundings) -> bool:
    """Whether it is asked what it comes to: "what is 3 hours in minutes", "what is half of 10"."""
    led, kinds = " ".join(around.texts[: piece.start]), around.lexicon.no_times
    units = around.follower(piece) == "in" and around.is_unit(piece.end + 1)
    share = around.texts[piece.start : piece.end].count("of") == 1
    return led in kinds.asking_how_long or (led in kinds.asking_how_much and (units or share))


def is_converted(place: int, around: Surroundings) -> bool:
    """Whether a unit at a place is one of two: "convert 3 hours to minutes", "what is 1 hour in seconds"."""
    before = around.texts[place - 1] if place else ""
    said = " ".join((*around.texts, ""))
    asked = any(said.startswith(f"{opening} ") for opening in around.lexicon.no_times.asking_how_much)
    return "convert" in around.texts[:place] or (asked and before == "in")
