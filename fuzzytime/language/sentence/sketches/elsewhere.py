"""Times of something else than what is to be done: of what is told, and of things described by them.

"Remind me at six that the oven is cleaned at seven", "print the tickets for the film that starts at eight".
"""

from collections.abc import Collection, Sequence
from itertools import pairwise, takewhile

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Span
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.expressions import Duration, Offset, Phrase, Range, Repeat, Wall
from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.trees.tags import GRAMMATICAL_SUBJECTS, SUBJECTS
from fuzzytime.language.sentence.verbs.actions import FINITE, Action
from fuzzytime.requirement import Constraint

PERSONS = ("NN", "PRP")
SAID = ("DT", "PRP", "NN", "JJ", "EX", "CD")
"""How tags begin of words in front of what is told, and of its first."""

ASKED = 3
"""Words for who is asked, at most."""

FOR = "for"
WITH = "with"
ARTICLES = frozenset({"a", "an", "one"})

BOUNDS = frozenset({Constraint.BEFORE, Constraint.AFTER})

LEAST_CASE = 3
"""Words of such a case, at least, behind the first of them."""


def elsewhere(
    part: Part, phrases: Sequence[Phrase], action: Action, lexicon: Lexicon, *, told: bool = False
) -> list[Phrase]:
    """Give the times that are no times of what is to be done, of which a clause may have ``told`` when."""
    starts = {phrase.span: next(part.tree.at(*_local(part, phrase)), None) for phrase in phrases}
    timed = {place for phrase in phrases for place in part.tree.at(*_local(part, phrase))}
    said = _told_from(part, action, timed, lexicon)
    own = said is not None and any(place is None or place < said for place in starts.values())
    if part.tree.nodes[action.place].lemma in lexicon.doing.recalling and not own:
        said = _recalled_from(part, action)
    found = _of_moved(part, phrases, action, lexicon) + _of_prepared(part, phrases, action)
    found += _of_inner(part, phrases) + _of_subject(part, phrases, action, told=told)
    past: int | None = None
    for phrase in phrases:
        place = starts[phrase.span]
        if place is None:
            continue
        before, past = past, _done_before(part, phrase, place, action)
        # Of two times behind what was done the second says when: "call the man who rang at six at seven".
        described = past is not None and past != before
        of_told = said is not None and place > said and not _is_of_telling(part, phrase, action, said)
        if described or of_told or _is_described(part, place, action):
            found.append(phrase)
    return found


def is_of_subject(part: Part, phrase: Phrase, action: Action) -> bool:
    """Whether a time is of what a verb behind it is about: "meeting at 3.30, should be done by four"."""
    place = next(iter(part.tree.at(*_local(part, phrase))), None)
    subjects = part.tree.children(action.place, *GRAMMATICAL_SUBJECTS)
    is_when = phrase.said.constraint in {None, Constraint.AT}
    return is_when and place is not None and any(place in part.tree.below(subject) for subject in subjects)


def _of_subject(part: Part, phrases: Sequence[Phrase], action: Action, *, told: bool) -> list[Phrase]:
    """Give what something is for, beside when it happens: "the sheet for Monday goes out at six"."""
    subjects = [p for p in part.tree.children(action.place, *SUBJECTS) if p < action.place]
    inside = {p for subject in subjects for p in part.tree.below(subject)}
    places = {phrase.span: set(part.tree.at(*_local(part, phrase))) for phrase in phrases}
    own = [phrase for phrase in phrases if not places[phrase.span] <= inside]
    verb = part.tree.nodes[action.place]
    if verb.tag != "VBZ" or verb.lemma in part.tree.lexicon.doing.happening or not (own or told):
        # "Dinner for Saturday is at eight"
        return []
    return [phrase for phrase in phrases if phrase not in own and phrase.said.preposition == FOR]


def aim_of(part: Part, phrases: Sequence[Phrase], action: Action) -> Span | None:
    """Give the stretch that says how something else is then: "light it at five so the room is warm by six".

    What is to be done has a time of its own before it, so that the one behind is none of that.
    """
    nodes = part.tree.nodes
    for verb in range(action.place + 2, len(nodes)):
        subjects = [p for p in part.tree.children(verb, *SUBJECTS) if action.place < p < verb]
        helped = bool(part.tree.children(verb, "aux"))
        if not subjects or not (nodes[verb].tag in FINITE or (nodes[verb].tag == "VB" and helped)):
            continue
        first = min(part.tree.below(subjects[0]))
        so = first - 1 - (nodes[first - 1].lower == "that")
        if nodes[so].lower != "so" or nodes[subjects[0]].lower in part.tree.lexicon.closed.anaphors:
            continue
        start, end = nodes[so].start + part.offset, nodes[-1].end + part.offset
        own = any(phrase.span[1] <= start for phrase in phrases)
        behind = any(phrase.span[0] >= start for phrase in phrases)
        thing = {nodes[p].lower for p in part.tree.children(action.place, "dobj")}
        if own and behind and nodes[subjects[0]].lower not in thing:
            return start, end
    return None


def reason_of(part: Part, phrases: Sequence[Phrase], action: Action) -> Span | None:
    """Give the stretch that says why: "clear it by five because the painters come in overnight"."""
    nodes, closed = part.tree.nodes, part.tree.lexicon.closed
    for place in range(action.place + 1, len(nodes) - LEAST_CASE):
        opening = f"{nodes[place].lower} {nodes[place + 1].lower}"
        if opening in closed.subordinators_of_precaution and nodes[place + 2].lower != "of":
            # "Take a coat in case it rains at noon"
            return nodes[place].start + part.offset, nodes[-1].end + part.offset
    for place in range(action.place + 1, len(nodes)):
        if nodes[place].lower in closed.subordinators_of_reason and nodes[place].relation == "mark":
            reach = part.tree.reach(nodes[place].head)
            start, end = nodes[place].start + part.offset, nodes[reach[1] - 1].end + part.offset
            if any(start <= phrase.span[0] < end for phrase in phrases):
                return start, end
    return None


def _local(part: Part, phrase: Phrase) -> tuple[int, int]:
    first, end = phrase.span
    return first - part.offset, end - part.offset


def _told_from(part: Part, action: Action, timed: Collection[int], lexicon: Lexicon) -> int | None:
    """Give the "that" behind which is what somebody is told; None where nothing is."""
    nodes = part.tree.nodes
    known = [p for p in part.tree.children(action.place, "ccomp") if nodes[p].lower == "know"]
    if nodes[action.place].lemma in lexicon.letting and known:
        # "Let them know the meeting's at ten"
        return _said_from(part, known[0] + 1, timed, lexicon)
    asked = _asked_from(part, action, timed)
    asked = _requested_from(part, action, timed) if asked is None else asked
    if asked is not None or nodes[action.place].lemma not in lexicon.addressing:
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
    return _said_from(part, action.place + 2, timed, lexicon)


def _is_of_telling(part: Part, phrase: Phrase, action: Action, told: int) -> bool:
    """Whether a time behind what is told is when it is told: "ask Sam to call me every day"."""
    if part.tree.nodes[action.place].lemma in part.tree.lexicon.doing.recalling:
        # "Remind me what I said in ten minutes"
        return isinstance(phrase.said.time, Offset)
    return isinstance(phrase.said.time, Repeat) and part.tree.nodes[told].lower == "to"


def _recalled_from(part: Part, action: Action) -> int | None:
    """Give where that begins which is asked about and was: "remind me what i said about tuesday"."""
    nodes, first = part.tree.nodes, action.place + 2
    asked = first < len(nodes) and (nodes[first].lower,) in part.tree.lexicon.questions["asking"]
    was = any(node.tag == "VBD" for node in nodes[first:])
    return first if asked and was else None


def _asked_from(part: Part, action: Action, timed: Collection[int]) -> int | None:
    """Give the "if" or "whether" behind which is what somebody is asked: "ask Tom if he's free at six"."""
    nodes, lexicon = part.tree.nodes, part.tree.lexicon
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
    nodes, lexicon = part.tree.nodes, part.tree.lexicon
    told = {nodes[p].lower for p in range(first + 1, len(nodes)) if p not in timed}
    named = {nodes[p].lemma for p in range(first + 1, len(nodes)) if nodes[p].tag.startswith("NN")}
    helping = lexicon.closed.tentative_modals | lexicon.closed.future
    return bool(told & (helping | lexicon.beside.open_things) or named & lexicon.travelling)


def _requested_from(part: Part, action: Action, timed: Collection[int]) -> int | None:
    """Give the "to" behind which is what somebody else is to do: "ask dave to pick me up at half five".

    Who speaks is reminded, and a machine does it when it is told to.
    """
    nodes, lexicon = part.tree.nodes, part.tree.lexicon
    if nodes[action.place].lemma not in lexicon.doing.requesting:
        return None
    behind = [place for place in range(action.place + 1, len(nodes) - 1) if place not in timed]
    to = next((p for p in behind[1 : ASKED + 2] if nodes[p].lower == "to" and nodes[p + 1].is_bare), None)
    whom = {nodes[p].lower for p in behind if to is None or p < to}
    refused = lexicon.closed.speakers | lexicon.machines | lexicon.addresses
    return None if to is None or whom & refused - lexicon.closed.indefinite_pronouns else to


def _said_from(part: Part, first: int, timed: Collection[int], lexicon: Lexicon) -> int | None:
    """Give the first word of what somebody is told, where the one before a time says that of a thing.

    "Tell her dinner's at seven", "tell Sam the bus leaves at four"; but "ask what time it is at noon".
    """
    nodes = part.tree.nodes
    for place in sorted(timed):
        verb = place - 1
        asked = any(node.tag.startswith("W") for node in nodes[first:verb])
        if verb > first and verb not in timed and not asked:
            word, doing = nodes[verb].lower, lexicon.doing
            comes = nodes[verb].tag == "VBZ" and nodes[verb].lemma in doing.arriving
            if comes or word in lexicon.closed.present_be or word in doing.timed:
                return first
    return None


def _of_moved(part: Part, phrases: Sequence[Phrase], action: Action, lexicon: Lexicon) -> list[Phrase]:
    """Give when what is moved or cancelled would have been: "move the meetings on friday to monday".

    The new time stands right behind it; of what is cancelled, all that are so are meant.
    """
    nodes = part.tree.nodes
    lemma = nodes[action.place].lemma
    if lemma in lexicon.moving:
        pairs = pairwise(phrases)
        return [old for old, new in pairs if new.said.preposition == "to" and old.end == new.first]
    objects = part.tree.children(action.place, "dobj")
    several = [
        thing
        for thing in objects
        for p in part.tree.children(thing, "det")
        if nodes[p].lower in lexicon.closed.universal_determiners
    ]
    if lemma not in lexicon.doing.dropping or not several:
        return []
    behind = nodes[several[-1]].end + part.offset
    return [phrase for phrase in phrases if behind <= phrase.span[0] <= behind + 1]


def _of_prepared(part: Part, phrases: Sequence[Phrase], action: Action) -> list[Phrase]:
    """Give when that is which is prepared, where another time says when: "the rota for monday by friday"."""
    nodes = part.tree.nodes
    for place, phrase in enumerate(phrases):
        first = next(iter(part.tree.at(*_local(part, phrase))), None)
        named = first is not None and first > action.place + 1 and nodes[first - 1].tag.startswith("NN")
        if named and phrase.said.preposition == FOR and phrase.said.constraint is None:
            listed = [phrase, *takewhile(_is_listed, phrases[place + 1 :])]
            others = (other for other in phrases if other not in listed and other.said.preposition != FOR)
            return listed if any(_says_when(other) for other in others) else []
    return []


def _of_inner(part: Part, phrases: Sequence[Phrase]) -> list[Phrase]:
    """Give how long a part of it is, where words say of the whole: "from 9 to 11 with a ten minute break"."""
    nodes, found = part.tree.nodes, []
    for phrase in phrases:
        first = next(iter(part.tree.at(*_local(part, phrase))), 0)
        led = [node.lower for node in nodes[max(0, first - 2) : first]]
        inner = isinstance(phrase.said.time, Duration) and phrase.said.preposition is None
        if inner and led[:1] == [WITH] and led[1] in ARTICLES and len(phrases) > 1:
            found.append(phrase)
    spans = any(isinstance(phrase.said.time, (Range, Duration)) for phrase in phrases if phrase not in found)
    return found if spans else []


def _is_listed(phrase: Phrase) -> bool:
    """Whether it is a day of a list: "for monday, tuesday and friday"."""
    days = phrase.said.time.days if isinstance(phrase.said.time, Wall) else None
    return phrase.said.preposition is None and isinstance(days, Fields)


def _says_when(phrase: Phrase) -> bool:
    """Whether a time says on which day something is done, and is no clock time of another's day."""
    said, time = phrase.said, phrase.said.time
    if said.constraint in BOUNDS:
        return True
    return isinstance(time, Wall) and time.days is not None and said.constraint in {None, Constraint.AT}


def _done_before(part: Part, phrase: Phrase, place: int, action: Action) -> int | None:
    """Give the verb of what was done that a time is of: "send the photos I took last monday"."""
    above = next((p for p in part.tree.above(place) if part.tree.nodes[p].is_verb), None)
    if above is None or above <= action.place or phrase.said.constraint is Constraint.BEFORE:
        return None
    node = part.tree.nodes[above]
    return above if node.relation == "relcl" and node.tag == "VBD" else None


def _is_described(part: Part, place: int, action: Action) -> bool:
    """Whether a time stands right behind the verb of a relative clause: "the film that starts at eight"."""
    tree, verb = part.tree, place - 1
    if verb <= action.place or not tree.nodes[verb].is_verb:
        return False
    # "The meeting I have tomorrow" is what is counted from.
    before = (p for p in tree.children(verb) if p < verb and tree.nodes[p].relation != "mark")
    return any(tree.nodes[p].lower in part.tree.lexicon.closed.relatives for p in before)
