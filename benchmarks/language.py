"""Time the language, and grade it beside other readers of time, on given corpora.

``FUZZYTIME_CORPORA=FOLDER PYTHONPATH=.:cli python benchmarks/language.py``. The folder holds ``grade.py``,
``time_phrases.jsonl`` and ``instructions.jsonl``; without it, only speed is measured. dateparser and
parsedatetime are graded where they are installed; both read points only. "strict" is the paper's own reading:
the oblique temporal modifier of the root verb.
"""

import importlib.util
import json
import os
import runpy
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from datetime import datetime
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any

from fuzzytime.language import Language, Token, answer, find_times

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - a naive wall clock is what the corpora have
PHRASES = (
    "in about ten minutes",
    "no later than half past six tomorrow evening",
    "every other day at noon until friday",
    "shortly before 5:30 pm",
    "between ten and a quarter to twelve",
    "soon",
    "on the first monday of march at 15h30",
)
SENTENCES = (
    "Flip the pancakes in the pan in about two minutes",
    "boil the eggs for eight minutes starting in a quarter of an hour",
    "Stir the soup when the pan is very hot and add the salt",
    "remind me to call mum tomorrow at noon",
)
SUBSETS = ("core", "near48", "fuzzy", "nontime")

Answers = list[dict[str, Any]]
Peer = Callable[[str, datetime], Answers]


def main() -> None:
    """Print the tables."""
    speed()
    folder = os.environ.get("FUZZYTIME_CORPORA")
    if folder is None:
        print("FUZZYTIME_CORPORA names no folder: nothing is graded")
        return
    grade = runpy.run_path(str(Path(folder) / "grade.py"))
    grade_phrases(grade, rows(Path(folder) / "time_phrases.jsonl"))
    grade_instructions(grade, rows(Path(folder) / "instructions.jsonl"))


def rows(path: Path) -> Answers:
    """Read lines of JSON."""
    return [json.loads(line) for line in path.read_text("utf-8").splitlines()]


# -- speed ----------------------------------------------------------------------------------------------


def speed() -> None:
    """Time phrases by the grammar, sentences with the model, and one call of the program."""
    find_times(PHRASES[0], NOW)
    # Those read last are remembered: each text is another one, by the spaces behind it.
    phrases = [f"{text}{' ' * spaces}" for spaces in range(200) for text in PHRASES]
    taken = [timed(partial(find_times, text, NOW)) for text in phrases]
    print(f"a phrase by the grammar             {statistics.median(taken) * 1000:8.2f} ms, median")
    print(f"                                    {quantile(taken, 0.95) * 1000:8.2f} ms, 95th percentile")
    language = Language.shipped()
    language.read(SENTENCES[0], now=NOW)
    texts = [(f"{text} {number}", NOW) for number in range(100) for text in SENTENCES]
    seconds = timed(lambda: language.read_independent(texts))
    print(f"a sentence of a file, with the model{seconds / len(texts) * 1000:8.2f} ms")
    with tempfile.TemporaryDirectory() as folder:
        calls = [timed(lambda: one_call(Path(folder))) for _ in range(6)]
    print(f"one call of the program, first      {calls[0]:8.2f} s")
    print(f"one call of the program, parse known{statistics.median(calls[1:]):8.2f} s")


def timed(act: Callable[[], object]) -> float:
    """Give the seconds that something takes."""
    start = time.perf_counter()
    act()
    return time.perf_counter() - start


def quantile(values: Sequence[float], share: float) -> float:
    """Give the value below which a share of values lies."""
    return sorted(values)[int(share * (len(values) - 1))]


def one_call(folder: Path) -> None:
    """Run ``fuzzytime parse`` on one sentence, with a cache of parses in a folder."""
    command = [sys.executable, "-m", "fuzzytime_cli", "parse", "--jsonl", "-"]
    environment = {**os.environ, "FUZZYTIME_CACHE": str(folder)}
    asked = json.dumps({"text": SENTENCES[0], "now": NOW.isoformat()})
    subprocess.run(command, input=asked, env=environment, text=True, check=True, capture_output=True)


# -- phrases --------------------------------------------------------------------------------------------


def grade_phrases(grade: dict[str, Any], cases: Answers) -> None:
    """Print the share of right readings by subset and reader."""
    sure = {"none", "duration"}
    asked = [
        case
        for case in cases
        if case["kind"] != "set"
        and (case["kind"] in sure or grade["moment"](case["start"]) or grade["moment"](case["end"]))
    ]
    texts = [(case["text"], datetime.fromisoformat(case["reference"][:19])) for case in asked]
    said = {"fuzzytime": [answer(reading) for reading in Language.shipped().read_independent(texts)]}
    for name, peer in peers().items():
        said[name] = [{"requirements": peer(text, now)} for text, now in texts]
    print(f"\n{'time phrases':18}" + "".join(f"{name:>16}" for name in said) + f"{'cases':>8}")
    for subset in SUBSETS:
        places = [place for place, case in enumerate(asked) if subset in case["tags"]]
        share = {
            name: statistics.fmean(grade["phrase_is_right"](asked[p], found[p]) for p in places)
            for name, found in said.items()
        }
        line(subset, share.values(), len(places))
    precision, places = [], [place for place, case in enumerate(asked) if "near48" in case["tags"]]
    for found in said.values():
        answered = [p for p in places if found[p]["requirements"]]
        precision.append(statistics.fmean(grade["phrase_is_right"](asked[p], found[p]) for p in answered))
    line("precision near48", precision, len(places))


def line(name: str, shares: Any, count: int) -> None:  # noqa: ANN401 - any iterable of shares
    """Print a row of a table."""
    print(f"{name:18}" + "".join(f"{share:16.3f}" for share in shares) + f"{count:8}")


def peers() -> dict[str, Peer]:
    """Give the other readers that are installed."""
    known = {"dateparser": dateparser_reading, "parsedatetime": parsedatetime_reading}
    return {name: peer for name, peer in known.items() if importlib.util.find_spec(name) is not None}


def dateparser_reading(text: str, now: datetime) -> Answers:
    """Read with dateparser: the whole text, else the first time it finds inside."""
    settings = {"RELATIVE_BASE": now, "PREFER_DATES_FROM": "future"}
    whole = import_module("dateparser").parse(text, languages=["en"], settings=settings)
    if whole is not None:
        return [point(text, whole)]
    found = import_module("dateparser.search").search_dates(text, languages=["en"], settings=settings) or []
    return [point(words, moment) for words, moment in found]


def parsedatetime_reading(text: str, now: datetime) -> Answers:
    """Read with parsedatetime."""
    found = import_module("parsedatetime").Calendar().nlp(text, sourceTime=now) or ()
    return [point(words, moment) for moment, _, _, _, words in found]


def point(words: str, moment: datetime) -> dict[str, str]:
    """Give a point as a requirement."""
    said = moment.replace(tzinfo=None, microsecond=0).isoformat()
    return {"text": words, "earliest": said, "latest": said}


# -- instructions ---------------------------------------------------------------------------------------


def grade_instructions(grade: dict[str, Any], cases: Answers) -> None:
    """Print the share of instructions whose time words, verb, and both are right."""
    asked = [case for case in cases if not case["verb_or_action"].startswith("action:")]
    readings = Language.shipped().read_independent([(case["text"], NOW) for case in asked])
    said = {"fuzzytime": [answer(reading) for reading in readings]}
    said["strict"] = [
        strict(reading.text, reading.tokens, reading.strict.verb, reading.strict.modifier)
        for reading in readings
    ]
    for name, peer in peers().items():
        said[name] = [{"requirements": peer(case["text"], NOW)} for case in asked]
    print(f"\n{'instructions':18}" + "".join(f"{name:>16}" for name in said) + f"{'cases':>8}")
    verdicts = {
        name: [grade["instruction_is_right"](c, a) for c, a in zip(asked, found, strict=True)]
        for name, found in said.items()
    }
    line("time words", (statistics.fmean(span for span, _ in v) for v in verdicts.values()), len(asked))
    line("verb", (statistics.fmean(verb for _, verb in v) for v in verdicts.values()), len(asked))
    line("both", (statistics.fmean(all(pair) for pair in v) for v in verdicts.values()), len(asked))


def strict(text: str, tokens: Sequence[Token], verb: int | None, modifier: int | None) -> dict[str, Any]:
    """Give the paper's reading of a text: the words below the modifier, and the root verb."""
    found: dict[str, Any] = {"requirements": [], "operation": None}
    if verb is not None:
        found["operation"] = {"verb": tokens[verb].text.lower()}
    if modifier is not None:
        below = {modifier}
        while more := {p for p, t in enumerate(tokens) if t.head in below} - below:
            below |= more
        first, last = tokens[min(below)], tokens[max(below)]
        found["requirements"] = [{"text": text[first.span[0] : last.span[1]]}]
    return found


if __name__ == "__main__":
    main()
