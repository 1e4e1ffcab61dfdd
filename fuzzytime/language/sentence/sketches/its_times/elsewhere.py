"""Times of something else than what is to be done: of what is told, and of things described by them.

"Remind me at six that the oven is cleaned at seven", "print the tickets for the film that starts at eight".
"""

from collections.abc import Sequence
from itertools import pairwise, takewhile

from fuzzytime.language.instruction import Span
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.expressions import Duration, Offset, Phrase, Range, Wall
from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.sketches.its_times.what_is_told import (
    is_of_telling,
    recalled_from,
    told_from,
)
from fuzzytime.language.sentence.trees.reasons import begins_reason
from fuzzytime.language.sentence.trees.tags import GRAMMATICAL_SUBJECTS, SUBJECTS
from fuzzytime.language.sentence.verbs.meant.actions import FINITE, Action
from fuzzytime.requirement import BOUNDS, MOMENTS, Constraint

NAMING = ("NN", "PRP", "DT", "CD")
"""How tags begin of what a relative clause says more of: "the film that starts at eight"."""

LEAST_CASE = 3
"""Words of such a case, at least, behind the first of them."""


def elsewhere(part: Part, phrases: Sequence[Phrase], action: Action, *, told: bool = False) -> list[Phrase]:
    """Give the times that are no times of what is to be done, of which a clause may have ``told`` when."""
    starts = {phrase.span: next(part.at(phrase.span), None) for phrase in phrases}
    timed = {place for phrase in phrases for place in part.at(phrase.span)}
    said = told_from(part, action, timed)
    own = said is not None and any(place is None or place < said for place in starts.values())
    if part.tree.nodes[action.place].lemma in part.lexicon.doing.recalling and not own:
        said = recalled_from(part, action)
    found = _of_moved(part, phrases, action) + _of_aim(part, phrases, action)
    found += _of_prepared(part, [phrase for phrase in phrases if phrase not in found], action)
    found += _of_inner(part, phrases) + _of_subject(part, phrases, action, told=told)
    past: int | None = None
    for phrase in phrases:
        place = starts[phrase.span]
        if place is None:
            continue
        before, past = past, _done_before(part, phrase, place, action)
        # Of two times behind what was done the second says when: "call the man who rang at six at seven".
        described = past is not None and past != before
        of_told = said is not None and place > said and not is_of_telling(part, phrase, said)
        if described or of_told or _is_described(part, place, action):
            found.append(phrase)
    return found


def is_of_subject(part: Part, phrase: Phrase, action: Action) -> bool:
    """Whether a time is of what a verb behind it is about: "meeting at 3.30, should be done by four"."""
    place = next(part.at(phrase.span), None)
    subjects = part.tree.children(action.place, *GRAMMATICAL_SUBJECTS)
    is_when = phrase.said.constraint in MOMENTS
    return is_when and place is not None and any(place in part.tree.below(subject) for subject in subjects)


def _of_subject(part: Part, phrases: Sequence[Phrase], action: Action, *, told: bool) -> list[Phrase]:
    """Give what something is for, beside when it happens: "the sheet for Monday goes out at six"."""
    subjects = [p for p in part.tree.children(action.place, *SUBJECTS) if p < action.place]
    inside = {p for subject in subjects for p in part.tree.below(subject)}
    places = {phrase.span: set(part.at(phrase.span)) for phrase in phrases}
    own = [phrase for phrase in phrases if not places[phrase.span] <= inside]
    verb = part.tree.nodes[action.place]
    if verb.tag != "VBZ" or verb.lemma in part.lexicon.doing.happening or not (own or told):
        # "Dinner for Saturday is at eight"
        return []
    return [phrase for phrase in phrases if phrase not in own and phrase.said.preposition == "for"]


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
        lexicon = part.lexicon
        # "Post it by noon so they get it tomorrow"
        ends_so = not lexicon.closed.it_or_them & part.tree.said(part.tree.children(verb, "dobj"))
        own_end = ends_so and nodes[subjects[0]].lower in lexicon.closed.anaphors
        # "Fix the fence so the sheep don't get out tonight"
        denied = bool(part.tree.children(verb, "neg"))
        there = lexicon.places.intersection(part.tree.said(part.tree.children(verb, "advmod", "prep")))
        becomes = nodes[verb].lemma in lexicon.doing.being and not there
        if nodes[so].lower != "so" or (own_end and becomes and not denied):
            # "Soak it overnight so it's ready by six"; but "order it today so that it gets here on friday"
            continue
        start, end = part.span(nodes[so], nodes[-1])
        # "Ring me so I can pick you up at five"
        able = not lexicon.closed.requesting_modals.isdisjoint(
            part.tree.said(part.tree.children(verb, "aux"))
        )
        able = able and nodes[subjects[0]].lower in lexicon.closed.first_and_second_person
        own = not ends_so or denied or able or any(phrase.span[1] <= start for phrase in phrases)
        behind = any(phrase.span[0] >= start for phrase in phrases)
        thing = {nodes[p].lower for p in part.tree.children(action.place, "dobj")}
        if own and behind and nodes[subjects[0]].lower not in thing:
            return start, end
    return _later_use(part, phrases, action)


def _later_use(part: Part, phrases: Sequence[Phrase], action: Action) -> Span | None:
    """Give what is done with a thing later: "sow the peas for planting out in may"; but "… by friday"."""
    nodes = part.tree.nodes
    for place in range(action.place + 2, len(nodes)):
        start, end = part.span(nodes[place - 1], nodes[-1])
        used = nodes[place - 1].lower == "for" and nodes[place].lower in part.lexicon.asides["used later"]
        if used and any(one.span[0] >= start and one.said.constraint in MOMENTS for one in phrases):
            return start, end
    return None


def reason_of(part: Part, phrases: Sequence[Phrase], action: Action) -> Span | None:
    """Give the stretch that says why: "clear it by five because the painters come in overnight"."""
    nodes, closed = part.tree.nodes, part.lexicon.closed
    for place in range(action.place + 1, len(nodes) - LEAST_CASE):
        opening = f"{nodes[place].lower} {nodes[place + 1].lower}"
        if opening in closed.subordinators_of_precaution and nodes[place + 2].lower != "of":
            # "Take a coat in case it rains at noon"
            return part.span(nodes[place], nodes[-1])
    for place in range(action.place + 1, len(nodes)):
        if begins_reason(part.tree, place) and nodes[place].relation == "mark":
            reach = part.tree.reach(nodes[place].head)
            start, end = part.span(nodes[place], nodes[reach[1] - 1])
            if any(start <= phrase.span[0] < end for phrase in phrases):
                return start, end
    return None


def _of_moved(part: Part, phrases: Sequence[Phrase], action: Action) -> list[Phrase]:
    """Give when what is moved or cancelled would have been: "move the meetings on friday to monday".

    The new time stands right behind it; of what is cancelled, all that are so are meant.
    """
    nodes = part.tree.nodes
    lemma = nodes[action.place].lemma
    if lemma in part.lexicon.moving:
        pairs = pairwise(phrases)
        return [old for old, new in pairs if new.said.preposition == "to" and old.end == new.first]
    objects = part.tree.children(action.place, "dobj")
    several = [
        thing
        for thing in objects
        for p in part.tree.children(thing, "det")
        if nodes[p].lower in part.lexicon.closed.universal_determiners
    ]
    if lemma not in part.lexicon.doing.dropping or not several:
        return []
    behind = nodes[several[-1]].end + part.offset
    return [phrase for phrase in phrases if behind <= phrase.span[0] <= behind + 1]


def _of_aim(part: Part, phrases: Sequence[Phrase], action: Action) -> list[Phrase]:
    """Give when that is which something else is for: "remind me tonight to call Bob tomorrow"."""
    nodes = part.tree.nodes
    aims = (
        p for p in range(action.place + 2, len(nodes) - 1) if nodes[p].lower == "to" and nodes[p + 1].is_bare
    )
    to = next((nodes[p].start + part.offset for p in aims if nodes[p].head == p + 1), None)
    own = [phrase for phrase in phrases if to is not None and phrase.span[0] < to]
    return [
        phrase for phrase in phrases if phrase not in own and any(_is_another(one, phrase) for one in own)
    ]


def _is_another(first: Phrase, second: Phrase) -> bool:
    """Whether two times both name a day, or both an hour, so that one does not say more of the other."""
    moments = [phrase.said.time for phrase in (first, second) if phrase.said.constraint in MOMENTS]
    walls = [time for time in moments if isinstance(time, Wall)]
    if len(walls) < len(moments) == 2:
        return all(isinstance(time, (Wall, Offset, Duration)) for time in moments)
    both = len(walls) == 2
    return both and any(all(getattr(wall, said) is not None for wall in walls) for said in ("days", "clock"))


def _of_prepared(part: Part, phrases: Sequence[Phrase], action: Action) -> list[Phrase]:
    """Give when that is which is prepared, where another time says when: "the rota for monday by friday"."""
    nodes = part.tree.nodes
    for place, phrase in enumerate(phrases):
        first = next(part.at(phrase.span), None)
        named = first is not None and first > action.place + 1 and nodes[first - 1].tag.startswith("NN")
        if named and phrase.said.preposition == "for" and phrase.said.constraint in {None, Constraint.BEFORE}:
            listed = [phrase, *takewhile(_is_listed, phrases[place + 1 :])]
            others = (other for other in phrases if other not in listed and other.said.preposition != "for")
            return listed if any(_says_when(other) for other in others) else []
    return []


def _of_inner(part: Part, phrases: Sequence[Phrase]) -> list[Phrase]:
    """Give how long a part of it is, where words say of the whole: "from 9 to 11 with a ten minute break"."""
    nodes, found = part.tree.nodes, []
    for phrase in phrases:
        first = next(part.at(phrase.span), 0)
        led, article = ["", "", *(node.lower for node in nodes[:first])][-2:]
        inner = isinstance(phrase.said.time, Duration) and phrase.said.preposition is None
        one = article in part.lexicon.closed.singular_determiners
        if inner and led == "with" and one and len(phrases) > 1:
            found.append(phrase)
    spans = any(isinstance(phrase.said.time, (Range, Duration)) for phrase in phrases if phrase not in found)
    return found if spans else []


def _is_listed(phrase: Phrase) -> bool:
    """Whether it is a day of a list: "for monday, tuesday and friday"."""
    return phrase.said.preposition is None and isinstance(phrase.said.wall.days, Fields)


def _says_when(phrase: Phrase) -> bool:
    """Whether a time says on which day something is done, and is no clock time of another's day."""
    said = phrase.said
    return said.constraint in BOUNDS or (said.wall.days is not None and said.constraint in MOMENTS)


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
    # "The meeting I have tomorrow" is what is counted from; "let that cool for an hour" has no thing.
    before = (p for p in tree.children(verb) if p < verb and tree.nodes[p].relation != "mark")
    things = (p for p in before if tree.nodes[p - 1].tag.startswith(NAMING))
    return any(tree.nodes[p].lower in part.lexicon.closed.relatives for p in things)
