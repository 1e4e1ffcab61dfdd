"""Days left out of what is repeated, beside it or behind it.

Beside it: "apart from sundays, feed it every day". In a sentence of their own: "feed the cat every day. Not
on sundays", "…, skip weekends".
"""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.english import singular
from fuzzytime.language.instruction import Operation, overlap
from fuzzytime.language.meaning.expressions import Phrase, Repeat
from fuzzytime.language.meaning.joined.weekdays_left_out import weekdays_in, without_weekdays
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.language.sentence.trees.tree import Node


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
    told = replace(repeated[0].said, time=left)
    return sketch.keeping(lambda phrase: phrase not in denied).telling(repeated, told)


def left_out_behind(sketches: Sequence[Sketch]) -> list[Sketch]:
    """Give times that are denied alone to the order right before them, and so what is skipped of it."""
    found: list[Sketch] = []
    for sketch in sketches:
        before = found[-1] if found else None
        denied = () if before is None or not before.asks else _left_out(before, sketch)
        if before is None or not denied:
            found.append(sketch)
            continue
        whole = before.also(*denied).reaching(sketch)
        found[-1] = replace(whole, joints=(*before.joints, sketch.part.segment.span))
    return found


def _left_out(before: Sketch, sketch: Sketch) -> tuple[Phrase, ...]:
    """Give the times that a sketch leaves out of what stands before it; none where it says anything else."""
    if not sketch.phrases or sketch.clauses:
        return ()
    operation = sketch.operation
    if before.repeats and _names_again(before, sketch):
        # "Walk the dog every day, no walks on sundays"
        return _denied(sketch)
    if operation is None:
        alone = all(phrase.said.denied for phrase in sketch.phrases) and _says_no_more(sketch)
        return sketch.phrases if alone else ()
    if before.repeats and _is_denied_again(before, operation):
        # "Feed the cat every day. Don't feed it on sundays"
        return _denied(sketch) if all(weekdays_in(phrase.said.time) for phrase in sketch.phrases) else ()
    bare = (operation.object, operation.place, operation.complement) == (None, None, None)
    if (
        not before.repeats
        or not bare
        or operation.negated
        or operation.lemma not in before.lexicon.doing.dropping
    ):
        return ()
    # "Skip sundays"
    return _denied(sketch)


def _denied(sketch: Sketch) -> tuple[Phrase, ...]:
    """Give times as those at which something is not to be done."""
    return tuple(replace(phrase, said=replace(phrase.said, denied=True)) for phrase in sketch.phrases)


def _is_denied_again(before: Sketch, operation: Operation) -> bool:
    """Whether what is not to be done is what was asked for right before it."""
    first = before.operation
    if first is None or not operation.negated or operation.lemma not in {first.lemma, "do"}:
        return False
    thing = (operation.object or "").lower()
    return not thing or thing in before.lexicon.closed.all_anaphors or operation.object == first.object


def _names_again(before: Sketch, sketch: Sketch) -> bool:
    """Whether it is denied, by its name, what was asked for right before it, on some weekdays."""
    first, (no, *named) = before.operation, [node.lower for node in _beside_times(sketch)] or [""]
    if first is None or no != "no" or not all(weekdays_in(phrase.said.time) for phrase in sketch.phrases):
        return False
    asked = {first.lemma, first.verb, *content_words(first.object)}
    return bool(named) and all(not asked.isdisjoint({word, singular(word)}) for word in named)


def _says_no_more(sketch: Sketch) -> bool:
    """Whether nothing but small words stands beside times."""
    small = sketch.lexicon.beside.around_denials
    return all(node.lower in small for node in _beside_times(sketch))


def _beside_times(sketch: Sketch) -> list[Node]:
    """Give the words of a sketch that are in none of its times."""
    part, times = sketch.part, [phrase.span for phrase in sketch.phrases]
    words = (node for node in part.tree.nodes if node.text.isalpha())
    return [node for node in words if not any(overlap(part.span(node), span) for span in times)]
