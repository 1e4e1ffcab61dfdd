"""Words that are no instruction: questions, and what is not English. They are said, and not planned."""

from collections.abc import Iterator, Sequence

from fuzzytime.language.grammar.judging.walls.dated_entries import HEADS_ALONE
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word, words_of
from fuzzytime.language.instruction import Remark, RemarkKind, Span
from fuzzytime.language.meaning.expressions import Wall
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.together.none_of_it.again_before import repeats
from fuzzytime.language.sentence.together.none_of_it.how_things_are import holds_true, tells_how_things_are
from fuzzytime.language.sentence.together.none_of_it.orders_again import is_about_orders
from fuzzytime.language.sentence.together.none_of_it.what_was import has_done, tells_what_was
from fuzzytime.language.sentence.trees.named import is_none
from fuzzytime.language.sentence.trees.tags import DETERMINERS, SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.requirement import Constraint

OBJECTS = ("dobj", "attr", "oprd")

GREETED = 2
"""Words behind a greeting that are no time."""


def doubts_of(text: str, span: Span, words: Sequence[Word], sketch: Sketch) -> Iterator[Remark]:
    """Give what makes a stretch of a text no instruction; ``sketch`` is that of its words."""
    heads = [phrase.span for phrase in sketch.phrases if phrase.rule in HEADS_ALONE]
    # "AM: post the letters" is not about who speaks.
    inside = (word for word in words if span[0] <= word.start < span[1])
    said = [word for word in inside if not any(first <= word.start < end for first, end in heads)]
    behind = next((word.text for word in words if word.start >= span[1]), "")
    what = _does(said, behind, sketch)
    before, after = (any(map(str.isalnum, part)) for part in (text[: span[0]], text[span[1] :]))
    if what is None and (before or after) and has_done(sketch):
        # Alone, "I've fed the cat" is news of what was planned.
        what = "tells what was, and says nothing to do"
    beside = before or (after and (sketch.operation is None or holds_true(sketch.part.tree)))
    if what is not None:
        yield Remark(RemarkKind.NOT_UNDERSTOOD, span, f"{text[slice(*span)]!r} {what}")
    elif beside and tells_how_things_are(sketch):
        message = f"{text[slice(*span)]!r} tells how things are, and says nothing to do"
        yield Remark(RemarkKind.TOLD, span, message)


def _does(said: Sequence[Word], behind: str, sketch: Sketch) -> str | None:
    """Give what words do that ask for nothing, as in "greets"; None where they may ask for something.

    ``behind`` is the mark that follows them.
    """
    lexicon = sketch.lexicon
    tree = sketch.part.tree
    has_to = " ".join(word.text for word in said[:2]) in lexicon.beside.obliging and behind != "?"
    if (asks(said, behind, lexicon) and not has_to) or (behind == "?" and _is_inverted(tree)):
        return "asks, and says nothing to do"
    if _greets(sketch, said) or _answers(said, lexicon):
        return "greets, and says nothing to do"
    if _takes_back(said, lexicon):
        return "takes back what was said before, and says nothing to do"
    if repeats(sketch.operation, lexicon):
        return "names nothing to repeat: say again what is to be done"
    if _shifts(said, lexicon):
        return "is about when something else is: say the new time of that itself"
    if is_about_orders(sketch.operation, lexicon):
        return "is about what was asked for before: say anew what is meant"
    told = _tells(sketch)
    if told is not None:
        return f"tells {told}, and says nothing to do"
    foreign = foreign_words(tree)
    return f"is not English, as {tree.nodes[foreign[0]].text!r} shows" if foreign else None


def unasked(clauses: Sequence[Clause], text: str, lexicon: Lexicon) -> tuple[Clause, ...]:
    """Give the clauses that do not ask when something is: "when does the shop open"."""
    said = [[word.text for word in words_of(text[slice(*clause.span)])] for clause in clauses]
    asking = [
        words[:1] == ["when"] and words[1:2] != [] and words[1] in lexicon.closed.inverted_auxiliaries
        for words in said
    ]
    return tuple(clause for clause, asks in zip(clauses, asking, strict=True) if not asks)


def _tells(sketch: Sketch) -> str | None:
    """Give what a sentence tells where it asks for nothing: what was, or what nobody does."""
    closed, tree = sketch.lexicon.closed, sketch.part.tree
    root = tree.root
    if not tree.nodes:
        return None
    subjects = [p for p in tree.children(root, *SUBJECTS) if p < root]
    denied = [p for p in subjects if tree.nodes[p].lower in closed.negative_pronouns or _is_no_one(tree, p)]
    if denied:
        return "what nobody does"
    if is_none(tree, root):
        return "what is not to be"
    if tells_what_was(sketch):
        return "what was"
    return "what is not to be" if _is_cancelled(sketch) else None


def _is_cancelled(sketch: Sketch) -> bool:
    """Whether it is told that something does not happen: "choir got cancelled, so no pickup at five"."""
    tree, closed = sketch.part.tree, sketch.lexicon.closed
    node, root = tree.nodes[tree.root], tree.root
    helping = tree.said(tree.children(root, "auxpass"))
    told = bool(helping) and helping <= closed.present_be | closed.past_be | {"got", "gets", "been"}
    told = told and not tree.said(tree.children(root, "aux")) - closed.have
    due = any(phrase.said.constraint is Constraint.BEFORE for phrase in sketch.phrases)
    named = any(p < root for p in tree.children(root, *SUBJECTS))
    called = f"{node.lower} {tree.nodes[root + 1].lower}" if root + 1 < len(tree.nodes) else ""
    off = {" ".join(form) for form in sketch.lexicon.conversation["cancelled"]}
    return node.tag == "VBN" and told and named and not due and not off.isdisjoint({node.lower, called})


def _is_no_one(tree: Tree, place: int) -> bool:
    """Whether it is "no one"."""
    return tree.nodes[place].lower == "one" and place > 0 and tree.nodes[place - 1].lower == "no"


def _greets(sketch: Sketch, said: Sequence[Word]) -> bool:
    """Whether words wish something, or take leave: "merry christmas", "see you tomorrow".

    Behind the greeting stands who is greeted, at most, or what for.
    """
    greeting = longest_match(said, 0, sketch.lexicon.conversation["greeting"]) if said else None
    if greeting is None:
        return False
    heard = sketch.heard
    behind = [word for word in said[len(greeting) :] if word.is_letters]
    left = [word for word in behind if not any(a <= word.start < b for a, b in heard)]
    if left and any(isinstance(p.said.time, Wall) and p.said.time.clock for p in sketch.phrases):
        # "Happy hour at six"
        return False
    return len(left) <= GREETED and not any(word.text in sketch.lexicon.particles for word in left)


def _answers(said: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words only say that it is well, or take leave: "thanks, that's all for now"."""
    place = 0
    while place < len(said):
        form = longest_match(said, place, lexicon.conversation["answering"])
        if form is None and said[place].text[0].isalnum():
            return False
        place += len(form or " ")
    # "Boil the eggs, then cool"
    return sum(word.is_letters for word in said) > 1


def _takes_back(said: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words do nothing but deny: "wait, not now"."""
    marks = {word for form in lexicon.corrections for word in form} | lexicon.beside.taken_back
    texts = [word.text for word in said if word.text.isalpha()]
    return "not" in texts and all(text in marks for text in texts)


def _shifts(said: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether what has a time is moved by a length: "delay the call by an hour"."""
    if not said or said[0].text not in lexicon.moving | lexicon.doing.shifting:
        return False
    counting = lexicon.numbers.keys() | lexicon.beside.of_lengths
    for first in (
        place + 1 for place, word in enumerate(said) if word.text in lexicon.closed.particles_of_shifts
    ):
        behind = first
        while behind < len(said) and (said[behind].text in counting or said[behind].is_digits):
            behind += 1
        units = lexicon.pieces(said, behind) if first < behind < len(said) else ()
        if any(piece.category == "unit" for piece in units):
            return True
    return False


def _is_inverted(tree: Tree) -> bool:
    """Whether a helping verb stands before who does it: "do the bins go out?", but not "could you …?"."""
    root = tree.root
    if not tree.nodes or tree.nodes[0].relation != "aux" or tree.nodes[0].head != root:
        return False
    subjects = [place for place in tree.children(root, *SUBJECTS) if place < root]
    return bool(subjects) and tree.nodes[subjects[0]].lower not in tree.lexicon.closed.asked_to_act


def asks(words: Sequence[Word], behind: str, lexicon: Lexicon) -> bool:
    """Whether words are a question; "could you …?" and "why don't you …?" ask for something to be done.

    ``behind`` is the mark that follows them.
    """

    def opens(place: int, *names: str) -> bool:
        return place < len(words) and any(longest_match(words, place, lexicon.questions[n]) for n in names)

    if not words or opens(0, "requesting", "suggesting"):
        return False
    placed = opens(0, "placing") and (opens(1, "helping") or behind == "?")
    return placed or opens(0, "asking", "stating") or (opens(0, "helping") and opens(1, "asked"))


def foreign_words(tree: Tree) -> list[int]:
    """Give the words that no English sentence has: small words of another language.

    Of those that English has too, "den" is one without an article, and "die" where it has an object.
    """
    found = []
    for place, node in enumerate(tree.nodes):
        named = place > 0 and tree.nodes[place - 1].tag in DETERMINERS
        if node.text in tree.lexicon.foreign and not named:
            acts = node.is_verb and bool(tree.children(place, *OBJECTS))
            if acts or not (node.may_act and node.is_verb):
                found.append(place)
    return found
