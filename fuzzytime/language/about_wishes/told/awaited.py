"""What somebody tells to have happened, and whether something waits for it: "bob called", "he has left"."""

import re
from collections.abc import Iterator, Sequence

from fuzzytime.language.about_wishes.about import AT_FIRST
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Token
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.requirement import Constraint, TimeRequirement

CONTRACTED = re.compile(r"(?<=\w)['\u2019](s|re)\b")
BEING = {"s": " is", "re": " are"}
SUBJECTS = frozenset({"nsubj", "nsubj:pass"})
VERBAL = ("V", "M")
"""How the tags of verbs begin."""

NOMINAL = ("N", "PRP", "DT")
"""How those begin of which one tells."""


def written_out(said: str) -> str:
    """Write out what is short for "is", or "are": "the glue's dry".

    >>> written_out("the glue's dry")
    'the glue is dry'
    """
    return CONTRACTED.sub(lambda short: BEING[short[1]], said)


def as_now(said: str, lexicon: Lexicon) -> str | None:
    """Give what is told to have happened as it is said of what happens now; None where its verb is none.

    >>> from fuzzytime.language.finding import shipped_lexicon
    >>> as_now("the timer rang", shipped_lexicon())
    'the timer rings'
    """
    front, _, last = said.rpartition(" ")
    verb = next((verb for verb, forms in lexicon.past.items() if last.lower() in forms), None)
    return f"{front} {verb}s" if verb and front else None


def is_untold(part: TimeRequirement) -> bool:
    """Whether it waits for something that no instruction brings about."""
    if part.condition is not None and part.constraint is Constraint.WHEN:
        return part.condition.target is None and not part.condition.goes_on
    # That the glue is dry is only assumed of what glues.
    loose = part.anchor is not None and (part.anchor.target is None or part.anchor.assumed)
    return loose and part.constraint is Constraint.AFTER


def tells_of_somebody(tokens: Sequence[Token]) -> bool:
    """Whether words tell something of somebody: what is asked has its verb in front."""
    verbs = (place for place, token in enumerate(tokens) if token.tag.startswith(VERBAL))
    subjects = (place for place, token in enumerate(tokens) if token.relation in SUBJECTS)
    first = next(verbs, None)
    # Trees take "Tim" for a time, in "Tim got home".
    named = bool(tokens) and tokens[0].tag.startswith(NOMINAL)
    return first is not None and first > 0 and (named or next(subjects, first) < first)


def tells_awaited(
    told: Sequence[Token], waiting: Sequence[Token], part: TimeRequirement, lexicon: Lexicon
) -> bool:
    """Whether words tell what an instruction waits for: in other forms ("left", "have left"), or of "he".

    Parameters
    ----------
    told
        The words that tell.
    waiting
        The words of the instruction that waits.
    part
        What it waits for.
    """
    clause = _clause(waiting, part, lexicon)
    if _denies(told, lexicon) is not _is_denied(clause, part, lexicon):
        return False
    closed = lexicon.closed
    who, of_whom = (_subject(tokens) for tokens in (told, clause))
    if of_whom and (who in closed.first_person) is not (of_whom in closed.first_person):
        return False
    this, that = (set(_named(tokens, lexicon)) for tokens in (told, clause))
    anybody = closed.personal_pronouns | closed.third_person
    # "He left", and "it has cooled"
    alike = this == that or (who in anybody and this < that) or (of_whom in anybody and that < this)
    return bool(this) and bool(that) and alike


def _clause(waiting: Sequence[Token], part: TimeRequirement, lexicon: Lexicon) -> list[Token]:
    """Give the words of what is waited for, without what joins them."""
    first, end = part.span
    first += max(part.text.rfind(part.anchor.text), 0) if part.anchor is not None else 0
    words = words_of(part.anchor.text if part.anchor is not None else part.text)
    if joint := longest_match(words, 0, lexicon.clauses):
        first += words[len(joint)].start
    return [token for token in waiting if first <= token.span[0] < end]


def _named(tokens: Sequence[Token], lexicon: Lexicon) -> Iterator[str]:
    """Give the words that name who does what, without those that only say that it is news: "just"."""
    closed = lexicon.closed
    pronouns = closed.personal_pronouns | closed.third_person
    small = {form[0] for name in ("being", "anew") for form in lexicon.conversation[name] if len(form) == 1}
    places = lexicon.particles.keys() | {
        form[0] for form in lexicon.conversation["present"] if len(form) == 1
    }
    # "The pasta is in" is not "the pasta is out", and the same as "the pasta went in".
    where = tokens[-1:] and tokens[-1].text.lower() in places
    getting = lexicon.doing.being_somewhere if where else frozenset[str]()
    for place, token in enumerate(tokens):
        word, verb = token.text.lower(), token.tag.startswith(VERBAL)
        left_out = pronouns if verb else pronouns | small
        last = where and place == len(tokens) - 1
        named = word[:1].isalnum() and word not in left_out and (last or content_words(word))
        if named and token.relation not in {"aux", "aux:pass"} and token.lemma not in getting:
            yield token.lemma


def _subject(tokens: Sequence[Token]) -> str:
    return next((token.text.lower() for token in tokens if token.relation in SUBJECTS), "")


def _denies(tokens: Sequence[Token], lexicon: Lexicon) -> bool:
    return any(token.text.lower() in lexicon.closed.negators for token in tokens)


def _is_denied(clause: Sequence[Token], part: TimeRequirement, lexicon: Lexicon) -> bool:
    return part.condition.negated if part.condition is not None else _denies(clause, lexicon)


def done_at_once(text: str, part: TimeRequirement) -> str:
    """Give the words of an instruction with now in place of what it waited for."""
    first, end = part.span
    beside = part.anchor is not None and part.anchor.text != part.text
    time = part.text.replace(part.anchor.text, "now") if part.anchor is not None and beside else AT_FIRST
    return f"{text[:first]}{time}{text[end:]}"
