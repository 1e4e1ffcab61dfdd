"""What is said right behind a question about room, or beside it: "pop that in", "have lunch then"."""

from collections.abc import Callable
from dataclasses import replace

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import Interpreted
from fuzzytime.language.about_wishes import AboutKind, Said, about_wishes
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.naming import entry_of
from fuzzytime_cli.repl.plain_words.usually_said import asks_how_it_is
from fuzzytime_cli.repl.questions import rooms
from fuzzytime_cli.repl.scene import Reply, Scene, waiting

ROOMS = frozenset({AboutKind.ROOM, AboutKind.FREE})
"""Questions of which what is told behind them is said: "is there time for a run? it takes an hour"."""


def offer_taken(scene: Scene, words: str) -> str | None:
    """Give what is wished by who takes what there was said to be room for: "pop that in".

    Raises
    ------
    FuzzytimeError
        If there are several gaps, and which one is not said; or if there is no room for it.
    """
    offer = scene.offer
    if offer is None:
        return None
    said = Said.of(words, scene.now, scene.lexicon).without_exclamations()
    ahead = said.after("going ahead")
    if ahead is not None and ahead.forms[:1] == (",",):
        # "Go on, put it in"
        said = ahead.behind(1)
    if said.is_in("accepting") and offer.thing:
        return f"{offer.thing} {offer.time}".rstrip()
    if said.is_in("accepting") and not said.is_in("going ahead"):
        raise FuzzytimeError("nothing was said to fit in: say what is to be done, and when")
    for place in range(1, len(said.words)):
        behind = said.behind(place).after("in the gap")
        front = said.until(place)
        if behind is not None and (not behind.words or behind.forms[0] == ",") and not front.has_time:
            if not offer.time:
                raise FuzzytimeError("which gap? Say: at two, after the call")
            return f"{front.text} {offer.time}{behind.text}"
    return None


def takes_offer(scene: Scene, words: str) -> bool:
    """Whether a line says no more than that what was tried is to be so: "yes please", "ok, do that then"."""
    said = Said.of(words, scene.now, scene.lexicon)
    taken = said.opens_with("agreeing")
    # "Ok, do that"
    behind = said.behind(taken + (said.forms[taken : taken + 1] == (",",))).without_exclamations()
    told = behind.without_end(said.table("preferring")) if behind.words else said
    return any(told.is_in(name) for name in ("accepting", "agreeing"))


def declines(scene: Scene, words: str) -> bool:
    """Whether a line lets be what there was said to be room for: "no, don't bother"."""
    said = Said.of(words, scene.now, scene.lexicon)
    taken = said.opens_with("answering")
    behind = said.behind(taken + (said.forms[taken : taken + 1] == (",",))) if taken else said
    # "No, leave it"
    return behind.is_in("retracting") or behind.is_in("restoring")


def beside_what_is_meant(scene: Scene, words: str) -> str | None:
    """Give a wish with what it is to come before or after, where that was spoken of: "print it beforehand".

    Behind an answer that is what was asked about, and before what has begun nothing can be; where it is what
    was said last, the words need no other.
    """
    said = Said.of(words, scene.now, scene.lexicon).without_exclamations()
    for place in range(1, len(said.words)):
        behind = said.behind(place).after("beside it")
        if behind is None or (behind.words and behind.forms[0] != ","):
            continue
        way = "before" if said.forms[place].startswith("before") else "after"
        meant = _meant_beside(scene, way)
        if meant is None or len(scene.language.read(words, now=scene.now).instructions) != 1:
            return None
        name, operation = meant.skill.name, meant.operation
        done = operation is not None and operation.object not in {None, name}
        return f"{said.until(place).text} {way} {'I' if done else 'the'} {name}{behind.text}"
    return None


def _meant_beside(scene: Scene, way: str) -> Interpreted | None:
    """Give what "beforehand" and "afterwards" mean, where that is not what was said last."""
    last, spoken_of = scene.conversation.state.entries[-1:], entry_of(scene, frozenset())
    if spoken_of is None or (way == "after" and not waiting(scene, spoken_of.number)):
        return None
    ahead = [entry for entry in reversed(scene.conversation.state.entries) if waiting(scene, entry.number)]
    meant = spoken_of if waiting(scene, spoken_of.number) else next(iter(ahead), None)
    return None if meant is None or meant in last else waiting(scene, meant.number)[0][1]


def question_with_aside(
    scene: Scene, words: str, answered: Callable[[Scene, str], Reply | None]
) -> Reply | None:
    """Answer a question with what is told of it behind it, which changes nothing; None where nothing is."""
    asked, mark, aside = words.partition("? ")
    told = Said.of(aside, scene.now, scene.lexicon)
    if not mark or not told.words or not (told.opens_with("they") or told.opens_with("last")):
        return None
    about, length = about_wishes(f"{asked}?", scene.now, scene.lexicon), told.length()
    if about is not None and about.kind is AboutKind.ROOM and length is not None:
        return rooms.room(scene, replace(about, by=length.seconds))
    of_room = about is not None and about.kind in ROOMS
    news = about is not None and about_wishes(aside, scene.now, scene.lexicon) is not None
    if not of_room and (news or not asks_how_it_is(scene, f"{asked}?")):
        # "When's the call? It takes an hour" tells of the call.
        return None
    answer = answered(scene, f"{asked}?")
    beside = Text(plain(f"{told.text!r} is told beside the question, and changes nothing"))
    return None if answer is None or answer.changed else replace(answer, lines=(*answer.lines, beside))
