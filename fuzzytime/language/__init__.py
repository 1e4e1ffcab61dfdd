"""From typed words to instructions with time requirements; the only home of spaCy.

The ``reader`` finds times by the ``grammar`` of ``english`` (``finding``), with what they are in
``meaning``, and reads what stands around them in the ``sentence``. An ``instruction`` comes out, an
``answer`` for other programs; one may only be ``told_done``. The ``policy`` decides what words leave
open; rule tables bring ``own_words``; ``lines`` and what is ``unseen`` are seen to first. What was read
last is kept (``recent``).

``about_wishes`` is for conversations: a door of its own, since one call needs nothing of it.
"""

from fuzzytime.language.answer import NAMED, answer
from fuzzytime.language.finding import Times, check_customs, check_length, find_times, shipped_lexicon
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import (
    Instruction,
    Operation,
    Order,
    Question,
    Reading,
    Remark,
    RemarkKind,
    StrictReading,
    Token,
)
from fuzzytime.language.meaning.required.decisions import HALF_OF_DAY_ADVICE
from fuzzytime.language.own_words import with_words
from fuzzytime.language.policy import Policy, Steps
from fuzzytime.language.reader import Language
from fuzzytime.language.sentence.references.hours_on_days import hours_on_a_day
from fuzzytime.language.sentence.references.meals import names_meal
from fuzzytime.language.sentence.references.mentions import comes, nouns_of, shares_thing, undoes, verb_forms
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.language.sentence.trees.model import ModelError, installed_model
from fuzzytime.language.sentence.trees.model_files import model_files
from fuzzytime.language.sentence.trees.named import is_several
from fuzzytime.language.sentence.trees.parse_cache import ParseCache
from fuzzytime.language.told_done import perhaps_reported, reported, told_result

__all__ = [
    "HALF_OF_DAY_ADVICE",
    "NAMED",
    "Instruction",
    "Language",
    "Lexicon",
    "ModelError",
    "Operation",
    "Order",
    "ParseCache",
    "Policy",
    "Question",
    "Reading",
    "Remark",
    "RemarkKind",
    "Steps",
    "StrictReading",
    "Times",
    "Token",
    "answer",
    "check_customs",
    "check_length",
    "comes",
    "content_words",
    "find_times",
    "hours_on_a_day",
    "installed_model",
    "is_several",
    "model_files",
    "names_meal",
    "nouns_of",
    "perhaps_reported",
    "reported",
    "shares_thing",
    "shipped_lexicon",
    "told_result",
    "undoes",
    "verb_forms",
    "with_words",
]
