"""YAML is read as texts with places; hostile and broken files are refused, all mistakes at once."""

import contextlib
import time
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.documents.nodes import MAX_BYTES, MAX_DEPTH, Mapping, Reader, Scalar
from fuzzytime.errors import DocumentError, FuzzytimeError
from fuzzytime.spelling import suggestion
from fuzzytime.times import parse_duration


def mistakes_of(source: str | bytes) -> list[str]:
    """Places and messages of what is wrong with a document as such."""
    try:
        reader = Reader("f.yaml", source)
        reader.root()
        reader.finish()
    except DocumentError as error:
        return [f"{mistake.line}:{mistake.column} {mistake.message}" for mistake in error.mistakes]
    return []


@pytest.mark.parametrize(
    "text", ["on", "no", "yes", "~", "1:30", "1e3", "08", "0o10", "2026-11-21", "1_000", ".inf"]
)
def test_scalars_stay_the_text_that_was_written(text: str) -> None:
    reader = Reader("f.yaml", f"{text}: {text}")
    assert reader.mapping(reader.root(), "")[text] == Scalar(text, 0, len(text) + 2, len(text) + 2)


TAB = "lines must be indented by spaces, got a tab"
UNCLOSED = "'[' is not closed: did not find expected ',' or ']'"


@pytest.mark.parametrize(
    ("source", "mistakes"),
    [
        ("", ["1:1 the file must not be empty"]),
        ("# nothing\n", ["1:1 the file must not be empty"]),
        (
            "a: &x 1\nb: *x\n",
            ["1:4 anchors are not allowed, got '&x'", "2:4 aliases are not allowed, got '*x'"],
        ),
        (
            "a: !!python/object/apply:os.system [ls]",
            ["1:4 tags are not allowed, got '!!python/object/apply:os.system'"],
        ),
        ("a: !mine 1", ["1:4 tags are not allowed, got '!mine'"]),
        ("<<: {a: 1}\nb: 2", ["1:1 merge keys are not allowed, got '<<'"]),
        ("a: 1\n---\nb: 2", ["2:1 a file must hold one document"]),
        ("? [a, b]\n: c", ["1:3 a key must be a text, got a list or a mapping"]),
        ("a:\n\t- 1", [f"2:1 not valid YAML: {TAB}"]),
        ("a: \x00", ["1:4 not valid YAML: control characters are not allowed"]),
        ("b: 1\na: b: c", ["2:5 not valid YAML: mapping values are not allowed in this context"]),
        (b"k: v\na: \xff", ["2:4 text must be UTF-8, got byte 0xff"]),
        ("a: [1, 2", [f"1:4 not valid YAML: {UNCLOSED}"]),
        ("a: " + "x" * MAX_BYTES, [f"1:1 a file must not be larger than {MAX_BYTES:,} bytes"]),
    ],
)
def test_what_is_not_allowed_is_placed(source: str | bytes, mistakes: list[str]) -> None:
    assert mistakes_of(source) == mistakes


NESTED = {
    "lists": "[" * 3000 + "]" * 3000,
    "mappings": "{a: " * 3000 + "}" * 3000,
    "blocks": "\n".join("  " * depth + "- " for depth in range(200)),
    "keys": "? " * 100_000,
    "unclosed": "[" * 1_000_000,
}


@pytest.mark.parametrize("source", NESTED.values(), ids=NESTED)
def test_deep_nesting_is_refused_without_being_followed(source: str) -> None:
    (mistake,) = mistakes_of(source)
    assert mistake.endswith(f"nesting must not be deeper than {MAX_DEPTH}")


def test_a_bomb_of_aliases_is_only_its_text() -> None:
    bomb = "\n".join(
        f"{name}: &{name} [{', '.join(f'*{before}' for _ in range(9))}]"
        for before, name in zip("abcdefgh", "bcdefghi", strict=True)
    )
    reader = Reader("f.yaml", "a: &a [x, x]\n" + bomb)
    reader.root()
    assert len(reader.mistakes) == 9 + 8 * 9


def test_too_many_values_are_refused() -> None:
    assert mistakes_of("a: 1\n" * 30_000) == ["20001:1 a file must not have more than 20,000 lines"]
    assert mistakes_of("[" + "1," * 30_000 + "]") == ["1:32000 a file must not hold more than 16,000 values"]


def test_an_alias_is_reported_once_and_the_rest_of_the_file_is_read() -> None:
    reader = Reader("f.yaml", "a: *x\nb: {c: 1, d: 2}\ne: [1, f]\n")
    found = reader.mapping(reader.root(), "")
    for read in (
        reader.number,
        reader.duration,
        reader.string,
        reader.mapping,
        reader.sequence,
        reader.boolean,
    ):
        read(found["a"], "a")
    reader.mapping(found["b"], "b", ("c",))
    for i, item in enumerate(reader.sequence(found["e"], "e")):
        reader.number(item, f"e[{i}]")
    assert [f"{m.line}:{m.column} {m.key}" for m in reader.mistakes] == ["1:4 ", "2:11 b.d", "3:8 e[1]"]


def test_keys_are_known_required_and_differ() -> None:
    reader = Reader("f.yaml", "name: x\nwieght: 2\nname: y\n")
    found = reader.mapping(reader.root(), "rule", ("name", "weight", "then"), ("then",))
    assert list(found) == ["name"]
    assert [(m.line, m.column, m.message) for m in reader.mistakes] == [
        (2, 1, "unknown key 'wieght' (did you mean 'weight'?)"),
        (3, 1, "keys must differ, got 'name' as on line 1"),
        (1, 1, "missing key 'then'"),
    ]


def test_values_convert_or_are_placed() -> None:
    reader = Reader("f.yaml", "{n: 1e3, w: 4, d: 1h30, c: red, s: [a, b], b: true, x: hot, y: 9, z: [1]}")
    found = reader.mapping(reader.root(), "")
    assert reader.number(found["n"], "n") == 1000
    assert reader.whole(found["w"], "w", 0, 9) == 4
    assert reader.duration(found["d"], "d") == 5400
    assert reader.choice(found["c"], "c", ("red", "blue")) == "red"
    assert reader.strings(found["s"], "s") == ("a", "b")
    assert reader.strings(found["c"], "c") == ("red",)
    assert reader.boolean(found["b"], "b") is True
    reader.finish()
    assert reader.number(found["x"], "x") == 0
    assert reader.whole(found["n"], "n", 0, 9) == 0
    assert reader.number(found["y"], "y", 0, 5) == 0
    assert reader.string(found["z"], "z") == ""
    assert reader.choice(found["x"], "x", ("hut", "cold")) == ""
    assert reader.sequence(found["z"], "z", 2) == ()
    with pytest.raises(DocumentError) as caught:
        reader.finish()
    assert [m.message for m in sorted(caught.value.mistakes, key=lambda m: m.key)] == [
        "must be a whole number, got '1e3'",
        "must be a number, got 'hot'",
        "must be one of the known words, got 'hot' (did you mean 'hut'?)",
        "must be between 0 and 5, got '9'",
        "must be a text, got a list",
        "must hold 2 items, got 1",
    ]


def test_a_mistake_shows_its_line_with_a_caret() -> None:
    reader = Reader("kitchen.yaml", "rules:\n  - if: pan is hto\n")
    rules = reader.mapping(reader.root(), "")["rules"]
    condition = reader.mapping(reader.sequence(rules, "rules")[0], "rules[0]")["if"]
    reader.mistake(condition, "rules[0].if", "'pan' has no term 'hto'", offset=7)
    assert str(reader.mistakes[0]) == (
        "kitchen.yaml:2:16: rules[0].if: 'pan' has no term 'hto'\n"
        "      - if: pan is hto\n"
        "                   ^"
    )


@pytest.mark.parametrize(
    ("source", "place"),
    [
        ("a: one two", (1, 8)),
        ('a: "one two"', (1, 9)),
        ("a: 'one two'", (1, 9)),
        ("a: |\n  one two\n", (2, 7)),
        ("a: >\n  one\n  two\n", (3, 3)),
        ("a: one\n  two\n", (2, 3)),
    ],
)
def test_a_place_inside_a_text_is_found_however_it_is_written(source: str, place: tuple[int, int]) -> None:
    reader = Reader("f.yaml", source)
    node = reader.mapping(reader.root(), "")["a"]
    reader.mistake(node, "a", "here", offset=4)
    assert (reader.mistakes[0].line, reader.mistakes[0].column) == place


def test_other_line_ends_do_not_move_places() -> None:
    reader = Reader("f.yaml", "a: 1\r\nb\u2028c: 2\rd: x\x85y\n")
    assert [(key.text, key.line) for key in reader.keys(reader.root()).values()] == [
        ("a", 0),
        ("b c", 1),
        ("d", 2),
    ]


def test_a_file_is_called_as_shown(tmp_path: Path) -> None:
    path = tmp_path / "f.yaml"
    path.write_bytes(b"\xef\xbb\xbfa: 1\n")
    reader = Reader.of_file(path, "rules/f.yaml")
    assert reader.place(reader.root()) == "rules/f.yaml:1"
    assert list(reader.mapping(reader.root(), "")) == ["a"]


def test_a_conversion_s_error_becomes_a_mistake() -> None:
    reader = Reader("f.yaml", "soon")
    node = reader.root()
    assert isinstance(node, Scalar)
    assert reader.read(node, "t", parse_duration) is None
    assert reader.mistakes[0].key == "t"


def test_suggestions_name_the_near_or_the_known() -> None:
    assert suggestion("hto", ["hot", "cold"]) == " (did you mean 'hot'?)"
    assert suggestion("xyz", ["hot", "cold"]) == " (known: cold, hot)"
    assert suggestion("xyz", []) == ""


@given(st.text(max_size=200))
def test_any_text_is_a_tree_or_a_document_error(text: str) -> None:
    reader = Reader("f.yaml", text)
    try:
        node = reader.root()
    except FuzzytimeError:
        return
    assert isinstance(node, Scalar | Mapping) or node.items is not None


@given(st.binary(max_size=200))
def test_any_bytes_are_a_tree_or_a_document_error(raw: bytes) -> None:
    with contextlib.suppress(FuzzytimeError):
        Reader("f.yaml", raw).root()


def test_hostile_files_are_refused_at_once() -> None:
    # No benchmark: a second is a hundred times what they need, and a thousandth of what a follower would.
    started = time.perf_counter()
    for source in NESTED.values():
        mistakes_of(source)
    assert time.perf_counter() - started < 5
