"""Plain words about what was asked for already, taken as the commands that they mean."""

from collections.abc import Callable, Mapping
from dataclasses import replace

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import Reading, content_words, reported
from fuzzytime.language.about_wishes import (
    About,
    AboutKind,
    about_things,
    about_wishes,
    added_time,
    by_how_much,
    lets_be,
    respelled,
)
from fuzzytime.language.sentence.trees.model import is_verb
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.commands import looking
from fuzzytime_cli.repl.commands.by_name import how_to
from fuzzytime_cli.repl.naming import (
    LABEL,
    entry_of,
    is_named_itself,
    is_of_one_task,
    label_meant,
    may_be_told_of,
    unknown,
)
from fuzzytime_cli.repl.plain_words.between_planned import wish_between_planned
from fuzzytime_cli.repl.plain_words.happened import happened
from fuzzytime_cli.repl.plain_words.has_done import done, perhaps_done
from fuzzytime_cli.repl.plain_words.leaning import leaning
from fuzzytime_cli.repl.plain_words.leaving_out import left_out, left_out_then, next_left_out
from fuzzytime_cli.repl.plain_words.meant import command_meant
from fuzzytime_cli.repl.plain_words.offered import beside_what_is_meant, declines, offer_taken, takes_offer
from fuzzytime_cli.repl.plain_words.perhaps import cancelled_elsewhere, check_who
from fuzzytime_cli.repl.plain_words.progress import running_for
from fuzzytime_cli.repl.plain_words.reasons import behind_what_tells, with_reason
from fuzzytime_cli.repl.plain_words.redirected import by_another_length, the_other
from fuzzytime_cli.repl.plain_words.retiming import wished_instead
from fuzzytime_cli.repl.plain_words.said_again import again_later, said_anew, timed_now
from fuzzytime_cli.repl.plain_words.shifting import check_order, each_on_a_day, of_several_on_a_day
from fuzzytime_cli.repl.plain_words.supposing import supposed
from fuzzytime_cli.repl.plain_words.taking import run, run_each
from fuzzytime_cli.repl.plain_words.telling import (
    behind_a_fact,
    behind_how_a_day_is,
    is_news,
    told_anew,
    told_reading,
    told_state,
    told_to_have_happened,
)
from fuzzytime_cli.repl.plain_words.usually_said import asks_how_it_is
from fuzzytime_cli.repl.questions import answering, ends, gaps, leeways, rooms
from fuzzytime_cli.repl.scene import Reply, Scene, refused
from fuzzytime_cli.repl.which import which_one
from fuzzytime_cli.told_states import tells_what_is, told_of_whom

OF_ITSELF = frozenset({AboutKind.DROP, AboutKind.MOVE, AboutKind.EXCEPT})
"""What is told of a thing, and is of no wish that only has to do with it: "lunch is off", of buying lunch."""

BE = "be"
"""The verb of what is only told."""

ASKED_BACK = {
    AboutKind.WRONG: "what is meant instead? Say: no, at six (or: undo that)",
    AboutKind.UNABLE: "when then? Say: push it back by half an hour (or: make it six; forget it)",
}
"""What is answered to a protest."""


def reply_about(scene: Scene, words: str) -> Reply | None:
    """Answer what is said about wishes that were said before; None where the words are a wish themselves.

    Raises
    ------
    FuzzytimeError
        If nothing that is known can be meant, or which of several is not said.
    """
    reply = _reply_about(scene, words)
    if reply is not None:
        return reply
    anew = respelled(words, scene.now, scene.lexicon, is_verb)
    reply = None if anew is None else _reply_about(scene, anew)
    if reply is None or reply.anew:
        return cancelled_elsewhere(scene, words)
    return replace(reply, lines=(Text(plain(f"read as: {anew}")), *reply.lines))


def _reply_about(scene: Scene, words: str) -> Reply | None:
    asked = scene.asked
    if asked is not None and (
        answer := by_how_much(words, asked, scene.now, scene.lexicon) or which_one(scene, words, asked)
    ):
        return _taken(scene, answer)
    let_be = lets_be(words, scene.now, scene.lexicon)
    if (asked is not None and let_be) or (scene.offer is not None and (let_be or declines(scene, words))):
        return Reply(("nothing is changed",))
    asks = asks_how_it_is(scene, words)
    if scene.offer is not None and scene.offer.line and takes_offer(scene, words):
        # "What if I push it back?", and then "ok, do that"
        return run(scene, About(kind=AboutKind.MOVE), scene.offer.line)
    wish = offer_taken(scene, words) or beside_what_is_meant(scene, words)
    wish = wish or (None if asks else wish_between_planned(scene, words) or again_later(scene, words))
    if wish is not None:
        return Reply((Text(plain(f"taken as: {wish}")),), anew=wish)
    if waited := happened(scene, words):
        reading = scene.language.read(words, now=scene.now)
        return told_reading(scene, words, reading) or run_each(scene, waited)
    instead = None if asks else wished_instead(scene, words)
    if instead is not None:
        return run(scene, About(kind=AboutKind.MOVE), instead)
    if (reply := with_reason(scene, words, _taken)) is not None:
        return reply
    about = about_wishes(words, scene.now, scene.lexicon) or behind_what_tells(scene, words)
    asked_back = about is not None and about.kind is AboutKind.DELAY and about.by is None and not about.text
    if asks and (about is None or about.kind not in ANSWERS):
        # "Is the gym cancelled?" cancels nothing.
        changing = None if about is None else refused(f"{words!r} asks, and nothing is changed")
        return answering.asked_of(scene, words) or gaps.then_of(scene, words) or changing
    if about is not None and about.told and (reply := told_anew(scene, about, words, _taken)) is not None:
        return reply
    if about is None or (not about.certain and not asked_back and is_news(scene, words)):
        check_who(scene, words)
        return (
            behind_how_a_day_is(scene, words, _taken)
            or behind_a_fact(scene, words, _reply_about)
            or _told(scene, words)
        )
    if about.kind in ANSWERS:
        return ANSWERS[about.kind](scene, about)
    return _taken(scene, about) or behind_a_fact(scene, words, _reply_about) or _told(scene, words)


def _told(scene: Scene, words: str) -> Reply | None:
    """Take what somebody tells to have done as done: "I've fed the cat"; None where nothing is told.

    Raises
    ------
    FuzzytimeError
        If nothing that is known was done.
    """
    language = scene.language
    reading = language.read(words, now=scene.now)
    # "I meant the cat" tells of nothing that was done.
    means = about_things(words, scene.now, language.lexicon)
    meant = means is not None and means.kind is AboutKind.INSTEAD
    operation = None if meant else reported(reading, language.lexicon)
    if operation is None:
        state = told_state(scene, words, reading) or told_to_have_happened(scene, words)
        if state is not None:
            return state
        if not meant and (reply := perhaps_done(scene, reading, _taken)) is not None:
            return reply
        if tells_what_is(reading, language.lexicon) and not is_news(scene, words):
            raise FuzzytimeError(f"{words!r} tells what is, and says nothing to do: say what you want done")
        if means is None or not (means.certain and means.names):
            _check_labels(scene, reading)
        # "Dinner at six" is a wish, and no time of another.
        wish = any(one.operation is not None for one in reading.instructions)
        added = added_time(words, scene.now, language.lexicon, wish=wish)
        if added is not None:
            return _taken(scene, added)
        anew = said_anew(scene, words) or timed_now(scene, words, reading)
        if anew is not None:
            return run(scene, About(kind=AboutKind.MOVE), anew)
        leant = leaning(scene, words, reading, _taken)
        if leant is None:
            check_order(scene, words)
            _check_told(scene, words, reading)
        # What asks for something is no question: "could you feed the cat?"
        if leant is not None or wish:
            return leant
        return answering.asked_of(scene, words) or gaps.then_of(scene, words)
    reply = done(scene, operation, _taken)
    if reply is None:
        raise FuzzytimeError(
            f"{words!r} tells what was done, and nothing like it is planned (:list shows what is)"
        )
    return reply


def _check_labels(scene: Scene, reading: Reading) -> None:
    """Refuse to make a wish of what names another by its label: "start s2", "s2 at eight".

    Raises
    ------
    FuzzytimeError
        If something is to be done with a label, or begins with one.
    """
    labels = {entry.identifier for entry in scene.conversation.state.entries}
    objects = (one.operation.object for one in reading.instructions if one.operation is not None)
    for said in (reading.text.partition(" ")[0], *objects):
        if said is not None and "." in said and LABEL.fullmatch(said) is not None:
            labels.add(label_meant(scene, frozenset({said})) or unknown(frozenset({said})))
        if said in labels:
            raise FuzzytimeError(
                f"{said} was asked for already, and this is not understood of it; say: move {said} to six, "
                f"push {said} back by ten minutes, drop {said}, {said} is done, why {said}"
            )


def _check_told(scene: Scene, words: str, reading: Reading) -> None:
    """Refuse to plan what only tells how something is that is planned: "the dog is a bit much today".

    Raises
    ------
    FuzzytimeError
        If it does.
    """
    operations = [one.operation for one in reading.instructions]
    if (who := told_of_whom(reading, scene.lexicon)) and not is_news(scene, words):
        if any(entry_of(scene, frozenset({word})) for word in content_words(who)):
            raise FuzzytimeError(
                f"{words!r} says something of {who} that is not understood, and nothing is changed: "
                "say: move it to six, push it back by ten minutes, drop it"
            )
        raise FuzzytimeError(
            f"{words!r} tells something that nothing planned is about, and says nothing to do"
        )
    told = all(one is not None and one.stated and one.lemma == BE for one in operations)
    if not told or len(operations) != 1 or is_news(scene, words):
        return
    if may_be_told_of(scene, content_words(operations[0].object if operations[0] is not None else None)):
        raise FuzzytimeError(
            f"{words!r} tells how something is that is planned, and what to do then is not understood: "
            "say: move it to six, push it back by ten minutes, drop it"
        )


def _taken(scene: Scene, about: About) -> Reply | None:
    """Run the command that is meant; None where the words may be a wish of their own."""
    if about.kind is AboutKind.UNABLE and about.names:
        return _when_then(scene, about)
    if about.kind in ASKED_BACK:
        raise FuzzytimeError(ASKED_BACK[about.kind])
    of_task = about.kind is AboutKind.MOVE and is_of_one_task(scene, about.names)
    if about.told and about.kind in OF_ITSELF and not (of_task or is_named_itself(scene, about.names)):
        return None
    if about.kind is AboutKind.BLOCK and about.text:
        return Reply((Text(plain(f"taken as: {about.text}")),), anew=about.text)
    if about.kind is AboutKind.OTHER:
        return the_other(scene, about, _taken)
    if about.kind is AboutKind.EXCEPT:
        return left_out(scene, about, _taken)
    if about.kind is AboutKind.DROP and about.upcoming and (out := next_left_out(scene, about)) is not None:
        return out
    if (moved := _retimed(scene, about)) is not None:
        return moved
    if about.kind is AboutKind.TAKES:
        about = replace(about, kind=AboutKind.MOVE)
    line = command_meant(scene, about)
    if line is None:
        return None
    return run(scene, about, line)


def _retimed(scene: Scene, about: About) -> Reply | None:
    """Take another time, or length, of what was left out, of all, or of what is running; else give None."""
    if (moved := left_out_then(scene, about)) is not None:
        return moved
    if about.kind is AboutKind.MOVE and (again := by_another_length(scene, about, _taken)) is not None:
        return again
    if about.kind is AboutKind.MOVE and (
        about.text if about.everything else of_several_on_a_day(scene, about)
    ):
        return each_on_a_day(scene, about)
    lasting = running_for(scene, about)
    return None if lasting is None else run(scene, about, lasting)


def _when_then(scene: Scene, about: About) -> Reply | None:
    """Ask when something is to be that cannot be: "Jo can't make it"; None where nothing is about that."""
    known = not about.told or is_named_itself(scene, about.names)
    entry = entry_of(scene, about.names) if known else None
    return None if entry is None else Reply((ASKED_BACK[about.kind],), focus=entry.number)


ANSWERS: Mapping[AboutKind, Callable[[Scene, About], Reply]] = {
    AboutKind.NEXT: answering.coming,
    AboutKind.ANSWER: answering.coming,
    AboutKind.ALL: lambda scene, _: looking.show_list(scene, ""),
    AboutKind.CLOCK: lambda scene, _: looking.now(scene, ""),
    AboutKind.WHEN: answering.when,
    AboutKind.LASTING: answering.lasting,
    AboutKind.WHY: answering.why,
    AboutKind.DID: answering.did,
    AboutKind.BESIDE: answering.beside,
    AboutKind.FREE: gaps.free,
    AboutKind.ROOM: rooms.room,
    AboutKind.APART: rooms.apart,
    AboutKind.LEEWAY: leeways.how_far,
    AboutKind.DURING: gaps.during,
    AboutKind.ON_TIME: ends.on_time,
    AboutKind.SUPPOSE: lambda scene, about: supposed(scene, about.text, _reply_about),
    AboutKind.HOW: lambda scene, about: how_to(scene, about.text),
}
"""What answers each kind of question."""
