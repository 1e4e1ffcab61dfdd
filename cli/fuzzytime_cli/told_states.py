"""What somebody tells to be so: "the dew is off" asks for nothing, and is what something may wait for."""

from collections.abc import Iterable

from fuzzytime.interpreter import Interpreted
from fuzzytime.language import Lexicon, Reading, content_words


def tells_a_state(said: str, reading: Reading, lexicon: Lexicon) -> bool:
    """Whether words tell what is so: they ask for nothing at any time."""
    if len(reading.instructions) > 1 or any(one.requirements for one in reading.instructions):
        return False
    first = said.split(maxsplit=1)[0].lower().replace("\u2019", "'") if said else ""
    asks = any(one.operation is not None for one in reading.instructions)
    # No order begins with "the" or "it".
    return not asks or first in told_of(lexicon) | lexicon.closed.noun_openers


def is_waited_for(said: str, skills: Iterable[Interpreted]) -> bool:
    """Whether one of some skills waits for what these words say."""
    named = content_words(said)
    parts = (part for one in skills for part in one.requirements)
    return bool(named) and any(
        named <= content_words(part.text)
        for part in parts
        if part.condition is not None or (part.anchor is not None and part.anchor.target is None)
    )


def as_news(said: str) -> str:
    """Put a state that was told as what happens now."""
    return f"{said.strip().rstrip('.! ')} now"


def told_of(lexicon: Lexicon) -> frozenset[str]:
    """Give the first words of what is told of something that was spoken of."""
    return frozenset(form[0] for form in lexicon.conversation["told of"])
