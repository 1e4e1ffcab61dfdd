"""Words that name no time."""

from fuzzytime.errors import FuzzytimeError


class UngroundedError(FuzzytimeError):
    """Words that name no time: a date that does not exist, a time of day when no clock is known."""
