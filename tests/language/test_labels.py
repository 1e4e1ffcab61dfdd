"""The model's labels become the paper's, and its strict reading finds what its figure shows."""

from fuzzytime.language.instruction import StrictReading
from fuzzytime.language.sentence.trees.labels import strict_reading
from language.trees import PLACE_THE_PAN, tree


def test_the_papers_figure_is_read_as_the_figure_shows() -> None:
    tokens, strict = strict_reading(PLACE_THE_PAN)
    found = {
        name: tokens[place].text
        for name in ("verb", "modifier", "number", "fuzziness", "preposition")
        if (place := getattr(strict, name)) is not None
    }
    assert found == {
        "verb": "Place",
        "modifier": "minutes",
        "number": "four",
        "fuzziness": "about",
        "preposition": "in",
    }


def test_a_noun_hangs_on_the_verb_and_its_preposition_on_the_noun() -> None:
    tokens, _ = strict_reading(PLACE_THE_PAN)
    relations = {token.text: (token.relation, tokens[token.head].text) for token in tokens}
    assert relations["minutes"] == ("obl:tmod", "Place")
    assert relations["in"] == ("case", "minutes")
    assert relations["stove"] == ("obl", "Place")
    assert relations["four"] == ("nummod", "minutes")


def test_a_bare_noun_of_time_is_an_oblique_modifier() -> None:
    tokens, strict = strict_reading(tree("Leave VB ROOT Leave", "tomorrow NN npadvmod Leave"))
    assert tokens[1].relation == "obl:tmod"
    assert strict == StrictReading(verb=0, modifier=1)


def test_without_a_verb_at_the_root_nothing_is_found() -> None:
    _, strict = strict_reading(tree("in IN ROOT in", "minutes NNS pobj in"))
    assert strict == StrictReading()


def test_a_time_below_another_clause_is_none_of_the_roots() -> None:
    _, strict = strict_reading(
        tree(
            "remind VB ROOT remind",
            "me PRP dobj remind",
            "to TO aux call",
            "call VB xcomp remind",
            "at IN prep call",
            "noon NN pobj at",
        )
    )
    assert strict == StrictReading(verb=0)
