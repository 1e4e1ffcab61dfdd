"""Orders whose tree takes another word for their verb, given it: "feed grandpa", "press start"."""

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.sentence.trees.tags import DETERMINERS, NOUNS
from fuzzytime.language.sentence.trees.tree import Node, Tree

LEAST_DONE = 3
"""Words of "review pull requests"."""

LET = 2
"""Words of "press start"."""

OF_VERBS = frozenset({"dobj", "prep", "npadvmod", "advmod", "prt", "tmod"})
"""Relations of words to the verb in front of them."""


def with_verb(tree: Tree) -> Tree | None:
    """Give an order whose tree has another word for its verb that verb; None where it has none."""
    orders = (
        *(_orders_verb, _switches, _does_led, _does_owned, _calls_person, _lists_order, _does_compound),
        *(_goes_to_do, _has_done, _does_that, _is_asked, _is_to_be_done),
    )
    return next((mended for does in orders if (mended := does(tree)) is not None), None)


def does_to_person(tree: Tree) -> Tree | None:
    """Give "feed grandpa at ten" its verb, where who stands right behind was taken for it."""
    lexicon = tree.lexicon
    if tree.root != 1 or not tree.nodes[1].is_verb:
        return None
    first, person = tree.nodes[:LET]
    acts = first.may_act and first.lower == first.lemma and first.tag in NOUNS | {"VB"}
    known = person.lower in lexicon.persons | lexicon.animals and not person.may_act
    # "Ping frank at nine", "show rose the flat"; but "help mark the books"
    leads = first.lower in lexicon.doing.trying | lexicon.doing.watching | lexicon.letting
    called = person.lower in lexicon.names_like_words and (person.lower != person.lemma or not leads)
    if not acts or not (known or called):
        return None
    return None if first.lower in lexicon.persons else with_thing_done(tree, 1)


def _orders_verb(tree: Tree) -> Tree | None:
    """Give "press start" its verb, where what is pressed, or are several, was taken for it."""
    if len(tree.nodes) < LET or tree.root != 1 or tree.nodes[0].relation not in {"aux", "compound", "nsubj"}:
        return None
    called = tree.nodes[1].may_act and tree.nodes[1].lower == tree.nodes[1].lemma
    orders = called and tree.nodes[0].lower in tree.lexicon.ordering
    orders = orders or _orders_several(tree.nodes[0], tree.nodes[1], tree.lexicon)
    return with_thing_done(tree, 1) if orders else None


def _switches(tree: Tree) -> Tree | None:
    """Give "switch pump off" its verb, to which the word behind its thing belongs."""
    if len(tree.nodes) < LEAST_DONE or tree.root != 1 or tree.nodes[0].head != 1:
        return None
    verb, thing, behind = tree.nodes[:LEAST_DONE]
    known = verb.lower in tree.lexicon.particles.get(behind.lower, ()) and verb.lower == verb.lemma
    # "Power's off from nine"
    named = thing.may_name and thing.text[0].isalnum()
    return with_thing_done(tree, 1) if known and named and behind.head == 1 else None


def _orders_several(verb: Node, things: Node, lexicon: Lexicon) -> bool:
    """Whether something is done with several: "water plants", "feed chickens"; but "swim lessons" happen."""
    done = lexicon.chores | lexicon.doing.by_the_day | lexicon.dosing | lexicon.ordering
    timed = lexicon.happening | lexicon.taken | lexicon.events
    bare = verb.tag == "NN" and verb.lower in done - lexicon.addressing
    # "Water ferns": no verb for what a noun does
    several = things.tag == "NNS" or (things.tag == "VBZ" and not things.may_act)
    return bare and several and timed.isdisjoint({things.lower, things.lemma})


def _does_led(tree: Tree) -> Tree | None:
    """Give "thaw the cells", "hoover the stairs" its verb: no noun or adverb is followed by an article."""
    lexicon = tree.lexicon
    root = tree.root
    if len(tree.nodes) < LEAST_DONE:
        return None
    first, led = tree.nodes[:LET]
    bare = first.may_act and first.lower == first.lemma and led.tag in DETERMINERS
    if bare and first.tag == "VB" and first.relation == "nsubj" and root >= LEAST_DONE:
        # "Schedule a team call": no verb is who does another.
        event = with_thing_done(tree, root).hung(range(1, root), root)
        return event.changed(root - 1, relation="compound")
    beside = lexicon.entries.keys() | lexicon.places | lexicon.particles.keys() | lexicon.function_words
    if not bare or first.is_verb or first.lower in beside:
        return None
    if root == 0 and led.head in tree.children(0, "dobj", "pobj", "nsubj"):
        return with_thing_done(tree, led.head)
    described = first.head == root and first.relation in {"npadvmod", "advmod", "compound", "amod", "nmod"}
    named = tree.nodes[root].tag.startswith("NN") and led.head == root
    return with_thing_done(tree, root) if described and named else None


def _does_owned(tree: Tree) -> Tree | None:
    """Give "iron Ann's shirt" its verb, which a tree takes for a part of a name: "Uncle Tom's cabin"."""
    root = tree.root
    if root < LEAST_DONE or tree.children(1, "case") != (LET,) or tree.nodes[0].head not in {1, root}:
        return None
    first, owner = tree.nodes[:LET]
    orders = first.may_act and first.lower not in tree.lexicon.persons and first.lower == first.text
    owned = owner.relation == "poss" and owner.head == root and tree.nodes[root].tag in NOUNS
    return with_thing_done(tree, root) if orders and owned else None


def _has_done(tree: Tree) -> Tree | None:
    """Give "have ben slice the tomato" who does it, whom a tree takes for a part of what is done."""
    root, nodes = tree.root, tree.nodes
    helps = nodes[0].lower in tree.lexicon.causing and nodes[0].relation == "aux" and nodes[0].head == root
    if not helps or root != LET or nodes[1].relation not in {"compound", "npadvmod", "nmod"}:
        return None
    person = nodes[1].lower in tree.lexicon.persons or nodes[1].tag == "NNP"
    return tree.changed(1, relation="nsubj") if person and nodes[root].is_bare else None


def _does_that(tree: Tree) -> Tree | None:
    """Give "check that oven at six" its thing, which a tree takes for where, or for what that does."""
    lexicon = tree.lexicon
    if tree.root not in {0, LET} or len(tree.nodes) <= LET or tree.nodes[1].lower != "that":
        return None
    verb, that, thing = tree.nodes[: LET + 1]
    taken = that.relation in {"dobj", "nsubj", "mark", "det"} and thing.relation != "dobj"
    taken = taken and thing.head == tree.root and verb.may_act and verb.lower == verb.lemma
    taken = taken and verb.lower not in lexicon.function_words
    # "Boil that spaghetti", "lock that shed"; but "check that works"
    taken = taken and (thing.tag in {"IN", "VBG", "NN", "NNS"} or thing.is_bare or not thing.may_act)
    # "Make that dressing"; but "keep that going"
    led = thing.lower not in lexicon.places | lexicon.particles.keys() and (
        thing.tag == "VBG" or thing.lower not in lexicon.function_words
    )
    becomes = verb.lemma in (lexicon.causing | lexicon.letting) - {"make"}
    behind = tree.nodes[LET + 1 : LET + 2]
    if (
        not taken
        or not led
        or becomes
        or any(node.tag in DETERMINERS | NOUNS or node.tag.startswith(("VB", "MD")) for node in behind)
    ):
        return None
    named = tree.hung(tree.children(LET), 0).changed(0, tag="VB", relation="ROOT", head=0)
    named = named.changed(1, tag="DT", relation="det", head=LET)
    return named.changed(LET, tag="NN", lemma=thing.lower, relation="dobj", head=0)


def _calls_person(tree: Tree) -> Tree | None:
    """Give "facetime granny", "zoom aunt jo" its verb, where who is called was taken for it."""
    lexicon = tree.lexicon
    root = tree.root
    beside = tree.nodes[0].head == root and tree.nodes[0].relation in {"compound", "nsubj", "npadvmod"}
    if not 0 < root < LEAST_DONE or not beside or tree.nodes[root].is_verb:
        return None
    who = tree.nodes[1 : root + 1]
    names = lexicon.people
    person = any(node.lower in names or node.text[0].isupper() for node in who)
    # "Text rob at six"; but "text message", "phone call"
    things = lexicon.taken | lexicon.happening | lexicon.events | lexicon.doing.letters
    person = person or (who[-1].may_act and who[-1].lower not in things)
    calls = tree.nodes[0].lower in lexicon.addressing - lexicon.persons
    return with_thing_done(tree, root) if calls and person else None


def _is_asked(tree: Tree) -> Tree | None:
    """Give "could you hoover under the beds" its verb, which a tree takes for no verb."""
    root = tree.root
    helping, subjects = tree.children(root, "aux"), tree.children(root, "nsubj")
    asked = bool(helping) and tree.nodes[helping[0]].tag == "MD" and bool(subjects)
    if (
        not asked
        or subjects[-1] > root
        or tree.nodes[root].is_verb
        or tree.nodes[root].lower not in tree.lexicon.orders
    ):
        return None
    return tree.changed(root, tag="VB", lemma=tree.nodes[root].lower)


def _lists_order(tree: Tree) -> Tree | None:
    """Give "add mop the hall to my chores" its verb, which a tree takes for one that helps another."""
    root, nodes = tree.root, tree.nodes
    things = tree.children(root, "dobj")
    listed = root == 1 and nodes[0].lower in tree.lexicon.beside.listing and nodes[0].relation == "aux"
    if not listed or not things or not any(nodes[p].lower == "to" for p in tree.children(root, "prep")):
        return None
    listing = tree.hung(tree.children(root, "prep"), 0).changed(0, tag="VB", relation="ROOT", head=0)
    named = listing.changed(root, tag="NN", relation="compound", head=things[0])
    return named.changed(things[0], relation="dobj", head=0)


def _does_compound(tree: Tree) -> Tree | None:
    """Give "review pull requests", "strip used beds" its verb, where the second word was taken for it.

    A noun in the singular and a bare verb do not agree; and who would be called has a name of its own.
    """
    if tree.root != 1 or len(tree.nodes) < LEAST_DONE:
        return None
    first, second, third = tree.nodes[:LEAST_DONE]
    things = tree.children(1, "dobj")
    used = second.tag == "VBD" and first.lower in tree.lexicon.orders - tree.lexicon.names_like_words
    bare = first.tag == "NN" and first.may_act and second.tag in {"VB", "VBP"}
    if (
        not (bare or used)
        or third.tag not in {"NN", "NNS"}
        or first.lower in tree.lexicon.persons | tree.lexicon.workers
        or not things
    ):
        return None
    done = tree.hung(tree.children(1), 0).changed(0, tag="VB", relation="ROOT", head=0)
    kind = {"tag": "VBN", "relation": "amod"} if used else {"tag": "NN", "relation": "compound"}
    return done.changed(1, head=things[0], **kind)


def _goes_to_do(tree: Tree) -> Tree | None:
    """Give "go feed the cat" what is to be done, beside which "go" and "come" say nothing more."""
    if tree.root != 0 or len(tree.nodes) < LEAST_DONE or tree.nodes[0].lemma not in tree.lexicon.doing.trying:
        return None
    done = tree.nodes[1]
    # "Go mist the ferns": no noun is followed by an article
    bare = done.tag == "VB" or (done.tag in NOUNS and done.may_act and tree.nodes[2].tag in DETERMINERS)
    if not bare or done.head != 0 or tree.children(1, "aux", "mark", "det"):
        return None
    led = tree.hung(tree.children(0), 1).changed(0, relation="aux", head=1)
    return led.changed(1, tag="VB", relation="ROOT")


def _is_to_be_done(tree: Tree) -> Tree | None:
    """Give "remind me to hoover the stairs" what is to be done, which a tree takes for where to."""
    for place in range(LET, len(tree.nodes)):
        to, done, behind = tree.nodes[place - 1], tree.nodes[place], tree.nodes[place + 1 : place + 2]
        if to.lower != "to" or not done.may_act or done.lower != done.lemma:
            continue
        if done.relation in {"compound", "amod"} and place < done.head:
            mended = _asked_to_do(tree, place)
            if mended is not None:
                return mended
        if to.relation != "prep" or done.relation != "pobj" or done.head != place - 1:
            continue
        ends = done.lower in tree.lexicon.needing_nothing and not behind
        # No noun is followed by an article.
        if ends or any(node.tag in DETERMINERS for node in behind):
            nodes = enumerate(tree.nodes)
            later = [p for p, node in nodes if node.head < place < p and node.relation in OF_VERBS]
            mended = tree.hung(later, place).changed(place - 1, tag="TO", relation="aux", head=place)
            return mended.changed(place, tag="VB", lemma=done.lower, relation="xcomp", head=to.head)
    return None


def _asked_to_do(tree: Tree, place: int) -> Tree | None:
    """Give "I have to ice cakes" what is to be done, which a tree takes for what kind of thing that is."""
    lexicon = tree.lexicon
    asking = lexicon.wanting | lexicon.forgetting | lexicon.doing.remembering | lexicon.doing.requesting
    asks = next((p for p in range(place - 2, -1, -1) if tree.nodes[p].is_verb), None)
    if asks is None or tree.nodes[asks].lemma not in asking | {"have"}:
        return None
    thing = tree.nodes[place].head
    mended = tree.hung((p for p in tree.children(thing) if p < place or thing < p), place)
    mended = mended.changed(place - 1, tag="TO", relation="aux", head=place)
    mended = mended.changed(place, tag="VB", lemma=tree.nodes[place].lower, relation="xcomp", head=asks)
    return mended.changed(thing, relation="dobj", head=place)


def with_thing_done(tree: Tree, thing: int) -> Tree:
    """Make the first word the verb, a thing its object, and what hung on that behind it the verb's.

    What else is named stays with the thing: "email tom and ben".
    """
    joined = tree.children(thing, "cc", "conj")
    named = all(tree.nodes[p].tag in NOUNS for p in joined if tree.nodes[p].relation == "conj")
    kept = joined if named else ()
    moved = tree.hung((p for p in tree.children(thing) if p > thing and p not in kept), 0)
    moved = moved.changed(0, tag="VB", relation="ROOT", head=0)
    return moved.changed(thing, tag="NN", relation="dobj", head=0)


def with_deed_named(tree: Tree) -> Tree:
    """Give "start the cool down", "do the warm up" the whole thing, of which a tree gives the verb a part.

    So of "on the way out". But "put the wash up", where the verb is one with that word, too.
    """
    particles, doing = tree.lexicon.particles, tree.lexicon.doing
    attended = doing.of_events | doing.beginning | doing.ending
    for place in range(2, len(tree.nodes)):
        node, named, opener = tree.nodes[place], tree.nodes[place - 1], tree.nodes[place - 2]
        verb = tree.nodes[tree.root]
        verbs = particles.get(node.lower, frozenset())
        deed = not verbs.isdisjoint({named.lower, named.lemma}) and (
            verb.lemma not in verbs or verb.lemma in attended
        )
        ways = named.lower in tree.lexicon.closed.ways
        led = opener.tag in DETERMINERS and (node.head == tree.root or node.head == place - 1)
        if led and (deed or ways) and tree.root < place - 2 and not tree.children(place):
            tree = tree.changed(place, tag="NN", head=place - 1, relation="compound")
            tree = tree if ways else tree.changed(place - 1, tag="NN")
    return tree
