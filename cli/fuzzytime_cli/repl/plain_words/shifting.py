"""What is planned said with its verb, to be later, earlier, begun, or not: "feed it an hour earlier"."""

from dataclasses import replace

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import verb_forms
from fuzzytime.language.about_wishes import (
    About,
    AboutKind,
    Said,
    about_wishes,
    bare,
    later_by,
    without_request,
)
from fuzzytime.requirement import Constraint, Unit
from fuzzytime.times import seconds_between
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.naming import entry_of, is_named_itself, part_meant, starts_of_entry
from fuzzytime_cli.repl.plain_words.known import is_known
from fuzzytime_cli.repl.plain_words.of_all import entries_of_all
from fuzzytime_cli.repl.plain_words.retiming import with_time
from fuzzytime_cli.repl.plain_words.said_again import asked_alike
from fuzzytime_cli.repl.questions.stretches import CLOCKED
from fuzzytime_cli.repl.scene import Reply, Scene, is_for_others, step, waiting
from fuzzytime_cli.repl.typed import number_of
from fuzzytime_cli.repl.which import entries_meant
from fuzzytime_cli.session import Entry, State

MINUTE = 60.0


def shift_said(scene: Scene, clause: str) -> str | None:
    """Give the usual words for what is to be later, earlier, or begun at a time; None where nothing is.

    Of "could I feed the cat a bit later?" that is "push s1 back a bit". What is not planned is a wish.
    """
    said = Said.of(clause, scene.now, scene.lexicon)
    if not any(form.isalnum() for form in said.forms):
        return None
    asked = bare(without_request(said))
    for one in (asked, said.behind(said.opens_with("may do"))):
        begun = None if about_wishes(one.text, scene.now, scene.lexicon) is not None else _begun(scene, one)
        usual = _later(scene, one) or begun or _not_done(scene, one)
        if usual is not None:
            return usual
    return None


def _later(scene: Scene, said: Said) -> str | None:
    """Read a verb, what it is done with, and how much later or earlier that is to be."""
    said = said.without_end(said.table("instead")) if said.words else said
    for place in range(1, len(said.words)):
        front, behind = said.until(place), said.behind(place)
        undirected, directions = behind.without("later", "earlier")
        found = later_by(behind)
        if (
            not directions
            or front.ends_with("again")
            or (undirected.words and (found is None or found[1].words))
        ):
            continue
        label = _meant(scene, front)
        if label is None:
            continue
        about = About(kind=AboutKind.DELAY, earlier="earlier" in directions) if found is None else found[0]
        earlier = about.earlier or (about.by or 0.0) < 0.0
        length = behind.without("later", "earlier")[0].text
        if about.by is None:
            return f"move {label} {length} {'earlier' if earlier else 'later'}".replace("  ", " ")
        return f"{'bring' if earlier else 'push'} {label} {'forward' if earlier else 'back'} by {length}"
    return None


def _meant(scene: Scene, said: Said) -> str | None:
    """Give the label of what a verb and a thing are of, as it was asked for, or whatever is done with it."""
    thing = said.behind(1)
    of_it = thing.is_in("last") or (thing.words and set(thing.forms) <= scene.lexicon.closed.all_anaphors)
    if of_it:
        return _done_so(scene, said.forms[0])
    entry, names = asked_alike(scene, said.text), said.names
    if entry is None and thing.words and said.forms[0] in _verbs(scene):
        known = is_known(scene, thing, told=False)
        entry, names = entry_of(scene, thing.meant) if known else None, thing.meant
    return _label(scene, entry, names)


def _label(scene: Scene, entry: Entry | None, names: frozenset[str]) -> str | None:
    """Give the label of what is left to do of an entry, or of the one of its things that is named."""
    if entry is None or not waiting(scene, entry.number):
        return None
    return part_meant(scene, entry.number, names) or entry.identifier


def _not_done(scene: Scene, said: Said) -> str | None:
    """Read what is planned, and is not to be done after all: "don't call the bank"."""
    rest = said.after("not doing")
    if rest is None:
        return None
    for place in range(1, len(rest.words) + 1):
        label, behind = _meant(scene, rest.until(place)), rest.behind(place)
        if label is None:
            continue
        time = behind.one_time()
        if time is not None and time.constraint is Constraint.BEFORE:
            # "Don't call the bank before noon"
            return f"move {label} to not {behind.text}"
        if not behind.words:
            return f"cancel {label}"
    return None


def _done_so(scene: Scene, verb: str) -> str | None:
    """Give the label of the last that is done with a verb: "feed it", whatever was spoken of since."""
    labels = [
        one.identifier
        for _, one in waiting(scene)
        if one.operation is not None and verb in verb_forms(one.operation.lemma, scene.lexicon)
    ]
    spoken_of = [label for label in labels if number_of(label) == scene.focus]
    return max(spoken_of or labels, key=number_of, default=None)


def _begun(scene: Scene, said: Said) -> str | None:
    """Read when something planned is to begin: "start the film at half eight", which was to be at eight."""
    if not said.words or said.forms[0] not in _verbs(scene):
        return None
    asked = said.without_end(said.table("instead"))
    for place in (n for n in range(2, len(asked.words)) if not asked.words[n].glued):
        thing, time = asked.until(place).behind(1), asked.behind(place).as_time()
        named = bool(thing.words) and not thing.is_in("last") and is_known(scene, thing, told=False)
        if not time or time.lower().startswith("for ") or not named:
            continue
        # "Start the fence at eleven, then"
        itself = asked != said or bool(thing.label) or is_named_itself(scene, thing.names)
        label = _label(scene, entry_of(scene, thing.meant), thing.meant) if itself else None
        return None if label is None else f"move {label} to {time.removeprefix('at ')}"
    return None


def _verbs(scene: Scene) -> frozenset[str]:
    """Give the verbs with which whatever is planned is done: "start the essays", "do the shed"."""
    doing = scene.lexicon.doing
    making = frozenset(form[0] for form in scene.lexicon.conversation["done with"])
    verbs = doing.beginning | doing.spending | making
    return frozenset[str]().union(*(verb_forms(verb, scene.lexicon) for verb in verbs))


def check_order(scene: Scene, words: str) -> None:
    """Refuse to make a wish of an order about what is planned: "move the call around a bit".

    Raises
    ------
    FuzzytimeError
        If it is one.
    """
    whole = Said.of(words, scene.now, scene.lexicon)
    said = bare(without_request(whole)) if whole.words else whole
    if not said.words or said.forms[0] not in scene.lexicon.moving or said.has_time:
        return
    for place in range(len(said.words), 1, -1):
        thing = said.until(place).behind(1)
        known = bool(thing.words) and is_known(scene, thing, told=False)
        if known and is_named_itself(scene, thing.names):
            raise FuzzytimeError(
                f"{words!r} is not understood of {thing.text}, and nothing is changed: "
                "say: move it to six, push it back by ten minutes"
            )


def behind_its_other(scene: Scene, entry: Entry, by: float) -> str | None:
    """Give an entry's words, later behind what it follows: "half an hour after lunch"; None for nothing.

    Raises
    ------
    FuzzytimeError
        If it would start before that is over.
    """
    mine = waiting(scene, entry.number)
    parts = [part for _, one in mine for part in one.requirements if part.anchor is not None]
    starts = starts_of_entry(scene, entry)
    if len(mine) != 1 or len(parts) != 1 or len(starts) != 1 or parts[0].constraint is not Constraint.AFTER:
        return None
    (place, one), (part,) = mine[0], parts
    firsts = [entry.first for entry in scene.plan.schedule.task.precedences if entry.second == place]
    firsts += [n for n, other in enumerate(scene.plan.skills) if other.identifier in one.tied_to]
    if len(firsts) != 1 or not scene.plan.has_time(firsts[0]) or part.anchor is None:
        return None
    over = scene.plan.instant(scene.plan.schedule.skills[firsts[0]].done)
    lag = round((seconds_between(over, starts[0]) + by) / MINUTE)
    first = scene.plan.skills[firsts[0]].skill.name
    if lag < 0:
        raise FuzzytimeError(f"{one.skill.name} is to come after {first}, and cannot be earlier than that")
    # Of "ten minutes after you call mum", and "when the lawn is mown", that
    time = f"{lag} {Unit.MINUTE}s after {part.anchor.text}"
    own = one.instruction.requirements if one.instruction is not None else ()
    return with_time(scene, entry, About(kind=AboutKind.MOVE, time=time), own) if lag else None


def each_on_a_day(scene: Scene, about: About) -> Reply:
    """Move all that are meant to another day, each at its hour, in one step.

    Raises
    ------
    FuzzytimeError
        If nothing is meant, or its words have no place for a day.
    """
    several = entries_of_all(scene, about) if about.everything else entries_meant(scene, about)
    meant = [
        entry
        for entry in several
        if (mine := waiting(scene, entry.number)) and not any(is_for_others(one) for _, one in mine)
    ]
    day = About(kind=AboutKind.MOVE, time=about.text if about.everything else about.time)
    texts = {entry.number: with_time(scene, entry, day) for entry in meant if _is_timed(scene, entry)}
    if not texts:
        raise FuzzytimeError("nothing else is left that could be moved")

    def change(state: State) -> State:
        for number, text in texts.items():
            state = state.with_changed(number, text=text, given=scene.now, moved_by=0.0, moved_to=None)
        return state

    reply = step(scene, f":edit {','.join(map(str, texts))}", change)
    heads = [Text(plain(f"taken as :edit {number} {text}")) for number, text in texts.items()]
    return replace(reply, lines=(*heads, Text(":undo takes it all back"), *reply.lines), taken=about)


def of_several_on_a_day(scene: Scene, about: About) -> bool:
    """Whether several that are listed are to be on another day: "move the call and the gym to friday"."""
    time = Said(about.time, scene.now, scene.lexicon).one_time() if about.each or about.both else None
    return time is not None and time.grain not in {None, *CLOCKED} and len(entries_meant(scene, about)) > 1


def _is_timed(scene: Scene, entry: Entry) -> bool:
    """Whether it does not only follow another, with which it moves along."""
    parts = [part for _, one in waiting(scene, entry.number) for part in one.requirements]
    return not parts or any(part.anchor is None or part.anchor.target is None for part in parts)
