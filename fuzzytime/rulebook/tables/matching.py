"""Which requirements a row or a rule speaks about: the ``on:`` of rule files."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from fuzzytime.requirement import TimeRequirement

KEYS = (
    "cue",
    "word",
    "subject",
    "verb",
    "preposition",
    "hedge",
    "constraint",
    "reference",
    "grain",
    "unit",
    "number",
)
"""What ``on:`` may name."""


@dataclass(frozen=True, slots=True)
class Match:
    """Accepted texts by key; a requirement matches where for each key one of its texts is accepted."""

    accepted: tuple[tuple[str, frozenset[str]], ...] = ()

    def __call__(self, texts: Mapping[str, frozenset[str]]) -> bool:
        """Tell whether a requirement that is `described` by some texts matches."""
        return all(accepted & texts[key] for key, accepted in self.accepted)

    def first_covering(self, others: Iterable["Match"]) -> int | None:
        """Give the place of the first of others that matches all that this one matches."""
        own = dict(self.accepted)
        for place, other in enumerate(others):
            if all(key in own and own[key] <= texts for key, texts in other.accepted):
                return place
        return None

    @property
    def keys(self) -> frozenset[str]:
        """The keys that it names."""
        return frozenset(key for key, _ in self.accepted)


def verbs_of(lemma: str | None) -> tuple[str, ...]:
    """Give a verb as it is looked up: whole ("turn on", "go to bed"), then without its last words."""
    words = (lemma or "").lower().replace("_", " ").split()
    return tuple(" ".join(words[:end]) for end in range(len(words), 0, -1))


def described(requirement: TimeRequirement, verb: str | None) -> Mapping[str, frozenset[str]]:
    """Give the texts of a requirement by the keys of ``on:``, all in lower case."""
    condition = requirement.condition
    said: dict[str, tuple[object, ...]] = {
        "cue": (requirement.word, requirement.preposition, requirement.constraint.value),
        "word": (requirement.word, condition.word if condition else None),
        "subject": (condition.subject if condition else None,),
        "verb": verbs_of(verb),
        "preposition": (requirement.preposition,),
        "hedge": (*requirement.fuzziness, " ".join(requirement.fuzziness) or None),
        "constraint": (requirement.constraint.value,),
        "reference": (requirement.reference.value,),
        # "Within two hours" is meant as finely as it is counted.
        "grain": (requirement.grain or requirement.unit,),
        "unit": (requirement.unit,),
        "number": (None if requirement.number is None else f"{requirement.number:g}",),
    }
    return {
        key: frozenset(str(text).lower() for text in texts if text is not None) for key, texts in said.items()
    }
