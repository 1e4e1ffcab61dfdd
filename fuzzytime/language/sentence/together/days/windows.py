"""The hours of a line, and from when to when a line above has them."""

from collections.abc import Sequence
from datetime import timedelta

from fuzzytime.language.finding import ground_all
from fuzzytime.language.meaning.expressions import Phrase, Range, Wall
from fuzzytime.language.meaning.grounded.moment import Moment
from fuzzytime.language.meaning.phrases import is_window
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS, Clock
from fuzzytime.language.policy import Policy
from fuzzytime.language.sentence.segments.drafts import Draft


def clocks_in(draft: Draft) -> list[Clock]:
    """Give the clock times of a line that name no day."""
    times = [phrase.said.time for phrase in draft.phrases]
    ends = [
        end for time in times for end in ((time.first, time.last) if isinstance(time, Range) else (time,))
    ]
    return [end.clock for end in ends if isinstance(end, Wall) and end.clock is not None and end.days is None]


def is_within(clocks: Sequence[Clock], window: Phrase, draft: Draft, policy: Policy) -> bool:
    """Whether some clock times may all be meant in a window."""
    bounds = window_of(window, draft, policy)
    if bounds is None or draft.now is None:
        return False
    begins = draft.now + timedelta(seconds=bounds[0])
    begin = begins.hour * 3600 + begins.minute * 60
    length = bounds[1] - bounds[0]
    return all(any((s - begin) % DAY_SECONDS <= length for s in clock.candidates()) for clock in clocks)


def window_of(phrase: Phrase, draft: Draft, policy: Policy) -> tuple[float, float] | None:
    """Give from when to when a phrase is, in seconds; None where it is no window within a day."""
    if not is_window(phrase):
        return None
    for time in ground_all((phrase,), draft.text, Moment(draft.now, policy)).requirements:
        first, last = time.earliest, time.latest
        if first is not None and last is not None and 0 < last - first <= DAY_SECONDS:
            return first, last
    return None


def window_above(draft: Draft) -> tuple[float, float] | None:
    """Give from when to when a line above says that all below it is; None where none says so."""
    phrases = () if draft.heading is None else draft.heading.phrases
    windows = (window_of(phrase, draft, draft.lexicon.policy) for phrase in phrases)
    return next((window for window in windows if window is not None), None)
