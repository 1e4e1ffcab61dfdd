"""How long what is asked for takes: as given, as said, as a table knows it."""

from dataclasses import dataclass, replace
from itertools import pairwise

from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.interpreter.request import Wish
from fuzzytime.language import Instruction, Lexicon, Operation
from fuzzytime.rulebook import OperationDuration, Rulebook

ATTEND = "attend"
"""The row of durations for what happens, by its name."""

LEAVE = "leave"
"""The row of durations for what is left to itself."""

TO = "to"

TURN = "turn"
"""With "on" or "off", the row of what must be so: "heating on at five"."""


@dataclass(frozen=True, slots=True)
class HowLong:
    """Tells for how long hands are needed, and when it is done."""

    rulebook: Rulebook
    lexicon: Lexicon

    def of(self, wish: Wish, instruction: Instruction) -> OperationDuration:
        """Take what is given, else what is said ("for eight minutes"), else the table's.

        What is said is how long it goes on; the table knows whether that needs hands: eggs that boil for
        eight minutes leave the cook free.
        """
        if wish.hands_on is not None or wish.elapsed is not None:
            return self.given(wish, instruction.operation)
        return self._said(instruction, instruction.duration)

    def _said(self, instruction: Instruction, length: float | None) -> OperationDuration:
        """Give the durations of an instruction that goes on for a length, the table's where none is said."""
        operation = instruction.operation
        table = self._of_table(operation)
        if operation is not None and operation.stated:
            # What happens by itself needs nobody's hands: "the guests arrive at six".
            if length is not None:
                return OperationDuration(hands_on=0.0, elapsed=length, source="said", assumed=False)
            moment = operation.verb in self.lexicon.closed.named_moments
            if moment or operation.lemma in self.lexicon.doing.ending:
                # "Call time 6:00", "the shift ends at two": that is a moment.
                return OperationDuration(hands_on=0.0, elapsed=0.0, source="said", assumed=False)
            known = self._happening(operation) or (table if table.known else None)
            if known is None:
                return OperationDuration(hands_on=0.0, elapsed=0.0, source="said", assumed=False)
            return replace(known, hands_on=0.0)
        if length is None:
            return table
        if instruction.alone:
            # "Paint the door and give it an hour"
            whole = table.hands_on + length
            return OperationDuration(hands_on=table.hands_on, elapsed=whole, source="said", assumed=False)
        # "Paint the door for three hours": what dries when that is over leaves nobody free before.
        unattended = table.known and table.elapsed > table.hands_on and not table.worked
        hands_on = min(table.hands_on, length) if unattended else length
        if operation is not None and self._rests(operation):
            alone = self.rulebook.left_alone(self.rulebook.duration_of(LEAVE), length)
            hands_on = hands_on if alone is None else min(hands_on, alone)
        elif operation is not None and operation.object is not None:
            # "Leave the dough for an hour"; but who leaves for an hour is away.
            alone = self.rulebook.left_alone(table, length, operation.phrase)
            hands_on = hands_on if alone is None else min(hands_on, alone)
        return OperationDuration(
            hands_on=hands_on, elapsed=length, source="said", assumed=False, needed_for=table.needed_for
        )

    def _rests(self, operation: Operation) -> bool:
        """Whether something is done for what goes on by itself: "hang the film to dry", "allow to cool"."""
        said = pairwise(operation.name.lower().split())
        return any(to == TO and verb in self.lexicon.doing.by_itself for to, verb in said)

    def _happening(self, operation: Operation) -> OperationDuration | None:
        """Give how long something that happens takes by the table; None where it is not in it.

        What who speaks takes part in takes as long as anything that is attended.
        """
        anything = self.rulebook.duration_of(ATTEND)
        found = self.rulebook.duration_of(ATTEND, operation.object)
        return found if operation.attended or found != anything else None

    def lasting(self, made: Interpreted, length: float, *, alone: bool = False) -> Interpreted:
        """Let a skill go on for as long as was told of it afterwards.

        What is only begun by hand ("put the bread in the oven") goes on by itself, and so does what is left
        ``alone`` ("give it an hour").
        """
        if made.wish.hands_on is not None or made.wish.elapsed is not None or made.instruction is None:
            return made
        table = self._of_table(made.instruction.operation)
        duration = self._said(replace(made.instruction, alone=alone), length)
        begun = self.rulebook.left_alone(table, length)
        if begun is not None:
            duration = replace(duration, hands_on=min(duration.hands_on, begun))
        skill = replace(made.skill, duration=duration.hands_on, elapsed=duration.elapsed)
        return replace(made, skill=skill, duration=duration)

    def by_itself(self, made: Interpreted) -> Interpreted:
        """Let a skill go on by itself once it is begun: something else is done meanwhile.

        What the table knows to need hands to its end keeps them: "mix the dough".
        """
        if made.instruction is None or made.wish.hands_on is not None or made.wish.elapsed is not None:
            return made
        table = self._of_table(made.instruction.operation)
        if table.known and table.elapsed <= table.hands_on:
            return made
        duration = replace(made.duration, hands_on=min(made.duration.hands_on, table.hands_on))
        return replace(made, skill=replace(made.skill, duration=duration.hands_on), duration=duration)

    def given(self, wish: Wish, operation: Operation | None) -> OperationDuration:
        """Take what the wish gives; of hands-on and elapsed time, the one not given follows the table."""
        table = self._of_table(operation)
        elapsed = wish.elapsed if wish.elapsed is not None else max(table.elapsed, wish.hands_on or 0.0)
        hands_on = wish.hands_on if wish.hands_on is not None else min(table.hands_on, elapsed)
        if operation is None and wish.elapsed is None:
            elapsed = hands_on
        if operation is not None and operation.stated:
            # A meeting that is to be longer would be in the way of itself.
            hands_on = 0.0
        return OperationDuration(hands_on=hands_on, elapsed=elapsed, source="given", assumed=False)

    def _of_table(self, operation: Operation | None) -> OperationDuration:
        if operation is None:
            return self.rulebook.duration_of(None)
        if operation.lemma == "be" and operation.place in self.lexicon.beside.switched:
            return self.rulebook.duration_of(f"{TURN} {operation.place}", operation.object)
        return self.rulebook.duration_of(operation.phrase, operation.object)
