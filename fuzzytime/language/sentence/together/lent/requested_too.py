"""What another is asked to do too, and when: "ask Ann to come at four and Bob at five"."""

from dataclasses import replace

from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.sketches.telling import of_something_else, of_which

TO = " to "
"""What stands between who is asked and what to do."""


def requested_too(before: Sketch, sketch: Sketch, again: Operation, text: str) -> list[Sketch] | None:
    """Give a request, and what is asked behind it; None where its times are those of asking.

    ``again`` is the operation of the request with what is said anew: another request where that is somebody,
    but the same where it is a thing: "ask Ann to wash the windows today and the doors tomorrow".
    """
    first = before.operation
    if first is None or again.lemma not in before.lexicon.doing.requesting or before.phrases:
        return None
    if not sketch.part.segment.verbless and sketch.operation is not None:
        return None
    whom, said = again.object or "", first.object or ""
    if TO in whom:
        return [before, _named(sketch, of_which(text, again, sketch.phrases), text)]
    if not whom or TO not in said or not before.named:
        return None
    if _is_somebody(whom, before):
        asked = said.split(TO, 1)[1]
        for phrase in before.named:
            # "Tell Ann to come at four": the time is in what she is told.
            asked = asked.removesuffix(text[slice(*phrase.span)]).strip()
        told = replace(again, object=f"{whom}{TO}{asked}", manner=None)
        return [before, _named(sketch, of_which(text, told, sketch.phrases), text)]
    both = replace(first, object=f"{said} and {whom}")
    named = _named(sketch, both, text)
    kept = replace(before.reaching(sketch), operation=both, named=(*before.named, *named.named))
    return [replace(kept, remarks=(*before.remarks, *named.remarks))]


def _is_somebody(whom: str, before: Sketch) -> bool:
    """Whether another is named who is asked, and not a thing to do it with."""
    words, tree = whom.split(), before.part.tree
    named = words[0][:1].isupper() or words[-1].lower() in before.lexicon.persons
    return named or not any(tree.children(place, "dobj") for place in tree.children(tree.root, "xcomp"))


def _named(sketch: Sketch, operation: Operation, text: str) -> Sketch:
    """Give what is asked without its times, which are none of asking."""
    remarks = tuple(of_something_else(text, phrase) for phrase in sketch.phrases)
    return replace(
        sketch,
        operation=operation,
        phrases=(),
        references=(),
        named=(*sketch.named, *sketch.phrases),
        remarks=(*sketch.remarks, *remarks),
    )
