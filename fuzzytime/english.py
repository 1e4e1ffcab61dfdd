"""English words and their forms, as they are looked at where no word tables are at hand.

Rule tables name things and what becomes of them, and operations have names: both need to know which words
name nothing, and which are forms of one. Another language has a module like this one.
"""

import re

_ARTICLES = frozenset({"the", "a", "an"})
_OWNERS = frozenset({"my", "your", "our", "his", "her", "their"})
_POINTING = frozenset({"this", "that", "these", "those"})

DETERMINERS = _ARTICLES | _OWNERS | _POINTING | {"its"}
"""Words before the names of things in clauses and in rule tables."""

EMPTY = (
    _ARTICLES
    | _OWNERS
    | _POINTING
    | {"some", "all", "any", "few", "couple", "of", "and", "is", "are", "has", "have", "been"}
    | {"with", "in", "on", "to", "for"}
)
"""Words that name nothing in what is said to be done."""

BEFORE_PARTICLES = _POINTING | {"me", "us", "you", "him", "her", "it", "them"}
"""Objects that stand before a particle: "wake me up"."""

PLACING = frozenset({"in", "on", "for", "with", "from", "to", "at", "into", "onto", "by", "under", "over"})
"""Prepositions behind which an object says where it is, or what for: "the lid on the pot"."""

NAMELESS = frozenset({"it", "they", "there"})
"""Subjects that name nothing."""

MEASURES = frozenset({"temperature", "temp", "level", "charge", "reading", "pressure", "speed", "cycle"})
"""What is read of a thing that is named before it: "the oven temperature" is the oven's."""

_HAVE = frozenset({"has", "have", "had", "just", "already", "finally"})
_FORMS_OF_BE = frozenset({"is", "are", "was", "were", "been", "gets", "got"})
_BE = "is"
_ENDING = re.compile(r"(?<=\w{3})(?:(?<=([^aeiou]))\1(?=ing|ed))?(?:ing|ed|es|s|e)$")
_DENIALS = re.compile(r"\b(?:not|no longer|never|neither|\w+n't)\b")

REFLEXIVE = ("self", "selves")
"""How pronouns end that are no event: "clean up after yourselves"."""

WHITHER = ("wards", "wise")
"""How adverbs end that say where to, or which way round."""

PARTICIPLE = "ing"
"""The ending of a verb that goes on beside another."""

_VOWELS = frozenset("aeiouy")

SHORT_FOR_IS = frozenset({"'s", "\u2019s"})
"""What is short for "is", or tells whose something is."""

_NAMED_AFTER = ("ation", "ator", "ion", "or", "ing", "er", "ment")
"""Endings of words that are named after what is done, the longest first."""

_SHORTEST_STEM = 5


def is_participle(word: str) -> bool:
    """Whether a word ends like a verb that goes on.

    >>> is_participle("baking"), is_participle("drying"), is_participle("bring"), is_participle("ring")
    (True, True, False, False)
    """
    return word.endswith(PARTICIPLE) and not _VOWELS.isdisjoint(word.removesuffix(PARTICIPLE))


def of_any_tense(text: str) -> str:
    """Give a plain text without tenses, as far as these are regular: "courier has come" is "courier come".

    >>> of_any_tense("kettle has boiled") == of_any_tense("kettle boils")
    True
    """
    words = (_BE if word in _FORMS_OF_BE else word for word in text.split() if word not in _HAVE)
    return " ".join(_ENDING.sub("", word) for word in words)


def denies(text: str) -> bool:
    """Tell whether a clause denies what it says: "is not hot", "is no longer hot", "isn't hot"."""
    return _DENIALS.search(text.lower().replace("\u2019", "'")) is not None


def looks_plural(word: str) -> bool:
    """Whether a word is as it is of more than one thing, by its ending.

    >>> looks_plural("eggs"), looks_plural("glass")
    (True, False)
    """
    return word.endswith("s") and not word.endswith("ss")


def singular(word: str) -> str:
    """Give a word as it is of one thing, by its ending.

    >>> singular("berries"), singular("tomatoes"), singular("eggs"), singular("glass")
    ('berry', 'tomato', 'egg', 'glass')
    """
    if word.endswith("ies") and len(word) > 4:
        return word[:-3] + "y"
    if word.endswith(("oes", "shes", "tches", "sses", "xes")):
        return word[:-2]
    return word[:-1] if looks_plural(word) and len(word) > 3 else word


def singular_forms(word: str) -> list[str]:
    """Give a noun and all that it may be the plural of.

    >>> singular_forms("eggs"), singular_forms("dishes"), singular_forms("berries"), singular_forms("glass")
    (['eggs', 'egg'], ['dishes', 'dishe', 'dish'], ['berries', 'berrie', 'berry'], ['glass'])
    """
    forms = [word]
    if word.endswith("s") and not word.endswith("ss") and len(word) > 3:
        forms.append(word[:-1])
        if word.endswith("ies"):
            forms.append(word[:-3] + "y")
        elif word.endswith("es"):
            forms.append(word[:-2])
        if word.endswith("ves"):
            forms += [word[:-3] + "f", word[:-3] + "fe"]
    return forms


def stem(word: str) -> str | None:
    """Give what words that are named after one verb begin with; None for a word that is named after none.

    >>> stem("incubator"), stem("incubation"), stem("egg")
    ('incub', 'incub', None)
    """
    ending = next((end for end in _NAMED_AFTER if word.endswith(end)), "")
    return word[: -len(ending)] if ending and len(word) - len(ending) >= _SHORTEST_STEM else None
