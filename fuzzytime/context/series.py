"""One signal over all of time: what was read, what lies between, and what is forecast."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from fuzzytime.context.forecast import Forecast, forecast
from fuzzytime.context.readings import Context, Reading
from fuzzytime.context.signals import Signal
from fuzzytime.satisfaction import Floats


@dataclass(frozen=True, slots=True, eq=False)
class Series:
    """A signal's readings by time, in its own unit, and its forecast.

    ``forecast`` is None where there is none: without a reading, or where the last one is older than the
    signal's maximum age at time 0. Then what follows that age is unknown.
    """

    signal: Signal
    times: Floats
    values: Floats
    forecast: Forecast | None

    @classmethod
    def of(cls, signal: Signal, readings: Sequence[Reading]) -> "Series":
        """Make the series of admitted readings, by ascending times."""
        times = np.array([reading.at for reading in readings], float)
        values = np.array([reading.value for reading in readings], float)
        if not times.size:
            return cls(signal, times, values, None)
        return cls(signal, times, values, forecast(signal, times, values))

    @classmethod
    def within(cls, context: Context, signal: Signal) -> "Series":
        """Give the series of a signal in an admitted context, which remembers it."""
        return context.derived(signal, lambda: cls.of(signal, context.of_signal(signal.name)))

    @property
    def known_until(self) -> float:
        """The time after which nothing is known; before the first reading where there is none."""
        if self.forecast is None:
            return -math.inf
        last = float(self.times[-1])
        too_old = last + self.signal.max_age
        return min(self.forecast.until, too_old if too_old < 0 else math.inf)

    @property
    def components(self) -> tuple[float, ...]:
        """The weights of the forecast's components; one where nothing is forecast."""
        return (1.0,) if self.forecast is None else tuple(part.weight for part in self.forecast.components)

    def at(self, times: Floats, component: int = 0) -> Floats:
        """Give values of shape (curves, k) at ascending times of shape (k,), NaN where they are unknown.

        Between two readings the signal runs straight; a gap longer than the signal's maximum is unknown.
        """
        if self.forecast is None:
            return np.full((1, times.size), np.nan)
        past = np.searchsorted(times, self.times[-1], "right")
        known = np.interp(times[:past], self.times, self.values, left=np.nan)
        before = np.clip(np.searchsorted(self.times, times[:past], "right") - 1, 0, self.times.size - 1)
        after = np.minimum(before + 1, self.times.size - 1)
        gap = self.times[after] - self.times[before]
        known[(gap > self.signal.max_gap) & (times[:past] > self.times[before])] = np.nan
        if past == times.size:
            # What was read is the same for all curves.
            return known[None, :]
        ahead = self.forecast.values(component, times[past:])
        ahead[:, times[past:] > self.known_until] = np.nan
        return np.concatenate([np.broadcast_to(known, (ahead.shape[0], past)), ahead], axis=1)
