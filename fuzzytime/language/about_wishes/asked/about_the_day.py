"""Questions about when one is free, what was done, and what there is: "am I free at six?"."""

from dataclasses import replace

from fuzzytime.language.about_wishes.about import About, AboutKind
from fuzzytime.language.about_wishes.asked.about_room import (
    AFTER,
    BEFORE,
    BETWEEN,
    NONE,
    ROOM,
    asked_gap,
    asked_room,
    ends_between,
    way_beside,
)
from fuzzytime.language.about_wishes.asked.about_the_plan import helping
from fuzzytime.language.about_wishes.said import Said
from fuzzytime.language.grammar.lexicon import longest_match
from fuzzytime.requirement import Constraint


def asked(said: Said) -> About | None:
    """Read a question about gaps, what was done, a thing or a day; None where it is none."""
    return (
        _about_last(said)
        or _over_by(said)
        or asked_room(said)
        or _free(said)
        or asked_gap(said)
        or _is_then(said)
        or _during(said)
        or _done(said)
        or _beside(said)
        or _about(said)
        or _turned(said)
    )


def _about_last(said: Said) -> About | None:
    if said.is_in("asking for all"):
        return About(kind=AboutKind.ALL, certain=True)
    if said.is_in("asking if late"):
        return About(kind=AboutKind.ON_TIME, text=said.text, certain=True)
    if said.is_in("on time"):
        return About(kind=AboutKind.ON_TIME, certain=True)
    if said.is_in("asking next"):
        return About(kind=AboutKind.NEXT, certain=True)
    if said.is_in("asking when"):
        return About(kind=AboutKind.WHEN, certain=True)
    rest = said.after("lasting")
    ends = () if rest is None else (rest, rest.without_end(said.table("needing")))
    if any(end.ends_with("all of it") for end in ends):
        # "How long does it take in all?"
        return About(kind=AboutKind.WHEN, everything=True, certain=True)
    return None


def _is_then(said: Said) -> About | None:
    """Read whether something is at some time: "is it today?", "is the dentist at three?"."""
    if said.forms[:1] not in {("is",), ("are",), ("was",), ("were",)} or len(said.words) < 2:
        return None
    thing, time = said.behind(1).parted()
    named = Said(thing, said.now, said.lexicon).without("yet")[0]
    known = named.is_in("last") or named.forms[:1] == ("the",)
    return About(kind=AboutKind.WHEN, names=_named(named), certain=True) if time and known else None


def _free(said: Said) -> About | None:
    """Read whether somebody is free, or busy, at a time: "am I free at six?", "is she free at two?"."""
    when = said.after("when") if said.forms[:1] != ("how",) else None
    asks = when or said
    rest = asks.after("free") or asks.after("busy") or _of_somebody(asks)
    if rest is not None:
        thing, time = rest.parted() if rest.words else ("", "")
        time = rest.as_time() or (time if rest.text.startswith(time) and rest is not said else "")
        known = not rest.words or bool(time)
        if (beside := rest.beside()) is not None and (names := beside[1].names):
            # "Have I got time before the call?"
            way = way_beside(rest, 0)
            way = AFTER if way is None else way
            return replace(ROOM, names=names, joint=way, text=rest.text, time=time)
        nouns = asks.table("gaps") - asks.table("at leisure")
        if time and not time.startswith("at ") and any((word,) in nouns for word in asks.forms):
            # "Is there a gap this afternoon?"
            return replace(ROOM, time=time, text=time)
        busy = "busy" if asks.opens_with("busy") or "busy" in asks.forms else ""
        return About(kind=AboutKind.FREE, time=time, text=busy, certain=True) if known else None
    rest = said.after("may do")
    if rest is None or not rest.words:
        return None
    # "Can I go at five?"
    thing, time = rest.without("instead")[0].parted()
    return About(kind=AboutKind.FREE, thing=thing, time=time, certain=True) if time else None


def _of_somebody(said: Said) -> Said | None:
    """Give what stands behind "free" in a question of anybody: "is Ann free at two for a chat?"."""
    place = next((n for n, word in enumerate(said.forms) if (word,) in said.table("at leisure")), 0)
    asks = place > 1 and said.forms[0] in helping(said) and said.until(place).length() is None
    return said.behind(place + 1) if asks else None


def _over_by(said: Said) -> About | None:
    """Read whether all is over by a time: "will I be home by five?"."""
    points = said.lexicon.closed.prepositions_of_points
    due = (n for n in range(2, len(said.words)) if said.forms[n] in points and way_beside(said, n) == BEFORE)
    place = next((n for n in due if said.behind(n).one_time()), 0)
    if not place or said.forms[0] not in helping(said):
        return None
    rest, found = said.until(place).behind(1).without("finished", "present", "speaker", "everything")
    over = bool(found & {"finished", "present"}) and bool(found & {"speaker", "everything"})
    time = said.behind(place).text
    return About(kind=AboutKind.ON_TIME, time=time, certain=True) if over and not rest.words else None


def _done(said: Said) -> About | None:
    """Read whether something was done: "did I feed the cat?", "is the soup done?", "done yet?"."""
    bare = said.without("yet")[0]
    holds = bare.opens_with("having left") > bare.opens_with("done already")
    rest = None if holds else bare.after("done already")
    if rest is not None and rest.names:
        return About(kind=AboutKind.DID, names=rest.names, thing=rest.text, certain=True)
    helping = bare.forms[:1] and bare.forms[0] in {"is", "are"}
    rest = bare.behind(1) if helping else None
    finished = rest.ends_with("finished") if rest else 0
    if rest is None or not finished:
        return None
    thing = rest.until(len(rest.words) - finished)
    known = not thing.words or thing.is_in("last") or bool(thing.names)
    return About(kind=AboutKind.DID, names=_named(thing), thing=thing.text, certain=True) if known else None


def _named(said: Said) -> frozenset[str]:
    return frozenset() if said.is_in("last") else said.names


def _during(said: Said) -> About | None:
    """Read what there is at some time: "what's on friday?", "what am I doing at nine?"."""
    rest = said.after("holding") or said.after("busy") or _doing(said)
    what = said.after("what") if rest is None else None
    # "What's between lunch and the call?"
    rest = what if what is not None and what.words and way_beside(what, 0) == BETWEEN else rest
    if rest is None or not rest.words:
        return None
    names, others = ends_between(rest.behind(1)) if way_beside(rest, 0) == BETWEEN else (NONE, NONE)
    if names:
        time = rest.text if rest.one_time() is not None else ""
        between = About(kind=AboutKind.DURING, time=time, names=names, others=others, certain=True)
        return replace(between, thing=rest.text)
    again = rest.after("holding") or rest
    for one in (said.behind(len(said.words) - len(rest.words) - 1), again):
        # "What's on friday": "on" may belong to the question, or to the time
        found = one.one_time()
        if found is not None and found.constraint is not Constraint.FOR:
            return About(kind=AboutKind.DURING, time=one.text, certain=True)
    time = rest.as_time()
    if not time:
        # "What do I take tomorrow?"
        verb, time = rest.parted()
        # "What about lunch then?"
        time = time if " " not in verb and (time.lower(),) not in said.table("instead") else ""
    return About(kind=AboutKind.DURING, time=time, certain=True) if time else None


def _doing(said: Said) -> Said | None:
    """Give what stands behind what somebody does: "what's Ann doing at three?"."""
    rest = said.after("what")
    place = rest.forms.index("doing") if rest is not None and "doing" in rest.forms else 0
    return rest.behind(place + 1) if rest is not None and place else None


def _beside(said: Said) -> About | None:
    """Read what comes before or behind something: "what do I do after lunch?"."""
    rest = said.after("besides")
    if rest is None or not rest.words:
        return None
    beside = rest.beside()
    if beside is None or not beside[1].names:
        return None
    way = BEFORE if way_beside(rest, 0) == BEFORE else AFTER
    thing = beside[1].text
    return About(kind=AboutKind.BESIDE, names=beside[1].names, thing=thing, joint=way, certain=True)


def _about(said: Said) -> About | None:
    """Read a question about a thing: "what about the car?", "what's step two?"."""
    asked_for = said.after("what")
    if asked_for is not None and asked_for.label:
        return About(kind=AboutKind.WHEN, names=frozenset({asked_for.label}), certain=True)
    rest = said.without_end(said.table("instead")).after("asking about")
    if rest is None or not rest.names or rest.has_time:
        return None
    # "What about calling Ann?" is a suggestion.
    certain = rest.forms[0] in said.lexicon.closed.definite_determiners or said.forms[:2] != ("what", "about")
    return About(kind=AboutKind.WHEN, names=rest.names, certain=certain)


def _turned(said: Said) -> About | None:
    """Read a question that ends with what asks: "bank when?"."""
    if len(said.words) < 2 or said.forms[-1:] not in {("when",), ("why",)}:
        return None
    if longest_match(said.words, 0, said.table("what") | said.table("when")):
        return None
    thing = said.until(len(said.words) - 1)
    kind = AboutKind.WHEN if said.forms[-1] == "when" else AboutKind.WHY
    return About(kind=kind, names=_named(thing), certain=True) if thing.names else None
