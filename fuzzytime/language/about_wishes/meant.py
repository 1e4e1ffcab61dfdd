"""Which wishes words mean: the last one, both, the next, or those that are named."""

from fuzzytime.language.about_wishes.about import About, AboutKind
from fuzzytime.language.about_wishes.said import LABEL, Said
from fuzzytime.language.about_wishes.turns import several_in
from fuzzytime.language.sentence.trees.named import is_several


def is_last(said: Said) -> bool:
    """Whether nothing is named but what was said last."""
    return not said.words or said.is_in("last")


def named_in(said: Said) -> frozenset[str]:
    """Give the words that name a thing; none where the last is meant, or one by its place."""
    if said.is_in("last") or said.places:
        return frozenset()
    return frozenset({said.label}) if said.label else said.names


def about_thing(kind: AboutKind, thing: Said, *, certain: bool = False) -> About:
    """Give what is said of a thing that was asked for, or of several."""
    if thing.is_in("both"):
        return About(kind=kind, both=True, certain=True)
    if (both := several_in(thing)) is not None:
        return About(kind=kind, names=both, both=True, certain=True)
    if thing.is_in("other"):
        return About(kind=kind, other=True, certain=True)
    if thing.is_in("the next"):
        return About(kind=kind, upcoming=True, certain=True)
    following = thing.after("the next")
    if following is not None and following.names and not thing.places:
        # "The next aspirin"
        return About(kind=kind, names=following.names, upcoming=True)
    counted = () if thing.is_in("last") else thing.places
    names = named_in(thing)
    several = bool(names) and not thing.label and is_several(thing.text, thing.lexicon)
    certain = certain or bool(counted or thing.label)
    each = () if thing.label or counted else listed_in(thing)
    return About(kind=kind, names=names, each=each, places=counted, several=several, certain=certain)


def listed_in(thing: Said) -> tuple[frozenset[str], ...]:
    """Give the words that name each of several things: "the call and the soup"; none where there is one."""
    labels = thing.text.lower().split()
    if len(labels) > 1 and all(LABEL.fullmatch(label) for label in labels):
        # "S1 s2"
        return tuple(frozenset({label}) for label in labels)
    joints = [place for place, word in enumerate(thing.forms) if word in thing.lexicon.closed.coordinators]
    first = (0, *(place + 1 for place in joints))
    parts = [
        thing.until(end).behind(begin) for begin, end in zip(first, (*joints, len(thing.words)), strict=True)
    ]
    named = tuple(part.names for part in parts if part.words)
    return named if len(named) > 1 and all(named) else ()
