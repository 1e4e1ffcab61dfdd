"""What a clause says: that something is done ("you serve") or so ("it is hot"), or an event ("dinner")."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from fuzzytime.english import REFLEXIVE
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.clauses.conditions import (
    ITS,
    being,
    compared,
    condition_of,
    happening,
    levelled,
    state,
)
from fuzzytime.language.sentence.trees.tags import DETERMINERS
from fuzzytime.language.sentence.trees.tree import Tree

STATED = frozenset({"when", "if", "until"})
"""Clauses that say what must be so."""

NAMING = frozenset({"after", "before", "until", "into", "within", "halfway"})
"""Clauses that may name an event."""

NAMED = ("NN", "JJ", "DT", "PDT", "PRP$", "CC", ",")
"""How tags of words begin that name things one by one."""

NOUNS = ("NN", "VBG", "CD", "PRP", "JJ")


@dataclass(frozen=True, slots=True)
class Contents:
    """Reads what clauses of a tree say; ``phrases`` are the times, at which a noun ends."""

    tree: Tree
    phrases: Sequence[Phrase]
    lexicon: Lexicon

    def told(self, clause: Clause, nodes: Sequence[int]) -> Clause | None:
        """Give a clause with what it says: that something is done, or so, or an event."""
        said = self.tree.text[slice(*clause.span)]
        verb, *others = self._verbs(clause, nodes) or (None,)
        if verb is not None:
            told = self._done(clause, verb, nodes)
            further = [self._done(clause, p, sorted({*nodes} & {*self.tree.below(p)})) for p in others if p]
            return replace(told, further=tuple(one for one in further if one.object is not None))
        if clause.kind in STATED:
            content, bare = self.tree.text[slice(*clause.content)], clause.kind == "until"
            condition = levelled(said, content, self.lexicon, bare=bare)
            condition = condition or compared(self.tree, nodes, said) or happening(self.tree, nodes, said)
            condition = condition or being(self.tree, nodes, said)
            if condition is None and clause.marker.startswith("the "):
                # "The minute steak"
                return None
            if condition is None and clause.kind in NAMING and self._names_event(nodes):
                return self.event(clause, nodes)
            condition = condition or state(self.tree, nodes, said)
            if condition is not None:
                return replace(clause, condition=condition)
        # "While its cooking", "while the baby's asleep"; but "as mum's treat"
        its = clause.marker != "as" or self.tree.nodes[nodes[0]].lower == ITS
        goes_on = None
        if clause.kind == "while" and its:
            goes_on = compared(self.tree, nodes, said) or being(self.tree, nodes, said)
            goes_on = goes_on or state(self.tree, nodes, said)
        return self.event(clause, nodes) if goes_on is None else replace(clause, condition=goes_on)

    def _done(self, clause: Clause, verb: int, nodes: Sequence[int]) -> Clause:
        """Give a clause with what a verb in it says that is done."""
        done = self._finished(verb, nodes)
        thing = self._object(done, nodes) or self._object(verb, nodes)
        condition = condition_of(self.tree, verb, nodes, self.tree.text[slice(*clause.span)])
        if condition.subject is None and self.tree.children(verb, "auxpass") and thing is not None:
            condition = replace(condition, subject=thing.lower(), word=self.tree.nodes[verb].lower)
        return replace(
            clause,
            verb=self.tree.nodes[done].lemma,
            object=thing,
            condition=condition,
            where=self._where(verb, nodes),
        )

    def _verbs(self, clause: Clause, nodes: Sequence[int]) -> list[int]:
        """Give the clause's own verb, the highest in it, and those that "and" joins to it."""
        verbs = [p for p in nodes if self.tree.nodes[p].is_verb and not self._describes(p, clause, nodes)]
        inside = set(nodes)
        tops = [p for p in verbs if not any(a in inside and a in verbs for a in self.tree.above(p))]
        first = (tops or verbs)[:1]
        joined = (p for p in verbs if self.tree.nodes[p].relation == "conj" and p not in first)
        return [*first, *joined]

    def _finished(self, verb: int, nodes: Sequence[int]) -> int:
        """Give what is done that a verb says to be over: "once it has finished welding"."""
        if self.tree.nodes[verb].lemma not in self.lexicon.doing.stopping:
            return verb
        below = (
            p for p in self.tree.children(verb, "xcomp") if p in nodes and self.tree.nodes[p].tag == "VBG"
        )
        return next(below, verb)

    def _describes(self, place: int, clause: Clause, nodes: Sequence[int]) -> bool:
        """Whether a verb is a part of another word; in "the moment it boils" that word is the marker's."""
        node = self.tree.nodes[place]
        if node.relation in {"relcl", "acl"}:
            return node.head in nodes
        if node.relation == "xcomp" and node.head not in nodes and place != nodes[0]:
            # "Remind me the day before the exam to print my notes"
            return True
        led = clause.kind in NAMING and self.tree.nodes[nodes[0]].tag.startswith(("NN", *DETERMINERS))
        if led and place != nodes[0] and "to" in self.tree.said(self._before(place)):
            # "Stay behind after class to tidy up"
            return not self.tree.children(place, "nsubj")
        return node.relation in {"aux", "auxpass", "amod", "compound"}

    def _before(self, place: int) -> list[int]:
        """Give the verbs that help one, and its "to"."""
        return [p for p in self.tree.children(place, "aux") if p < place]

    def _where(self, verb: int, nodes: Sequence[int]) -> str | None:
        """Give what is said behind a verb from the first word on that says where, without times."""
        timed = [range(*phrase.span) for phrase in self.phrases]
        behind = [p for p in nodes if p > verb and not any(self.tree.nodes[p].start in t for t in timed)]
        begin = self.lexicon.beside.whereabouts | self.lexicon.particles.keys() | self.lexicon.places
        first = next((p for p in behind if self.tree.nodes[p].lower in begin), None)
        if first is None:
            return None
        return " ".join(self.tree.nodes[p].text for p in behind if p >= first)

    def _object(self, verb: int, nodes: Sequence[int]) -> str | None:
        inside = set(nodes)
        # "The labels are printed and the boxes are packed": the second may hang on what helps its verb.
        helped = (p for aux in self.tree.children(verb, "auxpass") for p in self.tree.children(aux, "nsubj"))
        for place in (
            *self.tree.children(verb, "dobj", "nsubjpass"),
            *self.tree.children(verb, "nsubj", "attr"),
            *helped,
        ):
            if place in inside:
                below = {p for p in self.tree.below(place) if p in inside}
                below |= {*self._joined_in_front(min(below), nodes)}
                text = " ".join(self.tree.nodes[p].text for p in sorted(below))
                if text.lower() not in self.lexicon.closed.personal_pronouns:
                    return text
        return None

    def _joined_in_front(self, first: int, nodes: Sequence[int]) -> Sequence[int]:
        """Give what "and" joins to a thing in front, where a tree has that elsewhere: "rice and beans"."""
        before = [p for p in nodes if p < first]
        tags = [self.tree.nodes[p].tag for p in before]
        if tags[-1:] != ["CC"] or self.tree.nodes[before[-1]].lower not in self.lexicon.closed.additions:
            return ()
        return before if all(tag.startswith(NAMED) for tag in tags) and tags[-2].startswith("NN") else ()

    def event(self, clause: Clause, nodes: Sequence[int]) -> Clause | None:
        """Read a noun as what is measured from: "before the meeting", "until the end of the film"."""
        together = (
            clause.kind == "while" and clause.marker not in self.lexicon.closed.subordinators_of_simultaneity
        )
        named = clause.edge is not None or clause.kind in NAMING or clause.marker == "by"
        if not (together or named) or not self.tree.nodes[nodes[-1]].tag:
            return None
        head = next((p for p in nodes if self.tree.nodes[p].tag.startswith(NOUNS)), None)
        if head is None or self.tree.nodes[head].lower.endswith(REFLEXIVE):
            return None
        noun = self._noun_end(nodes)
        if self.tree.nodes[noun].lower in self.lexicon.landmarks:
            # "Turn left after the second crossing"
            return None
        end = self.tree.nodes[noun].end
        return replace(
            clause,
            span=(clause.span[0], end),
            content=(clause.content[0], end),
            object=self.tree.text[clause.content[0] : end],
            is_event=True,
        )

    def _names_event(self, nodes: Sequence[int]) -> bool:
        """Whether a noun alone names what happens: "until handover"; but "until golden" is a state."""
        said = tuple(self.tree.nodes[p].lower for p in nodes)
        known = said in self.lexicon.moments or said[-1] in self.lexicon.happening | self.lexicon.taken
        return known and all(self.tree.nodes[p].tag.startswith("NN") for p in nodes)

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
                or (node.relation == "nsubj" and self.tree.nodes[last].tag not in DETERMINERS)
            ):
                break
            last = place
        return last
