"""Rules: over which requirements, under which condition, which model with which parameters."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

from fuzzytime.rulebook.logic.formula import Formula
from fuzzytime.rulebook.tables.matching import Match


@dataclass(frozen=True, slots=True, kw_only=True)
class Effect:
    """What a rule asks for.

    Parameters
    ----------
    model
        A model's name; None keeps the one of the table's row.
    t, w, core, fade
        Parameters in seconds, None where the rule leaves them.
    scale
        Factors of t and w, which multiply in with the rule's degree as exponent.
    """

    model: str | None = None
    t: float | None = None
    w: float | None = None
    core: float | None = None
    fade: float | None = None
    scale: Mapping[str, float] = field(default_factory=lambda: MappingProxyType({}))

    @property
    def only_scales(self) -> bool:
        """Whether it leaves model and parameters to others."""
        return self.model is None and (self.t, self.w, self.core, self.fade) == (None, None, None, None)


@dataclass(frozen=True, slots=True, kw_only=True)
class Rule:
    """If a requirement matches ``match`` and ``condition`` holds, then ``effect``, by ``weight``."""

    name: str
    place: str
    match: Match
    condition: Formula | None
    effect: Effect
    weight: float = 1.0
