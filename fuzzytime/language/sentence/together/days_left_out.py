"""Weekdays left out of what is repeated, said apart from it: "apart from sundays, feed it every day"."""

from dataclasses import replace

from fuzzytime.language.meaning.expressions import Repeat
from fuzzytime.language.meaning.weekdays_left_out import weekdays_in, without_weekdays
from fuzzytime.language.sentence.sketches.sketch import Sketch


def without_days_left_out(sketch: Sketch) -> Sketch:
    """Let a repetition be on its other weekdays, in every week that it goes on."""
    phrases = sketch.phrases
    repeated = [p for p in phrases if isinstance(p.said.time, Repeat) and not p.said.denied]
    denied = [p for p in phrases if p.said.denied and weekdays_in(p.said.time)]
    if len(repeated) != 1 or not denied:
        return sketch
    days = frozenset[int]().union(*(weekdays_in(phrase.said.time) for phrase in denied))
    repeat = repeated[0].said.time
    left = without_weekdays(repeat, days) if isinstance(repeat, Repeat) else None
    if left is None:
        return sketch
    told = replace(repeated[0], said=repeated[0].said.borrowing(replace(repeated[0].said, time=left)))
    kept = [place for place, phrase in enumerate(phrases) if phrase not in denied]
    return replace(
        sketch,
        phrases=tuple(told if phrases[place] is repeated[0] else phrases[place] for place in kept),
        references=tuple(sketch.references[place] for place in kept),
    )
