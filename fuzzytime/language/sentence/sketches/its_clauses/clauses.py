"""Where clauses about time stand: markers, distances, ends, own times; "five minutes before you serve"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.judging.beside.titles import written_out
from fuzzytime.language.grammar.lexicon import longest_match
from fuzzytime.language.grammar.surroundings.looked_up import named_in
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Coming, Duration, Offset, Phrase, Wall
from fuzzytime.language.meaning.joined.beside import joined
from fuzzytime.language.meaning.joined.distances import LEFT
from fuzzytime.language.meaning.joined.first_times import closing_of
from fuzzytime.language.meaning.phrases import places_in
from fuzzytime.language.sentence.clauses.before_markers import OF, BeforeMarker
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.clauses.clause_contents import STATED, Contents
from fuzzytime.language.sentence.clauses.clause_sides import (
    BEHIND,
    at_most_after,
    dates,
    happens,
    is_apart,
    sided,
)
from fuzzytime.language.sentence.segments.events.event_edges import BY, OF_EDGES, is_length
from fuzzytime.language.sentence.sketches.its_clauses.at_levels import clause_of_level
from fuzzytime.language.sentence.sketches.its_clauses.ends import ClauseEnds
from fuzzytime.language.sentence.sketches.its_clauses.markers import ClauseMarkers
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.requirement import Constraint, Edge, Unit

BY_THEN = "by the time"
EVENTFUL = frozenset({"after", "before", "until", BY_THEN})
"""Clauses about an event, which may have a clock time of its own: "before the guests arrive at seven"."""

AFTER = ("after",)
COUNTED_FROM = (("before",), AFTER)
"""Markers of what distances and parts of the day count from: "the evening before the trip"."""

A_DAY = Duration(((1, Unit.DAY),))

WITHIN = (("of",), ("after",))
"""Markers behind which a bound counts from what they name: "within an hour of calling"."""


def clauses_of(
    tree: Tree, words: Sequence[Word], phrases: Sequence[Phrase], named: Sequence[Phrase] = ()
) -> list[Clause]:
    """Find the clauses of one instruction.

    A marker inside a time ("before noon") begins none. ``named`` are times that name events: "before my four
    o'clock meeting" is before four.
    """
    lexicon = tree.lexicon
    found: list[Clause] = []
    covered = places_in(phrases)
    titled = written_out(words, lexicon) | named_in(words, lexicon)
    reader = _Clauses(tree, words, phrases, named)
    place = 0
    while place < len(words):
        is_name = place in titled or (place > 0 and words[place - 1].text in lexicon.closed.sure_noun_openers)
        level = None if place in covered else clause_of_level(tree, words, place)
        unmarked = place in covered or is_name or level is not None
        form = None if unmarked else longest_match(words, place, lexicon.clauses)
        leads = form is not None and (
            reader.markers.begins_none(place, form) or reader.leads_to_distance(place, form)
        )
        if form is not None and (is_length(form, words, place, lexicon) or leads):
            # "Rest it for half as long as you cooked it"
            place += len(form)
            continue
        form = form or (reader.markers.other(place) if level is None else None)
        clause = level if form is None else reader.denied(place, form) or reader.read(place, form)
        if clause is None:
            place += 1
            continue
        found.append(clause)
        place = next((p for p, word in enumerate(words) if word.start >= clause.span[1]), len(words))
    return found


def _named_at(event: Clause, named: Phrase, day: Phrase | None) -> Clause:
    """Give an event its clock time, and the day behind it: "before the 6 am flight on saturday"."""
    if day is None or not isinstance(day.said.time, Wall) or not isinstance(named.said.time, Wall):
        return replace(event, time=named)
    both = joined(named.said.time, day.said.time)
    if both is None:
        return replace(event, time=named)
    dated = named.at(both)
    return replace(event, time=dated, span=(event.span[0], day.span[1]))


class _Clauses:
    def __init__(
        self, tree: Tree, words: Sequence[Word], phrases: Sequence[Phrase], named: Sequence[Phrase]
    ) -> None:
        self.tree, self.words, self.phrases, self.named = tree, words, phrases, named
        self.lexicon, self.covered = tree.lexicon, places_in(phrases)
        self.contents = Contents(tree, phrases, self.lexicon)
        self.before = BeforeMarker(words, phrases, self.lexicon, self.covered)
        self.ends = ClauseEnds(tree, words, phrases)
        self.markers = ClauseMarkers(self.before, self.ends)

    def leads_to_distance(self, place: int, form: tuple[str, ...]) -> bool:
        """Whether a marker bounds so long before or after an event: "until ten minutes before the parade"."""
        if self.lexicon.clauses[form] != "until" or self.denied(place, form) is not None:
            return False
        behind = place + len(form)
        ends = (p.end for p in self.phrases if p.first == behind and isinstance(p.said.time, Duration))
        return any(
            longest_match(self.words, end, self.lexicon.clauses) in COUNTED_FROM
            for end in ends
            if end < len(self.words)
        )

    def _kind(self, form: tuple[str, ...], bound: Phrase | None, edge: Edge | None) -> str:
        """Give the kind of the clause that a marker begins."""
        inverted = form[0] in self.lexicon.closed.conditional_inversion
        kind = self.lexicon.clauses.get(form, "if" if inverted else "until")
        if edge is not None:
            return OF_EDGES.get(form[0], {}).get(edge, kind)
        if bound is not None:
            return "within"
        if form == (OF,):
            return "while"
        return "by the time" if form == BY else kind

    def denied(self, place: int, form: tuple[str, ...]) -> Clause | None:
        """Read what begins so long after something: "don't start it until ten minutes after the bell"."""
        behind = self.before.behind_denied(place, form)
        clause = None if behind is None else self.read(behind, AFTER)
        return clause and replace(
            clause, kind="until", side=None, span=(self.words[place].start, clause.span[1])
        )

    def _so_far(
        self, place: int, distance: Phrase | None, kind: str
    ) -> tuple[int, Duration | None, Constraint | None]:
        """Give where a clause begins with its distance from the event, how far that is, and its bound."""
        if distance is None:
            return self.words[place].start, None, None
        side, distance = sided(distance, self.words, self.lexicon)
        start, length = distance.span[0], distance.said.time
        if isinstance(length, (Offset, Coming)):
            length = length.duration
        if not isinstance(length, Duration):
            return start, None, side
        length = replace(length, hedges=(*distance.said.hedges, *length.hedges))
        return start, length, side or at_most_after(kind, length)

    def read(self, place: int, form: tuple[str, ...]) -> Clause | None:
        """Read the clause that a marker at a place begins; None where it begins none."""
        bound = self.before.bound(place) if form in WITHIN else None
        edge, first = self.markers.edge(place + len(form)) or (None, place + len(form))
        if self._is_one_after_the_other(place, first):
            return None
        kind = self._kind(form, bound, edge)
        if edge is None and bound is not None and isinstance(bound.said.time, Coming):
            edge = Edge.START
        end, time = self._end(first, kind)
        said_end = end if time is None else time.first
        time = self.before.aside(end) if time is None else time
        if said_end <= first or self.covered.issuperset(range(first, said_end)):
            # "Once today"
            return None
        content = (self.words[first].start, self.words[said_end - 1].end)
        nodes = list(self.tree.at(*content))
        if not nodes or (form[-1] in self.lexicon.ordinals and self._is_counted(nodes[0])):
            return None
        # "Fade it out over ten seconds when he walks on", "cook it ten minutes once it boils"
        distance = bound or (None if kind in STATED else self.before.distance(place))
        start, duration, side = self._so_far(place, distance, kind)
        day_part = self._day_part(place, form) if distance is None else None
        if day_part is not None and form in COUNTED_FROM:
            start, duration = day_part.span[0], A_DAY
        if kind == "into" and duration is None:
            return None
        clause = Clause(
            kind=kind,
            marker=" ".join(form).replace(" -", "-") if bound is None else bound.said.preposition or kind,
            span=(start, content[1]),
            content=content,
            distance=duration,
            beside=self._beside(form) if (kind,) in COUNTED_FROM else None,
            edge=edge,
            side=side,
            day_part=day_part,
        )
        names = edge is not None or form == BY or (form == (OF,) and bound is None)
        return self._told(clause, nodes, (place, first), time, names=names)

    def _is_one_after_the_other(self, place: int, first: int) -> bool:
        """Whether a marker stands between "one" and "the other"."""
        behind = {word.text for word in self.words[first : first + 1]}
        one = place > 0 and self.words[place - 1].text == "one"
        return one and not self.lexicon.beside.the_other.isdisjoint(behind)

    def _told(
        self,
        clause: Clause,
        nodes: list[int],
        begins: tuple[int, int],
        time: Phrase | None,
        *,
        names: bool,
    ) -> Clause | None:
        """Give what a clause tells, as far as it goes on, with its time; None where it tells nothing.

        ``begins`` are the places of its marker and of what is behind that, which it ``names``, or tells.
        """
        place, first = begins
        if time is not None and time.said.preposition == LEFT:
            return self._left_of(clause, nodes, time)
        named = next((phrase for phrase in self.named if phrase.first == first + 1), None)
        if named is not None and (time is None or time.said.is_day) and clause.kind in EVENTFUL:
            event = self.contents.event(clause, nodes)
            return event and _named_at(event, named, time)
        told = self.contents.event(clause, nodes) if names else self.contents.told(clause, nodes)
        # "By the time the night shift clocks off at six", where a tree finds no verb.
        told = clause if told is None and clause.kind == BY_THEN and time is not None else told
        found = self._gone_on(self._denied(told, place))
        return found if found is None or time is None else self._timed(found, clause, time)

    def _timed(self, told: Clause, clause: Clause, time: Phrase) -> Clause:
        """Give what a clause tells its own time, where that is an event: "the interval, at eight"."""
        kind, occurs = clause.kind, happens(told, self.lexicon) or self._is_over(told)
        eventful = kind in EVENTFUL or (kind == "when" and occurs) or (kind == "while" and told.is_event)
        if not eventful or not dates(time, clause.distance, kind):
            return told
        return replace(told, time=time, span=(clause.span[0], time.span[1]))

    def _end(self, first: int, kind: str) -> tuple[int, Phrase | None]:
        """Give where a clause ends that begins at a place, and the time of its own behind it."""
        end = self.ends.of(first)
        last = (phrase for phrase in self.phrases if first < phrase.first and phrase.end == end)
        time = next((phrase for phrase in last if is_apart(phrase, kind)), None)
        if time is not None and self.words[time.first - 1].text in self.lexicon.closed.alternatives:
            # "Until the bell or three o'clock"
            return time.first - 1, None
        return end, time

    def _day_part(self, place: int, form: tuple[str, ...]) -> Phrase | None:
        """Give the part of a day beside a marker: "the evening before it", "on the morning of the trip"."""
        if form[-1] == OF:
            return self.before.part_of_day(place + len(form) - 1)
        return self.before.part_of_day(place) if form in COUNTED_FROM else None

    def _beside(self, form: tuple[str, ...]) -> str | None:
        """Give the hedge that a marker is: "just before", "right after"."""
        entries = self.lexicon.entries.get(form[0], ())
        return next(
            (entry.value for entry in entries if entry.category == "beside" and entry.words == form), None
        )

    def _gone_on(self, clause: Clause | None) -> Clause | None:
        """Give a clause how long what is done in it has gone on: "when it has simmered for ten minutes"."""
        if clause is None or clause.verb is None or clause.kind not in BEHIND:
            return clause
        said = (
            phrase.said.time
            for phrase in self.phrases
            if phrase.said.constraint is Constraint.FOR
            and clause.content[0] < phrase.span[0]
            and phrase.span[1] == clause.content[1]
        )
        length = next((time for time in said if isinstance(time, Duration)), None)
        return clause if length is None else replace(clause, gone_on=length)

    def _left_of(self, clause: Clause, nodes: list[int], time: Phrase) -> Clause | None:
        """Read what goes on so long yet as so long before its end: "when the roast has ten minutes left"."""
        left = closing_of(time.said)
        if left is None or clause.kind not in BEHIND or clause.distance is not None:
            return None
        named = [place for place in nodes if self.tree.nodes[place].lower not in self.lexicon.closed.have]
        before = replace(clause, kind="before", distance=left, edge=Edge.END)
        event = self.contents.event(before, named)
        return event and replace(event, span=(clause.span[0], time.span[1]))

    def _is_over(self, clause: Clause) -> bool:
        """Whether it says of something that it is done: "when the show is over"."""
        condition = clause.condition
        return condition is not None and not condition.negated and condition.word in self.lexicon.results

    def _denied(self, clause: Clause | None, place: int) -> Clause | None:
        """Give a clause as the words before its marker have it: "not when it rains" is when it does not."""
        before = [word.text for word in self.words[max(0, place - 2) : place]]
        excepted = self.lexicon.beside.excepting & {*before[-1:]} or before == ["except", "for"]
        if clause is None or not excepted:
            return clause
        if clause.condition is None or clause.kind not in {"when", "if", "while"} or before[-1:] == ["even"]:
            return replace(clause, excepted=True)
        condition = replace(clause.condition, negated=not clause.condition.negated, excepted=True)
        return replace(
            clause, kind="when", condition=condition, span=(self.words[place - 1].start, clause.span[1])
        )

    def _is_counted(self, place: int) -> bool:
        """Whether a word behind "the second" is counted: "the second tray", not "the second it boils"."""
        return self.tree.nodes[place].tag.startswith(("NN", "JJ", "CD")) or not self.tree.nodes[place].tag
