"""Which kind of thing a line of a conversation says about the wishes before it."""

from datetime import datetime

from fuzzytime.language.about_wishes.about import About, AboutKind
from fuzzytime.language.about_wishes.asked.about_the_day import asked
from fuzzytime.language.about_wishes.asked.about_the_plan import question
from fuzzytime.language.about_wishes.changes.changes import change
from fuzzytime.language.about_wishes.corrections import opening_correction
from fuzzytime.language.about_wishes.said import ENDS, Said
from fuzzytime.language.about_wishes.told.reports import report
from fuzzytime.language.finding import LONGEST_TEXT
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.recent import remembering

CLOSING = ("anew", "preferring", "closing")
"""Tables of what may close a line, and says nothing of wishes."""

LONGEST_NAME = 4
"""Words that somebody is called by before what they ask for, at most, and one."""

SO = " so "

NO, COMMA = "no", ","

MARKS = frozenset({",", ".", "!", "?", "-"})


@remembering(64)
def about_wishes(text: str, now: datetime, lexicon: Lexicon) -> About | None:
    """Read what is said about wishes that were said before; None where it may be a wish itself.

    >>> from datetime import datetime
    >>> from fuzzytime.language.finding import shipped_lexicon
    >>> about_wishes("no, make it six", datetime(2026, 3, 4, 9), shipped_lexicon()).time
    'at six'
    """
    if len(text) > LONGEST_TEXT:
        return None
    whole = Said.of(text, now, lexicon)
    if not whole.words:
        return None
    said = _without_courtesies(whole)
    if not said.words or not set(whole.without("answering")[0].forms) - MARKS:
        return About(kind=AboutKind.ANSWER, certain=True)
    if said.without_exclamations().is_in("going ahead"):
        return About(kind=AboutKind.ANSWER, certain=True)
    if text.rstrip().endswith("?") and said.without("yet")[0].is_in("finished"):
        # "Done?"
        return About(kind=AboutKind.DID, certain=True)
    if text.rstrip().endswith("?"):
        said = _without_tag(said)
        further = said.after("continuing")
        if further is not None and further.has_time and further.as_time() == further.text:
            # "And at six?"
            return About(kind=AboutKind.DURING, time=further.text, certain=True)
    found = (
        _read(said) or _certain_behind_and(said) or (_of_thing(said) if text.rstrip().endswith("?") else None)
    )
    plain = said.without_exclamations()
    # "Ok then do it the day after"
    then = plain.after("following") or plain
    # "Hmm, actually maybe make the call a bit later"
    anew = plain.behind(opening_correction(plain)).without_exclamations()
    for other in (plain, then, anew, plain.without_end(plain.table("preferring"))):
        found = _read(other) if found is None and other != said and other.words else found
    return found


def _read(said: Said) -> About | None:
    how = said.after("how to")
    meant = None if how is None or not how.words else change(how) or report(how)
    if meant is not None and meant.kind is not AboutKind.UNABLE:
        # "How do I cancel something?"
        return About(kind=AboutKind.HOW, text=meant.kind.value, certain=True)
    if how is not None and how.words and how.forms[0] in said.lexicon.moving:
        return About(kind=AboutKind.HOW, text=AboutKind.MOVE.value, certain=True)
    order = without_request(said)
    found = asked(said) or question(said) or change(order) or change(said) or report(said)
    return found or (report(order) if order != said else None)


def _certain_behind_and(said: Said) -> About | None:
    """Read what goes on with another change of what was spoken of: "and make it half an hour"."""
    rest = said.after("continuing")
    found = _read(rest) if rest is not None and rest.words else None
    # "And can we do it at three?"
    asked = rest is not None and bool(rest.words) and without_request(rest) != rest
    return found if found is not None and (found.certain or asked) and not found.names else None


def _of_thing(said: Said) -> About | None:
    """Read what is asked of a thing without a verb: "and the eggs?"."""
    thing = said.after("continuing")
    named = thing is not None and thing.words and thing.forms[0] in said.lexicon.closed.noun_openers
    return About(kind=AboutKind.WHEN, names=thing.names, certain=True) if thing and named else None


def _without_tag(said: Said) -> Said:
    """Leave out what makes a question of what it stands behind: "I'm free at two, right?"."""
    joint = max((place for place, word in enumerate(said.forms) if word == ","), default=0)
    return said.until(joint) if joint and said.behind(joint + 1).is_in("answering") else said


def behind_what_is_told(text: str, now: datetime, lexicon: Lexicon) -> tuple[str, About] | None:
    """Give what a line tells, and what it says of wishes behind that: "he is tired, cancel the walk".

    What is told may be nothing that asks; who reads its words must see to that.
    """
    told, mark, rest = text.rpartition(",")
    if not mark:
        # "It's raining so cancel the walk"
        told, mark, rest = text.rpartition(SO)
    if not mark or not rest.strip(ENDS):
        return None
    about = about_wishes(rest, now, lexicon)
    if about is None or about.kind is AboutKind.ANSWER:
        return None
    front = Said.of(told, now, lexicon).without_exclamations()
    front = front.behind(opening_correction(front))
    said = about_wishes(front.text, now, lexicon) if front.words else None
    return "" if said is not None and said.certain else front.text, about


def bare(said: Said) -> Said:
    """Leave out what opens and closes a line and says nothing of wishes: "oh, … after all, please"."""
    rest = said.without_exclamations() if said.words else said
    # "No swimming tomorrow" wishes for none.
    none = rest.forms[:1] == (NO,) and rest.forms[1:2] not in {(COMMA,), ()}
    corrected = opening_correction(rest) if rest.words and not none else 0
    rest = rest.behind(corrected) if corrected < len(rest.words) else rest
    rest = rest.without_thanks().without_end(
        frozenset().union(*map(said.table, CLOSING)) - said.table("instead")
    )
    return rest if rest.text == said.text or not rest.words else bare(rest)


def without_request(said: Said) -> Said:
    """Leave out what makes a question or a suggestion of an order: "could we", "can you please", "let's"."""
    if not said.words:
        return said
    said = _without_courtesies(said)
    questions = said.lexicon.questions
    opening = {*questions["requesting"], *questions["suggesting"], *said.table("letting")}
    form = longest_match(said.words, 0, opening)
    if form is not None and len(form) < len(said.words):
        return said.behind(len(form))
    # "Bob wants to move it to four"
    asks = (said.behind(place).after("asking to") for place in range(1, min(len(said.words), LONGEST_NAME)))
    return next((rest for rest in asks if rest is not None and rest.words), said)


def _without_courtesies(said: Said) -> Said:
    """Leave out what opens a request, as it does a wish, and thanks: "could you please … thanks"."""
    lexicon = said.lexicon
    opening = {*lexicon.courtesies, *((word,) for word in lexicon.addresses)} - lexicon.corrections.keys()
    place = 0
    while form := longest_match(said.words, place, opening):
        if place + len(form) >= len(said.words):
            break
        place += len(form)
    # "Cancel the gym too"
    return said.behind(place).without_thanks().without_end(said.table("closing") | said.table("no more"))
