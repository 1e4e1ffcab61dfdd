"""Where what somebody is told begins: "text mike i'm on my way", "tell sam the shop closes at six".

By words alone, as trees go wrong over it: a name and a sentence without a joint.
"""

from collections.abc import Sequence
from collections.abc import Set as AbstractSet

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word

LONGEST_NAME = 3
"""Words of who is told, at most: "my big sister", "mum and dad"."""

LONGEST_SUBJECT = 5
"""Words of what something is told of, at most."""


def told_from(
    words: Sequence[Word], place: int, times: dict[int, int], covered: AbstractSet[int], lexicon: Lexicon
) -> int | None:
    """Give where that begins which somebody is told who is named from a place on; None where nothing is.

    ``times`` are the ends of times by their first words, ``covered`` the words in them. Who speaks is
    reminded by what is told, and not told it: "text me that the film starts at six".
    """
    closed = lexicon.closed
    if place >= len(words) or words[place].text in closed.speakers | closed.subordinators_of_questions:
        return None
    led = words[place].text in closed.noun_openers
    sure = words[place].text in closed.third_person_objects | closed.indefinite_pronouns
    # "Text her i'm late", "text her sister i'm late"
    longest = 1 if sure and not led else LONGEST_NAME + led
    for end in range(place + 1 + (led and not sure), min(place + longest, len(words) - 1) + 1):
        alone = sure and end == place + 1
        if not (alone or _names(words, end - 1, lexicon)):
            return None
        known = not led or alone or words[end - 1].text in lexicon.persons | lexicon.doing.recipients
        if words[end].text == ":" and end + 1 < len(words):
            # "Text Kate: dinner at eight" needs no sentence behind the mark
            return None if _calls(words, place, lexicon) else end
        if known and words[end].text == "," and _opens(words, end + 1, covered, lexicon, sure=True):
            return end
        behind = times.get(end, end)
        that = known and behind < len(words) and words[behind].text == "that"
        if that and is_said(words, behind + 1, lexicon):
            # "Text mike at six that i'm late"; but "email the file that we signed"
            return behind
        clipped = behind > end and known and behind < len(words) - 1 and "'" in words[behind].text
        if clipped and _is_subject(words[behind].text, lexicon):
            # "Text mike at six i'm late"
            return behind
        # "Email raj today and they want it by two"
        joined = "and" in {word.text for word in words[end - 1 : end + 1]}
        if end not in covered and not joined and _opens(words, end, covered, lexicon, sure=known):
            return end
    return None


def _calls(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a machine is told, which does it: "tell the robot: dock at noon"."""
    known = lexicon.machines | lexicon.addresses
    return not known.isdisjoint(word.text for word in words[place : place + LONGEST_NAME])


def _names(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a word may be of a name: "jo", "and dad"."""
    text = words[place].text
    refused = lexicon.function_words | lexicon.places | lexicon.closed.inverted_auxiliaries
    named = words[place].is_letters and text not in refused and "'" not in text
    return text == "and" or (named and not _is_subject(text, lexicon))


def is_said(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a sentence may begin behind "that": "that i'm late", "that dinner is ready"."""
    if place >= len(words) - 1:
        return False
    return _is_subject(words[place].text, lexicon) or _finite(words, place, lexicon) is not None


def _opens(
    words: Sequence[Word], place: int, covered: AbstractSet[int], lexicon: Lexicon, *, sure: bool
) -> bool:
    """Whether a sentence begins at a place that nothing joins to the name before it.

    Only behind a ``sure`` name: "the photo i took" is a thing described.
    """
    if place >= len(words) - 1 or not sure:
        return False
    closed = lexicon.closed
    text, behind = words[place].text, words[place + 1].text
    if _is_subject(text, lexicon) and (text != "it" or place + 1 not in covered):
        return "'" in text or place + 1 not in covered
    if text in closed.singular_anaphors:
        # "This is jo"; but "that joke"
        return behind in closed.stative_verbs | closed.told_auxiliaries
    if text in closed.inverted_auxiliaries:
        # "Can you pick up milk", "is dinner ready"; but "mail delivery is at ten"
        named = closed.noun_openers | lexicon.taken | lexicon.happening
        return behind in closed.subject_pronouns or (text in closed.present_be and behind in named)
    if (text,) in lexicon.questions["asking"] or text in closed.relatives:
        return _is_question(words, place, lexicon)
    verb = _finite(words, place, lexicon)
    return verb is not None and covered.isdisjoint(range(place, verb))


def _is_subject(text: str, lexicon: Lexicon) -> bool:
    """Whether a word is a pronoun that something is told of, with what may be clipped behind it: "i'll"."""
    return (
        text.partition("'")[0] in lexicon.closed.subjects_told_of or text in lexicon.closed.subjects_as_typed
    )


def _is_question(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether it is asked or told: "where are you", "what time we're landing"; but not "what to buy"."""
    if "'" in words[place].text:
        return True
    for here in range(place + 1, min(place + LONGEST_NAME + 1, len(words) - 1)):
        if words[here].text in lexicon.closed.inverted_auxiliaries:
            return True
        if words[here].text == "to" or _is_subject(words[here].text, lexicon):
            helping = lexicon.closed.inverted_auxiliaries | lexicon.closed.told_auxiliaries
            return "'" in words[here].text or words[here + 1].text in helping
    return False


def _finite(words: Sequence[Word], place: int, lexicon: Lexicon) -> int | None:
    """Give the verb of what is said of a thing named at a place: "dinner is", "the offices close"."""
    closed, doing = lexicon.closed, lexicon.doing
    helping = closed.stative_verbs | closed.told_auxiliaries
    named = place + (words[place].text in closed.noun_openers)
    for here in range(named, min(named + LONGEST_SUBJECT, len(words))):
        text = words[here].text
        if here > named:
            several = text in doing.several_timed and words[here - 1].text.endswith("s")
            if text in helping or text in doing.timed or several:
                return here
        clipped = "'s" in text and here + 1 < len(words) and words[here + 1].text in closed.behind_clipped_be
        if clipped:
            # "Dinner's at seven"
            return here
        known = text in closed.noun_openers | closed.told_joints
        if not known and (text in lexicon.function_words or not words[here].is_letters):
            return None
    return None
