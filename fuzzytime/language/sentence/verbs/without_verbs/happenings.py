"""What happens at a time, said without a verb: "dinner at seven", "team meeting from two to three"."""

from collections.abc import Sequence

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Operation
from fuzzytime.language.meaning.expressions import Phrase, Repeat
from fuzzytime.language.meaning.phrases import is_at_clock, is_window
from fuzzytime.language.sentence.trees.named import calls_somebody, names_one
from fuzzytime.language.sentence.trees.tags import DETERMINERS, SINGULAR, SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.language.sentence.verbs.places import Places
from fuzzytime.language.sentence.verbs.without_verbs.named_deeds import names_deed
from fuzzytime.requirement import MOMENTS, Constraint

DOING = ("advcl", "dobj", "nsubj", "nsubjpass", "aux", "auxpass", "expl", "neg", "prt", "xcomp", "ccomp")
"""What hangs on a verb, and on no noun."""

NAMES = ("NN", "VBG", "CD")
PLACING = ("JJ", "DT", "PRP$", "POS", "IN")
NOUN_TAGS = frozenset({"NN", "NNS"})


def happens(tree: Tree, phrases: Sequence[Phrase]) -> bool:
    """Whether a tree names what has a time, and nobody does anything.

    Its root is a noun for that; or any noun for one thing beside two clock times ("physio from two to
    three"), or one that is no verb beside a clock time in a list.
    """
    lexicon = tree.lexicon
    root = tree.root
    if not tree.nodes[root].tag.startswith(NAMES) or tree.children(root, *DOING):
        return False
    if _opens_order(tree):
        return False
    if tree.nodes[root].lower in lexicon.happening | lexicon.taken:
        return True
    if _is_somebodys(tree, root) and any(is_at_clock(p) or p.said.is_day for p in phrases):
        return True
    if tree.nodes[root].lower in lexicon.closed.coming and any(map(is_at_clock, phrases)):
        # "Taxi at seven", "concrete truck 8:30"; but "load truck at nine", and "train at six"
        return not any(node.may_act and node.tag != "JJ" for node in tree.nodes[:root])
    # "A table of twelve at 7:15": no verb has an "of" behind it.
    counted = root == 0 and "of" in tree.said(tree.children(root, "prep"))
    if counted and any(map(is_at_clock, phrases)):
        return True
    # "12:00 emails": what is named by more than one is no order.
    listed = not tree.nodes[root].may_act and any(map(_is_clock_alone, phrases))
    listed = listed or (_is_several(tree, root) and any(map(is_typed, phrases)))
    # "Incision at eight"
    named = _is_noun(tree, root) or _is_counted(tree, root) or _is_of_nouns(tree, root)
    # "District nurse at three"; but "weight check at ten" is somebody's work
    named = named or (names_one(tree.nodes[: root + 1], lexicon) and not names_deed(tree, 0, root))
    listed = listed or (named and any(is_at_clock(one) or _is_at_part(one) for one in phrases))
    # "Status page update every 30 minutes", "backups every night"
    behind = {node.lower for node in tree.nodes[root + 1 : root + 2]} & lexicon.closed.universal_determiners
    repeated = bool(behind) and any(isinstance(phrase.said.time, Repeat) for phrase in phrases)
    single = tree.nodes[root].tag in NOUN_TAGS and _is_noun(tree, root)
    listed = listed or (repeated and (single or _is_of_nouns(tree, root)))
    return listed or (tree.nodes[root].tag in SINGULAR and any(map(is_window, phrases)))


def _opens_order(tree: Tree) -> bool:
    """Whether the first word is what somebody is to do, whatever noun a tree takes it for."""
    first, behind = tree.nodes[0], tree.nodes[1:2]
    if behind and _leads_particle(tree):
        # "Sign in the visitors between nine and ten"
        return True
    if tree.root and first.lower in tree.lexicon.appointing:
        # "Schedule lunch at noon" asks for it.
        return True
    # "Book the meeting room from three to four": no noun stands right before an article.
    return tree.root == 0 and any(node.tag in {"DT", "PRP$"} for node in behind)


def frame_on_day(tree: Tree, timed: Sequence[int], phrases: Sequence[Phrase]) -> Operation | None:
    """Give what one word names that goes on from when to when: "shift 14-22", "Mon early 7-3"."""
    words = [node for p, node in enumerate(tree.nodes) if p not in timed and node.text[0].isalnum()]
    windows = [phrase for phrase in phrases if is_window(phrase)]
    days = [phrase for phrase in phrases if phrase.said.is_day]
    if len(words) != 1 or not windows or len(windows) + len(days) != len(phrases):
        return None
    (node,) = words
    if node.lower not in tree.lexicon.frames - tree.lexicon.chores - tree.lexicon.alone:
        return None
    span = (node.start, node.end)
    return Operation(verb=node.lower, lemma="be", span=span, object=node.text, stated=True)


def _is_somebodys(tree: Tree, root: int) -> bool:
    """Whether it is named by whose it is, which no order is: "kids' bath at half six"."""
    owners = tree.children(root, "poss")
    return tree.nodes[root].tag in {*SINGULAR, "VBG"} and any(tree.children(p, "case") for p in owners)


def _leads_particle(tree: Tree) -> bool:
    """Whether the first word is a verb by the word behind it, as is one that is no noun with a thing."""
    if tree.root and (len(tree.nodes) < 3 or tree.nodes[2].tag not in DETERMINERS):
        return False
    return tree.nodes[0].may_act and tree.nodes[0].lower in tree.lexicon.particles.get(
        tree.nodes[1].lower, ()
    )


def _is_noun(tree: Tree, root: int) -> bool:
    """Whether words are one noun that is no verb, without what could be ordered in front."""
    before = all(tree.nodes[p].tag in {"NN", "NNP", "JJ", "DT", "PRP$"} for p in range(root))
    return before and not tree.nodes[root].may_act and not any(tree.nodes[p].may_act for p in range(root))


def _is_several(tree: Tree, root: int) -> bool:
    """Whether words are nouns, the last for more than one: "client emails"; but "water plants"."""
    node = tree.nodes[root]
    nouns = all(other.tag.startswith(("NN", "CD", "SYM", "HYPH")) for other in tree.nodes[: root + 1])
    nouns = nouns and not any(other.may_act for other in tree.nodes[:root])
    return node.tag == "NNS" and node.text.isalpha() and node.lower != node.lemma and nouns


def _is_counted(tree: Tree, root: int) -> bool:
    """Whether words name one of several, which no order is: "last orders", "another viewing"."""
    lexicon, first = tree.lexicon, tree.nodes[0].lower
    led = first in lexicon.ordinals.keys() | lexicon.closed.ends_of_rows
    led = led or (first,) in lexicon.conversation["more"]
    return led and root > 0 and all(node.tag in NOUN_TAGS for node in tree.nodes[1 : root + 1])


def _is_of_nouns(tree: Tree, root: int) -> bool:
    """Whether words are nouns of which the first cannot be ordered, nor do it: "status page update"."""
    lexicon = tree.lexicon
    first = tree.nodes[0]
    others = lexicon.machines | lexicon.persons | lexicon.workers | lexicon.entries.keys()
    named = first.tag in {"NN", "NNS"} and not first.may_act and first.lower not in others
    return named and root > 0 and all(node.tag in NOUN_TAGS for node in tree.nodes[: root + 1])


def may_be_ordered(tree: Tree) -> bool:
    """Whether what seems to name a thing may as well be an order: "clean bay 2 from one to three"."""
    first = tree.nodes[0]
    bare = first.may_act and first.lower == first.lemma and not first.tag.startswith("NNS")
    return tree.root != 0 and bare and first.tag in {"JJ", "NNP", "VB", "VBP"}


def happening_at(root: int, tree: Tree, phrases: Sequence[Phrase], names: Places) -> Operation:
    """Give what happens, which a tree's root names beside its time.

    Who speaks takes part in what keeps people from all else, and in what is said from when to when, unless
    that goes on around other work, or is awaited.
    """
    lexicon = tree.lexicon
    node = tree.nodes[root]
    spans = any(phrase.said.constraint is Constraint.BETWEEN or is_window(phrase) for phrase in phrases)
    # In "sunday lunch at the club", the lunch is in its time, too.
    meal = {root} if node.lower in lexicon.happening else set()
    words = [place for place in sorted(tree.below(root)) if place in meal or not names.timed(place)]
    named = names.said([place for place in words if names.has_content(place, words)])
    # "Kids at swimming four to five": somebody else is
    placed = any(not names.timed(place) for place in tree.children(root, "prep"))
    others = placed and node.lower in lexicon.people - lexicon.taken
    return Operation(
        verb=node.lower,
        lemma="be",
        span=(node.start, node.end),
        object=(named or node.text)
        .removesuffix(" and")
        .rstrip(" ,")
        .removesuffix("'s")
        .removesuffix("\u2019s"),
        stated=True,
        attended=not others
        and node.lower not in lexicon.frames | lexicon.beside.awaited_in_a_stretch
        and (spans or (node.lower in lexicon.taken and node.lower not in lexicon.happening)),
    )


def person_there(tree: Tree, timed: Sequence[int], *, clocked: bool) -> Operation | None:
    """Give who is somewhere, or is not, for a while: "Chris away friday", "mum in hospital till thursday".

    By the clock, somewhere is where people are to be, or what they do: "kids in bed at eight", "kids at judo
    four to five"; but "Jo back at six".
    """
    lexicon, nodes = tree.lexicon, tree.nodes
    end, where = min(timed, default=len(nodes)), 1 + (nodes[0].tag in DETERMINERS)
    alone = all(p in timed or not nodes[p].text[0].isalnum() for p in range(end, len(nodes)))
    if end <= where or not alone or (end > where + 1 and clocked):
        return None
    known = calls_somebody(nodes[where - 1], lexicon)
    there = nodes[where].lower in lexicon.beside.states | lexicon.closed.adverbs_of_arrival
    named = all(node.tag.startswith((*NAMES, *PLACING)) for node in nodes[where + 1 : end])
    if not (known and there and named):
        return None
    name, place = tree.typed(range(where)), tree.typed(range(where, end))
    span = (nodes[where].start, nodes[end - 1].end)
    return Operation(verb="is", lemma="be", span=span, object=name, place=place, stated=True)


def meal_alone(text: str, phrases: Sequence[Phrase], lexicon: Lexicon, *, listed: bool) -> Operation | None:
    """Give the meal that a text is all about, with its hour: "Christmas dinner at 2pm".

    In a line among others the hours of the meal are its time: "sunday lunch".
    """
    if len(phrases) != 1 or phrases[0].said.preposition is not None:
        return None
    wall = phrases[0].said.wall
    meals = [word for word in words_of(text) if word.text in lexicon.happening - lexicon.frames]
    if wall.part is None or not wall.part.meal or not (listed or wall.clock is not None) or not meals:
        return None
    meal = meals[-1]
    return Operation(verb=meal.text, lemma="be", span=(meal.start, meal.end), object=meal.text, stated=True)


def given_new_time(tree: Tree, phrases: Sequence[Phrase], names: Places) -> Operation | None:
    """Give what happens at the time that it was moved to: "the dentist has been moved to four".

    What others have moved does: "they've moved my appointment to four".
    """
    moved = (tree.nodes[tree.root].lower,) in tree.lexicon.conversation["rescheduled"]
    if not moved or not any(phrase.said.preposition == "to" for phrase in phrases):
        return None
    subjects = [p for p in tree.children(tree.root, *SUBJECTS) if tree.nodes[p].tag.startswith("NN")]
    if tree.said(tree.children(tree.root, *SUBJECTS)) & tree.lexicon.closed.third_person:
        subjects = [p for p in tree.children(tree.root, "dobj") if tree.nodes[p].tag.startswith("NN")]
    return happening_at(subjects[0], tree, phrases, names) if subjects else None


def _is_clock_alone(phrase: Phrase) -> bool:
    """Whether it is a clock time without a preposition, as in a list: "9:15 Status of the project"."""
    said, clock = phrase.said, phrase.said.wall.clock
    return clock is not None and not clock.bare and said.preposition is None and said.constraint is None


def is_typed(phrase: Phrase) -> bool:
    """Whether it is a clock time, or a stretch between two, as it is typed: "12:00", "9:15-10:00", "@10"."""
    return _is_clock_alone(phrase) or is_at_clock(phrase) or is_window(phrase)


def _is_at_part(phrase: Phrase) -> bool:
    """Whether it is at a part of the day: "sparklers at dusk"."""
    said, part = phrase.said, phrase.said.wall.part
    return part is not None and not part.place and said.preposition == "at" and said.constraint in MOMENTS
