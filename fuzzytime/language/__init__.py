"""From typed words to instructions with time requirements; the only home of spaCy."""

from fuzzytime.language.answer import answer
from fuzzytime.language.grammar import Times, phrases
from fuzzytime.language.instruction import (
    Instruction,
    Operation,
    Question,
    Reading,
    Remark,
    RemarkKind,
    StrictReading,
    Token,
)
from fuzzytime.language.lexicon import Lexicon
from fuzzytime.language.model import ModelError, installed_model, model_files
from fuzzytime.language.parse_cache import ParseCache
from fuzzytime.language.policy import Policy
from fuzzytime.language.reader import Language

__all__ = [
    "Instruction",
    "Language",
    "Lexicon",
    "ModelError",
    "Operation",
    "ParseCache",
    "Policy",
    "Question",
    "Reading",
    "Remark",
    "RemarkKind",
    "StrictReading",
    "Times",
    "Token",
    "answer",
    "installed_model",
    "model_files",
    "phrases",
]
