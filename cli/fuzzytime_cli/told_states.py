"""What somebody tells to be so: "the dew is off" asks for nothing, and is what something may wait for."""

from collections.abc import Iterable

from fuzzytime.english import SHORT_FOR_IS
from fuzzytime.interpreter import Interpreted
from fuzzytime.language import Lexicon, Operation, Reading, content_words, reported
from fuzzytime.language.instruction import overlap

NAMING = ("N", "D", "PRP", "J", "CD", "R", "IN")
"""How the tags of words begin that name what something is told of."""

STATES = frozenset({"JJ", "RB"})
"""Tags of how something is."""

MUST, MUST_BE, HAVE = "must", "must be", "have"
"""What stands before what somebody has to do, or what is to be done; and before what was."""

NO = "no"
"""What stands before a thing that is not there."""

PLACES = frozenset({"IN", "RP"})
"""Tags of where somebody is, where nothing but a time stands behind: "mum isn't in until six"."""

HAPPENING = ("present", "finished", "later", "being", "anew", "absent")
"""Tables of words behind "is" with which something happens, or is news."""


def tells_a_state(said: str, reading: Reading, lexicon: Lexicon) -> bool:
    """Whether words tell what is so: they ask for nothing at any time."""
    if len(reading.instructions) > 1 or any(one.requirements for one in reading.instructions):
        return False
    first = said.split(maxsplit=1)[0].lower().replace("\u2019", "'") if said else ""
    asks = any(one.operation is not None for one in reading.instructions)
    # No order begins with "the" or "it".
    return not asks or first in told_of(lexicon) | lexicon.closed.noun_openers


def is_waited_for(said: str, skills: Iterable[Interpreted]) -> bool:
    """Whether one of some skills waits for what these words say."""
    named = content_words(said)
    parts = (part for one in skills for part in one.requirements)
    return bool(named) and any(
        named <= content_words(part.text)
        for part in parts
        if part.condition is not None or (part.anchor is not None and part.anchor.target is None)
    )


def as_news(said: str) -> str:
    """Put a state that was told as what happens now."""
    return f"{said.strip().rstrip('.! ')} now"


def told_of(lexicon: Lexicon) -> frozenset[str]:
    """Give the first words of what is told of something that was spoken of."""
    return frozenset(form[0] for form in lexicon.conversation["told of"])


def tells_what_is(reading: Reading, lexicon: Lexicon) -> bool:
    """Whether what looks like a wish tells what is, or was: "dinner's burnt", "you forgot the windows"."""
    if len(reading.instructions) > 1 or reading.text.rstrip().endswith("?"):
        return False
    operation = reading.instructions[0].operation if reading.instructions else None
    if operation is None:
        return _is_somehow(reading, lexicon)
    if _is_short_for_is(reading) or _goes_on(reading, lexicon) or _is_somehow(reading, lexicon):
        return True
    if not reading.instructions[0].requirements and _is_remark(reading, operation, lexicon):
        return True
    passed = any(one.relation == "aux:pass" and one.tag == "VBD" for one in reading.tokens)
    if passed or (operation.lemma == "have" and any(one.text.lower() == NO for one in reading.tokens)):
        # "The film got cancelled", "Theo has no homework today"
        return True
    owed = any(token.text.lower() in lexicon.closed.verbs_of_obligation for token in reading.tokens)
    if operation.due is not None:
        # "Mum called"; but "Gareth needs to be called"
        calls = operation.lemma in lexicon.addressing and not (owed or reading.instructions[0].requirements)
        return calls or (operation.object or "").endswith(("'s", "\u2019s"))
    first = reading.tokens[0].text.lower() if reading.tokens else ""
    if operation.negated or reading.instructions[0].requirements:
        return False
    verb = operation.verb.lower()
    past = verb != operation.lemma or any(verb in forms for forms in lexicon.past.values())
    closed = lexicon.closed
    if first in closed.first_person | closed.second_person:
        # "I've got some"; but "I've fed the cat" tells what was done
        spoken = first in closed.first_person or not operation.stated
        return past and spoken and reported(reading, lexicon) is None
    # No order begins with "she", "they" or "that".
    return first in closed.third_person | closed.singular_anaphors and not owed


def told_of_whom(reading: Reading, lexicon: Lexicon) -> str:
    """Give whom words tell something of that is no order, though it reads like one; else empty.

    Of "serving has slipped to six" it is serving, and of "Ann can't help before two" Ann.
    """
    operation = reading.instructions[0].operation if len(reading.instructions) == 1 else None
    if operation is None or reading.text.rstrip().endswith("?"):
        return ""
    tokens = reading.tokens
    place = next((n for n, token in enumerate(tokens) if token.relation == "root"), 0)
    own = [token for token in tokens[:place] if token.head == place]
    subject = next((token for token in own if token.relation == "nsubj"), None)
    if subject is None or subject.text.lower() in lexicon.closed.first_person | lexicon.closed.second_person:
        return ""
    obliges = any(token.lemma in lexicon.closed.verbs_of_obligation for token in own if token.lemma != HAVE)
    happened = operation.due == MUST_BE and tokens[place].tag in {"VBN", "VBD"} and not obliges
    denied = any(token.text.lower() in lexicon.closed.negators for token in own)
    able = denied and operation.due == MUST and not operation.negated and not obliges
    # "Mum says it can't be before one"; but "Mum says dinner at six"
    not_so = any(token.text.lower() in lexicon.closed.negators for token in tokens[place:])
    says = operation.stated and operation.lemma in lexicon.doing.learning and not_so
    return (operation.object or subject.text) if happened or able or says else ""


def _is_remark(reading: Reading, operation: Operation, lexicon: Lexicon) -> bool:
    """Whether words say what somebody thinks, has, or may do: "I like piano", "it might be short"."""
    tokens, closed = reading.tokens, lexicon.closed
    root = next((token for token in tokens if token.relation == "root"), tokens[0])
    mine = tokens[0].text.lower() in closed.first_person
    minds = (operation.lemma,) in lexicon.conversation["minding"]
    clause = any(token.relation == "ccomp" for token in tokens)
    may = any((token.text.lower(),) in lexicon.conversation["may be"] for token in tokens)
    being = operation.lemma == "be" or operation.lemma in lexicon.doing.being
    # "Good to know", and "Bob cooks", which trees take for what is done with cooks
    judged = root.tag == "JJ" and operation.object is None and not operation.stated
    named = tokens[0].text.lower() in lexicon.people and [token.tag for token in tokens[1:]] == ["NNS"]
    return (
        (minds and (mine or clause))
        or (may and (being or mine))
        or (being and root.tag == "VBZ")
        or (mine and root.tag == "VBP" and operation.lemma == "have" and operation.due is None)
        or judged
        or named
    )


def _goes_on(reading: Reading, lexicon: Lexicon) -> bool:
    """Whether words tell what somebody else is at: "Ann is painting the door"."""
    tokens, closed = reading.tokens, lexicon.closed
    place = next((n for n, token in enumerate(tokens) if token.tag == "VBG" and token.relation == "root"), 0)
    own = [token for token in tokens[:place] if token.head == place]
    helped = any(token.text.lower() in closed.third_person_be for token in own)
    told = any(token.relation == "nsubj" and token.text.lower() not in closed.first_person for token in own)
    return helped and told and not reading.instructions[0].requirements


def _is_somehow(reading: Reading, lexicon: Lexicon) -> bool:
    """Whether words tell how something is at some time: "Tom's out on thursday", "it looks like rain".

    What is back, ready or due then happens.
    """
    tokens, conversation = reading.tokens, lexicon.conversation
    being = lexicon.closed.present_be | SHORT_FOR_IS
    timed = [part.span for one in reading.instructions for part in one.requirements]
    # "At ten am" tells of nobody.
    outside = [not any(overlap(one.span, span) for span in timed) for one in tokens]
    place = next((n for n, token in enumerate(tokens) if token.text.lower() in being and outside[n]), 0)
    if not 0 < place < len(tokens) - 1:
        # "Looks like rain at four"
        seems = tokens[:1] != () and tokens[0].tag == "VBZ" and tokens[0].lemma != "be"
        return seems and tokens[0].lemma in lexicon.doing.being - {tokens[0].text.lower()}
    denied = tokens[place + 1].text.lower() in lexicon.closed.negators
    place += denied
    state = tokens[min(place + 1, len(tokens) - 1)]
    happens = {form[0] for name in HAPPENING for form in conversation[name]} | lexicon.doing.foretold
    things = all(token.tag.startswith(NAMING) for token in tokens[: place - denied])
    # "Mum's old car" is hers.
    owned = any(one.tag.startswith("N") for one in tokens[place + 2 : place + 3] if outside[place + 2])
    known = state.text.lower() in happens and not denied
    alone = not any(outside[place + 2 :])
    how = state.tag in STATES or state.lemma in lexicon.doing.closing_up or (state.tag in PLACES and alone)
    return things and how and not owned and not known


def _is_short_for_is(reading: Reading) -> bool:
    """Whether words tell how something is, whose "'s" a tree takes for an owner's: "glue's dry"."""
    tokens = reading.tokens
    place = next(
        (n for n, token in enumerate(tokens) if token.text in SHORT_FOR_IS and n + 1 < len(tokens)), None
    )
    if place is None or reading.instructions[0].requirements:
        return False
    following = tokens[place + 1]
    closes = tokens[place + 2 :] == () and following.tag == "JJ"
    # "Gareth's got a cold"; but "buy Mum's baked beans"
    has = following.tag in {"VBD", "VBN"} and not any(one.tag.startswith("V") for one in tokens[:place])
    return closes or has or following.tag in {"IN", "RP"}
