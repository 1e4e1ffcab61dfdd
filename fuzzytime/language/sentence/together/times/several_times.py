"""Several times of one thing: all are meant ("at seven and at eight"), or one ("at seven or at eight")."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.understood.filled import filled
from fuzzytime.language.grammar.understood.lists import lists_of
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.sentence.sketches.around_events.at_events import events_in
from fuzzytime.language.sentence.sketches.sketch import Sketch


def of_several_times(sketch: Sketch, words: Sequence[Word]) -> list[Sketch]:
    """Give one sketch for each time that is meant, or one of which each time is an alternative.

    "At seven and at six" asks for two, "at seven or at eight" for one; "tomorrow, by noon" is one time.
    """
    times = next(lists_of(sketch.phrases, words, sketch.lexicon), None)
    if times is None:
        return [sketch]
    rest = [phrase for phrase in sketch.phrases if phrase not in times.members]
    members = filled(times, words)
    listed = times.members[0].span[0], times.members[-1].span[1]
    sketch = replace(sketch, joints=(*sketch.joints, listed))
    groups = [members] if times.either else [[one] for one in members]
    return [_with(sketch, [*rest, *group]) for group in groups]


def _with(sketch: Sketch, phrases: Sequence[Phrase]) -> Sketch:
    """Give a sketch with some of its times, which may have got a day or a clock time, in their order."""
    references = {
        phrase.span: reference for phrase, reference in zip(sketch.phrases, sketch.references, strict=True)
    }
    times = tuple(sorted(phrases, key=lambda phrase: phrase.span))
    return replace(sketch, phrases=times, references=tuple(references[time.span] for time in times))


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
