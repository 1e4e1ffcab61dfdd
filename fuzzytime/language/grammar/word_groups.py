"""Small groups of words that rules ask for by name: each field is a row of ``rules/lexicon.yaml``.

What a group is for, and which words it holds, stands there, beside it; a space in its name is an underscore
here.
"""

from dataclasses import dataclass

Words = frozenset[str]


@dataclass(frozen=True, slots=True, kw_only=True)
class ClosedClasses:
    """Determiners, pronouns, auxiliaries, conjunctions, prepositions and adverbs: ``closed_classes``."""

    articles: Words
    own: Words
    sure_owners: Words
    owners: Words
    openers: Words
    sure_openers: Words
    before_numbers: Words
    of_units: Words
    each: Words
    each_of_several: Words
    all_of_some: Words
    one_of_some: Words
    some_one: Words
    one_alone: Words
    of_what_is_given: Words
    behind_verbs: Words
    speakers: Words
    speakers_and_asked: Words
    asked: Words
    he_or_she: Words
    somebody: Words
    anybody: Words
    unasked: Words
    without_s: Words
    others_or_it: Words
    no_noun: Words
    indefinite: Words
    nobody: Words
    asked_together: Words
    asked_or_relative: Words
    begin_what_is_so: Words
    said_before: Words
    it_or_them: Words
    them: Words
    several: Words
    things: Words
    persons: Words
    anything: Words
    receivers: Words
    objects: Words
    everything: Words
    all_meant: Words
    of_asides: Words
    relative: Words
    present_be: Words
    am: Words
    be: Words
    was: Words
    short_be: Words
    have_got: Words
    said_of_things: Words
    will: Words
    polite: Words
    possibly: Words
    told: Words
    due: Words
    duties: Words
    helping: Words
    inverting: Words
    asking_when: Words
    we_will: Words
    denying: Words
    denying_as_typed: Words
    listing: Words
    listing_days: Words
    reaching: Words
    reaching_or_both: Words
    so: Words
    consequences: Words
    reasons: Words
    instead: Words
    going_on: Words
    another_order: Words
    same_order: Words
    another_clause: Words
    further: Words
    leading: Words
    further_ones: Words
    swapped: Words
    end_of_an_event: Words
    end_of_an_aside: Words
    end_of_a_gap: Words
    opened_by: Words
    ways: Words
    of_nouns: Words
    more_of_it: Words
    going_along: Words
    by_then: Words
    how_long: Words
    up_to: Words
    shifting_by: Words
    per: Words
    back_home: Words
    there: Words
    again: Words
    sides: Words
    opening: Words
    sooner_or_later: Words
    no_place_in_an_order: Words
    abbreviations: Words


@dataclass(frozen=True, slots=True, kw_only=True)
class BesideTimes:
    """Words around a time, and around its lengths, by what they make of it: ``beside_times``."""

    restricting: Words
    comparing: Words
    distances: Words
    ahead: Words
    saying: Words
    being_late: Words
    taking_along: Words
    behind_round: Words
    of_hours: Words
    of_clocks: Words
    repeating: Words
    first_of_repetitions: Words
    again: Words
    twice: Words
    beside_twice: Words
    hedging_lengths: Words
    polite_ends: Words
    behind_gone_on: Words
    looking_after: Words
    no_length: Words
    not_how_long: Words
    behind_minutes: Words
    stops: Words
    behind_things: Words
    sentence_starts: Words
    binding_ranges: Words
    clock_subjects: Words
    bound_for: Words
    put_off: Words
    plurals: Words
    spending: Words
    stating: Words
    minus: Words
    greeting: Words
    of_lengths: Words
    marking_order: Words
    taken_back: Words
    courteous: Words
    starts: Words
    ends: Words
    the_end: Words
    thereafter: Words
    obliging: Words
    obliged: Words
    no_event: Words
    as_long_as: Words
    excepting: Words
    excepted: Words
    due: Words
    over: Words
    nothing: Words
    behind_gaps: Words


@dataclass(frozen=True, slots=True, kw_only=True)
class Doing:
    """Verbs, and what is said like one, by what they say of what happens or ask for: ``doing``."""

    arriving: Words
    leaving: Words
    beginning: Words
    ending: Words
    going_on: Words
    running: Words
    taking: Words
    spent: Words
    spending: Words
    finished: Words
    putting: Words
    waiting: Words
    setting: Words
    set_going: Words
    repeating: Words
    shifting: Words
    trying: Words
    sure: Words
    keeping: Words
    getting: Words
    becoming: Words
    being: Words
    being_or_doing: Words
    phases: Words
    stopping: Words
    happening: Words
    surely_timed: Words
    timed: Words
    several_timed: Words
    dropping: Words
    remembering: Words
    needing: Words
    past_alike: Words
