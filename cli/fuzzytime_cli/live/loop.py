"""The loop of a run: time goes on, news comes in, and what happens is told."""

import math
from collections.abc import Callable

from fuzzytime_cli.live.clock import Clock
from fuzzytime_cli.live.dispatcher import Dispatcher
from fuzzytime_cli.live.events import Event, Trouble
from fuzzytime_cli.live.inbox import MOST_HELD, Arrival, Inbox, Line, Stop
from fuzzytime_cli.live.messages import Listener, Unreadable


def carry_out(
    dispatcher: Dispatcher,
    clock: Clock,
    inbox: Inbox,
    listener: Listener,
    tell: Callable[[Event], None],
    *,
    stay: bool = False,
) -> bool:
    """Run until nothing is left to do, or somebody wishes to stop; say whether it came to its end.

    With ``stay`` it goes on as long as something may come in.
    """
    while True:
        now = clock.now
        arrivals = _heard(inbox, listener, now)
        if any(isinstance(arrival, Stop) for arrival in arrivals):
            tell(dispatcher.stopped(now))
            tell(dispatcher.finished(now))
            return False
        for event in dispatcher.step(now, arrivals):
            tell(event)
        dispatcher.ready(clock.now)
        until = min(dispatcher.next_time(), inbox.next_time)
        if dispatcher.needs_words and not inbox.is_open:
            tell(Trouble(at=now, message="the input has ended: nobody is left to say what is done"))
            tell(dispatcher.finished(now))
            return True
        if _is_over(dispatcher, inbox, stay=stay) or (until == math.inf and not inbox.is_open):
            tell(dispatcher.finished(now))
            return True
        clock.wait(until, inbox)


def _is_over(dispatcher: Dispatcher, inbox: Inbox, *, stay: bool) -> bool:
    if not dispatcher.is_idle:
        return False
    if inbox.is_open and (stay or dispatcher.outlook.has_hope):
        return False
    return not inbox.holds_instructions


def _heard(inbox: Inbox, listener: Listener, now: float) -> list[Arrival]:
    """Take what has come, with lines understood; those about a time ahead are held until then."""
    arrivals: list[Arrival] = []
    for arrival in inbox.take(now):
        if not isinstance(arrival, Line):
            arrivals.append(arrival)
            continue
        message = listener.heard(arrival.text, arrival.place, now)
        if message is None:
            continue
        if message.comes <= now:
            arrivals.append(message)
        elif not inbox.hold(message.comes, message):
            rule = f"at most {MOST_HELD:,} lines may wait for their time"
            arrivals.append(Unreadable(at=now, comes=now, place=arrival.place, message=rule))
    return arrivals
