"""What a clause tells of one planned thing: when it is to be, by when, beside what, or how long it takes.

Whatever the words are, such a clause has who or what it is of in front of a finite verb, and its time at
the end: "customer wants the cake by half two", "physio can only see me at five". Each word between must be
of a kind that tells what is said; of others nothing is known, and nothing is read.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property

from fuzzytime.language.about_wishes.corrections import opening_correction
from fuzzytime.language.about_wishes.lengths import DIRECTIONS, counted, in_full
from fuzzytime.language.about_wishes.said import Said
from fuzzytime.language.about_wishes.told.awaited import written_out
from fuzzytime.language.finding import one_time
from fuzzytime.requirement import Constraint

KINDS = (
    "denied",
    "moving",
    "waiting",
    "able to",
    "wanting",
    "being over",
    "going on for",
    "helping",
    "beside verbs",
    "whom",
    *DIRECTIONS,
)
"""Tables of the words that may stand between what is told of and its time, the more telling first."""

BY_A_LENGTH = ("late", "early", "more", *DIRECTIONS)
"""Tables of what may stand beside a length, and tells what that changes."""

SOONER = frozenset({"early", "earlier"})
LATER = frozenset({"late", "later"})

LONGEST_NAME = 6
"""Words that a thing, or who tells of it, is called by at most."""

LONGEST = 24
"""Words of a clause that is read so."""

IT, NO, NOT, AND, THE = "it", "no", "not", "and", "the"

Knows = Callable[[Said], bool]
"""Whether words name something that was asked for; "it" is what was spoken of last."""

Does = Callable[[Said, str], bool]
"""Whether a word says what is done with a thing: "bathed", of the kids who are to be."""


def of_planned(clause: Said, knows: Knows, does: Does) -> tuple[str, ...]:
    """Give what a clause tells of something planned as orders; none where it tells nothing that is known."""
    said = Said.of(clause.text, clause.now, clause.lexicon).without_exclamations()
    while (taken := said.opens_with("told openers")) and taken < len(said.words):
        said = said.behind(taken)
    # "They want us on at half eight now"
    now = said.without_end(said.table("anew") | said.table("instead"))
    # "Before then"
    said = now if now.forms[-1:] not in said.lexicon.clauses else said
    none_wanted = said.forms[:1] == (NO,) and said.forms[1:2] != (",",)
    said = said if none_wanted else said.behind(opening_correction(said))
    if said.asks or not 2 < len(said.words) <= LONGEST or "," in said.forms:
        return ()
    for text in dict.fromkeys((said.text, written_out(said.text))):
        whole = Said(text, said.now, said.lexicon)
        for joint in (len(whole.words), *(n for n, word in enumerate(whole.forms) if word == AND)):
            front = _one(whole.until(joint), knows, does)
            rest = whole.behind(joint + 1)
            if front is None or not rest.words:
                if front is not None:
                    return (front.order,)
                continue
            # "The chicken needs an hour and has to be out by six"
            again = Said(f"{front.thing.text} {rest.text}", whole.now, whole.lexicon)
            behind = _one(rest, knows, does) or _one(again, knows, does)
            if behind is not None:
                return front.order, behind.order
    return ()


def _one(said: Said, knows: Knows, does: Does) -> "_Told | None":
    """Read a clause that tells one thing."""
    for thing, rest, kinds in _subjects(said, knows, does):
        for read in _behind(thing, rest, kinds, knows, does):
            if read.order:
                return read
    return None


def _subjects(said: Said, knows: Knows, does: Does) -> Iterator[tuple[Said | None, Said, frozenset[str]]]:
    """Give what is in front of the finite verb, as far as it names what is planned, and what is behind it."""
    if said.forms[:1] == (NO,):
        # "No mowing before four"
        for end in range(min(len(said.words), LONGEST_NAME) - 1, 1, -1):
            if knows(thing := said.until(end).behind(1)):
                yield thing, said.behind(end), frozenset({"denied", "helping"})
        return
    if said.forms[0] in said.lexicon.closed.requesting_modals and len(said.words) > 1:
        # "Could judo start half an hour earlier"
        yield None, said.behind(1), frozenset({"helping"})
        return
    places = range(1, min(len(said.words), LONGEST_NAME + 1))
    place = next((n for n in places if said.behind(n).opens_with("telling") or said.behind(n).beside()), 0)
    if not place:
        return
    who, rest = said.until(place), said.behind(place)
    if not rest.opens_with("telling"):
        # "Groceries before that"
        if knows(who) and not who.has_time:
            yield who, rest, frozenset({"helping"})
        return
    # "The lawn probably takes an hour"
    who = who.without_end(who.table("beside verbs"))
    opened = Said(f"{THE} {who.text}", who.now, who.lexicon)
    # "Tutor wants to start at four", though to tutor is something to be done
    who = opened if len(who.words) == 1 and not knows(who) and knows(opened) else who
    told = who if len(who.words) == 1 or not does(who.behind(1), who.forms[0]) else who.behind(1)
    if knows(told) and not told.is_in("last") and not told.is_in("they"):
        # "Call the bank has been moved back half an hour"
        yield told, rest, frozenset()
    elif not who.has_time:
        yield None, rest, frozenset({"they"} if who.is_in("they") or who.is_in("last") else set())


def _behind(
    subject: Said | None, said: Said, kinds: frozenset[str], knows: Knows, does: Does
) -> Iterator["_Told"]:
    """Give each reading of a verb with what stands behind it, whose end is a time, or what it is beside."""
    place, thing, found, ends = 0, subject, set(kinds), list[tuple[int, Said | None, frozenset[str]]]()
    while place < len(said.words):
        if place or kinds & {"denied", "helping"}:
            ends.append((place, thing, frozenset(found)))
        rest = said.behind(place)
        taken = max(rest.opens_with(name) for name in KINDS)
        own = next((end for end in _ends(rest) if knows(rest.until(end))), 0) if thing is None else 0
        if own and own >= taken and not rest.until(own).is_in("last"):
            thing, taken = rest.until(own), own
        elif taken:
            found |= {name for name in KINDS if rest.opens_with(name) == taken}
            found |= {IT} if rest.until(taken).is_in("last") else set()
        elif thing is not None and does(thing, rest.forms[0]):
            taken, found = 1, {*found, "being over", "able to"}
        else:
            break
        place += taken
    for end, known, of in reversed(ends):
        # "The boss needs it by one"; of "they" alone, what was spoken of last
        meant = known or (Said(IT, said.now, said.lexicon) if of & {IT, "they"} else None)
        if meant is not None and (meant is known or knows(meant)):
            yield _Told(meant, of, said.behind(end), knows)


def _ends(said: Said) -> range:
    return range(min(len(said.words), LONGEST_NAME), 0, -1)


@dataclass(frozen=True)
class _Told:
    """What a clause is of, the kinds of the words that tell it, and how it ends."""

    thing: Said
    kinds: frozenset[str]
    end: Said
    knows: Knows

    @property
    def name(self) -> str:
        """What it is called in an order: "s3" of "step 3"."""
        return self.thing.label or self.thing.text

    @cached_property
    def order(self) -> str:
        """Say it as an order; empty where that is not known."""
        return self._beside() or self._of_length() or self._of_time()

    def _beside(self) -> str:
        """Say beside what it is to be: "before the viewing"."""
        beside = self.end.beside()
        if beside is None:
            return ""
        other = beside[1]
        begins = other.lexicon.doing.arriving | other.lexicon.doing.beginning
        end = len(other.words) - 1
        if end and other.forms[end].removesuffix("s") in begins and self.knows(other.until(end)):
            # "Before the tutor comes"; but "before the chicken comes out"
            other = other.until(end)
        way = other.lexicon.clauses.get(self.end.forms[:1])
        if way not in {"before", "after"} or not self.knows(other) or other.text == self.thing.text:
            return ""
        if "denied" in self.kinds:
            way = "after" if way == "before" else ""
        return f"move {self.name} to {way} {other.text}" if way and not self.kinds <= {"whom"} else ""

    def _of_length(self) -> str:
        """Say by how much it moves, or how long it takes: "is running half an hour late", "takes an hour"."""
        left, tables = self.end.without(*BY_A_LENGTH)
        # "Mum's running fifteen late"
        left = counted(left) if tables & (SOONER | LATER) else left
        ways = (tables | self.kinds) & {*BY_A_LENGTH, "moving"}
        found = left.length() or (self.end.length() if "more" in tables else None)
        if found is None or found.rest.words or "denied" in self.kinds:
            return ""
        length = left.text.removeprefix("by ").removeprefix("for ")
        if "more" in ways:
            # "This will take another hour"
            length = in_full(left).text if len(left.words) == 1 else length
            return f"make {self.name} {length} longer" if not ways & (SOONER | LATER) else ""
        if ways & SOONER:
            return f"bring {self.name} forward by {length}"
        if ways:
            return f"push {self.name} back by {length}"
        lasts = "going on for" in self.kinds and "being over" not in self.kinds
        return f"make {self.name} {length}" if lasts else ""

    def _of_time(self) -> str:
        """Say when it is to be, by when, or from when on."""
        time, denied = self.end.as_time(), "denied" in self.kinds
        read = one_time(time, self.end.now, self.end.lexicon) if time else None
        if read is None or read.constraint is Constraint.FOR or (read.t_spec or read.latest) is None:
            return ""
        until = any(self.end.text.lower().startswith(to) for to in self.end.towards)
        over = "being over" in self.kinds and "able to" not in self.kinds
        moves = bool(self.kinds & {"moving", "waiting"})
        if denied:
            return self._denied(time, read.constraint, until=until)
        if read.constraint is Constraint.BEFORE and self.kinds & {"wanting", "helping", "able to"}:
            return f"move {self.name} to {time}"
        says_when = moves or (self.kinds & {"able to", "wanting"} and not until)
        # What "is at six" is told elsewhere; and what is over then begins before.
        return f"move {self.name} to {time.removeprefix('at ')}" if says_when and not over else ""

    def _denied(self, time: str, constraint: Constraint, *, until: bool) -> str:
        """Say from when on something may be that cannot be before, or by when what cannot be later."""
        end = self.end
        if until or constraint is Constraint.BEFORE:
            clock = next((end.text[len(to) :] for to in end.towards if end.text.lower().startswith(to)), "")
            bound = f"not before {clock}" if until else f"{NOT} {time}"
        elif end.opens_with("later") or end.lexicon.clauses.get(end.forms[:1]) == "after":
            bound = f"{NOT} {end.text}"
        else:
            # By how much "it can't go on past seven" shortens it, or when it begins then, is not said.
            return ""
        read = one_time(bound, end.now, end.lexicon)
        known = {Constraint.AFTER} if until or constraint is Constraint.BEFORE else {Constraint.BEFORE}
        return f"move {self.name} to {bound}" if read is not None and read.constraint in known else ""
