"""Verbs, and what is said like one, in the groups that readers of trees ask for by name."""

from typing import NamedTuple

from fuzzytime.language.grammar.lexicon.word_groups import Words


class Doing(NamedTuple):
    """Verbs, and what is said like one, by what they say of what happens or ask for: ``doing``."""

    labels: Words
    arriving: Words
    loading: Words
    leaving: Words
    being_there: Words
    getting_there: Words
    beginning: Words
    ending: Words
    going_on: Words
    for_days: Words
    by_then: Words
    naming_nothing: Words
    by_the_day: Words
    of_events: Words
    shutting: Words
    lit: Words
    running: Words
    taking: Words
    spent: Words
    spending: Words
    finished: Words
    putting: Words
    being_somewhere: Words
    waiting: Words
    taking_care: Words
    setting: Words
    set_going: Words
    repeating: Words
    shifting: Words
    trying: Words
    continuing: Words
    settling: Words
    inquiring: Words
    requesting: Words
    finding_out: Words
    asking: Words
    learning: Words
    more_said_of: Words
    recalling: Words
    messaging: Words
    marking: Words
    noting: Words
    replying: Words
    letters: Words
    recipients: Words
    before_messages: Words
    sure: Words
    unwanted: Words
    holding_true: Words
    requiring: Words
    covering: Words
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
    saying: Words
    passing_on: Words
    foretold: Words
    closing_up: Words
    closing_there: Words
    opening_up: Words
    opening_there: Words
    hours: Words
    errands: Words
    dropping: Words
    declining: Words
    revoking: Words
    inviting: Words
    seeking: Words
    finding: Words
    showing: Words
    remembering: Words
    needing: Words
    wishing: Words
    hesitating: Words
    bringing: Words
    meeting: Words
    resting: Words
    watching: Words
    past_alike: Words
