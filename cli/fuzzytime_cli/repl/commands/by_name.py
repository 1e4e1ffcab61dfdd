"""The commands of the conversation by name: what each takes, what it does, and the function that does it."""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import Lexicon
from fuzzytime_cli.render import wrapped
from fuzzytime_cli.repl.commands import anew, changing, looking, moving, saving
from fuzzytime_cli.repl.commands.rating import rate
from fuzzytime_cli.repl.scene import Reply, Scene
from fuzzytime_cli.session import State

Run = Callable[[Scene, str], Reply]


@dataclass(frozen=True, slots=True)
class Command:
    """A command: what it takes, what it does in a sentence, and the function."""

    usage: str
    help: str
    run: Run

    @property
    def takes_words(self) -> bool:
        """Whether something may follow its name."""
        return " " in self.usage


HEAD = (
    "Type what you want done and when: flip the pancakes in about two minutes.",
    (
        "Speak of it as you like: no, make it six; push the call back by ten minutes; swap the two; done; "
        "five more minutes; I'm ten minutes late; cancel the call; what's next?; why?; undo."
    ),
    "Or give a command; N is a number of the list, or for :why, :done and :drop words: :why the call.",
)
"""What the commands' list begins with."""

DID = "If you did that:"
"""What stands above what would come of something."""

NARROW = 60
"""Columns below which what a command does stands under it, not beside it."""


def _help(scene: Scene, text: str) -> Reply:
    """Show what a command does, or all of them, and what else can be typed."""
    rows: list[str] = []
    asked = [_named(name.lower().removeprefix(":")) for name in text.split()]
    if not asked:
        rows += [*(line for sentence in HEAD for line in wrapped(sentence, scene.width, 0)), ""]
    for command in asked or COMMANDS.values():
        beginning = f"  :{command.usage:<26} "
        if scene.width < NARROW:
            rows += [f"  :{command.usage}", *wrapped(f"      {command.help}", scene.width, 6)]
        else:
            rows += wrapped(beginning + command.help, scene.width, len(beginning))
    return Reply(tuple(rows))


def how_to(scene: Scene, kind: str) -> Reply:
    """Show how something is said of what was asked for, and the command for it."""
    name = SAID_AS.get(kind, kind)
    rows = [line for sentence in HEAD[1:2] for line in wrapped(sentence, scene.width, 0)]
    return Reply((*rows, *(_help(scene, name).lines if name in COMMANDS else ())))


def _quit(_: Scene, __: str) -> Reply:
    return Reply(over=True)


def what_if(scene: Scene, text: str) -> Reply:
    """Show what would move if one asked for something too, or gave a command; nothing is changed.

    Raises
    ------
    FuzzytimeError
        If nothing is said, or a command that does not work or changes nothing that is asked for.
    """
    words = text.strip()
    if not words:
        raise FuzzytimeError(
            "an instruction or a command must follow, such as: :what-if call mum at noon; :what-if :drop 2"
        )
    if words[0] in ":/":
        return looking.what_would_move(scene, DID, _tried(scene, words))
    asked = scene.conversation.state.with_entry(words, scene.now)
    return looking.what_would_move(scene, "If you asked for that:", asked)


def _tried(scene: Scene, words: str) -> State:
    """Give the state that a command would lead to."""
    command, rest = command_of(words)
    if command not in TRIED:
        known = ", ".join(f":{one.usage.split()[0]}" for one in TRIED)
        raise FuzzytimeError(f"what can be tried is one of {known}, got {words!r}")
    tried: list[State] = []
    command.run(replace(scene, tried=tried), rest)
    if not tried:
        raise FuzzytimeError(f"{words!r} would change nothing: say what, such as :what-if :drop 2")
    return tried[-1]


COMMANDS: Mapping[str, Command] = {
    "list": Command("list", "the schedule, and what you asked for", looking.show_list),
    "why": Command("why N", "explain skill N: words, rules, satisfaction, and why then", looking.why),
    "what-if": Command("what-if TEXT", "what would move if you asked for that, or gave a :command", what_if),
    "edit": Command("edit N [TEXT]", "say instruction N anew", anew.edit),
    "drop": Command("drop N|N,M|all", "forget instruction N, several, or all", changing.drop),
    "delay": Command(
        "delay N|N,M|all 10min", "move N, or all that is left, to later (-10min: earlier)", moving.delay
    ),
    "swap": Command("swap N M", "give N and M each other's times", moving.swap),
    "done": Command("done N", "skill N is done", changing.done),
    "more": Command(
        "more N 5min", "skill N, which has started, goes on for longer (-5min: less long)", changing.more
    ),
    "undo": Command("undo", "take the last step back", changing.undo),
    "redo": Command("redo", "take an undone step again", changing.redo),
    "duration": Command("duration N 4min", "how long instruction N takes", changing.duration),
    "priority": Command("priority N 2", "how much instruction N counts", changing.priority),
    "ctx": Command("ctx [pan_temp=180]", "a reading now; alone: the readings", changing.ctx),
    "busy": Command("busy 12:00 13:00 lunch", "a time that is taken", changing.busy),
    "agents": Command("agents 2", "how many can work at once", changing.agents),
    "in-order": Command("in-order on|off", "whether each is done after the one before", changing.in_order),
    "solver": Command("solver NAME", "the method that finds the schedule", changing.solver),
    "rate": Command("rate [N 1-5|too late]", "how a start was, for later plans; alone: your ratings", rate),
    "plot": Command(
        "plot N [FILE.svg]", "draw the satisfaction of skill N; FILE.svg alone: the plan", looking.plot
    ),
    "save": Command("save FILE", ".json the session; .ics .csv .html .svg .jsonl the plan", saving.save),
    "load": Command("load FILE", "a saved session, a calendar, or instructions a line", saving.load),
    "now": Command("now", "the moment", looking.now),
    "help": Command("help [COMMAND]", "this list, or one command of it", _help),
    "quit": Command("quit", "leave, as Ctrl-D does", _quit),
}
"""Every command by its name."""


TRIED = tuple(
    COMMANDS[name]
    for name in (
        "edit",
        "drop",
        "delay",
        "swap",
        "duration",
        "priority",
        "ctx",
        "busy",
        "agents",
        "in-order",
        "solver",
    )
)
"""What may be asked about beforehand: commands that change what is asked for, or what is so."""

NUMBERED = re.compile(r"s\d+(\.\d+)?", re.IGNORECASE)
"""How a skill of the plan is called where no word stands for it: "s1", "s2.1"."""

SAID_AS = {"move": "edit", "takes": "duration", "late": "busy", "stop": "done", "except": "edit"}
"""The commands for what is said of wishes, where they are called otherwise."""

FILED = ("save", "load")
"""Commands that need no colon in front of the name of a file."""

NEVER_WISHED = ("agents", "busy", "ctx", "duration", "edit", "in-order", "plot", "priority", "save", "solver")
"""Commands whose names alone are no wish: what must follow them is said."""

ALSO_CALLED = {"explain": "why", "export": "save"}
"""Commands by other names that people type."""

BARE = {
    "asking for help": ":help",
    "asking for the list": ":list",
    "asking to clear": ":help drop",
    "quitting": ":quit",
}
"""What people mean by words that they type to a prompt, by the tables of these words."""


def without_colon(words: str, lexicon: Lexicon) -> str:
    """Give the command that is meant by words that need no colon ("help", "plot s1"), else the words."""
    form = tuple(words.lower().rstrip("?").split())
    if not form:
        return ":help"
    name, rest = ALSO_CALLED.get(form[0], form[0]), words.split()[1:]
    if _is_command(name, rest):
        return " ".join([f":{name}", *rest])
    found = (line for table, line in BARE.items() if form in lexicon.conversation[table])
    return next(found, words)


def _is_command(name: str, rest: list[str]) -> bool:
    """Whether a command's name and what follows can be nothing else: "plot", "rate s1 4", "save it.ics"."""
    if not rest:
        return name in NEVER_WISHED
    if name in FILED:
        return len(rest) == 1 and bool(Path(rest[0]).suffix)
    return name in (*NEVER_WISHED, "rate", "why") and bool(NUMBERED.fullmatch(rest[0]))


def command_of(line: str) -> tuple[Command, str]:
    """Find the command of a line that starts with ``:`` or ``/``, and what follows it.

    An unambiguous beginning of a name will do; no name at all asks for help.

    Raises
    ------
    FuzzytimeError
        If there is no such command, or something follows where nothing may.
    """
    name, _, rest = line[1:].strip().partition(" ")
    command = _named(name.lower() or "help")
    if rest.strip() and not command.takes_words:
        raise FuzzytimeError(f"nothing may follow :{command.usage}, got {rest.strip()!r}")
    return command, rest


def _named(name: str) -> Command:
    from fuzzytime.spelling import suggestion

    matching = [key for key in COMMANDS if key.startswith(name)]
    if name in COMMANDS:
        return COMMANDS[name]
    if len(matching) == 1:
        return COMMANDS[matching[0]]
    raise FuzzytimeError(
        f"there is no command {name!r}{suggestion(name, matching or COMMANDS)}; :help lists them"
    )
