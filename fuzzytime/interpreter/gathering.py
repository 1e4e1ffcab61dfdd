"""Wishes one after the other, each made into skills by what was said before it."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import islice

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter.binding.bounds import bound_by, bounding
from fuzzytime.interpreter.binding.delays import since_the_step_before
from fuzzytime.interpreter.binding.in_order import Rows, without_now
from fuzzytime.interpreter.binding.meanwhile import beside_what_lasts, going_on_by_itself
from fuzzytime.interpreter.binding.references import Links
from fuzzytime.interpreter.binding.steps import is_asked
from fuzzytime.interpreter.identifiers import Identifiers
from fuzzytime.interpreter.in_other_words.retold import from_then_on
from fuzzytime.interpreter.in_other_words.why_nothing import why_nothing
from fuzzytime.interpreter.interpretation import Interpreted, Problem, ProblemKind
from fuzzytime.interpreter.making import MAX_OCCURRENCES, Maker
from fuzzytime.interpreter.notes import beside_news, by_how_much, ending_with, in_its_hours, too_few
from fuzzytime.interpreter.remarks import is_spoiled, is_told, problem_of, remarks_of
from fuzzytime.interpreter.request import DirectWish, SpokenWish
from fuzzytime.interpreter.told_anew import asks_beside_another, meant, on_its_day, told_anew
from fuzzytime.interpreter.turns.behind import Behind, behind_of
from fuzzytime.interpreter.turns.each_turn import EachTurn, each_turn_of
from fuzzytime.interpreter.turns.inside import GoingOn, going_on
from fuzzytime.interpreter.turns.of_each import OfEach, each_of, of_each
from fuzzytime.language import Instruction, Reading, reported
from fuzzytime.language.about_wishes import News, NewsKind, news_in
from fuzzytime.language.instruction import Span, overlap
from fuzzytime.times import seconds_between

Told = dict[Span, int]
"""The words of a wish that tell anew of what happens, and the position of that."""


@dataclass(slots=True)
class Gathering:
    """The skills of all wishes so far, and what was noted on the way."""

    maker: Maker
    links: Links
    rows: Rows
    skills: list[Interpreted] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)
    ahead: list[tuple[SpokenWish, Instruction]] = field(default_factory=list)
    lengths: list[tuple[int, Instruction]] = field(default_factory=list)
    waiting: list[tuple[int, SpokenWish, Reading, Instruction]] = field(default_factory=list)
    identifiers: Identifiers = field(init=False)
    _begun: int = 0
    _before: list[int] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.identifiers = Identifiers(set(self.links.wishes))

    def direct(self, wish: DirectWish) -> None:
        """Add the skill of a wish without words."""
        self._add([self.maker.direct(wish)])

    def news(self, wish: SpokenWish, reading: Reading) -> Told:
        """Take what a wish tells anew of what happens; give of which skills which words told."""
        told: Told = {}
        if not any(one.stated for one in self.skills):
            return told
        at = seconds_between(self.maker.request.now, wish.given)
        heard = news_in(wish.text, wish.given, self.maker.lexicon)
        known = any(news.kind is not NewsKind.LATE for news in heard)
        for news in heard:
            place = meant(news, self.skills, wish, at, self.maker.lexicon)
            if place is None or asks_beside_another(reading, news):
                continue
            told[news.span] = place
            if news.kind is not NewsKind.LATE:
                made = self.skills[place]
                self.skills[place] = self._told_anew(place, news, wish, reading, at)
                self._take_along(place, made)
            elif not known:
                self.problems.append(by_how_much(wish, news, self.skills[place]))
        self.problems += beside_news(wish, reading, told) if told else ()
        return told

    def _told_anew(
        self, place: int, news: News, wish: SpokenWish, reading: Reading, at: float
    ) -> Interpreted:
        made = self.skills[place]
        begun = next((one for one in self.maker.request.started if one.identifier == made.identifier), None)
        over = begun is not None and begun.start < at
        if over and news.kind is NewsKind.THERE:
            return made
        anew = told_anew(made, news, wish, reading, self.maker, at)
        # What was taken to have happened does not move: told anew it is another.
        return replace(anew, identifier=self.identifiers.of(wish)) if over and not anew.cancelled else anew

    def _take_along(self, place: int, before: Interpreted) -> None:
        """Take along what is on a day that counts from what was told anew."""
        events = {number for number, places in enumerate(self.links.instructions) if place in places}
        for other, one in enumerate(self.skills):
            if one.instruction is not None and one.instruction.day_of in events:
                self.skills[other] = on_its_day(one, before, self.skills[place], self.maker)

    def spoken(self, wish: SpokenWish, reading: Reading, told: Told) -> None:
        """Add the skills of a wish in words; what they told of what happens refers to that."""
        listed = self.rows.holds(reading)
        self._begun = len(self.links.instructions)
        about: list[tuple[Instruction, range]] = []
        for instruction in reading.instructions:
            news = [place for span, place in told.items() if overlap(span, instruction.span)]
            if news:
                self.links.instructions.append(range(news[0], news[0] + 1))
                continue
            if reported(reading, self.maker.lexicon) is not None:
                self.links.done.add(len(self.links.instructions))
            places = self._take(wish, reading, instruction, listed=listed)
            self.links.instructions.append(places)
            about.append((instruction, places))
        said = [place for one, places in about for place in places if one.again is None]
        self._before = said or self._before
        if not listed:
            self.rows.join(reading, about, self.skills, self.maker.lexicon)

    def _take(self, wish: SpokenWish, reading: Reading, instruction: Instruction, *, listed: bool) -> range:
        """Take what an instruction tells or asks for, and give the places of the skills that it is about."""
        instruction = bounding(instruction, reading, self.maker.lexicon) if listed else instruction
        if instruction.length_of is not None:
            told = instruction.length_of.target
            if told is not None and told >= len(self.links.instructions):
                # "The gel takes 90 minutes, start it before lunch"
                self.lengths.append((len(self.links.instructions), instruction))
                return range(0)
            lengthened = self._lengthened(instruction)
            self._go_there(wish, reading, instruction, instruction.length_of.target)
            return lengthened
        if instruction.again is not None:
            again = self._again(instruction.again, listed=listed)
            if not again:
                what = "names nothing to repeat: say again what is to be done"
                self.problems.append(problem_of(wish, ProblemKind.NOT_UNDERSTOOD, what, instruction.span))
            return again
        if instruction.time_of is not None and not any(one.asked for one in self.skills):
            # "Everything must be done by six", said before anything is asked for.
            self.ahead.append((wish, instruction))
            return range(0)
        timed = self._timed_by(instruction)
        if timed is not None:
            for place in timed:
                self._time(place, instruction, wish)
            return timed[-1:]
        given = self.links.instructions, self.skills, self.maker.lexicon
        instruction = beside_what_lasts(instruction, *given)
        for place in going_on_by_itself(instruction, *given):
            self.skills[place] = self.maker.how_long.by_itself(self.skills[place])
        step = instruction
        if listed and self.rows.begun:
            since = seconds_between(self.maker.request.now, wish.given)
            mornings = [one.skill.until - since for one in self.skills if one.skill.until is not None]
            step = from_then_on(without_now(instruction), self.maker.lexicon, mornings)
            step = since_the_step_before(step, reading, *given)
        if self._is_of_what_comes(step):
            self.waiting.append((len(self.links.instructions), wish, reading, step))
            return range(0)
        made = self._make(wish, reading, step)
        if listed:
            self.rows.add(self.skills, made, len(self.links.instructions))
        self._go_there(wish, reading, instruction, len(self.links.instructions))
        return made

    def _again(self, times: int, *, listed: bool) -> range:
        """Do again, so many times, what this text asked for so far, or else the one before it."""
        known = self.links.instructions
        here = known[self._begun :]
        # "Hamstrings: hold thirty seconds, repeat twice": nothing else is meant where that is not understood
        said = [place for places in here for place in places] if here else self._before
        copied = [self.skills[place] for place in said if is_asked(self.skills[place])]
        for one in islice(copied * times, MAX_OCCURRENCES):
            last = len(self.skills) - 1
            if isinstance(one.wish, SpokenWish) and one.reading is not None and one.instruction is not None:
                made = self._make(one.wish, one.reading, replace(one.instruction, requirements=()))
                if listed:
                    self.rows.add(self.skills, made, len(known))
                elif made:
                    self.rows.follow(last, made[0], self.skills)
        return range(len(self.skills) - 1, len(self.skills)) if copied else range(0)

    def _is_of_what_comes(self, instruction: Instruction) -> bool:
        """Whether it is done beside each of what is told only behind it: how often is known then."""
        here, late = len(self.links.instructions), {place for place, *_ in self.waiting}
        return any(one > here or one in late for one in each_of(instruction))

    def finish(self) -> None:
        """Make what waited for others, and let all be done by when words ahead of it said so."""
        for place, instruction in self.lengths:
            self.links.instructions[place] = self._lengthened(instruction)
        late = [place for place, *_ in self.waiting]
        # What waits for its like is last.
        self.waiting.sort(key=lambda one: max((p for p in each_of(one[3]) if p in late), default=-1))
        for place, wish, reading, instruction in self.waiting:
            self.links.instructions[place] = self._make(wish, reading, instruction)
        for wish, instruction in self.ahead:
            if not any(one.asked for one in self.skills):
                what = "says when all must be done, and nothing is asked for"
                self.problems.append(problem_of(wish, ProblemKind.NOTHING_TO_DO, what, instruction.span))
            for place in bound_by(instruction, self.skills, self.maker.lexicon):
                self._time(place, instruction, wish)

    def _make(self, wish: SpokenWish, reading: Reading, instruction: Instruction) -> range:
        """Make an instruction's skills, and give their places."""
        given = instruction, self.links.instructions, self.skills
        inside = going_on(*given, self.maker.lexicon)
        # What lasts is gone on from: "stain it for five minutes, wash three times, two minutes each".
        lasted = [one for one in reading.instructions if one.span[1] <= instruction.span[0]][-1:]
        stepwise = self.rows.begun or any(one.duration is not None for one in lasted)
        behind = behind_of(*given, stepwise=stepwise) or each_turn_of(*given)
        made = self._skills_of(wish, reading, instruction, inside or behind, of_each(*given))
        if inside is not None and made:
            self.problems.append(ending_with(wish, instruction, inside))
        self.problems += [note for one in made[:1] for note in in_its_hours(wish, instruction, one)]
        first = len(self.skills)
        self._add(made)
        return range(first, len(self.skills))

    def _skills_of(
        self,
        wish: SpokenWish,
        reading: Reading,
        instruction: Instruction,
        inside: GoingOn | Behind | EachTurn | None,
        beside: OfEach | None,
    ) -> list[Interpreted]:
        """Make an instruction's skills; where there is none to make, say why."""
        if is_told(instruction, reading) or is_spoiled(instruction, reading, remarks_of(reading, wish)):
            return []
        why_none = why_nothing(instruction, reading, self.skills, self.maker.lexicon)
        if why_none is None:
            try:
                made = self.maker.spoken(wish, reading, instruction, inside, beside)
            except FuzzytimeError as error:
                self.problems.append(problem_of(wish, ProblemKind.UNREADABLE, str(error), instruction.span))
                return []
            if made:
                return made
            why_none = "does not occur within the horizon" if beside is None else too_few(beside)
        self.problems.append(problem_of(wish, ProblemKind.NOTHING_TO_DO, why_none, instruction.span))
        return []

    def _add(self, made: Sequence[Interpreted]) -> None:
        self.skills += [replace(one, identifier=self.identifiers.of(one.wish)) for one in made]

    def _timed_by(self, instruction: Instruction) -> range | None:
        """Give the skills of which an instruction tells when they must be done: "it must be done by six"."""
        told = instruction.time_of
        if told is None:
            return None
        if told.target is None:
            return bound_by(instruction, self.skills, self.maker.lexicon)
        meant = self.links.skills_of(told.target)
        return meant if len(meant) == 1 and isinstance(self.skills[meant[0]].wish, SpokenWish) else None

    def _time(self, place: int, instruction: Instruction, wish: SpokenWish) -> None:
        """Let a skill be done by when an instruction tells, unless it was asked for later than that."""
        made = self.skills[place]
        if not made.asked:
            return
        timed = self.maker.timed(made, instruction, wish.given)
        if timed.skill.satisfaction.support.empty and not made.skill.satisfaction.support.empty:
            said = " ".join(part.text for part in instruction.requirements)
            message = f"{made.skill.name} is asked for later than {said!r}, and keeps its time"
            self.problems.append(problem_of(wish, ProblemKind.NOTE, message, instruction.span))
            return
        self.skills[place] = timed

    def _go_there(
        self, wish: SpokenWish, reading: Reading, instruction: Instruction, target: int | None
    ) -> None:
        """Add the way to where something is done or happens, right before that."""
        meant = range(0) if target is None else self._skills_at(target)
        if instruction.way is None or target is None or not meant:
            return
        operation = self.skills[meant[0]].operation
        if operation is not None and operation.lemma in self.maker.lexicon.doing.leaving:
            # "We leave at six, the drive takes an hour"
            self.skills[meant[0]] = self.maker.how_long.lasting(self.skills[meant[0]], instruction.way)
            return
        self._add([self.maker.way(wish, reading, instruction, self.skills[meant[0]], target)])

    def _skills_at(self, target: int) -> range:
        if target < len(self.links.instructions):
            return self.links.skills_of(target)
        return range(len(self.skills) - 1, len(self.skills)) if self.skills else range(0)

    def _lengthened(self, instruction: Instruction) -> range:
        """Let skills go on for as long as an instruction tells ("it takes an hour"), and give their places.

        Who refers to these words means what they are about.
        """
        told, length = instruction.length_of, instruction.duration
        if told is None or told.target is None or length is None:
            return range(0)
        meant = self.links.skills_of(told.target)
        for place in meant:
            self.skills[place] = self.maker.lengthened(self.skills[place], length, alone=instruction.alone)
        return meant
