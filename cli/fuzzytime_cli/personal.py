"""A person's ratings: kept with their sessions, and laid over the tables as a table of their own."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from fuzzytime.rulebook import Rulebook
    from fuzzytime.study.calibration.personal import PersonalTable
    from fuzzytime_cli.session import KeptRating


def kept_ratings(folder: Path | None) -> "tuple[KeptRating, ...]":
    """Give the ratings of all sessions in a data folder; where they cannot be read, say so and give none."""
    path = folder / "sessions.sqlite" if folder is not None else None
    if path is None or not path.is_file():
        return ()
    from fuzzytime_cli.faults import report
    from fuzzytime_cli.session import open_store

    store, trouble = open_store(path)
    try:
        if trouble and not store.names():
            report(f"your ratings are not used: {trouble}")
        return store.ratings()
    finally:
        store.close()


def personal_table(kept: "Sequence[KeptRating]") -> "PersonalTable":
    """Give the table that ratings amount to."""
    from fuzzytime.study import Prior, personal_table
    from fuzzytime.study.answers.rating import rating_of

    return personal_table(Prior.shipped(), [rating_of(json.loads(one.rating)) for one in kept])


def personal_rulebook(rulebook: "Rulebook", kept: "Sequence[KeptRating]") -> "Rulebook":
    """Lay a person's own table over the tables; without ratings they stay as they are."""
    return rulebook.with_rules(personal_table(kept).yaml, "your ratings") if kept else rulebook


def rating_line(kept: "KeptRating") -> str:
    """Say one rating in a line."""
    document = json.loads(kept.rating)
    said = [f"{document['score']} of 5"] if document["score"] is not None else []
    said += [document["direction"]] if document["direction"] is not None else []
    return f"{kept.identifier} {kept.name} at {kept.start:%H:%M:%S}: {', '.join(said)}"
