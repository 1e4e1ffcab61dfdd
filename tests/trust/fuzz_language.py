"""Fuzz the language: random texts through the grammar, and through the whole road; print what was counted.

    python tests/trust/fuzz_language.py --grammar 1000000 --road 20000 --seed 1

Texts are random unicode, words of the tables in random order, sentences cut, joined and damaged. A text
must give a reading or an `InstructionError`, within a time limit; every ψ that comes of it must be finite
and in [0, 1]. The same seed gives the same texts. Exit status 1 if anything failed.
"""

import argparse
import random
import sys
import time
import traceback
from collections.abc import Iterator
from datetime import UTC, datetime
from zoneinfo import ZoneInfo

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import find_times, shipped_lexicon

SENTENCES = (
    "flip the pancakes in about two minutes, then set the table",
    "boil the eggs for eight minutes starting in a quarter of an hour",
    "don't open the oven before 6 pm on friday the 13th",
    "water the plants every other day at half past nine until the end of the month",
    "meet me between 10:30 and a quarter to twelve tomorrow, no, on monday",
    "five minutes before you serve the soup, toast the bread; meanwhile feed the cat",
    "call back the first tuesday of march 2031 at 15h30 or so, shortly before noon at the latest",
    "within the next 3 to 5 hours, less than two weeks after christmas, at 3pm PST",
    "when the pan is very hot add some oil, at five, I mean six sharp",
)
SLOW = 2.0
"""Seconds of processor time that one text of at most a few hundred characters may take."""

NOWS = (
    datetime(2026, 3, 4, 9),  # noqa: DTZ001
    datetime(2026, 3, 29, 1, 59, 59, tzinfo=ZoneInfo("Europe/Berlin")),
    datetime(2026, 10, 25, 2, 30, fold=1, tzinfo=ZoneInfo("Europe/Berlin")),
    datetime(2024, 2, 29, 23, 59, tzinfo=UTC),
    datetime(1, 1, 2),  # noqa: DTZ001
    datetime(9999, 12, 30, 23, 59),  # noqa: DTZ001
    None,
)


def vocabulary() -> list[str]:
    """Give every way to say something that the word tables have, and marks."""
    lexicon = shipped_lexicon()
    said = {" ".join(entry.words) for entries in lexicon.entries.values() for entry in entries}
    said |= set(lexicon.numbers) | set(lexicon.ordinals) | {" ".join(form) for form in lexicon.clauses}
    said |= {" ".join(form) for form in lexicon.connectives}
    marks = [*",.;-–/:'\"()%~½８\u202e\ud800\x00", "\x1b[31m"]
    return sorted(said) + marks * 3


def texts(count: int, seed: int) -> Iterator[str]:
    """Give texts, the same for the same seed."""
    chance = random.Random(seed)
    words = vocabulary()
    for _ in range(count):
        kind = chance.randrange(6)
        if kind == 0:
            yield "".join(chr(chance.randrange(0x110000)) for _ in range(chance.randrange(60)))
        elif kind == 1:
            yield " ".join(chance.choice(words) for _ in range(chance.randrange(1, 14)))
        elif kind == 2:
            yield chance.choice(("", " ", "-")).join(
                chance.choice((chance.choice(words), str(chance.randrange(10 ** chance.randrange(1, 12)))))
                for _ in range(chance.randrange(1, 12))
            )
        elif kind == 3:
            sentence = chance.choice(SENTENCES)
            first = chance.randrange(len(sentence))
            yield sentence[first : first + chance.randrange(len(sentence))]
        elif kind == 4:
            yield _damaged(chance, chance.choice(SENTENCES))
        else:
            yield chance.choice((" ", ", ", " and ", ". ")).join(
                chance.choice(SENTENCES)[: chance.randrange(1, 60)] for _ in range(chance.randrange(1, 4))
            )


def _damaged(chance: random.Random, text: str) -> str:
    letters = list(text)
    for _ in range(chance.randrange(1, 8)):
        place = chance.randrange(len(letters))
        action = chance.randrange(3)
        if action == 0:
            letters[place] = chr(chance.randrange(0x3000))
        elif action == 1:
            letters[place] = ""
        else:
            letters.insert(place, str(chance.randrange(100)))
    return "".join(letters)


def check_grammar(text: str, now: datetime | None) -> None:
    """Find the times of a text: whatever it is, only a `FuzzytimeError` may come of it."""
    try:
        found = find_times(text, now)
    except FuzzytimeError:
        return
    for requirement in found.requirements:
        first, end = requirement.span
        if not 0 <= first < end <= len(text):
            raise AssertionError(f"a span must lie in its text, got {requirement.span}")
        for bound in (requirement.t_spec, requirement.earliest, requirement.latest):
            if bound is not None and not np.isfinite(bound):
                raise AssertionError(f"a bound must be finite, got {bound}")
        if requirement.recurrence is not None:
            requirement.recurrence.occurrences(2 * 86400.0)


def check_road(road: "Road", text: str, now: datetime | None) -> None:
    """Read a text, make its skills, evaluate their ψ."""
    from fuzzytime.interpreter import Request, SpokenWish

    given = now or NOWS[0]
    assert given is not None
    request = Request(now=given, wishes=(SpokenWish(text=text, given=given),))
    try:
        interpretation = road.interpreter.interpret(request)
    except FuzzytimeError:
        return
    for interpreted in interpretation.skills:
        values = interpreted.skill.satisfaction(road.times)
        if not (np.isfinite(values).all() and (values >= 0).all() and (values <= 1).all()):
            raise AssertionError("ψ must be finite and in [0, 1]")


class Road:
    """The interpreter, and times at which ψ is asked for."""

    def __init__(self) -> None:
        from fuzzytime.interpreter import Interpreter

        self.times = np.concatenate([np.linspace(-3600, 48 * 3600, 200), [0.0, 1e9]])
        self.interpreter = Interpreter.shipped()
        # Loading the model is not what is timed.
        check_road(self, "set the table", NOWS[0])


def run(name: str, count: int, seed: int, road: Road | None) -> int:
    """Run texts through one check; print the figure, give the number of failures."""
    chance = random.Random(seed + 1)
    failed = slow = 0
    longest = 0.0
    began = time.process_time()
    for text in texts(count, seed):
        now = chance.choice(NOWS)
        start = time.process_time()
        try:
            if road is None:
                check_grammar(text, now)
            else:
                check_road(road, text, now)
        except Exception:  # noqa: BLE001 - anything that escapes is what is looked for
            failed += 1
            if failed <= 5:
                print(repr(text), now)
                traceback.print_exc()
        taken = time.process_time() - start
        longest = max(longest, taken)
        slow += taken > SLOW
    seconds = time.process_time() - began
    print(
        f"{name}: {count:,} texts, seed {seed}, {failed} failures, {slow} over {SLOW:g} s, "
        f"longest {longest * 1000:.0f} ms, {seconds:.0f} s in all"
    )
    return failed + slow


def main() -> int:
    """Run what is asked."""
    plain = argparse.RawDescriptionHelpFormatter
    options = argparse.ArgumentParser(description=__doc__, formatter_class=plain)
    options.add_argument("--grammar", type=int, default=1_000_000, metavar="N")
    options.add_argument("--road", type=int, default=20_000, metavar="N")
    options.add_argument("--seed", type=int, default=1)
    chosen = options.parse_args()
    failures = run("grammar", chosen.grammar, chosen.seed, None) if chosen.grammar else 0
    if chosen.road:
        failures += run("whole road", chosen.road, chosen.seed, Road())
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
