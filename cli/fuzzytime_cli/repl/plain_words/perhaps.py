"""What is taken as it stands, though something that was asked for may be meant: that is said, or asked."""

from collections.abc import Sequence
from datetime import date, datetime

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import Interpretation, Interpreted
from fuzzytime.language import Lexicon, Operation, content_words
from fuzzytime.language.about_wishes import AboutKind, about_wishes, news_in
from fuzzytime.times import instant_after
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.naming import called, entry_of, is_named_itself
from fuzzytime_cli.repl.plain_words.leaving_out import repeats
from fuzzytime_cli.repl.scene import Reply, Scene, waiting
from fuzzytime_cli.session import Started

BE, MUST_BE = "be", "must be"
"""The verb of what is only told, and the words in front of one with which something is to be done."""


def cancelled_elsewhere(scene: Scene, words: str) -> Reply | None:
    """Say of what is to be cancelled that nothing planned is about it, so that cancelling is to be done.

    Raises
    ------
    FuzzytimeError
        If something like it is planned: "the first viewing", where there is one viewing.
    """
    language = scene.language
    about = about_wishes(words, scene.now, language.lexicon)
    declining = language.lexicon.doing.declining
    if about is None or about.kind is not AboutKind.DROP or not scene.conversation.state.entries:
        return None
    if words.split(maxsplit=1)[0].lower() not in declining:
        return None
    thing = " ".join(words.rstrip(".! ").split()[1:])
    named = content_words(thing.rpartition(" ")[2])
    like = entry_of(scene, named) if named else None
    if like is not None and is_named_itself(scene, named):
        label = called(scene, like.number) or f"s{like.number}"
        raise FuzzytimeError(
            f"nothing that is planned is called {thing!r}; if {like.text!r} is: drop {label}"
        )
    head = "nothing that is planned is about that: taken as something to do; :undo takes it back"
    return Reply((Text(head),), anew=words)


def check_who(scene: Scene, words: str) -> None:
    """Ask who is meant where "she" comes at another time, and several are to come.

    Raises
    ------
    FuzzytimeError
        If several are.
    """
    told = words.lower().replace("\u2019", "'").partition("'")[0].split()
    news = [one for one in news_in(words, scene.now, scene.lexicon) if one.several is False and not one.names]
    if not news or scene.lexicon.closed.third_person_singular.isdisjoint(told):
        return
    left = [(one, one.operation) for _, one in waiting(scene) if not one.skill.duration]
    who = [one for one, comes in left if comes is not None and news[0].is_of(comes, scene.lexicon)]
    if len(who) > 1:
        named = " or ".join(f"{one.skill.name} ({one.identifier})" for one in who)
        raise FuzzytimeError(f"which one: {named}? Say it with the name")


def second_lines(
    made: Interpretation, running: Sequence[Started], number: int, words: str, now: datetime, lexicon: Lexicon
) -> tuple[Text, ...]:
    """Say that the same is planned for another time of the day, or running: "gym at seven", after "at six".

    Who says that it is "another one" knows.
    """
    own = [one for one in made.everything if one.wish.identifier == f"s{number}"]
    known = (lexicon.conversation[name] for name in ("closing", "again", "more"))
    said_so = {form[0] for form in frozenset().union(*known) if len(form) == 1}
    if len(own) != 1 or repeats(own[0]) or not said_so.isdisjoint(words.lower().split()):
        return ()
    others = [one for one in made.everything if one is not own[0] and not repeats(one)]
    same = [one for one in others if _is_same(one, own[0], lexicon) and _day(one, now) == _day(own[0], now)]
    told = [
        (one.identifier, one.skill.name, ", ".join(part.text for part in one.requirements)) for one in same
    ]
    operation = own[0].operation
    named = frozenset[str]() if operation is None else _essence(operation, lexicon)
    told += [
        (one.identifier, one.name, "running") for one in running if named and named <= content_words(one.name)
    ]
    if len(told) != 1:
        return ()
    ((identifier, name, when),) = told
    first = f"{identifier} {name}{f' ({when})' if when else ''}"
    return (Text(plain(f"beside {first}, which stays; if they are one: drop {identifier}")),)


def _day(one: Interpreted, now: datetime) -> date | None:
    best = one.skill.satisfaction.best
    return None if best.empty else instant_after(now, best.low).date()


def _is_same(one: Interpreted, other: Interpreted, lexicon: Lexicon) -> bool:
    """Whether two things may be one: "get the rice in" and "put the rice in", "gym" and "do the gym"."""
    operation, behind = one.operation, other.operation
    if operation is None or behind is None or operation.negated or behind.negated:
        return False
    things = content_words(operation.object)
    timed = lexicon.happening | lexicon.events | lexicon.taken
    begins = (
        (behind.stated and things.isdisjoint(timed))
        or not behind.object
        or behind.lemma in lexicon.doing.beginning
    )
    if things and things == content_words(behind.object or behind.verb) and (operation.particle or begins):
        # "Rice at ten", beside "cook the rice at nine"
        return operation.particle == behind.particle
    alone = not (behind.object or behind.place) and behind.lemma not in lexicon.needing_nothing
    alike = bool(things) and things == content_words(behind.object) and not (operation.place and behind.place)
    if operation.lemma == behind.lemma and (alone or alike):
        # "Bake at eleven", "bake the loaves with Jo", beside "bake the loaves at ten"
        return operation.particle == behind.particle
    told = behind.stated or behind.lemma == BE or behind.due == MUST_BE
    if told and not (things | content_words(operation.place)).isdisjoint(
        content_words(behind.object) - timed
    ):
        # "Slides are with them now", beside "send the slides"
        return True
    same = content_words(operation.name) == content_words(behind.name)
    return same or _essence(operation, lexicon) == _essence(behind, lexicon)


def _essence(operation: Operation, lexicon: Lexicon) -> frozenset[str]:
    """Give the words that name what is done, without a verb that says no more: "do the gym"."""
    doing, words = lexicon.doing, content_words(operation.name)
    light = operation.lemma in doing.beginning | doing.running | doing.spending
    return words - content_words(operation.verb) if light else words
