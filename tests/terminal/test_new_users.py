"""What people say who never read how: they correct, ask, wave on, and take back in their own words."""

import pytest

from fuzzytime.language.about_wishes import AboutKind, about_wishes, in_its_place, said_apart
from fuzzytime.language.finding import shipped_lexicon
from terminal.talking import NINE, Talk, talk_of


@pytest.mark.parametrize("line", ["go", "ok go", "let's go", "wait", "hang on a minute", "k", "ty", "oops"])
def test_what_only_waves_on_is_no_wish(line: str) -> None:
    talk = talk_of("call Ann at noon")
    assert "s1 call Ann: at 12:00" in talk.say(line)
    assert talk.entries == ["call Ann at noon"]


def test_going_somewhere_is_a_wish() -> None:
    lexicon = shipped_lexicon()
    for line in ("go home at six", "wait ten minutes", "continue stirring", "go right", "start the pump"):
        assert about_wishes(line, NINE, lexicon) is None, line


@pytest.mark.model
@pytest.mark.parametrize(
    ("said", "entry"),
    [
        ("forget that, call Ann at six", "call Ann at six"),
        ("scratch that. Call Bob at seven.", "Call Bob at seven"),
        ("cancel the call and text him at six", "text Bob at six"),
        ("never mind the call; email Bob at two", "email Bob at two"),
        ("cancel that and text him instead", "text Bob"),
    ],
)
def test_what_is_wished_behind_what_is_let_be_stands_in_its_place(said: str, entry: str) -> None:
    talk = talk_of("call Bob at five")
    assert "taken as :edit 1" in talk.say(said)
    assert talk.entries == [entry]
    talk.say("undo")
    assert talk.entries == ["call Bob at five"]


def test_what_is_let_be_alone_stands_in_nothings_place() -> None:
    lexicon = shipped_lexicon()
    for line in ("forget that", "cancel the call, please move the soup to six", "call Ann, text Bob"):
        assert in_its_place(line, NINE, lexicon) is None, line


@pytest.mark.model
@pytest.mark.parametrize(
    ("first", "line", "entry"),
    [
        ("finish the essay by seven pm", "make it eight", "finish the essay by eight"),
        ("finish the essay by seven pm", "make that half past", "finish the essay by half past 7 pm"),
        ("finish the essay by seven pm", "no, at ten pm", "finish the essay at ten pm"),
        ("call Ann after three", "make that half past", "call Ann after half past 3 pm"),
        ("be at work from nine tomorrow", "no, half past eight", "be at work tomorrow from half past eight"),
        ("water the plants before noon", "move it to one", "water the plants before one"),
    ],
)
def test_a_bound_stays_one_where_only_its_time_is_said_anew(first: str, line: str, entry: str) -> None:
    talk = talk_of("sand the desk from eight to noon", first, line)
    assert talk.entries[-1] == entry


@pytest.mark.model
def test_dinner_with_its_time_is_a_wish_and_no_time_of_another() -> None:
    talk = talk_of("start the rice at half past five pm", "dinner at six pm")
    assert talk.entries == ["start the rice at half past five pm", "dinner at six pm"]


@pytest.mark.model
def test_what_is_to_come_first_or_last_needs_no_verb() -> None:
    talk = talk_of("wash up now")
    for line in ("make the salad", "make the soup", "chop the nuts"):
        talk.say(line)
    talk.say("soup first, please")
    assert talk.start("s3") < min(talk.start("s2"), talk.start("s4"))
    talk.say("salad last")
    assert talk.start("s2") > max(talk.start("s3"), talk.start("s4"))
    assert "nothing that is planned is about fish" in talk.say("fish first")


@pytest.mark.model
def test_entries_are_called_by_their_numbers() -> None:
    talk = talk_of("call Ann at ten", "iron the shirts at eleven", "2 at noon")
    assert talk.start("s2").hour == 12
    talk.say("s1 at one pm")
    assert talk.start("s1").hour == 13
    talk.say("s2 takes half an hour")
    assert talk.entries[1] == "iron the shirts at noon for half an hour"
    assert "s1 call Ann" in talk.say("what's step 1?")
    assert "done: call Ann" in talk.say("number 1 done")
    assert "done: iron the shirts" in talk.say("shirts done")


@pytest.mark.model
def test_lines_are_crossed_off_in_several_words() -> None:
    talk = Talk()
    for line in ("call Ann at ten", "call Ben at eleven", "call Cem at noon", "put the lid on at one pm"):
        talk.say(line)
    talk.say("delete Ben")
    talk.say("remove Ann's call")
    talk.say("remove the lid")
    assert talk.entries == ["call Cem at noon", "put the lid on at one pm", "remove the lid"]
    talk.say("get rid of the first one")
    assert talk.entries == ["put the lid on at one pm", "remove the lid"]


@pytest.mark.model
def test_what_is_to_stop_is_done_or_forgotten() -> None:
    talk = talk_of("check the oven every ten minutes until noon")
    assert "taken as :drop 1" in talk.say("stop checking")
    talk.say("stop stirring the soup at noon")
    assert talk.entries == ["stop stirring the soup at noon"]


@pytest.mark.model
def test_both_are_over_though_one_of_them_was_running() -> None:
    talk = talk_of("wash the car now", "feed the cat at ten")
    talk.wait(minutes=1)
    assert ":drop 1,2" in talk.say("both done")


@pytest.mark.model
def test_a_number_alone_counts_minutes_where_something_is_pushed() -> None:
    talk = talk_of("call Ann at ten", "push everything by ten", "push it back ten", "delay it by five")
    assert talk.start("s1").strftime("%H:%M") == "10:25"
    talk.say("never mind, leave it")
    assert talk.start("s1").strftime("%H:%M") == "10:20"


@pytest.mark.model
def test_how_long_something_takes_is_told_of_what_was_spoken_of() -> None:
    talk = talk_of("bake the cake at noon", "it takes two hours")
    assert talk.entries == ["bake the cake at noon for two hours"]
    assert "by how much?" in talk.say("it takes longer")
    assert "150min" in talk.say("half an hour")
    assert "by how much?" in talk.say("I'm late")
    assert ":busy" in talk.say("ten minutes")


@pytest.mark.model
def test_what_is_supposed_of_the_same_again_is_of_that() -> None:
    talk = talk_of("start the rice at half past five pm")
    assert "moved: s1 start the rice from 17:30 to 18:00" in talk.say("what if I start the rice at six pm?")


@pytest.mark.model
def test_questions_are_answered_and_change_nothing() -> None:
    talk = talk_of("stir the soup at eleven", "serve the soup at noon")
    assert "s1 stir the soup: at 11:00" in talk.say("how much time do I have?")
    assert "s1 stir the soup: at 11:00" in talk.say("how long left?")
    assert "yes: everything that is planned has its time" in talk.say("am I going to make it?")
    assert "s1 stir the soup: at 11:00" in talk.say("is it today?")
    assert "yes: nothing is planned at two" in talk.say("I'm free at two, right?")
    assert "stir the soup: 11:00" in talk.say("where am I at eleven?")
    assert "serve the soup" in talk.say("what do I have to do after the stirring?")
    assert "stir the soup" in talk.say("how many things are left?")
    assert "stir the soup" in talk.say("so what was the plan again?")
    assert len(talk.entries) == 2
    talk.say("paint the fence for an hour at 11:30 exactly")
    assert "yes:" in talk.say("will we be late?")
    assert "not all of it" in talk.say("will we be on time?")


@pytest.mark.model
def test_it_is_no_event_where_a_thing_was_named() -> None:
    talk = talk_of("fold the laundry at ten", "handover at 13:30")
    assert "put away the laundry" in talk.say("put it away before that")
    talk.say("meeting with Tom at three pm")
    assert "prepare meeting with Tom" in talk.say("prepare it before that")
    talk.say("the truck arrives at two pm")
    assert "unload the truck" in talk.say("unload it")


def test_words_that_take_back_are_of_what_they_are_said_of() -> None:
    lexicon = shipped_lexicon()
    about = about_wishes("I said seven", NINE, lexicon)
    assert about is not None
    assert (about.kind, about.time) == (AboutKind.MOVE, "at seven")
    about = about_wishes("start now", NINE, lexicon)
    assert about is not None
    assert about.kind is AboutKind.STARTED


@pytest.mark.model
@pytest.mark.parametrize(
    ("wish", "told", "reading"),
    [
        ("flip the pancakes when the pan is hot", "the pan is hot", ":ctx pan_temp=190 degC"),
        ("flip the pancakes when the pan is hot", "Pan is at 180.", ":ctx pan_temp=180 degC"),
        ("drain the pasta when the water boils", "the water boils", ":ctx water_temp="),
        ("close the window when it rains", "it's raining", ":ctx rain="),
        ("light the candles when the guests are here", "the guests are here", ":ctx guests_arrive"),
        ("serve the soup ten minutes after the guests arrive", "the guests have arrived", ":ctx guests"),
        ("open the door when Bob is here", "Bob is here", "taken as :edit 1 "),
        ("take the tents down once the dew is off", "the dew is off", "taken as :edit 1 "),
        ("order the parts if the tray is ok", "the tray is ok", "taken as :edit 1 "),
        ("set a timer once pasta is in", "pasta's in", "taken as :edit 1 "),
    ],
)
def test_what_is_told_to_be_so_is_what_something_waits_for(wish: str, told: str, reading: str) -> None:
    talk = Talk()
    assert " waits " in talk.say(wish)
    answer = talk.say(told)
    assert reading in answer
    assert "found a place: s1" in answer
    talk.say("undo")
    assert talk.entries == [wish]


@pytest.mark.model
def test_what_is_told_and_waited_for_by_nothing_is_no_wish() -> None:
    talk = Talk()
    for line in ("dinner's burnt", "you forgot the windows", "samples are in"):
        talk.say(line)
        assert not talk.entries, line
    talk.say("serve the soup at noon")
    assert ":drop all" in talk.say("dinner's burnt, start over")


@pytest.mark.model
def test_a_line_may_say_several_things_of_what_was_asked_for() -> None:
    talk = Talk()
    for line in ("call Bob at five pm", "stir the soup at noon", "call Ann at ten"):
        talk.say(line)
    answer = talk.say("cancel Ann and move the soup to one pm")
    assert "moved: s2 stir the soup from 12:00 to 13:00" in answer
    assert talk.entries == ["call Bob at five pm", "stir the soup at one pm"]
    assert "s2 stir the soup: at 13:00" in talk.say("Thanks. What's next?")
    talk.say("no, make it two pm. And call Dan at eight pm.")
    assert talk.entries == ["call Bob at five pm", "stir the soup at two pm", "call Dan at eight pm"]
    answer = talk.say("undo. drop the fish, what's next?")
    assert talk.entries[-1] != "call Dan at eight pm"
    assert "s2 stir the soup" in answer


def test_one_thing_is_said_with_commas_too() -> None:
    lexicon = shipped_lexicon()
    for line in (
        "no, ten minutes later",
        "not that one, the other one",
        "swap the call and the soup",
        "I'm late, ten minutes",
        "call Ann at ten and Ben at eleven",
        "thanks, bye",
    ):
        assert said_apart(line, NINE, lexicon) == [line], line


@pytest.mark.model
def test_one_of_several_things_is_left_out_of_an_instruction() -> None:
    talk = talk_of("clean the bathroom, the hall and the kitchen at eleven", "not the hall")
    assert talk.entries == ["clean the bathroom and the kitchen at eleven"]
    talk.say("leave the kitchen out")
    assert talk.entries == ["clean the bathroom at eleven"]
    talk.say("del 1")
    assert talk.entries == []


@pytest.mark.model
def test_who_is_here_is_who_was_to_come() -> None:
    talk = talk_of("movers arrive at ten am", "keys to the landlord at 5 pm sharp")
    assert "moved: s1 movers arrive" in talk.say("they're here")


@pytest.mark.model
def test_what_tells_how_something_is_stands_in_the_place_of_nothing() -> None:
    talk = talk_of("freeze the tubes at ten")
    for line in ("never mind, it works", "it works", "that helps", "sorry", "y"):
        talk.say(line)
        assert talk.entries == ["freeze the tubes at ten"], line
    assert ":duration 1 7min" in talk.say("add 5 minutes")


@pytest.mark.model
def test_an_answer_in_front_of_something_else_is_no_part_of_it() -> None:
    talk = talk_of("do the dishes after lunch", "ok fine, at six pm")
    assert talk.entries == ["do the dishes at six pm"]
    talk.say("sure, call Bob at eleven")
    assert talk.entries[-1] == "call Bob at eleven"
    talk.say("no, at noon")
    assert talk.entries[-1] == "call Bob at noon"
    assert ":drop all" in talk.say("done with everything")


@pytest.mark.model
def test_one_of_several_things_to_do_of_a_line_is_meant() -> None:
    talk = talk_of("water the roses at nine thirty, then mow the lawn at ten")
    assert "done: mow the lawn" in talk.say("the lawn is done")
    talk.say("call Ann at eleven and Ben at noon")
    talk.say("drop Ben")
    assert talk.entries[-1] == "call Ann at eleven"
    assert talk.start("s2").hour == 11


@pytest.mark.model
def test_what_is_to_come_beside_another_may_be_corrected() -> None:
    talk = talk_of("hang the banner at five pm", "blow up the balloons at six pm", "no, before the banner")
    assert talk.start("s2") < talk.start("s1")


@pytest.mark.model
def test_a_delivery_is_unpacked() -> None:
    talk = talk_of("count the till at nine thirty", "delivery at ten am")
    assert "unpack delivery" in talk.say("unpack it straight after")


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("show", "what"),
        ("my plan", "what"),
        ("clear", "forget instruction N"),
        ("save", "a file must follow"),
        ("export", "a file must follow"),
        ("plot s1", "satisfaction with a start"),
        ("explain s1", "call Ann at noon"),
        ("priority s1 2", "call Ann"),
    ],
)
def test_the_name_of_a_command_is_no_wish(line: str, said: str) -> None:
    talk = talk_of("call Ann at noon")
    assert said in talk.say(line)
    assert talk.entries == ["call Ann at noon"]


@pytest.mark.model
@pytest.mark.parametrize(
    "line", ["plot the data at four", "export the data", "edit the essay", "rate the pies at two"]
)
def test_what_commands_are_called_may_be_done_to_a_thing(line: str) -> None:
    talk = talk_of(line)
    assert talk.entries == [line]


@pytest.mark.parametrize("line", ["list", "status", "help me"])
def test_commands_need_no_colon_where_they_are_no_wishes(line: str) -> None:
    talk = talk_of("call Ann at noon")
    assert "call Ann" in talk.say(line) or line == "help me"
    assert talk.entries == ["call Ann at noon"]


def test_undo_behind_done_loses_nothing() -> None:
    talk = talk_of("boil the rice for 20 minutes")
    talk.wait(minutes=1)
    assert "done: boil the rice" in talk.say("done")
    assert "running: s1 boil the rice, until 09:20:00" in talk.say("undo")


@pytest.mark.model
@pytest.mark.parametrize(
    "line", ["scratch that, feed the cat at seven pm", ":edit 1 feed the cat at seven pm"]
)
def test_another_wish_in_the_place_of_what_has_begun_in_part_is_planned(line: str) -> None:
    talk = talk_of("dust the shelf, sweep the floor, call Ann at six pm")
    talk.wait(seconds=30)
    assert "no longer running: dust the shelf" in talk.say(line)
    assert talk.entries == ["feed the cat at seven pm"]
    assert talk.start("s2").hour == 19


@pytest.mark.model
def test_what_is_left_of_what_has_begun_in_part_is_worded_anew() -> None:
    talk = talk_of("dust the shelf, sweep the floor, call Ann at six pm")
    talk.wait(seconds=30)
    answer = talk.say(":edit 1 dust the shelf, sweep the floor, call Ann at eight pm")
    assert "running: s1 dust the shelf" in answer
    assert talk.start("s1.3").hour == 20


@pytest.mark.model
def test_who_asks_why_hears_what_something_waits_for() -> None:
    talk = talk_of("take the tents down once the dew is off")
    for question in ("why the tents", "when do I take the tents down?", ":why s1"):
        assert "waits: nothing tells 'once the dew is off'" in talk.say(question), question
    talk.say("forget the tents")
    assert talk.entries == []
