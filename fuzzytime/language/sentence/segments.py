"""A text cut into instructions: at the ends of sentences, at "then" and its kind, before a further verb."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Span
from fuzzytime.language.meaning.expressions import Offset, Phrase, TimeWord
from fuzzytime.language.sentence.tree import Node, Tree

ENDS = frozenset({".", "!", "?", ";", "…", "\n"})
TITLES = frozenset({"dr", "mr", "ms", "mrs", "st", "prof", "no", "vs", "approx", "ca", "etc"})
"""Words that are typed with a full stop which ends nothing."""

ADJECTIVES = frozenset({"next", "first", "finally", "lastly", "firstly"})
"""Connectives that open an instruction only where it begins."""

OPENED = frozenset({"and", "but", "please", "then"})
JOINTS = frozenset({"and", ",", ";", "&", "then", "please", "also"})
BOUND = frozenset({"by", "before", "until", "till", "from", "since", "after"})
"""Words behind which "then" is a time: "by then"."""

ARTICLES = frozenset({"the", "a", "an", "my", "your", "our", "his", "her", "their"})
FINITE = frozenset({"VBZ", "VBD", "VBP", "MD"})
IMPERATIVE = frozenset({"VB", "VBP"})
SUBJECTS = ("nsubj", "nsubjpass", "csubj", "expl")
EMBEDDED = frozenset({"xcomp", "ccomp", "relcl", "acl", "pcomp"})
COORDINATE = ("conj", "dep", "parataxis", "ccomp", "advcl", "appos")


@dataclass(frozen=True, slots=True)
class Segment:
    """A stretch of the text that holds one instruction, and the connective that led to it, with its span.

    ``addressee`` is who was asked by name, before a comma or behind one; ``verbless`` says that its verb was
    said before: "the cat at eight and the dog at nine".
    """

    span: Span
    connective: str = ""
    connective_span: Span = (0, 0)
    addressee: str | None = None
    verbless: bool = False

    def shares(self, text: str) -> bool:
        """Whether it shares object and time with the verb alone before it: "peel and chop the onions"."""
        return text[slice(*self.connective_span)].lower() in {"and", ","}

    @property
    def empty(self) -> bool:
        """Whether nothing is left."""
        return self.span[0] >= self.span[1]


def segments_of(
    text: str,
    words: Sequence[Word],
    phrases: Sequence[Phrase],
    lexicon: Lexicon,
    taken_back: Sequence[Span] = (),
) -> list[Segment]:
    """Cut a text at what always ends an instruction: full stops and connectives, outside of times.

    ``taken_back`` are stretches that later words correct: nothing ends there.
    """
    inside = {place for phrase in phrases for place in range(phrase.first, phrase.end)}
    inside |= {place for place, word in enumerate(words) if any(a <= word.start < b for a, b in taken_back)}
    cuts: list[tuple[int, int, str]] = []
    place = 0
    vague = {phrase.first for phrase in phrases if isinstance(phrase.said.time, TimeWord)}
    following = {phrase.first for phrase in phrases if _follows(phrase, words)}
    following |= {phrase.end for phrase in phrases if _stops(phrase, words, lexicon)}
    while place < len(words):
        if place in following:
            cuts.append((place, place, ""))
        if place in inside and place not in vague:
            place += 1
            continue
        found = longest_match(words, place, lexicon.connectives) if _opens(words, place, vague) else None
        end = 0 if found is None else _end_of(words, place, len(found))
        # "Do it when you're done": nothing follows.
        if found is not None and end < len(words) and words[end].text not in {*ENDS, "as"}:
            cuts.append((place, end, lexicon.connectives[found]))
            place = end
            continue
        if words[place].text in ENDS and _is_end(text, words, place):
            cuts.append((place, place + 1, ""))
        place += 1
    return list(_between(text, words, cuts, lexicon))


def _follows(phrase: Phrase, words: Sequence[Word]) -> bool:
    """Whether a time in front of an order counts from the order before: "…, five minutes later serve"."""
    later = isinstance(phrase.said.time, Offset) and phrase.said.preposition == "later"
    joined = phrase.first > 0 and words[phrase.first - 1].text in {",", "and", "then", ";"}
    return later and joined and phrase.end < len(words) and words[phrase.end].text not in ENDS


def _stops(phrase: Phrase, words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether the full stop of an abbreviation ends a sentence too: "at 6 p.m. Add the salt"."""
    if words[phrase.end - 1].text != "." or phrase.end + 1 >= len(words):
        return False
    word, object_ = words[phrase.end], words[phrase.end + 1].text
    inside = word.text in lexicon.function_words | lexicon.places
    return word.capital or (not inside and object_ in ARTICLES | {"it", "them"})


def _end_of(words: Sequence[Word], place: int, length: int) -> int:
    """Give the place behind a connective, and the comma that may follow it."""
    end = place + length
    return end + 1 if end < len(words) and words[end].text in {",", ":"} else end


def _opens(words: Sequence[Word], place: int, vague: set[int]) -> bool:
    """Whether a connective here opens an instruction, and is no word inside one ("the next step").

    A vague time does where an instruction begins: "wipe the table; afterwards sweep the floor".
    """
    if place + 1 >= len(words):
        return False
    before = words[place - 1].text if place else ","
    if words[place].text == "then" and before in BOUND:
        return False
    if place in vague and (not place or (before[0].isalnum() and before not in OPENED)):
        return False
    return words[place].text not in ADJECTIVES or before in OPENED or not before[0].isalnum()


def _is_end(text: str, words: Sequence[Word], place: int) -> bool:
    """Whether a mark ends a sentence: it is no part of a number or an abbreviation."""
    word = words[place]
    if word.text != ".":
        return True
    after = text[word.end : word.end + 1]
    if after and not after.isspace():
        return False
    before = words[place - 1] if place else None
    return before is None or (not (len(before.text) == 1 and before.is_letters) and before.text not in TITLES)


def _between(
    text: str, words: Sequence[Word], cuts: Sequence[tuple[int, int, str]], lexicon: Lexicon
) -> Iterator[Segment]:
    start, connective, said = 0, "", (0, 0)
    for first, end, name in (*cuts, (len(words), len(words), "")):
        begin = _behind_opening(words, start, first, lexicon)
        segment = _segment(
            text, words, begin, _before_courtesies(words, begin, first, lexicon), connective, said
        )
        if segment is not None:
            yield segment
            connective, said = "", (0, 0)
        start = end
        if name:
            connective, said = name, (words[first].start, words[end - 1].end)


def _behind_opening(words: Sequence[Word], start: int, end: int, lexicon: Lexicon) -> int:
    """Give where an order begins: "hey robot, please" and "why don't you" are no part of it."""
    begin = start
    while begin < end - 1:
        suggestion = longest_match(words, begin, lexicon.questions["suggesting"])
        if suggestion is not None and begin + len(suggestion) < end:
            begin += len(suggestion)
        elif words[begin].text in lexicon.machines and _counts(words[begin + 1], lexicon):
            break
        elif words[begin].text in lexicon.addresses or (begin > start and words[begin].text == ","):
            begin += 1
        else:
            break
    return begin


def _counts(word: Word, lexicon: Lexicon) -> bool:
    return word.is_digits or word.text in lexicon.numbers


def _before_courtesies(words: Sequence[Word], start: int, end: int, lexicon: Lexicon) -> int:
    """Give where an order ends: "thanks" and "pls" behind it are no part of it."""
    while end > start + 1:
        said = next((f for f in lexicon.courtesies if _ends_with(words, start, end, f)), None)
        if said is None and words[end - 1].text != ",":
            break
        end -= 1 if said is None else len(said)
    return end


def _ends_with(words: Sequence[Word], start: int, end: int, form: tuple[str, ...]) -> bool:
    """Whether a stretch of words ends with a form, and holds more."""
    first = end - len(form)
    return first > start and tuple(word.text for word in words[first:end]) == form


def _segment(
    text: str, words: Sequence[Word], start: int, end: int, connective: str, said: Span
) -> Segment | None:
    while start < end and words[start].text in {",", "and", ":", "-"}:
        start += 1
    while end > start and words[end - 1].text in {",", "and", ":"}:
        end -= 1
    if start >= end:
        return None
    span = (words[start].start, words[end - 1].end)
    if not any(character.isalnum() for character in text[span[0] : span[1]]):
        return None
    return Segment(span, connective, said)


def further_verbs(tree: Tree, root: int, lexicon: Lexicon, times: Sequence[Span] = ()) -> list[int]:
    """Give the words at which further instructions of one sentence begin: imperatives beside the first.

    "Chop the onions, fry them and serve": the tree calls them conjuncts, or mistakes them for something
    else; what counts is a bare verb without a subject behind "and" or a comma.
    """
    timed = {place for span in times for place in tree.at(*span)}
    second = _follows_order(tree, root)
    found = [] if second is None else [second]
    for place, node in enumerate(tree.nodes):
        if place in timed and place != root:
            continue
        alone = node.lower in lexicon.alone
        if (
            place > 1
            and place != root
            and _governs(tree, place, lexicon)
            and (alone or place + 1 not in timed)
        ):
            found.append(place)
            continue
        if place > 1 and place != root and _is_order_before_time(tree, place, timed):
            found.append(place)
            continue
        if place > 1 and place != root and place - 2 in timed and _stands_alone(tree, place, lexicon):
            found.append(place)
            continue
        if place > 1 and _is_passive_order(tree, place) and tree.nodes[place - 1].lower in JOINTS:
            found.append(place)
            continue
        if place in {0, root} or not _is_bare(node) or node.relation not in COORDINATE:
            continue
        if tree.children(place, *SUBJECTS) or tree.children(place, "aux", "mark"):
            continue
        start = _first_of(tree, place)
        start = _behind_joint(tree, start, timed)
        if start == 0 or tree.nodes[start - 1].lower not in JOINTS or _is_embedded(tree, place, root):
            continue
        if place > root or _leads(tree, place, root):
            found.append(start)
    return found


def _behind_joint(tree: Tree, start: int, timed: set[int]) -> int:
    """Give where an instruction begins with the time in front: "…, and by seven have the soup ready"."""
    first = start
    while first and first - 1 in timed:
        first -= 1
    behind = first
    while behind and (behind - 1 in timed or tree.nodes[behind - 1].lower == ","):
        behind -= 1
    # "Boil it, and before that, wash it"
    led = behind > 0 and tree.nodes[behind - 1].lower in {"and", "&", "but"}
    return behind if led else first


def _governs(tree: Tree, place: int, lexicon: Lexicon) -> bool:
    """Whether a word taken for no verb has an object, or a particle: "wipe the rug and empty the bins"."""
    node, before = tree.nodes[place], tree.nodes[place - 1].lower
    if node.tag == "NN" and before in {"and", "&", ","} and node.lower in lexicon.alone:
        return True
    if node.tag not in {"NN", "NNP", "JJ"} or before not in JOINTS or place + 2 >= len(tree.nodes):
        return False
    behind = tree.nodes[place + 1].lower
    if node.lower in lexicon.particles.get(behind, ()):
        return True
    return node.relation == "conj" and before in {"and", "&"} and behind in ARTICLES


def _is_order_before_time(tree: Tree, place: int, timed: set[int]) -> bool:
    """Whether it is an order with nothing but a time: "go to the gate, wait for ten seconds".

    The tree may have it for a thing.
    """
    node = tree.nodes[place]
    if place + 1 not in timed or tree.nodes[place - 1].text != "," or not node.may_act:
        return False
    # "Open in two seconds, close in five"
    listed = place - 2 in timed
    lasts = tree.nodes[place + 1].lower == "for"
    return node.lower == node.lemma and (listed or lasts or node.tag in IMPERATIVE)


def _stands_alone(tree: Tree, place: int, lexicon: Lexicon) -> bool:
    """Whether a word behind a time is an order of one word: "fry it for a minute, flip, fry it again"."""
    node = tree.nodes[place]
    behind = tree.nodes[place + 1].lower if place + 1 < len(tree.nodes) else ","
    bare = (node.may_act and node.lower == node.lemma) or node.lower in lexicon.alone
    counted = place + 1 < len(tree.nodes) and tree.nodes[place + 1].tag == "CD"
    return bare and tree.nodes[place - 1].lower in JOINTS and (counted or behind in JOINTS | ENDS)


def _is_passive_order(tree: Tree, place: int) -> bool:
    """Whether it is the "get" of "get dressed", beside another order."""
    node, over = tree.nodes[place], tree.nodes[tree.nodes[place].head]
    bare = node.tag in IMPERATIVE and node.relation == "auxpass" and node.lemma == "get"
    return bare and over.relation in COORDINATE and not tree.children(node.head, *SUBJECTS)


def _is_bare(node: Node) -> bool:
    """Whether a verb has its bare form, whatever tense it was taken for: "put" is a past form too."""
    return node.tag in IMPERATIVE or (node.tag in {"VBD", "VBN"} and node.lower == node.lemma)


def _follows_order(tree: Tree, root: int) -> int | None:
    """Give where the root begins, if it is a second order: "weld it, wait" has its first below it.

    So has a statement behind an order: "bring my coat, we leave at three".
    """
    subjects = tree.children(root, *SUBJECTS)
    start = min([root, *tree.below(subjects[0])]) if subjects else _first_of(tree, root)
    joint = tree.nodes[start - 1].lower if start else ""
    if joint not in JOINTS or (subjects and joint != ",") or tree.children(root, "aux"):
        return None
    before = [p for p in tree.children(root, *COORDINATE, "csubj") if p < start]
    # "Saw the board, sand the edges": a past form in front is an order, as nobody is named.
    orders = [p for p in before if tree.nodes[p].tag == "VB" or (p == 0 and tree.nodes[p].is_verb)]
    if subjects:
        orders = [p for p in orders if tree.nodes[p].tag == "VB" and _first_of(tree, p) == 0]
    ordered = any(not tree.children(p, *SUBJECTS, "aux", "mark", "advmod") for p in orders)
    return start if ordered else None


def _leads(tree: Tree, place: int, root: int) -> bool:
    return root in tree.below(place)


def _first_of(tree: Tree, place: int) -> int:
    """Give where the instruction of a verb begins: adverbs right before it belong to it."""
    start = place
    while start and tree.nodes[start - 1].tag in {"RB", "UH"} and tree.nodes[start - 1].head == place:
        start -= 1
    return start


def _is_embedded(tree: Tree, place: int, root: int) -> bool:
    """Whether a verb is joined to one that the instruction is about: "remind me to call mum and buy milk"."""
    for above in tree.above(place):
        if above == root:
            return False
        node = tree.nodes[above]
        if node.relation in EMBEDDED and node.tag not in FINITE:
            return True
    return False
