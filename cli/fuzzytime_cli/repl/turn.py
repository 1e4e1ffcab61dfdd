"""One turn of the conversation: a line typed, an answer, and the schedule drawn again where it changed."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from datetime import datetime

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import Plan, Problem, ProblemKind
from fuzzytime.language import Lexicon
from fuzzytime.language.about_wishes import (
    About,
    behind_an_answer,
    choice_meant,
    chooses_none,
    said_apart,
    without_closing,
)
from fuzzytime_cli.faults import message_of
from fuzzytime_cli.formats.table import PlanView
from fuzzytime_cli.inputs.lines import is_ticked_off, said_in
from fuzzytime_cli.render import plain, wrapped
from fuzzytime_cli.repl.commands.by_name import command_of
from fuzzytime_cli.repl.commands.looking import move_lines, start_line
from fuzzytime_cli.repl.compared import lengths_of, news_of
from fuzzytime_cli.repl.conversation import Conversation, answered
from fuzzytime_cli.repl.pending import Pending, asked_late, question_lines, question_of, untold_notes
from fuzzytime_cli.repl.plain_words.offered import question_with_aside
from fuzzytime_cli.repl.plain_words.perhaps import second_lines
from fuzzytime_cli.repl.plain_words.speaking import reply_about
from fuzzytime_cli.repl.plain_words.usually_said import as_usually_said
from fuzzytime_cli.repl.scene import (
    UNREAD,
    AskedBackError,
    Offer,
    Reply,
    Scene,
    problem_lines,
    refused,
    running_lines,
    said,
)
from fuzzytime_cli.repl.together import parted, words_of
from fuzzytime_cli.repl.typed import number_of, whole_number
from fuzzytime_cli.session import NotKeptError, Started

Line = Text | str


@dataclass(slots=True)
class Turns:
    """A conversation going on: the plan on the screen, the question put, what was told, and what is news.

    ``asks`` says that somebody is there to answer: then an ambiguous time is asked about, once. ``focus`` is
    the instruction that was spoken of last, ``told_last`` the one that who types spoke of, and no answer.
    ``taken`` is what was understood of the last line that changed something, ``asked`` what was asked back,
    and ``offer`` what there was said to be room for.
    """

    conversation: Conversation
    width: int
    unicode: bool = True
    asks: bool = False
    plan: Plan | None = None
    version: int = -1
    pending: Pending | None = None
    news: list[Started] = field(default_factory=list)
    told: set[Problem] = field(default_factory=set)
    focus: int | None = None
    told_last: int | None = None
    taken: About | None = None
    asked: About | None = None
    offer: Offer | None = None

    @property
    def lexicon(self) -> Lexicon:
        """The words of the language."""
        return self.conversation.interpreter.language.lexicon

    def opened(self, now: datetime) -> list[Line]:
        """Greet: the schedule of a session that goes on, or what to do in a new one."""
        if not self.conversation.state.entries:
            self._refresh(now)
            kept = "everything" if self.conversation.store.path is not None else "nothing"
            greeting = (
                "Say what you want done and when: flip the pancakes in about two minutes.",
                f":help shows the commands, Ctrl-D leaves; {kept} is kept.",
            )
            return [line for sentence in greeting for line in wrapped(sentence, self.width, 0)]
        lines: list[Line] = [f"Session {plain(self.conversation.name)!r} goes on."]
        return [*lines, *self._redrawn(now)]

    def take(self, line: str, now: datetime) -> Reply:
        """Answer a line; every error of what was typed is an answer too."""
        words = words_of(line, self.conversation.interpreter.language)
        if not words:
            return said(f"ticked off, and not planned: {line.strip()}") if is_ticked_off(line) else Reply()
        pending = self._question_put()
        return self._turn(lambda: self._answer_to(words, pending, now), now)

    def take_together(self, lines: Sequence[str], now: datetime) -> Reply:
        """Keep lines that were said at once, each an instruction, and draw the schedule once."""
        self._question_put()
        return self._turn(
            lambda: self._instructions([said_in(line) or line.strip() for line in lines], now), now
        )

    def together(self, lines: Sequence[str], now: datetime) -> list[list[str]]:
        """Part lines said at once: instructions in a row stand together, all else alone."""
        return parted(lines, self.conversation.interpreter.language, now)

    def _turn(self, answer: Callable[[], Reply], now: datetime) -> Reply:
        """Give an answer, with the schedule where that changed; every error is an answer too."""
        try:
            reply = answer()
            self.asked, self.offer = reply.asked, reply.offer
            self.taken = reply.taken if reply.changed else self.taken
            self.focus = reply.focus if reply.focus is not None else self.focus
            if reply.changed:
                self.told_last = reply.focus if reply.focus is not None else self.told_last
                reply = replace(reply, lines=(*reply.lines, *self._redrawn(now)))
            reply = replace(reply, lines=(*self._told_news(), *reply.lines))
            if self.pending is not None:
                asked = question_lines(self.pending.question, self.width)
                reply = replace(reply, lines=(*reply.lines, *asked))
        except FuzzytimeError as error:
            self.asked, self.offer = error.about if isinstance(error, AskedBackError) else None, None
            return refused(str(error))
        except NotKeptError:
            raise  # whether to go on without a memory is not decided here
        except OSError as error:
            return refused(message_of(error))
        return reply

    def _answer_to(self, words: str, pending: Pending | None, now: datetime) -> Reply:
        pending = pending or asked_late(self._scene(now), words)
        choice = whole_number(words)
        if pending is not None and choice is not None:
            return self._answer(pending, choice)
        if pending is not None and (answer := self._answer_in_words(words, pending, now)) is not None:
            return answer
        if words[0] in ":/":
            command, rest = command_of(words)
            return command.run(self._scene(now), rest)
        usual = as_usually_said(self._scene(now), behind_an_answer(words, now, self.lexicon))
        if (answer := question_with_aside(self._scene(now), usual, reply_about)) is not None:
            return answer
        parts = said_apart(usual, now, self.lexicon)
        return self._one_by_one(parts, now) if len(parts) > 1 else self._said(parts[0], now)

    def _one_by_one(self, parts: Sequence[str], now: datetime) -> Reply:
        """Take what one line says of several things, and draw the schedule once."""
        before, lines, last = self.plan, list[Line](), Reply()
        changed = False
        for part in parts:
            try:
                reply = self._said(part, now)
            except FuzzytimeError as error:
                lines += refused(str(error)).lines
                continue
            lines += reply.lines
            changed |= reply.changed
            self.focus = reply.focus if reply.focus is not None else self.focus
            if reply.changed:
                last = reply
                self.told_last, self.taken = self.focus, reply.taken
                self._refresh(now)
        # What moved is told from the plan on the screen on.
        self.plan = before
        return replace(last, lines=tuple(lines), changed=changed)

    def _said(self, words: str, now: datetime) -> Reply:
        reply = reply_about(self._scene(now), words)
        if reply is None or not reply.anew:
            return reply or self._instructions([without_closing(words, now, self.lexicon)], now)
        made = self._instructions([reply.anew], now)
        return replace(made, lines=(*reply.lines, *made.lines)) if made.changed else made

    def tick(self, now: datetime) -> list[Line]:
        """Say what has started by now; plan anew where another terminal took a step."""
        lines: list[Line] = []
        if self.plan is None or self.conversation.store.version(self.conversation.name) != self.version:
            if self.plan is not None:
                lines = [Text("Changed in another terminal:", style="bold"), *self._redrawn(now)]
            return lines
        for started in self.conversation.note_started(self.plan, now):
            lines.append(start_line(started))
            self.focus = number_of(started.identifier)
        return lines

    # -- inside ---------------------------------------------------------------------------------------------

    def _question_put(self) -> Pending | None:
        """Give the question that the last turn ended with; it is put once."""
        pending, self.pending = self.pending, None
        return pending

    def _scene(self, now: datetime) -> Scene:
        plan = self.plan if self.plan is not None else self._refresh(now)
        # What starts now has started before anything is said of it.
        self.news += self.conversation.note_started(plan, now)
        return Scene(
            self.conversation,
            plan,
            now,
            self.width,
            self.unicode,
            focus=self.focus,
            told_last=self.told_last,
            taken=self.taken,
            asked=self.asked,
            offer=self.offer,
        )

    def _refresh(self, now: datetime) -> Plan:
        """Plan from a moment on: what has started by then stays."""
        self.version = self.conversation.store.version(self.conversation.name)
        if self.plan is not None:
            self.news += self.conversation.note_started(self.plan, now)
        self.plan = self.conversation.plan(now, previous=self.plan)
        return self.plan

    def _redrawn(self, now: datetime) -> list[Line]:
        before = self.plan
        made = self._refresh(now)
        started = {one.identifier for one in self.conversation.store.started(self.conversation.name)}
        lines = self._told_news()
        lines += [Text(line, style="yellow") for line in move_lines(before, made, started)]
        lines += running_lines(self.conversation, now)
        told = self.told | untold_notes(made, self.lexicon.policy, self.pending)
        untold = tuple(problem for problem in made.problems if problem not in told)
        noted = {problem for problem in self.told if problem.kind is ProblemKind.NOTE}
        self.told = noted | set(made.problems)
        view = PlanView(replace(made, problems=untold), self.width, unicode=self.unicode)
        lines += view.brief(news_of(before, made), lengths_of(before, made))
        lines += [line for problem in untold for line in problem_lines(problem, self.width)]
        return lines

    def _told_news(self) -> list[Line]:
        """Announce what has started since the last announcement, and is still asked for."""
        asked = {entry.number for entry in self.conversation.state.entries}
        lines: list[Line] = [start_line(one) for one in self.news if number_of(one.identifier) in asked]
        self.news.clear()
        return lines

    def _instructions(self, said: Sequence[str], now: datetime) -> Reply:
        """Keep instructions that are understood; those that are not are pointed at, and not kept."""
        trial = self.conversation.state.with_entries(said, now)
        made = self.conversation.understood(now, trial)
        lines: list[Line] = []
        kept, last = [], None
        for words, entry in zip(said, trial.entries[-len(said) :], strict=True):
            faults = [one for one in made.problems if one.text == words and one.kind in UNREAD]
            own = [one for one in made.everything if one.wish.identifier == entry.identifier]
            if faults and not own:
                lines += [line for problem in faults for line in problem_lines(problem, self.width)]
            else:
                kept.append(words)
                last = own[0] if own else None
        if not kept:
            return Reply(tuple(lines))
        what = kept[0] if len(kept) == 1 else f"{len(kept)} instructions from {kept[0]} on"
        state = self.conversation.change(what, lambda state: state.with_entries(kept, now))
        number = state.entries[-1].number
        reading = last.reading if last is not None and not last.told_by else None
        # What is told anew is taken for the time nearest to the old one.
        question = None if reading is None else question_of(reading, self.lexicon.policy)
        if len(kept) == 1:
            running = self.conversation.running(now)
            lines += second_lines(made, running, number, kept[0], now, self.lexicon)
        if self.asks and len(said) == 1 and question is not None:
            self.pending = Pending(number, question)
        return Reply(tuple(lines), changed=True, focus=number)

    def _answer_in_words(self, words: str, pending: Pending, now: datetime) -> Reply | None:
        """Take words that mean one of the choices; put the question again where they choose none."""
        if chooses_none(words, now, self.lexicon):
            self.pending = pending
            return Reply(("One of the times has to be taken, or another said, such as: at half past seven.",))
        choice = choice_meant(words, pending.question, now, self.lexicon)
        if choice is None:
            return None
        head = f"taken as {choice + 1} ({pending.question.choices[choice]:%A %H:%M}); :undo takes it back"
        answer = self._answer(pending, choice + 1)
        return replace(answer, lines=(Text(head), *answer.lines))

    def _answer(self, pending: Pending, choice: int) -> Reply:
        """Say the chosen time explicitly in the instruction; what no choice has that number leaves it."""
        question = pending.question
        if not 1 <= choice <= len(question.choices):
            self.pending = pending
            return Reply((f"There is no choice {choice}.",))
        instant = question.choices[choice - 1]
        self.conversation.change(
            f"{instant:%a %H:%M}",
            lambda state: state.with_changed(
                pending.entry, text=answered(state.entry(pending.entry), question.span, instant).text
            ),
        )
        return Reply(changed=True)
