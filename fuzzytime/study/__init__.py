"""From what people draw to the table that plans (the paper's section III-C).

Collect curves with `fuzzytime.study.serving.server`, keep them in an `AnswerStore`, describe them by
`characterise`, `fit` and `compare`, and write the rule table that they amount to by `calibrate`.
Everything but the server, the store and the plots is a pure function over arrays.

``asking`` and ``serving`` bring ``answers``, kept by ``storing``; ``analysis``, and its ``reporting``;
``calibration``. Pages are made of ``assets``, numbers read by ``wording``.
"""

from fuzzytime.study.analysis.analyse import Analysis, analyse, corner_intervals
from fuzzytime.study.analysis.characteristics import Characteristics, characterise, histogram
from fuzzytime.study.analysis.compare import Comparison, compare
from fuzzytime.study.analysis.density import Flanks, flanks, variance
from fuzzytime.study.analysis.described import Described
from fuzzytime.study.analysis.fitting import Fit, Model, fit, fit_models
from fuzzytime.study.analysis.scale import ScaleComparison, compare_answers
from fuzzytime.study.analysis.start_times import StartTimeInfluence, influence_of_start_times
from fuzzytime.study.analysis.subgroups import Subgroups, subgroups
from fuzzytime.study.answers.participants import Answers, Origin, Participant, SetAside
from fuzzytime.study.answers.rating import Cue, CueKind, Direction, Rating
from fuzzytime.study.answers.simulate import Hand, Population, simulate
from fuzzytime.study.answers.subjective import SubjectiveSatisfaction
from fuzzytime.study.asking.design import Design
from fuzzytime.study.asking.questions import StudyInstruction, Timeline
from fuzzytime.study.calibration.calibrate import Calibration, calibrate
from fuzzytime.study.calibration.personal import PersonalTable, personal_table
from fuzzytime.study.calibration.prior import Prior
from fuzzytime.study.calibration.table import rule_table
from fuzzytime.study.storing.store import AnswerStore

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
