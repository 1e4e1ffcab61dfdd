"""Groups of words around what looks like a time and is none: rows of ``rules/lexicon.yaml``."""

from typing import NamedTuple

from fuzzytime.language.grammar.lexicon.word_groups import Words


class NoTimes(NamedTuple):
    """Words around what looks like a time and is none, by what it is instead: ``no_times``."""

    streets: Words
    set_to: Words
    holding: Words
    scales: Words
    valuing: Words
    renewing: Words
    reckoning: Words
    far: Words
    for_periods: Words
    rounds: Words
    tiny: Words
    adjectives: Words
    idioms: Words
    capital_names: Words
    words: Words
    words_for: Words
    spelling: Words
    writing: Words
    speaking: Words
    sending: Words
    works: Words
    naming: Words
    christening: Words
    meaning: Words
    rhyming: Words
    listening: Words
    titled: Words
    copies: Words
    beginning_titles: Words
    of_years: Words
    topical: Words
    notable: Words
    binding_days: Words
    before_places: Words
    inside_units: Words
    asking_how_long: Words
    asking_how_much: Words
    aging: Words
    numbered: Words
    numbered_in_two: Words
    costing: Words
    versioning: Words
    screens: Words
    file_endings: Words
    shapes: Words
    betting: Words
    having_room: Words
    extents: Words
    sizing: Words
    measured_in: Words
    portions: Words
    totals: Words
    around_ages: Words
    of_decades: Words
    codes: Words
    together: Words
    looking: Words
    handing: Words
    working: Words
    given_names: Words
