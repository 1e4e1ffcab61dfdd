"""Exit codes, after sysexits.h where it has one."""

from enum import IntEnum


class Exit(IntEnum):
    """How the command ends."""

    FINE = 0
    FAILURE = 1
    USAGE = 2
    INFEASIBLE = 3
    BAD_DATA = 65
    NO_INPUT = 66
    IO_ERROR = 74
    BAD_CONFIG = 78
    INTERRUPT = 130
    CLOSED_PIPE = 141
