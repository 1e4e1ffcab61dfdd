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
    first_person_possessives: Words
    sure_possessives: Words
    possessives: Words
    noun_openers: Words
    sure_noun_openers: Words
    before_numbers: Words
    of_units: Words
    distributives: Words
    each_of_several: Words
    universal_determiners: Words
    general_ordinals: Words
    indefinite_determiners: Words
    singular_determiners: Words
    of_what_is_given: Words
    behind_verbs: Words
    first_person: Words
    first_and_second_person: Words
    second_person: Words
    third_person_singular: Words
    sure_persons: Words
    personal_pronouns: Words
    first_and_third_person: Words
    plural_agreement: Words
    third_person: Words
    subject_pronouns: Words
    indefinite_pronouns: Words
    negative_pronouns: Words
    persons_addressed: Words
    second_person_or_relative: Words
    condition_openers: Words
    singular_anaphors: Words
    it_or_them: Words
    plural_person: Words
    plural_anaphors: Words
    anaphors: Words
    third_person_objects: Words
    all_anaphors: Words
    indirect_objects: Words
    object_pronouns: Words
    wholes: Words
    universal_pronouns: Words
    nonrestrictive_relatives: Words
    relatives: Words
    third_person_be: Words
    present_be: Words
    lemmas_of_be: Words
    past_be: Words
    clipped_be: Words
    have: Words
    have_before_got: Words
    stative_verbs: Words
    future: Words
    requesting_modals: Words
    tentative_modals: Words
    predicting_modals: Words
    obligation: Words
    verbs_of_obligation: Words
    modals_before_lengths: Words
    conditional_inversion: Words
    inverted_auxiliaries: Words
    first_person_future: Words
    negators: Words
    negators_as_typed: Words
    coordinators: Words
    coordinators_of_days: Words
    range_joints: Words
    range_joints_or_and: Words
    subordinators_of_purpose: Words
    joints_of_consequence: Words
    subordinators_of_reason: Words
    denied_alternatives: Words
    subordinators_of_precaution: Words
    subordinators_of_questions: Words
    alternatives: Words
    subordinators_of_simultaneity: Words
    joints_of_orders: Words
    joints_of_clauses: Words
    further_clause: Words
    further_conditions: Words
    additions: Words
    joints_of_conditions: Words
    joints_of_instances: Words
    joints_of_swaps: Words
    end_of_an_order: Words
    end_of_an_event: Words
    end_of_an_aside: Words
    end_of_a_gap: Words
    before_connectives: Words
    prepositions_of_recipients: Words
    prepositions_of_nouns: Words
    prepositions_behind_times: Words
    prepositions_of_duration: Words
    prepositions_of_time: Words
    prepositions_of_times_taken: Words
    prepositions_of_length: Words
    prepositions_of_way: Words
    prepositions_of_points: Words
    particles_of_shifts: Words
    rates: Words
    back_home: Words
    adverbs_of_arrival: Words
    adverbs_of_repetition: Words
    sides: Words
    conjuncts: Words
    adverbs_of_order: Words
    no_order_before: Words
    abbreviations: Words


@dataclass(frozen=True, slots=True, kw_only=True)
class BesideTimes:
    """Words around a time, and around its lengths, by what they make of it: ``beside_times``."""

    before_weekends: Words
    switched: Words
    ordinal_endings: Words
    restricting: Words
    hedging_verbs: Words
    belonging: Words
    which_is_not_said: Words
    first_of_repetitions: Words
    binding_ranges: Words
    behind_round: Words
    taking_along: Words
    how_late: Words
    being_late: Words
    prefixes: Words
    greeting: Words
    of_hours: Words
    of_clocks: Words
    clock_subjects: Words
    bound_for: Words
    getting_off: Words
    put_off: Words
    hedging_lengths: Words
    of_lengths: Words
    comparing: Words
    distances: Words
    ahead: Words
    no_length: Words
    not_how_long: Words
    as_long_as: Words
    behind_gone_on: Words
    behind_minutes: Words
    minus: Words
    repeating: Words
    again: Words
    twice: Words
    beside_twice: Words
    thereafter: Words
    behind_gaps: Words
    saying: Words
    stating: Words
    due: Words
    over: Words
    looking_after: Words
    plurals: Words
    spending: Words
    nothing: Words
    ready: Words
    there: Words
    whereabouts: Words
    marking_order: Words
    no_event: Words
    starts: Words
    ends: Words
    the_end: Words
    excepting: Words
    the_other: Words
    sentence_starts: Words
    stops: Words
    behind_things: Words
    polite_ends: Words
    calls: Words
    visiting: Words
    behind_visiting: Words
    degrees: Words
    mixing: Words
    reasons_in_front: Words
    sites: Words
    turnings: Words
    turning: Words
    contrary: Words
    taken_back: Words
    courteous: Words
    second_choice: Words
    obliging: Words
    obliged: Words
    denying_times: Words
    before_no_denial: Words
    leaving_out: Words
    leaving_out_of_all: Words
    behind_leaving_out: Words


@dataclass(frozen=True, slots=True, kw_only=True)
class Doing:
    """Verbs, and what is said like one, by what they say of what happens or ask for: ``doing``."""

    arriving: Words
    leaving: Words
    being_there: Words
    getting_there: Words
    beginning: Words
    ending: Words
    going_on: Words
    for_days: Words
    by_the_day: Words
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
    continuing: Words
    settling: Words
    inquiring: Words
    asking: Words
    learning: Words
    recalling: Words
    sure: Words
    unwanted: Words
    eating: Words
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
    hesitating: Words
    bringing: Words
    meeting: Words
    resting: Words
    watching: Words
    past_alike: Words


@dataclass(frozen=True, slots=True, kw_only=True)
class NoTimes:
    """Words around what looks like a time and is none, by what it is instead: ``no_times``."""

    streets: Words
    set_to: Words
    holding: Words
    valuing: Words
    renewing: Words
    reckoning: Words
    far: Words
    for_periods: Words
    tiny: Words
    adjectives: Words
    idioms: Words
