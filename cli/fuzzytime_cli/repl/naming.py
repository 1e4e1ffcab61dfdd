"""What words mean of what was asked for: an instruction, a skill that is running, one that is over."""

import re
from datetime import datetime
from typing import NoReturn

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import Interpreted
from fuzzytime.language import content_words, nouns_of, verb_forms
from fuzzytime_cli.repl.scene import Scene, asked_by, begun_parts, identifier_of, own_words, waiting
from fuzzytime_cli.repl.typed import number_of, whole_number
from fuzzytime_cli.session import Entry, Started

LABEL = re.compile(r"s\d+(?:\.\d+)?")
"""How what is planned is labelled: by its line, and which of several things of that it is."""

LABEL_NUMBERS = re.compile(r"\d+")

BE = "be"
"""The verb of what has only a name: "tea at six"."""

FEW = 2
"""Words that are repeated at most."""


def entry_of(scene: Scene, names: frozenset[str]) -> Entry | None:
    """Give the latest entry that all of some words name; without words the one that was spoken of last.

    Its label names it, too: "s2".
    """
    entries = _to_do_first(scene)
    label = label_meant(scene, names)
    labelled = (entry for entry in entries if label and entry.number == number_of(label))
    if label and (found := next(labelled, None)) is not None:
        return found
    if not names:
        spoken_of = (entry for entry in entries if entry.number == scene.focus)
        return next(spoken_of, None) or next(iter(entries), None)
    return next(iter(entries_named(scene, names)), None)


def is_named_itself(scene: Scene, names: frozenset[str]) -> bool:
    """Whether words name what is to be done, or its label, and no thing that something is done with.

    "Lunch" is itself what is planned in "have lunch with Ann", and no more than a thing in "buy lunch".
    """
    entry = entry_of(scene, names)
    if entry is None or label_meant(scene, names):
        return entry is not None
    operations = [one.operation for one in scene.plan.everything if one.wish.identifier == entry.identifier]
    timed = not names.isdisjoint(scene.lexicon.happening | scene.lexicon.events | scene.lexicon.taken)
    return any(
        operation is not None
        and names <= words_of_entry(scene, entry)
        and not names.isdisjoint(
            # "Football", which Tom has
            content_words(operation.object) | content_words(operation.complement)
            if operation.stated or (timed and operation.lemma in scene.lexicon.doing.spending)
            else content_words(operation.verb) | _words_of_verb(scene, operation.lemma)
        )
        for operation in operations
    )


def may_be_told_of(scene: Scene, names: frozenset[str]) -> bool:
    """Whether what is told of some words is of what was asked for, and may be of nothing that comes besides.

    Lunch may be at one where it is to be bought, but no lawn is that is to be mown.
    """
    entry = entry_of(scene, names) if names else None
    if entry is None or not names <= words_of_entry(scene, entry):
        return False
    lexicon = scene.lexicon
    timed = lexicon.happening | lexicon.events | lexicon.taken
    return is_named_itself(scene, names) or names.isdisjoint(timed)


def is_of_one_task(scene: Scene, names: frozenset[str]) -> bool:
    """Whether words name what one planned thing is done with, and nothing that has a time of its own.

    "The lawn" is that which is to be mown, and "lunch" none of "buy lunch".
    """
    lexicon = scene.lexicon
    if not names or not names.isdisjoint(lexicon.happening | lexicon.events | lexicon.taken):
        return False
    done = [one.operation.object or "" for _, one in waiting(scene) if one.operation and not one.stated]
    return sum(_is_of(names, thing) for thing in done) == 1


def _is_of(names: frozenset[str], thing: str) -> bool:
    """Whether words name a thing, perhaps without whose it is: "the dressing", of "Mrs Ray's dressing"."""
    words, last = content_words(thing), content_words(thing.rpartition(" ")[2])
    return names == words or (names < words and bool(last) and last <= names)


def entries_named(scene: Scene, names: frozenset[str]) -> list[Entry]:
    """Give the entries that all of some words name: the latest first, and what is over last."""
    entries = _to_do_first(scene)
    # "The guests" are what comes, before they are what others wait for.
    happening = {
        one.wish.identifier: content_words(one.skill.name) for one in scene.plan.everything if one.stated
    }
    comes = [e for e in entries if names <= happening.get(e.identifier, frozenset())]
    # What is done with it is meant before what only comes after it: "the nap", and "park after the nap".
    things = [e for e in entries if names <= _things_of(scene, e)]
    own = [entry for entry in entries if names <= own_words(scene, entry)]
    # "It" in its words is what it is called by, and "the inspection" what is inspected.
    by_name = [e for e in entries if names <= words_of_entry(scene, e) | own_words(scene, e)]
    if names <= {form[0] for form in scene.lexicon.conversation["occasion"]}:
        # Which "appointment" is not said.
        by_name = []
    return comes or things or own or by_name


def _to_do_first(scene: Scene) -> list[Entry]:
    """Give all entries, the latest first; what only tells of others ("the lunch takes an hour"), last."""
    running = {number_of(one.identifier) for one in scene.conversation.running(scene.now)}
    latest = scene.conversation.state.entries[::-1]
    to_do = [e for e in latest if called(scene, e.number) is not None or e.number in running]
    return [*to_do, *(entry for entry in latest if entry not in to_do)]


def label_meant(scene: Scene, names: frozenset[str]) -> str:
    """Give the label that names are: "s2", "s1.2"; empty where they are none, or of nothing.

    Where one line asks for several things, and there is no second line, "2" is the second of these.
    """
    label = next(iter(names)) if len(names) == 1 else ""
    if LABEL.fullmatch(label) is None:
        return ""
    entries = scene.conversation.state.entries
    if label in {entry.identifier for entry in entries} | set(_parts(scene)):
        return label
    spoken_of = [entry.number for entry in entries if entry.number == scene.focus or len(entries) == 1]
    parts = [part for number in spoken_of[:1] for part in _parts(scene) if number_of(part) == number]
    place = number_of(label)
    return parts[place - 1] if "." not in label and 1 < len(parts) >= place else ""


def _parts(scene: Scene) -> list[str]:
    """Give how all that is planned or running is labelled, as it was said."""
    found = [one.identifier for one in scene.plan.skills]
    found += [one.identifier for one in scene.conversation.running(scene.now)]
    return sorted(dict.fromkeys(found), key=lambda label: [int(n) for n in LABEL_NUMBERS.findall(label)])


def _things_of(scene: Scene, entry: Entry) -> frozenset[str]:
    """Give the words that an entry itself says of what is done, and not of when."""
    skills = (one for one in scene.plan.everything if one.wish.identifier == entry.identifier)
    return content_words(entry.text) & frozenset[str]().union(
        *(content_words(one.skill.name) for one in skills)
    )


def starts_of_entry(scene: Scene, entry: Entry) -> list[datetime]:
    """Give when what an entry asks for is planned to start, as far as it has not."""
    schedule = scene.plan.schedule
    return [
        scene.plan.instant(schedule.start_times[place])
        for place, _ in waiting(scene, entry.number)
        if scene.plan.has_time(place)
    ]


def words_of_entry(scene: Scene, entry: Entry) -> frozenset[str]:
    """Give the words that name what an entry asks for: its things, and its verbs as nouns too."""
    skills = [one for one in scene.plan.everything if one.wish.identifier == entry.identifier]
    # What only is ("tea at six") has no verb that it could be called by.
    verbs = (one.operation.lemma for one in skills if one.operation and one.operation.lemma != BE)
    nouns = frozenset(noun for verb in verbs for noun in _words_of_verb(scene, verb))
    begun = (content_words(one.name) for one in begun_parts(scene, entry.number))
    names = (content_words(one.skill.name) | occasion_words(scene, one) for one in skills)
    return nouns.union(*names, *begun, {entry.identifier})


def occasion_words(scene: Scene, one: Interpreted) -> frozenset[str]:
    """Give the words for any occasion, where it is one: the dentist is the "dentist appointment", too."""
    return frozenset(form[0] for form in scene.lexicon.conversation["occasion"] if one.stated)


def _words_of_verb(scene: Scene, verb: str) -> frozenset[str]:
    """Give the forms of a verb, and the nouns for what it does."""
    calling = scene.lexicon.doing.calling_up
    forms = verb_forms(verb, scene.lexicon) | (calling if verb in calling else frozenset())
    return frozenset({*forms, *nouns_of(verb), f"{verb}er", f"{verb}y", f"{verb.removesuffix('e')}y"})


def identifier_meant(scene: Scene, text: str) -> str:
    """Give the identifier of the skill that a number, an identifier or words mean: "2", "s2", "the soup".

    Raises
    ------
    FuzzytimeError
        If words mean none, or there are none.
    """
    if not text.strip():
        raise FuzzytimeError("a number from the list must follow, such as 2, or words for what is planned")
    names = content_words(text)
    if whole_number(text.strip().removeprefix("s").partition(".")[0]) is not None or not names:
        return identifier_of(scene, text)
    entry = entry_of(scene, names)
    if entry is None:
        unknown(names)
    running = running_one(scene, names)
    if running is not None and number_of(running.identifier) == entry.number:
        return running.identifier
    return called(scene, entry.number) or entry.identifier


def called(scene: Scene, number: int) -> str | None:
    """Give the identifier of an instruction's first skill in the plan; None where none is planned."""
    found = (one.identifier for one in scene.plan.everything if one.wish.identifier == f"s{number}")
    return next(found, None)


def running_one(scene: Scene, names: frozenset[str]) -> Started | None:
    """Give the skill that is running and that all of some words name; without words the only one.

    Raises
    ------
    FuzzytimeError
        If nothing is named, and several are running.
    """
    running = scene.conversation.running(scene.now)
    if label := label_meant(scene, names):
        return next(
            (one for one in running if label in {one.identifier, f"s{number_of(one.identifier)}"}), None
        )
    if names:
        return next((one for one in reversed(running) if names <= words_begun(scene, one)), None)
    if len(running) > 1:
        spoken_of = next((one for one in running if number_of(one.identifier) == scene.focus), None)
        # Who has their hands free again means what they were at.
        at_work = [one for one in running if one.end > scene.now]
        if spoken_of is None and len(at_work) != 1:
            names_of = ", ".join(f"{one.name} ({one.identifier})" for one in running)
            raise FuzzytimeError(f"several are running: say which: {names_of}")
        return spoken_of or at_work[0]
    return running[0] if running else None


def part_meant(scene: Scene, number: int, names: frozenset[str]) -> str | None:
    """Give the only one of several things to do of an instruction that words name; None for the whole."""
    label = label_meant(scene, names)
    if label and number_of(label) == number:
        # "Drop s1", of s1 and s1.2, is of the first
        several = len({part for part in _parts(scene) if number_of(part) == number}) > 1
        return label if several and label in _parts(scene) else None
    begun = {one.identifier: one.name for one in scene.conversation.running(scene.now)}
    parts = begun | {one.identifier: one.skill.name for _, one in waiting(scene, number)}
    mine = {key: name for key, name in parts.items() if number_of(key) == number}
    # "He rang", of "ring the supplier"
    verbs = {name: verb_forms(name.partition(" ")[0].lower(), scene.lexicon) for name in mine.values()}
    occasions = {one.skill.name: occasion_words(scene, one) for _, one in waiting(scene, number)}
    named = [
        key
        for key, name in mine.items()
        if names <= content_words(name) | verbs[name] | occasions.get(name, frozenset())
    ]
    return named[0] if names and len(named) == 1 and len(set(mine.values())) > 1 else None


def all_called(scene: Scene, names: frozenset[str]) -> list[Started]:
    """Give what has started and is named by all of some words, the latest last; without words all."""
    known = {entry.identifier for entry in scene.conversation.state.entries}
    begun = scene.conversation.store.started(scene.conversation.name)
    return sorted(
        (
            one
            for one in begun
            if one.identifier.partition(".")[0] in known and names <= words_begun(scene, one)
        ),
        key=lambda one: one.done,
    )


def words_begun(scene: Scene, one: Started) -> frozenset[str]:
    """Give the words that name what has started: those of its name, its verb, and its number."""
    number = number_of(one.identifier)
    # The car is not what is mown of "wash the car, mow the lawn".
    whole = len(asked_by(scene, number)) == 1
    entries = scene.conversation.state.entries
    said = (own_words(scene, one) for one in entries if one.number == number and whole)
    # "Have I fed the cat?"
    verb = verb_forms(one.name.partition(" ")[0].lower(), scene.lexicon)
    return content_words(one.name) | next(said, frozenset()) | verb | {f"s{number}"}


def unknown(names: frozenset[str]) -> NoReturn:
    """Say that nothing is meant.

    Raises
    ------
    FuzzytimeError
        Always.
    """
    if not names:
        raise FuzzytimeError("nothing is planned yet")
    what = " ".join(sorted(names)) if len(names) <= FEW else "that"
    raise FuzzytimeError(f"nothing that is planned is about {what} (:list shows what is)")
