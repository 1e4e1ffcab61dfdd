"""What is said about what was asked for already: "no, make it six", "cancel the call", "when do I stir?".

A line is ``said``, and what it is ``about`` is a value; ``reading`` tells which kind of line it is:

What is to be otherwise
    ``changes`` of which wishes (``meant``) and by how much (``lengths``); ``turns`` to what was just said;
    ``corrections``; ``things`` alone, or ``called_by_time``; a line in ``other_words``.
What is told or asked
    What somebody has ``told``; what is ``asked``.
What leans on the line before
    ``continued`` gives it in full.
"""

from fuzzytime.language.about_wishes.about import AT_FIRST, AT_LAST, AT_ONCE, About, AboutKind
from fuzzytime.language.about_wishes.called_by_time import called_by_time
from fuzzytime.language.about_wishes.continued import continued, names_thing
from fuzzytime.language.about_wishes.corrections import (
    added_time,
    opening_correction,
    restated,
    without_closing,
)
from fuzzytime.language.about_wishes.lengths import by_how_much, counted, in_full, later_by
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
from fuzzytime.language.about_wishes.reading import about_wishes, bare, behind_what_is_told, without_request
from fuzzytime.language.about_wishes.said import Said
from fuzzytime.language.about_wishes.things import about_things, continuing
from fuzzytime.language.about_wishes.told.awaited import (
    as_now,
    done_at_once,
    is_untold,
    tells_awaited,
    tells_of_somebody,
    written_out,
)
from fuzzytime.language.about_wishes.told.news import News, NewsKind, clauses_of, news_in
from fuzzytime.language.about_wishes.told.of_planned import of_planned
from fuzzytime.language.about_wishes.told.open_hours import goes_on_until, open_hours

__all__ = [
    "AT_FIRST",
    "AT_LAST",
    "AT_ONCE",
    "About",
    "AboutKind",
    "News",
    "NewsKind",
    "Said",
    "about_things",
    "about_wishes",
    "added_time",
    "as_now",
    "bare",
    "behind_an_answer",
    "behind_what_is_told",
    "by_how_much",
    "called_by_time",
    "choice_meant",
    "chooses_none",
    "clauses_of",
    "continued",
    "continuing",
    "counted",
    "done_at_once",
    "goes_on_until",
    "in_full",
    "in_its_place",
    "is_person",
    "is_thing",
    "is_untold",
    "later_by",
    "lets_be",
    "may_be_thing",
    "merged_time",
    "names_thing",
    "news_in",
    "of_planned",
    "open_hours",
    "opening_correction",
    "respelled",
    "restated",
    "reworded",
    "said_apart",
    "tells_awaited",
    "tells_of_somebody",
    "with_names",
    "without_article",
    "without_closing",
    "without_request",
    "written_out",
]
