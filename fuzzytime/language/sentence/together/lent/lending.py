"""What the instructions of a text lend each other: a time alone, a verb, an object, a start."""

from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation, overlap
from fuzzytime.language.meaning.expressions import Duration, Offset, Phrase, Repeat, Said, TimeWord
from fuzzytime.language.meaning.joined.distances import HALFWAY, INTO, LATER
from fuzzytime.language.sentence.sketches.sketch import Sketch, text_between
from fuzzytime.language.sentence.together.lent.requested_too import requested_too
from fuzzytime.language.sentence.together.lent.verbs_again import all_again, done_again_of
from fuzzytime.language.sentence.trees.tags import SUBJECTS
from fuzzytime.requirement import Constraint, Reference, Unit

STARTS = frozenset({None, Constraint.AT, Constraint.BETWEEN, Constraint.AFTER})
"""How a time binds that is about the first of two operations done in one go; a deadline is about the last."""


def led(sketches: list[Sketch], text: str) -> list[Sketch]:
    """Give times that stand alone to the order behind them: "not for ten minutes, but then …"."""
    found: list[Sketch] = []
    for sketch in sketches:
        before, segment = found[-1] if found else None, sketch.part.segment
        alone = before is not None and before.operation is None and _is_time_alone(before)
        if before is not None and before.repeats and before.part.segment.connective == "then":
            # "Use it twice a day for a week, then once a day for a week, then stop"
            alone = alone and not found[:-1]
        steps = segment.connective in {"then", "first"}
        if before is not None and alone and (steps or _is_in_front(before, sketch, text)):
            waited = before.phrases
            if steps:
                waited = tuple(replace(phrase, said=_until_then(phrase.said)) for phrase in waited)
            whole = (before.part.segment.span[0], segment.span[1])
            part = replace(sketch.part, segment=replace(segment, span=whole, connective=""))
            found[-1] = replace(sketch.under(waited, before.clauses), part=part)
        else:
            found.append(sketch)
    return found


def _is_in_front(before: Sketch, sketch: Sketch, text: str) -> bool:
    """Whether a comma alone is between a time and what is to be done, or who is asked to do it."""
    between = text_between(before, sketch, text).strip()
    called = sketch.part.segment.addressee
    apart = between == "," or (called is not None and between.lstrip(" ,:").startswith(called))
    return apart and not before.part.segment.connective and sketch.operation is not None


def _is_time_alone(sketch: Sketch) -> bool:
    """Whether nothing but times and clauses is said: not "maths until ten", "home by five"."""
    part, heard, states = sketch.part, sketch.heard, sketch.lexicon.beside.states
    names = (node for node in part.tree.nodes if node.tag.startswith("NN") or node.lower in states)
    return bool(heard) and all(any(overlap(part.span(name), span) for span in heard) for name in names)


def _until_then(said: Said) -> Said:
    """Read a length of time alone before "then" as what is waited: "two minutes, then flip"."""
    alone = said.preposition is None and isinstance(said.time, Duration)
    return replace(said, constraint=Constraint.AT, preposition="in") if alone else said


def repeated(sketches: list[Sketch], text: str) -> list[Sketch]:
    """Let a time or a thing alone be of what was done before: "then five minutes on high"."""
    found: list[Sketch] = []
    for sketch in sketches:
        several = all_again(found, sketch, text)
        if several is not None:
            found = several
            continue
        before = _done_before(found, sketch)
        again = None if before is None else done_again_of(before, sketch, text)
        if again is None:
            found.append(sketch)
            continue
        requested = requested_too(found[-1], sketch, again, text)
        if requested is not None:
            found[-1:] = requested
            continue
        then = sketch.part.segment.connective == "then"
        phrases = tuple(_from_then(p, found[-1]) if then else p for p in sketch.phrases)
        found.append(replace(sketch, operation=again, phrases=phrases))
    return found


def _done_before(found: list[Sketch], sketch: Sketch) -> Operation | None:
    """Give what was done last; "stew on at one, stir at two, off at five" turns off what was on."""
    last, particles = found[-1].operation if found else None, sketch.lexicon.particles
    first = next((node.lower for node in sketch.part.tree.nodes), "")
    if last is None or first not in particles or last.lemma in particles[first] - sketch.lexicon.addressing:
        return last
    done = (before.operation for before in reversed(found) if before.operation is not None)
    turned = (one for one in done if one.particle or (one.due is not None and one.place in particles))
    return next(turned, last)


def _from_then(phrase: Phrase, before: Sketch) -> Phrase:
    """Let a repetition begin where that of the same before it ends: "every 5 minutes for an hour, then …"."""
    time = phrase.said.time
    ends = [p.said.time.until for p in before.phrases if isinstance(p.said.time, Repeat)]
    if (
        not isinstance(time, Repeat)
        or time.starting is not None
        or time.every is None
        or ends[:1] in ([], [None])
    ):
        return phrase
    starting = Offset(time.every, 1, ends[0])
    until = time.until
    if isinstance(until, Offset) and until.anchor is None:
        # "…, then twice a day for another week"
        until = replace(until, anchor=ends[0])
    return phrase.at(replace(time, starting=starting, until=until))


def within(sketches: list[Sketch], text: str) -> list[Sketch]:
    """Let times count from the start of what lasts: "roast it for an hour and turn it after ten minutes".

    What goes on beside it has its object ("bake the bread for an hour, turning it"), and what happens to the
    same thing next is stated too ("the roast goes in at ten and comes out at two").
    """
    found = sketches[:1]
    for sketch in sketches[1:]:
        before, told = found[-1], sketch
        apart = sketch.part.segment.entry
        if not apart and before.operation is not None and sketch.operation is not None:
            between = text_between(before, sketch, text)
            joined = between.strip(" ,").lower() == "and"
            operation = _beside(before.operation, sketch, sketch.operation, joined=joined)
            told = replace(sketch, operation=operation)
        if sketch.part.segment.connective != "then":
            length = _length(before)
            told = replace(told, phrases=tuple(_counted_in(phrase, length) for phrase in told.phrases))
        found.append(told)
    return [replace(sketch, phrases=tuple(map(_halfway, sketch.phrases))) for sketch in found]


def _halfway(phrase: Phrase) -> Phrase:
    """Let what is halfway through something else count from that."""
    time = phrase.said.time
    if not isinstance(time, TimeWord) or time.word != HALFWAY:
        return phrase
    return replace(phrase, said=Said(Offset(Duration(((0, Unit.SECOND),))), None, HALFWAY))


def _length(sketch: Sketch) -> float:
    """Give how long an instruction was said to last, in seconds; 0 where nothing was said."""
    lengths = (p.said.time for p in sketch.phrases if p.said.constraint is Constraint.FOR)
    return next((time.seconds for time in lengths if isinstance(time, Duration)), 0.0)


def _beside(before: Operation, sketch: Sketch, operation: Operation, *, joined: bool) -> Operation:
    """Give an operation with the object of the one before, which it is about too."""
    doing = sketch.lexicon.doing
    tree = sketch.part.tree
    if operation.object is not None or not tree.nodes:
        return operation
    node = tree.nodes[tree.root]
    alone = not sketch.times
    begins = before.stated and before.lemma in doing.beginning_or_being and bool(sketch.phrases)
    if before.object is None or before.attended:
        # "We're on at nine and play for an hour"; but "I'm out at noon, feed the cat"
        goes_on = begins and (alone or operation.lemma in doing.ending) and joined and not operation.stated
        # "We leave at eight and get back at six"
        comes = before.stated and before.lemma != "be" and not before.attended and bool(sketch.phrases)
        goes_on = goes_on or (comes and joined and not operation.stated)
        return replace(operation, object=before.object, stated=True) if goes_on else operation
    if before.stated and tree.children(tree.root, *SUBJECTS):
        # "The show starts at two and I must dance"
        return operation
    if before.stated and joined and not operation.stated and node.tag in {"VBZ", "VB", "VBP"}:
        return replace(operation, object=before.object, stated=True)
    # "Would you mind turning it down and locking up": either is an order of its own.
    goes_on = node.tag == "VBG" and not before.stated and not operation.stated
    goes_on = goes_on and before.verb == before.lemma
    return replace(operation, object=before.object) if goes_on else operation


def _counted_in(phrase: Phrase, length: float) -> Phrase:
    """Give a time that lies inside what lasts as one from its start."""
    said = phrase.said
    time = said.time.duration if isinstance(said.time, Offset) and said.time.anchor is None else said.time
    if isinstance(time, TimeWord) and time.word == HALFWAY and length:
        time = Duration(((length / 2, Unit.SECOND),))
    elif not isinstance(time, Duration) or said.preposition not in {"after", LATER}:
        return phrase
    if said.constraint is Constraint.FOR or not time.seconds < length:
        return phrase
    return replace(phrase, said=Said(Offset(replace(time, hedges=())), None, INTO, said.hedges))


def shared(sketches: list[Sketch], text: str) -> list[Sketch]:
    """Let a verb alone share the object and the start of the next: "rinse and drain the rice at noon"."""
    found = list(sketches)
    for place in range(len(found) - 1, 0, -1):
        first, second = found[place - 1], found[place]
        if not second.part.segment.shares(text) or first.operation is None or second.operation is None:
            continue
        if second.operation.lemma == "be":
            # "Shower, and be downstairs in twenty minutes": by then one is there.
            continue
        operation = first.operation
        if operation.object is None and not _is_apart(operation, second.operation, first.lexicon):
            operation = replace(operation, object=second.operation.object)
        first = replace(first, operation=operation)
        goes_on = Reference.THROUGHOUT in second.references
        # "Cover and leave it overnight"
        if (
            not first.phrases
            and not goes_on
            and all(phrase.said.constraint in STARTS for phrase in second.phrases)
        ):
            first = replace(first, phrases=second.phrases, references=second.references)
            second = second.without_times()
        found[place - 1 : place + 1] = [first, second]
    return found


def _is_apart(first: Operation, second: Operation, lexicon: Lexicon) -> bool:
    """Whether orders have no thing in common: "shower and call a cab"; but "dust and wipe the desk"."""
    chores = (lexicon.chores | lexicon.doing.naming_nothing) - lexicon.intransitive
    return first.lemma in lexicon.needing_nothing and not {first.lemma, second.lemma} <= chores
