"""What somebody tells to have happened, where something waits for it: "bob called", "the rain stopped"."""

import re
from collections.abc import Iterator, Sequence

from fuzzytime.interpreter import Interpreted
from fuzzytime.language import AT_FIRST, Lexicon, Token, content_words
from fuzzytime.language.grammar.lexicon import longest_match
from fuzzytime.language.grammar.words import words_of
from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime_cli.repl.scene import Scene, number_of, waiting

CONTRACTED = re.compile(r"(?<=\w)['\u2019]s\b")
NOW = "now"
SUBJECTS = frozenset({"nsubj", "nsubj:pass"})
HELPING = frozenset({"aux", "aux:pass"})
VERBAL = ("V", "M")
"""How the tags of verbs begin."""

NOMINAL = ("N", "PRP", "DT")
"""How those begin of which one tells."""


def happened(scene: Scene, words: str) -> tuple[str, ...]:
    """Give the commands that plan what waits for something now that this is told; none where nothing does.

    Of "call mum when I get home", and then "I got home", that is to call mum as soon as possible.
    """
    waited = [(one, part) for _, one in waiting(scene) for part in one.requirements if _is_untold(part)]
    said = words.strip().rstrip(".! ")
    if not waited or said.endswith("?"):
        return ()
    language = scene.conversation.interpreter.language
    reading = language.read(said, now=scene.now)
    if not _tells(reading.tokens):
        # "The glue's dry"
        reading = language.read(CONTRACTED.sub(" is", said), now=scene.now)
    if not _tells(reading.tokens) or any(one.requirements for one in reading.instructions):
        return ()
    found = [(one, part) for one, part in waited if _is_told(reading.tokens, one, part, language.lexicon)]
    lines = (f":edit {number_of(one.identifier)} {_at_once(one.words or '', part)}" for one, part in found)
    return tuple(dict.fromkeys(lines))


def _is_untold(part: TimeRequirement) -> bool:
    """Whether it waits for something that no instruction brings about."""
    if part.condition is not None and part.constraint is Constraint.WHEN:
        return part.condition.target is None and not part.condition.goes_on
    # That the glue is dry is only assumed of what glues.
    loose = part.anchor is not None and (part.anchor.target is None or part.anchor.assumed)
    return loose and part.constraint is Constraint.AFTER


def _tells(tokens: Sequence[Token]) -> bool:
    """Whether words tell something of somebody: what is asked has its verb in front."""
    verbs = (place for place, token in enumerate(tokens) if token.tag.startswith(VERBAL))
    subjects = (place for place, token in enumerate(tokens) if token.relation in SUBJECTS)
    first = next(verbs, None)
    # Trees take "Tim" for a time, in "Tim got home".
    named = bool(tokens) and tokens[0].tag.startswith(NOMINAL)
    return first is not None and first > 0 and (named or next(subjects, first) < first)


def _is_told(told: Sequence[Token], one: Interpreted, part: TimeRequirement, lexicon: Lexicon) -> bool:
    """Whether words tell what somebody waits for: in other forms ("left", "have left"), or of "he"."""
    clause = _clause(one, part, lexicon)
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


def _clause(one: Interpreted, part: TimeRequirement, lexicon: Lexicon) -> list[Token]:
    """Give the words of what is waited for, without what joins them."""
    first, end = part.span
    first += max(part.text.rfind(part.anchor.text), 0) if part.anchor is not None else 0
    words = words_of(part.anchor.text if part.anchor is not None else part.text)
    if joint := longest_match(words, 0, lexicon.clauses):
        first += words[len(joint)].start
    tokens = () if one.reading is None else one.reading.tokens
    return [token for token in tokens if first <= token.span[0] < end]


def _named(tokens: Sequence[Token], lexicon: Lexicon) -> Iterator[str]:
    """Give the words that name who does what, without those that only say that it is news: "just"."""
    closed = lexicon.closed
    pronouns = closed.first_person | closed.personal_pronouns | closed.third_person
    small = {form[0] for name in ("being", "anew") for form in lexicon.conversation[name] if len(form) == 1}
    for token in tokens:
        word, verb = token.text.lower(), token.tag.startswith(VERBAL)
        left_out = pronouns if verb else pronouns | small
        named = word[:1].isalnum() and word not in left_out and content_words(word)
        if named and token.relation not in HELPING:
            yield token.lemma


def _subject(tokens: Sequence[Token]) -> str:
    return next((token.text.lower() for token in tokens if token.relation in SUBJECTS), "")


def _denies(tokens: Sequence[Token], lexicon: Lexicon) -> bool:
    return any(token.text.lower() in lexicon.closed.negators for token in tokens)


def _is_denied(clause: Sequence[Token], part: TimeRequirement, lexicon: Lexicon) -> bool:
    return part.condition.negated if part.condition is not None else _denies(clause, lexicon)


def _at_once(text: str, part: TimeRequirement) -> str:
    """Give the words of an instruction with now in place of what it waited for."""
    first, end = part.span
    beside = part.anchor is not None and part.anchor.text != part.text
    time = part.text.replace(part.anchor.text, NOW) if part.anchor is not None and beside else AT_FIRST
    return f"{text[:first]}{time}{text[end:]}"
