"""Choices that fit the tables to their users."""

from enum import StrEnum


class Profile(StrEnum):
    """Whose expectations the widths follow."""

    EVERYDAY = "everyday"
    """Wide, after the paper's introduction: "in about ten minutes" loses nothing five minutes off."""

    STUDY = "study"
    """The figures of the paper's study."""


class Actor(StrEnum):
    """Who is to act (the paper's question F2)."""

    ROBOT = "robot"
    PERSON = "person"
