"""What somebody tells to have happened, where something waits for it, or only names it."""

import pytest

from terminal.talking import Talk, talk_of

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    ("wish", "told", "entry"),
    [
        ("tidy up when the guests have left", "the guests have left", "tidy up as soon as possible"),
        ("tidy up when the guests leave", "the guests left", "tidy up as soon as possible"),
        (
            "plant the tomatoes once dad has dug the bed",
            "dad dug the bed",
            "plant the tomatoes as soon as possible",
        ),
        ("post the letter after bob calls", "bob just called", "post the letter after now"),
        ("leave when the kids are ready", "the kids are ready", "leave as soon as possible"),
        ("call mum when I get home", "I got home", "call mum as soon as possible"),
        ("call mum after I have fed the cat", "I fed the cat", "call mum after now"),
        ("mow the lawn if it doesn't rain", "it didn't rain", "mow the lawn as soon as possible"),
        ("sand the door when the glue is dry", "glue's dry", "sand the door as soon as possible"),
        ("slice the ham once it has cooled", "the ham has cooled", "slice the ham as soon as possible"),
        ("cook when Tim gets home", "Tim got home", "cook as soon as possible"),
        ("tell Ann when Bob has left", "he left", "tell Ann as soon as possible"),
    ],
)
def test_what_waits_for_it_is_done_now(wish: str, told: str, entry: str) -> None:
    talk = talk_of(wish)
    assert f"taken as :edit 1 {entry}" in talk.say(told)
    assert talk.entries == [entry]
    talk.say("undo")
    assert talk.entries == [wish]


@pytest.mark.parametrize(
    ("wish", "told"),
    [
        ("mow the lawn if it doesn't rain", "it rained"),
        ("call mum when I get home", "he got home"),
        ("tidy up when the guests have left", "have the guests left?"),
        ("tidy up when the guests have left", "the guests haven't left"),
        ("call mum when Bob calls", "call Bob"),
    ],
)
def test_what_tells_another_thing_leaves_it_waiting(wish: str, told: str) -> None:
    talk = talk_of(wish, told)
    assert talk.entries[0] == wish


@pytest.mark.parametrize(
    "told", ["glue's dry", "cake's out of the oven", "mum's in charge of dinner", "vitamins w lunch"]
)
def test_what_tells_how_something_is_changes_nothing(told: str) -> None:
    talk = Talk()
    assert "taken as" not in talk.say(told)
    assert talk.entries == []


@pytest.mark.parametrize("told", ["bob has called", "the paint has dried", "dad has dug the bed"])
def test_what_is_over_is_no_wish(told: str) -> None:
    talk = Talk()
    assert "tells what was" in talk.say(told)
    assert talk.entries == []


@pytest.mark.parametrize(
    ("wish", "line"),
    [
        ("call mum before dinner", "dinner's done"),
        ("call mum before dinner", "cancel dinner"),
        ("read before the nap", "the nap is done"),
        ("read before the nap", "push the nap back by ten minutes"),
        ("leave when the kids are ready", "cancel the kids"),
    ],
)
def test_what_it_is_only_done_beside_does_not_name_it(wish: str, line: str) -> None:
    talk = talk_of(wish, line)
    assert talk.entries[0] == wish


@pytest.mark.parametrize(
    ("told", "news", "answer"),
    [
        ("flight is at 11:40", "flight's delayed by 40 minutes", "12:20"),
        ("lea comes over at five pm", "lea's not coming after all", "will not happen: s1 lea comes over"),
        ("the train leaves at ten am", "the train's cancelled", "will not happen: s1 the train leaves"),
        ("guests come at six pm", "they're coming an hour earlier", "from 18:00 to 17:00"),
        ("bob comes at five pm", "bob arrived", "from 17:00 to 09:00"),
        ("dinner's at six pm", "dinner's at 7 now", "from 18:00 to 19:00"),
    ],
)
def test_news_is_told_in_short_forms(told: str, news: str, answer: str) -> None:
    talk = talk_of(told)
    assert answer in talk.say(news)


def test_a_change_that_would_not_be_understood_changes_nothing() -> None:
    talk = talk_of("call Ann at noon")
    assert "nothing is changed" in talk.say(":edit 1 the blue one")
    assert talk.entries == ["call Ann at noon"]
