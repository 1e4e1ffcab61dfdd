"""What the times of an instruction count from, as those beside it in its text say."""

from collections.abc import Sequence
from dataclasses import replace
from datetime import timedelta

from fuzzytime.language.finding import ground_all
from fuzzytime.language.instruction import Instruction
from fuzzytime.language.meaning.grounded.chosen_clocks import NOON_TIME
from fuzzytime.language.meaning.grounded.moment import Moment
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.sketches.around_events.prepared import due_of
from fuzzytime.language.sentence.sketches.meaning.clock_times import NOTHING, last_said
from fuzzytime.language.sentence.sketches.meaning.usual_hours import at_usual_hours
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.together.days.mornings_after import follows_night
from fuzzytime.language.sentence.together.times.pairs import follows_on, leads_to, side_of_night


def moment_of(
    moment: Moment,
    sketches: Sequence[Sketch],
    place: int,
    made: Sequence[Instruction],
    draft: Draft,
    *,
    usual: bool,
) -> Moment:
    """Give a moment for the sketch at a place, with what those beside it say; those before it are ``made``.

    Things are done at their ``usual`` hours, or not.
    """
    sketch, text = sketches[place], draft.text
    then = sketch.part.segment.connective == "then"
    settled = _settled_behind(moment, sketches[place : place + 2], draft) if usual else None
    return replace(
        moment,
        since=settled or moment.since,
        listed=place > 0 and sketch.part is sketches[place - 1].part,
        follows=then or follows_night(sketches, place),
        due=due_of(text, sketches[:place], sketch, made, moment),
        leads=leads_to(sketches, place, text),
        overnight=side_of_night(sketches, place, text),
        onto=follows_on(sketches, place, text) or (then and place > 0),
        past=sketch.past,
    )


def _settled_behind(moment: Moment, pair: Sequence[Sketch], draft: Draft) -> float | None:
    """Give when an order of a morning behind what is told is: "the bus goes at ten, wake me at eight"."""
    if draft.now is None or len(pair) == 1:
        return None
    told, order = pair
    if not order.asks or told.operation is None or told.asks:
        return None
    both = [at_usual_hours(moment, one, draft.text) for one in (told, order)]
    if [one.usual for one in both] != [False, True]:
        return None
    clock = last_said(ground_all(order.phrases, draft.text, both[1]).requirements, NOTHING).clock
    early = clock and (draft.now + timedelta(seconds=clock)).time() < NOON_TIME
    return clock if early else None
