"""Penn tags and relations that several readers of trees ask for."""

SUBJECTS = ("nsubj", "nsubjpass")
"""Relations of who or what does something."""

GRAMMATICAL_SUBJECTS = (*SUBJECTS, "expl")
"""And of "there" and "it" that stand for nothing."""

DETERMINERS = frozenset({"DT", "PRP$"})
"""Tags of words that begin a noun's: "the", "my"."""

IMPERATIVE = frozenset({"VB", "VBP"})
"""Tags of bare verbs."""

PRESENT = frozenset({"VBZ", "VBP"})
"""Tags of verbs of what is so now."""

SINGULAR = frozenset({"NN", "NNP"})
"""Tags of nouns that name one."""

NOUNS = frozenset({"NN", "NNS", "NNP"})
"""Tags of things, and of orders taken for one."""

ALL_NOUNS = NOUNS | {"NNPS"}
"""Tags of all that names something."""

NAMING = ALL_NOUNS | DETERMINERS | {"JJ", "CD", "POS"}
"""Tags of the words of a name."""

FINITE = frozenset({"VBZ", "VBP", "VBD", "MD"})
"""Tags of what says that something is so."""

PAST = frozenset({"VBN", "VBD"})
"""Tags of what was done; trees mistake one for the other."""
