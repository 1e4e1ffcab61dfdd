"""What turns to what was said or done just before: "stop that", "the other one", "both calls"."""

from fuzzytime.english import is_participle
from fuzzytime.language.about_wishes.about import About, AboutKind
from fuzzytime.language.about_wishes.corrections import opening_correction
from fuzzytime.language.about_wishes.said import Said
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.language.sentence.trees.named import is_several


def turned(said: Said) -> About | None:
    """Read what is about what was said or done last; None where it may be a wish."""
    corrected = opening_correction(said)
    rest = said.behind(corrected)
    kept = rest.after("retracting")
    if kept is not None and (left := kept.behind(kept.forms[:1] == (",",))).is_in("restoring"):
        # "Never mind, leave it"
        return About(kind=AboutKind.UNDO, text=left.text, certain=True)
    if rest.is_in("restoring"):
        # "Put it back", where something was dropped, or "leave it as it is"
        stays = rest.forms[0] in said.lexicon.doing.keeping
        return About(kind=AboutKind.UNDO, text=rest.text, certain=corrected > 0 or stays)
    if _retracts(rest if rest.words else said) and not rest.is_in("forgetting"):
        # "Scratch that": what was changed last, or else what was asked for
        return About(kind=AboutKind.DROP, corrects=True, certain=True)
    for kind, name in ((AboutKind.STOP, "stopping"), (AboutKind.REVERSE, "reversing")):
        if rest.is_in(name):
            return About(kind=kind, certain=True)
    if (names := _stopped(rest)) is not None:
        return About(kind=AboutKind.STOP, names=names)
    # "Not that one, the other one"
    kept = said.after("denying")
    if kept is not None and kept.words and kept.is_in("last"):
        # "Not that one"
        return About(kind=AboutKind.WRONG, certain=True)
    joint = -1 if kept is None or "," not in kept.forms else kept.forms.index(",")
    if kept is not None and joint > 0 and kept.until(joint).is_in("last"):
        rest = kept.behind(joint + 1)
    return About(kind=AboutKind.OTHER, certain=True) if rest.is_in("other") else None


def _retracts(said: Said) -> bool:
    """Whether a line takes something back, and says nothing else: "no, scratch that"."""
    retracting = said.ends_with("retracting")
    return retracting > 0 and not said.until(len(said.words) - retracting).names


def _stopped(said: Said) -> frozenset[str] | None:
    """Give the words for what is to be done no longer: "stop stirring the soup"; None where none is."""
    rest = said.after("no longer")
    going_on = rest is not None and rest.is_one and is_participle(rest.forms[0]) and not rest.has_time
    return rest.names if rest is not None and going_on else None


def several_in(said: Said) -> frozenset[str] | None:
    """Give what two are called that are meant, none where by nothing: "the two calls"; None for no two."""
    rest = said.after("both")
    if rest is None or not rest.words or rest.has_time or not is_several(rest.text, said.lexicon):
        return None
    general = content_words(" ".join(word for form in said.table("several") for word in form))
    return rest.names - general
