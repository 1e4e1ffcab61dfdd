"""Tables of cells as spreadsheets and data loggers write them: commas between cells, or what stands for them.

Where people write a comma for the decimal point, their spreadsheets put semicolons between the cells.
"""

import re

_DELIMITERS = (",", ";", "\t")
_DECIMAL_COMMA = re.compile(r"(\s*[-+\u2212]?\d*),(\d)")


def delimiter_of(head: str) -> str:
    """Give what stands between the cells of a table, by its first line.

    >>> delimiter_of("at_s,pan_temp"), delimiter_of("at_s;pan_temp"), delimiter_of("at_s")
    (',', ';', ',')
    """
    return max(_DELIMITERS, key=head.count)


def with_point(cell: str, delimiter: str) -> str:
    """Give a cell with a decimal point for a decimal comma, where cells have another sign between.

    >>> with_point("60,5 degC", ";"), with_point("60.5", ";"), with_point("when hot, flip", ";")
    ('60.5 degC', '60.5', 'when hot, flip')
    """
    found = None if delimiter == "," else _DECIMAL_COMMA.match(cell)
    return cell if found is None else f"{found[1]}.{cell[found.start(2) :]}"
