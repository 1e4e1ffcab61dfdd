"""What people type every day: they clear an afternoon, mistype, give reasons, tell what is done."""

from pathlib import Path

import pytest

from fuzzytime.language.about_wishes import AboutKind, about_things, about_wishes, respelled
from fuzzytime.language.finding import shipped_lexicon
from terminal.running import ran
from terminal.talking import NINE, Talk, talk_of


@pytest.mark.parametrize(
    ("line", "time"),
    [
        ("clear my afternoon", "my afternoon"),
        ("cancel everything after three", "after three"),
        ("clear friday", "friday"),
        ("remove everything before noon", "before noon"),
    ],
)
def test_a_stretch_of_time_is_cleared(line: str, time: str) -> None:
    about = about_wishes(line, NINE, shipped_lexicon())
    assert about is not None
    assert (about.kind, about.everything, about.time) == (AboutKind.DROP, True, time)


@pytest.mark.parametrize("line", ["clear the table at six", "clear the table this evening", "wipe the table"])
def test_a_table_is_cleared_and_no_time(line: str) -> None:
    assert about_wishes(line, NINE, shipped_lexicon()) is None


@pytest.mark.model
def test_of_what_was_cleared_one_is_kept_after_all() -> None:
    talk = Talk()
    for line in ("dentist at two", "pick up the kids at four", "call Ann at ten"):
        talk.say(line)
    assert "taken as :drop 1,2" in talk.say("clear my afternoon")
    assert talk.entries == ["call Ann at ten"]
    talk.say("oh wait, not the kids")
    assert talk.entries == ["pick up the kids at four", "call Ann at ten"]
    assert "nothing else is planned tomorrow" in talk.say("cancel everything tomorrow")
    talk.say("cancel both")
    talk.say("no, not Ann")
    assert talk.entries == ["call Ann at ten"]


@pytest.mark.model
def test_who_asks_for_a_while_gets_it() -> None:
    talk = talk_of("call Ann at 9:02")
    assert "taken from 09:00 to 09:05" in talk.say("give me five minutes")
    talk.wait(minutes=6)
    assert "goes on until" in talk.say("I need ten minutes")
    about = about_wishes("I need ten more minutes", NINE, shipped_lexicon())
    assert about is not None
    assert about.kind is AboutKind.MORE
    assert about_wishes("I need five minutes for the soup", NINE, shipped_lexicon()) is None


def test_what_corrects_is_no_other_thing() -> None:
    about = about_things("wait, not the kids", NINE, shipped_lexicon())
    assert about is not None
    assert (about.kind, set(about.names)) == (AboutKind.DROP, {"kid"})


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("canel that", "cancel that"),
        ("udno", "undo"),
        ("wen is it", "when is it"),
        ("mvoe the call to six", "move the call to six"),
        ("shwo me the plan", "show me the plan"),
        ("sip the tea", None),
        ("cancel that", None),
        ("mash the peas", None),
    ],
)
def test_a_mistyped_order_about_wishes_is_read(typed: str, meant: str | None) -> None:
    assert respelled(typed, NINE, shipped_lexicon(), lambda word: word in {"sip", "mash"}) == meant


@pytest.mark.model
def test_a_mistyped_order_is_read_where_it_means_something() -> None:
    talk = talk_of("call Ann at noon")
    assert "read as: mvoe" not in talk.say("mvoe the sofa")
    assert "read as: move it to one" in talk.say("mvoe it to one")
    talk.say("mvoe the call to two")
    assert talk.entries == ["call Ann at two", "mvoe the sofa at one"]


@pytest.mark.model
def test_a_reason_is_no_wish_and_said_to_change_nothing() -> None:
    talk = talk_of("go for a run at 6 pm")
    assert "'too tired' changes nothing" in talk.say("actually skip it, too tired")
    talk.say("undo")
    assert '"it\'s raining" changes nothing' in talk.say("forget the run, it's raining")
    assert talk.entries == []


@pytest.mark.model
@pytest.mark.parametrize(
    ("planned", "told"),
    [
        ("feed the cat at noon", "fed the cat"),
        ("call the bank at noon", "ok called them"),
        ("call mum at noon", "called mum already"),
        ("water plants at noon", "watered plants"),
        ("buy milk at noon", "got the milk"),
    ],
)
def test_what_was_done_needs_no_speaker(planned: str, told: str) -> None:
    talk = talk_of(planned)
    assert "done: " in talk.say(told)
    assert talk.left == []


@pytest.mark.model
def test_what_may_be_the_name_of_a_dish_is_a_wish() -> None:
    talk = talk_of("fried eggs at six")
    assert talk.entries == ["fried eggs at six"]
    assert "nothing like it is planned" in talk.say("hung the picture")
    assert talk.entries == ["fried eggs at six"]


@pytest.mark.model
def test_of_several_things_one_is_done_and_the_rest_stays() -> None:
    talk = talk_of("buy milk and bread at noon", "I bought the milk")
    assert talk.entries == ["buy bread at noon"]


@pytest.mark.model
def test_of_several_things_of_a_line_one_is_moved_lengthened_swapped_and_dropped() -> None:
    talk = talk_of("call Ann at ten, Bob at eleven and Carl at noon", "swap Ann and Carl")
    assert talk.entries == ["call Ann at noon, Bob at eleven and Carl at ten"]
    talk.say("s1.2 at one pm")
    assert talk.entries == ["call Ann at noon, Bob at one pm and Carl at ten"]
    talk = talk_of("pay the rent at ten, fix the bike at eleven, mow the lawn at four pm", "2 at noon")
    assert talk.entries == ["pay the rent at ten, fix the bike at noon, mow the lawn at four pm"]
    talk.say("step 3 takes 9 minutes")
    assert talk.entries == [
        "pay the rent at ten, fix the bike at noon, mow the lawn at four pm for 9 minutes"
    ]
    talk.say("drop 2")
    assert talk.entries == ["pay the rent at ten, mow the lawn at four pm for 9 minutes"]
    assert "done: pay the rent" in talk.say("1 is done")
    assert "nothing that is planned is about s1.7" in talk.say("drop s1.7")


@pytest.mark.model
def test_a_time_without_its_half_of_the_day_does_not_go_to_tomorrow() -> None:
    talk = talk_of("call Ann at ten", "no, at seven")
    assert talk.start("s1") == NINE.replace(hour=19)


@pytest.mark.model
def test_how_something_is_said_is_told() -> None:
    talk = Talk()
    assert ":drop" in talk.say("how do I cancel something?")
    assert ":edit" in talk.say("how can I move the call?")
    assert "asks" in talk.say("how do I peel an egg?")


@pytest.mark.model
def test_why_asks_of_what_is_running_too() -> None:
    talk = talk_of("iron the shirts now")
    talk.wait(seconds=5)
    assert "is running until" in talk.say("why is it now?")
    assert "running" in talk.say("how long will that take?")


@pytest.mark.model
def test_what_waits_for_a_taxi_finds_it() -> None:
    talk = talk_of("taxi at seven pm", "pack before the taxi comes")
    assert "no instruction" not in talk.say("lock up when it's here")
    assert talk.start("s3") == talk.start("s1")


@pytest.mark.model
def test_a_number_in_front_of_its_time_is_pointed_at() -> None:
    assert "'2': what it counts is not said" in Talk().say("2 at noon")


def test_the_doctor_reads_the_tables_of_whoever_asks(tmp_path: Path) -> None:
    own = tmp_path / "own.yaml"
    own.write_text("fuzzytime: 1\nlanguage: en\nverbz: {}\n", "utf-8")
    told = ran("doctor", folder=tmp_path, FUZZYTIME_CUSTOMS=str(own))
    assert "FAIL tables" in told.out
    assert told.code == 1


def test_the_doctor_tells_that_the_sessions_are_damaged(tmp_path: Path) -> None:
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "sessions.sqlite").write_text("no database")
    told = ran("doctor", folder=tmp_path, COLUMNS="300")
    assert "FAIL sessions" in told.out
    assert "sessions.sqlite: file is not a database" in told.out
    assert told.code == 1


@pytest.mark.model
def test_keeping_takes_one_back_of_what_was_dropped() -> None:
    talk = talk_of("ring the plumber at half ten", "ring the electrician at eleven")
    talk.say("cancel everything this morning")
    talk.say("no wait, keep the plumber")
    assert talk.entries == ["ring the plumber at half ten"]


@pytest.mark.model
def test_and_with_a_time_alone_is_the_same_at_that_time_too() -> None:
    talk = talk_of("read to the kids at 8 pm", "and at 7:30 pm")
    assert talk.entries == ["read to the kids at 8 pm", "read to the kids at 7:30 pm"]


@pytest.mark.model
def test_what_is_repeated_is_left_out_on_days_that_repeat() -> None:
    talk = talk_of("read to the kids at 8 pm every day", "not on fridays")
    assert talk.entries == ["read to the kids at 8 pm every day except on fridays"]


@pytest.mark.model
@pytest.mark.parametrize(
    ("line", "entry"),
    [("reschedule for friday", "call Ann friday at four pm"), ("I need it by three", "call Ann by three")],
)
def test_a_new_time_needs_no_thing(line: str, entry: str) -> None:
    talk = talk_of("call Ann at four pm", line)
    assert talk.entries == [entry]


@pytest.mark.model
def test_what_was_asked_for_without_a_time_may_get_one() -> None:
    talk = talk_of("water the plants", "water the plants at six pm")
    assert talk.entries == ["water the plants at six pm"]
    talk.say("water the plants again at eight pm")
    assert len(talk.entries) == 2


@pytest.mark.model
def test_one_of_several_things_of_a_line_is_put_off_and_no_other() -> None:
    talk = talk_of("mow the lawn at ten, trim the hedge at eleven and sweep the path at one pm")
    talk.say("postpone the hedge by an hour")
    assert (talk.start("s1").hour, talk.start("s1.2").hour, talk.start("s1.3").hour) == (10, 12, 13)


@pytest.mark.model
def test_questions_name_days_of_the_plan_and_what_is_planned() -> None:
    talk = talk_of("Tom picks up Lena from school at half three")
    assert "s1 Tom picks up Lena" in talk.say("who picks up lena?")
    assert "nothing is planned then" in talk.say("what's the plan for tomorrow")
    assert "s1 Tom picks up Lena" in talk.say("what time do I start then?")
    assert "s1 Tom picks up Lena" in talk.say("what should I do first?")
    assert "asks" in talk.say("who are you?")
    assert len(talk.entries) == 1


@pytest.mark.model
@pytest.mark.parametrize("line", ["...", "?", "!", "skip it, ,", ", too tired", "and at", "s1.", "wait, not"])
def test_what_says_nothing_is_answered(line: str) -> None:
    talk = Talk()
    assert talk.say(line)
    assert talk.entries == []


def test_a_file_needs_no_colon_and_what_is_ticked_off_is_said(tmp_path: Path) -> None:
    talk = Talk()
    assert "ticked off" in talk.say("- [x] order coffee")
    assert talk.paste("- [x] feed the cat", "# for tonight")[0].startswith("ticked off")
    assert "written" in talk.say(f"save {tmp_path / 'dinner.json'}")
    assert talk.entries == []
