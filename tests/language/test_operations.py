"""The verb that is meant, its object and place, and the moment of a time, from trees built by hand."""

import pytest

from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.language.sentence.verbs.meant.actions import action_of, is_doubtful
from fuzzytime.language.sentence.verbs.operations.operations import Reader
from fuzzytime.requirement import Reference
from language.trees import PLACE_THE_PAN, tree

WANT = tree(
    "I PRP nsubj want", "want VBP ROOT want", "to TO aux wash", "wash VB xcomp want", "it PRP dobj wash"
)
FORGET = tree(
    "do VBP aux forget", "n't RB neg forget", "forget VB ROOT forget", "to TO aux eat", "eat VB xcomp forget"
)
START = tree("start VB ROOT start", "cooking/cook VBG xcomp start", "the DT det rice", "rice NN dobj cooking")
READY = tree("have VB ROOT have", "the DT det rice", "rice NN nsubj ready", "ready JJ ccomp have")
LET_US = tree("let VB ROOT let", "us PRP nsubj eat", "eat VB ccomp let")
LET_ME = tree("let VB ROOT let", "me PRP nsubj know", "know VB ccomp let")
STATEMENT = tree("the DT det rice", "rice NN nsubj boil", "should MD aux boil", "boil VB ROOT boil")
CAT = tree("feed VB ROOT feed", "the DT det \U0001f431", "\U0001f431 NN dobj feed")
FEE = tree("pay VB ROOT pay", "50 CD nummod €", "€ NNS dobj pay", "! . punct pay")
DINNER = tree("dinner NN nsubj is", "is/be VBZ ROOT is")
QUIET = tree("be VB ROOT be", "quiet JJ acomp be")
NO_VERB = tree("the DT det rice", "rice NN ROOT rice")
GO = tree("have VBP aux go", "the DT det robot", "robot NN nsubj go", "go VB ROOT go")


@pytest.mark.parametrize(
    ("parsed", "verb", "reference", "negated"),
    [
        (PLACE_THE_PAN, "Place", None, False),
        (WANT, "wash", None, False),
        (FORGET, "eat", None, False),
        (START, "cooking", Reference.START, False),
        (READY, "have", Reference.FINISH, False),
        (LET_US, "eat", None, False),
        (LET_ME, "let", None, False),
        (STATEMENT, "boil", None, False),
        (GO, "have", None, False),
    ],
)
def test_the_verb_is_the_one_that_is_meant(
    parsed: Tree,
    verb: str,
    reference: Reference | None,
    negated: bool,  # noqa: FBT001
) -> None:
    action = action_of(parsed)
    assert action is not None
    assert (parsed.nodes[action.place].text, action.reference, action.negated) == (verb, reference, negated)


def test_without_a_verb_there_is_no_action_and_the_tree_is_doubtful() -> None:
    assert action_of(NO_VERB) is None
    assert is_doubtful(NO_VERB)
    assert not is_doubtful(PLACE_THE_PAN)


@pytest.mark.parametrize(
    ("parsed", "times", "name"),
    [
        (PLACE_THE_PAN, [(25, 46)], "place the pan on a stove"),
        (PLACE_THE_PAN, [], "place the pan on a stove in about four minutes"),
        (WANT, [], "wash it"),
        (READY, [], "have the rice ready"),
        (STATEMENT, [], "the rice must boil"),
        (DINNER, [], "dinner"),
        (QUIET, [], "be quiet"),
        (CAT, [], "feed the \U0001f431"),
        (FEE, [], "pay 50 €"),
    ],
)
def test_an_operation_is_named_without_its_time(
    parsed: Tree, times: list[tuple[int, int]], name: str
) -> None:
    action = action_of(parsed)
    assert action is not None
    assert Reader(parsed, times).operation(action).name == name
