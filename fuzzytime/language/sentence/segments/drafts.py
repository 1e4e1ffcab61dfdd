"""The first pass over texts: times by the grammar, instructions apart, a tree for each, in a few batches."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import datetime

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.grammar.typed_words import MARKS, spelt
from fuzzytime.language.grammar.understood.denied import denied
from fuzzytime.language.grammar.understood.filled import as_one
from fuzzytime.language.grammar.understood.lists import closed_lists
from fuzzytime.language.grammar.understood.minutes_of_steps import says_lengths
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Operation, Order, Remark, Span, blanked
from fuzzytime.language.meaning.expressions import Phrase, Said
from fuzzytime.language.meaning.phrases import places_in
from fuzzytime.language.sentence.segments.connectives import order_words
from fuzzytime.language.sentence.segments.events.event_edges import said_apart
from fuzzytime.language.sentence.segments.events.instances import NONE, Instances, instances_of
from fuzzytime.language.sentence.segments.events.prepared_for import with_prepared_for
from fuzzytime.language.sentence.segments.heading import Heading
from fuzzytime.language.sentence.segments.lists.dividers import divided
from fuzzytime.language.sentence.segments.lists.heads import with_time_in_front
from fuzzytime.language.sentence.segments.lists.hours_of_lines import Timed, hours_in
from fuzzytime.language.sentence.segments.lists.joints import without_joints
from fuzzytime.language.sentence.segments.lists.leading_tags import (
    leading_labels,
    leading_tags,
    remarks_of_tags,
    step_titles,
    with_joints,
    without_bullets,
)
from fuzzytime.language.sentence.segments.lists.list_marks import list_marks, without_marks
from fuzzytime.language.sentence.segments.lists.named_by_time import with_named_events
from fuzzytime.language.sentence.segments.lists.numbered_periods import NumberedPeriod, numbered_periods
from fuzzytime.language.sentence.segments.lists.timed_lines import how_timed, timed_lines
from fuzzytime.language.sentence.segments.lists.unmarked import with_marks_between
from fuzzytime.language.sentence.segments.openings import lengths_in_front, openings_inside, without_reminding
from fuzzytime.language.sentence.segments.rounds import parted
from fuzzytime.language.sentence.segments.source import Source
from fuzzytime.language.sentence.segments.steps_apart import steps_apart
from fuzzytime.language.sentence.segments.taken_back.corrections import corrected
from fuzzytime.language.sentence.segments.told.asides import Aside, asides_of, beside_each_other
from fuzzytime.language.sentence.segments.told.asides_of_hours import asides_of_hours
from fuzzytime.language.sentence.segments.told.asides_of_needs import asides_of_needs
from fuzzytime.language.sentence.segments.told.gaps import with_gaps
from fuzzytime.language.sentence.segments.told.messages import Message, messages_of, orders_beside, remarks_of
from fuzzytime.language.sentence.segments.told.notes import notes_of
from fuzzytime.language.sentence.segments.told.reasons import without_threats
from fuzzytime.language.sentence.segments.told.told_apart import with_brackets_apart, with_told_apart
from fuzzytime.language.sentence.segments.told.told_lengths import told_lengths
from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.trees.tree import Trees

NAMING = "name"
"""The rule of a clock time that names an event."""

NOTED = "is taken as a note, and not planned"

TITLED = "is taken as a title, and not planned"


READ_APART = (
    without_reminding,
    with_time_in_front,
    with_gaps,
    said_apart,
    with_prepared_for,
    without_threats,
    with_told_apart,
    with_brackets_apart,
)
"""What gives a text of the same length in which more is told apart, in the order of their reading."""


@dataclass(frozen=True, slots=True)
class Draft:
    """A text with its times and its parts, before anything is grounded.

    ``step`` is its number in a numbered list; ``asides`` say how long something in it takes, and are in none
    of its parts, nor are ``messages``, which somebody is told. ``heading`` is the time that a line above
    names for it; one that ``leads`` names that of the lines below, and a ``listed`` one is among lines with
    times, as one ``beside`` others may have none. What is ``needed`` is only named. ``instances`` are several
    of one kind, of which each has a time, ``orders`` the words that say where something comes among others.
    What happens on an ``entry`` that is all a name is known from the beginning.
    ``period`` is the week, or day, of a plan that it begins with.
    """

    text: str
    now: datetime | None
    scanned: Scanned
    phrases: tuple[Phrase, ...]
    parts: tuple[Part, ...]
    remarks: tuple[Remark, ...]
    step: int | None = None
    asides: tuple[Aside, ...] = ()
    messages: tuple[Message, ...] = ()
    heading: Heading | None = None
    leads: bool = False
    listed: bool = False
    beside: bool = False
    needed: bool = False
    instances: Instances = NONE
    orders: tuple[tuple[Span, Order], ...] = ()
    entry: Operation | None = None
    period: NumberedPeriod | None = None

    @property
    def lexicon(self) -> Lexicon:
        """The words of its language."""
        return self.scanned.lexicon

    @property
    def unfinished(self) -> tuple[Span, ...]:
        """The stretches that begin a time and do not end it: "at half past"."""
        words = self.scanned.words
        covered = places_in(self.phrases)
        found = (p for p in self.scanned.pieces("unfinished") if covered.isdisjoint(range(p.start, p.end)))
        return tuple((words[piece.start].start, words[piece.end - 1].end) for piece in found)

    @property
    def naming(self) -> tuple[Phrase, ...]:
        """The clock times that name an event behind them, and so are no times: "my four o'clock meeting"."""
        words = self.scanned.words
        walls = (p for p in self.scanned.pieces("wall") if p.value.clock is not None and not p.value.bare)
        owned = (
            p
            for p in walls
            if p.start and words[p.start - 1].text in self.scanned.lexicon.closed.noun_openers
        )
        return tuple(
            Phrase(Said(p.value), p.start, p.end, (words[p.start].start, words[p.end - 1].end), NAMING)
            for p in sorted(owned, key=lambda piece: -piece.end)
        )


def drafted(
    texts: Sequence[tuple[str, datetime | None]],
    grammar: Grammar,
    lexicon: Lexicon,
    trees: Trees,
    *,
    together: bool,
) -> list[Draft]:
    """Draft texts, which may be ``together`` a list of times; ``trees`` parses."""
    entries = [(text, with_joints(without_bullets(text), lexicon), now) for text, now in texts]
    said = entries if together else []
    periods = numbered_periods([(entry, now) for _, entry, now in said], lexicon) or [None] * len(entries)
    titles = step_titles([text for text, *_ in said], trees, lexicon) or [()] * len(entries)
    fronts = [
        (*title, *((period.span,) if period else ())) for title, period in zip(titles, periods, strict=True)
    ]
    entries = [
        (text, blanked(entry, front), now) for (text, entry, now), front in zip(entries, fronts, strict=True)
    ]
    listed = [without_marks(entry, list_marks(entry, lexicon)) for _, entry, _ in entries]
    timed = timed_lines(listed, lexicon) if together else [Timed.NO] * len(listed)
    measured = together and any(says_lengths(words_of(entry), lexicon) for entry in listed)
    drafts = [
        _without_parts(text, entry, now, how, grammar, lexicon, measured=measured)
        for (text, entry, now), how in zip(entries, timed, strict=True)
    ]
    sources = [_source_of(draft) for draft in drafts]
    return [
        replace(
            draft,
            parts=tuple(parts),
            remarks=(
                *draft.remarks,
                *remarks_of(draft.text, draft.messages),
                *remarks_of_tags(draft.text, leading_tags(draft.text)),
                *(Remark.noted(draft.text, span, TITLED) for span in title),
            ),
            orders=source.orders,
            beside=together and len(texts) > 1,
            period=period,
            # Steps that each have a title are done in turn.
            step=place if title and draft.step is None else draft.step,
        )
        for place, (draft, source, parts, period, title) in enumerate(
            zip(drafts, sources, parted(sources, trees), periods, titles, strict=True), 1
        )
    ]


def _source_of(draft: Draft) -> Source:
    """Give what a draft is cut into parts by."""
    lists = closed_lists(draft.phrases, draft.scanned.words, draft.lexicon)
    phrases = tuple(as_one(lists, draft.phrases, draft.scanned.words))
    steps = dict(steps_apart(draft.scanned.words, phrases, draft.lexicon))
    apart = (*orders_beside(draft.scanned.text, draft.messages), *steps)
    meanwhile = tuple(start for start, beside in steps.items() if beside)
    further = tuple(times.further for times in lists)
    source = Source(
        draft.now, draft.scanned, phrases, draft.remarks, apart=apart, meanwhile=meanwhile, further=further
    )
    said = draft.scanned.words, source.covered, draft.lexicon
    openings = (*openings_inside(*said), *lengths_in_front(draft.scanned.words, draft.phrases, draft.lexicon))
    orders = tuple(order_words(*said))
    return replace(source, orders=orders, openings=openings)


def _without_parts(
    text: str,
    entry: str,
    now: datetime | None,
    timed: Timed,
    grammar: Grammar,
    lexicon: Lexicon,
    *,
    measured: bool,
) -> Draft:
    """Draft a text, which is an ``entry`` without its bullet, up to its parts, which need trees.

    Its remarks are what is corrected in it.
    """
    marks, tags = list_marks(entry, lexicon), leading_tags(text)
    timed = max(timed, how_timed([entry], lexicon))
    plain = with_marks_between(blanked(spelt(without_marks(entry, marks), lexicon), tags), grammar, lexicon)
    hours, listed = hours_in(plain, lexicon, timed), timed >= Timed.MOST
    plain = without_joints(plain, hours, lexicon, listed=listed)
    plain = blanked(plain, leading_labels(plain, lexicon))
    scanned = _in_entries(plain, hours, grammar, lexicon, listed=listed, measured=measured)
    messages, notes = messages_of(scanned), [*notes_of(scanned)]
    scanned = _again(scanned, blanked(scanned.text, (*notes, *(one.span for one in messages))), grammar)
    lengths = beside_each_other(asides_of(scanned), told_lengths(scanned))
    bounds = beside_each_other(asides_of_hours(scanned), asides_of_needs(scanned))
    asides = beside_each_other(lengths, bounds)
    scanned = _again(scanned, blanked(scanned.text, (aside.span for aside in asides)), grammar)
    for said in READ_APART:
        scanned = _again(scanned, said(scanned), grammar)
    scanned, instances = instances_of(scanned, grammar)
    phrases, remarks = corrected(scanned, with_named_events(scanned, phrases_of(scanned)))
    return Draft(
        text,
        now,
        scanned,
        tuple(denied(scanned.words, phrases, lexicon)),
        (),
        (*remarks, *(Remark.noted(text, span, NOTED) for span in notes)),
        step=marks[0].number if marks else None,
        asides=asides,
        messages=messages,
        instances=instances,
        listed=listed,
    )


def _in_entries(
    text: str,
    hours: frozenset[int],
    grammar: Grammar,
    lexicon: Lexicon,
    *,
    listed: bool,
    measured: bool,
) -> Scanned:
    """Scan a text with a stop between each two entries of a line; ``hours`` are marked as such."""
    marked = "".join(MARKS.get(c, c) if place in hours else c for place, c in enumerate(text))
    apart = divided(marked, grammar, lexicon, listed=listed)
    typed = "".join(text[place] if place in hours else c for place, c in enumerate(apart))
    return Scanned.of(typed, grammar, lexicon, hours=hours, measured=measured)


def _again(scanned: Scanned, text: str, grammar: Grammar) -> Scanned:
    """Scan what a text became, where it is another."""
    if text == scanned.text:
        return scanned
    return Scanned.of(text, grammar, scanned.lexicon, hours=scanned.hours, measured=scanned.measured)
