"""Instructions said anew, in other words: they keep their places, and what they still ask for its label."""

from collections.abc import Sequence
from dataclasses import replace

from rich.text import Text

from fuzzytime.interpreter import Interpretation, Interpreted, ProblemKind
from fuzzytime.times import seconds_between
from fuzzytime_cli.formats.series import AS_ASKED
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.scene import Reply, Scene, begun_of, begun_parts, ended_line, not_understood, step
from fuzzytime_cli.repl.typed import number_of
from fuzzytime_cli.repl.without import numbers_kept, only_left_out
from fuzzytime_cli.session import Started, State


def edit(scene: Scene, text: str) -> Reply:
    """Say an instruction anew; without words put it on the prompt."""
    first, _, rest = text.strip().partition(" ")
    number = number_of(first)
    if not rest.strip():
        return Reply(edit=f":edit {number} {scene.conversation.state.entry(number).text}")
    words = rest.strip()
    old = scene.conversation.state.entry(number)
    begun = begun_of(scene, number) or _left_out(scene, number, words)
    # What has started does not move: said anew it is another, and may start at another time.
    said_anew = State.with_changed if begun is None else State.with_another
    anew: dict[str, object] = {
        "text": words,
        "parts": () if begun is not None else numbers_kept(scene, old, words),
    }
    if not only_left_out(scene, old, words):
        anew |= {"given": scene.now, "moved_by": 0.0, "moved_to": None}
    state = scene.conversation.state
    # Who says the same once more, of what is running, has not begun: "I haven't started yet".
    if (
        begun is not None
        and words != old.text
        and _is_kept_by(scene, begun, state.with_another(number, **anew))
    ):
        reply = step(scene, f":edit {number}", lambda state: state.with_changed(number, **anew))
        return replace(reply, lines=(Text(f"{plain(begun.name)} goes on: it is in time"), *reply.lines))
    called = number if begun is None else state.next_number
    behind = _refers_to_what_came_between(scene, number, called, said_anew(state, number, **anew))

    def change(state: State) -> State:
        changed = said_anew(state, number, **anew)
        return changed.with_last(called) if behind else changed

    if refused := not_understood(scene, change(state), called):
        return Reply(refused)
    reply = step(scene, f":edit {number}", change)
    return reply if begun is None else replace(reply, lines=(*ended_line(scene, begun), *reply.lines))


def _is_kept_by(scene: Scene, begun: Started, state: State) -> bool:
    """Whether what is running is just what an instruction asks for whose words come last, and is in time.

    So is the printing of the poster, where "Ann needs it by three" is said while it goes on.
    """
    if begun.done <= scene.now:
        return False
    made = scene.conversation.understood(scene.now, state).everything
    own = [one for one in made if number_of(one.identifier) == state.next_number - 1]
    if len(own) != 1 or own[0].skill.name != begun.name:
        return False
    lasts = seconds_between(begun.start, begun.done)
    if abs(own[0].skill.time_until_done - lasts) >= 1.0:
        return False
    # "Soon" said while it goes on, as "now", is not later than it has begun.
    starts = (seconds_between(scene.now, begun.start), 0.0)
    return any(float(own[0].skill.satisfaction(start)) >= AS_ASKED for start in starts)


def _left_out(scene: Scene, number: int, words: str) -> Started | None:
    """Give what has started of an instruction whose new words ask for it no more; None where there is none.

    Of "dust the shelf, call Ann", where that is being dusted, "feed the cat" is another instruction.
    """
    conversation, begun = scene.conversation, begun_parts(scene, number)
    if not begun:
        return None
    given = [one.operation for one in scene.plan.everything]
    read = conversation.interpreter.language.read(words, now=scene.now, given=given)
    asked = {one.operation.name.lower() for one in read.instructions if one.operation is not None}
    return next((one for one in reversed(begun) if one.name.lower() not in asked), None)


def reworded(scene: Scene, number: int, text: str) -> Reply:
    """Give an instruction other words, of which those for its time count from when they were said."""
    if begun_of(scene, number) is not None:
        return edit(scene, f"{number} {text}")
    return step(scene, f":edit {number}", lambda state: state.with_changed(number, text=text))


def _refers_to_what_came_between(scene: Scene, number: int, called: int, here: State) -> bool:
    """Whether the words of an instruction that is said anew refer to others that were given since.

    "Stir the soup after that" does, where that is the instruction given last. Where it stands among the
    others, "that" would be another one, or none; but what was said behind it refers to it there.
    """
    conversation, now = scene.conversation, scene.now
    there = here.with_last(called)
    if there == here:
        return False
    in_place, last = (conversation.understood(now, state) for state in (here, there))
    followed = _followed(in_place.everything, called)
    if followed == _followed(last.everything, called):
        return False
    if followed and followed == _followed(scene.plan.everything, number):
        return False
    lost = _unresolved(last)
    return not lost or lost < _unresolved(in_place)


def _followed(skills: Sequence[Interpreted], number: int) -> list[str]:
    """Give what an instruction asks by its words to come after."""
    own = [one for one in skills if number_of(one.identifier) == number and not one.in_order]
    return [name for one in own for name in one.follows]


def _unresolved(interpretation: Interpretation) -> int:
    """Count the references that are to nothing."""
    return sum(problem.kind is ProblemKind.UNRESOLVED for problem in interpretation.problems)
