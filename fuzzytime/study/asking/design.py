"""The design of a study: who is asked what, on which timeline, and how answers are checked; read from YAML.

``rules/study/sucker2024.yaml`` is the paper's design, and shows the format.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from fuzzytime.documents.nodes import Reader
from fuzzytime.errors import FuzzytimeError
from fuzzytime.resources import rules_directory
from fuzzytime.study.asking.design_parts import (
    read_control,
    read_demographics,
    read_groups,
    read_instructions,
    read_timeline,
)
from fuzzytime.study.asking.page_texts import PageTexts, read_texts
from fuzzytime.study.asking.questions import ControlQuestion, Question, StudyInstruction, Timeline
from fuzzytime.times import DAY

SHIPPED = "sucker2024"


_KEYS = (
    "fuzzytime-study",
    "name",
    "title",
    "source",
    "timeline",
    "default",
    "groups",
    "attention",
    "instructions",
    "demographics",
    "control",
    "texts",
)
_REQUIRED = ("fuzzytime-study", "name", "timeline", "groups", "instructions")


@dataclass(frozen=True, slots=True, kw_only=True)
class Design:
    """A study's design.

    Parameters
    ----------
    name, title, source
        What it is called, for programs and for people, and where it comes from.
    timeline, default
        Where people draw, and the satisfaction before they do.
    groups
        The actors between which participants are divided, and the word for each.
    attention
        Seconds around t_spec in which a curve must be above 0 somewhere, None for no such check.
    instructions, demographics, control
        What is asked; ``control`` may be None.
    texts
        What the page says.
    yaml
        The file's text, which answers are stored with.
    """

    name: str
    title: str
    source: str
    timeline: Timeline
    default: float
    groups: Mapping[str, str]
    attention: float | None
    instructions: tuple[StudyInstruction, ...]
    demographics: tuple[Question, ...]
    control: ControlQuestion | None
    texts: PageTexts
    yaml: str = field(repr=False)

    @classmethod
    def shipped(cls, name: str = SHIPPED) -> "Design":
        """Read a design that comes with fuzzytime."""
        return cls.of_file(rules_directory() / "study" / f"{name}.yaml")

    @classmethod
    def of_file(cls, path: Path) -> "Design":
        """Read a design file.

        Raises
        ------
        OSError
            If it cannot be read.
        DocumentError
            If it breaks rules: all its mistakes, with their places.
        """
        return _read(Reader.of_file(path))

    @classmethod
    def of_text(cls, text: str, path: str = "design") -> "Design":
        """Read a design from its YAML text; ``path`` is what mistakes are said to be in.

        Raises
        ------
        DocumentError
            If it breaks rules.
        """
        return _read(Reader(path, text))

    def instruction(self, key: str) -> StudyInstruction:
        """Find an instruction by its key.

        Raises
        ------
        FuzzytimeError
            If there is none.
        """
        for instruction in self.instructions:
            if instruction.key == key:
                return instruction
        known = ", ".join(instruction.key for instruction in self.instructions)
        raise FuzzytimeError(f"an instruction must be one of {known}, got {key[:80]!r}")

    def question(self, key: str) -> Question:
        """Find a question about the participant by its key.

        Raises
        ------
        FuzzytimeError
            If there is none.
        """
        for question in self.demographics:
            if question.key == key:
                return question
        raise FuzzytimeError(f"there is no question {key[:80]!r}")

    def control_answer(self, answer: int) -> int:
        """Give an answer to the control question.

        Raises
        ------
        FuzzytimeError
            If the scale has no such point, or there is no control question.
        """
        if self.control is None:
            raise FuzzytimeError("there is no control question")
        if not 1 <= answer <= self.control.points:
            raise FuzzytimeError(f"the answer must be one of 1 to {self.control.points}, got {answer}")
        return answer


def _read(reader: Reader) -> Design:
    root = reader.mapping(reader.root(), "", _KEYS, _REQUIRED)
    if "fuzzytime-study" in root:
        reader.whole(root["fuzzytime-study"], "fuzzytime-study", 1, 1)

    def text(key: str, otherwise: str = "") -> str:
        return reader.string(root[key], key) if key in root else otherwise

    timeline = read_timeline(reader, root["timeline"]) if "timeline" in root else Timeline(0.0, 1.0, 2)
    attention = None
    if "attention" in root:
        around = reader.mapping(root["attention"], "attention", ("around",), ("around",))
        if "around" in around:
            attention = reader.duration(around["around"], "attention.around", 0.0, DAY)
    control = read_control(reader, root["control"], timeline) if "control" in root else None
    design = Design(
        name=reader.phrase(root["name"], "name") if "name" in root else "",
        title=text("title", text("name")),
        source=text("source"),
        timeline=timeline,
        default=reader.number(root["default"], "default", 0.0, 1.0) if "default" in root else 0.0,
        groups=read_groups(reader, root["groups"]) if "groups" in root else {},
        attention=attention,
        instructions=read_instructions(reader, root["instructions"], timeline)
        if "instructions" in root
        else (),
        demographics=read_demographics(reader, root["demographics"]) if "demographics" in root else (),
        control=control,
        texts=read_texts(reader, root.get("texts")),
        yaml=reader.text,
    )
    reader.finish()
    return design
