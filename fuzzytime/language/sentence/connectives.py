"""Orders that a connective says: "then", "meanwhile"."""

from fuzzytime.language.sentence.segments import Segment
from fuzzytime.requirement import Anchor, Constraint, Edge, TimeRequirement


def anchored_by_connective(segment: Segment, text: str, position: int) -> TimeRequirement | None:
    """Give the order that "then" or "meanwhile" says, to the instruction before; None without one."""
    if segment.connective not in {"then", "meanwhile"} or position == 0:
        return None
    first, end = segment.connective_span
    said = text[first:end].rstrip(" ,:") or text[first:end]
    follows = segment.connective == "then"
    return TimeRequirement(
        text=said,
        span=(first, first + len(said)),
        constraint=Constraint.AFTER if follows else Constraint.AT,
        preposition=segment.connective,
        anchor=Anchor(text=said, target=position - 1, edge=Edge.END if follows else Edge.START),
    )
