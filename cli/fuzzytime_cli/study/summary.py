"""A study in a terminal: its participants, and what its analysis says, in 80 columns."""

from collections.abc import Iterable, Iterator, Sequence
from textwrap import wrap

from fuzzytime.study import Answers, Model, Participant
from fuzzytime.study.analysis.analyse import Analysis
from fuzzytime.study.analysis.density import SQUARE_MINUTE
from fuzzytime.study.analysis.fitting import POOR
from fuzzytime.study.analysis.scale import FEW
from fuzzytime.study.wording import between, probability
from fuzzytime.times import MINUTE, format_duration
from fuzzytime_cli.render import fitted, plain, width_of


def participants(answers: Answers) -> Iterator[str]:
    """List everybody: group, origin, answered instructions, and why somebody does not count."""
    reasons = {entry.name: entry.reason for entry in answers.set_aside}
    count = len(answers.design.instructions)

    def row(person: Participant) -> tuple[str, ...]:
        state = "finished" if person.finished else "under way"
        done = f"{len(person.curves)}/{count}"
        return person.name, person.group, person.origin.value, state, done, reasons.get(person.name, "counts")

    head = ("participant", "group", "origin", "state", "curves", "")
    yield from table(head, map(row, answers.participants))
    yield ""
    yield plain(f"{answers.design.name}: {answers.head_count} count, {len(answers.set_aside)} set aside")


def analysis(found: Analysis) -> Iterator[str]:
    """Say what F1, F2 and F3 come to."""
    answers = found.answers
    yield plain(f"{answers.design.name}: {answers.head_count}")
    for entry in answers.set_aside:
        yield plain(f"  set aside: {entry.name} ({entry.reason})")
    yield ""
    yield from _instructions(found)
    yield ""
    yield "F1  Which functions fit: prediction errors (SSE) of the medians"
    yield from table(
        ("function", *found.models),
        ((model.value, *(between(*of.errors[model], 3) for of in found.models.values())) for model in Model),
    )
    yield from _groups(found)
    yield from _start_times(found)
    if found.divergent:
        yield ""
        yield from caution(f"two subgroups, clearly better than one, for: {', '.join(found.divergent)}")


def _instructions(found: Analysis) -> Iterator[str]:
    head = ("instruction", "variance", "deviation", "trapezoid (min)", "SSE", "bell SSE")
    rows = []
    for key, entry in found.overall.items():
        if not entry.fits:
            rows.append((key, "-", f"{entry.characteristics.disagreement:.3f}", "nobody agrees", "-", "-"))
            continue
        trapezoid, bell = entry.fits[Model.TRAPEZOID], entry.fits[Model.BELL]
        corners = getattr(trapezoid.function, "corners", ())
        rows.append(
            (
                key,
                f"{entry.variance / SQUARE_MINUTE:.3f}",
                f"{entry.characteristics.disagreement:.3f}",
                " ".join(f"{corner / MINUTE:.2f}" for corner in corners),
                f"{trapezoid.sse:.3f}",
                f"{bell.sse:.3f}",
            )
        )
    yield from table(head, rows)
    yield "(variance of the median in min²; deviation: how much participants disagree)"
    if found.poor:
        yield from caution(
            f"a trapezoid fits the median badly (R² below {POOR:g}) for: {', '.join(found.poor)}"
        )


def _groups(found: Analysis) -> Iterator[str]:
    if found.compared is None:
        return
    first, second = map(plain, found.compared)
    yield ""
    yield f"F2  {first} against {second}"
    comparison, scale = found.comparison, found.scale
    if comparison is None and scale is None:
        yield "    too few participants in a group to compare"
    if comparison is not None:
        smaller = int((comparison.differences < 0).sum())
        verdict = "groups differ" if comparison.p_value <= 0.05 else "no difference found"
        yield (
            f"    variance: {first} smaller in {smaller} of {comparison.differences.size}, mean difference "
            f"{comparison.mean_difference / SQUARE_MINUTE:+.3f} min²"
        )
        yield f"    permutation test over all instructions: p {probability(comparison.p_value)}, {verdict}"
    if scale is not None:
        modes = " and ".join(
            f"{name} {'/'.join(map(str, mode))}"
            for name, mode in ((first, scale.first_mode), (second, scale.second_mode))
        )
        low, high = scale.interval
        yield f"    control question: modes {modes}; Mann-Whitney U = {scale.u:g},"
        interval = f"{low:+.2f} to {high:+.2f}"
        yield f"    p {probability(scale.p_value)}, Cliff's delta {scale.delta:+.2f} (95 %: {interval})"
        if scale.few:
            yield f"    caution: with fewer than {FEW} answers in a group only large differences show"


def _start_times(found: Analysis) -> Iterator[str]:
    if not found.start_times:
        return
    yield ""
    yield "F3  Variance of the median (min²) by specified start time"
    times = next(iter(found.start_times.values())).t_spec
    yield from table(
        ("participants", *(format_duration(float(time)) for time in times), "ratio"),
        (
            (
                group or "all",
                *(f"{value / SQUARE_MINUTE:.3f}" for value in influence.variances),
                f"{influence.ratio:.2f}",
            )
            for group, influence in found.start_times.items()
            if influence.t_spec.size == times.size
        ),
    )


def caution(text: str) -> Iterator[str]:
    """Say what to know before numbers are used, in lines of 80 columns."""
    yield from wrap(plain(f"caution: {text}"), 80, subsequent_indent="  ")


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> Iterator[str]:
    """Lay out rows in columns as wide as what stands in them."""
    cells = [tuple(map(plain, row)) for row in (head, *rows)]
    widths = [max(width_of(row[column]) for row in cells) for column in range(len(head))]
    for row in cells:
        yield "  ".join(fitted(cell, width) for cell, width in zip(row, widths, strict=True)).rstrip()
