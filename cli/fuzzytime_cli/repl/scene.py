"""What commands of the conversation work with, and what they answer."""

from collections.abc import Callable
from dataclasses import dataclass
from datetime import datetime

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import IN_THE_PLAN, Interpreted, Plan, Problem, ProblemKind
from fuzzytime.language import Language, Lexicon, content_words
from fuzzytime.language.about_wishes import About
from fuzzytime.requirement import TimeRequirement
from fuzzytime_cli.clock import Clock
from fuzzytime_cli.faults import underlined
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.conversation import Conversation
from fuzzytime_cli.repl.typed import got, number_of
from fuzzytime_cli.session import Entry, Started, State

UNREAD = frozenset({ProblemKind.NOT_UNDERSTOOD, ProblemKind.UNREADABLE, ProblemKind.NOTHING_TO_DO})
"""What is wrong with words of which nothing can be planned."""

BE = "be"
"""The verb of what has only a name: "lunch at one"."""

FIRST = 1
"""The number of the first of several things that an instruction asks for."""


@dataclass(frozen=True, slots=True)
class Offer:
    """What an answer said that there is room for, or when ("a walk", "before the call"), or what it tried.

    Who takes it says no more than "pop that in", "have lunch then", or "ok, do that"; ``line`` is the command
    that was tried.
    """

    thing: str = ""
    time: str = ""
    line: str = ""


@dataclass(frozen=True, slots=True)
class Reply:
    """What a command answers: lines to show, and what happens next.

    ``changed`` asks for the schedule to be drawn again, ``edit`` puts words on the next prompt,
    ``over`` ends the conversation, ``focus`` is the instruction that was spoken of: what "it" is next.
    ``taken`` is what was understood of words that changed something, ``asked`` what is to be asked back
    about, ``offer`` what may be taken next, and ``anew`` an instruction that words which lean on another
    mean.
    """

    lines: tuple[Text | str, ...] = ()
    changed: bool = False
    edit: str = ""
    over: bool = False
    focus: int | None = None
    taken: About | None = None
    asked: About | None = None
    offer: Offer | None = None
    anew: str = ""


@dataclass(frozen=True, slots=True)
class Scene:
    """What a command works with: the conversation, the plan on the screen, the moment, the screen's width.

    Where ``tried`` is given, steps are not taken: what they would lead to is put there. ``focus`` is the
    instruction that was spoken of last, ``told_last`` the one that was told or changed last, ``taken`` what
    was understood of the words that changed something last, ``asked`` what the last answer asked about, and
    ``offer`` what it said that there is room for.
    """

    conversation: Conversation
    plan: Plan
    now: datetime
    width: int
    unicode: bool = True
    tried: list[State] | None = None
    focus: int | None = None
    told_last: int | None = None
    taken: About | None = None
    asked: About | None = None
    offer: Offer | None = None

    @property
    def language(self) -> Language:
        """What reads words."""
        return self.conversation.interpreter.language

    @property
    def lexicon(self) -> Lexicon:
        """The words of the language."""
        return self.language.lexicon


class AskedBackError(FuzzytimeError):
    """What is missing of what was said: the next line may say it."""

    def __init__(self, message: str, about: About) -> None:
        super().__init__(message)
        self.about = about


def said(text: str) -> Reply:
    """Answer with one line."""
    return Reply((Text(plain(text)),))


def refused(why: str) -> Reply:
    """Answer with what is wrong, and with nothing else."""
    return Reply((Text(plain(why), style="red"),))


def identifier_of(scene: Scene, text: str) -> str:
    """Give a skill's identifier, of which the number will do; what is neither stays as it is.

    Of an instruction without the first of its things it is that of the first that is left.
    """
    said = text.strip()
    wanted = f"s{said}" if said[:1].isdecimal() else said
    parts = next((one.parts for one in scene.conversation.state.entries if one.identifier == wanted), ())
    return wanted if not parts or FIRST in parts else f"{wanted}.{parts[0]}"


def position_of(scene: Scene, text: str) -> int:
    """Find a skill of the plan by its identifier, or by its instruction's number.

    Raises
    ------
    FuzzytimeError
        If there is none.
    """
    wanted = identifier_of(scene, text)
    for position, interpreted in enumerate(scene.plan.everything):
        if interpreted.identifier == wanted:
            return position
    for running in scene.conversation.running(scene.now):
        if running.identifier == wanted:
            until = Clock(scene.now, with_seconds=True).at(running.done)
            raise FuzzytimeError(
                f"{wanted} is running until {until}, and no longer planned (see: :done, :rate)"
            )
    known = ", ".join(interpreted.identifier for interpreted in scene.plan.everything) or "none yet"
    raise FuzzytimeError(f"a skill of the plan must follow ({known}){got(text)}")


def running_lines(conversation: Conversation, now: datetime) -> list[Text]:
    """Say what is going on, and until when."""
    clock = Clock(now, with_seconds=True)
    return [
        Text(f"running: {plain(one.identifier)} {plain(one.name)}, until {clock.at(one.done)}", style="bold")
        for one in conversation.running(now)
    ]


def begun_of(scene: Scene, number: int) -> Started | None:
    """Give the skill of an instruction that has started, the last if several have; None if one has not."""
    return None if waiting(scene, number) else next(reversed(begun_parts(scene, number)), None)


def begun_parts(scene: Scene, number: int) -> list[Started]:
    """Give what has started of an instruction, the latest last."""
    begun = scene.conversation.store.started(scene.conversation.name)
    return [one for one in begun if number_of(one.identifier) == number]


def waiting(scene: Scene, number: int | None = None) -> list[tuple[int, Interpreted]]:
    """Give the skills that have not started, with their places in the plan: an instruction's, or all."""
    begun = {one.identifier for one in scene.conversation.store.started(scene.conversation.name)}
    return [
        (place, one)
        for place, one in enumerate(scene.plan.everything)
        if one.identifier not in begun and (number is None or one.wish.identifier == f"s{number}")
    ]


def is_for_others(one: Interpreted) -> bool:
    """Whether it is for others to move: "the guests come at six", but not "lunch at one"."""
    return one.stated and one.operation is not None and one.operation.lemma != BE


def asked_by(scene: Scene, number: int) -> list[str]:
    """Name the several things that an instruction asks for, each once; only one where it is repeated."""
    begun = [one.name for one in begun_parts(scene, number)]
    planned = [one.skill.name for one in scene.plan.everything if one.wish.identifier == f"s{number}"]
    return list(dict.fromkeys([*begun, *planned]))


def check_sole(scene: Scene, number: int, length: str) -> None:
    """Refuse to say how long an instruction takes that asks for several things.

    Raises
    ------
    FuzzytimeError
        If it does.
    """
    several = asked_by(scene, number)
    if len(several) > 1:
        which = f"{', '.join(several[:-1])} or {several[-1]}"
        raise FuzzytimeError(f"which one takes so long: {which}? Say: {several[-1]} takes {length}")


def own_words(scene: Scene, entry: Entry) -> frozenset[str]:
    """Give the words of an entry, without those for other things that it is done beside: "before dinner"."""
    known = (one.reading for one in scene.plan.everything if one.wish.identifier == entry.identifier)
    # What is over is in no plan.
    reading = next((one for one in known if one is not None), None)
    read = (reading or scene.language.read(entry.text, now=entry.given)).instructions
    beside = (_words_beside(part, scene.lexicon) for one in read for part in one.requirements)
    named = (content_words(one.operation.name) for one in read if one.operation is not None)
    return content_words(entry.text) - (frozenset[str]().union(*beside) - frozenset[str]().union(*named))


def _words_beside(part: TimeRequirement, lexicon: Lexicon) -> frozenset[str]:
    """Give the words of a time that name something else: "dinner", which customs may tell the time of."""
    words = content_words(part.text)
    return words if part.anchor is not None or part.condition is not None else words & lexicon.events


def ended_line(scene: Scene, begun: Started) -> tuple[Text, ...]:
    """Say that what was running is not any more."""
    return (Text(f"no longer running: {plain(begun.name)}"),) if begun.done > scene.now else ()


def step(scene: Scene, what: str, change: Callable[[State], State]) -> Reply:
    """Take a step, after which the schedule is drawn again.

    Raises
    ------
    FuzzytimeError
        From the step, which then changes nothing.
    """
    if scene.tried is not None:
        scene.tried.append(change(scene.conversation.state))
        return Reply()
    scene.conversation.change(what, change)
    return Reply(changed=True)


def problem_lines(problem: Problem, width: int) -> list[Text | str]:
    """Give a problem as lines, with the words underlined; what is drawn with the plan is not said again."""
    if problem.kind in IN_THE_PLAN:
        return []
    lines: list[Text | str] = [Text(plain(problem.message), style="red")]
    if problem.span is not None and problem.text:
        lines += underlined(problem.text, problem.span, width).split("\n")
    return lines


def not_understood(scene: Scene, state: State, number: int) -> tuple[Text | str, ...]:
    """Say why an instruction's new words ask for nothing that can be: that changes nothing."""
    entry = state.entry(number)
    made = scene.conversation.understood(scene.now, state)
    own = [one for one in made.everything if one.wish.identifier == entry.identifier]
    faults = [one for one in made.problems if one.text == entry.text and one.kind in UNREAD]
    before = [one for one in scene.plan.everything if one.wish.identifier == entry.identifier]
    lost = not own or len(own) < len(before)
    lines = [line for one in faults for line in problem_lines(one, scene.width)] if lost else []
    known = {(one.skill.name, one.reason) for one in scene.plan.everything}
    lines += [
        Text(plain(f"{one.skill.name}: {one.reason}"), style="red")
        for one in own
        if one.reason and not one.waits and (one.skill.name, one.reason) not in known
    ]
    return (*lines, Text("nothing is changed")) if lines else ()
