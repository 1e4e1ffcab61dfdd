"""Reports of how it goes: "done", "the soup is ready", "I'm ten minutes late", "five more minutes"."""

from dataclasses import replace

from fuzzytime.english import is_participle
from fuzzytime.language.about_wishes.about import About, AboutKind
from fuzzytime.language.about_wishes.corrections import opening_correction
from fuzzytime.language.about_wishes.lengths import lengthened
from fuzzytime.language.about_wishes.said import FOR, Said
from fuzzytime.language.about_wishes.told.told_of import is_over


def report(said: Said) -> About | None:
    """Read how it goes; None where it may be a wish."""
    return (
        _of_last(said)
        or _late(said)
        or _more(said)
        or lengthened(said)
        or _unstarted(said)
        or _started(said)
        or _finished(said)
        or _going_on(said)
        or _protest(said)
    )


def _of_last(said: Said) -> About | None:
    """Read that what was spoken of last was done, or was not: "I already did", "no, not yet"."""
    rest = said.behind(opening_correction(said))
    if rest.is_in("said of me"):
        return About(kind=AboutKind.DONE, text=rest.text, certain=True)
    if rest.is_in("not done"):
        return About(kind=AboutKind.UNSTARTED, text=rest.text, certain=True)
    both, over = rest.opens_with("both"), rest.behind(rest.opens_with("both"))
    if both and over.words and is_over(over):
        return About(kind=AboutKind.DROP, both=True, certain=True)
    return None


def _late(said: Said) -> About | None:
    """Read who is late, or needs a while: "I'm ten minutes late", "give me five minutes"."""
    while_ = said.after("asking for a while")
    alone = None if while_ is None or while_.without("more")[1] else while_.length()
    if alone is not None and not alone.rest.words and alone.joint != FOR:
        return About(kind=AboutKind.LATE, by=alone.seconds, certain=True)
    found = said.length()
    left, tables = (said if found is None else found.rest).without("late", "speaker")
    by = None if found is None else found.seconds
    if "late" in tables and "speaker" in tables and not left.names:
        return About(kind=AboutKind.LATE, by=by, certain=True)
    return None


def _more(said: Said) -> About | None:
    """Read for how much longer something goes on: "five more minutes", "the soup needs another minute"."""
    if said.forms[:1] == ("make",):
        return _made_longer(said.behind(1))
    joint = said.forms.index(",") if said.forms.count(",") == 1 else 0
    front, by = (
        (_more(said.until(joint)), said.behind(joint + 1).without("more", "they", "being")[0].length())
        if joint
        else (None, None)
    )
    if front is not None and front.by is None and by is not None and not by.rest.words:
        # "The dishes took longer, it'll be another ten minutes"
        return replace(front, by=by.seconds)
    without, tables = said.without("more")
    # "Another hour" is none without its article.
    found = without.length() or said.length() if "more" in tables and said.is_one else None
    if found is None:
        left, parts = said.without("more", "needing", "lengths")
        # "The sanding takes longer": by how much is not said
        known = {"more", "needing"} <= parts and said.forms[-1:] in said.table("lengths")
        # "It takes longer", "the sanding takes longer"
        if not known or (left.words and not (left.names or left.is_in("last"))):
            return None
        return About(kind=AboutKind.MORE, names=left.names, certain=True)
    named, parts = found.rest.without("needing", "last", "more")
    # "Five more minutes for the rice", "give the rice five more minutes"
    given = named.behind(1) if named.forms[:1] in {("give",), (FOR.strip(),)} else named
    certain = not named.names or "needing" in parts or given is not named
    return About(kind=AboutKind.MORE, names=given.meant, by=found.seconds, certain=certain)


def _made_longer(said: Said) -> About | None:
    """Read what is to take longer, or less: "make the lesson ten minutes longer", "make it a bit shorter"."""
    for place in range(1, len(said.words)):
        thing, way = said.until(place), said.behind(place)
        left, parts = way.without("more", "less")
        # "Another hour" is none without its article.
        found = left.length() or way.without("less")[0].length()
        slight = f"{left.text} later" if left.is_in("slightly") else ""
        if not parts or (
            left.words and not slight and (found is None or found.rest.without("more")[0].words)
        ):
            continue
        by = None if found is None else -found.seconds if "less" in parts else found.seconds
        about = About(kind=AboutKind.MORE, names=thing.meant, by=by, text=slight, earlier="less" in parts)
        return replace(about, certain=by is not None or thing.is_in("last"))
    return None


def _unstarted(said: Said) -> About | None:
    """Read what has not begun: "I haven't started yet", "I haven't started the soup"."""
    rest = said
    while not rest.opens_with("unstarted") and (taken := rest.opens_with("speaker")):
        rest = rest.behind(taken)
    thing = rest.after("unstarted")
    if thing is None or thing.has_time:
        return None
    return About(kind=AboutKind.UNSTARTED, names=_begun(thing).meant, certain=True)


def _begun(said: Said) -> Said:
    """Leave out what stands beside a thing that is begun, or is not: "with the soup yet", "on the soup"."""
    thing = said.without("yet")[0]
    return thing.behind(1) if thing.forms[:1] in {("with",), ("on",)} else thing


def _started(said: Said) -> About | None:
    """Read what has begun just now: "started", "I've started the soup", or is to begin: "start now"."""
    if said.is_in("beginning now"):
        return About(kind=AboutKind.STARTED, upcoming=True, certain=True)
    if said.forms[0] in said.lexicon.doing.beginning and (label := said.behind(1).label):
        # "Start s2"
        return About(kind=AboutKind.STARTED, names=frozenset({label}), certain=True)
    thing = said.after("started")
    if thing is None or not thing.is_one or (thing := _begun(thing)).has_time:
        return None
    return About(kind=AboutKind.STARTED, names=thing.meant, upcoming=not thing.words, certain=True)


def _going_on(said: Said) -> About | None:
    """Read what is not over yet, of which nothing changes: "still cutting the boards"."""
    rest = said.after("still at")
    going_on = rest is not None and rest.words and is_participle(rest.forms[0]) and not rest.has_time
    return About(kind=AboutKind.WHEN, names=rest.names, certain=True) if rest and going_on else None


def _protest(said: Said) -> About | None:
    """Read that something is wrong, or cannot be done: "that's not right", "I can't do that now"."""
    for kind in (AboutKind.WRONG, AboutKind.UNABLE):
        rest = said.after(kind.value)
        if rest is not None and not rest.without("yet", "first", "last")[0].words:
            return About(kind=kind, certain=True)
    unable = said.after("unable of") if said.is_one else None
    timed = unable is not None and unable.has_time
    thing = Said(unable.parted()[0], said.now, said.lexicon) if unable is not None and timed else unable
    if thing is not None and thing.names:
        # "I can't make the gym today"
        return About(kind=AboutKind.UNABLE, names=thing.names, told=True)
    # "Jo can't make it", and "today"
    whole = Said(said.parted()[0], said.now, said.lexicon) if said.has_time else said
    who = whole.without_end(said.table("unable then"))
    if len(who.words) < len(whole.words) and who.names and said.is_one and not who.has_time:
        return About(kind=AboutKind.UNABLE, names=who.names)
    for place in range(1, len(said.words) if said.is_one else 0):
        who, rest = said.until(place), said.behind(place).after("unable at")
        if rest is not None and who.names and rest.words and rest.as_time():
            # "Jo can't do two"
            return About(kind=AboutKind.UNABLE, names=who.names)
    return None


def _finished(said: Said) -> About | None:
    rest = said
    while taken := rest.opens_with("speaker"):
        rest = rest.behind(taken)
    over = rest.opens_with("finished")
    if over:
        # "Done", "I'm done with the soup", "finished the soup"
        thing = rest.behind(over)
        with_it = thing.forms[:1] == ("with",)
        thing = thing.behind(1) if with_it else thing
        having = with_it or not thing.words or rest.opens_with("having")
        if rest != said and thing.words and thing.as_time():
            # "I'm done for today"
            return About(kind=AboutKind.NEXT, certain=True)
        if not having or thing.has_time:
            return None
        if thing.is_in("everything"):
            return About(kind=AboutKind.DROP, everything=True, certain=True)
        return About(kind=AboutKind.DONE, names=thing.meant, certain=True)
    return _stated_over(said)


def _stated_over(said: Said) -> About | None:
    """Read what is over without a verb: "number 1 done", "shirts done"."""
    closing = said.ends_with("finished")
    thing = said.until(len(said.words) - closing)
    if not closing or not thing.words or (thing.has_time and not thing.label):
        return None
    if thing.label:
        return About(kind=AboutKind.DONE, names=frozenset({thing.label}), certain=True)
    if thing.is_in("everything"):
        return About(kind=AboutKind.DROP, everything=True, certain=True)
    named = thing.behind(1) if thing.forms[0] in said.lexicon.closed.noun_openers else thing
    # "Get the shirts done" is a wish.
    return About(kind=AboutKind.DONE, names=named.names) if len(named.words) == 1 and named.names else None
