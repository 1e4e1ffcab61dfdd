"""What the participants of simulated studies mean."""

from fuzzytime.satisfaction import SatisfactionFunction, Trapezoid
from fuzzytime.study import StudyInstruction


def truth(instruction: StudyInstruction, _group: str) -> SatisfactionFunction:
    """Give shapes like the paper's."""
    t = instruction.t_spec
    w = (112.9 + 0.03406 * t) * (1.5 if instruction.fuzziness else 1.0)
    if instruction.preposition == "in":
        return Trapezoid(t - w, t - 0.4 * w, t + 0.4 * w, t + w)
    if instruction.preposition == "before":
        return Trapezoid(0.0, 0.0, t, t + 0.1 * w)
    return Trapezoid(t - 10.09, t, t + 0.2 * w, t + 0.2 * w + 192.3)
