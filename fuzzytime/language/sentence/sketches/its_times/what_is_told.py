"""Where that begins which somebody is told, asked or finds out: "tell Sam the bus leaves at four"."""

from collections.abc import Collection

from fuzzytime.language.meaning.expressions import Phrase, Repeat
from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.verbs.meant.actions import FINITE, Action

PERSONS = ("NN", "PRP")
SAID = ("DT", "PRP", "NN", "JJ", "EX", "CD")
"""How tags begin of words in front of what is told, and of its first."""

ASKED = 3
"""Words for who is asked, at most."""


def told_from(part: Part, action: Action, timed: Collection[int]) -> int | None:
    """Give the "that" behind which is what somebody is told; None where nothing is."""
    nodes = part.tree.nodes
    known = [p for p in part.tree.children(action.place, "ccomp") if nodes[p].lower == "know"]
    if nodes[action.place].lemma in part.lexicon.letting and known:
        # "Let them know the meeting's at ten"
        return _said_from(part, known[0] + 1, timed)
    asked = _asked_from(part, action, timed)
    asked = _requested_from(part, action, timed) if asked is None else asked
    if asked is not None or nodes[action.place].lemma not in part.lexicon.addressing:
        return asked
    for place in range(action.place + 2, len(nodes) - 1):
        behind_whom = place - 1 in timed or nodes[place - 1].tag.startswith(PERSONS)
        if nodes[place].lower == "that" and behind_whom and nodes[place + 1].tag.startswith(SAID):
            return place
    for below in part.tree.children(action.place, "ccomp"):
        # "Tell Sam the shop closes at six"
        subjects = [p for p in part.tree.children(below, "nsubj") if action.place + 1 < p < below]
        if subjects and nodes[below].tag in FINITE:
            return min(part.tree.below(subjects[0]))
    return _said_from(part, action.place + 2, timed)


def is_of_telling(part: Part, phrase: Phrase, told: int) -> bool:
    """Whether a time behind what is told is when it is told: "ask Sam to call me every day"."""
    return isinstance(phrase.said.time, Repeat) and part.tree.nodes[told].lower == "to"


def recalled_from(part: Part, action: Action) -> int | None:
    """Give where that begins which is asked about and was: "remind me what i said about tuesday"."""
    nodes, first = part.tree.nodes, action.place + 2
    asked = first < len(nodes) and (nodes[first].lower,) in part.lexicon.questions["asking"]
    was = any(node.tag == "VBD" for node in nodes[first:])
    return first if asked and was else None


def _asked_from(part: Part, action: Action, timed: Collection[int]) -> int | None:
    """Give the "if" or "whether" behind which is what somebody is asked: "ask Tom if he's free at six"."""
    nodes, lexicon = part.tree.nodes, part.lexicon
    asking = lexicon.closed.subordinators_of_questions
    behind = [place for place in range(action.place + 1, len(nodes)) if place not in timed]
    found = next((place for place in behind[: ASKED + 1] if nodes[place].lower in asking), None)
    lemma = nodes[action.place].lemma
    first = nodes[behind[0]].lower if behind else ""
    if f"{lemma} {first}" in lexicon.doing.finding_out:
        # "Find out when the shops close on sunday"
        opening = nodes[behind[1]] if len(behind) > 1 else None
        asks = opening is not None and (opening.lower in asking or opening.tag.startswith("W"))
        return behind[1] if asks else None
    if lemma in lexicon.doing.inquiring and found is not None:
        return found if _is_to_come(part, found, timed) else None
    if found is None:
        # "Ask kate what time she lands on friday"
        questions = lexicon.questions["asking"]
        behind = [place for place in behind[: ASKED + 1] if (nodes[place].lower,) in questions]
        found = next((place for place in behind if nodes[place + 1 : place + 2] != ()), None)
    return found if lemma in lexicon.doing.asking else None


def _is_to_come(part: Part, first: int, timed: Collection[int]) -> bool:
    """Whether what is found out is of another time: "see if he can come on monday", "if there's a train"."""
    nodes, lexicon = part.tree.nodes, part.lexicon
    told = {nodes[p].lower for p in range(first + 1, len(nodes)) if p not in timed}
    named = {nodes[p].lemma for p in range(first + 1, len(nodes)) if nodes[p].tag.startswith("NN")}
    helping = lexicon.closed.tentative_modals | lexicon.closed.future
    return bool(told & (helping | lexicon.beside.open_things) or named & lexicon.travelling)


def _requested_from(part: Part, action: Action, timed: Collection[int]) -> int | None:
    """Give the "to" behind which is what somebody else is to do: "ask dave to pick me up at half five".

    Who speaks is reminded, and a machine does it when it is told to.
    """
    nodes, lexicon = part.tree.nodes, part.lexicon
    if nodes[action.place].lemma not in lexicon.doing.requesting:
        return None
    behind = [place for place in range(action.place + 1, len(nodes) - 1) if place not in timed]
    to = next((p for p in behind[1 : ASKED + 2] if nodes[p].lower == "to" and nodes[p + 1].is_bare), None)
    whom = {nodes[p].lower for p in behind if to is None or p < to}
    refused = lexicon.closed.speakers | lexicon.machines | lexicon.addresses
    return None if to is None or whom & refused - lexicon.closed.indefinite_pronouns else to


def _said_from(part: Part, first: int, timed: Collection[int]) -> int | None:
    """Give the first word of what somebody is told, where the one before a time says that of a thing.

    "Tell her dinner's at seven", "tell Sam the bus leaves at four"; but "ask what time it is at noon".
    """
    nodes = part.tree.nodes
    for place in sorted(timed):
        verb = place - 1
        asked = any(node.tag.startswith("W") for node in nodes[first:verb])
        # "Visit the butcher's at noon"
        owned = nodes[verb].tag == "POS" and nodes[first - 1].tag in {"DT", "IN", "PRP$"}
        if verb > first and verb not in timed and not asked and not owned:
            word, doing = nodes[verb].lower, part.lexicon.doing
            comes = nodes[verb].tag == "VBZ" and nodes[verb].lemma in doing.arriving
            if comes or word in part.lexicon.closed.present_be or word in doing.timed:
                return first
    return None
