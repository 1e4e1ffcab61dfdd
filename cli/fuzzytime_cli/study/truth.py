"""What synthetic participants mean: ψ by a rule table, or written down for each instruction."""

from pathlib import Path

from fuzzytime.documents.nodes import Mapping as MappingNode
from fuzzytime.documents.nodes import Reader
from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime.rulebook import Actor, Profile, Rulebook
from fuzzytime.satisfaction import SatisfactionFunction
from fuzzytime.study import Design, StudyInstruction
from fuzzytime.study.answers.simulate import Truth
from fuzzytime_cli.inputs.functions import read_function


def read_truth(design: Design, path: Path | None, profile: Profile, *, by_actor: bool) -> Truth:
    """Give the truth: of the shipped tables, of a rule table over them, or of a plain mapping.

    A plain mapping gives a satisfaction function for each instruction's key:
    ``in-10: {trapezoid: [8 min, 9 min, 11 min, 12 min]}``.

    Raises
    ------
    OSError
        If the file cannot be read.
    DocumentError
        If it breaks rules, or lacks an instruction.
    """
    if path is not None:
        reader = Reader.of_file(path)
        root = reader.root()
        if isinstance(root, MappingNode) and "fuzzytime" not in reader.keys(root):
            return _plain(reader, root, design)
    return _tabled(design, path, profile, by_actor=by_actor)


def _plain(reader: Reader, root: MappingNode, design: Design) -> Truth:
    keys = [entry.key for entry in design.instructions]
    found = {
        key: read_function(reader, node, key) for key, node in reader.mapping(root, "", keys, keys).items()
    }
    reader.finish()
    return lambda instruction, _group: found[instruction.key]


def _tabled(design: Design, path: Path | None, profile: Profile, *, by_actor: bool) -> Truth:
    files = [path] if path is not None else []
    books = {
        group: Rulebook.shipped(profile, Actor(group) if by_actor and group in set(Actor) else None, files)
        for group in design.groups
    }

    def truth(instruction: StudyInstruction, group: str) -> SatisfactionFunction:
        book = books[group]
        return book.resolve(requirement_of(instruction, book)).satisfaction

    return truth


def requirement_of(instruction: StudyInstruction, book: Rulebook) -> TimeRequirement:
    """Say what an instruction of a study says about time, as the language would.

    Its preposition's row in the tables tells how the words bind the time.
    """
    row = book.tables.prepositions.get(instruction.preposition)
    model = book.tables.models.get(row.model) if row is not None else None
    constraint = model.constraint if model is not None and model.constraint is not None else Constraint.AT
    spoken = instruction.word is not None
    return TimeRequirement(
        text=instruction.text,
        span=(0, len(instruction.text)),
        constraint=constraint,
        preposition=None if spoken else instruction.preposition,
        word=instruction.word,
        fuzziness=(instruction.fuzziness,) if instruction.fuzziness is not None and not spoken else (),
        t_spec=instruction.t_spec,
        earliest=instruction.t_spec if constraint is not Constraint.BEFORE else None,
        latest=instruction.t_spec if constraint is not Constraint.AFTER else None,
    )
