"""What the help says of options is so."""

import re
from typing import get_type_hints

import pytest

from fuzzytime_cli.options import Solving
from fuzzytime_cli.settings import KINDS

HELPS = {
    name: hint.__metadata__[0].help
    for name, hint in get_type_hints(Solving, include_extras=True).items()
    if "default" in hint.__metadata__[0].help
}


@pytest.mark.parametrize("name", HELPS)
def test_the_help_tells_the_default_that_counts(name: str) -> None:
    (said,) = re.findall(r"\(default ([\d.]+)\)|(\w+) \(the default\)", HELPS[name])
    assert "".join(said) == str(KINDS[name].default).removesuffix(".0")
