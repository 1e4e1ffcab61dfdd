"""What a clause says must be so: "the pan is very hot", "the timer rings", "golden brown"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.surroundings.compared import NEARLY
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.sentence.clauses.levels import is_level
from fuzzytime.language.sentence.trees.tags import DETERMINERS, GRAMMATICAL_SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.requirement import Condition

LONGEST_STATE = 3
"""Words that say how something is, at most: "until light and fluffy"."""

NO = "no"
ITS = "its"
"""How "it's" is often typed."""

SAYING_HOW = frozenset({"JJ", "JJR", "RB", "RBR", "IN", "VBN", "VBG", "CD"})
"""Tags of words that say how something is, and of those before them: "too hot", "below 20"."""

EXCEPTING = "unless"
"""The marker of what leaves out a time."""

SHORTEST_BEING = 2
"""Words of "its dark"."""

ANY_DETERMINERS = DETERMINERS | {"PDT", "WDT"}


def is_wish(tree: Tree, words: Sequence[Word]) -> bool:
    """Whether words ask for what they say, and are no condition: "if you could post it by noon"."""
    texts = [word.text for word in words]
    asked = " ".join(texts[:3]) in tree.lexicon.beside.wished_for and "," not in texts
    return asked and tree.nodes[tree.root].start >= words[0].start


def condition_of(tree: Tree, verb: int, nodes: Sequence[int], text: str) -> Condition:
    """Read "the pan is very hot": subject, hedges, word; another form keeps its text only."""
    condition = _condition_of(tree, verb, nodes, text)
    if not text.lower().startswith(EXCEPTING):
        return condition
    return replace(condition, negated=not condition.negated, excepted=True)


def _condition_of(tree: Tree, verb: int, nodes: Sequence[int], text: str) -> Condition:
    doing, node, inside = tree.lexicon.doing, tree.nodes[verb], set(nodes)
    subjects = [p for p in tree.children(verb, *GRAMMATICAL_SUBJECTS) if p in inside]
    if not subjects:
        # "Until it thickens": a pronoun right before the verb was taken for what the marker governs.
        subjects = [p for p in nodes if p == verb - 1 and tree.nodes[p].tag in {"PRP", "PRP$"}]
    negated = any(p in inside for p in tree.children(verb, "neg"))
    if not subjects:
        return Condition(text=text, negated=negated)
    # "If no lamps are on"; but "if no one is in" is as "nobody"
    none = NO in tree.said(tree.children(subjects[0], "det"))
    nobody = none and tree.nodes[subjects[0]].lower == "one"
    negated = negated != (none and not nobody)
    subject = " ".join(
        tree.nodes[p].lower
        for p in sorted(tree.below(subjects[0]))
        if p in inside and (tree.nodes[p].tag not in ANY_DETERMINERS or nobody)
    )
    predicates = ("acomp", "oprd", "advmod", "attr", "prt", "xcomp")
    said = [p for p in tree.children(verb, *predicates) if p in inside and p > verb]
    # "When it is over": what governs nothing is no preposition.
    said = said or [
        p
        for p in nodes
        if p == nodes[-1] == verb + 1 and tree.nodes[p].relation in {"prep", "prt"} and not tree.children(p)
    ]
    # "Once it is hot, about eight minutes": a tree may hang what is so on the length.
    said = said or [p for p in nodes if verb < p == nodes[-1] and tree.nodes[p].tag.startswith("JJ")]
    if (node.lemma not in doing.being and node.lower not in tree.lexicon.closed.clipped_be) or not said:
        starts = node.lemma in doing.phases
        below = [p for p in tree.children(verb, "xcomp") if p in inside and starts]
        below += [p for p in nodes if p == verb + 1 and tree.nodes[p].tag == "VBG" and starts]
        acts = node.lemma not in doing.being or node.lemma in doing.being_or_doing
        action = tree.nodes[below[0]].lower if below else node.lower if acts else None
        return Condition(text=text, subject=subject or None, word=action, negated=negated)
    last = said[-1]
    hedges = tuple(tree.nodes[p].lower for p in sorted(tree.below(last)) if p < last)
    return Condition(
        text=text, subject=subject or None, word=tree.nodes[last].lower, hedges=hedges, negated=negated
    )


def happening(tree: Tree, nodes: Sequence[int], text: str) -> Condition | None:
    """Read "the timer rings", where the tree takes the verb for a plural: a noun, then a word in -s."""
    # "Every time the doorbell rings after dark"
    end = next((position for position, p in enumerate(nodes) if position and tree.nodes[p].tag == "IN"), None)
    *before, last = (tree.nodes[p] for p in nodes[:end])
    named = [node.lower for node in before if node.tag not in ANY_DETERMINERS]
    bare = named and last.tag in {"NN", "JJ"} and last.may_act
    if bare and (before[-1].tag == "NNS" or text.lower().startswith("if")):
        # "When the edges brown", "should the bell ring"
        return Condition(text=text, subject=" ".join(named), word=last.lower)
    if (
        last.tag != "NNS"
        or (len(named) == len(before) and last.lower not in tree.lexicon.doing.surely_timed)
        or not named
        or not before[-1].tag.startswith(("NN", "JJ"))
    ):
        return None
    return Condition(text=text, subject=" ".join(named), word=last.lower)


def being(tree: Tree, nodes: Sequence[int], text: str) -> Condition | None:
    """Read "its dark", "nobody home", where "is" or the mark of what is short for it was left out."""
    said = [tree.nodes[p] for p in nodes]
    if len(said) < SHORTEST_BEING:
        return None
    somebody = said[0].lower in tree.lexicon.closed.indefinite_pronouns and said[1].text.isalpha()
    if somebody and len(said) == SHORTEST_BEING:
        # "If nobody home"
        return Condition(text=text, subject=said[0].lower, word=said[1].lower)
    if said[0].lower == ITS and (len(said) == SHORTEST_BEING or said[1].tag in SAYING_HOW):
        # "When its dark", "when its too hot", "if its over 70 degrees"
        *hedges, last = said[1:]
        measured = any(node.tag == "CD" for node in hedges)
        if measured or not last.tag.startswith("NN") or not hedges:
            return Condition(
                text=text,
                subject="it",
                word=None if measured else last.lower,
                hedges=() if measured else tuple(node.lower for node in hedges),
            )
    return None


def state(tree: Tree, nodes: Sequence[int], text: str) -> Condition | None:
    """Read "until golden brown", "once tender", "while at work": what becomes so is not said."""
    said = [tree.nodes[place] for place in nodes]
    words = [node.lower for node in said if node.tag not in {"CC", ","}]
    again = words[:1] in (["more"], ["again"])
    where = len(said) > 1 and said[0].lower in tree.lexicon.places
    named = again or any(
        node.tag in ANY_DETERMINERS or node.tag in {"PRP", "CD", "IN", "TO"} for node in said[where:]
    )
    if named or not 0 < len(words) <= LONGEST_STATE or not all(word.isalpha() for word in words):
        return None
    return Condition(text=text, subject="it", word=words[-1], hedges=tuple(words[:-1]))


def levelled(text: str, content: str, lexicon: Lexicon, *, bare: bool = False) -> Condition | None:
    """Read "when at 60 degrees", and a ``bare`` "until 80%": what has that level is not said."""
    if not is_level(content, lexicon) and not (bare and is_level(f"at {content}", lexicon)):
        return None
    return at_level(text, content, lexicon)


def at_level(text: str, content: str, lexicon: Lexicon) -> Condition:
    """Give that something has a level: "it", where the level does not name it."""
    named = (word for word in content.lower().split() if word in lexicon.beside.levelled)
    return Condition(text=text, subject=next(named, "it"))


def compared(tree: Tree, nodes: Sequence[int], text: str) -> Condition | None:
    """Read "error rate > 2 %", "the battery below 20": a thing and a number, and no verb.

    So "the battery hovers around 12", where the tree takes the verb for a plural.
    """
    said = [tree.nodes[place] for place in nodes]
    number = next((place for place, node in enumerate(said) if node.tag == "CD"), 0)
    number -= number > 0 and said[number - 1].lower in NEARLY
    forms = (tuple(node.lower for node in said[first:number]) for first in range(number))
    words = next((form for form in forms if form in tree.lexicon.comparisons), ())
    named = [node for node in said[: number - len(words)] if node.tag not in ANY_DETERMINERS]
    if not words or not named or not all(node.tag.startswith("NN") for node in named):
        return None
    return Condition(text=text, subject=" ".join(node.lower for node in named))
