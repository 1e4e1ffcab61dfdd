"""An analysis as one HTML file that needs nothing else: tables, figures, methods."""

import html
from collections import Counter
from collections.abc import Mapping, Sequence

import numpy as np

from fuzzytime.satisfaction import Trapezoid
from fuzzytime.study.analysis.analyse import Analysis
from fuzzytime.study.analysis.compare import Comparison
from fuzzytime.study.analysis.density import SQUARE_MINUTE
from fuzzytime.study.analysis.described import Described
from fuzzytime.study.analysis.fitting import POOR, Model
from fuzzytime.study.analysis.scale import FEW, ScaleComparison
from fuzzytime.study.assets import asset
from fuzzytime.study.reporting.plots import instruction_figure
from fuzzytime.study.reporting.report_page import Page
from fuzzytime.study.wording import between, number, probability
from fuzzytime.times import MINUTE, format_duration


def report(analysis: Analysis, pictures: Mapping[str, bytes]) -> str:
    """Write the report.

    Parameters
    ----------
    analysis : Analysis
        What it reports.
    pictures : mapping of str to bytes
        SVG by the names of `fuzzytime.study.reporting.plots.figures`; those that are missing are left out.
    """
    design = analysis.answers.design
    page = Page()
    page.heading(f"{design.title} – analysis", 1)
    page.paragraph(design.source)
    _participants(page, analysis)
    _models(page, analysis, pictures)
    _groups(page, analysis, pictures)
    _start_times(page, analysis, pictures)
    _each(page, analysis, pictures)
    page.heading("Methods")
    for text in asset("methods.txt").split("\n\n"):
        page.paragraph(" ".join(text.split()))
    title = html.escape(f"{design.title} – analysis")
    return (
        f'<!doctype html><html lang="en"><head><meta charset="utf-8"><title>{title}</title>'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<style>{asset('report.css')}</style></head><body><main>{page.html}</main></body></html>\n"
    )


def _participants(page: Page, analysis: Analysis) -> None:
    answers = analysis.answers
    page.heading("Participants")
    page.paragraph(f"{answers.head_count} count, {len(answers.set_aside)} set aside.")
    if answers.set_aside:
        page.table(
            "Participants set aside.",
            ("participant", "reason"),
            ((entry.name, entry.reason) for entry in answers.set_aside),
        )
    rows = []
    for question in answers.design.demographics:
        given = [person.demographics.get(question.key, "") for person in answers.counted]
        rows.append((question.key, _summary([answer for answer in given if answer]), str(given.count(""))))
    if rows:
        page.table("Answers about the participants who count.", ("question", "answers", "open"), rows)


def _summary(answers: Sequence[str]) -> str:
    """Give median and range of numbers, shares of texts."""
    if not answers:
        return "–"
    if all(answer.isdigit() for answer in answers):
        numbers = np.array(answers, float)
        return f"median {np.median(numbers):g}, {numbers.min():g} to {numbers.max():g}"
    counts = Counter(answers).most_common()
    return ", ".join(f"{text} {count} ({100 * count / len(answers):.1f} %)" for text, count in counts)


def _models(page: Page, analysis: Analysis, pictures: Mapping[str, bytes]) -> None:
    page.heading("F1: which continuous functions model the instructions")
    _prediction_errors(page, analysis)
    page.figure(
        "fits",
        "Medians with their distribution, and trapezoid and bell fitted to them; prediction errors in grey, "
        "the time said dotted.",
        pictures,
    )
    _trapezoids(page, analysis)
    page.table(
        "Bells 1 / (1 + |(t − centre) / width|^(2·slope)) fitted to the same medians, times in minutes.",
        ("instruction", "centre", "width", "slope", "SSE", "RMSE", "R²"),
        (_bell_row(entry) for entry in analysis.overall.values() if entry.fits),
    )


def _prediction_errors(page: Page, analysis: Analysis) -> None:
    """Say how well each function fits the instructions of each preposition, and what its trapezoids are."""
    page.table(
        "Prediction errors (sum of squared residuals over the samples) of fits to the medians, smallest to "
        "largest over a preposition's instructions.",
        ("function", *analysis.models),
        (
            (model.value, *(between(*found.errors[model], 3) for found in analysis.models.values()))
            for model in Model
        ),
    )
    page.table(
        "The fitted trapezoids: in how many instructions their error is below the bell's and their plateau "
        "encloses the time said, mean absolute gradients of their flanks per minute, and where the plateau "
        "starts.",
        ("preposition", "below bell", "encloses", "left", "right", "start of plateau − time said"),
        (
            (
                found.preposition,
                f"{found.best[0]} of {found.best[1]}",
                f"{found.encloses} of {found.best[1]}",
                number(found.left * MINUTE, 3),
                number(found.right * MINUTE, 3),
                _range_of_times(found.left_edges),
            )
            for found in analysis.models.values()
        ),
    )


def _trapezoids(page: Page, analysis: Analysis) -> None:
    """Give the corners for each instruction, how far they are to be trusted, and where they fit badly."""
    page.table(
        "Trapezoids fitted to the medians: corners in minutes after the instruction, and how well they fit.",
        ("instruction", "rise start", "full start", "full end", "fall end", "SSE", "RMSE", "R²"),
        (_trapezoid_row(entry) for entry in analysis.overall.values() if entry.fits),
    )
    if analysis.poor:
        texts = "; ".join(analysis.overall[key].instruction.text for key in analysis.poor)
        page.paragraph(f"A trapezoid fits the median badly (R² below {POOR:g}) for: {texts}", "caution")
    if analysis.intervals:
        page.table(
            "95 % intervals of those corners, by the bootstrap over participants, in minutes.",
            ("instruction", "rise start", "full start", "full end", "fall end"),
            (
                (
                    analysis.overall[key].instruction.text,
                    *(between(low / MINUTE, high / MINUTE, 2) for low, high in intervals),
                )
                for key, intervals in analysis.intervals.items()
            ),
        )


def _trapezoid_row(entry: Described) -> tuple[str, ...]:
    fit = entry.fits[Model.TRAPEZOID]
    corners = fit.function.corners if isinstance(fit.function, Trapezoid) else ()
    shown = (number(corner / MINUTE, 2) for corner in corners)
    return entry.instruction.text, *shown, f"{fit.sse:.3f}", f"{fit.rmse:.4f}", f"{fit.r_squared:.4f}"


def _bell_row(entry: Described) -> tuple[str, ...]:
    fit = entry.fits[Model.BELL]
    centre, width, slope = (fit.parameters[name] for name in ("centre", "width", "slope"))
    shown = number(centre / MINUTE, 2), number(width / MINUTE, 2), number(slope, 2)
    return entry.instruction.text, *shown, f"{fit.sse:.3f}", f"{fit.rmse:.4f}", f"{fit.r_squared:.4f}"


def _groups(page: Page, analysis: Analysis, pictures: Mapping[str, bytes]) -> None:
    if analysis.compared is None:
        return
    first, second = analysis.compared
    page.heading(f"F2: {first} against {second}")
    if analysis.comparison is not None:
        texts = [entry.instruction.text for entry in analysis.overall.values()]
        _variances(page, first, second, texts, analysis.comparison)
    page.figure(
        "groups",
        "Medians and quartiles of the groups; variances of the medians in grey, the time said dotted.",
        pictures,
    )
    if analysis.scale is not None:
        _control(page, first, second, analysis.scale)


def _variances(page: Page, first: str, second: str, texts: Sequence[str], found: Comparison) -> None:
    smaller = int((found.differences < 0).sum())
    mean = number(found.mean_difference / SQUARE_MINUTE, 3)
    page.paragraph(
        f"The variance of the median is smaller for {first} in {smaller} of {found.differences.size} "
        f"instructions; the mean difference {first} − {second} is {mean} min² (permutation test over all "
        f"instructions: p {probability(found.p_value)})."
    )
    variances = (found.first, found.second, found.differences)
    page.table(
        f"Variances of the groups' medians as densities, in min²; p-values of {found.p_values.size} "
        "permutation tests, adjusted after Holm.",
        ("instruction", first, second, "difference", "p"),
        (
            (
                text,
                *(number(value / SQUARE_MINUTE, 3) for value in row),
                probability(p_value).removeprefix("= "),
            )
            for text, p_value, *row in zip(texts, found.p_values, *variances, strict=True)
        ),
    )


def _control(page: Page, first: str, second: str, scale: ScaleComparison) -> None:
    modes = (", ".join(map(str, mode)) for mode in (scale.first_mode, scale.second_mode))
    page.paragraph(
        f"Control question: modes {first} {next(modes)}, {second} {next(modes)}; "
        f"Mann-Whitney U = {scale.u:g}, p {probability(scale.p_value)}; Cliff's delta "
        f"{number(scale.delta, 2)} (95 % interval {between(*scale.interval, 2)}), above 0 where {first} "
        "answers higher."
    )
    if scale.few:
        page.paragraph(
            f"Caution: with fewer than {FEW} answers in a group the test misses all but large differences; "
            "look at the interval, not at the p-value alone.",
            "caution",
        )


def _start_times(page: Page, analysis: Analysis, pictures: Mapping[str, bytes]) -> None:
    if not analysis.start_times:
        return
    page.heading("F3: the influence of the start time")
    everybody = analysis.start_times.get(None)
    if everybody is not None:
        page.paragraph(
            f"From {format_duration(float(everybody.t_spec[0]))} to "
            f"{format_duration(float(everybody.t_spec[-1]))} ahead the variance "
            f"{'grows throughout,' if everybody.increasing else 'changes'} from "
            f"{everybody.variances[0] / SQUARE_MINUTE:.3f} to "
            f"{everybody.variances[-1] / SQUARE_MINUTE:.3f} min² (by a factor of {everybody.ratio:.3f})."
        )
    times = next(iter(analysis.start_times.values())).t_spec
    page.table(
        "Variance of the median in min², by the specified start time.",
        ("participants", *(format_duration(float(time)) for time in times)),
        (
            (group or "all", *(f"{value / SQUARE_MINUTE:.3f}" for value in found.variances))
            for group, found in analysis.start_times.items()
            if found.t_spec.size == times.size
        ),
    )
    page.figure("start-times", "Variance of the median over the specified start time.", pictures)


def _each(page: Page, analysis: Analysis, pictures: Mapping[str, bytes]) -> None:
    page.heading("Each instruction")
    if analysis.divergent:
        texts = "; ".join(analysis.overall[key].instruction.text for key in analysis.divergent)
        page.paragraph(
            f"Participants fall into two subgroups, clearly better than one, for: {texts}", "caution"
        )
    else:
        page.paragraph("In no instruction do two subgroups describe participants clearly better than one.")
    page.table(
        "Agreement: mean pointwise standard deviation where anybody is satisfied, variance of the median in "
        "min², gradients per minute, silhouette of the best split into two subgroups (clear from 0.7).",
        ("instruction", "deviation", "variance", "left", "right", "silhouette", "sizes"),
        (
            (
                entry.instruction.text,
                f"{entry.characteristics.disagreement:.3f}",
                number(entry.variance / SQUARE_MINUTE, 3),
                number(entry.flanks.left * MINUTE, 2),
                number(entry.flanks.right * MINUTE, 2),
                f"{entry.subgroups.silhouette:.2f}",
                f"{int((~entry.subgroups.second).sum())}/{int(entry.subgroups.second.sum())}",
            )
            for entry in analysis.overall.values()
        ),
    )
    memory = analysis.memory
    page.paragraph(
        f"A discretised function takes {memory.sampled_bytes:,} bytes ({memory.samples} samples), a "
        f"trapezoid {memory.fitted_bytes}: for n skills O(n·k) against O(n)."
    )
    for key, entry in analysis.overall.items():
        page.figure(
            instruction_figure(key),
            f"{entry.instruction.text} Curves of single participants; histogram over time and satisfaction; "
            "median with quartiles (shaded), minimum and maximum (dotted).",
            pictures,
        )


def _range_of_times(times: Sequence[float]) -> str:
    return between(min(times), max(times), 1, "s") if times else "–"
