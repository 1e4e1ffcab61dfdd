"""Words about time alone, as a plan of one instruction that has no operation of its own."""

from typing import TYPE_CHECKING

from fuzzytime_cli.options import Understanding

if TYPE_CHECKING:
    from fuzzytime.interpreter import Plan
    from fuzzytime_cli.assembly import Assembly


def shown_plan(text: str, assembly: "Assembly", understanding: Understanding) -> "Plan":
    """Plan an instruction; a fragment without a verb is taken as the time of "do it"."""
    from fuzzytime.interpreter import Request, SpokenWish

    interpreter = assembly.interpreter()
    now = assembly.moment()
    context = assembly.context(understanding, now, interpreter.rulebook.signals)
    reading = interpreter.language.read(text, now=now)
    whole = any(part.operation is not None and part.requirements for part in reading.instructions)
    wish = SpokenWish(text=text if whole else f"do it {text}", given=now)
    return assembly.plan(Request(now=now, wishes=(wish,), context=context), interpreter)
