"""English as it is shipped, and the moment at which the corpus of sentences is said."""

from functools import cache

import yaml

from fuzzytime.language import Language
from language.corpus_rows import FOLDER, instant

CORPUS = yaml.safe_load((FOLDER / "sentences.yaml").read_text("utf-8"))
NOW = instant(CORPUS["now"])


@cache
def language() -> Language:
    return Language.shipped()
