"""What would come of something that is only supposed: "what if I start the essays at ten?"."""

from dataclasses import replace

from fuzzytime.language import verb_forms
from fuzzytime.language.about_wishes import About, AboutKind, Said, about_wishes
from fuzzytime_cli.repl.commands.by_name import what_if
from fuzzytime_cli.repl.plain_words.known import is_known
from fuzzytime_cli.repl.plain_words.meant import command_meant
from fuzzytime_cli.repl.plain_words.reasons import CHANGING
from fuzzytime_cli.repl.plain_words.said_again import same_anew
from fuzzytime_cli.repl.scene import Offer, Reply, Scene

MARKS_OF_COMMANDS = ":/"


def supposed(scene: Scene, text: str) -> Reply:
    """Show what would come of it: a wish, or what is said of those there are."""
    about = about_wishes(text, scene.now, scene.lexicon)
    about = about or _begun_then(scene, text)
    line = None if about is None or about.text else _supposable(scene, about)
    # "What if I start the rice at six?", which was to be started at five
    tried = line or same_anew(scene, text) or text
    offer = Offer(line=tried) if tried[0] in MARKS_OF_COMMANDS else Offer(thing=text)
    return replace(what_if(scene, tried), offer=offer)


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
    return command_meant(scene, about) if about.kind in CHANGING else None
