"""`fuzzytime study`: collect what people draw, analyse it, and make a rule table of it."""

from fuzzytime_cli.study.commands import app

__all__ = ["app"]
