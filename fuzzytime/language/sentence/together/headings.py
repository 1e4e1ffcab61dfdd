"""Times on lines of their own, which hold for the lines below: "Saturday:", "Before the guests come:"."""

from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Reading, Remark, RemarkKind, Span
from fuzzytime.language.meaning.calendar import Calendar
from fuzzytime.language.meaning.expressions import Phrase, Range, TimeWord, Wall
from fuzzytime.language.meaning.told_apart import told_apart
from fuzzytime.language.sentence.segments.drafts import HEADED, Draft, Heading
from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.sketches.sketch import sketch_of

MARK = ":"
"""What ends a heading."""

FEWEST = 3
"""Lines below a title, at least."""

LONGEST = 6
"""Words of a title, at most."""

CALLED = 2
"""Words that call a worker: "Robot 2:"."""


def under_headings(drafts: Sequence[Draft], lexicon: Lexicon) -> list[Draft]:
    """Give drafts of lines said at one moment, each with the time that the nearest line above names alone.

    A part of the day, or a clause, is of the day that a line above it names.
    """
    headings = [_heading_of(draft, lexicon) for draft in drafts]
    if headings and headings[0] is None:
        headings[0] = _title_of(drafts, lexicon)
    found: list[Draft] = []
    heading: Heading | None = None
    day: Heading | None = None
    for place, draft in enumerate(drafts):
        if place and draft.now != drafts[place - 1].now:
            heading = day = None
        named = headings[place]
        if named is not None:
            heading = _on_day(named, day)
            day = named if named.is_day else day
        found.append(replace(draft, heading=heading, leads=named is not None and _holds(headings, place)))
    return found


def _holds(headings: Sequence[Heading | None], place: int) -> bool:
    """Whether a heading has lines below it, or one for some of them."""
    heading, below = headings[place], headings[place + 1 : place + 2]
    if heading is None or not below:
        return False
    return below[0] is None or (heading.is_day and not below[0].is_day)


def _heading_of(draft: Draft, lexicon: Lexicon) -> Heading | None:
    """Give what a line names that says a time, and nothing else."""
    marked = draft.text.rstrip(" *_").endswith(MARK)
    if marked and (called := _called(draft, lexicon)) is not None:
        return Heading(called, draft.text, draft.scanned, addressee=called)
    if marked and _is_title(draft, lexicon):
        days = [phrase for phrase in draft.phrases if not _names_thing(phrase, draft)]
        return Heading(_name_of(draft), draft.text, draft.scanned, _held(draft, days))
    if len(draft.parts) != 1 or not (marked or len(draft.phrases) == 1):
        return None
    if marked:
        sketch = sketch_of(draft, draft.parts[0], lexicon)
        phrases, clauses = sketch.phrases, sketch.clauses
    else:
        phrases, clauses = draft.phrases, ()
    heard = [*(phrase.span for phrase in phrases), *(clause.span for clause in clauses)]
    if not heard or any(isinstance(p.said.time, TimeWord) for p in phrases):
        return None
    # As in "Saturday in the garden:", where more than the day is named.
    titled = marked and sketch.operation is None and any(p.said.is_day for p in phrases)
    if _says_more(draft, heard) and not titled:
        return None
    if (not marked and not _is_of_calendar(phrases[0])) or any(map(_is_meal, phrases)):
        return None
    return Heading(_name_of(draft), draft.text, draft.scanned, _held(draft, phrases), clauses)


def _is_title(draft: Draft, lexicon: Lexicon) -> bool:
    """Whether a line with a colon says what the lines below are about: "Saturday, garden:", "Bakery:".

    It has no times but days, and asks for nothing.
    """
    named = [word for word in draft.scanned.words if word.is_letters]
    timed = {place for phrase in draft.phrases for place in range(phrase.first, phrase.end)}
    beside = [
        word for place, word in enumerate(draft.scanned.words) if place not in timed and word.is_letters
    ]
    if not beside or beside[0].text in lexicon.function_words or len(named) > LONGEST:
        return False
    if not all(phrase.said.is_day and _is_of_calendar(phrase) for phrase in draft.phrases):
        return False
    asked = lexicon.alone | lexicon.chores | lexicon.addressing | lexicon.ordering
    return not any(_begins_order(part, asked) for part in draft.parts)


def _names_thing(phrase: Phrase, draft: Draft) -> bool:
    """Whether a part of the day calls what stands behind it: "Morning round:"."""
    words = draft.scanned.words
    return not _names_day(phrase) and phrase.end < len(words) and words[phrase.end].is_letters


def _begins_order(part: Part, asked: AbstractSet[str]) -> bool:
    """Whether a part begins with what is done to something: "clean:", "fix the fence:"."""
    tree = part.tree
    first = next((place for place, node in enumerate(tree.nodes) if node.text[0].isalpha()), None)
    if first is None:
        return False
    owned = any(tree.children(thing, "det", "poss") for thing in tree.children(first, "dobj"))
    root = tree.nodes[tree.root]
    return tree.nodes[first].lower in asked or root.lower in asked or owned


def _name_of(draft: Draft) -> str:
    """Give the words of a heading, without its marks."""
    return draft.text.strip(" :.-*#_")


def _held(draft: Draft, phrases: Sequence[Phrase]) -> tuple[Phrase, ...]:
    """Give times as they hold for other lines, in which they have no place."""
    return tuple(
        replace(phrase, first=0, end=0, span=(0, 0), rule=HEADED, above=draft.text[slice(*phrase.span)])
        for phrase in phrases
    )


def _title_of(drafts: Sequence[Draft], lexicon: Lexicon) -> Heading | None:
    """Give the day that the first of some lines names behind what they are about: "Early shift Thursday".

    The lines below have clock times, and no days of their own; what somebody attends is no title.
    """
    first, below = drafts[0], [draft for draft in drafts[1:] if draft.now == drafts[0].now]
    clocked = sum(any(_is_clocked(phrase) for phrase in draft.phrases) for draft in below)
    dated = any(_names_day(phrase) for draft in below for phrase in draft.phrases)
    if len(below) < FEWEST or dated or 2 * clocked < len(below) or len(first.phrases) != 1:
        return None
    (day,) = first.phrases
    named = [word.text for word in first.scanned.words[: day.first] if word.is_letters]
    ends = not any(word.is_letters for word in first.scanned.words[day.end :])
    if not (day.said.is_day and _is_of_calendar(day) and named and ends) or day.said.preposition is not None:
        return None
    events = lexicon.taken | lexicon.happening | lexicon.function_words
    done = lexicon.alone | lexicon.chores | lexicon.addressing | lexicon.ordering
    if named[-1] in events - lexicon.frames or named[0] in done:
        return None
    return Heading(first.text[slice(*day.span)], first.text, first.scanned, _held(first, (day,)))


def _is_clocked(phrase: Phrase) -> bool:
    """Whether it has a time of day, and no day."""
    time = phrase.said.time
    ends = (time.first, time.last) if isinstance(time, Range) else (time,)
    return all(isinstance(end, Wall) and end.clock is not None and end.days is None for end in ends)


def _names_day(phrase: Phrase) -> bool:
    """Whether it says on which day."""
    time = phrase.said.time
    return isinstance(time, Wall) and time.days is not None


def _called(draft: Draft, lexicon: Lexicon) -> str | None:
    """Give who is called by a number, and asked for nothing: "Robot 2:"."""
    words = [word for word in draft.scanned.words if word.text[0].isalnum()]
    if len(words) != CALLED or words[0].text not in lexicon.workers or not words[1].is_digits:
        return None
    return draft.text[words[0].start : words[1].end]


def _says_more(draft: Draft, heard: Sequence[Span]) -> bool:
    """Whether words stand outside of some stretches."""
    words = (word for word in draft.scanned.words if word.text[0].isalnum())
    return any(not any(first <= word.start < end for first, end in heard) for word in words)


def _is_of_calendar(phrase: Phrase) -> bool:
    """Whether a time alone is a day or a part of one."""
    time = phrase.said.time
    if not isinstance(time, Wall) or time.clock is not None or phrase.said.constraint is not None:
        return False
    if time.days is not None:
        return not time.weak
    return time.part is not None


def _is_meal(phrase: Phrase) -> bool:
    """Whether a time may as well be a thing: "Dinner:"."""
    time = phrase.said.time
    if not isinstance(time, Wall) or time.days is not None or phrase.said.preposition is not None:
        return False
    return time.clock is None and time.part is not None and time.part.meal


def _on_day(heading: Heading, above: Heading | None) -> Heading:
    """Give a heading that names no day on that of a line above."""
    if above is None or above.day is None or heading.is_day:
        return heading
    if heading.addressee is not None:
        return replace(heading, phrases=above.phrases, clauses=above.clauses)
    told = [told_apart(phrase.said, above.day.said) for phrase in heading.phrases]
    phrases = [
        phrase if said is None else replace(phrase, said=said)
        for phrase, said in zip(heading.phrases, told, strict=True)
    ]
    if not any(told):
        phrases = [above.day, *phrases]
    return replace(heading, phrases=tuple(phrases), name=f"{above.name}, {heading.name}")


def read_heading(draft: Draft) -> Reading:
    """Give the reading of a time that holds for the lines below it."""
    heading = draft.heading
    said = draft.text if heading is None else heading.name
    what = "day" if heading is not None and heading.is_day and not heading.clauses else "time"
    message = f"{said!r} is taken as the {what} of the lines below it"
    if heading is not None and not heading.phrases and not heading.clauses:
        message = f"{said!r} is taken as what the lines below it are about"
    if heading is not None and heading.addressee is not None:
        message = f"{said!r} is taken as who is asked in the lines below it"
    remark = Remark(RemarkKind.POLICY, (0, len(draft.text)), message)
    return Reading(text=draft.text, now=draft.now, instructions=(), remarks=(remark,))


def day_above(heading: Heading | None) -> Calendar | None:
    """Give the day that a line above names."""
    day = None if heading is None else heading.day
    return day.said.time.days if day is not None and isinstance(day.said.time, Wall) else None
