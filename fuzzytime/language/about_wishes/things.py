"""What a line without a verb says of wishes: "and dad at seven", "no, the rice", "the call an hour later"."""

from dataclasses import replace
from datetime import datetime

from fuzzytime.english import EMPTY
from fuzzytime.language.about_wishes.about import AT_FIRST, AT_LAST, About, AboutKind
from fuzzytime.language.about_wishes.corrections import opening_correction
from fuzzytime.language.about_wishes.lengths import later_by
from fuzzytime.language.about_wishes.said import Said
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match

SHORTEST = 3
"""Words of one thing, and of the one that it is not."""


def continuing(text: str, now: datetime, lexicon: Lexicon) -> About | None:
    """Read what goes on with the verb that was said last; None where no word says that it goes on.

    >>> from datetime import datetime
    >>> from fuzzytime.language.finding import shipped_lexicon
    >>> said = continuing("and dad at seven", datetime(2026, 3, 4, 9), shipped_lexicon())
    >>> said.thing, said.time
    ('dad', 'at seven')
    """
    said = Said.of(text, now, lexicon).without_exclamations()
    if (same := said.after("like")) is not None and same.words:
        thing, time = same.parted()
        return (
            About(kind=AboutKind.LIKE, thing=thing, time=time, joint="for", certain=True) if thing else None
        )
    again = said.after("again")
    if again is not None and (time := again.as_time() if again.words else ""):
        return About(kind=AboutKind.AGAIN, time=time, certain=True)
    if again is not None and not again.words and len(said.words) > 1:
        return About(kind=AboutKind.AGAIN, certain=True)
    opened = said.opens_with("continuing")
    follows = "then" if said.opens_with("following") else ""
    rest = said.behind(opened)
    closing = rest.ends_with("closing")
    rest = rest.until(len(rest.words) - closing) if closing else rest
    if not (opened or closing) or not rest.words:
        return None
    if opened and (more := continuing(rest.text, now, lexicon)) is not None and more.certain:
        return more
    if opened and rest.has_time and rest.as_time() == rest.text:
        # "And at half past seven"; but "and dinner at seven"
        return About(kind=AboutKind.AGAIN, time=rest.text, certain=True)
    thing, time = rest.parted()
    # "And at eleven not ten" is another time, and no other thing.
    thing = "" if Said(thing, now, lexicon).opens_with("denying") else thing
    named = bool(thing) and not is_of_all(Said(thing, now, lexicon))
    return About(kind=AboutKind.LIKE, thing=thing, time=time, text=follows) if named else None


def about_things(text: str, now: datetime, lexicon: Lexicon) -> About | None:
    """Read what a line without a verb says of things that were, or might have been, asked for; else None."""
    whole = _without_and(Said.of(text, now, lexicon).without_exclamations().without_thanks())
    place = opening_correction(whole)
    said = whole.behind(place).without_exclamations() if place else whole
    # "The soup at four instead"
    told = said.without_end(said.table("instead") - lexicon.connectives.keys())
    said, place = told, place + (told != said)
    naming = whole.after("naming anew") or whole.after("meaning")
    if naming is not None and naming.words:
        said, place = naming, 1
    instead = _instead(whole) or _instead(said)
    if instead is not None:
        return instead
    if (kept := _to_be_kept(said, corrects=place > 0)) is not None:
        return _kept(kept)
    denied = said.after("denying") if not place or said.forms[:1] == ("not",) else None
    if denied is not None and denied.names and "," not in denied.forms and not denied.has_time:
        # "Not the carrots"
        return About(kind=AboutKind.DROP, names=denied.names, thing=denied.text, certain=place > 0)
    if len(said.words) > 1 and (placed := _placed(said)) is not None:
        return placed
    if (later := _later(said)) is not None:
        return later
    thing, time = said.parted(bare=True)
    if not thing or said.places:
        return None
    if time and (one := _one_of(Said(thing, now, lexicon))) is not None:
        return replace(one, time=time, corrects=place > 0)
    if time and whole.forms[0] == "no" and whole.forms[1:2] != (",",):
        # "No swimming today", where none is known
        return None
    if time:
        names = Said(thing, now, lexicon).names
        return About(kind=AboutKind.MOVE, names=names, thing=thing, time=time, corrects=place > 0)
    if not place or "," in said.forms:
        return None
    # "Actually no salad", but "no, the salad"
    none_wanted = whole.forms[place - 1] == "no" and said.forms[0] not in EMPTY
    instead = About(kind=AboutKind.INSTEAD, thing=thing, certain=True)
    return About(kind=AboutKind.DROP, names=said.names, thing=thing) if none_wanted else instead


def _without_and(said: Said) -> Said:
    """Leave out what goes on in front of another thing, or time: "and make it Ann", "and at six not five"."""
    rest = said.behind(1) if said.forms[:1] == ("and",) and len(said.words) > 1 else said
    return rest if rest.opens_with("naming anew") or "not" in rest.forms else said


def _to_be_kept(said: Said, *, corrects: bool) -> Said | None:
    """Give what is to be as it was: "keep the plumber", "leave the call where it is", "restore the call"."""
    staying = said.without_end(said.table("staying"))
    keeps = (corrects or staying != said) and bool(said.forms) and said.forms[0] in said.lexicon.doing.keeping
    return staying.behind(1) if keeps else said.after("bringing back")


def _kept(thing: Said) -> About | None:
    """Read what is kept where all was dropped: "no wait, keep the plumber", "leave the call where it is"."""
    return (
        About(kind=AboutKind.UNDO, names=thing.names, thing=thing.text, certain=True) if thing.names else None
    )


def _later(said: Said) -> About | None:
    """Read what is to be later, or earlier: "the call an hour later", "call mum earlier"."""
    later = later_by(said)
    if later is not None and later[1].names:
        # "Start the salad ten minutes earlier", which was to be made
        names = later[1].names - said.lexicon.doing.beginning or later[1].names
        return replace(later[0], names=names, certain=True)
    names = (
        said.until(len(said.words) - 1).names
        if said.forms[-1:] in {("earlier",), ("sooner",)}
        else frozenset()
    )
    # By how much is not said.
    return About(kind=AboutKind.DELAY, names=names, earlier=True, certain=True) if names else None


def _placed(said: Said) -> About | None:
    """Read what is to come first, or last: "the test first", "first the test", "the salad last"."""
    thing = said.until(len(said.words) - 1)
    ways = {"first": AT_FIRST, "last": AT_LAST}
    time = ways.get(said.forms[-1], "")
    if time and thing.names and not (time == AT_LAST and said.has_time):
        return About(kind=AboutKind.MOVE, names=thing.names, thing=thing.text, time=time)
    if said.forms[0] == "first" and not time and not said.has_time:
        return About(kind=AboutKind.MOVE, names=said.behind(1).names, time=AT_FIRST, certain=True)
    return None


def _one_of(said: Said) -> About | None:
    """Give which one words mean that name no thing, or whether all: "that one", "the second one", "both"."""
    if said.is_in("last"):
        return About(kind=AboutKind.MOVE, certain=True)
    if said.label:
        # "S1 at noon"
        return About(kind=AboutKind.MOVE, names=frozenset({said.label}), certain=True)
    if said.is_in("the next"):
        return About(kind=AboutKind.MOVE, upcoming=True, certain=True)
    if said.is_in("other"):
        return About(kind=AboutKind.MOVE, other=True, certain=True)
    if is_of_all(said):
        return About(kind=AboutKind.MOVE, everything=True, certain=True)
    return About(kind=AboutKind.MOVE, places=said.places, certain=True) if len(said.places) == 1 else None


def is_of_all(said: Said) -> bool:
    """Whether words name all that is left, or both, or what was spoken of last, and no other thing."""
    return any(said.is_in(name) for name in ("both", "everything", "last", "other"))


def _instead(said: Said) -> About | None:
    """Read what stands in the place of what: "not the soup, the rice", "butter, not bread"."""
    forms = said.forms
    corrected = opening_correction(said)
    joint = next((n for n, word in enumerate(forms) if word in {",", "but"} and n >= max(corrected, 1)), None)
    if forms[:1] == ("not",) and joint is not None:
        old, new = said.until(joint).behind(1), said.behind(joint + 1)
        new = new.behind(1) if new.forms[:1] == ("but",) else new
    elif joint is not None and forms[joint + 1 : joint + 2] == ("not",):
        old, new = said.behind(joint + 2), said.until(joint)
    elif (
        joint is None
        and "not" in forms[1:-1]
        and (len(forms) == SHORTEST or said.until(forms.index("not")).as_time())
    ):
        # "At three not two", "dad not mum"
        old, new = said.behind(forms.index("not") + 1), said.until(forms.index("not"))
    elif (place := _instead_of(said)) is not None:
        old, new = said.behind(place).after("in its place of") or said, said.until(place)
    else:
        return None
    if longest_match(old.words, 0, said.lexicon.clauses):
        # "Call Ann today, not while the baby sleeps"
        return None
    thing, time = ("", new.as_time()) if new.as_time() else new.parted()
    if time and old.as_time():
        # "At three, not two", "the gym at four, not ten"
        of = replace(new, text=thing).names
        return About(kind=AboutKind.MOVE, names=of, time=time, corrects=not of, certain=True)
    if new.is_in("other"):
        return About(kind=AboutKind.OTHER, certain=True)
    if not (new.names and (old.names or old.is_in("last"))) or "," in new.forms:
        return None
    return About(kind=AboutKind.INSTEAD, names=old.names, thing=new.text, certain=True)


def _instead_of(said: Said) -> int | None:
    places = range(1, len(said.words))
    return next((place for place in places if said.behind(place).opens_with("in its place of")), None)
