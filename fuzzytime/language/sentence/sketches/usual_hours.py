"""The hours at which people do what is asked for: dinner is in the evening, who wakes does in the morning."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word, words_of
from fuzzytime.language.meaning.moment import Moment
from fuzzytime.language.sentence.sketches.said_of_time import DATED
from fuzzytime.language.sentence.sketches.sketch import Sketch


def at_usual_hours(moment: Moment, sketch: Sketch, text: str, lexicon: Lexicon) -> Moment:
    """Give the moment for one instruction, with the policy of the hours that its words are usual at."""
    named = [sketch.operation.name] if sketch.operation is not None else []
    # "Let me sleep until ten", "don't sleep past nine"
    leading = [text[slice(*phrase.span)].partition(" ")[0] for phrase in sketch.phrases]
    leading += [phrase.said.preposition or "" for phrase in sketch.phrases]
    named = [*(f"{name} {word}" for name in named for word in leading), *named]
    dated = (text[slice(*phrase.span)] for phrase in sketch.phrases if phrase.rule == DATED)
    words = words_of(" ; ".join((*dated, *named)))
    places = (place for place in range(len(words)) if not _is_thing(words, place, lexicon))
    found = (longest_match(words, place, lexicon.usual_hours) for place in places)
    # "Sleep until" says more than "sleep"
    form = max((form for form in found if form is not None), key=len, default=None)
    if form is None:
        return moment
    first, last = lexicon.usual_hours[form]
    policy = replace(moment.policy, ahead_from=first)
    if last is not None:
        policy = replace(policy, plausible_from=first, plausible_to=last, workday_from=first)
    return replace(moment, policy=policy, usual=last is not None)


def _is_thing(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a word names a thing, and nothing of the day: "bed 5", "make the bed"."""
    behind = words[place + 1 : place + 2]
    if behind and (behind[0].is_digits or behind[0].text in lexicon.numbers):
        return True
    led = place > 0 and words[place - 1].text in lexicon.closed.noun_openers
    return led and any(p.category == "meal" and p.value.place for p in lexicon.pieces(words, place))
