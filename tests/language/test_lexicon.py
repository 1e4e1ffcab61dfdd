"""Word tables are read whole, and every mistake in them has its line and column."""

import re
from dataclasses import replace
from datetime import datetime
from pathlib import Path

import pytest

from fuzzytime.documents.nodes import Reader
from fuzzytime.errors import DocumentError
from fuzzytime.language import Language, Lexicon, find_times, shipped_lexicon
from fuzzytime.language.finding import shipped_grammar
from fuzzytime.language.grammar.lexicon.groups_beside_times import BesideTimes
from fuzzytime.language.grammar.lexicon.verb_groups import Doing
from fuzzytime.language.grammar.lexicon.word_groups import ClosedClasses
from fuzzytime.language.grammar.word_tables import read_lexicon
from fuzzytime.resources import rules_directory

LEXICON = (rules_directory() / "lexicon.yaml").read_text("utf-8")
ROOT = Path(__file__).parents[2]
CALENDAR = (rules_directory() / "calendar.yaml").read_text("utf-8")


def mistakes(tmp_path: Path, lexicon: str = LEXICON, calendar: str = CALENDAR) -> list[str]:
    """Give the mistakes of two files, without their folder."""
    (tmp_path / "lexicon.yaml").write_text(lexicon, "utf-8")
    (tmp_path / "calendar.yaml").write_text(calendar, "utf-8")
    try:
        read_lexicon(tmp_path / "lexicon.yaml", tmp_path / "calendar.yaml")
    except DocumentError as error:
        return [f"{Path(m.path).name}:{m.line}:{m.column}: {m.key}: {m.message}" for m in error.mistakes]
    return []


def test_the_shipped_tables_have_no_mistake(tmp_path: Path) -> None:
    assert mistakes(tmp_path) == []


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            "  by:              {constraint: before",
            "  by:              {constraint: beside",
            r"prepositions\.by\.constraint: must be one of",
        ),
        (
            "  about:           {side: before",
            "  about:           {sied: before",
            r"hedges\.about\.sied: unknown key 'sied' \(did you mean 'side'\?\)",
        ),
        (
            "  soon:                {constraint: vague",
            "  soon:                {constraint: never",
            r"words\.soon\.constraint: must be one of",
        ),
        (
            "  a few:        {quantity: [2, 3, 4, 6]",
            "  a few:        {quantity: [2, 3, 6, 4]",
            r"amounts\.a few: corners must not decrease",
        ),
        ("amounts:\n", "amounts:\n  a few: {}\n", r"amounts\.a few: keys must differ"),
        ("results:\n", "result:\n", r"unknown key 'result'"),
    ],
)
def test_a_mistake_among_the_words_is_located(tmp_path: Path, old: str, new: str, said: str) -> None:
    assert old in LEXICON
    changed = LEXICON.replace(old, new, 1)
    line = changed[: changed.index(new)].count("\n") + 1
    found = mistakes(tmp_path, lexicon=changed)
    assert any(re.search(said, mistake) for mistake in found), found
    assert any(re.match(rf"lexicon\.yaml:({line}|{line + 1}|\d+):\d+:", mistake) for mistake in found)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("landmarks:\n", "landmarks:\n  sauce: ours\n", r"landmarks.sauce: unknown key 'sauce'"),
        (
            "  wanting:    [",
            "  wantng:    [",
            r"verbs.wantng: unknown key 'wantng' (did you mean 'wanting'?)",
        ),
        (
            "  third person singular: [",
            "  third person singulr: [",
            "closed_classes.third person singulr: unknown key",
        ),
        (
            "  third person singular: [he, she]",
            "  third person singular: he",
            "closed_classes.third person singular: must be a list, got 'he'",
        ),
        (
            "  third person singular: [he, she]",
            "  third person singular: [he, she, he]",
            "words of a group must differ, got 'he' twice",
        ),
        ("  articles: [the, a, an]", "  articles: [<possessives>]", "a group in another must stand above it"),
        (
            "  third person singular: [he, she]",
            "  third person singular: [he, []]",
            "must be a text, got a list",
        ),
        ("  again: [again, then", '  again: ["", then', "beside_times.again: must not be empty"),
        ("  minus: [", "  minos: [", "beside_times.minos: unknown key 'minos' (did you mean 'minus'?)"),
        ("  beginning: [start,", "  beginning: [start, start,", "must differ, got 'start' twice"),
        (
            "  trying:    [go, come, try, hurry]",
            "  trying:    [go, come, try, hurry]\n  future: [go]",
            "doing.future: unknown key",
        ),
        (
            "  keeping: [keep, leave]",
            "  keeping: {keep: leave}",
            "doing.keeping: must be a list, got a mapping",
        ),
    ],
)
def test_a_mistake_in_a_group_is_told_at_its_line(tmp_path: Path, old: str, new: str, said: str) -> None:
    assert LEXICON.count(old) == 1
    changed = LEXICON.replace(old, new)
    line = changed[: changed.index(new)].count("\n") + 1 + new.strip("\n").count("\n")
    found = [mistake for mistake in mistakes(tmp_path, lexicon=changed) if said in mistake]
    assert [mistake.split(":")[1] for mistake in found] == [str(line)]


def test_a_group_that_is_missing_is_told(tmp_path: Path) -> None:
    row = next(line for line in LEXICON.splitlines(keepends=True) if line.startswith("  minus: ["))
    (mistake,) = mistakes(tmp_path, lexicon=LEXICON.replace(row, ""))
    assert mistake.endswith("beside_times: missing key 'minus'")


def test_a_section_that_is_no_list_of_words_is_told(tmp_path: Path) -> None:
    wrong = LEXICON.replace(
        "fillers:\n  source: ours\n  words: [", "fillers:\n  source: ours\n  words: [[], "
    )
    (mistake,) = mistakes(tmp_path, lexicon=wrong)
    assert "fillers.words[0]: must be a text, got a list" in mistake


def test_a_group_holds_the_words_of_the_groups_in_it() -> None:
    closed = shipped_lexicon().closed
    assert closed.articles | closed.possessives == closed.noun_openers
    assert (
        closed.first_person
        < closed.first_and_third_person
        < closed.personal_pronouns
        < closed.subject_pronouns
    )


def changed(tmp_path: Path, old: str, new: str) -> Lexicon:
    """Give the word tables with one row changed, as somebody's own."""
    assert LEXICON.count(old) == 1
    (tmp_path / "lexicon.yaml").write_text(LEXICON.replace(old, new), "utf-8")
    return read_lexicon(tmp_path / "lexicon.yaml", rules_directory() / "calendar.yaml")


def test_a_word_that_is_added_to_a_group_is_understood_by_the_grammar(tmp_path: Path) -> None:
    text, now = "move thy 3 pm to five", datetime.fromisoformat("2026-03-04T09:00")
    own = changed(
        tmp_path,
        "  possessives: [<sure possessives>, his, her]",
        "  possessives: [<sure possessives>, his, her, thy]",
    )
    assert [found.text for found in find_times(text, now).requirements] == ["3 pm to five"]
    assert [found.text for found in find_times(text, now, own).requirements] == ["to five"]


def test_a_word_that_is_added_to_a_group_is_understood_in_a_sentence(tmp_path: Path) -> None:
    text, now = "ditch all meetings after three", datetime.fromisoformat("2026-03-04T09:00")
    own = changed(tmp_path, "  dropping: [cancel, drop,", "  dropping: [ditch, cancel, drop,")
    language = Language.shipped()
    assert language.read(text, now=now).instructions[0].requirements
    assert not replace(language, lexicon=own).read(text, now=now).instructions[0].requirements


def test_every_section_of_words_says_where_they_are_from() -> None:
    reader = Reader.of_file(rules_directory() / "lexicon.yaml")
    sections = reader.mapping(reader.root(), "")
    unsourced = [name for name, node in sections.items() if "source" not in reader.keys(node)]
    assert unsourced == ["fuzzytime", "language"]


def test_every_group_of_words_is_asked_for_by_a_rule_or_another_group() -> None:
    code = "".join(
        path.read_text("utf-8") for part in ("fuzzytime", "cli") for path in (ROOT / part).rglob("*.py")
    )
    asked = set(re.findall(r"\b(?:closed|beside|doing|pronouns)\.(\w+)", code))
    held = {name.replace(" ", "_") for name in re.findall(r"<([\w ]+)>", LEXICON)}
    for kind in (ClosedClasses, BesideTimes, Doing):
        assert set(kind._fields) <= asked | held


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            '  noon:       {from: "12:00"',
            '  noon:       {from: "25:00"',
            r"parts\.noon\.from: a time of day must look like 09:30, got '25:00'",
        ),
        (
            "  epiphany:          {date: 01-06",
            "  epiphany:          {date: 13-06",
            r"holidays\.epiphany\.date: month and day must .* be in every year, got '13-06'",
        ),
        (
            "  vaisakhi:          {hindu sun: 0, at: midnight",
            "  vaisakhi:          {date: 04-14, at: midnight",
            r"holidays\.vaisakhi\.at: 'at' goes with 'hindu' or 'hindu sun', got 'date'",
        ),
        (
            "  yom kippur:        {hebrew: 07-10",
            "  yom kippur:        {hebrew: 17-10",
            r"holidays\.yom kippur\.hebrew: month and day must look like 12-24, .*, got '17-10'",
        ),
        (
            "  ramadan:           {islamic: 09-01, until: eid al-fitr",
            "  ramadan:           {islamic: 09-01, until: diwali",
            r"holidays\.ramadan\.until: must be a holiday that stands above, got 'diwali'",
        ),
        (
            "  holy week:         {easter: -7, lasts: 7}",
            "  holy week:         {lasts: 7}",
            r"holidays\.holy week: must have one of 'date', 'nth', .*",
        ),
        (
            "  holy week:         {easter: -7, lasts: 7}",
            "  holy week:         {}",
            r"holidays\.holy week: must have one of 'date', 'nth', .*",
        ),
        (
            "  holy week:         {easter: -7, lasts: 7}",
            "  holy week:         {easter: -7, date: 04-01}",
            r"holidays\.holy week\.\w+: must have one of .*, got '\w+' as well",
        ),
        (
            "  holy week:         {easter: -7, lasts: 7}",
            "  holy week:         {easter: -7, lasts: 7, until: easter}",
            r"holidays\.holy week\.until: a holiday has one of 'lasts' and 'until', got both",
        ),
        (
            "  epiphany:          {date: 01-06",
            "  epiphany:          {date: 04-31",
            r"holidays\.epiphany\.date: month and day must .* be in every year, got '04-31'",
        ),
        (
            "  yom kippur:        {hebrew: 07-10",
            "  yom kippur:        {hebrew: 07-31",
            r"holidays\.yom kippur\.hebrew: month and day must .* be in every year, got '07-31'",
        ),
        (
            "  yalda night:       {persian: 09-30",
            "  yalda night:       {persian: 09-31",
            r"holidays\.yalda night\.persian: month and day must .* be in every year, got '09-31'",
        ),
        (
            "  vaisakhi:          {hindu sun: 0, at: midnight",
            "  vaisakhi:          {hindu sun: 0, later: true",
            r"holidays\.vaisakhi\.later: 'later' goes with 'hindu', got 'hindu sun'",
        ),
        (
            "  vaisakhi:          {hindu sun: 0, at: midnight",
            "  vaisakhi:          {hindu sun: 0, at: [dawn, dusk]",
            r"holidays\.vaisakhi\.at: must be a text, got a list",
        ),
        (
            "  maha shivaratri:   {hindu: 11-29, at: midnight",
            "  maha shivaratri:   {hindu: 11-29, at: []",
            r"holidays\.maha shivaratri\.at: must not be empty",
        ),
        (
            "  eid:               {one of: [eid al-fitr, eid al-adha]",
            "  eid:               {one of: []",
            r"holidays\.eid\.one of: must not be empty",
        ),
        (
            "  eid:               {one of: [eid al-fitr, eid al-adha]",
            "  eid:               {one of: [eid al-fitr, eid al-adh]",
            r"holidays\.eid\.one of\[1\]: must be one of the known words, got 'eid al-adh'",
        ),
        (
            "  labor day:         {nth: [1, monday, september]}",
            "  labor day:         {nth: [0, monday, september]}",
            r"holidays\.labor day\.nth\[0\]: must be one of the known words, got '0'",
        ),
        (
            "  0: [monday, mon]",
            "  first: [monday, mon]",
            r"weekdays\.first: must be a whole number, got 'first'",
        ),
        (
            "  labor day:         {nth: [1, monday, september]}",
            "  labor day:         {nth: [1, monday]}",
            r"holidays\.labor day\.nth: must hold 3 items, got 2",
        ),
        (
            "  week:    [week",
            "  wek:     [week",
            r"units\.wek: a unit must be a number of known units, got 'wek'",
        ),
        ("  America/Denver:", "  America/Dever: ", r"zones\.America/Dever: a zone must be an IANA name"),
        (
            "  week_starts: monday",
            "  week_starts: mondy",
            r"policy\.week_starts: must be one of the known words, got 'mondy' \(did you mean 'monday'",
        ),
        ("  0: [monday, mon]", "  9: [monday, mon]", r"weekdays\.9: must be between 0 and 6, got '9'"),
    ],
)
def test_a_mistake_in_the_calendar_is_located(tmp_path: Path, old: str, new: str, said: str) -> None:
    assert old in CALENDAR
    changed = CALENDAR.replace(old, new, 1)
    line = changed[: changed.index(new)].count("\n") + 1
    found = mistakes(tmp_path, calendar=changed)
    assert any(re.match(rf"calendar\.yaml:{line}:\d+: ", m) and re.search(said, m) for m in found), found


def test_mistakes_of_both_files_are_told_in_one_run(tmp_path: Path) -> None:
    found = mistakes(
        tmp_path,
        LEXICON.replace("side: after", "side: afer", 1),
        CALENDAR.replace("half: am", "half: a", 1),
    )
    assert {mistake.split(":")[0] for mistake in found} == {"lexicon.yaml", "calendar.yaml"}


def test_words_with_two_meanings_in_one_table_are_a_mistake(tmp_path: Path) -> None:
    found = mistakes(tmp_path, LEXICON.replace("also: [bout, abt,", "also: [bout, nearly,", 1))
    assert len(found) == 1
    assert "words must have one meaning in a table, got 'nearly' twice" in found[0]


def test_every_word_that_a_rule_names_can_be_typed() -> None:
    assert all(literal == literal.lower() and " " not in literal for literal in shipped_grammar().literals)


def test_the_rows_that_a_rulebook_may_have_are_the_keys_of_the_tables() -> None:
    names = {
        entry.value.name
        for row in shipped_lexicon().entries.values()
        for entry in row
        if entry.category.startswith("preposition")
    }
    assert {"in", "at", "by", "before", "until", "no later than", "after", "from", "not before"} <= names | {
        "in"
    }
