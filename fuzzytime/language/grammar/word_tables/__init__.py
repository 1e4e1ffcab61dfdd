"""Reading the word tables: YAML to a `Lexicon`, with every mistake at its line and column.

``tables`` are read in ``layers``: of ``calendar.yaml`` the ``days`` and ``feasts``; of ``lexicon.yaml`` the
``speech``.
"""

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from fuzzytime.errors import DocumentError
from fuzzytime.language.grammar.lexicon import Entry, Forms, Lexicon, form_of
from fuzzytime.language.grammar.lexicon.groups_beside_times import BesideTimes
from fuzzytime.language.grammar.lexicon.no_time_groups import NoTimes
from fuzzytime.language.grammar.lexicon.spelling import clipped, misspellings
from fuzzytime.language.grammar.lexicon.transliteration import Names
from fuzzytime.language.grammar.lexicon.verb_groups import Doing
from fuzzytime.language.grammar.lexicon.word_groups import ClosedClasses
from fuzzytime.language.grammar.word_tables.days import (
    read_clocks,
    read_days,
    read_hours,
    read_parts,
    read_policy,
    read_units,
)
from fuzzytime.language.grammar.word_tables.feasts import is_transliterated, read_feasts
from fuzzytime.language.grammar.word_tables.speech import (
    read_amounts,
    read_comparisons,
    read_groups,
    read_hedges,
    read_prepositions,
    read_ways,
    read_words,
)
from fuzzytime.language.grammar.word_tables.tables import Tables, by_form, numbers


def read_lexicon(words: Path, calendar: Path, customs: Iterable[Path] = ()) -> Lexicon:
    """Read the tables of words and of the calendar.

    Parameters
    ----------
    words, calendar
        The files.
    customs
        Files of the calendar's form that say what is otherwise, each over those before it (see
        ``docs/customs.md``).

    Raises
    ------
    OSError
        If a file cannot be read.
    DocumentError
        If a table breaks rules: every mistake with file, line and column.
    """
    customs = tuple(customs)
    speech = Tables(words, _SPEECH)
    days = Tables(calendar, _CALENDAR, customs)
    for section, names in _ROWS.items():
        speech.rows(section, names)
    read_prepositions(speech)
    read_hedges(speech)
    read_words(speech)
    read_units(days)
    read_days(days)
    read_parts(days)
    read_feasts(days)
    read_clocks(days)
    lexicon = _lexicon(speech, days)
    # A list that is asked for twice has its mistakes twice.
    mistakes = {*speech.reader.mistakes, *days.reader.mistakes}
    if mistakes:
        # What a mistake above brings upon the rows below it need not be told as well.
        above = {mistake for mistake in mistakes if Path(mistake.path) in customs}
        raise DocumentError(tuple(above or mistakes))
    return lexicon


def _lexicon(speech: Tables, days: Tables) -> Lexicon:
    """Give what the tables say; of rows with mistakes, what is left of them."""
    entries: dict[str, list[Entry]] = {}
    for entry in (*speech.entries, *days.entries):
        entries.setdefault(entry.words[0], []).append(entry)
    number_words = numbers(days, "numbers")
    kept = speech.single_words("spelling", "kept") | speech.single_words("function_words")
    known = kept | entries.keys() | number_words.keys()
    return Lexicon(
        **_groups(speech),
        entries={first: tuple(found) for first, found in entries.items()},
        numbers=number_words,
        magnitudes={
            form[0]: int(name.text) for name, node in days.rows("magnitudes") for form in days.forms(node, "")
        },
        ordinals=numbers(days, "ordinals"),
        ambiguous=days.single_words("ambiguous"),
        comparisons=read_comparisons(speech),
        amounts=Forms(dict(read_amounts(speech))),
        doing=read_groups(speech, "doing", Doing),
        closed=read_groups(speech, "closed_classes", ClosedClasses),
        beside=read_groups(speech, "beside_times", BesideTimes),
        no_times=read_groups(speech, "no_times", NoTimes),
        ways=read_ways(speech),
        misspelt={
            **misspellings(speech.single_words("spelling", "words"), known),
            **{"".join(form[:-1]): form[-1] for form in speech.words("spelling", "short")},
        },
        clipped=clipped(speech.single_words("spelling", "ending"), known),
        transliterated=Names.of((entry.words, entry) for entry in days.entries if is_transliterated(entry)),
        usual_hours=read_hours(days, "usual_hours"),
        hours_on_days=read_hours(days, "hours_on_days"),
        policy=read_policy(days),
    )


def _groups(speech: Tables) -> dict[str, Any]:
    """Give words that do not mean a time, by their fields."""
    found: dict[str, Any] = {name: speech.single_words(name) for name in _SECTIONS}
    found |= {name: speech.single_words("verbs", name) for name in _ROWS["verbs"]}
    found |= {name: speech.single_words(*where) for name, where in _LISTS.items()}
    found |= {name: _by_use(speech, name) for name in _BY_USE}
    called = (*speech.words("courtesies", "behind times"), *speech.words("addresses"))
    return found | {
        "indicators": {" ".join(form): name for form, name in by_form(speech, "indicators").items()},
        "connectives": by_form(speech, "connectives"),
        "clauses": by_form(speech, "clauses"),
        "corrections": Forms.of(speech.words("corrections")),
        "courtesies": frozenset(speech.words("courtesies")),
        "called_behind": frozenset(called),
        "results": frozenset(" ".join(form) for form in speech.words("results")),
        "particles": {form_of(name)[0]: verbs for name, verbs in _by_use(speech, "particles").items()},
        "moments": frozenset(speech.words("moments")),
        "instances": {name: frozenset(speech.words("instances", name)) for name in _ROWS["instances"]},
        "persons": speech.single_words("persons") | found["names"],
        "rescheduling": found["moving"] | speech.single_words("rescheduling", "verbs"),
        "changing": frozenset(speech.words("measures", "changing")),
        "questions": {name: Forms.of(speech.words("questions", name)) for name in _ROWS["questions"]},
        "conversation": {
            name.text: frozenset(speech.words("conversation", name.text))
            for name, _ in speech.rows("conversation")
        },
    }


def _by_use(speech: Tables, section: str) -> dict[str, frozenset[str]]:
    """Give the words of a section by what they do."""
    return {
        name.text: frozenset(" ".join(form) for form in speech.forms(node, f"{section}.{name.text}"))
        for name, node in speech.rows(section)
    }


_SPEECH = (
    "prepositions", "hedges", "words", "indicators", "verbs", "results", "connectives", "addresses",
    "clauses", "comparisons", "corrections", "particles", "places", "appointing", "persons", "impersonal",
    "amounts", "measures", "function_words", "questions", "foreign", "lasting", "landmarks", "courtesies",
    "travelling", "machines", "workers", "rescheduling", "catching", "citing", "spelling", "timing", "taken",
    "happening", "frames", "standing", "conversation", "ways", "vague_adverbs", "told", "instances",
    "asides", "moments", "spacing", "animals", "becoming", "other_calendars", "fillers", "playing", "levels",
    "passing", "doing", "past", "undoing", "circling", "dosing", "coming_in", "dining", "closed_classes",
    "beside_times", "no_times", "called", "sky",
)  # fmt: skip
_ROWS = {
    "indicators": ("start", "finish", "throughout"),
    "verbs": (
        "wanting", "ordering", "forgetting", "causing", "letting", "intransitive", "alone", "chores",
        "addressing",
    ),
    "courtesies": ("words", "behind times"),
    "persons": ("words", "names", "like words"),
    "spelling": ("words", "short", "ending", "kept"),
    "timing": ("verbs", "alone"),
    "rescheduling": ("moving", "verbs", "switching", "events"),
    "connectives": ("then", "meanwhile", "first", "otherwise"),
    "questions": (
        "asking",
        "placing",
        "stating",
        "helping",
        "asked",
        "suggesting",
        "obliging",
        "supposing",
        "requesting",
    ),
    "told": (
        "joints", "small", "subjects", "determiners", "being", "taking", "going", "there", "by", "vehicles",
        "between", "each way", "helping", "enough", "allowing", "leaving", "going for", "for it",
    ),
    "asides": (
        "naming", "used later", "back", "helping", "taking", "whom", "preparing", "needing", "needed", "due",
        "being needed", "not needed", "being there", "having to be", "unable", "unable to",
    ),
    "spacing": ("leading", "beside", "nouns", "turns"),
    "instances": ("first", "further"),
    "conversation": (
        "dropping", "retracting", "clearing", "swapping", "undoing", "redoing", "delaying", "later",
        "earlier", "last", "everything", "all else", "onwards", "both", "speaker", "late", "they", "being",
        "anew", "early", "rescheduled", "cancelled",
        "except", "numbering", "listed", "adding",
        "present", "perfect", "happened", "absent", "finished", "having", "unstarted", "yet", "wrong",
        "unable", "more", "less", "lengthening", "shortening", "busy", "unable then", "able at", "still at",
        "needing", "open", "doing", "moment", "plan", "what", "showing", "when", "lasting", "why",
        "supposing", "filling", "first", "instead", "letting", "answering", "going ahead", "beginning now",
        "on time", "having left", "greeting",
        "again", "like", "continuing", "following", "closing", "naming anew", "meaning", "other",
        "reversing", "stopping", "no longer", "restoring", "staying", "unable at", "unable of", "asking to",
        "saying", "slightly", "several", "occasion", "getting in touch", "belonging", "under way", "skipping",
        "no more", "letting go", "denying",
        "proposing", "exclaiming", "free", "at leisure", "gaps", "may do", "having time", "at the latest",
        "asking how late", "asking how early", "asking if late",
        "asking for all", "not doing", "done already",
        "said of me", "not done", "asking about", "holding", "besides", "asking next", "asking when",
        "next of all", "coming last", "accepting", "in the gap", "beside it",
        "all of it", "by itself", "preferring", "lengths", "a day on", "a day back",
        "a week on", "a week back", "agreeing", "of course", "the earlier", "the later", "choosing none",
        "the next", "forgetting", "started", "asking for a while",
        "how to", "done with", "done next", "told of", "blocking", "keeping free",
        "kept free", "being away", "half of the day", "minding", "may be", "towards", "behind swapping",
        "in its place of", "going", "one", "clock", "parting", "asking for help", "asking for the list",
        "asking to clear", "quitting", "telling", "denied", "moving", "waiting", "able to", "wanting",
        "being over", "going on for", "helping", "beside verbs", "whom", "told openers",
        "pausing", "length of", "bringing back", "at hand", "out of use",
    ),
    "measures": ("verbs", "nouns", "changing", "dividing", "reading", "counting", "rating", "amounts"),
}  # fmt: skip
"""Sections whose rows rules ask for by name: all of them, and no other."""

_SECTIONS = (
    "addresses", "places", "vague_adverbs", "becoming", "fillers", "other_calendars", "levels", "passing",
    "appointing", "lasting", "playing", "catching", "circling", "dosing", "coming_in", "dining", "citing",
    "animals", "machines", "workers", "landmarks", "travelling", "impersonal", "taken", "happening", "frames",
    "standing", "foreign", "function_words",
)  # fmt: skip
"""Sections that are one group of words, in the field of that name."""

_LISTS = {
    "timing": ("timing", "verbs"), "timing_alone": ("timing", "alone"),
    "names": ("persons", "names"), "names_like_words": ("persons", "like words"),
    "moving": ("rescheduling", "moving"), "switching": ("rescheduling", "switching"),
    "events": ("rescheduling", "events"), "measure_verbs": ("measures", "verbs"),
    "measure_nouns": ("measures", "nouns"), "dividing": ("measures", "dividing"),
    "counting": ("measures", "counting"), "rating": ("measures", "rating"),
    "reading": ("measures", "reading"), "amount_nouns": ("measures", "amounts"),
}  # fmt: skip
"""Groups of words by their fields: the section of each, and the list in it."""

_BY_USE = ("sky", "called", "past", "undoing", "told", "asides", "spacing")
"""Sections whose words stand by what they do."""

_CALENDAR = (
    "numbers", "magnitudes", "ordinals", "fractions", "units", "weekdays", "months", "ambiguous",
    "days", "days_on", "deictics", "all_meals", "parts", "day_halves", "first_thing", "last_thing",
    "weeknights", "day_parts", "shares", "edges", "abbreviated_edges", "seasons", "shortened",
    "holidays",
    "meridiem", "zones", "usual_hours", "hours_on_days", "policy",
)  # fmt: skip
