"""From what people draw to the table that plans (the paper's section III-C).

Collect curves with `fuzzytime.study.server`, keep them in an `AnswerStore`, describe them by `characterise`,
`fit` and `compare`, and write the rule table that they amount to by `calibrate`. Everything but the server,
the store and the plots is a pure function over arrays.
"""

from fuzzytime.study.analysis import Analysis, analyse, corner_intervals
from fuzzytime.study.answers import Answers, Origin, Participant, SetAside
from fuzzytime.study.calibrate import Calibration, calibrate
from fuzzytime.study.characteristics import Characteristics, characterise, histogram
from fuzzytime.study.compare import Comparison, compare
from fuzzytime.study.density import Flanks, flanks, variance
from fuzzytime.study.described import Described
from fuzzytime.study.design import Design
from fuzzytime.study.fitting import Fit, Model, fit, fit_models
from fuzzytime.study.personal import PersonalTable, personal_table
from fuzzytime.study.prior import Prior
from fuzzytime.study.questions import StudyInstruction, Timeline
from fuzzytime.study.rating import Cue, CueKind, Direction, Rating
from fuzzytime.study.scale import ScaleComparison, compare_answers
from fuzzytime.study.simulate import Hand, Population, simulate
from fuzzytime.study.start_times import StartTimeInfluence, influence_of_start_times
from fuzzytime.study.store import AnswerStore
from fuzzytime.study.subgroups import Subgroups, subgroups
from fuzzytime.study.subjective import SubjectiveSatisfaction
from fuzzytime.study.table import rule_table

__all__ = [
    "Analysis",
    "AnswerStore",
    "Answers",
    "Calibration",
    "Characteristics",
    "Comparison",
    "Cue",
    "CueKind",
    "Described",
    "Design",
    "Direction",
    "Fit",
    "Flanks",
    "Hand",
    "Model",
    "Origin",
    "Participant",
    "PersonalTable",
    "Population",
    "Prior",
    "Rating",
    "ScaleComparison",
    "SetAside",
    "StartTimeInfluence",
    "StudyInstruction",
    "Subgroups",
    "SubjectiveSatisfaction",
    "Timeline",
    "analyse",
    "calibrate",
    "characterise",
    "compare",
    "compare_answers",
    "corner_intervals",
    "fit",
    "fit_models",
    "flanks",
    "histogram",
    "influence_of_start_times",
    "personal_table",
    "rule_table",
    "simulate",
    "subgroups",
    "variance",
]
