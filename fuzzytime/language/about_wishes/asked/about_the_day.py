"""Questions about when one is free, what was done, and what there is: "am I free at six?"."""

from fuzzytime.language.about_wishes.about import About, AboutKind
from fuzzytime.language.about_wishes.said import Said
from fuzzytime.language.grammar.lexicon import longest_match
from fuzzytime.requirement import Constraint

BESIDE = {"before": "before", "by": "before", "until": "before", "till": "before", "at": "", "after": "after"}
THE = ("the", "my", "our", "that", "this", "his", "her", "their")


def asked(said: Said) -> About | None:
    """Read a question about gaps, what was done, a thing or a day; None where it is none."""
    return (
        _about_last(said)
        or _is_then(said)
        or _room(said)
        or _free(said)
        or _done(said)
        or _during(said)
        or _beside(said)
        or _about(said)
        or _turned(said)
    )


def _about_last(said: Said) -> About | None:
    if said.is_in("on time"):
        return About(kind=AboutKind.ON_TIME, certain=True)
    if said.is_in("asking next"):
        return About(kind=AboutKind.NEXT, certain=True)
    if said.is_in("asking when"):
        return About(kind=AboutKind.WHEN, certain=True)
    rest = said.after("lasting")
    if rest is not None and rest.ends_with("all of it"):
        # "How long does it take in all?"
        return About(kind=AboutKind.WHEN, everything=True, certain=True)
    return None


def _is_then(said: Said) -> About | None:
    """Read whether something is at some time: "is it today?", "is the dentist at three?"."""
    if said.forms[:1] not in {("is",), ("are",), ("was",), ("were",)} or len(said.words) < 2:
        return None
    thing, time = said.behind(1).parted()
    named = Said(thing, said.now, said.lexicon)
    known = named.is_in("last") or named.forms[:1] == ("the",)
    return About(kind=AboutKind.WHEN, names=_named(named), certain=True) if time and known else None


def _free(said: Said) -> About | None:
    when = said.after("when") if said.forms[:1] != ("how",) else None
    rest = (when or said).after("free")
    if rest is not None:
        time = rest.as_time() if rest.words else ""
        known = not rest.words or bool(time)
        if not known and (beside := rest.beside()) is not None and (names := beside[1].names):
            # "Have I got time before the call?"
            way = BESIDE.get(rest.forms[0], "after")
            return About(kind=AboutKind.ROOM, names=names, joint=way, certain=True)
        busy = "busy" if (when or said).opens_with("busy") else ""
        return About(kind=AboutKind.FREE, time=time, text=busy, certain=True) if known else None
    rest = said.after("may do")
    if rest is None or not rest.words:
        return None
    # "Can I go at five?"
    thing, time = rest.without("instead")[0].parted()
    return About(kind=AboutKind.FREE, thing=thing, time=time, certain=True) if time else None


def _room(said: Said) -> About | None:
    """Read whether there is time for something, before a time or something else."""
    rest = said.after("having time")
    if rest is None or not rest.words:
        return None
    rest = rest.without_end(said.table("closing"))
    for place in range(len(rest.words) - 1, 0, -1):
        way = BESIDE.get(rest.forms[place])
        if way is None:
            continue
        behind = rest.behind(place)
        thing = rest.until(place).text
        if behind.one_time() is not None:
            return About(kind=AboutKind.ROOM, thing=thing, time=behind.text, certain=True)
        names = rest.behind(place + 1).names
        if way and names:
            return About(kind=AboutKind.ROOM, thing=thing, names=names, joint=way, certain=True)
    thing, time = rest.parted()
    return About(kind=AboutKind.ROOM, thing=thing, time=time, certain=True) if thing else None


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
    rest = said.after("holding")
    if rest is None or not rest.words:
        return None
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


def _beside(said: Said) -> About | None:
    """Read what comes before or behind something: "what do I do after lunch?"."""
    rest = said.after("besides")
    if rest is None or not rest.words:
        return None
    beside = rest.beside()
    if beside is None or not beside[1].names:
        return None
    way = "before" if rest.forms[0] == "before" else "after"
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
    certain = rest.forms[0] in THE or said.forms[:2] != ("what", "about")
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
