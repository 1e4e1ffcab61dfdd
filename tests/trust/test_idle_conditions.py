"""What a condition decides is noted text by text, and it can be switched off."""

import ast
from pathlib import Path
from typing import Any

from trust import idle_conditions

SOURCE = """
def is_wanted(number):
    if number > 2 or number > 100:
        return number != 4
    return False
"""


def test_a_condition_reports_the_texts_in_which_it_decides() -> None:
    watch = idle_conditions.Watch()
    tree = idle_conditions.Watched(Path("module.py"), SOURCE, watch).visit(ast.parse(SOURCE))
    names: dict[str, Any] = {"watch_": watch}
    exec(compile(ast.fix_missing_locations(tree), "module.py", "exec"), names)  # noqa: S102 - of this file
    for number in range(6):
        watch.text = number
        names["is_wanted"](number)
    decided = {site.said: site.texts for site in watch.sites}
    assert decided == {
        "number > 2": {3, 4, 5},
        "number > 100": set(),
        "number > 2 or number > 100": {3, 4, 5},
    }
    watch.off = next(place for place, site in enumerate(watch.sites) if site.said == "number > 2")
    assert [names["is_wanted"](number) for number in range(6)] == [False] * 6
