"""Completion at the prompt: commands after a colon, else verbs, words of conditions, and time words."""

from collections.abc import Iterable, Iterator

from prompt_toolkit.completion import CompleteEvent, Completer, Completion
from prompt_toolkit.document import Document

from fuzzytime.rulebook import Rulebook
from fuzzytime_cli.repl.commands.by_name import COMMANDS


class WordCompleter(Completer):
    """Completes the word under the cursor from the commands or from the tables' words."""

    def __init__(self, verbs: Iterable[str], words: Iterable[str], signals: Iterable[str]) -> None:
        self.verbs, self.words, self.signals = sorted(set(verbs)), sorted(set(words)), sorted(set(signals))

    @classmethod
    def of_rulebook(cls, rulebook: Rulebook) -> "WordCompleter":
        """Take the words that the tables know."""
        tables = rulebook.tables
        verbs = (verb for verb, _ in tables.durations.rows)
        conditions = (
            f"{word} is {term}" for v in tables.variables.values() for word in v.words for term in v.terms
        )
        return cls(verbs, (*conditions, *tables.words), rulebook.signals)

    def get_completions(self, document: Document, complete_event: CompleteEvent) -> Iterator[Completion]:
        """Give completions of the word before the cursor."""
        del complete_event
        text = document.text_before_cursor.lstrip()
        if text[:1] in {":", "/"}:
            yield from self._command(text)
            return
        word = document.get_word_before_cursor()
        if len(word) < 2:
            return
        known = self.verbs if text == word else [*self.words, *self.verbs]
        for candidate in known:
            if candidate.startswith(word.lower()) and candidate != word:
                yield Completion(candidate, start_position=-len(word))

    def _command(self, text: str) -> Iterator[Completion]:
        name, space, rest = text[1:].partition(" ")
        if not space:
            for key, command in COMMANDS.items():
                if key.startswith(name):
                    yield Completion(key, start_position=-len(name), display_meta=command.help)
        elif name == "ctx" and "=" not in rest:
            for signal in self.signals:
                if signal.startswith(rest):
                    yield Completion(f"{signal}=", start_position=-len(rest))
