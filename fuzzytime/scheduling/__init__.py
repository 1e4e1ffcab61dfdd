"""FuzzyTask to Schedule: provably best start times."""

from fuzzytime.scheduling.schedule import Certificate, Schedule, Status

__all__ = ["Certificate", "Schedule", "Status"]
