"""interim"""

from dataclasses import dataclass


@dataclass
class Why:
    position: int
    alone: float
    lost: float


def explain(schedule):
    out = []
    for i, s in enumerate(schedule.task.skills):
        b = s.satisfaction.best
        alone = float(s.satisfaction(max(b.low, 0.0))) if not b.empty else 0.0
        out.append(Why(i, alone, alone - schedule.satisfactions[i]))
    return out


def reason_of(why, plan, clock):
    return f"lost {why.lost:.2f}" if why.lost > 0.005 else ""
