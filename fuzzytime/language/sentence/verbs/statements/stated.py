"""Who or what is said to do it: statements ask for nothing."""

from dataclasses import dataclass

from fuzzytime.language.sentence.trees.named import is_shut
from fuzzytime.language.sentence.trees.tags import PRESENT, SUBJECTS
from fuzzytime.language.sentence.verbs.meant.actions import FINITE, passes_on
from fuzzytime.language.sentence.verbs.places import Places
from fuzzytime.language.sentence.verbs.statements.statements import others_do

STATED_OF = ("dobj", "acomp", "oprd", "xcomp", "ccomp")


@dataclass(frozen=True, slots=True)
class Stated(Places):
    """Reads off a tree who does what a verb says, and whether that is only told."""

    def _subject(self, verb: int) -> str | None:
        """Give what a statement is about: "the assignment should start now"."""
        closed = self.lexicon.closed
        node = self.tree.nodes[verb]
        verbs = self._with_verb_above(verb)
        subjects = [p for v in verbs for p in self.tree.children(v, *SUBJECTS) if not self.timed(p)]
        if not subjects:
            return None
        described = self.tree.children(subjects[0], "det", "amod")
        if self.tree.nodes[subjects[0]].lower in closed.subject_pronouns and not described:
            alone = self.tree.nodes[subjects[0]].lower
            wished = node.tag == "VBN" and self.tree.nodes[node.head].lemma in self.lexicon.doing.wishing
            if wished and alone not in closed.first_and_second_person:
                # "I want it cleaned by six"
                return alone
            helping = self.tree.said(self.tree.children(verb, "aux"))
            # "They collect the bins at seven"
            acts = alone in closed.third_person_singular or (
                alone in closed.third_person and bool(self.tree.children(verb, "dobj"))
            )
            return alone if acts and others_do(self.tree, verb, helping) else None
        return self.said([p for p in sorted(self.tree.below(subjects[0])) if not self.timed(p)])

    def _with_verb_above(self, verb: int) -> tuple[int, ...]:
        """Give a verb, with that above it which says who does it: "the sauce needs to simmer"."""
        node = self.tree.nodes[verb]
        below = node.relation == "xcomp" and not passes_on(self.tree, node.head)
        return (verb, node.head) if below else (verb,)

    def _due(self, verb: int) -> str | None:
        """Give what "it" must do: "it has to rest for ten minutes" is about what was said before."""
        node = self.tree.nodes[verb]
        if node.lower in self.lexicon.results or self.tree.children(verb, "auxpass"):
            return None
        verbs = self._with_verb_above(verb)
        subjects = [self.tree.nodes[p].lower for v in verbs for p in self.tree.children(v, *SUBJECTS)]
        helping = {self.tree.nodes[p].lower for v in verbs for p in self.tree.children(v, "aux", "auxpass")}
        helping |= self.tree.said(verbs[1:])
        due = not helping.isdisjoint(self.lexicon.closed.verbs_of_obligation)
        return {"it": "it", "they": "them"}.get(subjects[0]) if subjects and due else None

    def _must(self, verb: int) -> str:
        """Give the words between what must do something, or be done with, and its verb."""
        tag = self.tree.nodes[verb].tag
        if tag == "VBG":
            # "The lawn needs mowing", "the beds need making"
            return "need" if self.tree.nodes[self.tree.nodes[verb].head].tag == "VBP" else "needs"
        if self.tree.nodes[verb].lemma in self.lexicon.doing.needing:
            # "The car needs fuel"
            return ""
        passive = tag == "VBN" or self.tree.children(verb, "auxpass")
        return "must be" if passive else "must"

    def _is_attended(self, verb: int) -> bool:
        """Whether it is said where somebody is, or what they have, and that takes them: "I'm out at noon"."""
        subjects = self.tree.said(self.tree.children(verb, "nsubj"))
        if self._is_own(verb):
            return True
        if (
            self.tree.nodes[verb].lemma not in {"have", "be"}
            or not subjects & self.lexicon.closed.first_person
        ):
            return False
        behind = [p for p in self.tree.below(verb) if p > verb]
        if self._performing(verb):
            return True
        # "Office hours" go on around other work, but not "a meeting for two hours".
        frames = {self.tree.nodes[p].lower for p in behind if not self.timed(p)} & self.lexicon.frames
        said = {form for p in behind for form in (self.tree.nodes[p].lower, self.tree.nodes[p].lemma)}
        return not frames and not said.isdisjoint(self.lexicon.taken)

    def _is_own(self, verb: int) -> bool:
        """Whether an appointment of who speaks is said to be then: "my interview is at ten"."""
        owned = [
            p
            for p in self.tree.children(verb, "nsubj")
            if any(
                self.tree.nodes[owner].lower in self.lexicon.closed.first_person_possessives
                for owner in self.tree.children(p, "poss")
            )
        ]
        names = self.tree.said(owned)
        taken = self.lexicon.taken - self.lexicon.happening - self.lexicon.frames
        return self.tree.nodes[verb].lemma in self.lexicon.doing.happening and not names.isdisjoint(taken)

    def _performing(self, verb: int) -> list[int]:
        """Give the "on" of "we're on at 20:30", which governs nothing."""
        on = (
            p for p in self.tree.children(verb, "advmod", "prep", "prt") if self.tree.nodes[p].lower == "on"
        )
        return [p for p in on if p == verb + 1 and all(map(self.timed, self.tree.children(p)))]

    def attending(self, verb: int) -> list[int]:
        """Give the words for where somebody is who is taken by that: "I'm out", "we're on"."""
        out = [
            p for p in self.tree.below(verb) if self.tree.nodes[p].lower in self.lexicon.taken and p > verb
        ]
        return self._performing(verb) or out[:1]

    def _is_standing(self, verb: int) -> bool:
        """Whether it is said in what state something is for a while: "the bridge is closed until noon".

        A clock time or a deadline beside it asks for that, "the gate is closed at ten", unless it is to come.
        """
        closed = self.lexicon.closed
        helping, timed = self._helping(verb), [p for p in self.tree.children(verb) if self.timed(p)]
        so = {self.tree.nodes[verb].lower}
        if not helping and so <= closed.present_be:
            # "The gym's closed tomorrow": a tree may have that for how it is.
            helping, so = so, self.tree.said(self.tree.children(verb, "acomp"))
        points = self.tree.said(timed) & closed.prepositions_of_points
        foretold = not helping.isdisjoint(closed.future)
        subjects = self.tree.children(verb, "nsubjpass", "nsubj")
        named = bool(subjects) and bool(timed) and (foretold or not points)
        return (
            named
            and bool(helping)
            and helping <= (closed.future | {"be"} if foretold else closed.present_be)
            and not so.isdisjoint(self.lexicon.standing)
        )

    def _is_shut(self, verb: int, helping: set[str]) -> bool:
        """Whether nobody can go somewhere then, which nobody is asked to close: "school closed friday"."""
        named = self.tree.children(verb, *SUBJECTS)
        timed = self.tree.said(p for p in self.tree.children(verb) if self.timed(p))
        if not named or helping or not timed or "by" in timed:
            return False
        return is_shut(self.tree.nodes[named[0]], self.tree.nodes[verb], self.lexicon)

    def _has_then(self, verb: int) -> bool:
        """Whether who speaks has something: "we have visitors at eight", "I'm expecting a parcel at ten".

        It is not so of "I have to go", "I have the car washed at six".
        """
        node, closed = self.tree.nodes[verb], self.lexicon.closed
        helping = self._helping(verb)
        got = node.lower == "got" and bool(helping) and helping <= closed.have_before_got
        has = node.lemma == "have" and node.tag in PRESENT and not helping
        goes_on = node.tag == "VBG" and bool(helping) and helping <= closed.present_be
        goes_on = goes_on and (node.lemma == "have" or node.lemma in self.lexicon.doing.holding_true)
        goes_on = goes_on and any(map(self.timed, self.tree.below(verb)))
        subjects = self.tree.said(self.tree.children(verb, "nsubj"))
        # "We're having people round"
        below = self.tree.children(verb, *STATED_OF, "prt")
        there = [p for p in below if self.tree.nodes[p].lower in self.lexicon.beside.round_there]
        things = self.tree.children(verb, "dobj") or [
            p for place in there for p in self.tree.children(place, "nsubj")
        ]
        behind = [self.tree.nodes[p] for p in below if p not in things and p not in there]
        done = any(other.is_verb or other.lower in self.lexicon.results for other in behind)
        done = done or any(self.tree.children(p, "acl") for p in things)
        return bool((has or got or goes_on) and things and not done and subjects & closed.first_person)

    def _exists(self, verb: int, helping: set[str]) -> bool:
        """Whether something is said to be then: "there's a delivery at ten"; but not "there's no need to"."""
        node = self.tree.nodes[verb]
        there = self.tree.children(verb, "expl") and node.lemma in self.lexicon.closed.lemmas_of_be
        finite = node.tag in FINITE if not helping else helping <= self.lexicon.closed.future
        timed = any(map(self.timed, self.tree.below(verb)))
        return bool(there and finite and timed and self.tree.children(verb, "attr"))

    def _is_foretold(self, verb: int, helping: set[str]) -> bool:
        """Whether it is only told that something is to come: "rain is expected at three"."""
        node, closed, doing = self.tree.nodes[verb], self.lexicon.closed, self.lexicon.doing
        over = self.tree.nodes[node.head]
        called = self.tree.said(self.tree.children(node.head, *SUBJECTS))
        if not called.isdisjoint(closed.first_and_second_person) and verb != node.head:
            return False
        if node.relation == "xcomp" and node.tag == "VB" and not self.tree.children(verb, "auxpass"):
            helped = self._helping(node.head) | {over.lower}
            goes = node.lemma in doing.arriving | doing.leaving | doing.several_timed
            # "The ferry is due to leave at six"
            return over.lower in doing.foretold and bool(helped & closed.present_be) and goes
        come = helping and helping <= closed.present_be | closed.future | {"be"}
        # "Rain expected at three"
        named = self.tree.children(verb, *SUBJECTS) or (node.relation == "acl" and verb == node.head + 1)
        told = come or (not helping and node.relation in {"acl", "ROOT"} and named)
        alone = not self.tree.children(verb, "xcomp")
        return bool(told) and alone and node.tag == "VBN" and node.lower in doing.foretold

    def _helping(self, verb: int) -> set[str]:
        """Give the verbs that help one, and what denies it."""
        return self.tree.said(self.tree.children(verb, "aux", "auxpass", "neg"))

    def _is_stated(self, verb: int) -> bool:
        """Whether somebody or something is said to do it, and to nothing: "the guests arrive at six"."""
        closed, doing = self.lexicon.closed, self.lexicon.doing
        subjects = [self.tree.nodes[p].lower for p in self.tree.children(verb, "nsubj")]
        words = self.tree.said((verb, *self.tree.children(verb, "acomp", "attr")))
        if subjects == ["it"] and not self.lexicon.impersonal.isdisjoint(words):
            # "It's going to rain at four"
            return True
        becomes = self.tree.nodes[verb].lemma in self.lexicon.doing.being - {"be"}
        if subjects == ["it"] and becomes and self.tree.nodes[verb].tag == "VBZ":
            # "It gets cold after nine"
            return True
        helping = self._helping(verb)
        if self._comes_later(verb, helping):
            return True
        if others_do(self.tree, verb, helping) or self._exists(verb, helping):
            return True
        being = [self.tree.nodes[p].tag for p in self.tree.children(verb, "aux", "auxpass")]
        if being == ["VBZ", "VBG"] or being == ["VBP", "VBG"]:
            # "The lift is being mended at ten"
            return True
        if self._is_foretold(verb, helping):
            return True
        finite = self.tree.nodes[verb].tag in FINITE if not helping else helping <= closed.future
        if self._has_then(verb):
            return True
        happening = self.tree.nodes[verb].tag == "VBG" and bool(helping) and helping <= closed.present_be
        finite = finite or happening
        told = bool(subjects) and subjects[0] not in closed.subject_pronouns - closed.first_and_third_person
        goes = self.tree.nodes[verb].lower in doing.timed
        # "Take the bins out tonight, it's recycling tomorrow"
        opens = bool(doing.opening_up & words)
        told = told or (subjects[:1] == ["it"] and (goes or happening or opens))
        if finite and self._is_attended(verb):
            return True
        if self.tree.nodes[verb].lemma in doing.taking and helping <= closed.future | closed.tentative_modals:
            # "It should take an hour", "they need twenty minutes"
            objects = self.tree.children(verb, "dobj", "npadvmod")
            return bool(subjects) and subjects[0] not in closed.sure_persons and any(map(self.timed, objects))
        if self._is_shut(verb, helping):
            return True
        return self._is_standing(verb) or (told and finite and not self._done_to(verb, helping))

    def _comes_later(self, verb: int, helping: set[str]) -> bool:
        """Whether something is said not to happen until a time: "the guests aren't due till eight"."""
        closed, nodes = self.lexicon.closed, self.tree.nodes
        if helping.isdisjoint(closed.negators):
            return False
        subjects = [nodes[p].lower for p in self.tree.children(verb, "nsubj")]
        until = any(
            self.timed(p) and self.lexicon.clauses.get((nodes[p].lower,)) == "until"
            for p in self.tree.below(verb)
        )
        happens = helping - closed.negators <= closed.present_be | closed.future | closed.do_support
        asked = self.tree.children(verb, "dobj", "xcomp", "auxpass") or nodes[verb].tag == "VBN"
        told = bool(subjects) and subjects[0] not in closed.subject_pronouns
        return told and until and happens and not asked

    def _done_to(self, verb: int, helping: set[str]) -> list[int]:
        """Give what something is done to, or must become: of "the guests arrive at six" nothing."""
        closed, results, nodes = self.lexicon.closed, self.lexicon.results, self.tree.nodes
        due = self.lexicon.beside.due | (results if helping & closed.future else frozenset())
        # "The delivery arrives between ten and eleven"
        found = [p for p in self.tree.children(verb, *STATED_OF) if not self.timed(p)]
        found = [p for p in found if nodes[p].lower not in due]
        if nodes[verb].lemma == "be" and not helping:
            # "The hall is free between ten and noon"; but "the hall is ready by ten" asks for it.
            found = [p for p in found if nodes[p].relation != "acomp" or nodes[p].lower in results]
        if helping & closed.future:
            # "I'll be late", "the lads will be hungry at six"
            found = [p for p in found if nodes[p].relation != "acomp"]
        return found
