"""What a line says of what was asked for as it is usually said: "Tom rang, the gym can wait till six"."""

import re

from fuzzytime.language.about_wishes import (
    AboutKind,
    NewsKind,
    Said,
    about_things,
    about_wishes,
    bare,
    called_by_time,
    news_in,
)
from fuzzytime_cli.repl.naming import entry_of
from fuzzytime_cli.repl.plain_words.known import is_known
from fuzzytime_cli.repl.plain_words.shifting import shift_said
from fuzzytime_cli.repl.plain_words.telling import is_news
from fuzzytime_cli.repl.plain_words.told_times import order_told
from fuzzytime_cli.repl.plain_words.ways import MARK, in_usual_words, of_whom
from fuzzytime_cli.repl.scene import Scene
from fuzzytime_cli.repl.which import with_label, with_labels_of_places

JOINTS = re.compile(r"(,\s+|;\s+|\s+[-\u2013\u2014]+\s+|\s+(?:because|since|so)\s+)", re.IGNORECASE)
"""What stands between what is asked for and what is told beside it."""

COMMA = ", "
APART = ". "
"""What stands between what changes something, and a wish beside it."""

SURELY_ASKED = frozenset(
    {AboutKind.ON_TIME, AboutKind.LEEWAY, AboutKind.APART, AboutKind.ALL, AboutKind.LASTING, AboutKind.WHY}
)
"""Questions that are no request, whatever else they may be read as."""

TWO = 2
"""Clauses of what is late, and when it then is."""

LONGEST = 40
"""Words of a line that is about what was asked for, at most."""


def as_usually_said(scene: Scene, words: str) -> str:
    """Give a line with what it says about wishes as that is usually said; as it is where it says nothing.

    Behind that a reason stands behind a comma, whatever stood there: "skip the gym - I'm tired".
    """
    if len(words.split()) > LONGEST:
        return words
    words = _with_labels(scene, words)
    if asks_how_it_is(scene, words):
        # "Would it be possible to ring the landlord earlier?"
        return shift_said(scene, words) or words
    about = about_wishes(words, scene.now, scene.lexicon)
    if about is not None and about.certain and about.kind in SURELY_ASKED and words.rstrip().endswith("?"):
        # "Will it all be done by noon?"
        return words
    parts = JOINTS.split(words)
    clauses, joints = parts[::2], parts[1::2]
    whole = _usual(scene, words)
    if len(clauses) == TWO and (order := _when_late(scene, *clauses)):
        return order
    if not joints:
        return words if whole is None else whole
    first = _usual(scene, clauses[0])
    tells = first is not None or is_news(scene, clauses[0])
    if whole is not None and (tells or not _is_wish(scene, clauses[0])):
        return whole
    for place, told in enumerate(clauses[:-1]):
        clauses[place + 1] = _of_who_rang(scene, told, clauses[place + 1])
    usual = [first, *(_usual(scene, clause) for clause in clauses[1:])]
    if any(usual[1:]) and not tells and _is_wish(scene, clauses[0]):
        # "Order the cake, it's needed by six" is of the cake, whatever was asked for before.
        of_it = [place > 0 and _is_of_it(scene, clause) for place, clause in enumerate(clauses)]
        usual = [None if own else one for own, one in zip(of_it, usual, strict=True)]
    for place, joint in enumerate(joints):
        said = usual[place] or clauses[place]
        known = usual[place] is not None or about_wishes(said, scene.now, scene.lexicon) is not None
        joints[place] = COMMA if known else joint
        # "The pool shuts at five, so call Bob at six" says two things.
        beside = [clauses[n] for n in (place, place + 1) if usual[n] is None]
        joints[place] = APART if len(beside) == 1 and _is_wish(scene, beside[0]) else joints[place]
    said = [one or clause for one, clause in zip(usual, clauses, strict=True)]
    return "".join(part for pair in zip(said, [*joints, ""], strict=True) for part in pair)


def _is_of_it(scene: Scene, clause: str) -> bool:
    """Whether a clause is of what was named before it: "it takes an hour", "I can't do it before two"."""
    closed, said = scene.lexicon.closed, Said(clause, scene.now, scene.lexicon).forms
    things = closed.personal_pronouns | closed.it_or_them | closed.anaphors
    return any(not things.isdisjoint(form.split("'")) for form in said)


def asks_how_it_is(scene: Scene, words: str) -> bool:
    """Whether a line asks how something is, and for nothing to be done: "is gym before lunch?"."""
    said, questions = tuple(words.lower().split()), scene.lexicon.questions

    def opens(name: str) -> bool:
        return any(said[: len(form)] == form for form in questions[name])

    asks = words.rstrip().endswith("?") and opens("stating")
    return asks and not (opens("requesting") or opens("suggesting"))


def _is_wish(scene: Scene, clause: str) -> bool:
    """Whether a clause asks for something of its own, and says nothing of what was asked for."""
    if not clause.strip() or about_wishes(clause, scene.now, scene.lexicon) is not None:
        return False
    asked = [one.operation for one in scene.language.read(clause, now=scene.now).instructions]
    return any(one is not None and one.is_asked and not one.negated for one in asked)


def _of_who_rang(scene: Scene, told: str, clause: str) -> str:
    """Give a clause with whom it is of, behind who rang: "Tom rang, he can't come before two"."""
    said, behind = (Said.of(text, scene.now, scene.lexicon) for text in (told, clause))
    rang = next((n for n in range(1, len(said.words)) if said.behind(n).is_in("getting in touch")), 0)
    who = said.until(rang)
    if not rang or not behind.words or not is_known(scene, who, told=True):
        return clause
    if behind.opens_with("absent"):
        return f"{who.text} {behind.text}"
    return of_whom(who, behind).text


def _when_late(scene: Scene, told: str, clause: str) -> str:
    """Give the order for what is told to be late, and then when it is: "Ann is late, she comes at two"."""
    about = about_wishes(told, scene.now, scene.lexicon)
    late = about is not None and about.kind is AboutKind.DELAY and about.by is None and not about.text
    said = Said.of(clause, scene.now, scene.lexicon)
    if about is None or not (late and about.names and said.opens_with("they")) or is_news(scene, told):
        return ""
    entry = entry_of(scene, about.names)
    parts = (said.behind(place) for place in range(1, len(said.words)))
    time = next((part.as_time() for part in parts if part.one_time() is not None), "")
    moves = entry is not None and time and not time.lower().startswith(("for ", "by "))
    return f"move {entry.identifier} to {time.removeprefix('at ')}" if entry is not None and moves else ""


def _of_whose(scene: Scene, clause: str) -> str:
    """Give a clause with what it tells of those that belong to something told of that: "Rolo's owner"."""
    said = Said.of(clause, scene.now, scene.lexicon)
    for place in (n for n, form in enumerate(said.forms[1:-1], 1) if (form,) in said.table("belonging")):
        whole, owner = said.until(place + 1), MARK.sub("", said.until(place).text)
        who = Said(owner, said.now, said.lexicon)
        if entry_of(scene, whole.names) is None and who.words and is_known(scene, who, told=True):
            return f"{who.text} {said.behind(place + 1).text}"
    return clause


def _with_labels(scene: Scene, words: str) -> str:
    """Give a line with labels for what it calls by a time, or place: "the four o'clock", "the first one"."""
    while (called := called_by_time(words, scene.now, scene.lexicon)) is not None:
        labelled = with_label(scene, words, *called)
        if labelled is None or labelled == words:
            break
        words = labelled
    # "The first one" may answer which is meant.
    return words if scene.asked is not None else with_labels_of_places(scene, words)


def _usual(scene: Scene, clause: str) -> str | None:
    """Give a clause as it is usually said; None where it says nothing about wishes, or does so already."""
    if not clause.strip():
        return None
    about = about_wishes(clause, scene.now, scene.lexicon)
    if about is not None and about.kind is AboutKind.UNDO and about.text:
        # "Put it all back" pushes nothing.
        return None
    if (shifted := shift_said(scene, clause)) is not None:
        return shifted
    order = order_told(scene, clause)
    if is_news(scene, clause):
        # What only is late may tell a bound: "lunch can't be later than half twelve".
        told = news_in(clause, scene.now, scene.lexicon)
        if any(one.kind is not NewsKind.LATE for one in told):
            return None
    if order is not None:
        return order
    whose = _of_whose(scene, clause)
    if whose != clause:
        clause, about = whose, about_wishes(whose, scene.now, scene.lexicon)
    # "Leave it" is said of what was changed.
    sure = about is not None and about.certain

    def known(thing: Said, told: bool) -> bool:  # noqa: FBT001 - as the ways ask
        return is_known(scene, thing, told=told or (sure and thing.is_in("last")))

    usual = in_usual_words(clause, scene.now, scene.lexicon, known)
    # "Put the call back to where it was"
    things = None if usual is None else about_things(usual, scene.now, scene.lexicon)
    restores = things is not None and things.kind is AboutKind.UNDO
    if usual is not None and (restores or about_wishes(usual, scene.now, scene.lexicon) is not None):
        return usual
    whole = Said.of(clause, scene.now, scene.lexicon)
    closed, then = scene.lexicon.closed, whole.after("following")
    if then is not None and not (closed.told_auxiliaries | closed.third_person_be).isdisjoint(then.forms[1:]):
        # "Then the choir can start at seven"
        return _usual(scene, then.text)
    plain = bare(whole)
    if plain.text == whole.text or about is not None:
        return None
    about = about_wishes(plain.text, scene.now, scene.lexicon)
    named = about is not None and about.names and entry_of(scene, about.names) is not None
    return plain.text if named or (about is not None and about.certain) else None
