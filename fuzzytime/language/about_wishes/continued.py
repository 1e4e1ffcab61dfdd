"""What leans on the verb said before it, in full: "call mum at six", and then "and dad at seven"."""

from dataclasses import replace
from datetime import datetime

from fuzzytime.language.about_wishes.about import AboutKind
from fuzzytime.language.about_wishes.other_words.rewording import is_thing, reworded
from fuzzytime.language.about_wishes.things import continuing
from fuzzytime.language.finding import one_time
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Operation, Reading
from fuzzytime.language.reader import Language
from fuzzytime.language.sentence.trees.named import is_of_its_own
from fuzzytime.requirement import TimeRequirement
from fuzzytime.times import instant_after

MOST_WORDS = 6
"""Words that the name of a thing has at most."""


def continued(text: str, now: datetime, before: str, said: datetime, language: Language) -> str | None:
    """Give in full what leans on what was asked for before; None where it does not, or cannot.

    Parameters
    ----------
    text, now
        What leans on it, and when that is said.
    before, said
        What was asked for, and when.
    language
        What reads both.

    Raises
    ------
    InstructionError
        If a text is too long.
    """
    lexicon = language.lexicon
    about = continuing(text, now, lexicon)
    if about is None:
        return None
    first, _, rest = about.thing.partition(" ")
    if rest and first in lexicon.closed.prepositions_of_nouns and f" {first} " in before:
        # "Lesson with Mia at two", "and with Tom at three"
        about = replace(about, thing=rest, joint=first, certain=True)
    if about.kind is AboutKind.LIKE and not about.certain and not names_thing(about.thing, now, language):
        return None
    reading = language.read(before, now=said)
    operations = [one.operation for one in reading.instructions if one.operation is not None]
    if len(operations) != 1 or operations[0].negated:
        return None
    if about.kind is AboutKind.AGAIN:
        anew = reworded(reading, lexicon, time=about.time, now=now)
        if anew is None or not about.time:
            return anew
        day = one_time(about.time, now, lexicon)
        return anew if _is_repeated_alike(reading, language.read(anew, now=now), said, now, day) else None
    if not about.certain and (operations[0].stated or is_thing(reading)):
        return None
    if not about.certain and _is_met(about.thing, operations[0], lexicon):
        return None
    # "Then physics" comes when the other is over, and not when that was to be.
    time = about.time if about.time or about.text else None
    anew = reworded(reading, lexicon, thing=about.thing, joint=about.joint, time=time, now=now)
    return f"{about.text} {anew}".strip() if anew is not None else None


def _is_repeated_alike(
    old: Reading, anew: Reading, said: datetime, now: datetime, day: TimeRequirement | None
) -> bool:
    """Whether what is repeated begins at the same hour on the new day; what is done once may at any.

    "Every hour until two" says no hour at which it would begin tomorrow.
    """
    before, then = (_first_turn(reading) for reading in (old, anew))
    if before is None or then is None:
        return True
    if day is None or day.earliest is None:
        return False
    on_day = day.earliest <= then and (day.latest is None or then < day.latest)
    return on_day and instant_after(said, before).time() == instant_after(now, then).time()


def _first_turn(reading: Reading) -> float | None:
    """Give when what is repeated is done first; None where nothing is."""
    recurrences = (part.recurrence for one in reading.instructions for part in one.requirements)
    turns = (turn for one in recurrences if one is not None for turn in one.coming(1))
    return next((begin for begin, _ in turns), None)


def _is_met(thing: str, operation: Operation, lexicon: Lexicon) -> bool:
    """Whether somebody is met, to whom that is not done: "water the plants", "and the doctor at six"."""
    people = lexicon.persons
    person = not people.isdisjoint(word.text for word in words_of(thing)[-1:])
    known = (
        any(word.text in people for word in words_of(operation.name)) or operation.lemma in lexicon.addressing
    )
    return person and not known


def names_thing(thing: str, now: datetime, language: Language) -> bool:
    """Whether words name a thing with which nothing is done without another verb.

    "And dinner at seven" and "then a nap" are something of their own, and so is "and stir".
    """
    lexicon = language.lexicon
    words = [word.text for word in words_of(thing)]
    if not words or len(words) > MOST_WORDS or words[0].partition("'")[0] in lexicon.closed.anaphors:
        return False
    openers = lexicon.closed.noun_openers | lexicon.closed.anaphors
    if words[0] not in openers and not openers.isdisjoint(words[1:]):
        # "Add the rice" is an order, and needs no tree to be one.
        return False
    if is_of_its_own(thing, lexicon):
        return False
    numbered = len(words) == 2 and (words[1].isdecimal() or words[1] in lexicon.numbers)
    if len(words) == 1 or numbered:
        # Trees take a word alone for an order, and one with a number: "bread", "chapter four".
        return words[0] not in lexicon.alone | lexicon.intransitive | lexicon.chores
    return is_thing(language.read(thing, now=now))
