"""Times in a text by the grammar alone: no tree, no model, no spaCy."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from datetime import datetime
from pathlib import Path

from fuzzytime.documents.kept import Kept
from fuzzytime.errors import DocumentError, InstructionError, Mistake
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.leftovers.leftovers import leftovers
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.grammar.understood.denied import denied
from fuzzytime.language.instruction import Question, Remark, RemarkKind
from fuzzytime.language.meaning.expressions import HourMark, Phrase, Repeat, Wall
from fuzzytime.language.meaning.grounded.moment import Moment
from fuzzytime.language.meaning.required.offered import alternative_to
from fuzzytime.language.meaning.required.requirements import Grounded, grounded
from fuzzytime.language.meaning.times_of_day import Half
from fuzzytime.language.meaning.ungrounded import UngroundedError
from fuzzytime.language.policy import Policy
from fuzzytime.language.recent import remembering
from fuzzytime.language.unseen import without_unseen
from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime.resources import rules_directory

LONGEST_TEXT = 4000
"""Characters that one instruction may have at most."""


@dataclass(frozen=True, slots=True)
class Times:
    """The times that a text says: grounded, with the words that were not understood among its remarks."""

    found: tuple[Grounded, ...]
    remarks: tuple[Remark, ...] = ()

    @property
    def requirements(self) -> tuple[TimeRequirement, ...]:
        """The requirements, in the order of the words."""
        return tuple(grounded.requirement for grounded in self.found)

    @property
    def questions(self) -> tuple[Question, ...]:
        """The ambiguous times."""
        return tuple(question for grounded in self.found for question in grounded.questions)


def shipped_lexicon(kept: Kept | None = None) -> Lexicon:
    """Give the shipped word tables, which are English.

    They are read once, or were ``kept`` by an earlier program.

    Raises
    ------
    DocumentError
        If a table breaks rules: every mistake with file, line and column.
    """
    if not _ONCE:
        _ONCE.append(lexicon_with((), kept))
    return _ONCE[0]


_ONCE: list[Lexicon] = []
"""The shipped word tables, once they are read: they do not change."""


def lexicon_with(customs: Iterable[Path], kept: Kept | None = None) -> Lexicon:
    """Give the shipped word tables, with customs of one's own over the calendar, each over those before it.

    Where they are ``kept``, they are read only where they have changed since.

    Raises
    ------
    OSError
        If a file cannot be read.
    DocumentError
        If a table breaks rules: every mistake with file, line and column.
    """
    rules = rules_directory()
    words, calendar, customs = rules / "lexicon.yaml", rules / "calendar.yaml", tuple(customs)

    def read() -> Lexicon:
        from fuzzytime.language.grammar.word_tables import read_lexicon

        return read_lexicon(words, calendar, customs)

    return read() if kept is None else kept.made("lexicon", (words, calendar, *customs), read)


def check_customs(customs: Iterable[Path]) -> tuple[Mistake, ...]:
    """Give every mistake of files of customs, read over the shipped calendar as `lexicon_with` reads them.

    Raises
    ------
    OSError
        If a file cannot be read.
    """
    try:
        lexicon_with(customs)
    except DocumentError as error:
        return error.mistakes
    return ()


def shipped_grammar() -> Grammar:
    """Give the shipped rules."""
    from fuzzytime.language.english import grammar

    return grammar()


def check_length(text: str) -> None:
    """Refuse a text beyond the limit.

    Raises
    ------
    InstructionError
        If it is longer than `LONGEST_TEXT`.
    """
    if len(text) > LONGEST_TEXT:
        shown = text[:LONGEST_TEXT]
        message = f"an instruction must not be longer than {LONGEST_TEXT:,} characters, got {len(text):,}"
        raise InstructionError(message, shown, (0, 0))


@remembering(512)
def find_times(
    text: str,
    now: datetime | None,
    lexicon: Lexicon | None = None,
    policy: Policy | None = None,
    grammar: Grammar | None = None,
) -> Times:
    """Give the times that a text says, by the grammar alone.

    Parameters
    ----------
    text, now
        The text, and when it is said; None for a clock that is not known.
    lexicon, grammar
        The word tables and the rules; None for the shipped ones, which are English.
    policy
        What decides where words leave it open; None for that of the tables.

    Raises
    ------
    InstructionError
        If the text is too long.

    >>> from datetime import datetime
    >>> found = find_times("in about two minutes", datetime(2026, 3, 4, 9))
    >>> found.requirements[0].t_spec, found.requirements[0].fuzziness
    (120.0, ('about',))
    """
    check_length(text)
    text = without_unseen(text)
    words = lexicon or shipped_lexicon()
    scanned = Scanned.of(text, grammar or shipped_grammar(), words)
    moment = Moment(now, policy or words.policy)
    phrases = tuple(denied(scanned.words, phrases_of(scanned), words))
    times = ground_all(phrases, text, moment)
    left = leftovers(scanned, [phrase.span for phrase in phrases])
    return replace(times, remarks=(*times.remarks, *left)) if left else times


def one_time(text: str, now: datetime, lexicon: Lexicon) -> TimeRequirement | None:
    """Give the time that a text is, whole; None where it is none, or several."""
    found = find_times(text, now, lexicon).requirements
    return found[0] if len(found) == 1 and found[0].span == (0, len(text)) else None


def ground_all(phrases: tuple[Phrase, ...], text: str, moment: Moment) -> Times:
    """Ground phrases; those that name no time become remarks."""
    found: list[tuple[Phrase, Grounded]] = []
    remarks: list[Remark] = []
    for place, phrase in enumerate(phrases):
        before = next((pair for pair in found if pair[0] is phrases[place - 1]), None)
        begun = next((one.requirement for other, one in found if _leads(other, one, phrase)), None)
        here = moment
        if begun is not None and begun.earliest is not None:
            here = replace(
                moment, since=begun.earliest, carried=False, listed=False, follows=True, onto=False
            )
        if before is not None and isinstance(phrase.said.time, HourMark) and phrase.said.time.open:
            # "Flour at ten, eggs at half past": the half past behind that ten.
            requirement = before[1].requirement
            since = requirement.latest if requirement.earliest is None else requirement.earliest
            here = replace(moment, since=since, carried=False)
        if before is not None and phrase.said.alternative and _is_part_alone(phrase):
            # "Tonight or in the morning": the morning behind that night.
            here = replace(moment, since=before[1].requirement.earliest, follows=True)
        if phrase.said.denied:
            # "Every half hour except at three": half past two is another turn.
            every = [p.said.time.every for p in phrases if isinstance(p.said.time, Repeat)]
            halves = [int(length.seconds / 120) for length in every if length is not None]
            here = replace(
                here, policy=replace(moment.policy, kept_off=min((moment.policy.kept_off, *halves)))
            )
        try:
            some = grounded(alternative_to(before, phrase, moment), text, here)
        except UngroundedError as error:
            said = text[phrase.span[0] : phrase.span[1]]
            remarks.append(Remark(RemarkKind.NOT_UNDERSTOOD, phrase.span, f"{said!r}: {error}"))
            continue
        found += ((phrase, one) for one in some)
        remarks += [remark for one in some for remark in one.remarks]
    return Times(tuple(one for _, one in found), tuple(remarks))


def _leads(first: Phrase, begun: Grounded, second: Phrase) -> bool:
    """Whether the second of two times of one thing lies behind the first."""
    constraint = begun.requirement.constraint
    if second.said.constraint is not Constraint.BEFORE:
        # "After six, preferably around seven": the seven behind that six.
        clocked = isinstance(second.said.time, Wall) and second.said.time.clock is not None
        return clocked and constraint is Constraint.AFTER
    time = first.said.time
    night = isinstance(time, Wall) and time.part is not None and time.part.half is Half.NIGHT
    if constraint is Constraint.BETWEEN:
        # "Unplug it tonight so it's dry by morning", "charge it overnight so it's ready by six"
        return night or _is_part_alone(second)
    # "At four so it's cool by six": the six behind that four.
    return constraint is Constraint.AT


def _is_part_alone(phrase: Phrase) -> bool:
    """Whether a time is a part of a day that is not said."""
    time = phrase.said.time
    return isinstance(time, Wall) and time.part is not None and time.days is None and time.clock is None
