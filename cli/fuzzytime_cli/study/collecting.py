"""Collecting answers: serve the page, invent participants."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fuzzytime_cli.choices import ProfileChoice
from fuzzytime_cli.faults import NoInputError, as_config, as_usage, report
from fuzzytime_cli.study.shared import DESIGN, DesignFile, NewDatabase, design_of, now

if TYPE_CHECKING:
    from fuzzytime.study.serving.server import StudyServer
    from fuzzytime.study.serving.service import StudyService


def serve(
    design: Annotated[
        Path | None,
        typer.Argument(help=DESIGN),
    ] = None,
    *,
    database: NewDatabase,
    host: Annotated[
        str, typer.Option(help="Where to listen. Anything but loopback lets others reach the page.")
    ] = "127.0.0.1",
    port: Annotated[int, typer.Option(min=0, max=65535, help="0 takes a free one.")] = 8765,
    name: Annotated[
        list[str] | None,
        typer.Option(
            "--name",
            metavar="HOST",
            help="Another host by which people reach the page, or a proxy's address: https://study.example.",
        ),
    ] = None,
    browse: Annotated[bool, typer.Option("--open", help="Open the page in this computer's browser.")] = False,
) -> None:
    """Serve the page on which people draw, until Ctrl-C; every acknowledged answer is on the disk."""
    import secrets
    import signal

    from fuzzytime.study import AnswerStore
    from fuzzytime.study.serving.server import origin_of
    from fuzzytime.study.serving.service import StudyService

    with as_usage("--name"):
        for one in name or ():
            origin_of(one, port)
    with AnswerStore.create(database, design_of(database, design)) as store:
        service = StudyService(store, now, new_name)
        token = store.token(secrets.token_urlsafe(16))
        with _listening((host, port), service, token, tuple(name or ())) as server:
            _warn_of_others(host, named=bool(name))
            signal.signal(signal.SIGTERM, _stop)
            try:
                report(f"{store.design.title}: give participants the address below; Ctrl-C ends")
                sys.stdout.write("".join(f"{url}\n" for url in server.urls))
                sys.stdout.flush()
                if browse:
                    typer.launch(server.url)
                server.serve_forever()
            except KeyboardInterrupt:
                report(f"stopped, with {len(store.answers().participants)} participants in {database}")


def new_name() -> str:
    """Give a participant's name that nobody can guess: one word in a shell, and a text to a spreadsheet."""
    import secrets

    return f"p-{secrets.token_hex(8)}"


def _warn_of_others(host: str, *, named: bool) -> None:
    """Say who else reaches the page, and by what."""
    from fuzzytime.study.serving.server import EVERYWHERE

    if host not in ("127.0.0.1", "localhost", "::1"):
        report("the page can be reached from other computers; its traffic is not encrypted")
    if host in EVERYWHERE and not named:
        report("others reach it by the hosts that --name gives, such as this computer's address")


def _listening(
    address: tuple[str, int], service: "StudyService", token: str, names: tuple[str, ...]
) -> "StudyServer":
    from fuzzytime.study.serving.server import StudyServer

    try:
        return StudyServer(address, service, token, names=names, tell=report)
    except OSError as error:
        raise OSError(error.errno, error.strerror, "{}:{}".format(*address)) from error


def _stop(_number: int, _frame: object) -> None:
    """Stop as Ctrl-C does, where the system asks to."""
    raise KeyboardInterrupt


def simulate(
    database: NewDatabase,
    *,
    participants: Annotated[int, typer.Option(min=1, max=10_000, help="How many people to invent.")] = 32,
    seed: Annotated[int, typer.Option(min=0, help="The same seed gives the same answers.")] = 0,
    truth: Annotated[
        Path | None,
        typer.Option(help="What people mean: a rule table, or a function for each instruction (YAML)."),
    ] = None,
    profile: Annotated[
        ProfileChoice, typer.Option(help="The shipped table that the truth starts from.")
    ] = ProfileChoice.STUDY,
    by_actor: Annotated[
        bool, typer.Option("--by-actor", help="Let groups mean what the table's actors give them.")
    ] = False,
    individual: Annotated[
        float, typer.Option(min=0.0, help="Spread (standard deviation of the logarithm) of people's widths.")
    ] = 0.2,
    group_effect: Annotated[
        float,
        typer.Option(min=0.05, max=20.0, help="How many times as wide the last group draws as the first."),
    ] = 1.0,
    hand_time: Annotated[float, typer.Option(min=0.0, help="The hand's error in time, in seconds.")] = 2.0,
    hand_satisfaction: Annotated[
        float, typer.Option(min=0.0, max=1.0, help="The hand's error in satisfaction.")
    ] = 0.01,
    inattentive: Annotated[int, typer.Option(min=0, help="How many people do not attend.")] = 0,
    design: DesignFile = None,
) -> None:
    """Invent participants with a known truth, and add their answers to a study."""
    from fuzzytime.rulebook import Profile
    from fuzzytime.study import AnswerStore, Hand, Population
    from fuzzytime.study import simulate as invented
    from fuzzytime_cli.study.truth import read_truth

    if truth is not None and not truth.is_file():
        raise NoInputError(f"{truth}: there is no such truth")
    chosen = design_of(database, design)
    groups = list(chosen.groups)
    widths = {groups[0]: group_effect**-0.5, groups[-1]: group_effect**0.5} if len(groups) > 1 else None
    with as_config():
        meant = read_truth(chosen, truth, Profile(profile.value), by_actor=by_actor)
    answers = invented(
        chosen,
        meant,
        participants,
        seed=seed,
        population=Population(
            individual=individual,
            group_widths=widths,
            inattentive=inattentive,
            hand=Hand(time=hand_time, satisfaction=hand_satisfaction),
        ),
    )
    with AnswerStore.create(database, chosen) as store:
        count = store.add(answers.participants, now())
    report(f"{count} simulated participant{'s' * (count != 1)} added to {database}")
