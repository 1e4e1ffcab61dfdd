"""What reading a text gives: instructions with their operations and time requirements, and what was left.

These values know nothing of spaCy; the rest of the program sees only them.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from datetime import datetime
from enum import StrEnum
from typing import TYPE_CHECKING

from fuzzytime.english import BEFORE_PARTICLES
from fuzzytime.requirement import Anchor, Recurrence, TimeRequirement

if TYPE_CHECKING:
    # Skills bring numpy along, which reading does without.
    from fuzzytime.skills import FuzzyParameter

Span = tuple[int, int]
"""First and one past last character in the text as typed."""


def overlap(one: Span, other: Span) -> bool:
    """Whether two stretches have a character in common."""
    return one[0] < other[1] and other[0] < one[1]


def blanked(text: str, spans: Iterable[Span]) -> str:
    """Give a text of the same length with spaces for some of its stretches.

    >>> blanked("!high call the bank", [(0, 5)])
    '      call the bank'
    """
    for first, end in spans:
        text = text[:first] + " " * (end - first) + text[end:]
    return text


class Order(StrEnum):
    """Where something is done among all that is asked for: "do the windows first", "make the coffee last"."""

    FIRST = "first"
    LAST = "last"


BROUGHT = "…"
"""What stands in a verb for what is brought somewhere."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Operation:
    """What is to be done: the verb as typed in lower case, its object and place, and the verb's span.

    ``particle`` belongs to the verb ("put on", "turn off"), ``complement`` says what the object does or
    becomes ("let the dough rest", "have the slides ready"), ``manner`` how it is done or how often: "slowly",
    "twice", ``purpose`` what for: "go out to get milk"; ``addressee`` is who was asked ("Anna, …").
    ``stated`` says that it is not asked for, but happens: of "the guests arrive at six", the object does.
    ``due`` are the words between object and verb where the object must do it: "the bread must rise".
    ``again`` says that its object was named before ("bake it").
    ``order`` says where it is done among all that is asked for.
    ``attended`` says that who speaks takes part, and can do nothing else: "I have a meeting at two".
    """

    verb: str
    lemma: str
    span: Span
    object: str | None = None
    place: str | None = None
    particle: str | None = None
    complement: str | None = None
    manner: str | None = None
    purpose: str | None = None
    addressee: str | None = None
    due: str | None = None
    negated: bool = False
    stated: bool = False
    attended: bool = False
    again: bool = False
    order: Order | None = None

    def moved(self, by: int) -> "Operation":
        """Give the same operation that many characters further on."""
        first, end = self.span
        return replace(self, span=(first + by, end + by))

    @property
    def is_asked(self) -> bool:
        """Whether it is to be done, and is not only told or denied."""
        return not self.stated and not self.negated

    @property
    def phrase(self) -> str:
        """The verb's lemma with its particle: "turn on"."""
        return " ".join(word.lower() for word in (self.lemma, self.particle) if word)

    @property
    def going(self) -> str:
        """The same with where it leads: "go home", "get to the station"; "put … to bed", of who is put."""
        # "Take off by six"; but "take the wheel off by six"
        brought = self.object is not None and (self.place is not None or self.particle is not None)
        what = BROUGHT if brought else None
        return " ".join(word.lower() for word in (self.lemma, what, self.particle, self.place) if word)

    @property
    def name(self) -> str:
        """The operation in words, without its time: "place the pan on the stove", "wake me up"."""
        inner = (self.particle, self.object)
        if self.object is not None and self.object.lower() in BEFORE_PARTICLES:
            inner = (self.object, self.particle)
        said: tuple[str | None, ...] = (self.verb, *inner, self.complement, self.place)
        if self.due is not None:
            # "The turkey needs to come out", "the coffee should be ready"
            said = (self.object, self.due, self.verb, self.particle, self.complement, self.place)
        elif self.lemma == "be" and (self.complement or self.place):
            said = (self.object, self.verb, self.particle, self.complement, self.place)
        if self.stated:
            # "Dinner is at seven": what is, is its name.
            verb = None if self.attended or self.lemma == "be" else self.verb
            said = (self.object, verb, self.particle, None if verb is None else self.complement, self.place)
        # What a statement is about may be its time: "I have office hours from two to four".
        return " ".join(part for part in (*said, self.manner, self.purpose) if part) or self.verb


@dataclass(frozen=True, slots=True, kw_only=True)
class Instruction:
    """One instruction of a text.

    Parameters
    ----------
    operation
        None for a fragment without a verb, such as "in ten minutes".
    requirements
        What was said about time, in the order of the words; anchors to other instructions are among them.
    named
        The times of what is named, told or asked of others ("cancel my alarm for six"): when that is, and not
        when to do anything.
    duration
        "for eight minutes", in seconds; None where nothing was said.
    repeats
        "every day at nine"; None where nothing was said.
    fuzzy_parameters
        "some food", "a few screws".
    length_of
        The instruction whose duration is told, as in "it takes an hour": then nothing is to be done. Without
        a target none so far is meant.
    time_of
        The instruction whose time is told, as in "it should be done by eight": then nothing more is to be
        done. Without a target all that was asked for before is meant.
    way
        How many seconds it takes to go where it is done, None where nothing was said: of the instruction
        that ``length_of`` means, if there is one.
    alone
        Whether ``duration`` is how long what it is about is left alone then: "paint it and give it an hour".
    day_of
        The position of what happens from whose day that of its times was counted, as in "the evening before
        the trip"; None where no day was.
    again
        How many times what was asked for right before is done again: "repeat twice". None elsewhere.
    """

    span: Span
    operation: Operation | None
    requirements: tuple[TimeRequirement, ...] = ()
    named: tuple[TimeRequirement, ...] = ()
    duration: float | None = None
    repeats: Recurrence | None = None
    fuzzy_parameters: tuple["FuzzyParameter", ...] = ()
    length_of: Anchor | None = None
    time_of: Anchor | None = None
    way: float | None = None
    day_of: int | None = None
    alone: bool = False
    again: int | None = None


class RemarkKind(StrEnum):
    """Why words are pointed at."""

    NOT_UNDERSTOOD = "not understood"
    UNRESOLVED = "unresolved reference"
    POLICY = "decided by policy"
    CORRECTED = "corrected by later words"
    TOLD = "told beside what is asked for"


NOT_USED = "is not used"
"""What is said of words that no name and no time holds."""


@dataclass(frozen=True, slots=True)
class Remark:
    """Words that need saying something about: which, why, and in a sentence."""

    kind: RemarkKind
    span: Span
    message: str

    @classmethod
    def noted(cls, text: str, span: Span, what: str) -> "Remark":
        """Say what is decided by policy about a stretch of a text: "'at two' is not used"."""
        return cls(RemarkKind.POLICY, span, f"{text[slice(*span)]!r} {what}")


@dataclass(frozen=True, slots=True)
class Question:
    """An ambiguous time: the words, the possible instants, the policy's choice among them (a position)."""

    span: Span
    choices: tuple[datetime, ...]
    chosen: int


@dataclass(frozen=True, slots=True)
class Token:
    """A word of the dependency tree: span, part of speech, relation as the paper names it, head, lemma."""

    text: str
    span: Span
    tag: str
    relation: str
    head: int
    lemma: str


@dataclass(frozen=True, slots=True)
class StrictReading:
    """The paper's own reading: the root verb's oblique temporal modifier, and what hangs on it.

    Each field is a position among the tokens, or None where the method finds nothing.
    """

    verb: int | None = None
    modifier: int | None = None
    number: int | None = None
    fuzziness: int | None = None
    preposition: int | None = None

    def moved(self, by: int) -> "StrictReading":
        """Give the same positions that many tokens further on."""
        places = (self.verb, self.modifier, self.number, self.fuzziness, self.preposition)
        return StrictReading(*(None if place is None else place + by for place in places))


@dataclass(frozen=True, slots=True, kw_only=True)
class Reading:
    """One text, read: its instructions, its tree, the paper's strict reading, and what needs saying.

    ``step`` is its number in a numbered list ("2. fry the onions"), None where it has none.
    """

    text: str
    now: datetime | None
    instructions: tuple[Instruction, ...]
    tokens: tuple[Token, ...] = ()
    strict: StrictReading = StrictReading()
    remarks: tuple[Remark, ...] = ()
    questions: tuple[Question, ...] = ()
    step: int | None = None
