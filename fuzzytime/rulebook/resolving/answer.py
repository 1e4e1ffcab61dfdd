"""From a requirement to what it says about one moment: by the lookup and its rules, or by a clause."""

from dataclasses import replace
from functools import partial
from types import MappingProxyType

from fuzzytime.requirement import Anchor, Condition, Constraint, Reference
from fuzzytime.rulebook.logic.formula import Formula, variables, with_hedges_of
from fuzzytime.rulebook.resolving.adapt import Wanted, adapt
from fuzzytime.rulebook.resolving.beside import at_a_distance, not_happened, on_one_side
from fuzzytime.rulebook.resolving.clauses import wait_for
from fuzzytime.rulebook.resolving.evidence import signals_of
from fuzzytime.rulebook.resolving.inference import Base, Chosen, Heard, choose, matching
from fuzzytime.rulebook.resolving.question import Question, Said, notes_on
from fuzzytime.rulebook.tables.contents import Row
from fuzzytime.rulebook.tables.rules import Rule
from fuzzytime.rulebook.tables.vocabulary import CLAUSE_MODELS
from fuzzytime.rulebook.wording.lookup import Found, find
from fuzzytime.rulebook.wording.phrases import names
from fuzzytime.rulebook.wording.sentences import Understood, can_be_told, condition_of, understand
from fuzzytime.satisfaction import ALWAYS, NEVER


def answer(question: Question) -> Said:
    """Resolve a requirement, leaving aside which moment of the execution it is about."""
    requirement = question.requirement
    open_time = (requirement.t_spec, requirement.earliest, requirement.latest) == (None, None, None)
    if requirement.anchor is not None and open_time:
        return _anchored(question, requirement.anchor)
    if requirement.constraint is Constraint.WHEN:
        return _clause(question)
    return _timed(question)


def _anchored(question: Question, anchor: Anchor) -> Said:
    """Resolve a time measured from an event or a condition; another instruction binds by order, not by ψ."""
    if anchor.target is not None:
        note = f"depends on another instruction: {anchor.text!r}"
        return Said(satisfaction=ALWAYS, model="always", notes=(note,))
    if anchor.exact:
        return at_a_distance(question, anchor)
    before = question.requirement.constraint is Constraint.BEFORE or anchor.lag < 0
    asked = on_one_side(question, anchor)
    if asked is not None:
        said = answer(asked)
        # What nothing can tell of is not said to have happened.
        clause = condition_of(anchor)
        told = not before or said.satisfaction is not NEVER
        if told or can_be_told(clause, question.tables, question.context):
            return said
    if before:
        note = f"{not_happened(anchor)}: any time from now on counts as before it"
        return Said(satisfaction=ALWAYS, model="always", notes=(note,))
    return Said(satisfaction=NEVER, model="after", reason=not_happened(anchor), untold=True)


def _timed(question: Question) -> Said:
    """Resolve a time or a word: the row of the tables, and what rules make of it."""
    tables = question.tables
    found = find(question.requirement, tables, question.verb)
    heard = question.heard(matching(question.requirement, question.verb, tables))
    chosen = choose(_base(question, found.row, found.model.name), heard)
    notes = (*found.notes, *notes_on(found.row.name, heard))
    if chosen.model in CLAUSE_MODELS:
        formula = _strongest(heard, chosen.model, None, 0.0)
        if formula is not None:
            return _awaited(question, formula, chosen, heard, notes)
    return _adapted(question, found, chosen, notes)


def _base(question: Question, row: Row, model: str) -> Base:
    return Base(
        row.name,
        row.source,
        model,
        row.t,
        partial(question.width, row),
        row.core or 0.0,
        row.fade or 0.0,
    )


def _adapted(question: Question, found: Found, chosen: Chosen, notes: tuple[str, ...]) -> Said:
    own = chosen.model == found.model.name
    wanted = Wanted(
        model=found.model if own else question.tables.models[chosen.model],
        t=chosen.t,
        width=chosen.w,
        interval=found.interval,
        hedges=found.hedges,
        scale=chosen.scale,
    )
    adapted = adapt(wanted, question.requirement, question.tables)
    return Said(
        satisfaction=adapted.satisfaction,
        model=chosen.model,
        parameters=adapted.parameters,
        shares=chosen.shares,
        hedges=adapted.hedges,
        notes=(*notes, *adapted.notes),
        reference=None if question.requirement.reference_said else found.row.reference,
        named=chosen.t if question.requirement.constraint is Constraint.AT else None,
    )


def _clause(question: Question) -> Said:
    """Resolve "when the pan is hot": the sentence's own condition, or that of a rule for its words."""
    requirement = question.requirement
    said = requirement.condition or Condition(text=requirement.text)
    understood = understand(said, question.tables, question.context)
    condition, tables = understood.condition, understood.tables
    question = replace(question, tables=tables)
    row = tables.clauses.get(requirement.preposition or "", tables.constraints[Constraint.WHEN])
    rules = [
        rule
        for rule in matching(replace(requirement, condition=condition), question.verb, tables)
        if rule.effect.model not in CLAUSE_MODELS
        or (_binds_as(rule, row) and _is_about(rule, condition, question))
    ]
    heard = question.heard(rules)
    notes = (*understood.notes, *notes_on(row.name, heard))
    if understood.formula is not None and question.known(understood.formula):
        # What the sentence says can be told; a rule that would say more waits for its readings.
        heard = tuple(part for part in heard if not part.missing)
    chosen = choose(_base(question, row, row.model), heard)
    if chosen.model not in CLAUSE_MODELS:
        found = find(replace(requirement, constraint=Constraint.VAGUE, word=chosen.model), tables)
        return _adapted(question, found, chosen, notes)
    rest = max(0.0, 1.0 - sum(part.weight for part in heard if not part.rule.effect.only_scales))
    formula = _strongest(heard, chosen.model, understood.formula, rest)
    if understood.composed:
        # Who says so much means just that; what rules say of core and fade stands.
        formula = understood.formula
    elif formula is not None and understood.formula not in (None, formula):
        formula = with_hedges_of(understood.formula, formula)
    if said.excepted and (formula is None or not question.known(formula)):
        # What is to be left out is not said to be so: "unless it rains".
        return Said(satisfaction=ALWAYS, model="always", notes=(*notes, _not_excepted(condition)))
    if formula is None and row.model == "until" and not rules and not understood.composed:
        # What nothing can tell of is not said to have happened: it may begin.
        return Said(satisfaction=ALWAYS, model="always", notes=(*notes, _not_told(condition)))
    if formula is None:
        reason = understood.reason if understood.composed else None
        reason = reason or _why_not_understood(understood, rules, question)
        untold = not understood.impossible
        return Said(satisfaction=NEVER, model=chosen.model, reason=reason, untold=untold, notes=notes)
    if chosen.model == "until" and not question.known(formula):
        notes = (*notes, _not_told(condition))
    return _awaited(question, formula, chosen, heard, notes)


def _not_excepted(condition: Condition) -> str:
    """Say of what leaves out a time that nobody knows of any."""
    return f"nothing tells {condition.text!r}, so that no time is left out by it"


def _not_told(condition: Condition) -> str:
    """Say of an end that nobody knows when it is."""
    return f"not yet: nothing tells {condition.text!r}, so that any time from now on counts as before it"


def _binds_as(rule: Rule, row: Row) -> bool:
    """Tell whether a rule waits in the way that the clause's own word does, or names that word.

    "When the pan is hot" has a rule of its own; "until the pan is hot" and "while it is hot" mean otherwise.
    """
    return rule.effect.model == row.model or "preposition" in rule.match.keys


def _is_about(rule: Rule, condition: Condition, question: Question) -> bool:
    """Tell whether a rule for a clause is about the thing that the sentence names, and does not deny it.

    It is about it where it says so itself (``subject``), where the sentence names one of its variables, or
    where none of its variables is tied to a thing by words.
    """
    if condition.negated or rule.condition is None:
        return False
    if "subject" in rule.match.keys:
        return True
    spoken = [question.tables.variables[name] for name in variables(rule.condition)]
    if not any(variable.words for variable in spoken):
        return True
    subject = condition.subject or condition.text
    return any(names(variable, subject) for variable in spoken)


def _strongest(heard: tuple[Heard, ...], model: str, own: Formula | None, rest: float) -> Formula | None:
    """Give the condition to wait for: the weightiest rule's of those for a model, or the sentence's own."""
    best, formula = (rest, own) if own is not None else (-1.0, None)
    for part in reversed(heard):
        if part.rule.effect.model == model and part.rule.condition is not None and part.weight >= best:
            best, formula = part.weight, part.rule.condition
    return formula


def _awaited(
    question: Question, formula: Formula, chosen: Chosen, heard: tuple[Heard, ...], notes: tuple[str, ...]
) -> Said:
    core, fade = chosen.core * chosen.scale, chosen.fade * chosen.scale
    awaited = wait_for(formula, chosen.model, core, fade, question.world([formula]), question.horizon)
    parameters = {"core": core, "fade": fade} if chosen.model == "when" else {}
    if awaited.comes_true is not None:
        parameters["t"] = awaited.comes_true
    return Said(
        satisfaction=awaited.satisfaction,
        model=chosen.model,
        parameters=MappingProxyType(parameters),
        shares=question.explained(formula, chosen.shares, heard),
        reason=awaited.reason,
        untold=awaited.untold,
        notes=notes,
        trace=awaited.trace,
        # What goes on until a condition comes true ends when it does, and only has to start before.
        reference=Reference.START if chosen.model == "until" else None,
    )


def _why_not_understood(understood: Understood, rules: list[Rule], question: Question) -> str:
    """Say why a clause has no condition to wait for: unknown words, or a rule without any reading."""
    waiting = [
        rule.condition for rule in rules if rule.effect.model in CLAUSE_MODELS and rule.condition is not None
    ]
    missing = dict.fromkeys(name for formula in waiting for name in signals_of(formula, question.tables))
    if missing:
        return f"not enough readings of {' and '.join(missing)}"
    return understood.reason or "no condition was said"
