"""Where somebody is for a while: what is told of that says what "while she's out", "once he's gone" mean.

"Kids are at gran's till five", then "clean the oven while they're out" and "tea when they're back".
"""

from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.references.anchors import Anchors
from fuzzytime.language.sentence.references.mentions import comes, comes_by_name
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.language.sentence.trees.named import is_several, names_person
from fuzzytime.requirement import Edge


def stay_of(clause: Clause, anchors: Anchors) -> tuple[int, Edge] | None:
    """Give what tells where somebody is, and the end of it that a clause is about; None for neither."""
    condition, closed = clause.condition, anchors.lexicon.closed
    if condition is None or condition.negated or condition.subject is None or clause.kind == "if":
        return None
    words = {word.lower() for word in (condition.word, *(clause.where or "").split()[:1]) if word}
    known = closed.adverbs_of_return | closed.adverbs_of_absence
    if words.isdisjoint(known) and (clause.verb != "be" or clause.where is None):
        return None
    for place, told in anchors.just_before():
        if not told.stated or told.negated:
            continue
        edge = None
        if _is_about(told, condition.subject, anchors):
            edge = _edge_of(words, told, place, anchors)
        elif _is_called(told.complement or "", condition.subject, anchors):
            # "The bus picks her up at twelve and brings her back at four"
            said = {told.particle, *(told.place or "").split()[:1]}
            back = not closed.back_home.isdisjoint(said)
            edge = Edge.END if back is not words.isdisjoint(closed.adverbs_of_return) else None
        elif clause.kind == "while" and _is_there(told, clause.where or ""):
            edge = Edge.START
        if edge is not None:
            return place, edge
    return None


def _is_there(told: Operation, where: str) -> bool:
    """Whether it is told when something is that a clause says somebody is at: "while Sam's at football"."""
    words = content_words(where.partition(" ")[2])
    return bool(words) and words <= content_words(told.object)


def _edge_of(words: set[str], told: Operation, place: int, anchors: Anchors) -> Edge:
    """Give the end of somebody's stay that words of a clause are about."""
    closed, said = anchors.lexicon.closed, {told.particle, *(told.place or "").lower().split()[:1]} - {None}
    comes_there = comes(told, anchors.lexicon) or comes_by_name(told, anchors.lexicon)
    if not words.isdisjoint(closed.adverbs_of_absence):
        # "Mum is out from two", then "once she's gone"; but "boiler man from twelve to four"
        return Edge.END if comes_there or said <= closed.adverbs_of_arrival else Edge.START
    return Edge.START if anchors.told.length(place) is not None else Edge.END


def _is_about(told: Operation, subject: str, anchors: Anchors) -> bool:
    """Whether what is told is about somebody, or what comes: "the delivery", then "once it's here"."""
    comes_there = comes(told, anchors.lexicon) or comes_by_name(told, anchors.lexicon)
    if subject == "it" or (subject == "they" and not is_several(told.object or "", anchors.lexicon)):
        # "The vet comes at ten", then "once they're gone"
        return comes_there
    return _is_called(told.object or "", subject, anchors)


def _is_called(thing: str, subject: str, anchors: Anchors) -> bool:
    """Whether words name somebody as a clause does, or whom its pronoun may stand for."""
    lexicon = anchors.lexicon
    if subject not in lexicon.closed.third_person:
        return not content_words(subject).isdisjoint(content_words(thing))
    own = dict(pair.split() for pair in lexicon.closed.subjects_as_objects).get(subject)
    if thing in lexicon.closed.third_person_objects:
        return own == thing
    others = (words for other, words in lexicon.called.items() if own in lexicon.called and other != own)
    said = thing.lower().split()
    return names_person(thing, lexicon) and all(words.isdisjoint(said) for words in others)
