"""What somebody tells to be so now: "the pan is hot" is a reading, "Bob is here" what was waited for."""

from collections.abc import Callable
from dataclasses import replace

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import Reading, content_words, reported
from fuzzytime.language.about_wishes import (
    AT_ONCE,
    About,
    AboutKind,
    about_wishes,
    as_now,
    behind_what_is_told,
    news_in,
)
from fuzzytime.requirement import Condition, Constraint
from fuzzytime.times import format_duration
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.commands.changing import ctx
from fuzzytime_cli.repl.conversation import context_of
from fuzzytime_cli.repl.plain_words.leaving_out import Taken
from fuzzytime_cli.repl.plain_words.retiming import IDLE
from fuzzytime_cli.repl.plain_words.said_again import same_anew
from fuzzytime_cli.repl.plain_words.taking import run
from fuzzytime_cli.repl.scene import Reply, Scene, refused, waiting
from fuzzytime_cli.told_states import as_news, is_waited_for, tells_a_state, tells_what_is, told_of

CHANGED = frozenset({AboutKind.MOVE, AboutKind.DELAY, AboutKind.DROP, AboutKind.EXCEPT})
"""What may be said for a reason."""


def told_state(scene: Scene, words: str, reading: Reading) -> Reply | None:
    """Take what is so now as a reading, or as what something waits for; None where nothing is told."""
    if (reply := told_reading(scene, words, reading)) is not None:
        return reply
    said = words.strip().rstrip(".! ")
    if not _tells(scene, said, reading) or _condition(scene, said) is None:
        return None
    if not is_waited_for(said, (one for _, one in waiting(scene))):
        return None
    anew = as_news(said)
    read = scene.language.read(anew, now=scene.now).instructions
    if not any(one.operation is not None and one.operation.stated for one in read):
        return None
    return Reply((Text(plain(f"taken as: {anew}")),), anew=anew)


def told_reading(scene: Scene, words: str, reading: Reading) -> Reply | None:
    """Take what is so now as a reading of a signal: "the pan is hot"; None where it is of none."""
    said = words.strip().rstrip(".! ")
    condition = _condition(scene, said) if _tells(scene, said, reading) else None
    if condition is None:
        return None
    conversation = scene.conversation
    context = context_of(conversation.given, scene.now).merged(
        context_of(conversation.state.readings, scene.now)
    )
    told = conversation.interpreter.rulebook.told(condition, context)
    if told is None or not (told.value is not None or _is_event(told.signal, said, condition)):
        return None
    unit = f" {told.unit}" if told.unit else ""
    text = told.signal if told.value is None else f"{told.signal}={told.value:g}{unit}"
    reply = ctx(scene, text)
    head = Text(plain(f"taken as :ctx {text}; :undo takes it back"))
    return Reply((head, *reply.lines), changed=reply.changed)


def told_to_have_happened(scene: Scene, words: str) -> Reply | None:
    """Take an event that is told to have happened as a reading: "the timer rang"; else give None."""
    anew = as_now(words.strip().rstrip(".! "), scene.lexicon)
    return None if anew is None else told_reading(scene, anew, scene.language.read(anew, now=scene.now))


def _is_event(signal: str, said: str, condition: Condition) -> bool:
    """Whether it is told of an event itself: "dinner's here", and not "mum's in charge of dinner"."""
    named = content_words(signal.replace("_", " "))
    about = content_words(condition.subject)
    return content_words(said) <= named or any(word in signal for word in about)


def _tells(scene: Scene, said: str, reading: Reading) -> bool:
    """Whether words tell what is so, and are no news of what was told."""
    if said.endswith("?") or not reading.instructions or not tells_a_state(said, reading, scene.lexicon):
        return False
    return not is_news(scene, said)


def behind_how_a_day_is(scene: Scene, words: str, taken: Taken) -> Reply | None:
    """Take what is said of wishes behind how some day is: "the bank's closed today, do it tomorrow"."""
    told, about = behind_what_is_told(words, scene.now, scene.lexicon) or ("", None)
    if about is None or about.kind not in CHANGED or about.names or not told:
        return None
    reading = scene.language.read(told, now=scene.now)
    times = [part for one in reading.instructions for part in one.requirements]
    lexicon, forms = scene.lexicon, told.lower().replace("\u2019", "'").split()
    being = any(form in lexicon.closed.present_be or form.endswith(("'s", "'m", "'re")) for form in forms)
    event = not (lexicon.events | lexicon.happening).isdisjoint(content_words(told))
    days = bool(times) and all(part.constraint is Constraint.BETWEEN for part in times)
    if not (being and days) or event or is_news(scene, told):
        return None
    reply = taken(scene, about)
    changes_nothing = Text(plain(f"{told!r} changes nothing"))
    return None if reply is None else replace(reply, lines=(*reply.lines, changes_nothing))


def behind_a_fact(scene: Scene, words: str, answered: Callable[[Scene, str], Reply | None]) -> Reply | None:
    """Take what is asked for behind what tells how something is: "Tom's out, call Bob at two"; else None."""
    told, mark, rest = words.partition(",")
    reading = scene.language.read(told, now=scene.now) if mark and rest.strip() else None
    done = reading is not None and _tells_done(told, reading, scene)
    if reading is None or not (done or tells_what_is(reading, scene.lexicon)) or is_news(scene, told):
        return None
    asked = scene.language.read(rest, now=scene.now).instructions
    if not any(one.operation is not None and one.operation.is_asked for one in asked):
        return None
    # "I've fed the cat, call Bob at two"
    try:
        state = answered(scene, told) if done else told_state(scene, told, reading)
    except FuzzytimeError as error:
        state = refused(str(error))
    untimed = not any(one.requirements for one in asked)
    again = same_anew(scene, f"{rest.strip()} {AT_ONCE}") if done and untimed else None
    # "The onions are done, put the soup on", which was to be put on later
    reply = answered(scene, rest.strip()) if again is None else run(scene, About(kind=AboutKind.MOVE), again)
    lines = (Text(plain(f"{told!r} changes nothing")),) if state is None else state.lines
    if reply is None:
        return Reply(lines, anew=rest.strip())
    return replace(reply, lines=(*lines, *reply.lines))


def _tells_done(told: str, reading: Reading, scene: Scene) -> bool:
    """Whether it is told that something was done, or is: "I've fed the cat", "the onions are done"."""
    about = about_wishes(told, scene.now, scene.lexicon)
    done = about is not None and about.kind is AboutKind.DONE and bool(about.names)
    return done or reported(reading, scene.lexicon) is not None


def told_anew(scene: Scene, about: About, words: str, taken: Taken) -> Reply | None:
    """Take what is told anew of a thing: when it is, or, in one, by how much it is late; else None."""
    if about.kind is AboutKind.MOVE:
        return taken(scene, about)
    if about.kind is not AboutKind.DELAY or about.by is None or "," not in words or not is_news(scene, words):
        return None
    # "The truck's late, about 20 minutes"
    anew = f"{about.thing} {format_duration(abs(about.by))} {'early' if about.by < 0.0 else 'late'}"
    return Reply((Text(plain(f"taken as: {anew}")),), anew=anew)


def is_news(scene: Scene, said: str) -> bool:
    """Whether words tell anew of what was said to happen."""
    happening = [one.operation for one in scene.plan.everything if one.stated and one.operation is not None]
    return any(
        news.is_of(one, scene.lexicon)
        for news in news_in(said, scene.now, scene.lexicon)
        for one in happening
    )


def _condition(scene: Scene, said: str) -> Condition | None:
    """Give what is told as what somebody may wait for; of "it" what is waited for."""
    read = scene.language.read(f"{IDLE} when {said}", now=scene.now)
    found = [part.condition for one in read.instructions for part in one.requirements]
    if len(found) != 1 or found[0] is None:
        return None
    if found[0].subject not in told_of(scene.lexicon):
        return found[0]
    alike = (one for one in _awaited(scene) if one.word is not None and one.word == found[0].word)
    return next(alike, found[0])


def _awaited(scene: Scene) -> list[Condition]:
    """Give what skills that have not started wait for."""
    return [
        part.condition
        for _, one in waiting(scene)
        for part in one.requirements
        if part.condition is not None and part.constraint is Constraint.WHEN
    ]
