"""Rule files are read whole: every mistake of every file in one run, each at its place."""

from pathlib import Path

import pytest

from fuzzytime.context import Context
from fuzzytime.documents.nodes import Reader
from fuzzytime.errors import DocumentError
from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime.resources import rules_directory
from fuzzytime.rulebook import Profile, Rulebook, check
from fuzzytime.rulebook.tables.documents import shipped_tables

SEEDED = Path(__file__).with_name("seeded_mistakes.yaml")


def seeded() -> tuple[str, list[tuple[int, int, str]]]:
    """The file without its marks, and where its mistakes are and how their messages begin."""
    expected: list[tuple[int, int, str]] = []
    lines = []
    for number, line in enumerate(SEEDED.read_text(encoding="utf-8").splitlines(), 1):
        text, _, messages = line.partition("  #! ")
        columns = []
        while "«" in text and messages:
            columns.append(text.index("«") + 1)
            text = text.replace("«", "", 1)
        if messages:
            found = zip(columns, messages.split(" ;; "), strict=True)
            expected += [(number, column, message) for column, message in found]
        lines.append(text)
    return "\n".join(lines), expected


def test_all_seeded_mistakes_are_located_in_one_run(tmp_path: Path) -> None:
    text, expected = seeded()
    path = tmp_path / "seeded.yaml"
    path.write_text(text, encoding="utf-8")
    found = [(mistake.line, mistake.column, mistake.message) for mistake in check([path])]
    assert len(expected) >= 60
    assert [mistake[:2] for mistake in found] == [seed[:2] for seed in expected]
    for mistake, seed in zip(found, expected, strict=True):
        assert mistake[2].startswith(seed[2])


def test_each_mistake_names_its_file_and_shows_its_line(tmp_path: Path) -> None:
    path = tmp_path / "mine.yaml"
    path.write_text(
        "fuzzytime: 1\nrules:\n  - name: flip-when-hot\n    if: pan is hto\n    then: {model: when}\n"
    )
    (mistake,) = check([path])
    assert str(mistake) == (
        f"{path}:4:16: rules[0](flip-when-hot).if: 'pan' has no term 'hto' (did you mean 'hot'?)\n"
        "        if: pan is hto\n"
        "                   ^"
    )


STOPS = {
    "syntax": ("rules: [1, 2\n", "not valid YAML"),
    "empty": ("# nothing\n", "the file must not be empty"),
    "documents": ("a: 1\n---\nb: 2\n", "a file must hold one document"),
    "depth": ("[" * 3000, "nesting must not be deeper than 32"),
    "size": ("#" * (1 << 21), "a file must not be larger than 1,048,576 bytes"),
    "a list": ("- 1\n", "must be a mapping (key: value), got a list"),
    "text": ("hello\n", "must be a mapping (key: value), got 'hello'"),
}


@pytest.mark.parametrize("name", STOPS)
def test_a_file_that_cannot_be_read_on_is_one_mistake(tmp_path: Path, name: str) -> None:
    text, message = STOPS[name]
    path = tmp_path / "broken.yaml"
    path.write_text(text)
    (mistake,) = check([path])
    assert message in mistake.message
    assert mistake.path == str(path)


def test_mistakes_of_all_files_come_together(tmp_path: Path) -> None:
    first, second, third = (tmp_path / f"{name}.yaml" for name in "abc")
    first.write_text("fuzzytime: 1\nplateau: x\n")
    second.write_bytes(b"\xff")
    third.write_text("fuzzytime: 1\nwords: {soon: {model: sono}}\n")
    with pytest.raises(DocumentError) as caught:
        Rulebook.shipped(files=[first, second, third])
    assert [mistake.path for mistake in caught.value.mistakes] == [str(first), str(second), str(third)]


def test_a_missing_file_is_a_mistake(tmp_path: Path) -> None:
    (mistake,) = check([tmp_path / "missing.yaml"])
    assert mistake.message.startswith("the file cannot be read: ")


def test_the_shipped_tables_hold_no_mistake() -> None:
    assert check([]) == ()
    for profile in Profile:
        assert Rulebook.shipped(profile).tables.models


def test_both_profiles_are_checked_whichever_is_chosen(tmp_path: Path) -> None:
    path = tmp_path / "mine.yaml"
    path.write_text("fuzzytime: 1\nprofiles: {study: {plateau: 7}, everyday: {plateau: 8}}\n")
    assert [mistake.key for mistake in check([path])] == [
        "profiles.study.plateau",
        "profiles.everyday.plateau",
    ]


def test_a_variable_of_nothing_is_a_mistake_at_its_place(tmp_path: Path) -> None:
    path = tmp_path / "nothing.yaml"
    path.write_text(
        "fuzzytime: 1\nvariables:\n  rung: {since: , terms: {long: {rising: [1 min, 2 min]}}}\n"
        "rules:\n  - if: rung is long\n    then: {t: 2 min}\n"
    )
    (mistake,) = check([path])
    assert (mistake.line, mistake.message) == (3, "must name a signal or an event")


def test_every_word_that_begins_a_clause_has_a_row() -> None:
    lexicon = Reader.of_file(rules_directory() / "lexicon.yaml")
    clauses = lexicon.mapping(lexicon.mapping(lexicon.root(), "")["clauses"], "clauses")
    kinds = {kind: forms for kind, forms in clauses.items() if kind != "source"}
    said = {form for kind, forms in kinds.items() for form in lexicon.strings(forms, kind)}
    tables = shipped_tables(Profile.EVERYDAY)
    # "Right after" is no clause's word but a hedge of one.
    assert said - tables.clauses.keys() - tables.prepositions.keys() <= tables.time_hedges.keys()


def test_words_have_no_case_and_names_may_have_any_letters(tmp_path: Path) -> None:
    path = tmp_path / "mine.yaml"
    path.write_text(
        """fuzzytime: 1
hedges: {term: {Really: {power: 2}}, time: {Kinda: {widen: 2}}}
words: {Soonish: {model: in, t: 0 s, hedge: Kinda}}
signals: {öl_temp: {unit: degC, range: [0, 300]}}
variables: {öl: {of: öl_temp, terms: {heiß: {rising: [100, 200]}}}}
rules:
  - {name: hot, on: {cue: Soonish, number: [3, 4]}, if: öl is Really heiß, then: {t: 1 min}}
  - {name: in-use, on: {cue: soonish}, if: öl is really heiß, then: {t: 2 min}}
""",
        encoding="utf-8",
    )
    rulebook = Rulebook.shipped(files=[path])
    said = TimeRequirement(text="soonish", span=(0, 7), constraint=Constraint.VAGUE, word="soonish")
    resolved = rulebook.resolve(said, Context.of({"öl_temp": 150.0}))
    assert [share.name for share in resolved.shares] == ["Soonish", "in-use"]
    assert resolved.shares[1].degree.low == pytest.approx(0.25)
    assert [effect.factor for effect in resolved.hedges] == [2.0]
    assert rulebook.tables.rules["hot"].match.accepted[1] == ("number", frozenset({"3", "4"}))
