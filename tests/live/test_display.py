"""What a person sees of a run: every event in a line, and nothing that could harm a terminal."""

import io

import pytest

from fuzzytime_cli.live import events as told
from fuzzytime_cli.live.display import EventScreen
from fuzzytime_cli.live.events import Event
from fuzzytime_cli.render import Screen
from live.story import SIX, Json, kinds_of_events

EVIL = "stir\x1b]52;c;aGk=\x07 \u202ethe [bold]soup[/b]\x9b31m"
WHO: Json = {"at": 90.0, "id": "s1", "name": EVIL}
START = told.Start(
    **WHO,
    instruction=EVIL,
    planned_s=90.0,
    end_s=150.0,
    done_s=150.0,
    agent=1,
    satisfaction=0.5,
    parameters={"verb": EVIL},
    fuzzy_parameters=(EVIL,),
    command=("do", EVIL),
)
EVENTS: list[tuple[Event, str]] = [
    (START, "18:01:30  start     stir"),
    (
        told.Happens(**WHO, instruction=EVIL, planned_s=90.0, done_s=150.0, satisfaction=0.5),
        "(s1), until 18:02:30",
    ),
    (told.End(**WHO, agent=1), "end "),
    (told.Done(**WHO), "done "),
    (told.Moved(**WHO, before_s=None, after_s=120.0), ": no time → 18:02:00"),
    (told.Rejected(**WHO, reason=EVIL), "rejected"),
    (told.Waits(**WHO, reason=EVIL), "waits"),
    (told.Failed(**WHO, reason=EVIL), "failed"),
    (told.Dropped(**WHO, reason=EVIL), "dropped"),
    (told.Missed(**WHO, planned_s=60.0), "it was to start at 18:01:00"),
    (told.Late(**WHO, planned_s=60.0, expected_s=120.0), "now expected until 18:02:00"),
    (told.ContextRead(at=90, signal=EVIL, value=1.5, unit=EVIL, read_s=90, matters=True), "context"),
    (told.Silent(at=90, signal=EVIL, read_s=0.0, max_age_s=300.0), "was not read for 5 min"),
    (told.Instructed(at=90, text=EVIL, ids=("s1", EVIL)), "instruction"),
    (told.Trouble(at=90, message=EVIL, place=EVIL, text=EVIL, span=(0, 4)), "^^^^"),
    (told.Wrote(at=90, id="s1", text=EVIL), "output"),
    (told.Stopped(at=90, running=(EVIL,), waiting=()), "not started: nothing"),
    (
        told.Finished(
            at=90,
            done=("s1",),
            failed=(EVIL,),
            dropped=(),
            rejected=(),
            unfinished=(),
            satisfaction={"geometric_mean": 0.5, "least": 0.25},
        ),
        "1 done; failed: stir",
    ),
]


def shown(event: Event, *, colour: bool) -> str:
    stream = io.StringIO()
    EventScreen(Screen(stream, 80, colour, unicode=True, interactive=False), SIX).tell(event)
    return stream.getvalue()


@pytest.mark.parametrize(("event", "words"), EVENTS, ids=lambda value: getattr(value, "type", ""))
def test_an_event_is_a_line_of_harmless_text(event: Event, words: str) -> None:
    text = shown(event, colour=False)
    assert words in text
    assert all(character.isprintable() or character == "\n" for character in text)
    coloured = shown(event, colour=True)
    assert "\x1b]" not in coloured
    assert "\x07" not in coloured
    assert "\u202e" not in coloured


def test_a_reading_that_does_not_matter_is_not_shown() -> None:
    event = told.ContextRead(at=90, signal="queue", value=1.0, unit=None, read_s=90, matters=False)
    assert shown(event, colour=False) == ""


def test_every_event_is_tried_here() -> None:
    tried = {event.type for event, _ in EVENTS} | {"run", "planned"}
    assert tried == kinds_of_events().keys()
