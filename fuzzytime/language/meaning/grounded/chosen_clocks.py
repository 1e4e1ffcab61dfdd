"""Which of the moments is meant that a clock time without am or pm, or without a day, may be."""

from collections.abc import Sequence
from datetime import datetime, time, timedelta

from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.expressions import Wall
from fuzzytime.language.meaning.grounded.part_instants import EARLY
from fuzzytime.language.meaning.grounded.standpoint import Standpoint
from fuzzytime.language.meaning.instants import Instants, midnight
from fuzzytime.language.meaning.times_of_day import Clock, Half

NOON = 12
NOON_TIME = time(NOON)
FOLLOWING = timedelta(hours=6)
"""How long after a clock time the next one of a text, without am or pm, hardly is before it."""

CLOSE = timedelta(hours=3)
"""The same where another text said that clock time, as lines need not be in the order of the day."""

SHORTLY = timedelta(hours=1)
"""How long before a clock time the next one of a text may be, where nothing follows the first."""

EVENING = time(19)
"""From here on, what lines say goes on into the night."""

NIGHT = time(21)
OVERNIGHT = timedelta(hours=5)
"""What lines say from then on may lie behind midnight, so long after."""


def decided(here: Standpoint, moments: list[datetime], clock: Clock, wall: Wall) -> Instants:
    """Choose among the moments that a clock time may mean, in ascending order."""
    named = wall.days is not None
    # "Thursday", said on one at half past two at night, is no day to come.
    today = isinstance(wall.days, Fields) and moments[0].date() == here.now.date()
    ahead = (named and not today) or here.early
    plausible = [moment for moment in moments if is_plausible(here, moment, ahead=ahead)]
    chosen = (plausible or moments)[0]
    goes_on = here.since is not None and here.since.date() > here.now.date()
    if here.ends and not named and not here.usual and here.now.time() >= EARLY and not goes_on:
        # "Until ten", said at eight in the evening: what can still be kept today.
        chosen = next((moment for moment in moments if moment.date() == here.now.date()), chosen)
    if here.leads is not None and not named and not here.usual:
        # "Unlock it at 7:45 and lock it at 18:10": the 7:45 that is before.
        leading = (moment for moment in plausible if _leads(here, moment, here.leads))
        chosen = next(leading, chosen)
    if here.leads is not None and not here.leads.is_open and moments[0].date() == moments[-1].date():
        # "Milk them tomorrow at five and again at half past four pm": the first, however early that is.
        chosen = next((moment for moment in moments if _leads(here, moment, here.leads)), chosen)
    # "The cat at eight, the dog at nine and both at ten": both in the evening
    same = here.since in moments and not here.usual and not here.carried
    told = _of_night(here, moments) or (here.since if same else None)
    if told is not None:
        choices = tuple(moments) if len(moments) > 1 and told in moments else ()
        return Instants(told, told, clock.grain, choices, wall.zone)
    morning = _of_morning(here, moments, clock, named=named)
    if morning is not None and (not here.usual or morning in plausible):
        chosen = morning
    elif here.since is not None and not here.usual and _is_late(here, here.since, moments):
        # "The interval is at 20:35", "strike the set at ten": that evening, however late.
        chosen = next(moment for moment in moments if here.since < moment)
    elif here.since is not None and chosen < here.since:
        following = _following(here, moments, plausible, wall)
        if following is None and here.carried and here.released is not None:
            # "Bins out before bed", then "ring mum after eight": before the deadline.
            between = (moment for moment in plausible if here.released < moment <= here.since)
            following = next(between, None)
        chosen = following or chosen
    if here.night is not None and not named and not here.usual:
        # The shift is from 19:30 to 07:30: "handover at quarter past seven" is where it ends.
        first, last = here.night
        inside = (moment for moment in moments if first <= moment <= last)
        chosen = min(inside, key=lambda moment: abs(moment - (here.since or first)), default=chosen)
    choices = tuple(moments) if len(moments) > 1 and chosen in moments else ()
    return Instants(chosen, chosen, clock.grain, choices, wall.zone)


def _following(
    here: Standpoint, moments: Sequence[datetime], plausible: Sequence[datetime], wall: Wall
) -> datetime | None:
    """Give the moment that follows what was said before: "open it at eight and close it at nine"."""
    since = here.since
    if since is None:
        return None
    # Of "at eight, twelve and five", none is at night only because another is in the evening, and nobody
    # has lunch at midnight.
    known = plausible if here.listed or here.carried or here.usual else moments
    within = CLOSE if here.carried and not here.in_order else FOLLOWING
    follows = [moment for moment in known if since < moment <= since + within]
    if not follows and here.listed:
        # "Feed the baby at six and again at ten": late, and on the same day.
        late = (moment for moment in moments if moment.date() == since.date())
        follows = [moment for moment in late if since < moment <= since + within]
    if not follows and not here.carried and not here.onto:
        # "Open at nine, lights on at 8.45"
        follows = [moment for moment in plausible if since - SHORTLY <= moment < since]
    if wall.days is not None and not here.carried:
        # "On friday mow at ten and rake at six": the six of that day that follows, however late.
        follows += [moment for moment in plausible if since < moment]
    if not follows and here.onto and not here.carried:
        # "Open it at noon and close it at ten", however late that is.
        follows = [moment for moment in moments if since < moment]
    if not follows and not here.carried:
        # "Dinner is at seven, lay the table at half six", said early in the day
        follows = [moment for moment in plausible[::-1] if since - CLOSE <= moment < since]
    return next(iter(follows), None)


def _of_night(here: Standpoint, moments: Sequence[datetime]) -> datetime | None:
    """Give the evening, or the morning behind it: "close it at eight and open it at seven"."""
    if here.overnight is None:
        return None
    if here.overnight is Half.EVENING:
        return next((moment for moment in moments if moment.hour >= NOON), None)
    mornings = [moment for moment in moments if moment.hour < NOON]
    since = here.since or here.now
    return next((m + timedelta(days=m <= since) for m in mornings), None)


def _of_morning(
    here: Standpoint, moments: Sequence[datetime], clock: Clock, *, named: bool
) -> datetime | None:
    """Give the moment in which a night ends that was said before: people are up early then."""
    since = here.since
    if since is None:
        return None
    if here.ends and here.follows and not named and since.time() >= EVENING:
        # "Charge it overnight so it's ready by six"
        days = (midnight(since.date()) + timedelta(days=later) for later in (0, 1))
        there = (day + timedelta(seconds=seconds) for day in days for seconds in clock.candidates())
        return min(moment for moment in there if moment > since)
    late = any(since < moment <= since + OVERNIGHT for moment in moments)
    if here.early and here.carried and since.time() >= NIGHT and not late:
        # "Lights out 10.30", then "alarm 6.45"
        mornings = (m + timedelta(days=later) for m in moments for later in (0, 1))
        return next((m for m in mornings if since < m and EARLY <= m.time() < NOON_TIME), None)
    if since.time() < here.policy.plausible_from:
        # "Leave it on overnight and switch it off at six"
        return next((moment for moment in moments if since <= moment <= since + CLOSE), None)
    return None


def _is_late(here: Standpoint, since: datetime, moments: Sequence[datetime]) -> bool:
    """Whether one of some moments follows what was said of an evening on a line before."""
    # "Rounds at eleven, two and five", said at nine in the evening
    listed = here.listed and here.now.time() >= EVENING and since - here.now <= CLOSE
    if not (here.carried or listed) or since.time() < EVENING:
        return False
    if since.time() >= NIGHT:
        # Who drains it at 22:00 puts it back by 1:30 that night.
        return any(since < moment <= since + OVERNIGHT for moment in moments)
    return any(since < moment <= since + CLOSE and moment.date() == since.date() for moment in moments)


def is_plausible(here: Standpoint, moment: datetime, *, ahead: bool) -> bool:
    """Whether people are up, for as long as what is asked for is said to last.

    On a day to come that is named they may be up earlier for some things.
    """
    first, last = here.policy.plausible_from, here.policy.plausible_to
    if not (here.usual or ahead) and _is_soon(here, moment):
        return True
    if not here.usual and EARLY <= here.now.time() < first <= last and moment.date() == here.now.date():
        # Who speaks at five is up at half past; dinner is in the evening all the same.
        first = here.now.time()
    if here.early and ahead and moment.date() > here.now.date():
        # Nothing is at six in the morning but what people do that early.
        first = min(first, here.policy.ahead_from)
    # "Stay up until three": the end of usual hours is one of them, but "theatre at eleven" is none.
    closes = here.usual and here.ends and moment.time() == last
    if first > last:
        return moment.time() >= first or moment.time() < last or closes
    end = moment + timedelta(seconds=here.lasting)
    return (first <= moment.time() < last or closes) and (
        not here.lasting or (end.date() == moment.date() and end.time() <= last)
    )


def is_unusual(here: Standpoint, moments: Sequence[datetime]) -> bool:
    """Whether people do what is asked for at none of some moments, as far as its usual hours are known."""
    return here.usual and not any(is_plausible(here, moment, ahead=True) for moment in moments)


def _is_soon(here: Standpoint, moment: datetime) -> bool:
    """Whether a moment is so soon that it is meant at any hour: "at three", said at ten to two at night."""
    policy, now = here.policy, here.now.time()
    if now == time():
        # The moment is given as a day.
        return False
    at_night = now >= policy.night_from or now < policy.night_to
    hours = policy.night_hours if at_night else policy.soon_hours
    return timedelta(0) <= moment - here.now <= timedelta(hours=hours)


def _leads(here: Standpoint, moment: datetime, clock: Clock) -> bool:
    """Whether a clock time follows on the same day, while people are up where its half is not said."""
    there = (midnight(moment.date()) + timedelta(seconds=seconds) for seconds in clock.candidates())
    return any(m > moment and (not clock.is_open or is_plausible(here, m, ahead=True)) for m in there)


def same_day_after(here: Standpoint, clock: Clock) -> list[datetime]:
    """Give the moments of a clock time on the day of what it follows with the same thing, or on a line."""
    if here.since is None or here.since.date() <= here.now.date():
        return []
    # At eight in the evening, who writes down a day begins with the next.
    next_day = here.in_order and here.opened is not None and here.opened.date() > here.now.date()
    if not here.onto and not next_day:
        return []
    if here.since.time() < EARLY:
        # "Run it at midnight and report by six": the morning that follows.
        return []
    there = (midnight(here.since.date()) + timedelta(seconds=seconds) for seconds in clock.candidates())
    return sorted(moment for moment in there if moment >= here.since)


def just_over(here: Standpoint, clock: Clock) -> list[datetime]:
    """Give the moments of a clock time that are a little while ago, where the day of the lines has begun."""
    if not here.begun:
        return []
    first = here.now - timedelta(hours=here.policy.begun_hours)
    there = (midnight(here.now.date()) + timedelta(seconds=seconds) for seconds in clock.candidates())
    since = max(first, here.since) if here.since is not None else first
    return sorted(moment for moment in there if since <= moment < here.now)


def within_window(here: Standpoint, clock: Clock) -> list[datetime]:
    """Give the moments of a clock time in the hours that a line above names; none where none is in them."""
    if here.window is None:
        return []
    first, last = here.window
    days = {midnight(end.date()) for end in here.window}
    there = (day + timedelta(seconds=seconds) for day in days for seconds in clock.candidates())
    return sorted(moment for moment in there if first <= moment <= last)


def before_due(here: Standpoint, clock: Clock) -> list[datetime]:
    """Give the last of a clock time's moments before what is prepared; none where that is far from it."""
    if here.due is None:
        return []
    days = (midnight(here.due.date()) - timedelta(days=back) for back in (0, 1))
    moments = [day + timedelta(seconds=seconds) for day in days for seconds in clock.candidates()]
    last = max(moment for moment in moments if moment <= here.due)
    # "My shift starts at nine, leave at five" is behind it.
    early = not here.ends and last != here.due and not is_plausible(here, last, ahead=True)
    return [last] if last > here.now and here.due - last <= FOLLOWING and not early else []
