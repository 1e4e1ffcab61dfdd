"""News of what happens: "the guests are ten minutes late", "they come at eight", "it was cancelled"."""

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from datetime import datetime
from enum import StrEnum

from fuzzytime.english import EMPTY, singular
from fuzzytime.language.about_wishes.said import CLOCKED, Said
from fuzzytime.language.finding import find_times
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation, Question, Span
from fuzzytime.language.sentence.references.mentions import verb_forms
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.requirement import Constraint, TimeRequirement

CLAUSES = re.compile(r"(?:[^,.;!?]|[,.;!?](?=\S))+")
"""What stands between marks that are no part of a word or a number."""

CONTRACTED = re.compile(r"(?<=\w)(['\u2019])(s|ll|re)\b")
"""What is short for "is", "has" or "will", or tells whose something is."""

ANEW = frozenset({Constraint.AT, Constraint.BETWEEN, Constraint.VAGUE})
"""What says when something happens."""

SEVERAL = r"\bthey"
PERSON = re.compile(r"\b\w+")
SOONER = frozenset({"early", "earlier"})
LATER = frozenset({"late", "later", "rescheduled"})
TABLES = (
    "they",
    "being",
    "anew",
    "late",
    "early",
    "later",
    "earlier",
    "rescheduled",
    "cancelled",
    "present",
    "perfect",
    "absent",
)
"""The tables of what is said in a conversation whose words make news."""


class NewsKind(StrEnum):
    """What is told of something that happens."""

    TIME = "time"
    LATER = "later"
    LATE = "late"
    CANCELLED = "cancelled"
    THERE = "there"


LATE, CANCELLED, THERE = NewsKind.LATE, NewsKind.CANCELLED, NewsKind.THERE


@dataclass(frozen=True, slots=True, kw_only=True)
class News:
    """What a clause tells anew of something that happens.

    Parameters
    ----------
    kind
        Its new time, by how much later it is, that it is late by nobody knows how much, that it will not
        happen, or that it has.
    span
        The clause.
    names
        The words that say what it is, and what that does.
    several
        Where it is only "it" or "they": whether these are several. None where it is named.
    time
        The new time, counted from when this was said.
    question
        Which of several a new time may be that leaves it open.
    by
        Seconds by which it is later, below 0 for earlier.
    marked
        Whether the words say that it is news: else it is only where it was said later than the first.
    comes
        Whether it is of somebody, or of what comes: "she is late", "it will be here at six".
    """

    kind: NewsKind
    span: Span
    names: frozenset[str]
    several: bool | None = None
    time: TimeRequirement | None = None
    question: Question | None = None
    by: float = 0.0
    marked: bool = True
    comes: bool = False

    @property
    def heads_entry(self) -> bool:
        """Whether a clock time alone stands in front of the clause, as in the entries of a list."""
        time = self.time
        return time is not None and time.span[0] == self.span[0] and time.text[0].isdigit()

    def is_of(self, happening: Operation, lexicon: Lexicon) -> bool:
        """Whether it may be about something that was said to happen."""
        if not happening.stated or happening.negated:
            return False
        things = content_words(happening.object) | content_words(happening.place)
        if (
            (self.kind is THERE or self.comes)
            and not self.names
            and happening.lemma not in lexicon.doing.arriving | lexicon.doing.leaving
        ):
            # "They're here" is of the movers, and not of "keys to the landlord at five".
            return False
        subject = self.names - _verbs(happening, lexicon)
        return subject <= things and (self.several is not None or bool(subject))


def news_in(text: str, now: datetime, lexicon: Lexicon) -> tuple[News, ...]:
    """Give what the clauses of a text tell anew, if what they name was said to happen before.

    >>> from datetime import datetime
    >>> from fuzzytime.language.finding import shipped_lexicon
    >>> news = news_in("they are ten minutes late", datetime(2026, 3, 4, 9), shipped_lexicon())
    >>> [(one.kind.value, one.by) for one in news]
    [('later', 600.0)]
    """
    found = [
        one for span in clauses_of(text) if (one := _Clause(text, span, now, lexicon).news()) is not None
    ]
    # "They are late, they come at eight"; but "3:00 PM all horses brought in, feet washed" is an entry.
    marked = len(found) > 1 and not found[0].heads_entry
    return tuple(replace(one, marked=marked or one.marked) for one in found)


def clauses_of(text: str) -> Iterator[Span]:
    """Give the stretches of a text between its marks, as far as one can tell without its tree."""
    for clause in CLAUSES.finditer(text):
        first = clause.start() + len(clause[0]) - len(clause[0].lstrip())
        if clause[0].strip():
            yield first, first + len(clause[0].strip())


@dataclass(frozen=True, slots=True)
class _Clause:
    text: str
    span: Span
    now: datetime
    lexicon: Lexicon

    def news(self) -> News | None:
        # "The flight's delayed" says no more than "flight delayed", and each word keeps its place.
        words = CONTRACTED.sub(_blank, self.text[self.span[0] : self.span[1]])
        said = Said(words, self.now, self.lexicon)
        left, tables = said.without(*TABLES)
        if said.forms[:1] == ("no",) and left.words and left.forms[0] == said.forms[1] not in EMPTY:
            # "No gym today"
            return None
        if any((form,) in self.lexicon.conversation["happened"] for form in said.forms):
            tables |= {"happened"}
        if not tables:
            # Only a plain verb and a time: "the train leaves at nine"
            return self._timed(words, frozenset())
        found = left.length()
        if found is not None and tables & (SOONER | LATER):
            by = -found.seconds if tables & SOONER else found.seconds
            return None if "absent" in tables else self._news_of(NewsKind.LATER, found.rest, tables, by=by)
        if said.has_time and "cancelled" in tables:
            # Of which day that is, who asked for it must see.
            return None
        if said.has_time or ("rescheduled" in tables and self._joint(words)):
            return self._timed(words, tables)
        if "absent" in tables:
            known = LATE if {"present", "perfect"} & tables else CANCELLED
            return None if tables & (SOONER | LATER) else self._news_of(known, left, tables)
        kinds = {"cancelled": CANCELLED, "present": THERE, "perfect": THERE, "happened": THERE}
        kinds |= dict.fromkeys(("late", "rescheduled"), LATE)
        kind = next((kind for name, kind in kinds.items() if name in tables), None)
        return None if kind is None else self._news_of(kind, left, tables)

    def _joint(self, words: str) -> int:
        """Give where "to", "until" begins, behind which a new time stands; 0 for nowhere."""
        joints = Said(words, self.now, self.lexicon).towards
        return max((words.lower().rfind(f" {joint}") + 1 for joint in joints), default=0)

    def _timed(self, words: str, tables: frozenset[str]) -> News | None:
        """Read a new time: "they come at eight", "the meeting was moved to four"."""
        parts = find_times(words, self.now, self.lexicon).found
        # "The meeting is at four now"
        parts = tuple(part for part in parts if part.requirement.word != "now" or len(parts) == 1)
        joint = self._joint(words) if "rescheduled" in tables and not parts else 0
        if joint and (at := Said(words[joint:], self.now, self.lexicon).as_time()):
            # "It was moved to four"
            parts = find_times(at, self.now, self.lexicon).found
        if len(parts) != 1:
            return None
        time, questions = parts[0].requirement, parts[0].questions
        first, end = (joint, len(words)) if joint else time.span
        left, _ = Said(f"{words[:first]} {words[end:]}", self.now, self.lexicon).without(*TABLES)
        moved = "absent" in tables or "rescheduled" in tables
        if "absent" in tables and time.constraint is not Constraint.BEFORE:
            # "They don't come at seven" leaves open when, "they can't come today" does not.
            return self._news_of(LATE if time.grain in CLOCKED else CANCELLED, left, tables)
        if moved:
            # "They won't be here until eight", "it was moved to eight"
            at = Said(time.text, self.now, self.lexicon).as_time()
            said = find_times(at, self.now, self.lexicon).found[:1] if at and not joint else ()
            for one in said:
                time, questions = replace(one.requirement, text=time.text), one.questions
        if time.constraint not in ANEW or time.recurrence is not None:
            return None
        bare = time.preposition is None and time.grain in CLOCKED
        if bare and not left.text and tables <= {"they", "being"}:
            # "It's nearly six" tells what time it is.
            return None
        told = replace(time, span=(self.span[0] + first, self.span[0] + end))
        news = self._news_of(NewsKind.TIME, left, tables)
        if news is None:
            return None
        marked = moved or bool(tables - {"they", "being"})
        news = replace(news, time=told, question=next(iter(questions), None))
        return replace(news, marked=marked and not news.heads_entry)

    def _news_of(self, kind: NewsKind, left: Said, tables: frozenset[str], *, by: float = 0.0) -> News | None:
        """Give news of what the words that are left name; None where they say more than that."""
        forms = left.forms
        if self.lexicon.closed.indefinite_determiners & set(forms) or not all(
            form.replace("'", "").isalnum() for form in forms
        ):
            return None
        names = frozenset(singular(form) for form in forms if form not in EMPTY)
        if not (names or "they" in tables):
            return None
        words = self.text[self.span[0] : self.span[1]].lower()
        several = re.search(SEVERAL, words) is not None if "they" in tables else None
        somebody = not self.lexicon.closed.third_person_singular.isdisjoint(PERSON.findall(words))
        comes = somebody or "present" in tables
        return News(kind=kind, span=self.span, names=names, several=several, by=by, comes=comes)


def _blank(contracted: re.Match[str]) -> str:
    """Give spaces in the place of what is contracted: no other word moves."""
    return " " * len(contracted[0])


def _verbs(happening: Operation, lexicon: Lexicon) -> frozenset[str]:
    """Give the words for what something that happens does."""
    arriving = lexicon.doing.arriving
    beginning = lexicon.doing.beginning_or_being - arriving
    alike = arriving if happening.lemma in arriving else frozenset[str]()
    if happening.lemma in beginning:
        # "The meeting starts at four", which was at three
        alike |= beginning
    return frozenset(form for verb in alike | {happening.lemma} for form in verb_forms(verb, lexicon))
