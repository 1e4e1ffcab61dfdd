"""What is done again, with another thing or at another time: "feed the cat at eight and the dog at nine"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.english import looks_plural, singular
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation, Span, overlap
from fuzzytime.language.meaning.expressions import Repeat, Said, Wall
from fuzzytime.language.sentence.segments.other_cases import OTHER_CASE
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.language.sentence.sketches.sketch import Sketch, text_between
from fuzzytime.language.sentence.trees.named import takes_verb
from fuzzytime.language.sentence.verbs.places import says_where
from fuzzytime.requirement import Constraint

AGAIN = frozenset({"then", OTHER_CASE})
"""Connectives behind which what is done before may be done again: "if it's dry at six, otherwise at nine"."""

TWO = 2


def done_again_of(before: Operation, sketch: Sketch, text: str) -> Operation | None:
    """Give the operation before with what is said anew; None where a sketch has its own, or says nothing."""
    lexicon = sketch.lexicon
    closed = lexicon.closed
    part = sketch.part
    said = _beside_times(sketch, text)
    rest = text[said[0][0] : said[-1][1]] if said else ""
    own = [span for span in said if span[0] >= part.segment.span[0]]
    anew = text[own[0][0] : own[-1][1]] if own and sketch.heard else ""
    if tuple(anew.lower().split()) in lexicon.conversation["again"]:
        # "Feed the cat at eight and the same again at nine", "baste the roast and repeat this every hour"
        return replace(before, again=True)
    value = _valued_again(before, anew, lexicon) if sketch.phrases else None
    if value is not None or (rest and part.segment.entry):
        return value
    shortly = _said_shortly(before, rest, lexicon) if sketch.heard else None
    if shortly is not None:
        return shortly
    said_again = sketch.operation
    if said_again is not None and _is_it_after_all(before, said_again, lexicon) and sketch.phrases:
        # "Don't water the plants today, do it tomorrow"
        return replace(before, negated=False)
    then = part.segment.connective in AGAIN
    counted = _counted_again(before, rest, lexicon) if sketch.phrases else None
    if (then or part.segment.verbless) and counted is not None and (said_again is None or said_again.stated):
        return counted
    things = said_again is not None and _names_several(before, said_again, rest, sketch)
    if sketch.operation is not None and not things and not _is_next_numbered(before, sketch):
        return None
    goes_on = any(_goes_on(phrase.said) for phrase in sketch.phrases)
    goes_on = goes_on and not _follows_length(text[: before.span[0]], lexicon)
    opener = rest.partition(" ")[0]
    thing = opener.lower() in closed.noun_openers or f" {opener} " in (before.object or "")
    if then and sketch.phrases and (not rest or (goes_on and not thing)):
        # "Feed the cat at nine, then at five", "then for five minutes on high"; but "then the dog for ten"
        return replace(before, place=rest or before.place)
    if rest and part.segment.verbless:
        placed = _placed_again(before, rest, lexicon)
        if placed is not None or (before.object is None and before.place is not None):
            return placed
    if not rest or before.object is None:
        return None
    first = text[slice(*part.span(part.tree.nodes[0]))]
    return _with_another_thing(before, before.object, rest, first, sketch)


def all_again(found: Sequence[Sketch], sketch: Sketch, text: str) -> list[Sketch] | None:
    """Give what was said before with a time that is of several of it; None where none is.

    "Walk the pug at noon and the beagle at one and both again at seven"; but "rent on the first, gas on the
    tenth, all at nine" says when on those days.
    """
    closed = sketch.lexicon.closed
    said = [text[slice(*span)].lower() for span in _beside_times(sketch, text)]
    named = [word for word in said if word not in closed.adverbs_of_repetition | {"do", ","}]
    if len(named) != 1 or named[0] not in closed.wholes | closed.both or not sketch.phrases:
        return None
    before: list[Sketch] = []
    for one in reversed(found):
        done = one.operation is not None and not one.operation.negated
        ended = not ENDS.isdisjoint(text_between(one, (before or [sketch])[0], text))
        if not done or not one.phrases or ended:
            break
        before.insert(0, one)
    before = before[-TWO:] if named[0] in closed.both else before
    if not before:
        return None
    clock = sketch.phrases[0].said.time
    if isinstance(clock, Wall) and clock.days is None and all(map(_is_on_day, before)):
        days = ((one, one.phrases[0]) for one in before)
        timed = (replace(one, phrases=(p.at(replace(clock, days=p.said.wall.days)),)) for one, p in days)
        return [*found[: -len(before)], *timed]
    told = replace(sketch, joints=(*sketch.joints, sketch.part.segment.span))
    return [*found, *(replace(told, operation=one.operation) for one in before)]


def _is_on_day(sketch: Sketch) -> bool:
    """Whether all that is said of when is the day."""
    wall = sketch.phrases[0].said.wall
    return len(sketch.phrases) == 1 and wall.days is not None and not wall.is_timed


def _beside_times(sketch: Sketch, text: str) -> list[Span]:
    """Give the words of a sketch that are about no time, without a comma behind them."""
    spans = map(sketch.part.span, sketch.part.tree.nodes)
    said = [span for span in spans if not any(overlap(span, heard) for heard in sketch.heard)]
    while said and text[slice(*said[-1])] == ",":
        # "… and with Dominic at eleven, 45 minutes each"
        said.pop()
    return said


def _names_several(before: Operation, told: Operation, rest: str, sketch: Sketch) -> bool:
    """Whether what seems to be told names several things: "check the oil, then the tyre pressures at one"."""
    lexicon, (first, *named) = sketch.lexicon, rest.lower().split() or [""]
    doing = lexicon.doing
    acts = lexicon.intransitive | lexicon.timing | lexicon.timing_alone | lexicon.orders
    moves = told.lemma in acts or not (doing.timed | doing.moments | lexicon.people).isdisjoint(named)
    several = len(named) > 1 and looks_plural(named[-1]) and first in lexicon.closed.noun_openers
    asked = before.object is not None and not before.stated and sketch.part.segment.connective in AGAIN
    return asked and told.stated and several and not moves


def _with_another_thing(
    before: Operation, old: str, rest: str, first: str, sketch: Sketch
) -> Operation | None:
    """Give the operation before with another thing, which begins so: "dust the hall, then the stairs"."""
    then, verbless = sketch.part.segment.connective in AGAIN, sketch.part.segment.verbless
    openers, people = sketch.lexicon.closed.noun_openers, sketch.lexicon.persons
    opened = first.lower() in openers
    alike = old.partition(" ")[0].lower() in openers or rest.rpartition(" ")[2].lower() in people
    if before.stated and before.complement is not None and sketch.phrases and opened and not alike:
        # "Mum takes her drops at seven, the tablets at noon"; but "Tom cleans up tonight, the kids tomorrow"
        return replace(before, complement=rest.removesuffix(" again"))
    if before.stated and before.complement is not None and sketch.phrases and not opened:
        # "She has toast at seven and soup at noon"; but "Ann has maths at ten and Bob at eleven"
        known = sketch.lexicon.closed.personal_pronouns | openers | sketch.lexicon.people
        whose = old.partition(" ")[0].lower() in known or old[:1].isupper()
        bare = before.complement.partition(" ")[0].lower() not in openers
        if whose and bare and not first[:1].isupper() and rest.lower() not in people | sketch.lexicon.people:
            return replace(before, complement=rest.removesuffix(" again"))
    # "Interview with Priya at ten, then with Dominic at eleven"
    head, joint, _ = old.partition(f" {first} ")
    joint = "" if opened else joint
    thing = opened or bool(joint) or _is_next_numbered(before, sketch)
    # "Call Ann at ten, then Bob"
    called = then and first[:1].isupper() and old[:1].isupper()
    if not ((thing or verbless) if sketch.phrases else ((thing or called) and then)):
        return None
    if not takes_verb(before.lemma, old, rest, sketch.lexicon):
        # "Ring Bob, then a nap"
        return None
    if joint:
        rest = f"{head} {rest}"
    # "Hand me the wrench, then the pliers"
    whom, more, _ = old.partition(" ")
    given = [whom] if more and whom.lower() in sketch.lexicon.closed.indirect_objects else []
    return replace(before, object=" ".join((*given, rest)), place=None)


def _said_shortly(before: Operation, rest: str, lexicon: Lexicon) -> Operation | None:
    """Give the operation before where a particle alone, or that it is done again, is said beside a time."""
    turned, _, level = rest.partition(" to ")
    particle = _particle_alone(before, turned, lexicon)
    timed = lexicon.happening | lexicon.taken | lexicon.closed.coming
    # "Flight at ten, up at six": that is who flies.
    happens = before.stated and before.particle is None and before.verb in timed
    if particle is not None and not happens:
        if before.place in lexicon.particles:
            # "Heating on at five, off at nine"
            return replace(before, place=rest)
        # "And back up to 37 degrees at six"
        return replace(before, particle=particle, place=f"to {level}" if level else before.place)
    return None


def _placed_again(before: Operation, rest: str, lexicon: Lexicon) -> Operation | None:
    """Give the operation before at another place; None where none is said."""
    if says_where(rest.lower(), lexicon):
        # "Hoover downstairs in the morning and upstairs after lunch"
        whole = says_where((before.object or "").lower(), lexicon)
        return replace(before, object=None if whole else before.object, place=rest, manner=None)
    led = rest.lower().split()[0]
    old, new = (before.place or "").split(), rest.split()
    if before.object is None and old[:1] and old[0].isdecimal() and new[0].isdecimal():
        # "Run 5 km at seven and 8 km at four"
        return replace(before, place=rest) if old[1:] == new[1:] else None
    # "Stop for a brew at ten and for lunch at noon"
    again = before.object is None and [led] == old[:1]
    return replace(before, place=rest) if again else None


def _counted_again(before: Operation, rest: str, lexicon: Lexicon) -> Operation | None:
    """Give the operation before with another number: "two pills now, then one at six", "… then one pill"."""
    words, (count, *named) = (before.object or "").split(), rest.lower().split() or [""]
    place = next(
        (p for p, word in enumerate(words) if word.lower() in lexicon.numbers or word.isdecimal()), None
    )
    if place is None or not (count in lexicon.numbers or count.isdecimal()):
        return None
    noun = words[place + 1 :]
    if named and [singular(word) for word in named] != [singular(word.lower()) for word in noun]:
        return None
    noun = [singular(noun[0]), *noun[1:]] if noun and count in {"one", "1"} else noun
    return replace(before, object=" ".join((*words[:place], rest.split(maxsplit=1)[0], *noun)))


def _valued_again(before: Operation, rest: str, lexicon: Lexicon) -> Operation | None:
    """Give the operation before with another value: "heating to eighteen at ten, twenty at six"."""
    led, _, value = (before.place or "").partition(" ")
    values = [one.lower().strip("%°").split() for one in (value, rest.removeprefix(f"{led} "))]
    numbered = all(words[:1] and (words[0].isdecimal() or words[0] in lexicon.numbers) for words in values)
    # "To 21 degrees at seven, 17 at eleven"; but "to 21 at seven, 17 chairs at eleven"
    alike = numbered and values[1][1:] in ([], values[0][1:])
    return replace(before, place=f"{led} {rest.removeprefix(f'{led} ')}") if alike else None


def _goes_on(said: Said) -> bool:
    """Whether the same goes on with it: "then for five minutes on high", "then every hour"."""
    return said.constraint is Constraint.FOR or isinstance(said.time, Repeat)


def _follows_length(text: str, lexicon: Lexicon) -> bool:
    """Whether what follows a text is named behind how long it goes on: "20 min | run, then 10 min abs"."""
    return any(lexicon.means(word.lower(), "unit") for word in text.split()[-1:])


def _is_next_numbered(before: Operation, sketch: Sketch) -> bool:
    """Whether it is another of what the one before is about: "do ward 7, then ward 9"."""
    first = sketch.part.tree.nodes[:2]
    named = (before.object or "").lower().split()
    return len(first) > 1 and first[1].tag == "CD" and first[0].lower in sketch.lexicon.machines & {*named}


def _particle_alone(before: Operation, text: str, lexicon: Lexicon) -> str | None:
    """Give the particle that is all that is said of a verb: "switch it on at six and off again at eight"."""
    words = text.lower().split()
    said = [word for word in words if word not in lexicon.closed.adverbs_of_repetition]
    # "Put the chairs out at eight, back at five"; but who leaves at eight is back at five.
    said = said or (words if before.object and before.verb == before.lemma else [])
    return said[0] if len(said) == 1 and said[0] in lexicon.particles else None


def _is_it_after_all(before: Operation, operation: Operation, lexicon: Lexicon) -> bool:
    """Whether "do it" asks for what was not to be done before."""
    does = operation.lemma == "do" and (operation.object or "").lower() in lexicon.closed.singular_anaphors
    return does and before.negated and not operation.negated and not before.stated
