"""Words of time that rule tables bring, beside those of the language's own tables."""

from collections.abc import Iterable
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Entry, form_of
from fuzzytime.language.meaning.expressions import TimeWord
from fuzzytime.language.reader import Language
from fuzzytime.requirement import Constraint


def with_words(language: Language, words: Iterable[str]) -> Language:
    """Give a language that understands more words of time, each as vague as "soon".

    Words that it understands already stay as they are.

    >>> language = with_words(Language.shipped(), ["anon"])
    >>> language.read("Call mum anon").instructions[0].requirements[0].word
    'anon'
    """
    entries = language.lexicon.entries
    known = {one.words for found in entries.values() for one in found if one.category == "word"}
    forms = {form_of(word): word for word in words}
    new = [
        Entry(form, "word", TimeWord(word, Constraint.VAGUE))
        for form, word in forms.items()
        if form and form not in known
    ]
    more = dict(entries)
    for entry in new:
        more[entry.words[0]] = (*more.get(entry.words[0], ()), entry)
    return replace(language, lexicon=replace(language.lexicon, entries=more)) if new else language
