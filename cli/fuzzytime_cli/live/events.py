"""What a run tells: one frozen value an event, and each as a JSON object by the schema `fuzzytime-run/1`.

Times are seconds since the run's now.
"""

from dataclasses import asdict, dataclass, field
from datetime import datetime
from typing import Any, ClassVar

from fuzzytime.interpreter import Plan
from fuzzytime.times import instant_after

SCHEMA = "fuzzytime-run/1"

Json = dict[str, Any]
"""A JSON object; its shape is the schema's matter, not the type checker's."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Event:
    """Something that happened, and when."""

    type: ClassVar[str]

    at: float

    def fields(self) -> Json:
        """Give everything but type and time."""
        return {name: value for name, value in asdict(self).items() if name != "at"}


@dataclass(frozen=True, slots=True, kw_only=True)
class SkillEvent(Event):
    """Something that happened to a skill."""

    id: str
    name: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Began(Event):
    """The run begins; the first event."""

    type: ClassVar[str] = "run"

    schema: str = SCHEMA
    now: str
    speed: float | None
    agents: int
    threshold: float
    ends: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Upcoming:
    """A skill that is planned to start."""

    id: str
    name: str
    start_s: float
    end_s: float
    agent: int
    satisfaction: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Planned(Event):
    """A plan was made, for the reasons given; ``skills`` are those still to start, by time."""

    type: ClassVar[str] = "planned"

    because: tuple[str, ...]
    status: str
    skills: tuple[Upcoming, ...]
    plan: Plan = field(compare=False, repr=False)

    def fields(self) -> Json:
        """Give everything but type and time; the plan itself is for displays."""
        return {
            "because": list(self.because),
            "status": self.status,
            "skills": [{name: _rounded(value) for name, value in asdict(one).items()} for one in self.skills],
        }


@dataclass(frozen=True, slots=True, kw_only=True)
class Moved(SkillEvent):
    """A planned start moved noticeably; None where there was, or is, none."""

    type: ClassVar[str] = "moved"

    before_s: float | None
    after_s: float | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Rejected(SkillEvent):
    """As things stand no time satisfies; a later reading may change that."""

    type: ClassVar[str] = "rejected"

    reason: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Waits(SkillEvent):
    """It has no time yet: nobody has told what it waits for."""

    type: ClassVar[str] = "waits"

    reason: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Start(SkillEvent):
    """A skill starts now: everything that whoever does it needs to know."""

    type: ClassVar[str] = "start"

    instruction: str | None
    planned_s: float
    end_s: float
    done_s: float
    agent: int
    satisfaction: float
    parameters: dict[str, str]
    fuzzy_parameters: tuple[str, ...]
    command: tuple[str, ...] | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Happens(SkillEvent):
    """Something happens by itself: there is nothing to do, and no command is run."""

    type: ClassVar[str] = "happens"

    instruction: str | None
    planned_s: float
    done_s: float
    satisfaction: float


@dataclass(frozen=True, slots=True, kw_only=True)
class End(SkillEvent):
    """The agent is free again."""

    type: ClassVar[str] = "end"

    agent: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Done(SkillEvent):
    """The result is there."""

    type: ClassVar[str] = "done"


@dataclass(frozen=True, slots=True, kw_only=True)
class Late(SkillEvent):
    """A skill takes longer than planned; ``expected_s`` is when its end is expected now."""

    type: ClassVar[str] = "late"

    planned_s: float
    expected_s: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Failed(SkillEvent):
    """A skill was begun and will not be done."""

    type: ClassVar[str] = "failed"

    reason: str
    exit_code: int | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Dropped(SkillEvent):
    """A skill will not be done, because somebody said so."""

    type: ClassVar[str] = "dropped"

    reason: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Missed(SkillEvent):
    """A start passed while nobody looked, as when the machine slept; it is planned anew."""

    type: ClassVar[str] = "missed"

    planned_s: float


@dataclass(frozen=True, slots=True, kw_only=True)
class ContextRead(Event):
    """A reading came; ``matters`` says whether a skill that is still to start depends on it."""

    type: ClassVar[str] = "context"

    signal: str
    value: float | None
    unit: str | None
    read_s: float
    matters: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class Silent(Event):
    """A sensor that matters was last read longer ago than its readings are good for."""

    type: ClassVar[str] = "silent"

    signal: str
    read_s: float
    max_age_s: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Instructed(Event):
    """An instruction came and was understood."""

    type: ClassVar[str] = "instruction"

    text: str
    ids: tuple[str, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Trouble(Event):
    """Something that came in could not be understood or done: the rest goes on."""

    type: ClassVar[str] = "problem"

    message: str
    place: str | None = None
    text: str | None = None
    span: tuple[int, int] | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Wrote(Event):
    """A command wrote a line."""

    type: ClassVar[str] = "output"

    id: str
    text: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Stopped(Event):
    """The run was stopped: what was still going on, and what had not been started."""

    type: ClassVar[str] = "stopped"

    running: tuple[str, ...]
    waiting: tuple[str, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Finished(Event):
    """The last event: what became of every skill, and how well those that did not fail satisfied."""

    type: ClassVar[str] = "finished"

    done: tuple[str, ...]
    failed: tuple[str, ...]
    dropped: tuple[str, ...]
    rejected: tuple[str, ...]
    unfinished: tuple[str, ...]
    satisfaction: dict[str, float]


def document_of(event: Event, origin: datetime) -> Json:
    """Give an event as a JSON object; ``origin`` is the run's now."""
    fields = {name: _rounded(value) for name, value in event.fields().items()}
    at = round(event.at, 3)
    instant = instant_after(origin, at).isoformat(timespec="milliseconds")
    return {"type": event.type, "at": instant, "at_s": at, **fields}


def _rounded(value: object) -> object:
    """Give a number to the millisecond, and anything else as it is."""
    return round(value, 3) if isinstance(value, float) else value
