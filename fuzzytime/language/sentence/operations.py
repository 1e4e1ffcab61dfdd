"""What is to be done: an instruction's verb, object and place, and which moment of it a time is about."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Operation, Span
from fuzzytime.language.sentence.tree import Tree
from fuzzytime.requirement import Reference

if TYPE_CHECKING:
    from fuzzytime.skills import FuzzyParameter

COMPLEMENTS = ("xcomp", "ccomp")
SUBJECTS = ("nsubj", "nsubjpass")
OBJECTS = ("dobj", "attr", "oprd", "acomp", "xcomp", "ccomp", "dative")
PLACES = ("prep", "advmod")
PEOPLE = frozenset(
    {"i", "you", "we", "he", "she", "they", "someone", "somebody", "anyone", "one", "who", "it", "there"}
)


@dataclass(frozen=True, slots=True)
class Action:
    """The verb of an instruction in its tree, and what the words around it say."""

    place: int
    reference: Reference | None
    negated: bool


def is_doubtful(tree: Tree) -> bool:
    """Whether a tree has no verb at its root, or an infinitive that nothing governs: "alter it to repeat"."""
    root = tree.root
    if root is None or not tree.nodes[root].is_verb:
        return True
    return any(tree.nodes[p].lower == "to" for p in tree.children(root, "aux"))


def action_of(tree: Tree, lexicon: Lexicon) -> Action | None:
    """Find the verb that is meant: below "I want to", "can you", "don't forget to", "start"."""
    root = tree.root
    if root is None:
        return None
    if not tree.nodes[root].is_verb:
        root = next((p for p in tree.children(root) if _is_order(tree, p)), None)
        if root is None:
            return None
    root = _order_before(tree, root)
    negated = _is_negated(tree, root)
    reference: Reference | None = None
    for _ in range(4):
        lemma = tree.nodes[root].lemma
        below = _complement(tree, root, lemma)
        if below is None:
            break
        if lemma in lexicon.forgetting:
            negated = False
        elif (
            lemma in lexicon.wanting
            or (lemma == "let" and _lets(tree, root))
            or (lemma == "have" and _has_to(tree, below))
        ):
            pass
        elif (named := lexicon.indicators.get(lemma)) is not None:
            reference = Reference(named)
        else:
            break
        root = below
        negated = negated or _is_negated(tree, root)
    if reference is None:
        reference = reference_of(tree, root, lexicon)
    return Action(root, reference, negated)


def _order_before(tree: Tree, root: int) -> int:
    """Give the bare verb in front that a tree took for a subject or an auxiliary: "have the vacuum go"."""
    for place in tree.children(root, "csubj", "aux"):
        node = tree.nodes[place]
        bare = node.tag in {"VB", "VBP"} and not tree.children(place, "aux", *SUBJECTS)
        if bare and (node.relation == "csubj" or (node.lemma == "have" and tree.nodes[root].tag == "VB")):
            return place
    return root


def _is_order(tree: Tree, place: int) -> bool:
    node = tree.nodes[place]
    return (
        node.tag in {"VB", "VBP"}
        and node.relation not in {"relcl", "acl", "advcl"}
        and not tree.children(place, *SUBJECTS)
    )


def _complement(tree: Tree, place: int, lemma: str) -> int | None:
    """Give the verb below a verb, with "to" or as a gerund; "let us" has it bare."""
    for below in tree.children(place, *COMPLEMENTS):
        node = tree.nodes[below]
        if node.is_verb and (node.tag in {"VB", "VBG"} or lemma == "let") and below > place:
            return below
        if node.is_verb and lemma in {"want", "like", "need"} and node.tag in {"VBN", "VBP"}:
            return below
    return None


def _lets(tree: Tree, place: int) -> bool:
    """Whether it is "let us" or "lets", not "let me know"."""
    following = tree.nodes[place + 1].lower if place + 1 < len(tree.nodes) else ""
    return tree.nodes[place].lower == "lets" or following in {"us", "'s", "’s"}


def _has_to(tree: Tree, below: int) -> bool:
    """Whether it is "have to do", not "have it done"."""
    marks = [tree.nodes[p].lower for p in tree.children(below, "aux")]
    return "to" in marks and not tree.children(below, *SUBJECTS)


def _is_negated(tree: Tree, place: int) -> bool:
    return any(
        tree.nodes[p].lower in {"not", "n't", "n’t", "never"} for p in tree.children(place, "neg", "advmod")
    )


def reference_of(tree: Tree, place: int, lexicon: Lexicon) -> Reference | None:
    """Give which moment of an operation its verb, or what it results in, says that its times are about."""
    lemma = tree.nodes[place].lemma
    named = lexicon.indicators.get(lemma) or lexicon.indicators.get(tree.nodes[place].lower)
    if named is not None:
        return Reference(named)
    if tree.nodes[place].lower in lexicon.results and tree.children(place, "auxpass", "aux"):
        return Reference.FINISH
    if lemma in lexicon.causing and any(
        tree.nodes[p].lower in lexicon.results for p in _results(tree, place)
    ):
        return Reference.FINISH
    return None


def _results(tree: Tree, place: int) -> Iterator[int]:
    """Give what a verb brings about: "have the rice ready", "make sure that it is done"."""
    for below in tree.children(place, "acomp", "oprd", "ccomp", "attr", "xcomp", "advcl", "conj"):
        yield below
        yield from _results(tree, below)


@dataclass(frozen=True, slots=True)
class Reader:
    """Reads operations off a tree; ``times`` are the stretches of characters that are about time."""

    tree: Tree
    lexicon: Lexicon
    times: Sequence[Span]

    def operation(self, action: Action) -> Operation:
        """Give the operation of an action."""
        place = action.place
        node = self.tree.nodes[place]
        particle = next(
            (self.tree.nodes[p].lower for p in self.tree.children(place, "prt") if not self._timed(p)), None
        )
        return Operation(
            verb=node.lower,
            lemma=node.lemma,
            span=(node.start, node.end),
            object=self._object(action) or self._subject(place),
            place=self._place(place),
            particle=particle,
            negated=action.negated,
        )

    def _timed(self, place: int) -> bool:
        node = self.tree.nodes[place]
        return any(first <= node.start < end for first, end in self.times)

    def _object(self, action: Action) -> str | None:
        verb = action.place
        parts = [p for p in self.tree.children(verb, *OBJECTS) if p > verb and not self._timed(p)]
        words = self._words(parts, verb)
        # "Have the rice ready": what it results in says which moment is meant, not what is done.
        direct = self.tree.children(verb, *OBJECTS)
        while words and words[-1] in direct and self.tree.nodes[words[-1]].lower in self.lexicon.results:
            words.pop()
        return self._said(words) if words else None

    def _subject(self, verb: int) -> str | None:
        """Give what a statement is about: "the assignment should start now"."""
        subjects = [p for p in self.tree.children(verb, *SUBJECTS) if not self._timed(p)]
        if not subjects or self.tree.nodes[subjects[0]].lower in PEOPLE:
            return None
        return self._said([p for p in sorted(self.tree.below(subjects[0])) if not self._timed(p)])

    def _place(self, verb: int) -> str | None:
        parts = [p for p in self.tree.children(verb, *PLACES) if p > verb and not self._timed(p)]
        kept = [
            p
            for p in parts
            if self.tree.nodes[p].relation == "prep"
            or self.tree.nodes[p].lower
            in {"there", "here", "outside", "inside", "upstairs", "downstairs", "home"}
        ]
        words = self._words(kept, verb)
        words = [p for p in words if self._has_content(p, words)]
        return self._said(words) if words else None

    def _has_content(self, place: int, words: Sequence[int]) -> bool:
        """Whether a preposition still has what it governs: that may have been a time."""
        node = self.tree.nodes[place]
        if node.relation != "prep":
            return True
        return any(child in words for child in self.tree.children(place))

    def _words(self, parts: Sequence[int], verb: int) -> list[int]:
        """Give the words under some words, up to the first that is about time."""
        found: list[int] = []
        for part in parts:
            for place in sorted(self.tree.below(part)):
                if place <= verb:
                    continue
                if self._timed(place):
                    break
                found.append(place)
        return sorted(set(found))

    def _said(self, words: Sequence[int]) -> str | None:
        """Give words as typed, single spaces between those that stood apart, without marks at the ends."""
        kept = list(words)
        while kept and not self.tree.nodes[kept[-1]].text[-1].isalnum():
            kept.pop()
        while kept and not self.tree.nodes[kept[0]].text[0].isalnum():
            kept.pop(0)
        text = ""
        last = None
        for place in kept:
            node = self.tree.nodes[place]
            text += ("" if last is None or last == node.start else " ") + node.text
            last = node.end
        return text.strip() or None

    def parameters(self, action: Action) -> tuple["FuzzyParameter", ...]:
        """Give the vague amounts among what the verb governs: "some food", "a few screws"."""
        words = words_of(self.tree.text)
        found: list[FuzzyParameter] = []
        behind = 0
        for at, word in enumerate(words):
            if (
                at < behind
                or word.start < self.tree.nodes[action.place].start
                or any(a <= word.start < b for a, b in self.times)
            ):
                continue
            form = longest_match(words, at, self.lexicon.amounts)
            if form is None or at + len(form) >= len(words):
                continue
            behind = at + len(form)
            following = words[at + len(form)]
            nodes = list(self.tree.at(following.start, following.end))
            if not nodes:
                continue
            noun = self._noun(nodes[0])
            if noun is not None and not self._timed(noun):
                node = self.tree.nodes[noun]
                _, quantity = self.lexicon.amounts[form]
                found.append(_parameter(self.tree.text[word.start : node.end], node.lower, quantity))
        return tuple(found)

    def _noun(self, place: int) -> int | None:
        for here in (place, *self.tree.above(place)):
            if self.tree.nodes[here].tag.startswith("NN"):
                return here
            if self.tree.nodes[here].is_verb:
                return None
        return None


def _parameter(text: str, noun: str, quantity: tuple[float, float, float, float] | None) -> "FuzzyParameter":
    """Make a parameter; skills bring numpy along, so that they are imported only where there is an amount."""
    from fuzzytime.skills import FuzzyParameter

    return FuzzyParameter(text, noun, quantity)
