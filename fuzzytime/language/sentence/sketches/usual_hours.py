"""The hours at which people do what is asked for: dinner is in the evening, who wakes does in the morning."""

from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import words_of
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
    for place in range(len(words)):
        form = longest_match(words, place, lexicon.usual_hours)
        numbered = place + 1 < len(words) and words[place + 1].is_digits
        if form is not None and not numbered:
            # "Bed 5" is no bedtime
            first, last = lexicon.usual_hours[form]
            policy = replace(moment.policy, ahead_from=first)
            if last is not None:
                policy = replace(policy, plausible_from=first, plausible_to=last, workday_from=first)
            return replace(moment, policy=policy, usual=last is not None)
    return moment
