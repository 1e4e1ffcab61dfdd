"""Words about time that rule tables bring, beside those of the language's own tables."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Entry, Forms, Preposition, form_of
from fuzzytime.language.meaning.expressions import Edge, Said, TimeWord
from fuzzytime.language.reader import Language
from fuzzytime.requirement import Constraint

HEDGING = ("hedge", "hedge_after")
"""The categories of a hedge that may stand on either side of its time."""

OWN = 3.0
"""The weight that lets words of one's own win over any other reading of the same words, but not of more:
"tonight" over the part of a day, and not over "tonight at eight"."""

COUNTING = "within"
"""The category of a preposition before a length of time that counts from now."""

BINDING = frozenset({Constraint.AT, Constraint.BEFORE, Constraint.AFTER})
"""What a preposition can do."""


def with_words(
    language: Language,
    words: Iterable[str],
    hedges: Iterable[str] = (),
    prepositions: Mapping[str, Constraint | None] | None = None,
    clauses: Mapping[str, str] | None = None,
) -> Language:
    """Give a language that understands more words about time.

    They win over what it understands by the same words: "pretty much" may be a hedge of one's own, and
    "tonight" a word.

    Parameters
    ----------
    language
        What understands the others.
    words
        Words that are a time by themselves, each as vague as "soon".
    hedges
        Words that say how exactly a time is meant, in front of it or behind.
    prepositions
        Words in front of a time, and how they bind it; None for beside it, as "at" does.
    clauses
        Words that begin a clause, and of which kind it is: when, while or until.

    >>> language = with_words(Language.shipped(), ["anon"])
    >>> language.read("Call mum anon").instructions[0].requirements[0].word
    'anon'
    """
    new = (*_words(words), *_hedges(hedges), *_prepositions(prepositions or {}))
    more = dict(language.lexicon.entries)
    for entry in new:
        if entry.words:
            more[entry.words[0]] = (*more.get(entry.words[0], ()), entry)
    markers = {form_of(name): kind for name, kind in (clauses or {}).items()}
    if not new and markers.keys() <= language.lexicon.clauses.keys():
        return language
    old = language.lexicon
    fillers = old.fillers - {entry.words[0] for entry in new if entry.words}
    lexicon = replace(old, entries=more, clauses=Forms({**markers, **old.clauses}), fillers=fillers)
    return replace(language, lexicon=lexicon)


def _words(words: Iterable[str]) -> Iterator[Entry]:
    for form, word in {form_of(word): word for word in words}.items():
        time = TimeWord(word, Constraint.VAGUE)
        yield Entry(form, "word", time)
        yield Entry(form, "said", Said(time), OWN)


def _hedges(hedges: Iterable[str]) -> Iterator[Entry]:
    for hedge in hedges:
        for category in HEDGING:
            yield Entry(form_of(hedge), category, hedge, OWN)


def _prepositions(prepositions: Mapping[str, Constraint | None]) -> Iterator[Entry]:
    for name, constraint in prepositions.items():
        binds = constraint if constraint in BINDING else Constraint.AT
        preposition = Preposition(name, binds or Constraint.AT, Edge.START)
        # Before a clock time, and before a length of time from now: "nigh ten minutes".
        for category in (f"preposition_{binds}", COUNTING):
            yield Entry(form_of(name), category, preposition, OWN)
