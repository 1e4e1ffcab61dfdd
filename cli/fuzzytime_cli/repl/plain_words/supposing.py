"""What would come of something that is only supposed: "what if I start the essays at ten?"."""

from collections.abc import Callable
from dataclasses import replace

from fuzzytime.language import verb_forms
from fuzzytime.language.about_wishes import About, AboutKind, Said, about_wishes
from fuzzytime_cli.repl.commands.by_name import DID, what_if
from fuzzytime_cli.repl.commands.looking import what_would_move
from fuzzytime_cli.repl.plain_words.known import is_known
from fuzzytime_cli.repl.plain_words.meant import command_meant
from fuzzytime_cli.repl.plain_words.reasons import CHANGING
from fuzzytime_cli.repl.plain_words.said_again import same_anew
from fuzzytime_cli.repl.plain_words.usually_said import as_usually_said
from fuzzytime_cli.repl.scene import Offer, Reply, Scene
from fuzzytime_cli.session import State

MARKS_OF_COMMANDS = ":/"

Answered = Callable[[Scene, str], Reply | None]
"""What takes a line as it is said of wishes; in a scene where that is only ``tried`` it changes nothing."""


def supposed(scene: Scene, text: str, answered: Answered) -> Reply:
    """Show what would come of it: a wish, or what is said of those there are, as that is ``answered``."""
    asked = _of_now(scene, text)
    text = as_usually_said(scene, asked)
    about = about_wishes(text, scene.now, scene.lexicon)
    about = about or _begun_then(scene, text)
    line = None if about is None or about.text else _supposable(scene, about)
    # "What if I start the rice at six?", which was to be started at five
    line = line or same_anew(scene, text)
    states: list[State] = []
    if line is None and (reply := answered(replace(scene, tried=states), text)) and states:
        # "What if the call takes an hour?"
        told = what_would_move(scene, DID, states[-1])
        return replace(told, offer=Offer(thing=asked), focus=reply.focus)
    tried = line or asked
    offer = Offer(line=tried) if tried[0] in MARKS_OF_COMMANDS else Offer(thing=asked)
    return replace(what_if(scene, tried), offer=offer)


def _of_now(scene: Scene, text: str) -> str:
    """Give what is supposed as it is asked for, where its verb is of before: "skipped lunch"."""
    lexicon = scene.lexicon
    word, _, rest = text.partition(" ")
    dropping = {form[0] for form in lexicon.conversation["dropping"] if len(form) == 1}
    verbs = lexicon.past.keys() | lexicon.orders | lexicon.rescheduling | dropping
    of_now = (verb for verb in sorted(verbs) if word in verb_forms(verb, lexicon) - {verb})
    return text if word in verbs else f"{next(of_now, word)} {rest}".rstrip()


def _begun_then(scene: Scene, text: str) -> About | None:
    """Read when something planned is to begin, whatever is done with it: "start the essays at ten"."""
    said = Said.of(text, scene.now, scene.lexicon)
    thing, time = said.behind(1).parted() if said.words else ("", "")
    named = Said(thing, scene.now, scene.lexicon)
    doing = scene.lexicon.doing
    verbs = {form for verb in doing.beginning | doing.spending for form in verb_forms(verb, scene.lexicon)}
    # "What if I did the shed at two?"
    known = bool(thing and time) and said.forms[0] in verbs and is_known(scene, named, told=False)
    return About(kind=AboutKind.MOVE, names=named.meant, time=time) if known else None


def _supposable(scene: Scene, about: About) -> str | None:
    # "What if the call takes an hour?"
    lasts = about.kind is AboutKind.TAKES
    about = replace(about, kind=AboutKind.MOVE) if lasts else about
    return command_meant(scene, about) if about.kind in CHANGING else None
