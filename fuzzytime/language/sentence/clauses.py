"""Clauses about time: "when the pan is hot", "after setting the table", "five minutes before you serve"."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Span
from fuzzytime.language.meaning.expressions import Duration, Phrase
from fuzzytime.language.sentence.tree import Tree
from fuzzytime.requirement import Condition

BE = frozenset({"be", "become", "get", "turn", "feel", "look", "seem", "stay", "run", "go"})
UNLESS = "unless"
"""The marker whose clause must not hold."""

LONGEST_STATE = 3
"""Words that say how something is, at most: "until light and fluffy"."""

SUBJECTS = ("nsubj", "nsubjpass", "expl")
DETERMINERS = frozenset({"DT", "PRP$", "PDT", "WDT"})
NOUNS = ("NN", "VBG", "CD", "PRP", "JJ")


@dataclass(frozen=True, slots=True)
class Clause:
    """A clause: what begins it (its kind and as said), its stretch, that of what it says, a distance before.

    ``verb`` and ``object`` are what it says is done, as dictionary form and text; ``condition`` what it
    says must hold.
    """

    kind: str
    marker: str
    span: Span
    content: Span
    verb: str | None = None
    object: str | None = None
    condition: Condition | None = None
    distance: Duration | None = None
    is_event: bool = False

    def moved(self, by: int) -> "Clause":
        """Give the same clause that many characters further on."""
        (a, b), (c, d) = self.span, self.content
        return replace(self, span=(a + by, b + by), content=(c + by, d + by))


def clauses_of(
    tree: Tree, words: Sequence[Word], phrases: Sequence[Phrase], lexicon: Lexicon
) -> list[Clause]:
    """Find the clauses of one instruction.

    A marker inside a time ("before noon") begins none.
    """
    found: list[Clause] = []
    covered = {place for phrase in phrases for place in range(phrase.first, phrase.end)}
    place = 0
    while place < len(words):
        form = None if place in covered else longest_match(words, place, lexicon.clauses)
        clause = None
        if form is not None and lexicon.clauses[form] != "":
            clause = _Clauses(tree, words, phrases, lexicon, covered).read(place, form)
        if clause is None:
            place += 1
            continue
        found.append(clause)
        place = next((p for p, word in enumerate(words) if word.start >= clause.span[1]), len(words))
    return found


class _Clauses:
    def __init__(
        self,
        tree: Tree,
        words: Sequence[Word],
        phrases: Sequence[Phrase],
        lexicon: Lexicon,
        covered: set[int],
    ) -> None:
        self.tree = tree
        self.words = words
        self.phrases = phrases
        self.lexicon = lexicon
        self.covered = covered

    def read(self, place: int, form: tuple[str, ...]) -> Clause | None:
        """Read the clause that a marker at a place begins; None where it begins none."""
        kind = self.lexicon.clauses[form]
        marker_end = self._behind(place, len(form))
        end = self._end(place, marker_end)
        if end <= marker_end:
            return None
        content = (self.words[marker_end].start, self.words[end - 1].end)
        nodes = list(self.tree.at(*content))
        if not nodes or (form[-1] in self.lexicon.ordinals and self._is_counted(nodes[0])):
            return None
        start = self.words[place].start
        distance = self._distance(place)
        if distance is not None:
            start = distance.span[0]
        duration = (
            distance.said.time if distance is not None and isinstance(distance.said.time, Duration) else None
        )
        if duration is not None and distance is not None:
            duration = replace(duration, hedges=(*distance.said.hedges, *duration.hedges))
        span = (start, content[1])
        verb = self._verb(nodes)
        if verb is None and kind in {"when", "until"}:
            said = self.tree.text[start : content[1]]
            condition = self._happening(nodes, said)
            if condition is None and form[0] == "the":
                # "The minute steak"
                return None
            condition = condition or self._state(nodes, said)
            if condition is None:
                return self._event(kind, form, span, content, nodes, duration)
            return Clause(kind=kind, marker=" ".join(form), span=span, content=content, condition=condition)
        if verb is None:
            return self._event(kind, form, span, content, nodes, duration)
        return Clause(
            kind=kind,
            marker=" ".join(form),
            span=span,
            content=content,
            verb=self.tree.nodes[verb].lemma,
            object=self._object(verb, nodes),
            condition=self._condition(verb, nodes, self.tree.text[start : content[1]]),
            distance=duration,
        )

    def _is_counted(self, place: int) -> bool:
        """Whether a word behind "the second" is counted: "the second tray", not "the second it boils"."""
        return self.tree.nodes[place].tag.startswith(("NN", "JJ", "CD")) or not self.tree.nodes[place].tag

    def _behind(self, place: int, length: int) -> int:
        """Give the place behind a marker of some words, whose hyphens the words may have kept."""
        return place + length

    def _end(self, place: int, first: int) -> int:
        """Give where the clause ends: at a comma, at "and" and a time, or at the main verb behind it."""
        comma = next((p for p in range(first, len(self.words)) if self._is_mark(p)), len(self.words))
        root = self.tree.root
        if root is None or place >= len(self.words):
            return comma
        main = self.tree.nodes[root]
        if place == 0 and comma == len(self.words):
            # A clause in front without a comma: up to where the tree says that it ends.
            inner = (
                next(iter(self.tree.at(self.words[first].start, self.words[first].end)), None)
                if first < len(self.words)
                else None
            )
            if inner is not None and main.start > self.words[place].start:
                before = [p for p, word in enumerate(self.words) if word.start >= main.start]
                return before[0] if before else comma
        return comma

    def _is_mark(self, place: int) -> bool:
        """Whether a clause ends before a word: a comma, or "and" before a time or another clause."""
        text = self.words[place].text
        if text not in {"and", "but"} or place + 1 >= len(self.words) or place - 1 in self.covered:
            return text == ","
        clause = longest_match(self.words, place + 1, self.lexicon.clauses)
        bound = any(phrase.first == place + 1 and phrase.said.preposition for phrase in self.phrases)
        return bound or bool(clause and self.lexicon.clauses[clause])

    def _distance(self, place: int) -> Phrase | None:
        """Give the length of time right before a marker: "five minutes before"."""
        for phrase in self.phrases:
            if (
                phrase.end == place
                and phrase.said.preposition is None
                and isinstance(phrase.said.time, Duration)
            ):
                return phrase
        return None

    def _verb(self, nodes: Sequence[int]) -> int | None:
        """Give the clause's own verb: the highest in it."""
        verbs = [p for p in nodes if self.tree.nodes[p].is_verb and not self._describes(p, nodes)]
        if not verbs:
            return None
        inside = set(nodes)
        tops = [p for p in verbs if not any(a in inside and a in verbs for a in self.tree.above(p))]
        return tops[0] if tops else verbs[0]

    def _describes(self, place: int, nodes: Sequence[int]) -> bool:
        """Whether a verb is a part of another word; in "the moment it boils" that word is the marker's."""
        node = self.tree.nodes[place]
        if node.relation in {"relcl", "acl"}:
            return node.head in nodes
        return node.relation in {"aux", "auxpass", "amod", "compound"}

    def _object(self, verb: int, nodes: Sequence[int]) -> str | None:
        inside = set(nodes)
        for place in (
            *self.tree.children(verb, "dobj", "nsubjpass"),
            *self.tree.children(verb, "nsubj", "attr"),
        ):
            if place in inside:
                text = " ".join(
                    self.tree.nodes[p].text for p in sorted(self.tree.below(place)) if p in inside
                )
                if text.lower() not in {"you", "i", "we", "they", "he", "she"}:
                    return text
        return None

    def _condition(self, verb: int, nodes: Sequence[int], text: str) -> Condition:
        """Read "the pan is very hot": subject, hedges, word; another form keeps its text only."""
        inside = set(nodes)
        subjects = [p for p in self.tree.children(verb, *SUBJECTS) if p in inside]
        negated = any(p in inside for p in self.tree.children(verb, "neg"))
        negated ^= text.lower().startswith(UNLESS)
        if not subjects:
            return Condition(text=text, negated=negated)
        subject = " ".join(
            self.tree.nodes[p].lower
            for p in sorted(self.tree.below(subjects[0]))
            if p in inside and self.tree.nodes[p].tag not in DETERMINERS
        )
        node = self.tree.nodes[verb]
        predicates = ("acomp", "oprd", "advmod", "attr", "prt", "xcomp")
        said = [p for p in self.tree.children(verb, *predicates) if p in inside and p > verb]
        if node.lemma not in BE or not said:
            action = node.lower if node.lemma not in BE else None
            return Condition(text=text, subject=subject or None, word=action, negated=negated)
        last = said[-1]
        hedges = tuple(self.tree.nodes[p].lower for p in sorted(self.tree.below(last)) if p < last)
        return Condition(
            text=text,
            subject=subject or None,
            word=self.tree.nodes[last].lower,
            hedges=hedges,
            negated=negated,
        )

    def _happening(self, nodes: Sequence[int], text: str) -> Condition | None:
        """Read "the timer rings", where the tree takes the verb for a plural: a noun, then a word in -s."""
        *before, last = (self.tree.nodes[p] for p in nodes)
        named = [node.lower for node in before if node.tag not in DETERMINERS]
        if last.tag != "NNS" or len(named) == len(before) or not named or not before[-1].tag.startswith("NN"):
            return None
        return Condition(text=text, subject=" ".join(named), word=last.lower)

    def _state(self, nodes: Sequence[int], text: str) -> Condition | None:
        """Read "until golden brown", "once tender": what becomes so is not said."""
        said = [self.tree.nodes[place] for place in nodes]
        words = [node.lower for node in said if node.tag not in {"CC", ","}]
        named = any(node.tag in DETERMINERS or node.tag in {"PRP", "CD", "IN", "TO"} for node in said)
        if named or len(words) > LONGEST_STATE or not all(word.isalpha() for word in words):
            return None
        return Condition(text=text, subject="it", word=words[-1], hedges=tuple(words[:-1]))

    def _event(
        self,
        kind: str,
        form: tuple[str, ...],
        span: Span,
        content: Span,
        nodes: Sequence[int],
        distance: Duration | None,
    ) -> Clause | None:
        """Read a noun as what is measured from: "before the meeting", "until the end of the film"."""
        if kind not in {"after", "before", "until"} or not self.tree.nodes[nodes[-1]].tag:
            return None
        head = next((p for p in nodes if self.tree.nodes[p].tag.startswith(NOUNS)), None)
        if head is None:
            return None
        noun = self._noun_end(nodes)
        end = self.tree.nodes[noun].end
        return Clause(
            kind=kind,
            marker=" ".join(form),
            span=(span[0], end),
            content=(content[0], end),
            object=self.tree.text[content[0] : end],
            distance=distance,
            is_event=True,
        )

    def _noun_end(self, nodes: Sequence[int]) -> int:
        """Give the last word of the noun: up to a preposition, a verb, or a time."""
        last = nodes[0]
        for place in nodes:
            node = self.tree.nodes[place]
            timed = any(a <= node.start < b for a, b in (phrase.span for phrase in self.phrases))
            if place > nodes[0] and (
                timed
                or node.tag in {"IN", "TO", "CC", ",", ".", ":", "WDT", "WP", "MD"}
                or node.is_verb
                or node.relation == "nsubj"
            ):
                break
            last = place
        return last
