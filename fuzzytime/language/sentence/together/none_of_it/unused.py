"""Words of an instruction that neither its operation nor a time holds: they are pointed at, never dropped."""

from collections.abc import Iterator, Sequence

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word, is_quoted, words_of
from fuzzytime.language.instruction import NOT_USED, Operation, Remark, RemarkKind, Span, overlap
from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.trees.named import SAID_BY
from fuzzytime.language.sentence.trees.reasons import begins_reason
from fuzzytime.language.sentence.trees.tags import DETERMINERS, IMPERATIVE, SUBJECTS
from fuzzytime.language.sentence.trees.tree import Node, Tree
from fuzzytime.language.sentence.verbs.meant.actions import passes_on

OBJECTS = ("dobj", "attr", "oprd")
BESIDE = frozenset({"advcl", "ccomp", "conj", "parataxis", "dep"})
"""Relations of a verb that may be a further order, and was not cut off."""
NAMES = ("NN", "CD")
"""How tags of words begin that name or count something."""


def unused_orders(text: str, part: Part, operation: Operation, heard: Sequence[Span]) -> Iterator[Remark]:
    """Point at orders in the tree of an instruction that its operation does not hold: nothing is dropped.

    ``heard`` are the stretches of its times and clauses.
    """
    tree, held = part.tree, set(operation.name.lower().split())
    for place, node in enumerate(tree.nodes):
        start = node.start + part.offset
        inside = any(first <= start < end for first, end in heard) or operation.span[0] == start
        if inside or node.lower in held or node.tag not in IMPERATIVE or node.relation not in BESIDE:
            continue
        if tree.children(place, *SUBJECTS, "aux", "mark") or not tree.children(place, *OBJECTS, "prt"):
            continue
        below = [p for p in tree.below(place) if tree.nodes[p].relation != "punct"]
        span = part.span(tree.nodes[min(below)], tree.nodes[max(below)])
        message = f"{text[slice(*span)]!r} is not planned: say it as an instruction of its own"
        yield Remark(RemarkKind.NOT_UNDERSTOOD, span, message)


def things_or_orders(text: str, part: Part) -> Iterator[Remark]:
    """Point at a thing beside another that may as well be an order: "strip the wall and paint by noon"."""
    tree = part.tree
    for place, node in enumerate(tree.nodes):
        over = tree.nodes[node.head]
        joined = node.relation == "conj" and over.relation == "dobj" and over.tag.startswith("NN")
        bare = (
            node.tag == "NN"
            and not tree.children(place)
            and tree.nodes[place - 1].lower in tree.lexicon.closed.additive_conjunctions
        )
        led = any(tree.nodes[p].tag in DETERMINERS for p in tree.children(node.head, "det", "poss"))
        if joined and bare and led and node.lower in part.lexicon.chores:
            span = part.span(node)
            yield Remark.noted(text, span, "is taken for a thing: say 'then' before it if it is to be done")


def unused_front(text: str, part: Part, heard: Sequence[Span]) -> Iterator[Remark]:
    """Point at a clause in front that says nothing that is understood: nothing is dropped."""
    first, end = part.segment.span[0], part.offset
    said = text[first:end].rstrip(" ,")
    if said and not any(overlap(span, (first, first + len(said))) for span in heard):
        message = f"{said!r} says when, and is not understood"
        yield Remark(RemarkKind.NOT_UNDERSTOOD, (first, first + len(said)), message)


def unused_words(text: str, part: Part, operation: Operation, heard: Sequence[Span]) -> Iterator[Remark]:
    """Point at names and numbers of an instruction that neither its operation nor a time holds."""
    lexicon = part.lexicon
    beside, why = lexicon.beside, _reasons(part.tree)
    held = {word.text for word in words_of(f"{operation.name} {operation.addressee or ''}")}
    known = held | {word.removesuffix("'s") for word in held}
    persons = lexicon.persons - lexicon.names
    known = known.union(persons, lexicon.machines, beside.nothing, *lexicon.called_behind)
    left = [
        place
        for place, node in enumerate(part.tree.nodes)
        if (_names(node) or node.lower in beside.marking_order or _says_how(node, lexicon))
        and node.text[0].isalnum()
        and place not in why
        and not any(word.text in known for word in words_of(node.text))
        and not any(a <= node.start + part.offset < b for a, b in heard)
    ]
    for first in (place for place in left if place - 1 not in left):
        last = next(place for place in left if place >= first and place + 1 not in left)
        span = part.span(part.tree.nodes[first], part.tree.nodes[last])
        yield Remark.noted(text, span, NOT_USED)
    called = part.segment.addressee
    place = -1 if called is None or operation.addressee else text.find(called)
    span = (place, place + len(called or ""))
    if place >= 0 and not any(character.isdigit() for character in text[slice(*span)]):
        # "Sam, choir at seven": nobody is asked to do what happens.
        yield Remark.noted(text, span, NOT_USED)


def _names(node: Node) -> bool:
    """Whether a word names or counts something, or was taken for a verb that no dictionary has."""
    return node.tag.startswith(NAMES) or (node.tag == "VBZ" and not node.may_act)


def _reasons(tree: Tree) -> frozenset[int]:
    """Give the words that only say why, or what for: "… because Ann comes", "… so we can cook the fish".

    So does who passes an order on, or says what will be: "the school asked us to be there".
    """
    closed, nodes = tree.lexicon.closed, tree.nodes
    whose = [p for verb in range(len(nodes)) if passes_on(tree, verb) for p in tree.children(verb, *SUBJECTS)]
    marks = [place for place in range(len(nodes)) if begins_reason(tree, place)]
    for place, node in enumerate(nodes):
        # "So we can …", "so that we can …"
        aims = node.lower in closed.subordinators_of_purpose and "so" in tree.said(
            range(place - 1, place + 1)
        )
        marks += [place] if aims and place and place < node.head != tree.root else []
    led = (nodes[p].head for p in marks if nodes[p].relation in {"mark", "advmod"})
    whose += [place for place, node in enumerate(nodes) if node.relation == SAID_BY]
    return frozenset(place for top in (*led, *whose) for place in (top, *tree.below(top)))


def _says_how(node: Node, lexicon: Lexicon) -> bool:
    """Whether a word is an adverb that says how something is done, or how often."""
    told = node.tag.startswith("RB") and node.relation == "advmod"
    return told and node.lower not in lexicon.vague_adverbs | lexicon.particles.keys() | lexicon.places


def nothing_to_do(text: str, part: Part, words: Sequence[Word], heard: Sequence[Span]) -> Iterator[Remark]:
    """Point at words without a verb that is understood; at none where all that is said is a time."""
    first, end = part.segment.span
    # "Choir at seven, Jo, Sam": the one is called by the other.
    called = text.rfind(part.segment.addressee, 0, first) if part.segment.addressee else -1
    first = first if called < 0 else called
    inside = (word for word in words if first <= word.start < end)
    said = [word for word in inside if word.is_letters or is_quoted(word.text)]
    if _is_courtesy(words, part.lexicon):
        whole = words[0].start, words[-1].end
        yield Remark(RemarkKind.TOLD, whole, f"{text[slice(*whole)]!r} is said out of courtesy")
    elif not all(any(a <= word.start < b for a, b in heard) for word in said):
        message = f"{text[first:end]!r} names nothing to do that is understood"
        yield Remark(RemarkKind.NOT_UNDERSTOOD, (first, end), message)


def _is_courtesy(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether all that is said is polite, or calls somebody: "hi all", "many thanks"."""
    said = [word for word in words if word.text[0].isalnum()]
    place = 0
    while place < len(said):
        known = longest_match(said, place, lexicon.courtesies)
        if known is None and said[place].text not in lexicon.addresses:
            return False
        place += len(known or said[place : place + 1])
    return bool(said)
