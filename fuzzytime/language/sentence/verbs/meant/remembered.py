"""What is not to be forgotten: "don't forget the bins tonight" asks to remember them then."""

from dataclasses import replace

from fuzzytime.language.instruction import Operation


def as_remembered(operation: Operation) -> Operation:
    """Give what "don't forget" asks for where it names a thing, and no verb: to remember it.

    "Don't forget" alone names nothing to be done.
    """
    named = operation.object is not None or operation.place is not None
    if operation.lemma != "forget" or not operation.negated or operation.stated or not named:
        return operation
    return replace(operation, verb="remember", lemma="remember", negated=False)
