"""What leans on the verb of what was said before it, in full: "call mum at six", and then "and dad at seven"."""

from datetime import datetime
from typing import TYPE_CHECKING

from fuzzytime.language.about_wishes.about import AboutKind
from fuzzytime.language.about_wishes.rewording import is_thing, reworded
from fuzzytime.language.about_wishes.things import continuing
from fuzzytime.language.sentence.trees.content_words import content_words

if TYPE_CHECKING:
    from fuzzytime.language.reader import Language


def continued(
    text: str, now: datetime, before: str, said: datetime, language: "Language"
) -> str | None:
    """Give in full what leans on what was asked for before; None where it does not, or cannot.

    Parameters
    ----------
    text, now
        What leans on it, and when that is said.
    before, said
        What was asked for, and when.
    language
        What reads both.

    Raises
    ------
    InstructionError
        If a text is too long.
    """
    lexicon = language.lexicon
    about = continuing(text, now, lexicon)
    if about is None:
        return None
    reading = language.read(before, now=said)
    operations = [one.operation for one in reading.instructions if one.operation is not None]
    if not operations or len(operations) > 1 or operations[0].negated:
        return None
    if about.kind is AboutKind.AGAIN:
        return reworded(reading, lexicon, time=about.time, now=now)
    if not about.certain:
        own = content_words(about.thing)
        # "And dinner at seven" is something of its own.
        happens = bool(about.time) and not own.isdisjoint(lexicon.events | lexicon.happening)
        if happens or is_thing(reading) or not is_thing(language.read(about.thing, now=now)):
            return None
    # "Then physics" comes when the other is over, and not when that was to be.
    time = about.time if about.time or about.text else None
    anew = reworded(reading, lexicon, thing=about.thing, joint=about.joint, time=time, now=now)
    return f"{about.text} {anew}".strip() if anew is not None else None
