"""Whether words say all that a clause in front says: "the glue is dry", but not "the glue is"."""

from fuzzytime.language.sentence.clauses.conditions import being, happening, state
from fuzzytime.language.sentence.clauses.levels import is_level
from fuzzytime.language.sentence.trees.tags import DETERMINERS, SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.language.sentence.verbs.statements.statement_trees import as_statement

BINDING = frozenset({"DT", "PRP$", "TO", "MD", "IN", "CC", "PDT", "WDT", "EX"})
"""Tags of words that do not end a clause, and that no order follows."""

HELPING = frozenset({"have", "do", "get"})
"""Verbs that help another, beside "be" and the modals."""

COMPLEMENTS = ("acomp", "attr", "oprd", "prep", "advmod", "prt", "xcomp", "npadvmod", "dobj")
"""What a verb of a whole clause may have behind it."""

EVENTFUL = frozenset({"after", "before", "until", "into"})
"""Clauses that may be a noun: "after the meeting"."""


def binds(tree: Tree, place: int) -> bool:
    """Whether a word needs others behind it; a particle needs none: "when the kettle clicks off"."""
    lexicon = tree.lexicon
    node, before = tree.nodes[place], tree.nodes[place - 1]
    carried = before.is_verb and before.lemma not in lexicon.closed.lemmas_of_be
    # "When ann gets in book a table", "each time a truck comes in weigh it"
    behind = tree.nodes[place + 2 : place + 3]
    led = any(one.tag in DETERMINERS or one.lower in lexicon.closed.it_or_them for one in behind) and carried
    apart = node.lower in lexicon.particles and (led or all(below < place for below in tree.children(place)))
    if node.tag == "DT" and node.head < place and node.relation != "det":
        # "When you're done with that do the stairs"
        return False
    if node.lower in lexicon.particles and before.lemma in lexicon.closed.lemmas_of_be:
        # "When the film is over dim the lights"
        return False
    # "If the parcel hasn't come"; but "as soon as the shop opens buy bread"
    helping = node.tag == "MD" or node.lemma in HELPING | lexicon.closed.lemmas_of_be
    helps = helping and node.relation in {"aux", "auxpass"} and node.head > place
    # "If it rains I water the plants"
    subject = (before if node.tag == "RB" and place else node).lower in lexicon.closed.first_and_third_person
    denies = node.relation == "neg" and node.head > place
    return helps or denies or subject or (node.tag in BINDING and not apart)


def is_clause(tree: Tree, kind: str, *, wished: bool) -> bool:
    """Whether words say all that a clause says: that something is so, or done, or an event."""
    lexicon = tree.lexicon
    if is_level(tree.text, lexicon):
        return True
    if not tree.nodes or binds(tree, len(tree.nodes) - 1):
        return False
    named = lexicon.persons | lexicon.lasting | lexicon.happening | lexicon.taken
    does = named.isdisjoint({tree.nodes[tree.root].lower, tree.nodes[tree.root].lemma})
    # The order behind it stands where a time would: "the ice melts | serve the drinks"
    end = len(tree.nodes) + does
    tree = as_statement(tree, frozenset(range(end)), lexicon.travelling)
    root, node = tree.root, tree.nodes[tree.root]
    if tree.children(root, *SUBJECTS, "expl") and node.is_verb:
        # "When the timer goes"
        does = node.lemma not in lexicon.doing.being or node.lemma in lexicon.doing.being_or_doing
        # "When dad has been | I'll walk the dog"; but "once it has been cut"
        return does or bool(tree.children(root, *COMPLEMENTS)) or (wished and node.tag == "VBN")
    if node.tag in {"VBG", "VBN", "JJ"}:
        return True
    if kind in EVENTFUL:
        # "Before the guests get here": a plural has its verb behind it; but "after three rings".
        several = bool(tree.children(root, "conj")) or node.lower in lexicon.beside.plurals | lexicon.persons
        return (node.tag in {"NN", "NNP"} and not several) or (
            node.tag == "NNS" and bool(tree.children(root, "nummod"))
        )
    whole = range(len(tree.nodes))
    # "When in doubt call Ann"
    where = tree.nodes[0].lower in lexicon.places and state(tree, whole, tree.text) is not None
    return where or any(read(tree, whole, tree.text) is not None for read in (happening, being))
