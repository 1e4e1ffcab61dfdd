"""From typed words to instructions with time requirements; the only home of spaCy.

The ``reader`` finds times by the ``grammar`` of ``english`` (``finding``), with what they are in
``meaning``, and reads what stands around them in the ``sentence``. An ``instruction`` comes out, an
``answer`` for other programs. ``continued`` and ``about_wishes`` are for conversations. The ``policy``
decides what words leave open; rule tables bring ``own_words``; ``lines`` and what is ``unseen`` are
seen to first.
"""

from fuzzytime.language.about_wishes.about import AT_FIRST, AT_LAST, AT_ONCE, About, AboutKind
from fuzzytime.language.about_wishes.called_by_time import called_by_time
from fuzzytime.language.about_wishes.corrections import added_time, restated, without_closing
from fuzzytime.language.about_wishes.lengths import by_how_much, later_by
from fuzzytime.language.about_wishes.other_words.answers import choice_meant, chooses_none, lets_be
from fuzzytime.language.about_wishes.other_words.merging import merged_time
from fuzzytime.language.about_wishes.other_words.replacing import (
    behind_an_answer,
    in_its_place,
    said_apart,
    with_names,
)
from fuzzytime.language.about_wishes.other_words.respelling import respelled
from fuzzytime.language.about_wishes.other_words.rewording import (
    is_person,
    is_thing,
    may_be_thing,
    reworded,
    without_article,
)
from fuzzytime.language.about_wishes.reading import (
    about_wishes,
    bare,
    behind_what_is_told,
    without_request,
)
from fuzzytime.language.about_wishes.said import Said
from fuzzytime.language.about_wishes.things import about_things, continuing
from fuzzytime.language.about_wishes.told.awaited import (
    done_at_once,
    is_untold,
    tells_awaited,
    tells_of_somebody,
    written_out,
)
from fuzzytime.language.about_wishes.told.news import News, NewsKind, clauses_of, news_in
from fuzzytime.language.about_wishes.told.told_done import perhaps_reported, reported, told_result
from fuzzytime.language.answer import NAMED, answer
from fuzzytime.language.continued import continued, names_thing
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
from fuzzytime.language.policy import Policy
from fuzzytime.language.reader import Language
from fuzzytime.language.sentence.references.mentions import comes, nouns_of, shares_thing, undoes, verb_forms
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.language.sentence.trees.model import ModelError, installed_model, model_files
from fuzzytime.language.sentence.trees.named import is_several
from fuzzytime.language.sentence.trees.parse_cache import ParseCache

__all__ = [
    "AT_FIRST",
    "AT_LAST",
    "AT_ONCE",
    "HALF_OF_DAY_ADVICE",
    "NAMED",
    "About",
    "AboutKind",
    "Instruction",
    "Language",
    "Lexicon",
    "ModelError",
    "News",
    "NewsKind",
    "Operation",
    "Order",
    "ParseCache",
    "Policy",
    "Question",
    "Reading",
    "Remark",
    "RemarkKind",
    "Said",
    "StrictReading",
    "Times",
    "Token",
    "about_things",
    "about_wishes",
    "added_time",
    "answer",
    "bare",
    "behind_an_answer",
    "behind_what_is_told",
    "by_how_much",
    "called_by_time",
    "check_customs",
    "check_length",
    "choice_meant",
    "chooses_none",
    "clauses_of",
    "comes",
    "content_words",
    "continued",
    "continuing",
    "done_at_once",
    "find_times",
    "in_its_place",
    "installed_model",
    "is_person",
    "is_several",
    "is_thing",
    "is_untold",
    "later_by",
    "lets_be",
    "may_be_thing",
    "merged_time",
    "model_files",
    "names_thing",
    "news_in",
    "nouns_of",
    "perhaps_reported",
    "reported",
    "respelled",
    "restated",
    "reworded",
    "said_apart",
    "shares_thing",
    "shipped_lexicon",
    "tells_awaited",
    "tells_of_somebody",
    "told_result",
    "undoes",
    "verb_forms",
    "with_names",
    "with_words",
    "without_article",
    "without_closing",
    "without_request",
    "written_out",
]
