"""Where a verb is left out before another thing and its time: "feed the cat at eight and the dog at nine"."""

from collections.abc import Collection, Sequence
from itertools import pairwise

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Order
from fuzzytime.language.meaning.expressions import Phrase, TimeWord
from fuzzytime.language.meaning.phrases import places_in
from fuzzytime.language.sentence.references.phrase_anchors import ORDERING
from fuzzytime.language.sentence.segments.waiting import Part, Waiting
from fuzzytime.language.sentence.trees.tags import ALL_NOUNS, DETERMINERS, SUBJECTS
from fuzzytime.language.sentence.verbs.places import says_where
from fuzzytime.requirement import Constraint

SHORTEST_GAP = 2
"""Words at least between two times of which the second is another thing's: "and lunch"."""

THINGS = frozenset({"DT", "PRP$", "JJ", "NN", "NNS", "NNP", "IN", "UH", "CD"})
"""Tags of words that name a thing, or what is called out: "goodbye"."""

DESCRIBING = frozenset({"JJ", "JJR", "VBN", "VBD", "VBG"})
"""Tags of how a thing is; a plural may have that of a verb: "finals"."""

MOMENTS = frozenset({None, Constraint.AT, Constraint.BETWEEN})
"""How times bind that say when."""

SIDES = MOMENTS | {Constraint.BEFORE, Constraint.AFTER}
"""How times bind of which each is another thing's: "shirts before lunch and trousers after dinner"."""


def _turns_to_particle(between: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words between two times are a verb's other particle: "on at six and off again at eight"."""
    texts = [word.text for word in between]
    said = [text for text in texts[1:] if text not in lexicon.closed.adverbs_of_repetition] or texts[1:]
    # "And back up to 37 degrees"
    numbered = said[1:2] == ["to"] and said[2:3] != [] and said[2].isdecimal()
    alone = len(said) == 1 or numbered
    return texts[:1] in (["and"], [","], ["&"]) and alone and said[:1] != [] and said[0] in lexicon.particles


def _particles_behind_clauses(one: Waiting, part: Part) -> list[int]:
    """Give where a verb's other particle begins: "on when it gets dark and off at midnight"."""
    lexicon = part.lexicon
    words, starts = one.source.scanned.words, {phrase.first for phrase in one.source.phrases}
    lemma, found, behind = part.tree.nodes[part.tree.root].lemma, [], False
    for place in one.source.places(part.offset, one.segment.span[1])[: -SHORTEST_GAP - 1]:
        turned = words[place + 1].text
        again = words[place + 2].text in lexicon.closed.adverbs_of_repetition
        timed = place + SHORTEST_GAP + again
        says_when = timed in starts or longest_match(words, timed, lexicon.clauses) is not None
        carried = lemma in lexicon.particles.get(turned, ()) or turned in lexicon.beside.switched
        other = words[place].text in lexicon.closed.additive_conjunctions and carried
        # "At six turn it on, and off again at seven"
        apart = words[place - 1].text == ","
        turns = (again or apart) and words[place - 1 - apart].text in lexicon.particles
        if (behind or turns) and other and says_when:
            found.append(words[place + 1].start)
        behind = behind or (place > 0 and longest_match(words, place, lexicon.clauses) is not None)
    return found


def verbs_left_out(one: Waiting, part: Part) -> list[int]:
    """Give where the verb is left out before another thing and its time: "the cat at 8 and the dog at 9"."""
    words, phrases = one.source.scanned.words, one.source.phrases
    own = [p for p in phrases if part.offset <= p.span[0] and p.span[1] <= one.segment.span[1]]
    found = _particles_behind_clauses(one, part)
    for old, new in pairwise(own):
        between = words[old.end : new.first]
        joint = [word.text for word in between[:2]]
        if joint in ([",", "and"], [",", "then"]):
            between = between[1:]
        if _turns_to_particle(between, part.lexicon):
            found.append(between[1].start)
            continue
        if not between or between[0].text not in {"and", ",", "or", "then"}:
            continue
        if len(between) >= SHORTEST_GAP and (
            _names_another(one, part, between, old, new)
            or _is_elsewhere(words, between, part.lexicon, old, new)
        ):
            found.append(between[1].start)
    return (
        found
        + _things_behind_clauses(one, part, own)
        + _times_in_front(one, part, own)
        + _behind_first(one, part, own)
    )


def _things_behind_clauses(one: Waiting, part: Part, own: Sequence[Phrase]) -> list[int]:
    """Give where another thing follows a clause: "the hens when you get up and the ducks at nine"."""
    words, tree, lexicon = one.source.scanned.words, part.tree, part.lexicon
    behind = tree.nodes[tree.root].end + part.offset
    clause: Word | None = None
    for place in one.source.places(part.offset, one.segment.span[1])[:-SHORTEST_GAP]:
        word = words[place]
        if word.start >= behind and longest_match(words, place, lexicon.clauses):
            clause = word
        when = _when(one, place, own) if word.text == "and" and clause is not None else None
        if clause is None or when is None:
            continue
        # "When you get up"; but "when the rice and the peas are done"
        said, added = ([*part.at(span)] for span in ((clause.start, word.start), (word.end, when)))
        # But "and another one": that is the same again.
        named = added[:1] and tree.nodes[added[0]].tag in ALL_NOUNS | DETERMINERS
        named = named and tree.nodes[added[-1]].lower not in lexicon.closed.plural_anaphors | {"one"}
        if named and all(_is_of_thing(part, p, ()) for p in added) and _is_whole(part, said, added):
            return [words[place + 1].start]
    return []


def _is_whole(part: Part, said: Sequence[int], added: Sequence[int]) -> bool:
    """Whether a clause ends before "and": "when you get up"; but "when the rice | and the peas are done".

    What something is done with may go on behind it, "when you get the invoice | and the receipt", unless
    that is more likely whom the order is done with: "walk the dog before you leave the house | and the cat".
    """
    nodes, lexicon = part.tree.nodes, part.lexicon
    verb = max((p for p in said if nodes[p].is_verb), default=None)
    if verb is None:
        return False
    things = part.tree.said(part.tree.children(part.tree.root, "dobj", "dative"))
    alive = lexicon.people | lexicon.animals
    alike = not alive.isdisjoint(things) and not alive.isdisjoint(nodes[p].lower for p in added)
    return alike or not any(nodes[p].tag in ALL_NOUNS for p in said if p > verb)


def _when(one: Waiting, place: int, own: Sequence[Phrase]) -> int | None:
    """Give where a time or a clause begins behind a word: "at nine", "ten minutes before the pie is done"."""
    words, lexicon = one.source.scanned.words, one.source.scanned.lexicon
    behind = range(place + 1, len(one.source.places(0, one.segment.span[1])))
    clause = next((p for p in behind if longest_match(words, p, lexicon.clauses)), None)
    time = next((phrase for phrase in own if phrase.first >= place), None)
    if time is not None and time.said.constraint is Constraint.FOR and clause != time.end:
        return None
    begins = [p for p in (clause, None if time is None else time.first) if p is not None]
    return words[min(begins)].start if begins else None


def _times_in_front(one: Waiting, part: Part, own: Sequence[Phrase]) -> list[int]:
    """Give where what happens at a time in front begins: "monday gym at six and tuesday choir at seven"."""
    words, lexicon = one.source.scanned.words, part.lexicon
    heads = own[:1] and own[0].span[0] == one.segment.span[0]
    if not heads:
        return []
    found, timed = [], places_in(own)
    listed = part.tree.nodes[part.tree.root].tag in ALL_NOUNS
    for new in own[1:]:
        end = new.end
        for beside in own:
            end = beside.end if beside.first == end else end
        behind, further = ([word.text for word in words[end : end + 2]] + ["", ""])[:2]
        # "At six swim and at eight dinner"; but "at eight lunch boxes"
        ends = not further.isalpha() or further in lexicon.function_words
        happens = ends and behind in lexicon.happening | lexicon.taken
        # "Monday and tuesday gym" is the same on both.
        named = not timed.issuperset(range(own[0].end, new.first - 1))
        led = words[new.first - 1].text == "and" and named
        if led and (happens or (listed and behind.isalpha() and behind not in lexicon.function_words)):
            found.append(new.span[0])
    return found


def _behind_first(one: Waiting, part: Part, own: Sequence[Phrase]) -> list[int]:
    """Give where the second thing begins: "wash the blue towels first and the white ones after that"."""
    words, found = one.source.scanned.words, []
    firsts = (span for span, order in one.source.orders if order is Order.FIRST and span[0] >= part.offset)
    for _, end in firsts:
        then = next((phrase for phrase in own if end <= phrase.span[0]), None)
        between = [word for word in words if then is not None and end <= word.start < then.span[0]]
        if then is None or not _is_ordering(then) or len(between) <= SHORTEST_GAP:
            continue
        named = part.at((between[1].start, between[-1].end))
        closed = part.lexicon.closed
        opened = between[0].text in closed.joints_of_things and between[1].text in closed.noun_openers
        if opened and all(_is_of_thing(part, p, ()) for p in named):
            found.append(between[1].start)
    return found


def _is_ordering(phrase: Phrase) -> bool:
    """Whether a time is about what was said before: "after that"."""
    return isinstance(phrase.said.time, TimeWord) and phrase.said.time.word in ORDERING


def _names_another(one: Waiting, part: Part, between: Sequence[Word], old: Phrase, new: Phrase) -> bool:
    """Whether words between two times name another thing to do the same with: "and the dog at 9"."""
    root = part.tree.root
    words = one.source.scanned.words
    if _is_value(between[1:], part.lexicon) and _is_value(
        words[max(old.first - 2, 0) : old.first], part.lexicon
    ):
        # "Thermostat to 21 at seven, 17 at eleven"
        return True
    # "Tomorrow call Ann at eight and Bob at nine": a tree may have whom for what it becomes.
    objects = part.tree.children(root, "dobj", "oprd")
    things = part.tree.said(objects)
    nodes = [*part.at((between[1].start, between[-1].end))]
    restricted = part.tree.nodes[nodes[0]].lower in part.lexicon.beside.restricting if nodes else False
    if restricted:
        # "Wake both girls at seven, and only nina at eight"
        nodes = nodes[1:]
    if nodes[1:] and part.tree.nodes[nodes[-1]].lower in part.lexicon.closed.adverbs_of_repetition:
        # "The pug at noon, the beagle at one and both again at seven"
        nodes = nodes[:-1]
    others = [part.tree.nodes[p].tag for p in nodes if not _is_of_thing(part, p, things)]
    happens = not part.lexicon.happening.isdisjoint(word.text for word in between)
    # "Lunch at one and dinner at seven", "yoga is at six and judo at eight"
    verb, takes_time = part.tree.nodes[root], part.lexicon.happening | part.lexicon.taken
    # "I've got yoga at six, dinner with Pete at eight"
    has = part.tree.said(part.tree.children(root, *SUBJECTS)) & part.lexicon.closed.first_person
    told = verb.lower in part.lexicon.closed.present_be or (bool(has) and verb.lemma in {"have", "get"})
    is_then = told and bool(part.tree.children(root, *SUBJECTS))
    happening = verb.tag in ALL_NOUNS or (verb.tag == "VBG" and verb.lower in takes_time) or is_then
    # But "the shop is open at nine and closed at six" says two things of one.
    tags = [part.tree.nodes[p].tag for p in nodes]
    says_how = ALL_NOUNS.isdisjoint(tags) and any(tag in DESCRIBING for tag in tags)
    listed = happening and not says_how and between[0].text in part.lexicon.closed.joints_of_things
    if listed and not happens:
        # "Story at seven, lights out by half past": one word says what becomes of the thing.
        return all(tag == "RP" for tag in others[1:])
    opened = between[1].text in part.lexicon.closed.noun_openers
    lasting = opened and bool(objects) and Constraint.FOR in {old.said.constraint, new.said.constraint}
    # "I've got yoga at six for an hour, dinner at eight"
    lasting = lasting or (listed and old.said.constraint is Constraint.FOR)
    if not (lasting or _binds_alike(old, new, happens=happens and not listed)):
        # "An alarm for seven and a timer for ten minutes"
        return False
    places = part.tree.children(root, "prep")
    # "Stop for a brew at ten and for lunch at noon"
    prepositions = set() if objects else part.tree.said(places)
    led = between[1].text in prepositions
    has_object = one.segment.verbless or bool(part.tree.children(root, "dobj", "oprd", "intj"))
    # "Call with Ann at six and gym at eight"
    own = len(between) == SHORTEST_GAP and between[1].text in takes_time and not says_how
    named = led or opened or listed or own or (has_object and between[0].text in {"and", ",", "or"})
    return named and not others


def _is_value(said: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words are a number, or end with one and a unit: "to 21", "21 degrees"."""
    numbers = [word.text.isdecimal() or word.text in lexicon.numbers for word in said]
    return numbers[-1:] == [True] or (numbers[-2:] == [True, False] and said[-1].text.isalpha())


def _is_elsewhere(
    words: Sequence[Word], between: Sequence[Word], lexicon: Lexicon, old: Phrase, new: Phrase
) -> bool:
    """Whether the same is done elsewhere: "hoover downstairs in the morning and upstairs after lunch"."""
    where = len(between) == SHORTEST_GAP and says_where(between[1].text, lexicon)
    where = where and old.first > 0 and says_where(words[old.first - 1].text, lexicon)
    happens = not lexicon.happening.isdisjoint(word.text for word in between)
    return where and _binds_alike(old, new, happens=happens)


def _binds_alike(old: Phrase, new: Phrase, *, happens: bool) -> bool:
    """Whether two times may be of two things to do, or of two that happen."""
    kinds = {old.said.constraint, new.said.constraint}
    return len(kinds) == 1 or kinds <= (MOMENTS if happens else SIDES) or _is_ordering(new)


def _is_of_thing(part: Part, place: int, things: Collection[str]) -> bool:
    """Whether a word names a thing, or is said of one; a tree takes some plurals for verbs: "colours"."""
    node = part.tree.nodes[place]
    plural = node.tag == "VBZ" and not part.tree.children(place, *SUBJECTS)
    ordered = plural and not part.tree.children(part.tree.root, *SUBJECTS)
    # "Two more"
    more = node.lower == "more" and place > 0 and part.tree.nodes[place - 1].tag == "CD"
    # "Dad's bike"; but "dad's home", "mum's at the vet"
    owned = part.tree.nodes[place + 1 : place + 2] if node.tag == "POS" else ()
    owns = any(one.tag.startswith("NN") and not says_where(one.lower, part.lexicon) for one in owned)
    whole = node.lower in part.lexicon.closed.universal_pronouns
    return node.tag in THINGS or node.lower in things or ordered or more or owns or whole
