"""The population as the prior of personal calibration: how far people lie from it, how firm ratings are."""

from dataclasses import dataclass
from pathlib import Path

from fuzzytime.documents.nodes import Node, Reader
from fuzzytime.resources import rules_directory


@dataclass(frozen=True, slots=True, kw_only=True)
class Prior:
    """How people lie about the population's table, and how firm a rating is.

    Parameters
    ----------
    width, time, word
        Standard deviations of the logarithms of a person's factors of w, of t where a number was said, and of
        t where a word was.
    noise
        Standard deviation of a score, in points.
    direction
        How sharply "too late" begins at the plateau's end, in widths of its flank.
    lapse
        Share of those who say "too late" of any start: so that none of them moves a table far.
    points
        Of the scale.
    """

    width: float
    time: float
    word: float
    noise: float
    direction: float
    lapse: float
    points: int = 5

    @classmethod
    def shipped(cls) -> "Prior":
        """Read ``rules/study/personal.yaml``."""
        return cls.of_file(rules_directory() / "study" / "personal.yaml")

    @classmethod
    def of_file(cls, path: Path) -> "Prior":
        """Read a prior.

        Raises
        ------
        OSError
            If the file cannot be read.
        DocumentError
            If it breaks rules.
        """
        reader = Reader.of_file(path)
        sections = ("fuzzytime-personal", "spread", "rating")
        root = reader.mapping(reader.root(), "", sections, sections)
        numbers: dict[str, float] = {}
        for section, keys in (
            ("spread", ("width", "time", "word")),
            ("rating", ("points", "noise", "direction", "lapse")),
        ):
            found = reader.mapping(root[section], section, keys, keys) if section in root else {}
            numbers |= {key: _value(reader, node, f"{section}.{key}") for key, node in found.items()}
        reader.finish()
        points = int(numbers.pop("points"))
        return cls(points=points, **numbers)


def _value(reader: Reader, node: Node, key: str) -> float:
    parts = reader.mapping(node, key, ("value", "source"), ("value", "source"))
    return reader.number(parts["value"], f"{key}.value", 1e-3, 100.0) if "value" in parts else 1.0
