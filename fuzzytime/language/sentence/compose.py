"""The second pass: sketches grounded, their references resolved, put together as a reading."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.finding import Times, ground_all
from fuzzytime.language.grammar.leftovers.leftovers import leftovers
from fuzzytime.language.instruction import Instruction, Operation, Question, Reading, Remark, RemarkKind, Span
from fuzzytime.language.meaning.grounded.moment import Moment
from fuzzytime.language.meaning.joined.first_times import opening_of
from fuzzytime.language.meaning.required.requirements import Grounded
from fuzzytime.language.sentence.asked_for import asked_of
from fuzzytime.language.sentence.references.anchors import Anchors
from fuzzytime.language.sentence.references.mentions import Mentions
from fuzzytime.language.sentence.references.phrase_anchors import is_day_before
from fuzzytime.language.sentence.references.told import Told
from fuzzytime.language.sentence.required import required_of
from fuzzytime.language.sentence.segments.connectives import (
    anchored_by_connective,
    led_by_denial,
    led_by_nothing,
)
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.lists.things_needed import needed
from fuzzytime.language.sentence.segments.segment import Segment
from fuzzytime.language.sentence.segments.told.asides import Aside
from fuzzytime.language.sentence.sketches.around_events.days_of_events import on_days_of_events
from fuzzytime.language.sentence.sketches.meaning.alternatives import offered
from fuzzytime.language.sentence.sketches.meaning.both_sides import between_sides
from fuzzytime.language.sentence.sketches.meaning.clock_times import NOTHING, LastSaid, last_said
from fuzzytime.language.sentence.sketches.meaning.negations import awaiting, without_denial
from fuzzytime.language.sentence.sketches.meaning.usual_hours import at_usual_hours
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.together.days.headings import day_above, read_heading
from fuzzytime.language.sentence.together.days.windows import window_above
from fuzzytime.language.sentence.together.moments import moment_of
from fuzzytime.language.sentence.together.none_of_it.how_much import uncounted
from fuzzytime.language.sentence.together.none_of_it.named_whole import named_whole
from fuzzytime.language.sentence.together.none_of_it.naming import naming_none, unknown_moments
from fuzzytime.language.sentence.together.none_of_it.orders_again import denied_together
from fuzzytime.language.sentence.together.none_of_it.unused import unused_front, unused_words
from fuzzytime.language.sentence.together.sketches import sketches_of
from fuzzytime.language.sentence.together.times.behind_the_same import behind_the_same
from fuzzytime.language.sentence.together.times.for_all import said_for_all
from fuzzytime.language.sentence.together.told.lengths import (
    due_when_needed,
    length_of,
    lengths_in_front,
    second_ones,
    time_of,
    told_alone,
    unknown_length,
    waited,
)
from fuzzytime.language.sentence.together.told.reasons_told import behind_consequences
from fuzzytime.language.sentence.together.told.told_beside import due_before
from fuzzytime.language.sentence.tokens import tokens_of
from fuzzytime.requirement import Anchor, Edge, TimeRequirement


def composed(
    draft: Draft, mentions: Mentions, first: int, *, awaits: bool = False, since: LastSaid = NOTHING
) -> Reading:
    """Put a reading together; ``first`` of the operations were given before the text.

    Where it ``awaits`` them, those behind its own may be meant too. ``since`` is what the
    text before it said last.
    """
    if draft.leads:
        return read_heading(draft)
    if draft.needed:
        return Reading(text=draft.text, now=draft.now, instructions=(), remarks=(needed(draft.text),))
    reading = _Composer(draft, mentions, first, awaits=awaits, since=since).reading()
    whole = named_whole(draft, reading)
    return (
        reading if whole is None else _Composer(whole, mentions, first, awaits=awaits, since=since).reading()
    )


class _Composer:
    def __init__(
        self, draft: Draft, mentions: Mentions, first: int, *, awaits: bool, since: LastSaid
    ) -> None:
        self.draft = draft
        self.moment = Moment(
            draft.now,
            since.policy(draft.lexicon.policy),
            since=since.since,
            released=since.due_since,
            carried=since.clock is not None,
            in_order=since.in_order,
            begun=since.may_be_over,
            opened=since.opened,
            day=since.day,
            ahead=since.ahead,
            night=since.night,
            window=window_above(draft),
        )
        self.usual = since.usual or since.clock is None
        self.mentions = mentions
        self.first = first
        self.awaits = awaits
        self.remarks: list[Remark] = list(draft.remarks)
        self.questions: list[Question] = []
        self.told = Told(mentions.told)
        self.made: list[Instruction] = []
        self.explained: list[Span] = [said.span for said in draft.phrases]
        self.explained += [remark.span for remark in draft.remarks]
        self.explained += [told.whom for told in draft.messages if told.whom is not None]
        self.explained += [draft.entry.span] if draft.entry is not None else []

    def reading(self) -> Reading:
        """Read every part, then resolve what parts say of each other."""
        sketches, remarks = sketches_of(self.draft)
        sketches = waited(sketches, self.draft.asides, self.mentions.operations[: self.first])
        self.remarks += remarks
        sketches, remarks = denied_together(sketches, self.draft.text)
        self.remarks += remarks
        sketches, remarks = asked_of(sketches, self.draft, self.mentions, self.first)
        self.remarks += remarks
        sketches = said_for_all(sketches, self.draft.text)
        sketches = due_before(sketches, self.draft.text, self.mentions, self.first)
        operations = [sketch.operation for sketch in sketches]
        instructions = self.made
        for place, sketch in enumerate(sketches):
            self.moment = moment_of(self.moment, sketches, place, instructions, self.draft, usual=self.usual)
            instructions.append(self._instruction(sketch, self.first + place, operations))
            self.told.add(self.first + place, instructions[-1], self.draft.now)
        instructions = behind_consequences(instructions, sketches, self.draft.text, self.first)
        if sketches:
            first = sketches[0].part.segment.span[0]
            self.remarks += lengths_in_front(self.draft.asides, first, self.draft.text)
        else:
            for aside in self.draft.asides[:1]:
                instructions.append(told_alone(aside, self.draft.text, self.first, self.moment))
                self.remarks += unknown_length(instructions[-1].length_of, aside.span)
        self.remarks += naming_none(leftovers(self.draft.scanned, self.explained), sketches)
        self.remarks += self._unused(sketches)
        tokens, strict = tokens_of(self.draft)
        return Reading(
            text=self.draft.text,
            now=self.draft.now,
            instructions=tuple(instructions),
            tokens=tokens,
            strict=strict,
            remarks=tuple(sorted(dict.fromkeys(self.remarks), key=lambda remark: remark.span)),
            questions=tuple(dict.fromkeys(self.questions)),
            step=self.draft.step,
        )

    def _unused(self, sketches: Sequence[Sketch]) -> list[Remark]:
        """Point at what no operation and no time holds, where nothing else is said of it."""
        told = [*self.explained, *self.draft.unfinished, *(remark.span for remark in self.remarks)]
        found: list[Remark] = []
        for sketch in sketches:
            if sketch.operation is not None:
                text, part = self.draft.text, sketch.part
                held = [*told, *sketch.heard, *sketch.joints]
                found += unused_words(text, part, sketch.operation, held)
                found += uncounted(text, part, sketch.operation)
                found += unused_front(text, part, held)
                found += unknown_moments(text, part, held)
        return found

    def _instruction(
        self, sketch: Sketch, position: int, operations: Sequence[Operation | None]
    ) -> Instruction:
        """Ground a sketch: its requirements, how long it takes, whose length or time it tells."""
        sketch, text = between_sides(awaiting(sketch), self.draft.scanned.words), self.draft.text
        anchors = self._anchors_at(position, operations)
        self.explained += sketch.heard
        sketch, event, remarks = on_days_of_events(sketch, anchors, text)
        self.remarks += remarks
        if event is None and position and any(is_day_before(phrase.said) for phrase in sketch.phrases):
            event = self.told.event_of(position - 1)
        times = self._times_of(sketch, apart=event is not None)
        segment = sketch.part.segment
        said = text[slice(*segment.span)].strip()
        lengths = [one for one in times.found if one.duration is not None]
        length = lengths[0].duration if lengths else None
        operation, requirements, duration = self._required(sketch, times, anchors, said, length)
        requirements, remarks = offered(requirements, operation, text)
        self.remarks += remarks
        requirements = due_when_needed(requirements, operation, said, self.draft.lexicon)
        named = self.draft.entry is not None
        told = None if named else length_of(operation, requirements, said, anchors)
        self.remarks += [*unknown_length(told, segment.span), *sketch.remarks]
        self.explained += [remark.span for remark in sketch.remarks]
        return Instruction(
            span=segment.span,
            operation=operation,
            requirements=tuple(requirements),
            named=ground_all(sketch.named, text, self.moment).requirements,
            duration=_opening(sketch, operation, requirements) if duration is None else duration,
            repeats=next((part.recurrence for part in requirements if part.recurrence is not None), None),
            fuzzy_parameters=sketch.parameters,
            length_of=told,
            way=None if sketch.way is None else sketch.way.seconds,
            time_of=None if named or told is not None else time_of(operation, requirements, said, anchors),
            day_of=event,
            again=sketch.again,
            alone=bool(lengths) and any(_leaves(aside, lengths[0]) for aside in self.draft.asides),
        )

    def _required(
        self, sketch: Sketch, times: Times, anchors: Anchors, said: str, length: float | None
    ) -> tuple[Operation | None, Sequence[TimeRequirement], float | None]:
        """Give when a sketch is to be, and for how long; of what is denied, until when it is not to be."""
        segment, position = sketch.part.segment, anchors.position
        before = self._asked_before(position)
        connected = self._connected(segment, before, position)
        requirements, remarks = required_of(sketch, times, anchors, connected, self.draft)
        self.remarks += [*remarks, *second_ones(times.found)]
        self.explained += [part.span for part in requirements if part.anchor is not None]
        right_before = None if sketch.denial else self._right_before(position, before, said)
        denied = f"{sketch.denial} {said}"
        lexicon = self.draft.lexicon
        return without_denial(
            sketch.operation, requirements, length, connected, denied, lexicon, right_before
        )

    def _connected(self, segment: Segment, before: int | None, position: int) -> TimeRequirement | None:
        """Give the time that a connective says, "then"; where it follows nothing, that is said."""
        connected = anchored_by_connective(segment, self.draft.text, before)
        if before is None:
            led = led_by_denial if position else led_by_nothing
            self.remarks += led(segment, self.draft.text)
        if connected is not None:
            self.explained.append(connected.span)
        return connected

    def _anchors_at(self, position: int, operations: Sequence[Operation | None]) -> Anchors:
        """Give what finds the instructions that those at a position refer to."""
        return Anchors(
            position,
            self.first,
            operations,
            self.mentions,
            self.awaits,
            day_above(self.draft.heading),
            self.told,
            self.draft.now,
        )

    def _times_of(self, sketch: Sketch, *, apart: bool) -> Times:
        """Ground the times of a sketch, with what is to be said and asked; they may count from an event."""
        moment = at_usual_hours(self.moment, sketch, self.draft.text) if self.usual else self.moment
        times = ground_all(sketch.phrases, self.draft.text, moment)
        if self.made and sketch.operation is not None and sketch.operation.lemma not in sketch.lexicon.moving:
            before, own = self.made[-1], sketch.operation
            times = behind_the_same(times, sketch.phrases, self.draft.text, moment, before, own)
        decided = [remark for remark in times.remarks if remark.kind is RemarkKind.POLICY]
        self.remarks += [remark for remark in times.remarks if remark not in decided]
        if not sketch.doubted:
            # What is not planned is no clue to what else is meant, and nobody is asked, or told, when it is.
            happens = sketch.operation is not None and sketch.operation.stated
            self._remember(times, happens=happens, apart=apart)
            self.questions += times.questions
            self.remarks += decided
        return times

    def _right_before(self, position: int, before: int | None, said: str) -> Anchor | None:
        """Give what the same text asked for right before: its end, or its start where it goes on for long."""
        if before is None or not self.first < position == before + 1:
            return None
        lasts = self.made[-1].duration is not None
        return Anchor(text=said, target=before, edge=Edge.START if lasts else Edge.END)

    def _asked_before(self, position: int) -> int | None:
        """Give the instruction before that "then" follows: not what is not to be done; None without one."""
        given = (*self.mentions.operations[: self.first], *(made.operation for made in self.made))
        asked = (p for p in range(position - 1, -1, -1) if (one := given[p]) is None or not one.negated)
        return next(asked, None)

    def _remember(self, times: Times, *, happens: bool, apart: bool) -> None:
        """Remember the last clock time said: the next is hardly before it; and the day of what happens.

        One that counts ``apart``, from an event, is none that others are ahead of.
        """
        said = last_said(times.requirements, NOTHING)
        if said.clock is not None:
            self.moment = replace(self.moment, since=said.clock, carried=False)
        if said.day is not None:
            event = said.day if happens else self.moment.event
            ahead = self.moment.ahead if apart else said.day
            self.moment = replace(self.moment, day=said.day, event=event, ahead=ahead)


def _opening(
    sketch: Sketch, operation: Operation | None, requirements: Sequence[TimeRequirement]
) -> float | None:
    """Give how long something goes on that is done for the beginning of something: "for the first minute"."""
    denied = operation is None or operation.negated or any(part.denied for part in requirements)
    lengths = [length.seconds for phrase in sketch.phrases if (length := opening_of(phrase.said)) is not None]
    asked = operation is not None and operation.is_asked and not denied
    return lengths[0] if asked and len(lengths) == 1 else None


def _leaves(aside: Aside, length: Grounded) -> bool:
    """Whether a length is told by an aside as how long something is left alone."""
    return aside.left and aside.length.span == length.requirement.span
