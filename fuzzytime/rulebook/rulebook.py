"""The rulebook: from a time requirement and a context to ψ over start times, with its explanation."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType

from fuzzytime.context import Context, Reading, Signal
from fuzzytime.documents.kept import Kept
from fuzzytime.documents.nodes import Reader
from fuzzytime.errors import DocumentError, FuzzytimeError, Mistake
from fuzzytime.requirement import Anchor, Condition, Reference, TimeRequirement
from fuzzytime.rulebook.resolving.answer import answer
from fuzzytime.rulebook.resolving.beside import measured_from_event
from fuzzytime.rulebook.resolving.dependence import signals_for
from fuzzytime.rulebook.resolving.execution import over_starts, reason_for_never
from fuzzytime.rulebook.resolving.question import Question
from fuzzytime.rulebook.resolving.resolution import Resolution
from fuzzytime.rulebook.tables.contents import Tables
from fuzzytime.rulebook.tables.documents import Document, load, read_over, shipped_tables
from fuzzytime.rulebook.tables.durations import OperationDuration
from fuzzytime.rulebook.tables.profile import Actor, Profile
from fuzzytime.rulebook.wording.phrases import event_at_end
from fuzzytime.rulebook.wording.sentences import can_be_told, condition_of
from fuzzytime.rulebook.wording.told import reading_told
from fuzzytime.satisfaction import ALWAYS
from fuzzytime.times import HOUR

HORIZON = 48 * HOUR
"""Seconds from now within which conditions are looked for, where nothing else is asked."""


@dataclass(frozen=True, slots=True)
class Rulebook:
    """Tables, chosen for a profile and an actor, that give every requirement its ψ.

    >>> from fuzzytime.requirement import Constraint, TimeRequirement
    >>> rulebook = Rulebook.shipped()
    >>> said = TimeRequirement(text="in about ten minutes", span=(0, 20), constraint=Constraint.AT,
    ...                        preposition="in", fuzziness=("about",), t_spec=600.0)
    >>> rulebook.resolve(said).satisfaction([300, 900, 1200]).round(2).tolist()
    [1.0, 1.0, 0.5]
    """

    tables: Tables
    profile: Profile = Profile.EVERYDAY
    actor: Actor | None = None

    @classmethod
    def shipped(
        cls,
        profile: Profile = Profile.EVERYDAY,
        actor: Actor | None = None,
        files: Sequence[Path] = (),
        cache: Path | None = None,
    ) -> "Rulebook":
        """Load the shipped tables and, over them, files in rising precedence (user, project, ``--rules``).

        The shipped ones are kept in the folder ``cache`` as they were read.

        Raises
        ------
        DocumentError
            With every mistake of every file.
        """
        shipped = shipped_tables(profile, None if cache is None else Kept(cache))
        tables = load([Document(path, str(path)) for path in files], profile, shipped)
        return cls(tables, profile, actor)

    def with_rules(self, text: str, shown: str) -> "Rulebook":
        """Give the rulebook with a rule file's text laid over its tables; explanations call it ``shown``.

        Raises
        ------
        DocumentError
            With every mistake of the text.
        """
        tables, mistakes = read_over(self.tables, [Reader(shown, text)], self.profile)
        if mistakes:
            raise DocumentError(mistakes)
        return replace(self, tables=tables)

    @property
    def signals(self) -> Mapping[str, Signal]:
        """The signals that the tables declare: what a context may hold readings of."""
        return self.tables.signals

    def resolve(
        self,
        requirement: TimeRequirement,
        context: Context = Context.empty,
        *,
        verb: str | None = None,
        duration: float = 0.0,
        elapsed: float | None = None,
        horizon: float = HORIZON,
    ) -> Resolution:
        """Give ψ over start times on the requirement's own timeline, whose 0 is the context's as well.

        Parameters
        ----------
        requirement
            What was said. ``for`` and ``every`` bind no start by themselves and give ψ = 1: an occurrence of
            a series comes here as a requirement of its own, at its time or between two.
        context
            Readings up to now.
        verb
            The operation's lemma, with its particle ("turn on"), which rules may ask for.
        duration, elapsed
            Seconds that the agent is busy, and until the result is there (None: the same). A requirement
            about the finish is shifted by ``elapsed``; one about the whole execution is averaged over
            ``duration``.
        horizon
            Seconds within which a condition must come true.

        Raises
        ------
        FuzzytimeError
            If the context has a signal that no table declares, or a value that the signal cannot have, or a
            duration is negative or not finite.
        """
        for name, value in (("duration", duration), ("elapsed time", elapsed or 0.0), ("horizon", horizon)):
            if not 0 <= value < float("inf"):
                raise FuzzytimeError(f"a {name} must be finite and at least 0, got {value}")
        admitted = context.admitted(self.signals)
        event = event_at_end(requirement.text, self.tables)
        if event is not None and admitted.of_signal(event):
            requirement = measured_from_event(requirement, self.tables)
        said = answer(Question(requirement, verb, admitted, horizon, self.tables, self.actor))
        until_done = duration if elapsed is None else elapsed
        reference = said.reference or requirement.reference
        function = over_starts(said.satisfaction, reference, duration, until_done, horizon)
        before = until_done if reference is Reference.FINISH else 0.0
        reason = said.reason or reason_for_never(said.satisfaction, function, reference, until_done)
        return Resolution(
            satisfaction=function,
            model=said.model,
            parameters=said.parameters,
            shares=said.shares,
            hedges=said.hedges,
            reason=reason,
            untold=said.untold,
            notes=said.notes,
            trace=said.trace,
            reference=reference,
            from_readings=requirement.condition is not None or requirement.anchor is not None,
            named=None if said.named is None else said.named - before,
        )

    def signals_for(self, requirement: TimeRequirement, verb: str | None = None) -> frozenset[str]:
        """Give the signals whose readings may change what a requirement resolves to, read or not."""
        return signals_for(requirement, verb, self.tables)

    def tells(self, anchor: Anchor, context: Context) -> bool:
        """Tell whether readings can tell when something is: its words name an event, or a condition."""
        return self.tells_of(condition_of(anchor), context)

    def tells_of(self, condition: Condition, context: Context) -> bool:
        """Tell whether readings can tell when a condition holds."""
        return can_be_told(condition, self.tables, context)

    def told(self, condition: Condition, context: Context) -> Reading | None:
        """Give the reading, now, under which a condition holds that somebody tells; None where none does."""
        return reading_told(condition, self.tables, context)

    def untimed(self) -> Resolution:
        """Give ψ of an instruction without time words: satisfied at any time from now on."""
        return Resolution(
            satisfaction=ALWAYS,
            model="always",
            parameters=MappingProxyType({}),
            shares=(),
            notes=("no time was said: any time from now on satisfies",),
        )

    def left_alone(self, duration: OperationDuration, length: float, verb: str | None = None) -> float | None:
        """Give the hands-on seconds of what goes on by itself for a length, by the table of durations."""
        return self.tables.durations.left_alone(duration, length, verb)

    def in_passing(self, hands_on: float, interval: float) -> bool:
        """Say whether what takes hands so long, again and again, may be done beside something else."""
        times = self.tables.durations.in_passing
        return times is not None and interval >= times * hands_on

    def duration_of(self, lemma: str | None, thing: str | None = None) -> OperationDuration:
        """Give how long an operation takes where nobody said it, by its verb's lemma and its object."""
        return self.tables.durations.of(lemma, thing)


def check(paths: Sequence[Path] = ()) -> tuple[Mistake, ...]:
    """Give every mistake of rule files, read over the shipped ones as `Rulebook.shipped` reads them."""
    try:
        Rulebook.shipped(files=paths)
    except DocumentError as error:
        return error.mistakes
    return ()
