"""What only looks like a time needs no remark, and times beside it are kept."""

from datetime import datetime

import pytest

from fuzzytime.language import find_times

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - said on the wall clock


@pytest.mark.parametrize(
    "text",
    [
        "spell the word february",
        "what does noon mean",
        "what rhymes with june",
        "listen to September by Earth Wind and Fire",
        "rent Freaky Friday",
        "put on Die Another Day",
        "send it to 12 May Street",
        "drive to 9 March Road",
        "paint the wall midnight blue",
        "list the months of the year",
        "put on 80s hits",
        "play songs of the 90s",
        "coach the under 15s",
        "give the keys to April",
        "dance with June",
        "dilute bleach 1:10",
        "build the model at 1:72",
        "set the screen to 16:10",
        "scale it to 1:12",
        "use code MONDAY20",
        "convert 3 hours to minutes",
        "what is 3 hours in minutes",
        "ask Ann about friday",
        "think about tomorrow",
        "draw a picture of dawn",
        "adopt a dog called Friday",
        "write the word noon on the board",
        "play something by the Weeknd",
        "call 24/7 support",
    ],
)
def test_what_is_no_time_needs_no_remark(text: str) -> None:
    found = find_times(text, NOW)
    assert (found.requirements, found.remarks) == ((), ())


@pytest.mark.parametrize(
    ("text", "time"),
    [
        ("spell check it by friday", "by friday"),
        ("have a word with Tom tomorrow", "tomorrow"),
        ("translate it tomorrow", "tomorrow"),
        ("call Ann Friday", "Friday"),
        ("call Wednesday Mum", "Wednesday"),
        ("text Friday the address", "Friday"),
        ("meet Wednesday Noon", "Wednesday Noon"),
        ("listen tomorrow", "tomorrow"),
        ("send it to 12 May Street on 12 May", "on 12 May"),
        ("walk in the sun at noon", "at noon"),
        ("sit in the sun this afternoon", "this afternoon"),
        ("dry it in the morning sun tomorrow", "tomorrow"),
        ("meet on sun at noon", "on sun at noon"),
        ("she turns nine on friday", "on friday"),
        ("dinner is 7 on friday", "7 on friday"),
        ("watch season 2 on sunday", "on sunday"),
        ("wait at platform 9 until 9", "until 9"),
        ("book the meeting room 5 to 7 pm", "5 to 7 pm"),
        ("answer question 9 by 9", "by 9"),
        ("do exercise 12 by 12", "by 12"),
        ("choose one by five", "by five"),
        ("count the till by ten", "by ten"),
        ("ask Ann to come about friday", "about friday"),
        ("tell me about six", "about six"),
        ("deliver it about friday", "about friday"),
        ("say the word tomorrow", "tomorrow"),
        ("read a book called Tuesday at noon", "at noon"),
        ("finish it by the weeknd", "by the weeknd"),
        ("Call Ann After Eight", "After Eight"),
        ("guard it 24/7", "24/7"),
        ("set the screen timer to 16:10", "to 16:10"),
        ("upgrade the meeting to 10:30", "to 10:30"),
        ("place the bet at ten to one", "at ten to one"),
        ("print it at 5", "at 5"),
        ("mark the exams at noon and 8 inches of snow", "at noon"),
        ("wait 80s", "80s"),
        ("send the code friday", "friday"),
        ("send the file may 5", "may 5"),
        ("show films from 2030", "from 2030"),
        ("do a weekly check", "a weekly"),
        ("sign up for evening classes tomorrow", "tomorrow"),
        ("set it for morning", "for morning"),
        ("give the keys to April on Monday", "on Monday"),
        ("tell Summer by noon", "by noon"),
        ("meet dawn at dawn", "at dawn"),
        ("set the alarm for Dawn", "for Dawn"),
        ("tell Ann to move the trip to June", "to June"),
        ("postpone the exam to may", "to may"),
        ("let the flat from May to August", "from May to August"),
        ("read The Hobbit on Friday", "on Friday"),
        ("watch The Crown at Christmas", "at Christmas"),
        ("watch Born on the Fourth of July at 8", "at 8"),
        ("watch Ann on the Fourth of July", "on the Fourth of July"),
        ("play it on 3/4", "on 3/4"),
        ("text the butler on Friday", "on Friday"),
        ("call me at friday noon", "at friday noon"),
        ("write to Ann in ten minutes about the flat", "in ten minutes"),
        ("meet at 3 per our plan", "at 3"),
    ],
)
def test_a_time_beside_one_is_kept(text: str, time: str) -> None:
    assert [found.text for found in find_times(text, NOW).requirements] == [time]
