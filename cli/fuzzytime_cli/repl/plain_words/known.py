"""Whether words name something that was asked for, and may be told of."""

from fuzzytime.english import is_participle
from fuzzytime.language import content_words, verb_forms
from fuzzytime.language.about_wishes import Said
from fuzzytime_cli.repl.naming import entry_of, is_named_itself, may_be_told_of, words_of_entry
from fuzzytime_cli.repl.scene import Scene

TO = "to"


def is_known(scene: Scene, thing: Said, *, told: bool) -> bool:
    """Whether words name something that was asked for, and nothing else that may be told of."""
    if thing.label or thing.places or thing.is_in("the next"):
        return True
    if thing.is_in("last"):
        return bool(scene.conversation.state.entries) and not told
    if thing.forms[0] == TO:
        # "To prove", of what is left to
        verb = thing.behind(1)
        return len(verb.words) == 1 and bool(verb.names) and entry_of(scene, verb.names) is not None
    names, openers = thing.names, scene.lexicon.closed.noun_openers
    # "The call", "Ann's call", "that call"
    opened = thing.forms[0] in openers or thing.forms[:1] in thing.table("last")
    if not content_words(thing.forms[-1]) or not (content_words(thing.forms[0]) or opened):
        return False
    other_time = thing.has_time and not is_named_itself(scene, names)
    entry = entry_of(scene, names) if names and thing.is_one and not other_time else None
    if entry is None or not names <= words_of_entry(scene, entry):
        return False
    timed = scene.lexicon.happening | scene.lexicon.taken
    noun = is_participle(thing.forms[0]) or (len(thing.words) == 1 and names <= timed)
    if thing.forms[0] in verbs_of(scene, names) and not noun:
        # "Feed the dog" may be done twice, but "feeding the dog", and a call, is what was asked for.
        return False
    return not told or may_be_told_of(scene, names)


def verbs_of(scene: Scene, names: frozenset[str]) -> frozenset[str]:
    """Give the verbs of what is named, in any form."""
    asked = (one.operation for one in scene.plan.everything if names <= content_words(one.skill.name))
    verbs = (verb_forms(one.lemma, scene.lexicon) for one in asked if one is not None and not one.stated)
    return frozenset[str]().union(*verbs)
