"""One clause about time, as read: what begins it, and what it says."""

from dataclasses import dataclass, replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Span
from fuzzytime.language.meaning.expressions import Duration, Phrase
from fuzzytime.requirement import Condition, Constraint, Edge, Reference


@dataclass(frozen=True, slots=True)
class Clause:
    """A clause: what begins it (its kind and as said), its stretch, that of what it says, a distance before.

    ``verb`` and ``object`` are what it says is done, as dictionary form and text; ``condition`` what it
    says must hold; ``time`` when it says that is ("before the guests arrive at seven"). ``excepted`` marks
    when not to do something: "but not during her nap". ``takes`` is how long it takes until it is so,
    where an aside says that. ``beside`` is the hedge that puts it right beside: "just before we leave".
    ``reference`` is which moment of what is to be done it is about: "have it ready when they come".
    ``edge`` is that of the event which it names: "by the end of the lesson"; ``side`` on which side of its
    distance something must be: "no earlier than an hour after lunch"; ``day_part`` the part of the day, a day
    before or after: "the evening before the trip". ``alternative`` says that it may be so instead of the time
    before it: "at six or when it is full". ``gone_on`` is how long what it names has gone on by then:
    "when it has simmered for ten minutes". ``where`` are its words from the first on that says where: "in the
    oven", "on". ``further`` is what else it says is done: "once the car is washed and the lawn is mown".
    """

    kind: str
    marker: str
    span: Span
    content: Span
    verb: str | None = None
    object: str | None = None
    condition: Condition | None = None
    distance: Duration | None = None
    is_event: bool = False
    time: Phrase | None = None
    excepted: bool = False
    takes: Duration | None = None
    beside: str | None = None
    reference: Reference | None = None
    edge: Edge | None = None
    side: Constraint | None = None
    day_part: Phrase | None = None
    alternative: bool = False
    gone_on: Duration | None = None
    where: str | None = None
    further: tuple["Clause", ...] = ()

    def since_begun(self) -> "Clause":
        """Give the same clause counted from where that begins which it says has gone on for so long."""
        if self.gone_on is None:
            return self
        further = () if self.distance is None else self.distance.terms
        distance = replace(self.gone_on, terms=(*self.gone_on.terms, *further))
        return replace(self, distance=distance, edge=Edge.START, gone_on=None)

    def is_through(self, lexicon: Lexicon) -> bool:
        """Whether who speaks, or is spoken to, is through: "once we're done", but not "when I'm ready"."""
        if self.condition is None:
            return False
        subject, through = self.condition.subject, (self.condition.word or "",)
        speaks = subject in lexicon.closed.first_person and through in lexicon.conversation["having"]
        return speaks or subject == "you"

    def is_there(self, lexicon: Lexicon) -> bool:
        """Whether it says of somebody that they have come: "when they get here", "while she is in"."""
        known = self.condition is not None and not lexicon.closed.adverbs_of_arrival.isdisjoint(
            {self.condition.word, self.object}
        )
        return self.verb in lexicon.doing.getting and known

    def moved(self, by: int) -> "Clause":
        """Give the same clause that many characters further on."""
        (a, b), (c, d) = self.span, self.content
        further = tuple(one.moved(by) for one in self.further)
        return replace(self, span=(a + by, b + by), content=(c + by, d + by), further=further)
