"""What is made, or made ready, for what happens comes before that: "print the handouts for the meeting"."""

from collections.abc import Iterator, Sequence

from fuzzytime.interpreter.binding.steps import Step, is_asked
from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.language import Lexicon, Operation, content_words
from fuzzytime.skills import Precedence

FOR = "for"


def of_prepared(skills: Sequence[Interpreted], lexicon: Lexicon) -> Iterator[Precedence]:
    """Give the order of what is to be done for something that happens, and that; of its turns, the first.

    What has a time of its own keeps it: "print the handouts for the meeting at nine".
    """
    events = [(name, place) for place, one in enumerate(skills) if (name := _name_of(one, lexicon))]
    for place, one in enumerate(skills) if events else ():
        if not is_asked(one) or Step(place, one).timed or one.operation is None:
            continue
        meant = _meant(one.operation, lexicon)
        # "Slides for the call", of "the client call": what it is called by at last must be said.
        found = (event for name, event in events if meant <= frozenset(name) and name[-1] in meant)
        event = next(found, None)
        if event is not None:
            yield Precedence(place, event)


def _meant(operation: Operation, lexicon: Lexicon) -> frozenset[str]:
    """Give the words for what something is done with a thing: "ready for the call", "slides for the call"."""
    if operation.lemma in lexicon.doing.rewarding:
        return frozenset()
    thing = " ".join(filter(None, (operation.object, operation.complement)))
    if not thing and " " in operation.verb:
        # "Prep slides for the client call", where no tree tells verb and object apart
        thing = operation.verb
    placed = (operation.place or "").lower() if thing else ""
    _, _, purpose = thing.lower().partition(f" {FOR} ")
    return content_words(
        purpose or (placed.removeprefix(f"{FOR} ") if placed.startswith(f"{FOR} ") else None)
    )


def _name_of(one: Interpreted, lexicon: Lexicon) -> list[str]:
    """Give the words that something is called by, without what else is said of it: "1:1 with Sarah".

    What is to be done at a moment of its own is called by its verb: "call the client at ten", "team huddle".
    """
    operation = one.operation
    if operation is None or not (one.stated or Step(0, one).at_moment):
        return []
    said = (operation.object,) if one.stated else (operation.object, operation.verb)
    name: list[str] = []
    for word in " ".join(filter(None, said)).lower().split():
        if name and word in lexicon.function_words:
            break
        name += content_words(word)
    return name
