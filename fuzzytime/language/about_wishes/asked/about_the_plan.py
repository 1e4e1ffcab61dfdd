"""Questions about the plan: "what's next?", "how long until dinner?", "why so late?"."""

from fuzzytime.language.about_wishes.about import About, AboutKind
from fuzzytime.language.about_wishes.said import LABEL, Said
from fuzzytime.language.sentence.trees.content_words import content_words


def question(said: Said) -> About | None:
    """Read a question about the plan; None where it is none."""
    return _supposed(said) or _why(said) or _when(said) or _lasting(said) or _open(said)


def named_by(said: Said) -> frozenset[str]:
    """Give what a question is about: its labels, or its words but for those that name nothing."""
    if labels := frozenset(filter(LABEL.fullmatch, said.text.lower().split())):
        return labels
    closed = said.lexicon.closed
    times = {*said.lexicon.numbers, "at", "am", "pm"} | closed.personal_pronouns | closed.object_pronouns
    return frozenset(name for name in said.names - _words(said, "filling") - times if not name.isdigit())


def _supposed(said: Said) -> About | None:
    rest = said.after("supposing")
    if rest is None or not rest.words:
        return None
    if rest.forms[0] in said.lexicon.closed.first_person:
        rest = rest.behind(1)
    return About(kind=AboutKind.SUPPOSE, text=rest.text, certain=True) if rest.words else None


def _why(said: Said) -> About | None:
    rest = said.after("why")
    named = None if rest is None or rest.as_time() else _in_front(rest.without("last")[0])
    if named is not None and named.has_time:
        # "Why do I varnish at half ten?"
        named = Said(named.parted()[0] or named.text, said.now, said.lexicon)
    # "Why friday?"
    names = frozenset() if named is None else named_by(named)
    if rest is None or (names and _asks_for_something(said)):
        return None
    return About(kind=AboutKind.WHY, names=names, certain=True)


def _in_front(said: Said) -> Said:
    """Leave out what a thing comes before, or after: "the salad after the rice"."""
    joints = (
        n
        for n in range(1, len(said.words))
        if said.forms[n] in said.lexicon.beside.before_or_after and said.behind(n + 1).names
    )
    place = next(joints, len(said.words))
    return said.until(place) if said.until(place).names else said


def _asks_for_something(said: Said) -> bool:
    """Whether what looks like a question is a suggestion: "why don't you stir the soup?"."""
    return any(said.forms[: len(form)] == form for form in said.lexicon.questions["suggesting"])


def _when(said: Said) -> About | None:
    rest = said.after("when")
    if rest is None or not rest.words:
        return None
    if said.forms[0] == "when" and rest.forms[0] not in helping(said):
        # "When the rice is done, stir" is a clause.
        return None
    if rest.ends_with("everything") or _is_over(rest):
        return About(kind=AboutKind.WHEN, everything=True, certain=True)
    if rest.is_in("moment") and said.forms[0] != "when":
        return About(kind=AboutKind.CLOCK, certain=True)
    rest, found = rest.without("next of all", "yet")
    names = named_by(rest)
    # "What time do I start then?"
    about_it = not names and any((word,) in said.table("last") for word in rest.forms)
    about_it |= not names and rest.forms[:2] in said.table("done next")
    out = "be" in rest.forms and rest.forms[-1] in said.lexicon.particles
    over = "over" if out or rest.ends_with("finished") or rest.ends_with("present") else ""
    asked = About(kind=AboutKind.WHEN, names=names, text=over, upcoming="next of all" in found, certain=True)
    return asked if names or about_it else None


def helping(said: Said) -> frozenset[str]:
    """Give the helping words that a question may begin with: "is", "will"."""
    questions = said.lexicon.questions
    return frozenset(form[0] for form in questions["helping"] | questions["stating"])


def _is_over(said: Said) -> bool:
    """Whether who speaks asks when all is over: "when will I be done"."""
    rest, found = said.without("finished", "speaker", "everything")
    return "finished" in found and "speaker" in found and not named_by(rest)


def _lasting(said: Said) -> About | None:
    rest = said.after("lasting")
    if rest is not None and not rest.words:
        return About(kind=AboutKind.NEXT, certain=True)
    if rest is None or not rest.words:
        return None
    if rest.is_in("having left"):
        # "How much time do I have?"
        return About(kind=AboutKind.NEXT, certain=True)
    # "Tell me how long that takes"
    told = rest.forms[-1:] in said.table("needing") and len(rest.words) > 1
    if rest.forms[0] not in helping(said) and not told:
        return None
    rest = (rest.until(len(rest.words) - 1) if told else rest).without("yet")[0]
    left = rest.names & _words(said, "plan")
    names = named_by(rest) - left
    # "How long is left?" asks for what is going on.
    return About(kind=AboutKind.LASTING if names or not left else AboutKind.NEXT, names=names, certain=True)


def _open(said: Said) -> About | None:
    """Read a question about what comes next, or about everything."""
    asking = said.after("what") or said.after("showing")
    if asking is None:
        return None
    rest = asking.names
    last = any(asking.behind(place).opens_with("coming last") for place in range(len(asking.words)))
    if rest - _words(said, "filling") == _words(said, "clock") and said.after("what") is not None:
        return About(kind=AboutKind.CLOCK, certain=True)
    plan, open_ = (_words(said, name) for name in ("plan", "open"))
    filling = _words(said, "filling")
    ending = plan | open_ | filling | _words(said, "coming last") | _words(said, "occasion")
    if last and said.after("what") is not None and rest <= ending:
        return About(kind=AboutKind.NEXT, places=(-1,), certain=True)
    if rest & plan and rest <= plan | open_ | filling | _words(said, "everything"):
        return About(kind=AboutKind.ALL, certain=True)
    nexts = {word.text for word in asking.words} & {form[0] for form in said.table("open")}
    if said.after("what") is not None and (nexts or rest & _words(said, "doing")) and rest <= open_ | filling:
        return About(kind=AboutKind.NEXT, certain=True)
    return None


def _words(said: Said, name: str) -> frozenset[str]:
    return content_words(" ".join(word for form in said.table(name) for word in form))
