"""Texts that pages are made of: the study's page, and the report's style and methods."""

from importlib.resources import files


def asset(name: str) -> str:
    """Give the text of a file in this folder."""
    return files("fuzzytime.study.assets").joinpath(name).read_text(encoding="utf-8")
