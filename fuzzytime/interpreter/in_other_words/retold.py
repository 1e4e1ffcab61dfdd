"""Instructions in other words: two ends as start and length, one occurrence of many, the way somewhere."""

import math
from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from datetime import datetime

from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.interpreter.joining import both
from fuzzytime.language import Instruction, Lexicon, Operation, Reading, find_times
from fuzzytime.language.instruction import Span
from fuzzytime.requirement import Anchor, Constraint, Edge, Reference, TimeRequirement
from fuzzytime.satisfaction import Rectangle
from fuzzytime.skills import Precedence

RIGHT_THEN = "exactly"
"""How near what somebody goes to follows the way there."""

A_DAY = 86400.0
FROM, BETWEEN, UNTIL = "from", "between", "until"


def behind_ends(skills: Sequence[Interpreted], entries: Iterable[Precedence]) -> list[Interpreted]:
    """Let skills begin no sooner than until when those before them go on: "mop until ten, then rest".

    Where that would leave one no time, it keeps those it has.
    """
    found = list(skills)
    for entry in entries:
        until, second = found[entry.first].skill.until, found[entry.second].skill
        if until is None or entry.minimum_lag < 0:
            continue
        function = both(second.satisfaction, Rectangle(until + entry.minimum_lag, math.inf))
        if not function.support.empty:
            skill = replace(second, satisfaction=function)
            found[entry.second] = replace(found[entry.second], skill=skill)
    return found


def waiting_until(instruction: Instruction, lexicon: Lexicon) -> Instruction:
    """Let who waits until a time be there then: "wait until eight"."""
    operation = instruction.operation
    if operation is None or operation.lemma not in lexicon.doing.waiting or operation.object is not None:
        return instruction
    if instruction.duration is not None:
        return instruction
    requirements = tuple(
        replace(part, constraint=Constraint.AT, reference=Reference.FINISH, earliest=part.latest)
        if _is_until(part)
        else part
        for part in instruction.requirements
    )
    return replace(instruction, requirements=requirements)


def until_then(instruction: Instruction, lexicon: Lexicon) -> float | None:
    """Give until when goes on what is asked for: "play jazz until ten", but "post the letter until ten".

    None where how long it takes is said, or nothing says when it is over.
    """
    operation = instruction.operation
    if operation is None or not operation.is_asked or instruction.duration is not None:
        return None
    if operation.lemma in lexicon.doing.by_then:
        return None
    whole = lexicon.beside.all_through
    if operation.lemma in lexicon.doing.left_overnight | lexicon.letting | lexicon.timing:
        # "Incubate overnight", "let it dry overnight"; but "run the dishwasher overnight"
        whole |= lexicon.beside.through_the_night
    ends = [
        part.latest
        for part in instruction.requirements
        if ((_is_until(part) and part.constraint is Constraint.BEFORE) or _is_all_through(part, whole))
        and part.reference is not Reference.FINISH
        and not part.alternative
    ]
    return ends[0] if len(ends) == 1 else None


def from_then_on(instruction: Instruction, lexicon: Lexicon, mornings: Collection[float]) -> Instruction:
    """Let a step that is left to itself overnight be so from the step before on: "2. Chill it overnight".

    It is the night behind those that other steps take up, until some ``mornings``.
    """
    said = instruction.requirements
    end = until_then(instruction, lexicon)
    if end is None or len(said) != 1 or not _is_all_through(said[0], lexicon.beside.through_the_night):
        return instruction
    end += A_DAY * sum(morning >= end for morning in set(mornings))
    until = replace(
        said[0], constraint=Constraint.BEFORE, preposition=UNTIL, earliest=None, latest=end, t_spec=end
    )
    return replace(instruction, requirements=(until,))


def from_to(instruction: Instruction, reading: Reading, given: datetime, lexicon: Lexicon) -> Instruction:
    """Take two ends as a start and a length: "I have a meeting from two to four", "paint from two to four".

    "Between two and four" leaves open when in between something is done, and "sometime between two and four"
    when it happens, too. What a reading asks for in the same stretch shares it: "4:00-4:10 unpack, wash and
    change".
    """
    operation, requirements = instruction.operation, list(instruction.requirements)
    if operation is None or instruction.duration is not None:
        return instruction
    if any(part.alternative for part in requirements):
        # "From two to four or from six to seven" leaves open how long.
        return instruction
    for place, part in enumerate(requirements):
        if part.preposition != BETWEEN or part.earliest is None or part.latest is None:
            continue
        # What a line above says is when all below it is, and how long none of that.
        own = part.span[0] < part.span[1]
        asked = not operation.stated
        if asked and (not own or part.reference is not Reference.START):
            continue
        if _says_ends(part, given, lexicon, asked=asked):
            begin, length = part.earliest, part.latest - part.earliest
            within = _asked_in(part.span, reading) if asked else []
            if operation.span in within:
                length /= len(within)
                begin += within.index(operation.span) * length
            requirements[place] = replace(part, constraint=Constraint.AT, t_spec=begin, latest=begin)
            return replace(instruction, requirements=tuple(requirements), duration=length)
    if operation.stated:
        instruction = replace(instruction, requirements=tuple(map(_beginning, instruction.requirements)))
    # "I'm out until four", "Anna sleeps till nine"
    return _until(instruction) if operation.stated and not operation.negated else instruction


def _asked_in(span: Span, reading: Reading) -> list[Span]:
    """Give what a reading asks for in one stretch, in order, where nothing says how long any of it takes."""
    found = (
        one.operation.span
        for one in reading.instructions
        if one.operation is not None and one.operation.is_asked and one.duration is None
        if any(part.span == span for part in one.requirements)
    )
    return list(dict.fromkeys(found))


def _says_ends(part: TimeRequirement, given: datetime, lexicon: Lexicon, *, asked: bool) -> bool:
    """Whether a time is two ends, perhaps behind its day: "from two to four", "tomorrow 2-4".

    Of what is not ``asked`` for they may stand behind "between".
    """
    words = part.text.lower().split()
    opens = (place for place, word in enumerate(words) if _opens_ends(word, lexicon))
    first = next(opens, None) if asked else words.index(BETWEEN) if BETWEEN in words else 0
    day = " ".join(part.text.split()[:first])
    if not first:
        return first is not None
    times = find_times(day, given, lexicon).requirements
    return [(time.text, time.constraint) for time in times] == [(day, Constraint.BETWEEN)]


def _opens_ends(word: str, lexicon: Lexicon) -> bool:
    return word == FROM or word[0].isdigit() or word in lexicon.numbers


def _beginning(part: TimeRequirement) -> TimeRequirement:
    """Let what happens from a time on begin then: "rain from seven"."""
    if part.preposition != FROM or part.constraint is not Constraint.AFTER or part.t_spec is None:
        return part
    return replace(part, constraint=Constraint.AT, latest=part.t_spec)


def _until(instruction: Instruction) -> Instruction:
    """Let what is so until a time be so from now on, or from the hour, or the day, that is said."""
    ends = [part for part in instruction.requirements if part.preposition == UNTIL and part.anchor is None]
    days = [part for part in instruction.requirements if part not in ends]
    if len(ends) != 1 or ends[0].latest is None or any(part.anchor is not None for part in days):
        return instruction
    last = ends[0].latest
    if any(part.earliest is None or part.latest is None for part in days):
        return instruction
    # "Football at four till five"
    hours = [part for part in days if part.constraint is Constraint.AT]
    if any(part.latest is not None and last > part.latest for part in days if part not in hours):
        return instruction
    begin = max((part.earliest or 0.0 for part in days), default=0.0)
    if not 0 <= begin < last:
        return instruction
    whole = replace(ends[0], constraint=Constraint.AT, reference=Reference.START, t_spec=begin)
    whole = replace(whole, earliest=begin, latest=begin, unit=None, number=None)
    if hours and hours[0].span[1] < whole.span[0]:
        said = " ".join(part.text for part in (hours[0], whole))
        whole = replace(whole, text=said, span=(hours[0].span[0], whole.span[1]))
    return replace(instruction, requirements=(whole,), duration=last - begin)


def _is_until(part: TimeRequirement) -> bool:
    """Whether it tells until what time, and not until what else is over."""
    return part.preposition == UNTIL and part.anchor is None and part.latest is not None


def _is_all_through(part: TimeRequirement, whole: Collection[str]) -> bool:
    """Whether it is all of what is left of a part of a day: "all morning", "the rest of the afternoon"."""
    if part.constraint is not Constraint.BETWEEN or part.earliest is None or part.latest is None:
        return False
    said = part.latest - part.earliest <= A_DAY and part.recurrence is None
    text = f" {part.text.lower()} "
    return said and any(f" {form} " in text for form in whole)


def occurrence(repeated: TimeRequirement, start: float, end: float) -> TimeRequirement:
    """Give one occurrence of a repetition as a requirement of its own: at its time, or anywhere in it.

    It keeps the series, and the grain that its words have: both say how finely the time is meant.
    """
    moment = start == end
    return replace(
        repeated,
        constraint=Constraint.AT if moment else Constraint.BETWEEN,
        t_spec=start if moment else None,
        earliest=start,
        latest=end,
        number=None,
    )


def amid_its_hours(
    operation: Operation | None, requirements: Sequence[TimeRequirement], given: float
) -> tuple[float, ...]:
    """Give the middle of its hours for a meal that a line names alone: "lunch"."""
    if operation is None or not operation.stated or len(requirements) != 1:
        return ()
    (hours,) = requirements
    alone = hours.text.lower() == (operation.object or "").lower()
    if not alone or hours.earliest is None or hours.latest is None:
        return ()
    return (given + (hours.earliest + hours.latest) / 2,)


def turn(
    repeated: TimeRequirement, target: int, edge: Edge, lag: float, *, of: int | None = None
) -> TimeRequirement:
    """Give one turn of a repetition that is counted from an edge of what another instruction asks for.

    Parameters
    ----------
    repeated
        Says how often.
    target, edge
        The position of that instruction among all, and which of its ends is counted from.
    lag
        How long after it this turn is, in seconds.
    of
        Which turn of that instruction is counted from, if it has several.
    """
    anchor = Anchor(text=repeated.text, target=target, edge=edge, lag=lag, exact=True, turn=of)
    return replace(
        repeated, constraint=Constraint.AFTER, anchor=anchor, earliest=None, latest=None, number=None
    )


def going_to(instruction: Instruction, name: str, target: int, *, attended: bool) -> Instruction:
    """Give the instruction to go where something is done or happens, in time for that.

    Parameters
    ----------
    instruction
        Tells how long the way takes.
    name, target
        What somebody goes to, and its position among all instructions.
    attended
        Whether who speaks takes part in it.
    """
    operation = Operation(
        verb="travel",
        lemma="travel",
        span=instruction.span,
        object=f"the way to {name}" if attended else None,
        complement=None if attended else f"to {name}",
        stated=attended,
        attended=attended,
    )
    before = TimeRequirement(
        text=f"in time for {name}",
        span=instruction.span,
        constraint=Constraint.BEFORE,
        reference=Reference.FINISH,
        reference_said=True,
        fuzziness=(RIGHT_THEN,),
        anchor=Anchor(text=name, target=target, edge=Edge.START, exact=True),
    )
    length = instruction.way or 0.0
    return replace(
        instruction, operation=operation, duration=length, requirements=(before,), length_of=None, way=None
    )
