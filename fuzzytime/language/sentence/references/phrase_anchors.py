"""Times that count from another instruction without a clause: "before dinner", "ten minutes later"."""

from collections.abc import Sequence
from dataclasses import replace
from datetime import timedelta

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation, Remark, RemarkKind
from fuzzytime.language.meaning.days.relations import Relative
from fuzzytime.language.meaning.expressions import Edge as Bound
from fuzzytime.language.meaning.expressions import Offset, Phrase, Repeat, Said, TimeWord, Wall, wall_of
from fuzzytime.language.meaning.joined.distances import EARLIER, HALFWAY, INTO, LAST, LATER, LEFT
from fuzzytime.language.meaning.joined.first_times import closing_of, opening_of
from fuzzytime.language.meaning.times_of_day import Part
from fuzzytime.language.sentence.clauses.before_markers import OF
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.references.anchors import Anchors, only_counted
from fuzzytime.language.sentence.references.mentions import waits_for
from fuzzytime.language.sentence.references.same_thing import (
    is_about_the_same,
    since_the_same,
    tells_length_of,
)
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.requirement import Anchor, Constraint, Edge, TimeRequirement

AT_THE_END = "at the end"
"""The time word that is about the end of what goes on."""

IN_BETWEEN = "in between"
"""The time word that is about what was said before, and what comes behind that."""

LEAST = 2
"""What something is in between, where it comes before that, at least."""

ORDERING = {
    "afterwards": Constraint.AFTER,
    "right afterwards": Constraint.AFTER,
    "shortly afterwards": Constraint.AFTER,
    AT_THE_END: Constraint.AFTER,
    IN_BETWEEN: Constraint.AFTER,
    "beforehand": Constraint.BEFORE,
    "right beforehand": Constraint.BEFORE,
    "then": Constraint.AT,
    "meanwhile": Constraint.AT,
    "each time": Constraint.AT,
}
"""The time words that are about the instruction before it."""

NEAR = {
    "right afterwards": "right after",
    "shortly afterwards": "shortly after",
    "right beforehand": "right before",
}
"""The hedges of those that say how near to it."""

HOUR = "time"
"""The end of the name of when a meal is: "lunchtime"."""

INSIDE = frozenset({LEFT, LAST, HALFWAY})
"""The prepositions of times that are inside something else, and nothing without that."""

LISTED = frozenset({INTO, EARLIER})
"""The prepositions of which several in a list count from the same."""

COUNTED: dict[str | None, Constraint] = {
    LATER: Constraint.AFTER,
    EARLIER: Constraint.BEFORE,
    INTO: Constraint.AFTER,
    LEFT: Constraint.AFTER,
}
"""The prepositions that count from the instruction before: "ten minutes later", "ten minutes before that"."""


def counts_from_nothing(
    requirement: TimeRequirement, said: Said, operation: Operation | None, position: int
) -> bool:
    """Whether a time is inside something, or before it, and nothing was said: "remind me a day before"."""
    if requirement.anchor is not None or requirement.constraint is Constraint.FOR:
        return False
    asked = operation is not None and not operation.stated
    day_before = position == 0 and is_day_before(said)
    return (
        requirement.preposition in INSIDE
        or is_in_the_end(said)
        or (asked and (day_before or requirement.preposition == EARLIER))
    )


def is_day_before(said: Said) -> bool:
    """Whether it is on a day before the one that was said: "the day before", "the previous evening"."""
    days = said.wall.days
    return isinstance(days, Relative) and days.onward and days.days < 0


def of_phrase(
    anchors: Anchors, phrase: Phrase, requirement: TimeRequirement, clauses: Sequence[Clause]
) -> TimeRequirement:
    """Give a requirement of the grammar as a reference, where it is one; ``clauses`` stand beside it."""
    if is_in_the_end(phrase.said):
        return _in_the_end(anchors, phrase.said, requirement, clauses)
    found = _meal(anchors, phrase, requirement) or _later(anchors, phrase, requirement)
    found = found or since_the_same(anchors, phrase.said, requirement)
    found = found or _at_the_beginning(anchors, phrase.said, requirement)
    return found or _upon_arrival(anchors, requirement) or requirement


def _at_the_beginning(anchors: Anchors, said: Said, requirement: TimeRequirement) -> TimeRequirement | None:
    """Read "for the first hour" as counted from the start of what goes on, and so what is repeated in it.

    "Simmer it for three hours, stir it every ten minutes for the first hour".
    """
    target = anchors.said_to_last()
    if target is None or requirement.anchor is not None:
        return None
    anchor = Anchor(text=requirement.text, target=target, edge=Edge.START)
    if opening_of(said) is not None and requirement.latest is not None:
        return only_counted(requirement, replace(anchor, lag=requirement.latest), Constraint.BETWEEN)
    time = said.time
    turns = isinstance(time, Repeat) and time.every is not None and time.starting is None
    ends = turns and isinstance(time, Repeat) and isinstance(time.until, Offset) and time.until.anchor is None
    return replace(requirement, anchor=anchor) if ends and is_about_the_same(anchors, target) else None


def _upon_arrival(anchors: Anchors, requirement: TimeRequirement) -> TimeRequirement | None:
    """Count "within an hour" from when that comes which it is about: "the truck comes at ten, …"."""
    operation = anchors.operation_at(anchors.position)
    if requirement.preposition != "within" or requirement.t_spec is None or operation is None:
        return None
    for place, happening in anchors.just_before():
        beside = (
            anchors.first <= place == anchors.position - 1 and happening.lemma == "be" and happening.stated
        )
        if beside and operation.due is not None:
            # "A table of twelve at 7:15, starters must go within ten minutes": from then on.
            anchor = Anchor(text=requirement.text, target=place, edge=Edge.START, lag=requirement.t_spec)
            return only_counted(requirement, anchor, Constraint.BETWEEN)
        if waits_for(operation, happening, anchors.lexicon):
            anchor = Anchor(text=requirement.text, target=place, lag=requirement.t_spec)
            return only_counted(requirement, anchor, Constraint.BETWEEN)
    return None


def _meal(anchors: Anchors, phrase: Phrase, requirement: TimeRequirement) -> TimeRequirement | None:
    """Read "before dinner", "an hour before dinner" as a reference where another makes that dinner."""
    time, constraint, lag = phrase.said.time, phrase.said.constraint, 0.0
    if isinstance(time, Offset) and time.anchor is not None:
        lag = time.direction * time.duration.seconds
        time, constraint = time.anchor, Constraint.BEFORE if lag < 0 else Constraint.AFTER
    part = wall_of(time).part
    dated = isinstance(time, Wall) and time.days not in {None, anchors.day}
    if part is not None and not part.meal and part.name.endswith(HOUR):
        # "Call her at lunchtime"
        part = replace(part, name=part.name.removesuffix(HOUR), meal=True)
    beside = requirement.text.split()[0].lower() in anchors.lexicon.closed.prepositions_of_duration
    if phrase.said.beside:
        constraint = Constraint.BEFORE if phrase.said.edge is Bound.START else Constraint.AFTER
    if part is None or not part.meal or part.place:
        return None
    if not beside and constraint not in {Constraint.BEFORE, Constraint.AFTER}:
        return None
    when = requirement.t_spec if requirement.t_spec is not None else requirement.latest
    target = _meal_told(anchors, part, (when or 0.0) - lag, dated=dated)
    if target is None:
        return None
    constraint = Constraint.AT if beside or constraint is None else constraint
    edge = Edge.END if constraint is Constraint.AFTER else Edge.START
    just = phrase.said.beside and constraint is Constraint.BEFORE
    anchor = Anchor(
        text=part.name, object=part.name, target=target, edge=edge, lag=lag, exact=lag != 0 or just
    )
    return only_counted(requirement, anchor, constraint)


def _meal_told(anchors: Anchors, part: Part, when: float, *, dated: bool) -> int | None:
    """Give the position of what tells of a meal, by any of its names: before this one, or else behind it.

    In so many seconds it is, as far as its name tells; ``dated`` says that its day is said.
    """
    names = _names_of(part, anchors.lexicon)
    own = [
        anchors.first + place
        for place, operation in enumerate(anchors.own)
        if operation is not None and any(words <= content_words(operation.object) for words in names)
    ]
    before = (anchors.mentions.about(words, anchors.first) for words in names)
    told = [place for place in own if place != anchors.position]
    told = told or [place for place in before if place is not None]
    target, sure = max(told, default=None), not dated
    if target is None and anchors.awaits:
        # "Remind Sam ten minutes before lunch", where the next line says when that is.
        behind = anchors.first + len(anchors.own)
        places = (anchors.mentions.told_behind(words, behind) for words in names)
        target, sure = min((place for place in places if place is not None), default=None), False
    if target is None or sure:
        return target
    start = anchors.mentions.told.start(target)
    meant = None if anchors.now is None else anchors.now + timedelta(seconds=when)
    # "Lunch tomorrow is at three" is another lunch.
    elsewhen = start is not None and meant is not None and start.date() != meant.date()
    return None if elsewhen or (dated and start is None) else target


def _names_of(part: Part, lexicon: Lexicon) -> list[frozenset[str]]:
    """Give the words of each name of a meal: dinner is supper, too."""
    entries = (entry for entries in lexicon.entries.values() for entry in entries)
    others = (content_words(" ".join(entry.words)) for entry in entries if entry.value == part)
    return list(dict.fromkeys([content_words(part.name), *others]))


def _later(anchors: Anchors, phrase: Phrase, requirement: TimeRequirement) -> TimeRequirement | None:
    """Read "ten minutes later" as a distance from the instruction before, in the same text or another.

    "Afterwards" is after it and "before that" before it, at whatever distance.
    """
    time = phrase.said.time
    if isinstance(time, TimeWord) and time.word in ORDERING and anchors.position > 0:
        constraint = ORDERING[time.word]
        edge = Edge.END if constraint is Constraint.AFTER else Edge.START
        target = anchors.going_on() if time.word == AT_THE_END else anchors.position - 1
        if time.word == IN_BETWEEN and anchors.position - LEAST >= anchors.first and _ends_text(anchors):
            target = anchors.position - LEAST
        beside = NEAR.get(time.word)
        anchor = Anchor(text=requirement.text, target=target, edge=edge, exact=beside is not None)
        fuzziness = requirement.fuzziness if beside is None else (beside,)
        return only_counted(replace(requirement, word=None, fuzziness=fuzziness), anchor, constraint)
    if phrase.said.preposition == HALFWAY and anchors.position > 0:
        anchor = Anchor(text=requirement.text, target=anchors.going_on(), share=0.5, exact=True)
        return only_counted(requirement, anchor, Constraint.AFTER)
    side = COUNTED.get(phrase.said.preposition) if isinstance(time, Offset) and time.anchor is None else None
    # "Remind me a day before and an hour before"
    before = anchors.before_list() if phrase.said.preposition in LISTED else anchors.position - 1
    if phrase.said.preposition == LATER:
        before = anchors.position - 1
    own = anchors.operation_at(anchors.position)
    if phrase.said.preposition == EARLIER and own is not None and phrase.span[1] <= own.span[0]:
        before = anchors.counted_down_from()
    if side is None or before < 0:
        return None
    edge = Edge.START if side is Constraint.BEFORE or phrase.said.preposition == INTO else Edge.END
    lag = requirement.t_spec or 0.0
    target = anchors.going_on() if phrase.said.preposition == LEFT else before
    if phrase.said.preposition == LATER and lag and tells_length_of(anchors, target):
        edge = Edge.FREE
    bounded = phrase.said.constraint in {Constraint.BEFORE, Constraint.AFTER}
    anchor = Anchor(text=requirement.text, target=target, edge=edge, lag=lag, exact=not bounded)
    return only_counted(requirement, anchor, requirement.constraint if bounded else side)


def _ends_text(anchors: Anchors) -> bool:
    """Whether nothing comes behind two with their times: "meetings at ten and two, lunch in between"."""
    timed = all(anchors.told.start(anchors.position - back) is not None for back in range(1, LEAST + 1))
    return timed and anchors.position - anchors.first == len(anchors.own) - 1


def of_nothing(requirement: TimeRequirement, said: Said) -> Remark:
    """Point at a time that is inside something, or before it, where nothing of that was said."""
    message = f"{requirement.text!r} is about an instruction before it, and none was given so far"
    if is_in_the_end(said):
        message = f"{requirement.text!r} is the end of something, and what goes on until then is not said"
    return Remark(RemarkKind.NOT_UNDERSTOOD, requirement.span, message)


def of_the_beginning(requirement: TimeRequirement) -> Remark:
    """Point at the beginning of what is done itself, which says nothing of when that is."""
    message = f"{requirement.text!r} is of the beginning of what is done, and not when to do it"
    return Remark(RemarkKind.POLICY, requirement.span, message)


def is_in_the_end(said: Said) -> bool:
    """Whether it is in the end of something: "for the last ten minutes", "every minute for the last hour"."""
    closing = isinstance(said.time, Repeat) and said.time.closing is not None
    return closing or said.preposition == LAST


def _in_the_end(
    anchors: Anchors, said: Said, requirement: TimeRequirement, clauses: Sequence[Clause]
) -> TimeRequirement:
    """Read "for the last hour (of baking)" as counted back from the end of that, or of what goes on."""
    length = said.time.closing if isinstance(said.time, Repeat) else closing_of(said)
    named = next((clause for clause in clauses if clause.marker == OF), None)
    target = anchors.said_to_last() if named is None else anchors.target_of(named)
    unknown = target is None and named is None
    if length is None or unknown or requirement.constraint is Constraint.FOR:
        return requirement
    lasted = None if target is None or named is not None else anchors.told.length(target)
    # "Headstand 3 min", "lie down for the last ten": what is shorter is over, and this ends all.
    inside = lasted is None or lasted > length.seconds
    lag = -length.seconds if inside else 0.0
    anchor = Anchor(text=requirement.text, target=target, edge=Edge.END, lag=lag, exact=inside)
    if requirement.recurrence is not None:
        return replace(requirement, anchor=anchor)
    return only_counted(requirement, anchor, Constraint.AFTER)
