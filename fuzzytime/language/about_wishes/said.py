"""A line of a conversation with its words, and the times, lengths and names in it."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from functools import cached_property

from fuzzytime.language.finding import find_times, one_time
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word, words_of
from fuzzytime.language.meaning.units import UNIT_SECONDS
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.requirement import Constraint, TimeRequirement, Unit

Form = tuple[str, ...]

LABEL = re.compile(r"s[1-9]\d{0,8}(?:\.[1-9]\d{0,8})?")
"""How the list calls what was asked for, or one of several things that a line asks for."""

CLOCKED = frozenset({Unit.HOUR, Unit.MINUTE, Unit.SECOND})
"""The grains of clock times."""

LONGEST = 24
"""Words of a line in which a length is looked for."""

MARK = re.compile(r"[,.;](?!\S)")
"""What stands between clauses; but not in "s1.2", "9.30"."""

ENDS = ".?! "
"""Marks at the ends of a line."""

ASKING = ("what", "when", "why", "lasting", "supposing")
"""Tables of what opens a question."""

FOR, AT, FROM = "for ", "at ", "from "


@dataclass(frozen=True)
class Length:
    """A length of time in seconds, the word in front of it ("by", "for") if any, and the rest of the line."""

    seconds: float
    joint: str
    rest: "Said"


@dataclass(frozen=True)
class Said:
    """A line without what opens and ends it.

    ``now`` is when it is said, ``words`` are those of ``text``.
    """

    text: str
    now: datetime
    lexicon: Lexicon

    @classmethod
    def of(cls, text: str, now: datetime, lexicon: Lexicon) -> "Said":
        """Give a line without the marks at its ends."""
        return cls(text.strip(ENDS), now, lexicon)

    @cached_property
    def words(self) -> Sequence[Word]:
        """The words."""
        return words_of(self.text)

    @cached_property
    def forms(self) -> Form:
        """The words as forms of the tables."""
        return tuple(word.text for word in self.words)

    def behind(self, place: int) -> "Said":
        """Give what stands from a word on."""
        text = self.text[self.words[place].start :] if place < len(self.words) else ""
        return Said(text, self.now, self.lexicon)

    def until(self, place: int) -> "Said":
        """Give what stands before a word."""
        text = self.text[: self.words[place].start] if place < len(self.words) else self.text
        return Said(text.rstrip(" ,"), self.now, self.lexicon)

    def table(self, name: str) -> frozenset[Form]:
        """Give a table of what is said in a conversation."""
        return self.lexicon.conversation[name]

    @cached_property
    def is_one(self) -> bool:
        """Whether it is one clause, as far as its marks tell."""
        return MARK.search(self.text) is None

    def is_in(self, name: str) -> bool:
        """Whether it is, whole, an entry of a table; nothing at all is one where "" is."""
        return self.forms in self.table(name)

    def without_thanks(self) -> "Said":
        """Leave out what is polite behind something else: "the soup first, please"."""
        return self.without_end(self.lexicon.courtesies)

    def without_end(self, forms: frozenset[Form]) -> "Said":
        """Leave out the longest of some forms that ends it, and is not all of it."""
        behind = (form for form in forms if self.forms[-len(form) :] == form != self.forms)
        return self.until(len(self.words) - max(map(len, behind), default=0))

    def without_exclamations(self) -> "Said":
        """Leave out what opens a line and says nothing of wishes: "oh", "hmm, maybe", "ok then"."""
        said = self
        while (taken := said.opens_with("exclaiming")) and taken < len(said.words):
            rest = said.behind(taken)
            said = rest.behind(1) if rest.forms[:1] == (",",) and len(rest.words) > 1 else rest
        return said

    @property
    def towards(self) -> tuple[str, ...]:
        """The words between what is moved and the time that it is moved to, each with a space behind it."""
        found = (f"{' '.join(form)} " for form in self.table("towards"))
        return tuple(sorted(found, key=lambda words: (-len(words), words)))

    @property
    def asks(self) -> bool:
        """Whether it opens a question: "why is the call after the gym"."""
        return any(self.opens_with(name) for name in ASKING)

    def opens_with(self, name: str) -> int:
        """Give how many words an entry of a table has with which it begins; 0 for none."""
        return len(longest_match(self.words, 0, self.table(name)) or ()) if self.words else 0

    def ends_with(self, name: str) -> int:
        """Give how many words an entry of a table has with which it ends; 0 for none."""
        return max((len(form) for form in self.table(name) if self.forms[-len(form) :] == form), default=0)

    def after(self, name: str) -> "Said | None":
        """Give what stands behind an entry of a table with which it begins; None where it does not."""
        taken = self.opens_with(name)
        return self.behind(taken) if taken else None

    def without(self, *names: str) -> tuple["Said", frozenset[str]]:
        """Leave out every entry of some tables, and say of which tables there were any."""
        place, kept, found = 0, "", set[str]()
        while place < len(self.words):
            matched = {name: longest_match(self.words, place, self.table(name)) for name in names}
            longest = max(matched, key=lambda name: len(matched[name] or ()))
            form = matched[longest]
            # "The pick-up" goes nowhere.
            if form and not (place and self.words[place].glued):
                found.add(longest)
                place += len(form)
            else:
                word = self.words[place]
                kept += ("" if word.glued else " ") + self.text[word.start : word.end]
                place += 1
        return Said(kept.strip(), self.now, self.lexicon), frozenset(found)

    @cached_property
    def names(self) -> frozenset[str]:
        """Give the words that name something."""
        courteous = {form[0] for form in self.lexicon.courtesies}
        return content_words(self.text) - courteous - self.lexicon.closed.first_person

    @cached_property
    def label(self) -> str:
        """What is called so by a number, as it is labelled: "s2" of "2", "number two", "s2"; else empty."""
        if LABEL.fullmatch(self.text.lower()) is not None:
            return self.text.lower()
        rest = self.after("numbering") or self
        word = rest.forms[0] if len(rest.forms) == 1 else ""
        known = rest is not self or word.isdecimal()
        number = self.lexicon.numbers.get(word, word)
        return f"s{int(number)}" if known and str(number).isdecimal() and len(word) <= LONGEST else ""

    @property
    def meant(self) -> frozenset[str]:
        """Give the words, or the label, that name what is meant; none where that was spoken of last."""
        if self.label:
            return frozenset({self.label})
        return frozenset() if self.is_in("last") else self.names

    @cached_property
    def places(self) -> tuple[int, ...]:
        """Which ones of a list it is: of "the second one", "the last two"; none where it is no such thing."""
        forms = self.forms[1:] if self.forms[:1] == ("the",) else self.forms
        count, forms = self._counted(forms)
        named = not forms or forms in self.table("listed")
        return count if named and len(self.forms) > 1 else ()

    def _counted(self, forms: Form) -> tuple[tuple[int, ...], Form]:
        """Give the places that words begin with, and the rest: of "last two ones", -2, -1 and "ones"."""
        numbers = self.lexicon.numbers
        last = forms[:1] == ("last",)
        first = forms[:1] and self.lexicon.ordinals.get(forms[0])
        count = numbers.get(forms[1], 0) if len(forms) > 1 else 0
        if count > 1 and (last or first == 1):
            return tuple(range(-count, 0) if last else range(1, count + 1)), forms[2:]
        if last or first:
            return (-1 if last else int(first or 0),), forms[1:]
        return (), forms

    # -- times and lengths ----------------------------------------------------------------------------------

    @cached_property
    def has_time(self) -> bool:
        """Whether there is any time in it, unless what it names as a whole is one: "dinner"."""
        named = len(self.forms) == 1 and self.forms[0] in self.lexicon.events
        return bool(self._times) and not named

    def length(self) -> "Length | None":
        """Give the first length of time in it; None for none, and where it is part of another time."""
        if any(part.constraint is not Constraint.FOR for part in self._times):
            return None
        for place, word in enumerate(self.words[:LONGEST]):
            tail = self.text[word.start :]
            for part in find_times(FOR + tail, self.now, self.lexicon).requirements[:1]:
                whole = part.constraint is Constraint.FOR and part.span[0] == 0
                if whole and part.number is not None and part.unit is not None:
                    before = self.until(place)
                    joint = before.forms[-1] if before.forms[-1:] in {("by",), ("for",), ("about",)} else ""
                    front = before.until(len(before.words) - 1) if joint else before
                    rest = f"{front.text} {tail[part.span[1] - len(FOR) :].strip()}".strip()
                    seconds = part.number * UNIT_SECONDS[part.unit]
                    return Length(seconds, joint, Said(rest, self.now, self.lexicon))
        return None

    @cached_property
    def _times(self) -> tuple[TimeRequirement, ...]:
        return find_times(self.text, self.now, self.lexicon).requirements

    def as_time(self) -> str:
        """Give it as a new time, as that would be said with what is to be done; empty where it is none."""
        joint = next((to for to in self.towards if self.text.lower().startswith(to)), "")
        bare = self.text[len(joint) :]
        # "Reschedule for friday", but "for an hour"
        kept = bare[len(FOR) :] if bare.lower().startswith(FOR) else ""
        if any(part.constraint is not Constraint.FOR for part in self._as_one_time(kept)):
            bare = kept
        # "Move it to the afternoon"
        counted = bool(Said(bare, self.now, self.lexicon).places)
        inside = (f"in {bare}",) if bare.lower().startswith("the ") and not counted else ()
        # "Make it 20 minutes" is how long, and not when.
        lasts = any(part.constraint is Constraint.FOR for part in self._as_one_time(bare))
        tried = (*inside, bare, *(() if lasts else (f"at {bare}",)), f"for {bare}")
        found = [(text, part) for text in tried for part in self._as_one_time(text)]
        if len(found) > 1 and _lacks_preposition(found[0][1]):
            found = found[1:]
        # "Make it four to six"
        ends = any(part.constraint is not Constraint.AFTER for part in self._as_one_time(FROM + bare))
        return found[0][0] if found else FROM + bare if ends else ""

    def is_bare(self, time: str) -> bool:
        """Whether it has no preposition of its own where it is a new time: "seven", "to half past"."""
        return time.lower().startswith(AT) and not self.text.lower().startswith(AT)

    def one_time(self) -> TimeRequirement | None:
        """Give the time that it is, whole; None where it is none, or more."""
        return one_time(self.text, self.now, self.lexicon)

    def parted(self, *, bare: bool = False) -> tuple[str, str]:
        """Give a thing and its time, either empty where there is none; both where it is more than that.

        Where it may be ``bare``, a number that is no time elsewhere is one behind the thing: "the dog eight".
        """
        spans = list(dict.fromkeys(part.span for part in self._times))
        if not spans and bare and len(self.words) > 1:
            time = self.behind(len(self.words) - 1).as_time()
            return (self.until(len(self.words) - 1).text, time) if time else (self.text, "")
        if not spans:
            return self.text, ""
        first, end = spans[0]
        before, behind = self.text[:first].strip(" ,"), self.text[end:].strip(" ,")
        if len(spans) > 1 or (before and behind):
            return "", ""
        return before or behind, self.text[first:end]

    def as_number(self) -> str:
        """Give it where it is a number alone: what could count minutes; else empty."""
        counted = self._as_one_time(f"{FOR}{self.text} {Unit.MINUTE}s")
        # "For half past minutes" is no length of time, but one gone by.
        lasts = bool(counted) and counted[0].constraint is Constraint.FOR
        return self.text if lasts and counted[0].unit is Unit.MINUTE else ""

    def _as_one_time(self, text: str) -> tuple[TimeRequirement, ...]:
        """Give the time that a text is, whole, if it is one."""
        found = one_time(text, self.now, self.lexicon)
        return () if found is None else (found,)

    def beside(self) -> tuple[str, "Said"] | None:
        """Give what it comes "before" or "after", and what that is; None where it says neither."""
        forms = [form for form, kind in self.lexicon.clauses.items() if kind in {"after", "before"}]
        form = longest_match(self.words, 0, forms) if self.words else None
        if form is None or len(form) == len(self.words):
            return None
        return self.text, self.behind(len(form))


def _lacks_preposition(found: TimeRequirement) -> bool:
    """Whether a time is said as "six", "20 minutes", which want "at" and "for" behind what is to be done."""
    clock = found.constraint is Constraint.AT and found.grain in CLOCKED and " at " not in found.text
    length = found.constraint is Constraint.FOR and not found.text.lower().startswith("for ")
    return found.preposition is None and found.word is None and (clock or length)
