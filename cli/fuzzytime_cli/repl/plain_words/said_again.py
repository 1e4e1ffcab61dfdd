"""What is said again, with another time: "no, feed the dog at seven", "trim the hedge at four"."""

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import Operation, Reading, content_words
from fuzzytime.language.about_wishes import About, AboutKind, Said, later_by, restated, reworded
from fuzzytime.requirement import Constraint
from fuzzytime.times import instant_after
from fuzzytime_cli.repl.conversation import exactly
from fuzzytime_cli.repl.naming import entry_of, starts_of_entry
from fuzzytime_cli.repl.parts import with_time_of_part
from fuzzytime_cli.repl.plain_words.retiming import FOR, with_time
from fuzzytime_cli.repl.scene import Scene, begun_parts, waiting
from fuzzytime_cli.repl.typed import number_of
from fuzzytime_cli.session import Entry


def said_anew(scene: Scene, words: str) -> str | None:
    """Give the command that says an instruction anew: "no, feed the dog at seven"; None where none is meant.

    Raises
    ------
    FuzzytimeError
        If the instruction asks for more than that.
    """
    anew = restated(words, scene.now, scene.lexicon)
    return None if anew is None else same_anew(scene, anew)


def same_anew(scene: Scene, anew: str) -> str | None:
    """Give the command that words anew the instruction that asks for the same; None where none does.

    Raises
    ------
    FuzzytimeError
        If the instruction asks for more than that.
    """
    reading = scene.language.read(anew, now=scene.now, given=[one.operation for one in scene.plan.everything])
    if len(reading.instructions) != 1:
        return None
    operation, times = reading.instructions[0].operation, reading.instructions[0].requirements
    if operation is None or not times:
        return None
    read = [one for one in scene.plan.everything if one.reading]
    same = [one for one in read if _is_same(one.operation, operation)]
    if not same:
        # "No, call at seven", where somebody is to be called; "no, feed the dog at seven in the kitchen"
        things, only = content_words(operation.object), content_words(operation.verb)
        intransitive = operation.lemma in scene.lexicon.needing_nothing
        known = [one for one in read if one.operation and one.operation.lemma == operation.lemma]
        bare = content_words(operation.name) <= only and len(known) == 1 and not intransitive
        same = [
            one
            for one in known
            if bare or (things and content_words(one.operation and one.operation.object) == things)
        ]
    same.sort(key=lambda one: number_of(one.identifier) == scene.focus)
    if not same:
        return None
    old, number = same[-1], number_of(same[-1].identifier)
    several = old.reading is not None and len(old.reading.instructions) > 1
    own = old.instruction.requirements if old.instruction is not None else ()
    named = (operation.object or "").lower() in anew.lower() and bool(content_words(operation.object))
    before = frozenset[str]() if old.operation is None else content_words(old.operation.name)
    whole = len(times) > 1 or times[0].constraint is Constraint.EVERY
    says_more = whole or not content_words(operation.name) <= before
    if several or not named or len(own) > len(times) or not says_more:
        # The rest of its words stays, and where it stands "them" is nothing: "no, put them out at seven".
        moved = About(kind=AboutKind.MOVE, time=times[0].text)
        anew = with_time(scene, scene.conversation.state.entry(number), moved, own)
    return f":edit {number} {anew}"


def again_later(scene: Scene, words: str) -> str | None:
    """Give a wish for what was asked for again, some time behind that: "and again an hour later"; else None.

    Raises
    ------
    FuzzytimeError
        If what was asked for has no time that it counts from.
    """
    said = Said.of(words, scene.now, scene.lexicon)
    for place in range(len(said.words)):
        taken = said.behind(place).opens_with("again")
        by = _length_behind(said.behind(place + taken)) if taken else None
        if by is None:
            continue
        front = said.until(place)
        front = front.behind(front.opens_with("continuing"))
        entry = entry_of(scene, frozenset()) if not front.words else asked_alike(scene, front.text)
        if entry is None:
            return None
        begun = [one.start for one in begun_parts(scene, entry.number)]
        starts = [*begun, *starts_of_entry(scene, entry)]
        if not starts:
            raise FuzzytimeError(f"{entry.text!r} has no time yet: say when it is to be done again")
        time = exactly(instant_after(max(starts), by))
        reading = scene.language.read(entry.text, now=entry.given)
        return reworded(reading, scene.lexicon, time=time, now=scene.now)
    return None


def _length_behind(said: Said) -> float | None:
    """Give how much later words say that something is: "an hour later", "two hours after that"; else None."""
    later = later_by(said) if said.words else None
    if later is not None:
        return later[0].by if later[0].by is not None and later[0].by > 0 and not later[1].words else None
    for place in range(1, len(said.words)):
        beside, length = said.behind(place).beside(), said.until(place).length()
        if beside is not None and beside[1].is_in("last") and length is not None and not length.rest.words:
            return length.seconds
    return None


def asked_alike(scene: Scene, words: str) -> Entry | None:
    """Give the entry that asks for the same as some words; None where none does, or these ask for more."""
    read = scene.language.read(words, now=scene.now).instructions
    operation = read[0].operation if len(read) == 1 else None
    if operation is None or read[0].requirements:
        return None
    same = [one for one in scene.plan.everything if _is_same(one.operation, operation)]
    numbers = {number_of(one.identifier) for one in same}
    entries = scene.conversation.state.entries
    return next((entry for entry in reversed(entries) if entry.number in numbers), None)


def timed_now(scene: Scene, words: str, reading: Reading) -> str | None:
    """Give the command that gives its time to what was asked for without one; None where nothing was.

    Who asks to "trim the hedge", and then to "trim the hedge at four", means one and the same.
    """
    forms = scene.lexicon.conversation["closing"] | scene.lexicon.conversation["again"]
    more = {form[0] for form in forms if len(form) == 1}
    if len(reading.instructions) != 1 or not more.isdisjoint(words.lower().split()):
        return None
    operation, times = reading.instructions[0].operation, reading.instructions[0].requirements
    if operation is None or not operation.object or not times:
        return None
    same = [one for _, one in waiting(scene) if _is_same(one.operation, operation)]
    lasts = times[0].constraint is Constraint.FOR
    own = same[0].instruction if len(same) == 1 else None
    if own is not None and not any(
        not lasts or part.constraint is Constraint.FOR for part in own.requirements
    ):
        number, time = number_of(same[0].identifier), " ".join(part.text for part in times)
        # "Mow the lawn takes an hour"
        time = time if not lasts or time.startswith(FOR) else f"{FOR}{time}"
        entry = scene.conversation.state.entry(number)
        return f":edit {number} {with_time_of_part(scene, entry, time, same[0].identifier)}"
    # What may be done at any time is taken to have begun at once.
    begun = {
        number_of(one.identifier) for one in scene.conversation.running(scene.now) if one.end > scene.now
    }
    for entry in (entry for entry in scene.conversation.state.entries if entry.number in begun):
        read = scene.language.read(entry.text, now=entry.given).instructions
        untimed = len(read) == 1 and not read[0].requirements
        if not same and untimed and _is_same(read[0].operation, operation):
            return f":edit {entry.number} {words}"
    return None


def _is_same(one: Operation | None, other: Operation) -> bool:
    """Whether two operations do the same with the same, in one place as far as the second tells."""
    if one is None or (one.lemma, one.negated) != (other.lemma, other.negated):
        return False
    places = content_words(other.place) in (frozenset(), content_words(one.place))
    things = content_words(other.object)
    # "No, call her at seven"
    return places and (things == content_words(one.object) or (bool(other.object) and not things))
