"""Which of several things with their times have a verb: "feed the cat at six and grill steak at ten"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.trees.named import is_of_its_own
from fuzzytime.language.sentence.trees.tags import DETERMINERS
from fuzzytime.language.sentence.trees.tree import Tree


def with_own_verbs(parts: Sequence[Part]) -> list[Part]:
    """Give parts, of which none that has a verb borrows one: "feed the cat at six and grill steak at ten"."""
    found: list[Part] = []
    verb = ""
    for part in parts:
        own = part.segment.verbless and _has_own_verb(part.tree, verb)
        found.append(replace(part, segment=replace(part.segment, verbless=False)) if own else part)
        if part.tree.nodes and not found[-1].segment.verbless:
            verb = part.tree.nodes[part.tree.root].lemma
    return found


def _has_own_verb(tree: Tree, before: str) -> bool:
    """Whether words without an article begin with a verb, and not with what kind of thing they name.

    That is so of "grill steak", but not behind what is got: "order pizza at six and ice cream at seven".
    """
    if not tree.nodes or tree.root != 0:
        return False
    verb, lexicon = tree.nodes[0], tree.lexicon
    called = verb.lower in lexicon.people or verb.lower in lexicon.animals
    if not (verb.is_verb and verb.may_act) or verb.lower != verb.lemma or called:
        return False
    tags = [node.tag for node in tree.nodes[1:3]]
    if tags[:1] and (tags[0] in DETERMINERS or tags == ["IN", "CD"]):
        # "Water the basil at six", "spin at 300 g for 5 min"
        return True
    done = lexicon.ordering | lexicon.doing.errands | lexicon.doing.of_events
    things = [tree.reach(thing) for thing in tree.children(0, "dobj")]
    named = [tree.text[: tree.nodes[end - 1].end] for first, end in things if first == 1]
    listed = before in done or any(is_of_its_own(name, lexicon) for name in named)
    return not verb.may_name or (bool(named) and not listed)
