"""What is said again, with another time: "no, feed the dog at seven", "trim the hedge at four"."""

from fuzzytime.language import Operation, Reading, content_words
from fuzzytime.language.about_wishes import About, AboutKind, restated
from fuzzytime.requirement import Constraint
from fuzzytime_cli.repl.parts import with_time_of_part
from fuzzytime_cli.repl.plain_words.retiming import FOR, with_time
from fuzzytime_cli.repl.scene import Scene, waiting
from fuzzytime_cli.repl.typed import number_of


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
