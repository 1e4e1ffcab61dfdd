"""Steps of a day, each named with when it is or how long it takes: "lecture at 2, then gym for an hour, tea".

What joins such steps tells them apart, whatever their names are: nothing is done with one of them that may be
done with the next.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.grammar.words import Word, words_of
from fuzzytime.language.instruction import Span
from fuzzytime.language.meaning.expressions import Duration
from fuzzytime.language.meaning.phrases import places_in
from fuzzytime.language.sentence.segments.lists.entries import Entry, is_when
from fuzzytime.requirement import Constraint

ENDS = frozenset({".", "!", "?"})
"""What stands between two sentences."""

LEAST = 2
"""Steps with a time of their own at least."""

LONGEST = 3
"""Words of a step's name at most, without its article."""


@dataclass(frozen=True, slots=True)
class _Step:
    """What may be a step, with its name, and the joints before it."""

    joints: tuple[Word, ...]
    entry: Entry
    name: tuple[str, ...]

    @property
    def joint(self) -> Span | None:
        """Where a stop may stand before it; None behind "then" alone, which parts what it joins."""
        found = [word for word in self.joints if word.text != "then"]
        return (found[0].start, found[-1].end) if found else None

    @property
    def is_named(self) -> bool:
        """Whether it has a name of a few words, and asks for nothing that is done with the next as well."""
        lexicon, name = self.entry.lexicon, self.name
        verbs = lexicon.orders.union(lexicon.addressing, lexicon.circling, lexicon.timing)
        verbs = verbs.union(lexicon.doing.errands, lexicon.doing.putting, lexicon.doing.several_timed)
        known = all(word[0].isalpha() and word not in lexicon.function_words for word in name)
        acts = lexicon.doing.timed.union(lexicon.asides["taking"], lexicon.asides["helping"])
        acts = acts.union(verbs if len(name) > 1 else ())
        # "Viewing at 2 and another at 3.30" is of one thing.
        called = known and 0 < len(name) <= LONGEST and not lexicon.beside.twice.issuperset(name)
        return called and name[0] not in acts and lexicon.particles.keys().isdisjoint(name)

    @property
    def is_timed(self) -> bool:
        """Whether it is a name with its time behind it, or with how long it takes in front."""
        times, end = self.entry.times, len(self.entry.words)
        lasts = bool(times) and times[0].first == 0 and isinstance(times[0].said.time, Duration)
        return self.is_named and bool(times) and (lasts or times[-1].end == end)

    @property
    def is_known(self) -> bool:
        """Whether it is one word, or holds one for what has a time: no "add flour"."""
        return len(self.name) == 1 or any(map(self._is_done, self.name))

    @property
    def is_alone(self) -> bool:
        """Whether its name alone says what one does: "a break", "breakfast"."""
        return self.is_named and not self.entry.times and self._is_done(self.name[-1])

    def _is_done(self, word: str) -> bool:
        lexicon = self.entry.lexicon
        known = lexicon.happening | lexicon.taken | lexicon.lasting
        return word in known or (word,) in lexicon.conversation["by itself"]

    @property
    def is_apart(self) -> bool:
        """Whether it is an order, or what somebody does: "finish with a song", "we're on at nine"."""
        lexicon, first = self.entry.lexicon, self.entry.words[0].text.partition("'")[0]
        return first in lexicon.closed.subject_pronouns | lexicon.orders | lexicon.doing.several_timed

    @property
    def is_led(self) -> bool:
        """Whether it goes on with nothing that is said before it in its sentence, but comes next."""
        return not self.joints or any(word.text in ENDS | {"then"} for word in self.joints)


def chained(text: str, grammar: Grammar, lexicon: Lexicon) -> list[Span]:
    """Give the joints of a text that stand between such steps, where two of them have a time."""
    if not _may_chain(list(words_of(text)), lexicon):
        # Most lines are no such chain, and to scan them costs time.
        return []
    steps = [*_steps(Scanned.of(text, grammar, lexicon))]
    if _are_from_then_on(steps):
        return [step.joint for step in steps if step.joint is not None]
    found: list[Span] = []
    run: list[_Step] = []
    for step in (*steps, None):
        goes_on = step is not None and not ENDS.intersection(word.text for word in step.joints)
        if step is not None and goes_on and run and (step.is_timed or step.is_alone or step.is_apart):
            run.append(step)
            if not step.is_apart:
                continue
        if sum(one.is_timed for one in run) >= LEAST:
            found += [one.joint for one in run[1:] if one.joint is not None]
        run = [step] if step is not None and step.is_led and step.is_timed and step.is_known else []
    return found


def _are_from_then_on(steps: Sequence[_Step]) -> bool:
    """Whether all steps of a line are named before the one time from which on they are done.

    There are three, "bath, books, bed from 6.30", or one of them is done at no hour of its own: "bath and
    stories from seven"; but "tea and cake from three".
    """
    others, last = steps[:-1], steps[-1:]
    if not others or not last[0].is_timed or len(last[0].entry.times) != 1:
        return False
    time, lexicon = last[0].entry.times[0].said, last[0].entry.lexicon
    names = [word for step in steps for word in step.name]
    somebody = not lexicon.persons.isdisjoint(names)
    alone = all(step.is_named and not step.entry.times for step in others)
    if somebody or not alone or time.preposition != "from" or time.constraint is not Constraint.AFTER:
        return False
    by_itself = lexicon.conversation["by itself"]
    return len(steps) > LEAST or any((word,) in by_itself for word in names)


def _may_chain(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether a name may stand in front of joints, and no order with its thing: "ring the bell"."""
    texts = [word.text for word in words]
    closed = lexicon.closed
    things = closed.noun_openers | closed.all_anaphors | closed.personal_pronouns
    for place in range(len(texts) - 1):
        led = not place or texts[place - 1] in ENDS | {"then"}
        first = place + (texts[place] in closed.noun_openers)
        if not led or closed.joints_of_steps.isdisjoint(texts[first:]) or texts[first : first + 1] == []:
            continue
        behind, further = (*texts[first + 1 : first + 3], "", "")[:2]
        acts = texts[first] in lexicon.orders | lexicon.addressing and behind.isalnum()
        acts = acts and behind not in lexicon.function_words
        # "Two hours of coding", "half an hour of piano"
        counted = any(lexicon.means(word, "unit") for word in (behind, further))
        if counted or not (acts or texts[first] in lexicon.function_words or behind in things):
            return True
    return False


def _steps(scanned: Scanned) -> Iterator[_Step]:
    """Give what stands between the joints of a text."""
    words, phrases = scanned.words, [phrase for phrase in phrases_of(scanned) if is_when(phrase)]
    covered = places_in(phrases)
    joints = scanned.lexicon.closed.joints_of_steps | ENDS
    parting = [p for p, word in enumerate(words) if p not in covered and word.text in joints]
    first = joint = 0
    for end in (*parting, len(words)):
        if first < end:
            inside = [p for p in phrases if first <= p.first < end]
            times = tuple(replace(p, first=p.first - first, end=p.end - first) for p in inside)
            said = [words[p].text for p in range(first, end) if p not in covered]
            name = tuple(_named(said, scanned.lexicon))
            yield _Step(words[joint:first], Entry(words[first:end], times, (), scanned.lexicon), name)
            joint = end
        first = end + 1


def _named(said: Sequence[str], lexicon: Lexicon) -> Sequence[str]:
    """Give the words of a name without what opens it, and the "of" behind a length: "an hour | of maths"."""
    opens = bool(said) and (said[0] == "of" or said[0] in lexicon.closed.noun_openers)
    return [word for word in (said[1:] if opens else said) if word != "-"]
