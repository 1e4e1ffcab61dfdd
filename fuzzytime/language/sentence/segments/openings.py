"""Where an order begins behind who is asked, and ends before thanks: "hey robot, please … thanks"."""

from collections.abc import Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Span, blanked
from fuzzytime.language.meaning.expressions import Duration, Phrase

ENDS = frozenset({".", "!", "?", ";", "\n"})
"""Marks behind which no words belong to what stands before them."""

REMIND_ME = 2
"""Words of it."""

CLAUSE = 3
"""Words of a clause behind its marker, at least: "when I get home"."""

CAN_YOU = 2
"""Words that ask somebody: "can you"."""


def behind_opening(
    words: Sequence[Word], start: int, end: int, times: AbstractSet[int], lexicon: Lexicon
) -> int:
    """Give where an order begins: "hey robot, please" and "why don't you" are no part of it.

    Nor is "could you please", where a time stands behind it, at one of ``times``.
    """
    begin = start
    while begin < end - 1:
        if begin in times:
            # "Let's say noon"; "well before noon" is no "well"
            break
        suggestion = _suggested(words, begin, lexicon) or _supposed(words, begin, end, lexicon)
        if suggestion is not None and begin + len(suggestion) < end:
            begin += len(suggestion)
        elif (asked := _asked_before(words, begin, times, lexicon)) is not None:
            begin = asked
        elif words[begin].text in lexicon.machines and _counts(words[begin + 1], lexicon):
            break
        elif _is_somewhere(words, begin, times, lexicon) or _opens_clause(words, begin, end, lexicon):
            # "So long as it is dry"
            break
        elif words[begin + 1].text in lexicon.closed.stative_verbs:
            # "Everyone is picked up at six"
            break
        elif words[begin].text in lexicon.addresses or (begin > start and words[begin].text == ","):
            begin += 1
        else:
            break
    return begin


def _suggested(words: Sequence[Word], begin: int, lexicon: Lexicon) -> tuple[str, ...] | None:
    """Give "why don't you", "make sure that you" before an order; not before "you are there"."""
    found = longest_match(words, begin, lexicon.questions["suggesting"])
    behind = begin + len(found or ())
    if found is None or behind >= len(words) or found[-1] not in lexicon.closed.personal_pronouns:
        return found
    verb = words[behind].text.removesuffix("n't")
    told = (verb,) in lexicon.questions["helping"] or verb in lexicon.closed.stative_verbs
    return None if told else found


def without_reminding(scanned: Scanned) -> str:
    """Give a text of the same length without "remind me" before a time and an order without "to".

    So is dictated: "remind me at 8 feed the cat", "remind me when I get home water the plants".
    """
    words, lexicon = scanned.words, scanned.lexicon
    recalled = (place for place, word in enumerate(words[:-1]) if word.text in lexicon.doing.recalling)
    spans = (
        (words[place].start, words[place + 1].end)
        for place in recalled
        if words[place + 1].text in lexicon.closed.speakers
        and _reminds_then(words, place + REMIND_ME, {phrase.first for phrase in phrases_of(scanned)}, lexicon)
    )
    return blanked(scanned.text, spans)


def _reminds_then(words: Sequence[Word], behind: int, times: AbstractSet[int], lexicon: Lexicon) -> bool:
    """Whether a time or a clause stands behind "remind me", and then an order."""
    end = next((p for p in range(behind, len(words)) if words[p].text in ENDS), len(words))
    marker = (longest_match(words, behind, lexicon.clauses) or ()) if behind < end else ()
    if behind not in times and not marker:
        return False
    first = behind + len(marker)
    # "After lunch"
    short = behind in times or lexicon.means(words[min(first, end - 1)].text, "meal", "part")
    places = range(first + (1 if short else CLAUSE), end - 1)
    order = next((place for place in places if _is_ordered(words, place, lexicon)), None)
    return order is not None and lexicon.closed.reminded_by.isdisjoint(
        word.text for word in words[behind + len(marker) : order]
    )


def _is_ordered(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether an order begins at a place, and nothing that somebody does."""
    closed, word = lexicon.closed, words[place]
    acts = words[place + 1].text in closed.noun_openers | closed.it_or_them and word.is_letters
    acts = acts and word.text not in lexicon.function_words and not word.text.endswith("s")
    acts = acts and not any(lexicon.pieces(words, place))
    ordered = acts or (word.text in lexicon.orders and words[place + 1].is_letters)
    return ordered and words[place - 1].text not in closed.subject_pronouns


def _supposed(words: Sequence[Word], begin: int, end: int, lexicon: Lexicon) -> tuple[str, ...] | None:
    """Give "I think", "I hope that" before what is told; not before "about it", "so"."""
    found = longest_match(words, begin, lexicon.questions["supposing"])
    behind = begin + len(found or ())
    told = behind < end and words[behind].is_letters
    return found if told and words[behind].text not in lexicon.closed.nothing_supposed else None


def _opens_clause(words: Sequence[Word], begin: int, end: int, lexicon: Lexicon) -> bool:
    """Whether a marker stands at a place, and something behind it."""
    marker = longest_match(words, begin, lexicon.clauses)
    return marker is not None and begin + len(marker) < end


def behind_all_due(
    words: Sequence[Word], start: int, end: int, times: Mapping[int, int], lexicon: Lexicon
) -> int:
    """Give where the time begins that holds for what follows: "all done | by six: lay the table, …"."""
    time = next((place for place in range(start + 1, end) if place in times), end)
    colon = times.get(time, end)
    if colon >= end - 1 or words[colon].text != ":" or words[colon].glued is words[colon + 1].glued:
        return start
    said = [word.text for word in words[start:time]]
    # "All packed by six: fold the shirts", but "all packed by six: shirts, socks"
    behind = [word.text for word in words[colon + 1 : colon + 3]]
    ordered = behind[0] in lexicon.orders or behind[-1] in lexicon.closed.noun_openers
    so = lexicon.results if ordered else lexicon.conversation["having"] | {"ready"}
    obliged = {word for form in lexicon.beside.obliged for word in form.split()}
    known = lexicon.closed.wholes | lexicon.closed.all_anaphors | so | obliged | {"of", "do", "doing", "get"}
    return time if known.issuperset(said) and not (so | {"do", "doing"}).isdisjoint(said) else start


def openings_inside(words: Sequence[Word], times: AbstractSet[int], lexicon: Lexicon) -> Iterator[Span]:
    """Give the stretches that open an order behind a time or a comma: "at noon, why don't you …"."""
    apart = lexicon.closed.joints_of_orders | lexicon.closed.universal_pronouns | lexicon.machines
    addresses = (lexicon.addresses - apart) | {"please"}
    for place in range(1, len(words) - 1):
        if place in times or (place - 1 not in times and words[place - 1].text != ","):
            continue
        form = longest_match(words, place, lexicon.questions["suggesting"])
        form = (words[place].text,) if form is None and words[place].text in addresses else form
        # "The library closes at six, can you take these back"
        form = form or _can_you(words, place, lexicon)
        if not form and place - 1 in times and _is_only_then(words, place, times, lexicon):
            form = words[place].text, words[place + 1].text
        end = place + len(form)
        if form and end < len(words) and words[end].is_letters | (words[end].text == ","):
            yield words[place].start, words[end - 1].end


def requests_behind(
    words: Sequence[Word], times: Mapping[int, int], lexicon: Lexicon
) -> Iterator[tuple[int, int]]:
    """Give where what was asked ends, and a further request begins: "… before eleven | oh and | can you …".

    It stands behind a joint, or behind a time that ends the first; the time in front of it is its own: "and
    at six could you …". ``times`` are ends by starts.
    """
    inside = {place for first, end in times.items() for place in range(first, end)}
    starts = {end: first for first, end in times.items()}
    # What "then" leads is cut there.
    joints = lexicon.closed.joints_of_orders - {"or", "then"}
    begun = behind_opening(words, 0, len(words), times.keys(), lexicon)
    for place in range(begun + 1, len(words) - 1):
        form = () if place in inside else _request_at(words, place, lexicon)
        behind = place + len(form)
        if not form or behind >= len(words) or not words[behind].is_letters:
            continue
        for opening in sorted({starts.get(place, place), place}):
            start = opening
            while start > begun and words[start - 1].text in joints | lexicon.addresses:
                start -= 1
            joined = not joints.isdisjoint(word.text for word in words[start:opening])
            timed = opening == place and start - 1 in inside
            said = [at for at in range(begun, start) if at not in inside]
            if not any(words[at].is_letters for at in said):
                continue
            # "When it's hot and I have to …"; but nobody asks in a clause: "…, and can you …".
            told = form[0] not in lexicon.closed.requesting_modals and _holds_clause(words, said, lexicon)
            # "She said at six I have to call"
            told = told or (timed and words[said[-1]].text in lexicon.doing.saying)
            if (joined or timed) and not told:
                yield start, opening
                break


def _holds_clause(words: Sequence[Word], places: Sequence[int], lexicon: Lexicon) -> bool:
    """Whether a condition or a reason begins at one of some places."""
    reasons = lexicon.closed.subordinators_of_reason
    return any(
        words[place].text in reasons or longest_match(words, place, lexicon.clauses) is not None
        for place in places
    )


def _request_at(words: Sequence[Word], place: int, lexicon: Lexicon) -> tuple[str, ...]:
    """Give the words at a place that ask somebody for what is behind them: "can you", "do you mind"."""
    asked = _can_you(words, place, lexicon)
    form = longest_match(words, place, lexicon.questions["suggesting"]) or ()
    if not asked and len(form) > CAN_YOU and form[0] != "if":
        return form
    return asked or longest_match(words, place, lexicon.questions["obliging"]) or ()


def _can_you(words: Sequence[Word], place: int, lexicon: Lexicon) -> tuple[str, ...]:
    """Give the words at a place that ask "can you"; none where they do not."""
    modal, *whom = (word.text for word in words[place : place + CAN_YOU])
    asks = modal in lexicon.closed.requesting_modals and not lexicon.closed.second_person.isdisjoint(whom)
    return (modal, *whom) if asks else ()


def _is_only_then(words: Sequence[Word], place: int, times: AbstractSet[int], lexicon: Lexicon) -> bool:
    """Whether it is said who may do it only then: "not until noon | should you open the valve"."""
    closed = lexicon.closed
    first = place - 1
    while first - 1 in times:
        first -= 1
    limited = first == 0 and words[0].text in closed.negators | closed.limiting
    whom = closed.personal_pronouns | closed.indefinite_pronouns
    return limited and words[place].text in closed.inverted_auxiliaries and words[place + 1].text in whom


def lengths_in_front(words: Sequence[Word], phrases: Sequence[Phrase], lexicon: Lexicon) -> Iterator[Span]:
    """Give each length of what is named behind it: "two hours of coding", "30 seconds plank"."""
    for phrase in phrases:
        before = words[phrase.first - 1].text if phrase.first else "then"
        leads = not before.isalnum() or before in {"and", "then"} | lexicon.beside.of_hours
        said = words[phrase.end].text if phrase.end < len(words) else ""
        if not leads or not isinstance(phrase.said.time, Duration) or phrase.said.preposition is not None:
            continue
        if said == "of" and phrase.end < len(words) - 1:
            yield phrase.span[0], words[phrase.end].end
        elif said.isalpha() and said not in lexicon.function_words:
            yield phrase.span


def _is_somewhere(words: Sequence[Word], place: int, times: AbstractSet[int], lexicon: Lexicon) -> bool:
    """Whether everybody is said to be somewhere, and nobody is asked: "everyone out by ten"."""
    everybody = words[place].text in lexicon.addresses & lexicon.closed.universal_pronouns
    return everybody and place + 1 not in times and words[place + 1].text in lexicon.beside.states


def _asked_before(words: Sequence[Word], place: int, times: AbstractSet[int], lexicon: Lexicon) -> int | None:
    """Give the time behind which somebody is asked to do something: "can you by seven feed the cat"."""
    asked = _can_you(words, place, lexicon)
    time = place + len(asked)
    time += time < len(words) and words[time].text == "please"
    return time if asked and time in times else None


def _counts(word: Word, lexicon: Lexicon) -> bool:
    return word.is_digits or word.text in lexicon.numbers


def before_courtesies(
    words: Sequence[Word], start: int, end: int, times: Mapping[int, int], lexicon: Lexicon
) -> int:
    """Give where an order ends: "thanks" behind it is no part of it, nor "love" right behind its time."""
    behind = {stop for first, stop in times.items() if first > start}
    while end > start + 1:
        said = [f for f in lexicon.courtesies if _ends_with(words, start, end, f)]
        said += [
            f for f in lexicon.called_behind if end - len(f) in behind and _ends_with(words, start, end, f)
        ]
        if not said and words[end - 1].text != ",":
            break
        end -= max(map(len, said), default=1)
    return end


def _ends_with(words: Sequence[Word], start: int, end: int, form: tuple[str, ...]) -> bool:
    """Whether a stretch of words ends with a form, and holds more."""
    first = end - len(form)
    ends = words[end - 1].text == form[-1] and first > start
    return ends and tuple(word.text for word in words[first:end]) == form
