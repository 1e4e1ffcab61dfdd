"""An event joined to a time of the same thing: "ring the bell at noon and at kick-off" is done twice."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.words import Word
from fuzzytime.language.sentence.sketches.around_events.at_events import events_in
from fuzzytime.language.sentence.sketches.sketch import Sketch


def also_at_events(sketch: Sketch, words: Sequence[Word]) -> list[Sketch]:
    """Give one sketch for the time, and one for what hardly is a place and is joined to that by "and"."""
    if not sketch.asks or not sketch.phrases:
        return [sketch]
    ends = {phrase.end for phrase in sketch.phrases}
    for span, is_moment in events_in(sketch, words):
        at = next(place for place, word in enumerate(words) if word.start == span[0])
        joint = at - 1
        if is_moment and joint in ends and words[joint].text in sketch.lexicon.closed.additions:
            heard = (*sketch.joints, (words[joint].start, span[1]))
            return [replace(sketch, joints=heard), replace(sketch, phrases=(), references=(), joints=heard)]
    return [sketch]
