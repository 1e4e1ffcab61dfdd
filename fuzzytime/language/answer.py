"""A reading as plain JSON values: what ``fuzzytime parse --jsonl`` prints for other programs."""

from collections.abc import Iterable, Iterator
from typing import Any

from fuzzytime.language.instruction import Instruction, Operation, Reading
from fuzzytime.requirement import Comparison, Recurrence, TimeRequirement
from fuzzytime.times import instant_after

NAMED = "named"
"""The ``reference`` of times that are of what is named, told or asked of others, and bind nothing."""

NEXT = 3
"""How many coming occurrences of a repetition are listed."""


def answer(reading: Reading) -> dict[str, Any]:
    """Give a reading as the object of one JSON line.

    The keys of one instruction are always there. With several, ``operation`` is the first that is to be done,
    or that happens where nothing is; ``operations`` lists each one's operation, and each requirement has the
    ``instruction`` that it belongs to. ``remarks`` and ``questions`` hold what needs saying.

    Requirements whose ``reference`` is "named" say when something that is named is ("cancel my alarm for
    six"), and not when to do anything: they stand behind those that bind.

    A repetition's ``earliest`` and ``latest`` are its next occurrence.

    ``repeats`` is null or ``{"text", "interval_s", "next"}``: the words, seconds between occurrences where
    they are evenly spaced, and the next few occurrences, as instants where the time now is known and in
    seconds from now where it is not.
    """
    instructions = reading.instructions
    several = len(instructions) > 1
    operations = [_operation(instruction.operation) for instruction in instructions]
    found: dict[str, Any] = {
        "text": reading.text,
        "now": reading.now.isoformat() if reading.now is not None else None,
        "operation": _foremost(instruction.operation for instruction in instructions),
        "requirements": [
            {**told, **({"instruction": index} if several else {})}
            for index, instruction in enumerate(instructions)
            for told in _requirements(instruction, reading)
        ],
        "duration_s": next((i.duration for i in instructions if i.duration is not None), None),
        "repeats": next((_repeats(i, reading) for i in instructions if i.repeats is not None), None),
        "instructions": len(instructions),
        "error": None,
    }
    if several:
        found["operations"] = operations
    if reading.remarks:
        found["remarks"] = [
            {"kind": remark.kind.value, "span": list(remark.span), "message": remark.message}
            for remark in reading.remarks
        ]
    if reading.questions:
        found["questions"] = [
            {
                "span": list(question.span),
                "choices": [choice.isoformat() for choice in question.choices],
                "chosen": question.chosen,
            }
            for question in reading.questions
        ]
    return found


def _foremost(operations: Iterable[Operation | None]) -> dict[str, Any] | None:
    """Give the first operation that is to be done, or that happens: "the bus leaves at six, call a taxi"."""
    named = [operation for operation in operations if operation is not None]
    return _operation(min(named, key=lambda one: one.stated or one.negated, default=None))


def _operation(operation: Operation | None) -> dict[str, Any] | None:
    if operation is None:
        return None
    return {
        "verb": operation.verb,
        "object": operation.object,
        "place": operation.place,
        "span": list(operation.span),
        "negated": operation.negated,
        **({"particle": operation.particle} if operation.particle is not None else {}),
        **({"complement": operation.complement} if operation.complement is not None else {}),
        **({"manner": operation.manner} if operation.manner is not None else {}),
        **({"purpose": operation.purpose} if operation.purpose is not None else {}),
        **({"order": operation.order.value} if operation.order is not None else {}),
        **({"stated": True} if operation.stated else {}),
        **({"addressee": operation.addressee} if operation.addressee is not None else {}),
    }


def _requirements(instruction: Instruction, reading: Reading) -> Iterator[dict[str, Any]]:
    """Give what is said about time: what binds, then when that is which is named, and binds nothing."""
    for requirement in instruction.requirements:
        yield _requirement(requirement, reading)
    for requirement in instruction.named:
        yield {**_requirement(requirement, reading), "reference": NAMED}


def _requirement(requirement: TimeRequirement, reading: Reading) -> dict[str, Any]:
    coming = () if requirement.recurrence is None else requirement.recurrence.coming(1)
    first, last = coming[0] if coming else (requirement.earliest, requirement.latest)
    found: dict[str, Any] = {
        "text": requirement.text,
        "span": list(requirement.span),
        "reference": requirement.reference.value,
        "constraint": requirement.constraint.value,
        "preposition": requirement.preposition,
        "fuzziness": " ".join(requirement.fuzziness) or None,
        "number": _plain(requirement.number),
        "unit": requirement.unit.value if requirement.unit is not None else None,
        "t_spec_s": requirement.t_spec,
        "earliest": _instant(first, reading),
        "latest": _instant(last, reading),
    }
    if requirement.alternative:
        found["alternative"] = True
    if requirement.word is not None:
        found["word"] = requirement.word
    if requirement.condition is not None:
        condition = requirement.condition
        found["condition"] = {
            "subject": condition.subject,
            "word": condition.word,
            "hedges": list(condition.hedges),
            "negated": condition.negated,
        }
        if condition.comparisons:
            found["condition"]["comparisons"] = [_compared(number) for number in condition.comparisons]
    if requirement.anchor is not None:
        anchor = requirement.anchor
        found["anchor"] = {
            "text": anchor.text,
            "target": anchor.target,
            "edge": anchor.edge.value,
            "lag_s": anchor.lag,
            "exact": anchor.exact,
        }
    return found


def _compared(comparison: Comparison) -> dict[str, Any]:
    return {
        "text": comparison.text,
        "side": comparison.side.value,
        "number": _plain(comparison.number),
        "until": _plain(comparison.until),
        "fuzziness": list(comparison.fuzziness),
        "behind": comparison.behind,
    }


def _plain(number: float | None) -> float | int | None:
    """Give a whole number as one: 2, not 2.0."""
    return int(number) if number is not None and number == int(number) else number


def _instant(seconds: float | None, reading: Reading) -> str | None:
    if seconds is None or reading.now is None:
        return None
    return instant_after(reading.now, seconds).isoformat()


def _repeats(instruction: Instruction, reading: Reading) -> dict[str, Any]:
    recurrence: Recurrence | None = instruction.repeats
    text = next((r.text for r in instruction.requirements if r.recurrence is recurrence), "")
    coming = () if recurrence is None else recurrence.coming(NEXT)
    return {
        "text": text,
        "interval_s": recurrence.interval if recurrence is not None else None,
        "next": [_instant(seconds, reading) if reading.now is not None else seconds for seconds, _ in coming],
    }
