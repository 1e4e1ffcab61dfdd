"""Language: from texts to readings, by the grammar for times and the tree for everything around them."""

from collections.abc import Hashable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from datetime import datetime
from pathlib import Path

from fuzzytime.documents.kept import Kept
from fuzzytime.language.finding import check_length, lexicon_with, shipped_grammar, shipped_lexicon
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation, Reading, Remark, RemarkKind
from fuzzytime.language.lines import with_stops
from fuzzytime.language.policy import Policy
from fuzzytime.language.recent import Recent, moment_as_typed
from fuzzytime.language.sentence.compose import composed
from fuzzytime.language.sentence.references.mentions import Mentions
from fuzzytime.language.sentence.segments.drafts import Draft, drafted
from fuzzytime.language.sentence.sketches.meaning.clock_times import IN_ORDER, SEVERAL, LastSaid, said_in
from fuzzytime.language.sentence.together.days.headings import under_headings
from fuzzytime.language.sentence.together.days.of_the_next_day import on_next_day, through_night
from fuzzytime.language.sentence.together.none_of_it.needed_lines import with_needed
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.language.sentence.trees.model import ModelPackage, installed_model, parsed
from fuzzytime.language.sentence.trees.parse_cache import ParseCache
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.language.told_done import reported
from fuzzytime.language.unseen import without_unseen

RECENT_TREES = 1024
"""Trees that are kept in memory: those of a long conversation, or of a page."""

RECENT_READINGS = 64
"""Readings that are kept: of all that a line of a conversation may mean, and of what was said before."""


@dataclass(frozen=True, slots=True)
class Language:
    """A language: its words and rules, its policy, and a model that is loaded when a text needs it.

    Parameters
    ----------
    lexicon, grammar
        Words and rules.
    cache
        Where parses are kept, None for nowhere.

    >>> from datetime import datetime
    >>> text = "Flip the pancakes in about two minutes"
    >>> flip = Language.shipped().read(text, now=datetime(2026, 3, 4, 9)).instructions[0]
    >>> flip.operation.name, flip.requirements[0].t_spec
    ('flip the pancakes', 120.0)
    """

    lexicon: Lexicon
    grammar: Grammar
    cache: ParseCache | None = None
    _trees: Recent[str, Tree] = field(
        default_factory=lambda: Recent(RECENT_TREES), init=False, compare=False, repr=False
    )
    _readings: Recent[Hashable, list[Reading]] = field(
        default_factory=lambda: Recent(RECENT_READINGS), init=False, compare=False, repr=False
    )

    @classmethod
    def shipped(
        cls, *, cache: Path | None = None, policy: Policy | None = None, customs: Sequence[Path] = ()
    ) -> "Language":
        """Give English, with the shipped tables.

        Parameters
        ----------
        cache
            A folder where parses are kept, and the tables as they were read.
        customs
            Files of one's own parts of the day, feasts, policy and others, over the shipped calendar, each
            over those before it.
        policy
            What decides where words leave it open; None for that of the tables.

        Raises
        ------
        OSError
            If a file cannot be read.
        DocumentError
            If a table breaks rules.
        """
        kept = None if cache is None else Kept(cache)
        lexicon = lexicon_with(customs, kept) if customs else shipped_lexicon(kept)
        if policy is not None:
            lexicon = replace(lexicon, policy=policy)
        return cls(
            lexicon, shipped_grammar(), ParseCache(cache / "parses.sqlite") if cache is not None else None
        )

    def read(
        self, text: str, *, now: datetime | None = None, given: Sequence[Operation | None] = ()
    ) -> Reading:
        """Read one text.

        Parameters
        ----------
        text
            One or several instructions.
        now
            When it is said; without it, wall-clock words are not understood.
        given
            The operations of all instructions given before, which it may refer to.

        Raises
        ------
        InstructionError
            If the text is too long.
        """
        return self.read_all([(text, now)], given=given)[0]

    def read_all(
        self, texts: Iterable[tuple[str, datetime | None]], *, given: Sequence[Operation | None] = ()
    ) -> list[Reading]:
        """Read texts with their moments; each may refer to those before it, or else to those behind.

        Raises
        ------
        InstructionError
            If a text is too long.
        """
        texts = list(texts)
        key = (tuple((text, moment_as_typed(now)) for text, now in texts), tuple(given))
        known = self._readings.known([key]).get(key)
        if known is None:
            known = self._read_all(texts, given)
            self._readings.keep({key: known})
        return list(known)

    def _read_all(
        self, texts: Sequence[tuple[str, datetime | None]], given: Sequence[Operation | None]
    ) -> list[Reading]:
        drafts = under_headings(with_needed(self._drafts(texts, together=True)))
        readings, given_since, mentions = self._as_meant(drafts, given)
        told = frozenset[str]().union(*(content_words(one.object) for one in mentions.telling()))
        first = len(given)
        for place, draft in enumerate(drafts):
            behind = first + len(readings[place].instructions)
            if behind < len(mentions.operations) and _waits(readings[place], told):
                since = given_since[place]
                readings[place] = composed(draft, mentions, first, awaits=True, since=since)
            first = behind
        return self._as_typed(readings, texts)

    def _as_meant(
        self, drafts: Sequence[Draft], given: Sequence[Operation | None]
    ) -> tuple[list[Reading], list[LastSaid], Mentions]:
        """Compose drafts so that their lines go through a day, if they may, and not through the night.

        The first of them may be earlier in the day, or a little while ago where lines go on from there in
        order; in the evening, or where their first hour is over, all may be of tomorrow. What is between
        others may be at other hours than usual: "gym 9.45", "party 10.30", "lunch 12.30".
        """
        found = self._in_turn(drafts, given)
        if not found[1][-1].astray:
            return found
        begun = self._in_turn(drafts, given, over=True) if len(drafts) > IN_ORDER else found
        if begun[1][-1].in_order and begun[1][-1].astray < found[1][-1].astray:
            found = begun
        night = self._in_turn(through_night(drafts), given)
        if night[1][-1].lines >= SEVERAL and night[1][-1].forward == night[1][-1].lines:
            return night
        tomorrow = on_next_day(drafts)
        for days, early in ((drafts, True), (tomorrow, False), (tomorrow, True)):
            if days and found[1][-1].astray:
                other = self._in_turn(days, given, early=early)
                found = min(found, other, key=lambda one: one[1][-1].astray)
        over = on_next_day(drafts, over=True) if found[1][-1].astray else []
        later = self._in_turn(over, given) if over else found
        if later[1][-1].in_order and not later[1][-1].astray:
            return later
        other = self._in_turn(drafts, given, usual=False) if found[1][-1].astray else found
        said, otherwise = found[1][-1], other[1][-1]
        # Lines in no order are no nearer to one at unlikely hours; those of a night are astray all the same.
        goes_on = otherwise.in_order and otherwise.nightly <= said.nightly
        better = otherwise.astray < said.astray and (goes_on or not otherwise.astray)
        return other if better else found

    def _in_turn(
        self,
        drafts: Sequence[Draft],
        given: Sequence[Operation | None],
        *,
        early: bool = False,
        over: bool = False,
        usual: bool = True,
    ) -> tuple[list[Reading], list[LastSaid], Mentions]:
        """Compose drafts, each with what those before it said last; the last of all stands behind those."""
        mentions = Mentions(self.lexicon)
        for operation in given:
            mentions.add(operation)
        readings: list[Reading] = []
        nothing = LastSaid(early=early, over=over, usual=usual)
        said_before = [nothing]
        for draft in drafts:
            if readings and readings[-1].now != draft.now:
                # What lines said at another moment is no clue to what these mean.
                said_before[-1] = nothing
            since = said_before[-1]
            reading = composed(draft, mentions, len(mentions.operations), since=since)
            said_before.append(said_in(reading, since))
            for instruction in reading.instructions:
                mentions.told.add(len(mentions.operations), instruction, reading.now)
                mentions.add(instruction.operation)
            readings.append(reading)
        return readings, said_before, mentions

    def read_independent(self, texts: Iterable[tuple[str, datetime | None]]) -> list[Reading]:
        """Read texts that do not know of each other.

        Raises
        ------
        InstructionError
            If a text is too long.
        """
        texts = list(texts)
        drafts = self._drafts(texts, together=False)
        readings = [composed(draft, Mentions(self.lexicon), 0) for draft in drafts]
        return self._as_typed(readings, texts)

    def _as_typed(
        self, readings: Sequence[Reading], texts: Sequence[tuple[str, datetime | None]]
    ) -> list[Reading]:
        """Give readings with the texts as they were typed, and a note on those that only report."""
        return [
            _with_report(reading if reading.text == text else replace(reading, text=text), self.lexicon)
            for reading, (text, _) in zip(readings, texts, strict=True)
        ]

    def _drafts(self, texts: Sequence[tuple[str, datetime | None]], *, together: bool) -> list[Draft]:
        for text, _ in texts:
            check_length(text)
        function_words = self.lexicon.function_words
        stopped = [(with_stops(without_unseen(text), function_words), now) for text, now in texts]
        return drafted(stopped, self.grammar, self.lexicon, self.trees, together=together)

    def trees(self, texts: Sequence[str]) -> list[Tree]:
        """Parse texts, those that the cache knows without the model.

        Raises
        ------
        ModelError
            If the model is needed and not installed.
        """
        wanted = list(dict.fromkeys(text for text in texts if text.strip()))
        if not wanted:
            return [Tree(text, (), self.lexicon) for text in texts]
        known = self._trees.known(wanted)
        missing = [text for text in wanted if text not in known]
        if missing:
            made = self._parsed(missing, installed_model())
            self._trees.keep(made)
            known |= made
        return [known.get(text) or Tree(text, (), self.lexicon) for text in texts]

    def _parsed(self, texts: Sequence[str], package: ModelPackage) -> dict[str, Tree]:
        """Give the trees of texts: those kept on disk as they are there, the others parsed, and kept."""
        known = self.cache.known(texts, package, self.lexicon) if self.cache is not None else {}
        made = {
            tree.text: tree for tree in parsed([t for t in texts if t not in known], package, self.lexicon)
        }
        if self.cache is not None:
            self.cache.keep(made.values(), package)
        return known | made


def _with_report(reading: Reading, lexicon: Lexicon) -> Reading:
    """Give a reading with a note where it reports what was done, and asks for nothing: "I fed the cat"."""
    if reported(reading, lexicon) is None:
        return reading
    (instruction,) = reading.instructions
    message = f"{reading.text[slice(*instruction.span)].strip()!r} tells what was, and says nothing to do"
    remark = Remark(RemarkKind.NOT_UNDERSTOOD, instruction.span, message)
    return replace(reading, remarks=(*reading.remarks, remark))


def _waits(reading: Reading, told: frozenset[str]) -> bool:
    """Whether a reading speaks of something that no instruction so far is about, but a later one may be.

    So it does by a meal of which some line tells when it is: the words that are ``told`` of.
    """
    return any(
        requirement.condition is not None
        or (requirement.anchor is not None and requirement.anchor.target is None)
        or (requirement.anchor is None and not told.isdisjoint(content_words(requirement.text)))
        for instruction in reading.instructions
        for requirement in instruction.requirements
    )
