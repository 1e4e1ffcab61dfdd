"""The model's labels in the paper's terms, and the paper's strict reading of a tree.

The paper names Universal Dependencies relations; the model's scheme hangs a noun below its preposition, the
paper's the preposition below the noun. One table and one turn bring the one to the other.
"""

from collections.abc import Collection

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import StrictReading, Token
from fuzzytime.language.sentence.trees.tree import Tree

UNIVERSAL = {
    "npadvmod": "obl:tmod",
    "quantmod": "advmod",
    "dobj": "obj",
    "dative": "iobj",
    "nsubjpass": "nsubj:pass",
    "auxpass": "aux:pass",
    "prt": "compound:prt",
    "poss": "nmod:poss",
    "relcl": "acl:relcl",
    "neg": "advmod",
    "acomp": "xcomp",
    "attr": "xcomp",
    "pcomp": "advcl",
    "ROOT": "root",
}
"""Relations of the model by their name in the paper; the others have the same."""

_TIMELY = frozenset(
    {"unit", "day", "part", "meal", "day_part", "weekday", "month", "feast", "season", "word"}
)


def paper_tokens(tree: Tree, timely: Collection[int]) -> tuple[Token, ...]:
    """Give a tree's words with the paper's relations and heads.

    ``timely`` are words known to be about time: below a verb they are oblique temporal modifiers.
    """
    heads = [node.head for node in tree.nodes]
    relations = [UNIVERSAL.get(node.relation, node.relation) for node in tree.nodes]
    for place, node in enumerate(tree.nodes):
        if node.relation != "pobj" or tree.nodes[node.head].relation == "ROOT":
            continue
        over = tree.nodes[node.head].head
        heads[place], heads[node.head] = over, place
        relations[node.head] = "case"
        verbal = tree.nodes[over].is_verb
        relations[place] = ("obl:tmod" if place in timely else "obl") if verbal else "nmod"
        # What hung on the preposition ("about" in "in about four minutes") hangs on the number, or the noun.
        number = next(iter(tree.children(place, "nummod")), place)
        for child in tree.children(node.head, "advmod"):
            heads[child] = number
    return tuple(
        Token(node.text, (node.start, node.end), node.tag, relation, head, node.lemma)
        for node, relation, head in zip(tree.nodes, relations, heads, strict=True)
    )


def strict_reading(tree: Tree) -> tuple[tuple[Token, ...], StrictReading]:
    """Read a tree as the paper does.

    Search an oblique temporal modifier of the root verb; from it, recursively, number, fuzziness and
    preposition (section III-B1).
    """
    timely = {place for place, node in enumerate(tree.nodes) if is_timely(node.lower, tree.lexicon)}
    tokens = paper_tokens(tree, timely)
    root = tree.root
    if not tree.nodes or not tree.nodes[root].is_verb:
        return tokens, StrictReading()
    modifiers = [
        place
        for place, token in enumerate(tokens)
        if token.head == root
        and place != root
        and (token.relation == "obl:tmod" or place in timely)
        and token.relation in {"obl:tmod", "obl", "advmod"}
    ]
    if not modifiers:
        return tokens, StrictReading(verb=root)
    modifier = modifiers[0]
    below = _below(tokens, modifier)
    number = next((p for p in below if tokens[p].relation == "nummod"), None)
    fuzziness = next((p for p in below if tokens[p].relation == "advmod"), None)
    preposition = next((p for p in below if tokens[p].relation == "case"), None)
    return tokens, StrictReading(root, modifier, number, fuzziness, preposition)


def is_timely(word: str, lexicon: Lexicon) -> bool:
    """Whether a word alone is about time."""
    return lexicon.means(word, *_TIMELY)


def _below(tokens: tuple[Token, ...], place: int) -> list[int]:
    """Give the words under a word, in their order."""
    found = {place}
    while True:
        more = {p for p, token in enumerate(tokens) if token.head in found and p not in found}
        if not more:
            return sorted(found - {place})
        found |= more
